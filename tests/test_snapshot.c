/* SPDX-License-Identifier: MIT */
/** @file test_snapshot.c
 *  Snapshots: that they bring back every bit, that they are the same bytes every time, and that no disk, however full,
 *  does harm. */
#include <dirent.h>
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

#include "snapshot_fixture.h"

static bool same_files(const char *a, const char *b)
{
    size_t m, n;
    void *x = load_file(a, &m), *y = load_file(b, &n);
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
    sph2d_state before = sph2d_sim_state(fixture.sim), after = sph2d_snapshot_state(snapshot);
    ck_assert_uint_eq(after.version, before.version);
    ck_assert_uint_gt(after.array_count, before.array_count);
    for (size_t i = 0; i < before.array_count; ++i)
        assert_same_values(&before.arrays[i], &after.arrays[i]);
    for (int g = SPH2D_GROUP_FLUID; g <= SPH2D_GROUP_WALL; ++g)
        for (size_t i = 0; i < sph2d_field_count((sph2d_group)g); ++i) {
            sph2d_array field = sph2d_field(fixture.sim, (sph2d_group)g, i);
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
    ck_assert_str_eq(info.method, "wcsph");
    ck_assert_str_eq(info.isa, sph2d_isa_name(sph2d_sim_isa(fixture.sim)));
    ck_assert_str_eq(info.scene_text, fixture.text);
    ck_assert(info.time == sph2d_sim_time(fixture.sim) && info.time_step == sph2d_sim_time_step(fixture.sim) &&
              info.steps == 60);
    ck_assert(info.domain.max.x == 1 && info.spacing == 0.04);
    ck_assert(info.support_radius == sph2d_sim_plan(fixture.sim)->support_radius);
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
    ck_assert_int_eq(sph2d_snapshot_scene(snapshot, &more, 1, &again, &fixture.report), SPH2D_OK);
    ck_assert_str_eq(sph2d_scene_file_scene(again)->name, "again");
    ck_assert(sph2d_scene_file_scene(again)->run.until == 1); /* the override of the first run */
    sph2d_state state = sph2d_snapshot_state(snapshot);
    sph2d_sim *resumed = NULL;
    sph2d_status status = sph2d_sim_restore(sph2d_scene_file_scene(again), NULL, &state, &resumed, &fixture.report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&fixture.report));
    test_steps(fixture.sim, 20);
    test_steps(resumed, 20);
    sph2d_state a = sph2d_sim_state(fixture.sim), b = sph2d_sim_state(resumed);
    for (size_t i = 0; i < a.array_count; ++i)
        assert_same_values(&a.arrays[i], &b.arrays[i]);
    sph2d_sim_destroy(resumed);
    /* faults of its scene are told with their place in it */
    more = (sph2d_override){"spacing", "x"};
    sph2d_scene_file_destroy(again);
    sph2d_report_clear(&fixture.report);
    ck_assert_int_eq(sph2d_snapshot_scene(snapshot, &more, 1, &again, &fixture.report), SPH2D_SCENE);
    ck_assert_str_eq(fixture.report.items[0].file, "--set spacing=x");
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
    ck_assert_int_eq(sph2d_snapshot_write(fixture.sim, NULL, 0, "a.h5", &fixture.report), SPH2D_OK);
    sph2d_snapshot *snapshot = read_snapshot("a.h5");
    ck_assert_ptr_null(sph2d_snapshot_get_info(snapshot).scene_text);
    sph2d_scene_file *none = NULL;
    ck_assert_int_eq(sph2d_snapshot_scene(snapshot, NULL, 0, &none, &fixture.report), SPH2D_FORMAT);
    ck_assert_ptr_null(none);
    sph2d_snapshot_destroy(snapshot);
    /* a name and a text that are too long for attributes */
    static char name[100001], text[300000];
    memset(name, 'n', sizeof name - 1);
    int length = snprintf(text, sizeof text, "%s# %s\n", fixture.text, name);
    sph2d_override override = {"name", name};
    sph2d_scene_file *long_file = NULL;
    ck_assert_int_eq(sph2d_scene_file_parse(text, (size_t)length, "s", &override, 1, &long_file, &fixture.report),
                     SPH2D_OK);
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

/** Reads a dataset of `count` doubles. */
static double *read_reals(hid_t file, const char *path, size_t count)
{
    hid_t d = H5Dopen2(file, path, H5P_DEFAULT), space = H5Dget_space(d);
    ck_assert_uint_eq((size_t)H5Sget_simple_extent_npoints(space), count);
    double *values = malloc((count + 1) * sizeof *values);
    ck_assert_int_ge(H5Dread(d, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), 0);
    H5Sclose(space);
    H5Dclose(d);
    return values;
}

/** Particles, boundary particles, corners: the values of the three groups, or none, without copies of them. */
START_TEST(vtk_has_fluid_walls_and_outlines)
{
    static const char *const groups[] = {"/PartType0", "/PartType1", "/Outlines"};
    static const struct {
        const char *name, *as;
        size_t columns, groups;
    } fields[] = {{"Coordinates", "/VTKHDF/Points", 3, 3},
                  {"Velocities", "/VTKHDF/PointData/Velocities", 3, 2},
                  {"Pressures", "/VTKHDF/PointData/Pressures", 1, 2},
                  {"Accelerations", "/VTKHDF/PointData/Accelerations", 3, 1}};
    const size_t counts[] = {sph2d_sim_fluid(fixture.sim).count, sph2d_sim_walls(fixture.sim).count,
                             sph2d_field(fixture.sim, SPH2D_GROUP_OUTLINE, 0).count};
    const size_t all = counts[0] + counts[1] + counts[2];
    ck_assert(counts[1] > 0 && counts[2] > 0);
    write_snapshot("a.h5", _i ? 6 : 0);
    hid_t f = H5Fopen("a.h5", H5F_ACC_RDONLY, H5P_DEFAULT);
    for (size_t k = 0; k < sizeof fields / sizeof *fields; ++k) {
        double *joined = read_reals(f, fields[k].as, all * fields[k].columns), *next = joined;
        hid_t d = H5Dopen2(f, fields[k].as, H5P_DEFAULT);
        ck_assert_uint_eq(H5Dget_storage_size(d), 0);
        H5Dclose(d);
        for (size_t g = 0; g < 3; next += counts[g++] * fields[k].columns) {
            char path[64];
            snprintf(path, sizeof path, "%s/%s", groups[g], fields[k].name);
            double *part = g < fields[k].groups ? read_reals(f, path, counts[g] * fields[k].columns) : NULL;
            for (size_t i = 0; i < counts[g] * fields[k].columns; ++i)
                ck_assert_msg(part ? next[i] == part[i] : isnan(next[i]), "%s of %s", fields[k].name, groups[g]);
            free(part);
        }
        free(joined);
    }
    double *kinds = read_reals(f, "/VTKHDF/PointData/Kinds", all),
           *ids = read_reals(f, "/Outlines/OutlineIDs", counts[2]);
    for (size_t i = 0; i < all; ++i)
        ck_assert(kinds[i] == (i < counts[0] ? 0 : i < counts[0] + counts[1] ? 1 : 2));
    double *vertices = read_reals(f, "/VTKHDF/Vertices/Connectivity", counts[0] + counts[1]);
    for (size_t i = 0; i < counts[0] + counts[1]; ++i)
        ck_assert(vertices[i] == (double)i);
    /* the sides and the line of the scene are lines; it has no solids */
    ck_assert(ids[counts[2] - 1] == 1);
    double *offsets = read_reals(f, "/VTKHDF/Lines/Offsets", 3),
           *corners = read_reals(f, "/VTKHDF/Lines/Connectivity", counts[2]);
    for (size_t i = 0; i < counts[2]; ++i) {
        ck_assert(corners[i] == (double)(counts[0] + counts[1] + i));
        ck_assert((ids[i] == 0) == ((double)i < offsets[1]));
    }
    ck_assert(offsets[0] == 0 && offsets[2] == (double)counts[2]);
    free(read_reals(f, "/VTKHDF/Polygons/Connectivity", 0));
    double *lists[] = {kinds, ids, vertices, offsets, corners};
    for (size_t i = 0; i < sizeof lists / sizeof *lists; ++i)
        free(lists[i]);
    H5Fclose(f);
}
END_TEST

/** Without liquid, boundary particles and walls there are no points, but all of the datasets. */
START_TEST(vtk_of_a_scene_with_nothing)
{
    static const char text[] = "domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.04\nmethod: muller\n"
                               "boundary: {left: open, right: open, top: open, bottom: open}\n"
                               "sources:\n  - {at: [0.5, 0.5], speed: 1, width: 0.1, start: 5}\n";
    sph2d_scene_file *file = NULL;
    sph2d_report_clear(&fixture.report);
    sph2d_status status = sph2d_scene_file_parse(text, sizeof text - 1, "s.yaml", NULL, 0, &file, &fixture.report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&fixture.report));
    sph2d_sim *sim = test_create(sph2d_scene_file_scene(file), NULL);
    ck_assert_int_eq(sph2d_snapshot_write(sim, file, 0, "a.h5", NULL), SPH2D_OK);
    hid_t f = H5Fopen("a.h5", H5F_ACC_RDONLY, H5P_DEFAULT);
    static const char *const none[] = {"Points", "PointData/Pressures", "PointData/Kinds", "Lines/Connectivity"};
    for (size_t i = 0; i < sizeof none / sizeof *none; ++i) {
        char path[64];
        snprintf(path, sizeof path, "/VTKHDF/%s", none[i]);
        free(read_reals(f, path, 0));
    }
    H5Fclose(f);
    sph2d_snapshot_destroy(read_snapshot("a.h5"));
    sph2d_sim_destroy(sim);
    sph2d_scene_file_destroy(file);
}
END_TEST

