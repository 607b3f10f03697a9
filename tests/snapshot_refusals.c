/* SPDX-License-Identifier: MIT */
/** @file snapshot_refusals.c
 *  Files that are no snapshot, or no longer one: each is refused in a sentence, and none does harm. */
#include <hdf5.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "snapshot_fixture.h"

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

static void clock_list(hid_t f)
{
    put_attribute(f, "/State", "Time", H5T_NATIVE_DOUBLE, 3, NULL);
}

static void clock_count(hid_t f)
{
    put_attribute(f, "/Header", "Time", H5T_NATIVE_UINT64, 1, NULL);
}

static void clock_nan(hid_t f)
{
    double nan = NAN;
    put_attribute(f, "/Header", "Time", H5T_NATIVE_DOUBLE, 1, &nan);
}

static void odd_word(hid_t f)
{
    put_attribute(f, "/Parameters", "run.frames.style", H5T_C_S1, 0, "x");
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

/** One change of a sound snapshot, whichever is given, and what the reader says to it. */
static const struct refusal {
    sph2d_code code;
    const char *message;
    const char *attribute[2]; /**< group and name of one to drop */
    const char *link;         /**< path of one to drop */
    const char *count[2];     /**< group and name of one to set to `value` */
    uint64_t value;
    struct {
        const char *path;
        char type; /**< d, f or i for double, float or signed */
        int rank;
        hsize_t rows, columns, chunk;
    } dataset; /**< to put in the place of another */
    void (*change)(hid_t f);
} refusals[] = {
    {SPH2D_CODE_FILE_INCOMPLETE, "not written completely", .attribute = {"/", "Complete"}},
    {SPH2D_CODE_FILE_INCOMPLETE, "not written completely", .count = {"/", "Complete"}},
    {SPH2D_CODE_FILE_KIND, "not a snapshot of sph2d", .attribute = {"/", "Format"}},
    {SPH2D_CODE_FILE_VERSION, "the file has version 2.", .count = {"/", "FormatVersion"}, .value = 2},
    {SPH2D_CODE_FILE_VERSION, "this program reads 1.", .count = {"/State", "StateVersion"}, .value = 1000},
    {SPH2D_CODE_FILE_FIELD, "'/PartType0/Velocities' is missing", .link = "/PartType0/Velocities"},
    {SPH2D_CODE_FILE_FIELD, "'/PartType0/Masses' is missing", .link = "/PartType0/Masses"},
    {SPH2D_CODE_FILE_FIELD, "'/PartType1/Coordinates' is missing", .link = "/PartType1"},
    {SPH2D_CODE_FILE_FIELD, "'/State/StateVersion' is missing", .link = "/State"},
    {SPH2D_CODE_FILE_FIELD, "'/State/Arrays' is missing", .link = "/State/Arrays"},
    {SPH2D_CODE_FILE_FIELD, "'/State/NextTimeStep' is missing", .attribute = {"/State", "NextTimeStep"}},
    {SPH2D_CODE_FILE_FIELD, "'/Parameters/domain.min' is missing", .attribute = {"/Parameters", "domain.min"}},
    {SPH2D_CODE_FILE_FIELD, "'Densities' has 3 values", .dataset = {DENSITIES, 'd', 1, 3, 1, 0}},
    {SPH2D_CODE_FILE_FIELD, "'Densities' has the wrong shape", .dataset = {DENSITIES, 'd', 2, 200, 2, 0}},
    {SPH2D_CODE_FILE_FIELD, "'Densities' has the wrong shape", .dataset = {DENSITIES, 'd', 3, 200, 1, 0}},
    {SPH2D_CODE_FILE_FIELD, "'Densities' has the wrong type", .dataset = {DENSITIES, 'f', 1, 200, 1, 0}},
    {SPH2D_CODE_FILE_FIELD, "'ParticleIDs' has the wrong type",
     .dataset = {"/PartType0/ParticleIDs", 'i', 1, 200, 1, 0}},
    {SPH2D_CODE_FILE_FIELD, "'Densities' is damaged", .dataset = {DENSITIES, 'd', 1, (hsize_t)1 << 40, 1, 0}},
    {SPH2D_CODE_FILE_FIELD, "'Densities' is damaged", .dataset = {DENSITIES, 'd', 1, (hsize_t)1 << 40, 1, 1000}},
    {SPH2D_CODE_FILE_FIELD, "'Densities' is damaged", .dataset = {DENSITIES, 'd', 1, (hsize_t)1 << 61, 1, 1000}},
    {SPH2D_CODE_FILE_FIELD, "'Densities' has chunks that are",
     .dataset = {DENSITIES, 'd', 1, 200, 1, (hsize_t)1 << 28}},
    {SPH2D_CODE_FILE_FIELD, "'/PartType1/Coordinates' is missing", .dataset = {"/PartType1", 'd', 1, 1, 1, 0}},
    {SPH2D_CODE_FILE_FIELD, "'Time' has the wrong shape", .change = clock_list},
    {SPH2D_CODE_FILE_FIELD, "'Time' has the wrong type", .change = clock_count},
    {SPH2D_CODE_FILE_FIELD, "not finite", .change = clock_nan},
    {SPH2D_CODE_FILE_FIELD, "'run.frames.style' has a value that this program does not know", .change = odd_word},
    {SPH2D_CODE_FILE_FIELD, "'run.frames.size' is out of range", .change = no_size},
    {SPH2D_CODE_FILE_FIELD, "'Code Version' has the wrong type", .change = variable_text},
    {SPH2D_CODE_FILE_FIELD, "'Densities' cannot be read", .change = dataset_is_group},
};

static void apply(hid_t f, const struct refusal *r)
{
    if (r->attribute[0])
        drop_attribute(f, r->attribute[0], r->attribute[1]);
    if (r->link)
        drop_link(f, r->link);
    if (r->count[0])
        put_attribute(f, r->count[0], r->count[1], H5T_NATIVE_UINT64, 0, &r->value);
    if (r->dataset.path) {
        char type = r->dataset.type;
        put_dataset(f, r->dataset.path,
                    type == 'd'   ? H5T_NATIVE_DOUBLE
                    : type == 'f' ? H5T_NATIVE_FLOAT
                                  : H5T_NATIVE_INT64,
                    r->dataset.rank, r->dataset.rows, r->dataset.columns, r->dataset.chunk);
    }
    if (r->change)
        r->change(f);
}

START_TEST(changed_files_are_refused)
{
    write_snapshot("a.h5", 0);
    hid_t f = open_for_change("a.h5");
    apply(f, &refusals[_i]);
    close_and_seal(f, "a.h5");
    expect_refusal("a.h5", SPH2D_FORMAT, refusals[_i].code, refusals[_i].message);
}
END_TEST

/* It has no checksum, unless its maker gives it one, and is then read if that is asked for. */
START_TEST(a_change_on_purpose_is_read)
{
    write_snapshot("a.h5", 0);
    hid_t f = open_for_change("a.h5");
    other_value(f);
    H5Fclose(f);
    expect_refusal("a.h5", SPH2D_FORMAT, SPH2D_CODE_FILE_INCOMPLETE, "the checksum at the end of the file is missing");
    ck_assert_ptr_nonnull(strstr(fixture.report.items[0].hint, "--no-checksum"));
    sph2d_snapshot *snapshot = NULL;
    if (_i)
        ck_assert_int_eq(sph2d_snapshot_read_unchecked("a.h5", &snapshot, NULL), SPH2D_OK);
    else
        close_and_seal(open_for_change("a.h5"), "a.h5");
    snapshot = _i ? snapshot : read_snapshot("a.h5");
    const sph2d_array *densities = sph2d_snapshot_array(snapshot, SPH2D_GROUP_FLUID, "Densities");
    ck_assert(((const double *)densities->data[0])[5] == 1234);
    sph2d_snapshot_destroy(snapshot);
}
END_TEST

START_TEST(what_is_no_snapshot_is_refused)
{
    expect_refusal("missing.h5", SPH2D_NOINPUT, SPH2D_CODE_FILE_OPEN, "'missing.h5': No such file");
    expect_refusal(fixture.folder, SPH2D_NOINPUT, SPH2D_CODE_FILE_OPEN, "Is a directory");
    expect_refusal("/dev/null", SPH2D_FORMAT, SPH2D_CODE_FILE_KIND, "a device or pipe");
    store_file("a.h5", "", 0);
    expect_refusal("a.h5", SPH2D_FORMAT, SPH2D_CODE_FILE_KIND, "not an HDF5 file: it is empty");
    store_file("a.h5", fixture.text, strlen(fixture.text));
    expect_refusal("a.h5", SPH2D_FORMAT, SPH2D_CODE_FILE_KIND, "not an HDF5 file");
    store_file("a.h5", "\x89HDF\r\n\x1a\n", 8);
    expect_refusal("a.h5", SPH2D_FORMAT, SPH2D_CODE_FILE_INCOMPLETE, "checksum at the end of the file is missing");
    H5Fclose(H5Fcreate("a.h5", H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
    expect_refusal("a.h5", SPH2D_FORMAT, SPH2D_CODE_FILE_INCOMPLETE, "or it is no snapshot of sph2d");
    close_and_seal(open_for_change("a.h5"), "a.h5");
    expect_refusal("a.h5", SPH2D_FORMAT, SPH2D_CODE_FILE_KIND, "not a snapshot of sph2d");
    ck_assert_int_eq(mkfifo("pipe", 0644), 0);
    expect_refusal("pipe", SPH2D_FORMAT, SPH2D_CODE_FILE_KIND, "a device or pipe");
}
END_TEST

START_TEST(cut_files_are_refused)
{
    write_snapshot("a.h5", 0);
    size_t size;
    void *bytes = load_file("a.h5", &size);
    for (size_t i = 0; i < 400; ++i) {
        store_file("b.h5", bytes, i < 100 ? i : size * i / 400);
        sph2d_snapshot *snapshot = NULL;
        ck_assert_int_eq(sph2d_snapshot_read("b.h5", &snapshot, NULL), SPH2D_FORMAT);
        ck_assert_int_eq(sph2d_snapshot_read_unchecked("b.h5", &snapshot, NULL), SPH2D_FORMAT);
        ck_assert_ptr_null(snapshot);
    }
    free(bytes);
}
END_TEST

START_TEST(a_single_bit_is_noticed)
{
    write_snapshot("a.h5", 0);
    size_t size;
    unsigned char *bytes = load_file("a.h5", &size);
    for (size_t i = 0; i < 200; ++i) {
        size_t at = (size - 16) * i / 200; /* the trailer has 16 bytes */
        bytes[at] ^= (unsigned char)(1u << i % 8);
        store_file("b.h5", bytes, size);
        bytes[at] ^= (unsigned char)(1u << i % 8);
        if (at >= 8) /* before that, it is not even HDF5 */
            expect_refusal("b.h5", SPH2D_FORMAT, SPH2D_CODE_FILE_INCOMPLETE, "its checksum does not match");
    }
    free(bytes);
}
END_TEST

/* Eight letters, then XXH64 of all before them, which other programs can compute, lowest byte first. */
START_TEST(the_trailer_is_a_standard_checksum)
{
    write_snapshot("a.h5", 0);
    ck_assert_uint_eq(XXH64("", 0, 0), UINT64_C(0xef46db3751d8e999)); /* as its specification says */
    size_t size;
    unsigned char *bytes = load_file("a.h5", &size);
    uint64_t sum = 0;
    for (size_t i = 0; i < 8; ++i)
        sum |= (uint64_t)bytes[size - 8 + i] << 8 * i;
    ck_assert_int_eq(memcmp(bytes + size - 16, "SPH2Dxxh", 8), 0);
    ck_assert_uint_eq(sum, XXH64(bytes, size - 16, 0));
    free(bytes);
}
END_TEST

/** Reads b.h5 and makes a simulation of it if that is possible. Whether everything went as it should. */
static bool survives(void)
{
    sph2d_report_clear(&fixture.report);
    sph2d_snapshot *snapshot = NULL;
    sph2d_status status = sph2d_snapshot_read_unchecked("b.h5", &snapshot, &fixture.report);
    if (status == SPH2D_OK) {
        sph2d_state state = sph2d_snapshot_state(snapshot);
        sph2d_sim *restored = NULL;
        sph2d_sim_restore(sph2d_scene_file_scene(fixture.file), NULL, &state, &restored, NULL);
        sph2d_sim_destroy(restored);
    }
    sph2d_snapshot_destroy(snapshot);
    return (status == SPH2D_OK || (status == SPH2D_FORMAT && fixture.report.errors > 0)) &&
           H5Fget_obj_count((hid_t)H5F_OBJ_ALL, H5F_OBJ_ALL) == 0;
}

/* Plain and compressed files; without their trailer HDF5 1.10 itself reads a few bytes past the buffer of a damaged
 * compressed chunk, which AddressSanitizer sees in it. */
#ifdef __SANITIZE_ADDRESS__
enum { DAMAGED_KINDS = 1 };
#else
enum { DAMAGED_KINDS = 2 };
#endif

/** Removes the trailer and turns bits and bytes at random. HDF5 must not crash over them, nor the reader, nor a
 *  simulation made of the result. In a process of its own: HDF5 loses memory over damaged files, and would say so. */
START_TEST(damaged_files_do_no_harm)
{
    write_snapshot("a.h5", _i ? 6 : 0);
    size_t size;
    unsigned char *bytes = load_file("a.h5", &size), *damaged = malloc(size);
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
        store_file("b.h5", damaged, size);
        test_limit(30); /* a hang is a failure, too */
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

void snapshot_refusals(Suite *suite)
{
    TCase *refused = tcase_create("refused");
    tcase_add_checked_fixture(refused, snapshot_set_up, snapshot_tear_down);
    tcase_add_loop_test(refused, changed_files_are_refused, 0, sizeof refusals / sizeof refusals[0]);
    tcase_add_loop_test(refused, a_change_on_purpose_is_read, 0, 2);
    tcase_add_test(refused, what_is_no_snapshot_is_refused);
    tcase_add_test(refused, cut_files_are_refused);
    tcase_add_test(refused, a_single_bit_is_noticed);
    tcase_add_test(refused, the_trailer_is_a_standard_checksum);
    suite_add_tcase(suite, refused);
    TCase *slow = test_long(suite);
    tcase_add_checked_fixture(slow, snapshot_set_up, snapshot_tear_down);
    tcase_add_loop_test(slow, damaged_files_do_no_harm, 0, DAMAGED_KINDS);
}
