/* SPDX-License-Identifier: MIT */
/** @file test_snapshot.c
 *  Snapshots: that they bring back every bit, that they are the same bytes every time, and that no file, however
 * broken, and no disk, however full, does harm. */
#include <hdf5.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "common.h"
#include "sph2d/io.h"

static const char scene_text[] = "name: small\n"
                                 "domain: {min: [0, 0], max: [1, 1]}\n"
                                 "spacing: 0.04\n"
                                 "fluid: {dynamic_viscosity: 100}\n"
                                 "blocks:\n  - box: {min: [0, 0], max: [0.4, 0.8]}\n"
                                 "sources:\n  - {at: [0.7, 0.9], speed: 1, width: 0.1, spread: 0.1}\n"
                                 "obstacles:\n  - line: [[0.6, 0.1], [0.9, 0.1]]\n"
                                 "probes: [{name: e, kind: energy, every: 0.1}]\n"
                                 "run: {until: 2, frames: {per_second: 30, style: points, color: speed}}\n";

static char folder[] = "/tmp/sph2d-snapshot-XXXXXX";
static sph2d_scene_file *file;
static sph2d_sim *sim;
static sph2d_report report;

/** A folder to work in, and a simulation that has taken some steps. */
static void set_up(void)
{
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
    static const sph2d_override override = {"run.until", "1"};
    sph2d_status status =
        sph2d_scene_file_parse(scene_text, strlen(scene_text), "s.yaml", &override, 1, &file, &report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    sim = test_create(sph2d_scene_file_scene(file), NULL);
    test_steps(sim, 60);
    sph2d_report_clear(&report);
}

static void tear_down(void)
{
    sph2d_sim_destroy(sim);
    sph2d_scene_file_destroy(file);
    ck_assert_int_eq(chdir("/"), 0);
    char command[64];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    ck_assert_int_eq(system(command), 0);
    ck_assert_int_eq(H5Fget_obj_count((hid_t)H5F_OBJ_ALL, H5F_OBJ_ALL), 0);
}

static void write_snapshot(const char *path, unsigned compress)
{
    sph2d_status status = sph2d_snapshot_write(sim, file, compress, path, &report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
}

static sph2d_snapshot *read_snapshot(const char *path)
{
    sph2d_snapshot *snapshot = NULL;
    sph2d_status status = sph2d_snapshot_read(path, &snapshot, &report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    ck_assert_ptr_nonnull(snapshot);
    return snapshot;
}

static void *load(const char *path, size_t *size)
{
    FILE *stream = fopen(path, "rb");
    ck_assert_ptr_nonnull(stream);
    fseek(stream, 0, SEEK_END);
    *size = (size_t)ftell(stream);
    rewind(stream);
    void *bytes = malloc(*size);
    ck_assert_ptr_nonnull(bytes);
    ck_assert_uint_eq(fread(bytes, 1, *size, stream), *size);
    fclose(stream);
    return bytes;
}

static void store(const char *path, const void *bytes, size_t size)
{
    FILE *stream = fopen(path, "wb");
    ck_assert_ptr_nonnull(stream);
    ck_assert_uint_eq(fwrite(bytes, 1, size, stream), size);
    ck_assert_int_eq(fclose(stream), 0);
}

static bool same_files(const char *a, const char *b)
{
    size_t m, n;
    void *x = load(a, &m), *y = load(b, &n);
    bool same = m == n && memcmp(x, y, m) == 0;
    free(x);
    free(y);
    return same;
}

static void assert_same_values(const sph2d_array *a, const sph2d_array *b)
{
    ck_assert_str_eq(a->name, b->name);
    ck_assert_str_eq(a->description, b->description);
    ck_assert_int_eq(memcmp(a->unit, b->unit, sizeof a->unit), 0);
    ck_assert(a->group == b->group && a->type == b->type && a->components == b->components && a->count == b->count);
    for (unsigned c = 0; c < a->components; ++c)
        for (size_t i = 0; i < a->count; ++i)
            ck_assert_msg(memcmp((const char *)a->data[c] + 8 * i * a->stride,
                                 (const char *)b->data[c] + 8 * i * b->stride, 8) == 0,
                          "%s[%zu] differs", a->name, i);
}

/* ---- there and back ---------------------------------------------------------------------------------------------- */

START_TEST(every_bit_comes_back)
{
    write_snapshot("a.h5", _i ? 6 : 0);
    sph2d_snapshot *snapshot = read_snapshot("a.h5");
    sph2d_state before = sph2d_sim_state(sim), after = sph2d_snapshot_state(snapshot);
    ck_assert_uint_eq(after.version, before.version);
    ck_assert_uint_gt(after.array_count, before.array_count);
    for (size_t i = 0; i < before.array_count; ++i)
        assert_same_values(&before.arrays[i], &after.arrays[i]);
    for (int g = SPH2D_GROUP_FLUID; g <= SPH2D_GROUP_WALL; ++g)
        for (size_t i = 0; i < sph2d_field_count((sph2d_group)g); ++i) {
            sph2d_array field = sph2d_field(sim, (sph2d_group)g, i);
            const sph2d_array *array = sph2d_snapshot_array(snapshot, (sph2d_group)g, field.name);
            ck_assert_ptr_nonnull(array);
            assert_same_values(&field, array);
        }
    ck_assert_ptr_null(sph2d_snapshot_array(snapshot, SPH2D_GROUP_FLUID, "Colours"));
    sph2d_snapshot_destroy(snapshot);
    sph2d_snapshot_destroy(NULL);
}
END_TEST

START_TEST(it_says_what_it_is)
{
    write_snapshot("a.h5", 0);
    sph2d_snapshot *snapshot = read_snapshot("a.h5");
    sph2d_snapshot_info info = sph2d_snapshot_get_info(snapshot);
    ck_assert_str_eq(info.scene_name, "small");
    ck_assert_str_eq(info.code_version, sph2d_version());
    ck_assert_str_eq(info.method, "muller");
    ck_assert_str_eq(info.isa, sph2d_isa_name(sph2d_sim_isa(sim)));
    ck_assert_str_eq(info.scene_text, scene_text);
    ck_assert(info.time == sph2d_sim_time(sim) && info.time_step == sph2d_sim_time_step(sim) && info.steps == 60);
    ck_assert(info.domain.max.x == 1 && info.spacing == 0.04);
    ck_assert(info.support_radius == sph2d_sim_plan(sim)->support_radius);
    ck_assert(info.frames.rate.per_second == 30 && info.frames.style == SPH2D_STYLE_POINTS);
    ck_assert(info.frames.size[0] == 1280);
    ck_assert_str_eq(info.frames.color, "speed");
    sph2d_snapshot_destroy(snapshot);
}
END_TEST

START_TEST(a_run_goes_on_from_it)
{
    write_snapshot("a.h5", 0);
    sph2d_snapshot *snapshot = read_snapshot("a.h5");
    sph2d_override more = {"name", "again"};
    sph2d_scene_file *again = NULL;
    ck_assert_int_eq(sph2d_snapshot_scene(snapshot, &more, 1, &again, &report), SPH2D_OK);
    ck_assert_str_eq(sph2d_scene_file_scene(again)->name, "again");
    ck_assert(sph2d_scene_file_scene(again)->run.until == 1); /* the override of the first run */
    sph2d_state state = sph2d_snapshot_state(snapshot);
    sph2d_sim *resumed = NULL;
    sph2d_status status = sph2d_sim_restore(sph2d_scene_file_scene(again), NULL, &state, &resumed, &report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    test_steps(sim, 20);
    test_steps(resumed, 20);
    sph2d_state a = sph2d_sim_state(sim), b = sph2d_sim_state(resumed);
    for (size_t i = 0; i < a.array_count; ++i)
        assert_same_values(&a.arrays[i], &b.arrays[i]);
    sph2d_sim_destroy(resumed);
    /* faults of its scene are told with their place in it */
    more = (sph2d_override){"spacing", "x"};
    sph2d_scene_file_destroy(again);
    sph2d_report_clear(&report);
    ck_assert_int_eq(sph2d_snapshot_scene(snapshot, &more, 1, &again, &report), SPH2D_SCENE);
    ck_assert_str_eq(report.items[0].file, "--set spacing=x");
    sph2d_snapshot_destroy(snapshot);
}
END_TEST

START_TEST(the_same_simulation_gives_the_same_bytes)
{
    write_snapshot("a.h5", _i ? 6 : 0);
    ck_assert_int_eq(mkdir("elsewhere", 0755), 0);
    char *scattered[64]; /* other memory must not show */
    for (int i = 0; i < 64; ++i) {
        scattered[i] = malloc(5000);
        memset(scattered[i], 0xa5, 5000);
    }
    for (int i = 0; i < 64; ++i)
        free(scattered[i]);
    write_snapshot("elsewhere/another.name", _i ? 6 : 0);
    ck_assert(same_files("a.h5", "elsewhere/another.name"));
    write_snapshot("a.h5", _i ? 6 : 0); /* in place of the first */
    ck_assert(same_files("a.h5", "elsewhere/another.name"));
}
END_TEST

START_TEST(structs_without_a_file_and_long_texts)
{
    ck_assert_int_eq(sph2d_snapshot_write(sim, NULL, 0, "a.h5", &report), SPH2D_OK);
    sph2d_snapshot *snapshot = read_snapshot("a.h5");
    ck_assert_ptr_null(sph2d_snapshot_get_info(snapshot).scene_text);
    sph2d_scene_file *none = NULL;
    ck_assert_int_eq(sph2d_snapshot_scene(snapshot, NULL, 0, &none, &report), SPH2D_FORMAT);
    ck_assert_ptr_null(none);
    sph2d_snapshot_destroy(snapshot);
    /* a name and a text that are too long for attributes */
    static char name[100001], text[300000];
    memset(name, 'n', sizeof name - 1);
    int length = snprintf(text, sizeof text, "%s# %s\n", scene_text, name);
    sph2d_override override = {"name", name};
    sph2d_scene_file *long_file = NULL;
    ck_assert_int_eq(sph2d_scene_file_parse(text, (size_t)length, "s", &override, 1, &long_file, &report), SPH2D_OK);
    sph2d_sim *named = test_create(sph2d_scene_file_scene(long_file), NULL);
    ck_assert_int_eq(sph2d_snapshot_write(named, long_file, 0, "b.h5", NULL), SPH2D_OK);
    snapshot = read_snapshot("b.h5");
    ck_assert_str_eq(sph2d_snapshot_get_info(snapshot).scene_name, name);
    ck_assert_str_eq(sph2d_snapshot_get_info(snapshot).scene_text, text);
    sph2d_snapshot_destroy(snapshot);
    sph2d_sim_destroy(named);
    sph2d_scene_file_destroy(long_file);
}
END_TEST

static herr_t count_call(hid_t stack, void *data)
{
    (void)stack;
    ++*(int *)data;
    return 0;
}

START_TEST(hdf5_keeps_the_settings_of_the_program)
{
    int calls = 0;
    H5Eset_auto2(H5E_DEFAULT, count_call, &calls);
    sph2d_snapshot *snapshot = NULL;
    write_snapshot("a.h5", 0);
    ck_assert_int_eq(sph2d_snapshot_read("missing.h5", &snapshot, NULL), SPH2D_NOINPUT);
    ck_assert_int_eq(truncate("a.h5", 5000), 0);
    ck_assert_int_eq(sph2d_snapshot_read("a.h5", &snapshot, NULL), SPH2D_FORMAT);
    ck_assert_int_eq(calls, 0);
    H5E_auto2_t function = NULL;
    void *data = NULL;
    H5Eget_auto2(H5E_DEFAULT, &function, &data);
    ck_assert(function == count_call && data == &calls);
}
END_TEST

START_TEST(the_layout_is_what_other_programs_expect)
{
    write_snapshot("a.h5", 0);
    hid_t f = H5Fopen("a.h5", H5F_ACC_RDONLY, H5P_DEFAULT);
    static const char *const same[][2] = {{"/PartType0/Coordinates", "/VTKHDF/Points"},
                                          {"/PartType0/Velocities", "/VTKHDF/PointData/Velocities"},
                                          {"/PartType0/ParticleIDs", "/VTKHDF/PointData/ParticleIDs"}};
    for (size_t i = 0; i < sizeof same / sizeof same[0]; ++i) {
        H5O_info_t a, b;
        ck_assert_int_ge(H5Oget_info_by_name1(f, same[i][0], &a, H5P_DEFAULT), 0);
        ck_assert_int_ge(H5Oget_info_by_name1(f, same[i][1], &b, H5P_DEFAULT), 0);
        ck_assert_uint_eq(a.addr, b.addr);
    }
    sph2d_view fluid = sph2d_sim_fluid(sim);
    hid_t d = H5Dopen2(f, "/PartType0/Coordinates", H5P_DEFAULT), space = H5Dget_space(d);
    hsize_t sizes[2];
    ck_assert_int_eq(H5Sget_simple_extent_dims(space, sizes, NULL), 2);
    ck_assert(sizes[0] == fluid.count && sizes[1] == 3);
    double *points = malloc(fluid.count * 3 * sizeof *points);
    ck_assert_int_ge(H5Dread(d, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, points), 0);
    for (size_t i = 0; i < fluid.count; ++i)
        ck_assert(points[3 * i] == fluid.x[i] && points[3 * i + 1] == fluid.y[i] && points[3 * i + 2] == 0);
    free(points);
    H5Sclose(space);
    H5Dclose(d);
    static const char *const attributes[][2] = {
        {"/", "Complete"},
        {"/Header", "BoxSize"},
        {"/Header", "NumPart_Total"},
        {"/Header", "Time"},
        {"/Code", "Code Version"},
        {"/Units", "Unit length in cgs (U_L)"},
        {"/VTKHDF", "Type"},
        {"/VTKHDF", "Version"},
        {"/Parameters", "fluid.density"},
        {"/State", "NextTimeStep"},
        {"/State", "StateVersion"},
        {"/Parameters", "blocks[0].box.min"},
        {"/PartType0/Densities", "U_L exponent"},
    };
    for (size_t i = 0; i < sizeof attributes / sizeof attributes[0]; ++i)
        ck_assert_msg(H5Aexists_by_name(f, attributes[i][0], attributes[i][1], H5P_DEFAULT) > 0, "%s %s",
                      attributes[i][0], attributes[i][1]);
    H5Fclose(f);
}
END_TEST

/* ---- what is refused --------------------------------------------------------------------------------------------- */

static void drop_attribute(hid_t f, const char *group, const char *name)
{
    ck_assert_int_ge(H5Adelete_by_name(f, group, name, H5P_DEFAULT), 0);
}

static void drop_link(hid_t f, const char *path)
{
    ck_assert_int_ge(H5Ldelete(f, path, H5P_DEFAULT), 0);
}

/** Puts a list of `count` zeros of a type in the place of an attribute; 0 for a scalar. */
static void put_attribute(hid_t f, const char *group, const char *name, hid_t type, hsize_t count, const void *value)
{
    if (H5Aexists_by_name(f, group, name, H5P_DEFAULT) > 0)
        drop_attribute(f, group, name);
    hid_t space = count > 0 ? H5Screate_simple(1, &count, NULL) : H5Screate(H5S_SCALAR);
    hid_t at = H5Oopen(f, group, H5P_DEFAULT);
    hid_t a = H5Acreate2(at, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    ck_assert_int_ge(a, 0);
    if (value)
        H5Awrite(a, type, value);
    H5Aclose(a);
    H5Oclose(at);
    H5Sclose(space);
}

static void put_count(hid_t f, const char *group, const char *name, uint64_t value)
{
    put_attribute(f, group, name, H5T_NATIVE_UINT64, 0, &value);
}

/** Puts a dataset of another shape in the place of one; of `chunk` values in a chunk, 0 for none. */
static void put_dataset(hid_t f, const char *path, hid_t type, int rank, hsize_t rows, hsize_t columns, hsize_t chunk)
{
    drop_link(f, path);
    hsize_t sizes[3] = {rows, columns, 1}, most[3] = {H5S_UNLIMITED, columns, 1};
    hid_t space = H5Screate_simple(rank, sizes, chunk > 0 ? most : NULL), properties = H5Pcreate(H5P_DATASET_CREATE);
    if (chunk > 0)
        H5Pset_chunk(properties, 1, &chunk);
    hid_t d = H5Dcreate2(f, path, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    ck_assert_int_ge(d, 0);
    double zeros[3] = {0};
    if (rows < 10000 && chunk < 10000) { /* gives it its bytes */
        hsize_t start[3] = {0}, one[3] = {1, 1, 1};
        hid_t memory = H5Screate_simple(rank, one, NULL);
        H5Sselect_hyperslab(space, H5S_SELECT_SET, start, NULL, one, NULL);
        ck_assert_int_ge(H5Dwrite(d, type, memory, space, H5P_DEFAULT, zeros), 0);
        H5Sclose(memory);
    }
    H5Dclose(d);
    H5Pclose(properties);
    H5Sclose(space);
}

#define DENSITIES "/PartType0/Densities"

static void incomplete(hid_t f)
{
    drop_attribute(f, "/", "Complete");
}
static void not_complete(hid_t f)
{
    put_count(f, "/", "Complete", 0);
}
static void another_kind(hid_t f)
{
    drop_attribute(f, "/", "Format");
}
static void future_format(hid_t f)
{
    put_count(f, "/", "FormatVersion", 2);
}
static void future_state(hid_t f)
{
    put_count(f, "/State", "StateVersion", SPH2D_STATE_VERSION + 1);
}
static void no_velocities(hid_t f)
{
    drop_link(f, "/PartType0/Velocities");
}
static void no_masses(hid_t f)
{
    drop_link(f, "/PartType0/Masses");
}
static void no_walls(hid_t f)
{
    drop_link(f, "/PartType1");
}
static void no_state(hid_t f)
{
    drop_link(f, "/State");
}
static void no_list(hid_t f)
{
    drop_link(f, "/State/Arrays");
}
static void no_clock(hid_t f)
{
    drop_attribute(f, "/State", "NextTimeStep");
}
static void no_domain(hid_t f)
{
    drop_attribute(f, "/Parameters", "domain.min");
}
static void short_list(hid_t f)
{
    put_dataset(f, DENSITIES, H5T_NATIVE_DOUBLE, 1, 3, 1, 0);
}
static void two_columns(hid_t f)
{
    put_dataset(f, DENSITIES, H5T_NATIVE_DOUBLE, 2, 200, 2, 0);
}
static void three_dimensions(hid_t f)
{
    put_dataset(f, DENSITIES, H5T_NATIVE_DOUBLE, 3, 200, 1, 0);
}
static void floats(hid_t f)
{
    put_dataset(f, DENSITIES, H5T_NATIVE_FLOAT, 1, 200, 1, 0);
}
static void signed_numbers(hid_t f)
{
    put_dataset(f, "/PartType0/ParticleIDs", H5T_NATIVE_INT64, 1, 200, 1, 0);
}
static void endless(hid_t f)
{
    put_dataset(f, DENSITIES, H5T_NATIVE_DOUBLE, 1, (hsize_t)1 << 40, 1, 0);
}
static void endless_chunks(hid_t f)
{
    put_dataset(f, DENSITIES, H5T_NATIVE_DOUBLE, 1, (hsize_t)1 << 40, 1, 1000);
}
static void beyond_bytes(hid_t f)
{
    put_dataset(f, DENSITIES, H5T_NATIVE_DOUBLE, 1, (hsize_t)1 << 61, 1, 1000);
}
static void huge_chunk(hid_t f)
{
    put_dataset(f, DENSITIES, H5T_NATIVE_DOUBLE, 1, 200, 1, (hsize_t)1 << 28);
}
static void clock_list(hid_t f)
{
    put_attribute(f, "/State", "Time", H5T_NATIVE_DOUBLE, 3, NULL);
}
static void clock_count(hid_t f)
{
    put_attribute(f, "/Header", "Time", H5T_NATIVE_UINT64, 1, NULL);
}
static void odd_word(hid_t f)
{
    put_attribute(f, "/Parameters", "run.frames.style", H5T_C_S1, 0, "x");
}
static void no_number(hid_t f)
{
    double nan = strtod("nan", NULL);
    put_attribute(f, "/Header", "Time", H5T_NATIVE_DOUBLE, 1, &nan);
}
static void no_size(hid_t f)
{
    uint64_t size[2] = {1280, 1};
    put_attribute(f, "/Parameters", "run.frames.size", H5T_NATIVE_UINT64, 2, size);
}
static void variable_text(hid_t f)
{
    hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    put_attribute(f, "/Code", "Code Version", type, 0, NULL);
    H5Tclose(type);
}
static void group_is_dataset(hid_t f)
{
    drop_link(f, "/PartType1");
    hsize_t one = 1;
    hid_t space = H5Screate_simple(1, &one, NULL);
    H5Dclose(H5Dcreate2(f, "/PartType1", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    H5Sclose(space);
}
static void dataset_is_group(hid_t f)
{
    drop_link(f, DENSITIES);
    H5Gclose(H5Gcreate2(f, DENSITIES, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
}
static void other_value(hid_t f)
{
    hid_t d = H5Dopen2(f, DENSITIES, H5P_DEFAULT), memory = H5Screate(H5S_SCALAR), space = H5Dget_space(d);
    hsize_t place = 5;
    double value = 1234;
    H5Sselect_elements(space, H5S_SELECT_SET, 1, &place);
    ck_assert_int_ge(H5Dwrite(d, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, &value), 0);
    H5Sclose(space);
    H5Sclose(memory);
    H5Dclose(d);
}

static const struct {
    void (*change)(hid_t f);
    sph2d_code code;
    const char *message;
} refusals[] = {
    {incomplete, SPH2D_CODE_FILE_INCOMPLETE, "not written to its end"},
    {not_complete, SPH2D_CODE_FILE_INCOMPLETE, "not written to its end"},
    {another_kind, SPH2D_CODE_FILE_KIND, "no snapshot of sph2d"},
    {future_format, SPH2D_CODE_FILE_VERSION, "the file has version 2."},
    {future_state, SPH2D_CODE_FILE_VERSION, "this program reads 1."},
    {no_velocities, SPH2D_CODE_FILE_FIELD, "'/PartType0/Velocities' is missing"},
    {no_masses, SPH2D_CODE_FILE_FIELD, "'/PartType0/Masses' is missing"},
    {no_walls, SPH2D_CODE_FILE_FIELD, "'/PartType1/Coordinates' is missing"},
    {no_state, SPH2D_CODE_FILE_FIELD, "'/State/StateVersion' is missing"},
    {no_list, SPH2D_CODE_FILE_FIELD, "'/State/Arrays' is missing"},
    {no_clock, SPH2D_CODE_FILE_FIELD, "'/State/NextTimeStep' is missing"},
    {no_domain, SPH2D_CODE_FILE_FIELD, "'/Parameters/domain.min' is missing"},
    {short_list, SPH2D_CODE_FILE_FIELD, "'Densities' has 3 values"},
    {two_columns, SPH2D_CODE_FILE_FIELD, "'Densities' has the wrong shape"},
    {three_dimensions, SPH2D_CODE_FILE_FIELD, "'Densities' has the wrong shape"},
    {floats, SPH2D_CODE_FILE_FIELD, "'Densities' has the wrong type"},
    {signed_numbers, SPH2D_CODE_FILE_FIELD, "'ParticleIDs' has the wrong type"},
    {endless, SPH2D_CODE_FILE_FIELD, "'Densities' is damaged"},
    {endless_chunks, SPH2D_CODE_FILE_FIELD, "'Densities' is damaged"},
    {beyond_bytes, SPH2D_CODE_FILE_FIELD, "'Densities' is damaged"},
    {huge_chunk, SPH2D_CODE_FILE_FIELD, "'Densities' is damaged"},
    {clock_list, SPH2D_CODE_FILE_FIELD, "'Time' has the wrong shape"},
    {clock_count, SPH2D_CODE_FILE_FIELD, "'Time' has the wrong type"},
    {odd_word, SPH2D_CODE_FILE_FIELD, "'run.frames.style' has a value that this program does not know"},
    {no_number, SPH2D_CODE_FILE_FIELD, "not finite"},
    {no_size, SPH2D_CODE_FILE_FIELD, "'run.frames.size' is out of range"},
    {variable_text, SPH2D_CODE_FILE_FIELD, "'Code Version' has the wrong type"},
    {group_is_dataset, SPH2D_CODE_FILE_FIELD, "'/PartType1/Coordinates' is missing"},
    {dataset_is_group, SPH2D_CODE_FILE_FIELD, "'Densities' cannot be read"},
};

static void expect_refusal(const char *path, sph2d_status status, sph2d_code code, const char *message)
{
    sph2d_report_clear(&report);
    sph2d_snapshot *snapshot = NULL;
    ck_assert_int_eq(sph2d_snapshot_read(path, &snapshot, &report), status);
    ck_assert_ptr_null(snapshot);
    const char *all = test_report_text(&report);
    ck_assert_uint_gt(report.errors, 0);
    ck_assert_msg(report.items[0].code == code && strstr(report.items[0].message, message) != NULL, "%s", all);
    ck_assert_msg(status != SPH2D_FORMAT || strcmp(report.items[0].file, path) == 0, "%s", all);
}

START_TEST(changed_files_are_refused)
{
    write_snapshot("a.h5", 0);
    hid_t f = H5Fopen("a.h5", H5F_ACC_RDWR, H5P_DEFAULT);
    ck_assert_int_ge(f, 0);
    refusals[_i].change(f);
    ck_assert_int_ge(H5Fclose(f), 0);
    expect_refusal("a.h5", SPH2D_FORMAT, refusals[_i].code, refusals[_i].message);
}
END_TEST

START_TEST(a_change_on_purpose_is_read)
{
    write_snapshot("a.h5", 0);
    hid_t f = H5Fopen("a.h5", H5F_ACC_RDWR, H5P_DEFAULT);
    other_value(f);
    H5Fclose(f);
    sph2d_snapshot *snapshot = read_snapshot("a.h5");
    const sph2d_array *densities = sph2d_snapshot_array(snapshot, SPH2D_GROUP_FLUID, "Densities");
    ck_assert(((const double *)densities->data[0])[5] == 1234);
    sph2d_snapshot_destroy(snapshot);
}
END_TEST

START_TEST(what_is_no_snapshot_is_refused)
{
    expect_refusal("missing.h5", SPH2D_NOINPUT, SPH2D_CODE_FILE_OPEN, "'missing.h5': No such file");
    expect_refusal(folder, SPH2D_NOINPUT, SPH2D_CODE_FILE_OPEN, "Is a directory");
    expect_refusal("/dev/null", SPH2D_FORMAT, SPH2D_CODE_FILE_KIND, "a device or pipe");
    store("a.h5", "", 0);
    expect_refusal("a.h5", SPH2D_FORMAT, SPH2D_CODE_FILE_KIND, "not an HDF5 file: it is empty");
    store("a.h5", scene_text, sizeof scene_text);
    expect_refusal("a.h5", SPH2D_FORMAT, SPH2D_CODE_FILE_KIND, "not an HDF5 file");
    store("a.h5", "\x89HDF\r\n\x1a\n", 8);
    expect_refusal("a.h5", SPH2D_FORMAT, SPH2D_CODE_FILE_INCOMPLETE, "damaged or cut short");
    H5Fclose(H5Fcreate("a.h5", H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
    expect_refusal("a.h5", SPH2D_FORMAT, SPH2D_CODE_FILE_KIND, "no snapshot of sph2d");
    ck_assert_int_eq(mkfifo("pipe", 0644), 0);
    expect_refusal("pipe", SPH2D_FORMAT, SPH2D_CODE_FILE_KIND, "a device or pipe");
}
END_TEST

START_TEST(cut_files_are_refused)
{
    write_snapshot("a.h5", 0);
    size_t size;
    void *bytes = load("a.h5", &size);
    for (size_t i = 0; i < 400; ++i) {
        store("b.h5", bytes, i < 100 ? i : size * i / 400);
        sph2d_snapshot *snapshot = NULL;
        ck_assert_int_eq(sph2d_snapshot_read("b.h5", &snapshot, NULL), SPH2D_FORMAT);
        ck_assert_ptr_null(snapshot);
    }
    free(bytes);
}
END_TEST

START_TEST(a_single_bit_is_noticed)
{
    write_snapshot("a.h5", 0);
    size_t size;
    unsigned char *bytes = load("a.h5", &size);
    for (size_t i = 0; i < 200; ++i) {
        size_t at = (size - 16) * i / 200; /* the seal has 16 bytes */
        bytes[at] ^= (unsigned char)(1u << i % 8);
        store("b.h5", bytes, size);
        bytes[at] ^= (unsigned char)(1u << i % 8);
        if (at >= 8) /* before that, it is not even HDF5 */
            expect_refusal("b.h5", SPH2D_FORMAT, SPH2D_CODE_FILE_INCOMPLETE,
                           "its bytes are not those that were written");
    }
    free(bytes);
}
END_TEST

/** Reads b.h5 and makes a simulation of it if that is possible. Whether everything went as it should. */
static bool survives(void)
{
    sph2d_report_clear(&report);
    sph2d_snapshot *snapshot = NULL;
    sph2d_status status = sph2d_snapshot_read("b.h5", &snapshot, &report);
    if (status == SPH2D_OK) {
        sph2d_state state = sph2d_snapshot_state(snapshot);
        sph2d_sim *restored = NULL;
        sph2d_sim_restore(sph2d_scene_file_scene(file), NULL, &state, &restored, NULL);
        sph2d_sim_destroy(restored);
    }
    sph2d_snapshot_destroy(snapshot);
    return (status == SPH2D_OK || (status == SPH2D_FORMAT && report.errors > 0)) &&
           H5Fget_obj_count((hid_t)H5F_OBJ_ALL, H5F_OBJ_ALL) == 0;
}

/** Takes the seal off and turns bits and bytes at random. HDF5 must not crash over them, nor the reader, nor a
 *  simulation made of the result. In a process of its own: HDF5 loses memory over damaged files, and would say so. */
START_TEST(damaged_files_do_no_harm)
{
    write_snapshot("a.h5", _i ? 6 : 0);
    size_t size;
    unsigned char *bytes = load("a.h5", &size), *damaged = malloc(size);
    size -= 16;
    pid_t child = fork();
    ck_assert_int_ge(child, 0);
    uint64_t random = 1;
    for (size_t round = 0; child == 0 && round < 500; ++round) {
        memcpy(damaged, bytes, size);
        for (size_t change = 0; change <= round % 4; ++change) {
            size_t at = (size_t)test_random(&random, 0, (double)size);
            unsigned bit = (unsigned)test_random(&random, 0, 8);
            damaged[at] = round % 8 < 5 ? damaged[at] ^ (unsigned char)(1u << bit) : (unsigned char)(bit < 4 ? 0 : 255);
        }
        store("b.h5", damaged, size);
        alarm(30); /* a hang is a failure, too */
        if (!survives())
            _exit(1);
    }
    if (child == 0)
        _exit(0);
    int state;
    ck_assert_int_eq(waitpid(child, &state, 0), child);
    ck_assert_msg(state == 0, "a reader died or was wrong (%x); its file is b.h5", (unsigned)state);
    free(bytes);
    free(damaged);
}
END_TEST

/* ---- what cannot be written -------------------------------------------------------------------------------------- */

static void expect_no_write(const char *path, sph2d_status status, const char *message)
{
    sph2d_report_clear(&report);
    ck_assert_int_eq(sph2d_snapshot_write(sim, file, 0, path, &report), status);
    ck_assert_uint_eq(report.errors, 1);
    ck_assert_int_eq(report.items[0].code, SPH2D_CODE_FILE_WRITE);
    ck_assert_msg(strstr(report.items[0].message, message) != NULL, "%s", test_report_text(&report));
}

START_TEST(places_that_take_no_file)
{
    expect_no_write("/dev/full", SPH2D_CANTCREAT, "not a regular file");
    expect_no_write("missing/a.h5", SPH2D_CANTCREAT, "'missing/a.h5': No such file");
    expect_no_write(folder, SPH2D_CANTCREAT, "Is a directory");
    expect_no_write("", SPH2D_CANTCREAT, "No such file");
    ck_assert_int_eq(mkdir("locked", 0555), 0);
    ck_assert_int_eq(chmod(folder, 0755), 0);
    if (geteuid() == 0) /* root may write anywhere; nobody may not */
        ck_assert_int_eq(seteuid(65534), 0);
    expect_no_write("locked/a.h5", SPH2D_CANTCREAT, "Permission denied");
    if (getuid() == 0)
        ck_assert_int_eq(seteuid(0), 0);
    ck_assert_int_eq(sph2d_snapshot_write(NULL, file, 0, "a.h5", NULL), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_snapshot_write(sim, file, 10, "a.h5", NULL), SPH2D_INVALID);
    struct stat info;
    ck_assert(stat("/dev/full", &info) == 0 && S_ISCHR(info.st_mode));
}
END_TEST

/** The number of names in the folder. */
static int names(void)
{
    FILE *list = popen("ls -A | wc -l", "r");
    int count = -1;
    ck_assert_int_eq(fscanf(list, "%d", &count), 1);
    pclose(list);
    return count;
}

/** Room runs out at every stage of the writing; the limit of the process stands for the disk's. */
START_TEST(a_full_disk_leaves_the_old_file)
{
    write_snapshot("a.h5", _i ? 6 : 0);
    size_t size;
    free(load("a.h5", &size));
    signal(SIGXFSZ, SIG_IGN);
    for (size_t i = 0; i < 60; ++i) {
        store("b.h5", "old", 3);
        struct rlimit limit = {size * i / 60, RLIM_INFINITY}, none = {RLIM_INFINITY, RLIM_INFINITY};
        ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &limit), 0);
        sph2d_report_clear(&report);
        sph2d_status status = sph2d_snapshot_write(sim, file, _i ? 6 : 0, "b.h5", &report);
        ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &none), 0);
        ck_assert_int_eq(status, SPH2D_IO);
        ck_assert_msg(report.errors == 1 && strstr(report.items[0].message, "'b.h5': File too large"), "%s",
                      test_report_text(&report));
        char *kept = load("b.h5", &(size_t){0});
        ck_assert_int_eq(memcmp(kept, "old", 3), 0);
        free(kept);
        ck_assert_int_eq(H5Fget_obj_count((hid_t)H5F_OBJ_ALL, H5F_OBJ_ALL), 0);
    }
    ck_assert_int_eq(names(), 2); /* and nothing beside */
    write_snapshot("b.h5", _i ? 6 : 0);
    ck_assert(same_files("a.h5", "b.h5"));
}
END_TEST

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

START_TEST(a_killed_writer_leaves_a_whole_file_or_none)
{
    double start = seconds();
    write_snapshot("a.h5", 6);
    double one = seconds() - start; /* what a write takes */
    int found = 0;
    for (int round = 0; round < 40; ++round) {
        remove("a.h5");
        pid_t child = fork();
        ck_assert_int_ge(child, 0);
        if (child == 0)
            for (;;)
                sph2d_snapshot_write(sim, file, round % 2 ? 6 : 0, "a.h5", NULL);
        double wait = fmin(one * (0.1 + 0.15 * round), 0.9);
        nanosleep(&(struct timespec){0, (long)(1e9 * wait)}, NULL);
        kill(child, SIGKILL);
        waitpid(child, NULL, 0);
        if (access("a.h5", F_OK) == 0) {
            sph2d_snapshot_destroy(read_snapshot("a.h5"));
            ++found;
        }
    }
    ck_assert_int_gt(found, 0); /* otherwise nothing was tested */
}
END_TEST

Suite *suite_snapshot(void)
{
    Suite *suite = suite_create("snapshot");
    TCase *back = tcase_create("there and back");
    tcase_add_checked_fixture(back, set_up, tear_down);
    tcase_add_loop_test(back, every_bit_comes_back, 0, 2);
    tcase_add_test(back, it_says_what_it_is);
    tcase_add_test(back, a_run_goes_on_from_it);
    tcase_add_loop_test(back, the_same_simulation_gives_the_same_bytes, 0, 2);
    tcase_add_test(back, structs_without_a_file_and_long_texts);
    tcase_add_test(back, hdf5_keeps_the_settings_of_the_program);
    tcase_add_test(back, the_layout_is_what_other_programs_expect);
    suite_add_tcase(suite, back);
    TCase *refused = tcase_create("refused");
    tcase_add_checked_fixture(refused, set_up, tear_down);
    tcase_add_loop_test(refused, changed_files_are_refused, 0, sizeof refusals / sizeof refusals[0]);
    tcase_add_test(refused, a_change_on_purpose_is_read);
    tcase_add_test(refused, what_is_no_snapshot_is_refused);
    tcase_add_test(refused, cut_files_are_refused);
    tcase_add_test(refused, a_single_bit_is_noticed);
    tcase_add_loop_test(refused, damaged_files_do_no_harm, 0, 2);
    suite_add_tcase(suite, refused);
    TCase *unwritable = tcase_create("unwritable");
    tcase_add_checked_fixture(unwritable, set_up, tear_down);
    tcase_add_test(unwritable, places_that_take_no_file);
    tcase_add_loop_test(unwritable, a_full_disk_leaves_the_old_file, 0, 2);
    tcase_add_test(unwritable, a_killed_writer_leaves_a_whole_file_or_none);
    suite_add_tcase(suite, unwritable);
    return suite;
}