START_TEST(the_layout_is_what_other_programs_expect)
{
    write_snapshot("a.h5", 0);
    hid_t f = H5Fopen("a.h5", H5F_ACC_RDONLY, H5P_DEFAULT);
    sph2d_view fluid = sph2d_sim_fluid(fixture.sim);
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
    /* What SWIFT has is a list of one, as swiftsimio expects; the rest converts to a number. */
    static const struct {
        const char *group, *name;
        int rank;
    } shapes[] = {{"/Header", "Time", 1},   {"/Header", "Scale-factor", 1}, {"/Units", "Unit time in cgs (U_t)", 1},
                  {"/Header", "Step", 0},   {"/Header", "Spacing", 0},      {"/Header", "SoundSpeed", 0},
                  {"/State", "Time", 0},    {"/Header", "TimeStep", 0},     {"/Header", "SupportRadius", 0},
                  {"/", "FormatVersion", 0}};
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; ++i) {
        hid_t a = H5Aopen_by_name(f, shapes[i].group, shapes[i].name, H5P_DEFAULT, H5P_DEFAULT), of = H5Aget_space(a);
        ck_assert_msg(H5Sget_simple_extent_ndims(of) == shapes[i].rank, "%s %s", shapes[i].group, shapes[i].name);
        H5Sclose(of);
        H5Aclose(a);
    }
    H5Fclose(f);
}
END_TEST

/* ---- in two halves ----------------------------------------------------------------------------------------------- */

/** The number of names in the folder. */
static int names(void)
{
    DIR *list = opendir(".");
    int count = -2; /* itself and the one above */
    while (readdir(list))
        ++count;
    closedir(list);
    return count;
}

START_TEST(a_draft_becomes_a_snapshot_when_it_is_told)
{
    write_snapshot("a.h5", 0);
    sph2d_snapshot_draft *draft;
    ck_assert_int_eq(sph2d_snapshot_begin(fixture.sim, fixture.file, 0, "b.h5", &draft, NULL), SPH2D_OK);
    ck_assert_int_eq(access("b.h5", F_OK), -1);
    ck_assert_int_eq(names(), 2);
    ck_assert_int_eq(sph2d_sim_step(fixture.sim, NULL), SPH2D_OK); /* the draft has the state from before */
    ck_assert_int_eq(sph2d_snapshot_commit(draft, NULL), SPH2D_OK);
    ck_assert(same_files("a.h5", "b.h5"));
    ck_assert_int_eq(sph2d_snapshot_begin(fixture.sim, fixture.file, 0, "c.h5", &draft, NULL), SPH2D_OK);
    sph2d_snapshot_abort(draft);
    ck_assert_int_eq(access("c.h5", F_OK), -1);
    ck_assert_int_eq(names(), 2);
}
END_TEST

/* ---- what cannot be written -------------------------------------------------------------------------------------- */

static void expect_no_write(const char *path, sph2d_status status, const char *message)
{
    sph2d_report_clear(&fixture.report);
    ck_assert_int_eq(sph2d_snapshot_write(fixture.sim, fixture.file, 0, path, &fixture.report), status);
    ck_assert_uint_eq(fixture.report.errors, 1);
    ck_assert_int_eq(fixture.report.items[0].code, SPH2D_CODE_FILE_WRITE);
    ck_assert_msg(strstr(fixture.report.items[0].message, message) != NULL, "%s", test_report_text(&fixture.report));
}

START_TEST(places_that_take_no_file)
{
    expect_no_write("/dev/full", SPH2D_CANTCREAT, "not a regular file");
    expect_no_write("missing/a.h5", SPH2D_CANTCREAT, "'missing/a.h5': No such file");
    expect_no_write(fixture.folder, SPH2D_CANTCREAT, "Is a directory");
    expect_no_write("", SPH2D_CANTCREAT, "No such file");
    ck_assert_int_eq(mkdir("locked", 0555), 0);
    ck_assert_int_eq(chmod(fixture.folder, 0755), 0);
    if (geteuid() == 0) /* root may write anywhere; nobody may not */
        ck_assert_int_eq(seteuid(65534), 0);
    expect_no_write("locked/a.h5", SPH2D_CANTCREAT, "Permission denied");
    if (getuid() == 0)
        ck_assert_int_eq(seteuid(0), 0);
    ck_assert_int_eq(sph2d_snapshot_write(NULL, fixture.file, 0, "a.h5", NULL), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_snapshot_write(fixture.sim, fixture.file, 10, "a.h5", NULL), SPH2D_INVALID);
    struct stat info;
    ck_assert(stat("/dev/full", &info) == 0 && S_ISCHR(info.st_mode));
}
END_TEST

/** Room runs out at every stage of the writing; the limit of the process stands for the disk's. */
START_TEST(a_full_disk_leaves_the_old_file)
{
    write_snapshot("a.h5", _i ? 6 : 0);
    size_t size;
    free(load_file("a.h5", &size));
    signal(SIGXFSZ, SIG_IGN);
    for (size_t i = 0; i < 60; ++i) {
        store_file("b.h5", "old", 3);
        struct rlimit limit = {size * i / 60, RLIM_INFINITY}, none = {RLIM_INFINITY, RLIM_INFINITY};
        ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &limit), 0);
        sph2d_report_clear(&fixture.report);
        sph2d_status status = sph2d_snapshot_write(fixture.sim, fixture.file, _i ? 6 : 0, "b.h5", &fixture.report);
        ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &none), 0);
        ck_assert_int_eq(status, SPH2D_IO);
        ck_assert_msg(fixture.report.errors == 1 && strstr(fixture.report.items[0].message, "'b.h5': File too large"),
                      "%s", test_report_text(&fixture.report));
        char *kept = load_file("b.h5", &(size_t){0});
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
                sph2d_snapshot_write(fixture.sim, fixture.file, round % 2 ? 6 : 0, "a.h5", NULL);
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
    tcase_add_checked_fixture(back, snapshot_set_up, snapshot_tear_down);
    tcase_add_loop_test(back, every_bit_comes_back, 0, 2);
    tcase_add_test(back, it_says_what_it_is);
    tcase_add_test(back, a_run_goes_on_from_it);
    tcase_add_loop_test(back, the_same_simulation_gives_the_same_bytes, 0, 2);
    tcase_add_test(back, structs_without_a_file_and_long_texts);
    tcase_add_test(back, hdf5_keeps_the_settings_of_the_program);
    tcase_add_loop_test(back, vtk_has_fluid_walls_and_outlines, 0, 2);
    tcase_add_test(back, vtk_of_a_scene_with_nothing);
    tcase_add_test(back, the_layout_is_what_other_programs_expect);
    tcase_add_test(back, a_draft_becomes_a_snapshot_when_it_is_told);
    suite_add_tcase(suite, back);
    snapshot_refusals(suite);
    suite_add_tcase(suite, snapshot_storage());
    TCase *unwritable = tcase_create("unwritable");
    tcase_add_checked_fixture(unwritable, snapshot_set_up, snapshot_tear_down);
    tcase_add_test(unwritable, places_that_take_no_file);
    tcase_add_loop_test(unwritable, a_full_disk_leaves_the_old_file, 0, 2);
    suite_add_tcase(suite, unwritable);
    TCase *slow = test_long(suite);
    tcase_add_checked_fixture(slow, snapshot_set_up, snapshot_tear_down);
    tcase_add_test(slow, a_killed_writer_leaves_a_whole_file_or_none);
    return suite;
}
