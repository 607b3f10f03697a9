/* SPDX-License-Identifier: MIT */
/** @file snapshot_storage.c
 *  Snapshots with a checksum whose data are elsewhere, or stored in ways that HDF5 allows and the reader does not: each
 *  is refused before anything is read from it. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "snapshot_fixture.h"

#define DENSITIES "/PartType0/Densities"
enum { ROWS = 2000 };

/* ---- links ------------------------------------------------------------------------------------------------------- */

static void soft_link(hid_t f)
{
    H5Ldelete(f, DENSITIES, H5P_DEFAULT);
    ck_assert_int_ge(H5Lcreate_soft("/PartType0/Pressures", f, DENSITIES, H5P_DEFAULT, H5P_DEFAULT), 0);
}

/** To a pipe, which nobody writes: opening it would take for ever. */
static void external_link(hid_t f)
{
    ck_assert_int_eq(mkfifo("pipe", 0644), 0);
    H5Ldelete(f, "/PartType1", H5P_DEFAULT);
    ck_assert_int_ge(H5Lcreate_external("pipe", "/PartType1", f, "/PartType1", H5P_DEFAULT, H5P_DEFAULT), 0);
}

static void external_dataset(hid_t f)
{
    ck_assert_int_eq(mkfifo("pipe", 0644), 0);
    H5Ldelete(f, "/Scene/Text", H5P_DEFAULT);
    ck_assert_int_ge(H5Lcreate_external("pipe", "/Scene/Text", f, "/Scene/Text", H5P_DEFAULT, H5P_DEFAULT), 0);
}

static hid_t lead_nowhere(const char *name, hid_t group, const void *data, size_t size, hid_t access, hid_t transfer)
{
    (void)transfer;
    (void)name;
    (void)group;
    (void)data;
    (void)size;
    (void)access;
    return H5I_INVALID_HID;
}

static void link_of_its_own(hid_t f)
{
    const H5L_class_t kind = {.version = H5L_LINK_CLASS_T_VERS, .id = (H5L_type_t)200, .trav_func = lead_nowhere};
    ck_assert_int_ge(H5Lregister(&kind), 0);
    H5Ldelete(f, DENSITIES, H5P_DEFAULT);
    ck_assert_int_ge(H5Lcreate_ud(f, DENSITIES, (H5L_type_t)200, "data", 4, H5P_DEFAULT, H5P_DEFAULT), 0);
    ck_assert_int_ge(H5Lunregister((H5L_type_t)200), 0);
}

/** A group that has itself as a member has an end all the same. */
static void group_in_itself(hid_t f)
{
    ck_assert_int_ge(H5Lcreate_hard(f, "/PartType0", f, "/PartType0/Again", H5P_DEFAULT, H5P_DEFAULT), 0);
    H5Ldelete(f, DENSITIES, H5P_DEFAULT);
}

/* ---- datasets ---------------------------------------------------------------------------------------------------- */

/** Puts a dataset of ones in the place of the densities; rows of `chunk` values, 0 for contiguous. */
static void replace(hid_t f, hid_t type, hsize_t rows, hsize_t chunk, hid_t properties, bool write)
{
    H5Ldelete(f, DENSITIES, H5P_DEFAULT);
    hid_t space = H5Screate_simple(1, &rows, NULL);
    if (chunk > 0)
        ck_assert_int_ge(H5Pset_chunk(properties, 1, &chunk), 0);
    hid_t d = H5Dcreate2(f, DENSITIES, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    ck_assert_int_ge(d, 0);
    double *ones = write ? calloc(rows, sizeof *ones) : NULL;
    if (write)
        ck_assert_int_ge(H5Dwrite(d, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, ones), 0);
    free(ones);
    H5Dclose(d);
    H5Sclose(space);
    H5Pclose(properties);
}

static hid_t creation(void)
{
    return H5Pcreate(H5P_DATASET_CREATE);
}

static void external_storage(hid_t f)
{
    hid_t properties = creation();
    ck_assert_int_ge(H5Pset_external(properties, "/etc/passwd", 0, ROWS * sizeof(double)), 0);
    replace(f, H5T_NATIVE_DOUBLE, ROWS, 0, properties, false);
}

/** Its size depends on files that match a pattern, which HDF5 opens when it is asked for the size. */
static void virtual_dataset(hid_t f)
{
    ck_assert_int_eq(mkfifo("0.h5", 0644), 0);
    hsize_t none = 0, unlimited = H5S_UNLIMITED, start = 0, stride = 1, one = 1;
    hid_t space = H5Screate_simple(1, &none, &unlimited), source = H5Screate_simple(1, &one, NULL);
    H5Sselect_hyperslab(space, H5S_SELECT_SET, &start, &stride, &unlimited, &one);
    hid_t properties = creation();
    ck_assert_int_ge(H5Pset_virtual(properties, space, "%b.h5", "/a", source), 0);
    H5Ldelete(f, DENSITIES, H5P_DEFAULT);
    hid_t d = H5Dcreate2(f, DENSITIES, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    ck_assert_int_ge(d, 0);
    H5Dclose(d);
    H5Sclose(space);
    H5Sclose(source);
    H5Pclose(properties);
}

static void checksum_filter(hid_t f)
{
    hid_t properties = creation();
    H5Pset_fletcher32(properties);
    replace(f, H5T_NATIVE_DOUBLE, ROWS, 50, properties, true);
}

static void deflate_twice(hid_t f)
{
    hid_t properties = creation();
    H5Pset_deflate(properties, 6);
    H5Pset_deflate(properties, 6);
    replace(f, H5T_NATIVE_DOUBLE, ROWS, 50, properties, true);
}

static void shuffle_after_deflate(hid_t f)
{
    hid_t properties = creation();
    H5Pset_deflate(properties, 6);
    H5Pset_shuffle(properties);
    replace(f, H5T_NATIVE_DOUBLE, ROWS, 50, properties, true);
}

static void large_chunks(hid_t f)
{
    hid_t properties = creation();
    H5Pset_deflate(properties, 6);
    replace(f, H5T_NATIVE_DOUBLE, 1 << 18, 1 << 18, properties, true);
}

/** Chunks that are not there are zeros for HDF5, as many as are wanted. */
static void missing_chunks(hid_t f)
{
    replace(f, H5T_NATIVE_DOUBLE, 1000000, 100, creation(), false);
}

static void small_chunks(hid_t f)
{
    replace(f, H5T_NATIVE_DOUBLE, (hsize_t)1 << 40, 1, creation(), false);
}

static void put_chunk(hid_t f, unsigned skipped, size_t bytes)
{
    hid_t properties = creation();
    H5Pset_deflate(properties, 6);
    replace(f, H5T_NATIVE_DOUBLE, ROWS, ROWS, properties, false);
    hid_t d = H5Dopen2(f, DENSITIES, H5P_DEFAULT);
    hsize_t offset = 0;
    char *zeros = calloc(bytes, 1);
    ck_assert_int_ge(H5Dwrite_chunk(d, H5P_DEFAULT, skipped, &offset, bytes, zeros), 0);
    free(zeros);
    H5Dclose(d);
}

/** HDF5 would read behind it. */
static void short_plain_chunk(hid_t f)
{
    put_chunk(f, 1, ROWS);
}

static void chunk_of_one_byte(hid_t f)
{
    put_chunk(f, 0, 1);
}

static void long_chunk(hid_t f)
{
    put_chunk(f, 0, 16 * ROWS);
}

/** A type that HDF5 can read, by rules of the file. */
static void odd_type(hid_t f)
{
    hid_t type = H5Tcopy(H5T_IEEE_F64LE);
    H5Tset_fields(type, 63, 50, 13, 0, 50);
    replace(f, type, ROWS, 0, creation(), true);
    H5Tclose(type);
}

/** One dataset by many names, each of which is read: 15 times what the file has. */
static void many_names(hid_t f)
{
    static const char *const names[] = {"Velocities", "Accelerations", "Coordinates"};
    hid_t space = H5Screate_simple(2, (hsize_t[]){20000, 3}, NULL);
    hid_t d = H5Dcreate2(f, "/Large", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    double *zeros = calloc(60000, sizeof *zeros);
    ck_assert_int_ge(H5Dwrite(d, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, zeros), 0);
    free(zeros);
    H5Dclose(d);
    H5Sclose(space);
    char path[64];
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        snprintf(path, sizeof path, "/PartType0/%s", names[i]);
        H5Ldelete(f, path, H5P_DEFAULT);
        ck_assert_int_ge(H5Lcreate_hard(f, "/Large", f, path, H5P_DEFAULT, H5P_DEFAULT), 0);
    }
}

static const struct {
    const char *message, *hint;
    void (*change)(hid_t f);
} changes[] = {
    {"'Densities' is a soft link", "hard links only", soft_link},
    {"'/PartType1' is an external link", "hard links only", external_link},
    {"'Text' is an external link", "hard links only", external_dataset},
    {"'Densities' is a link of a kind of its own", "hard links only", link_of_its_own},
    {"'/PartType0/Densities' is missing", "", group_in_itself},
    {"'Densities' has its values in other files", "put the values themselves", external_storage},
    {"'Densities' is a virtual dataset", "put the values themselves", virtual_dataset},
    {"'Densities' has filters that are not accepted", "with deflate", checksum_filter},
    {"'Densities' has filters that are not accepted", "with deflate", deflate_twice},
    {"'Densities' has filters that are not accepted", "with deflate", shuffle_after_deflate},
    {"'Densities' has chunks that are too large", "at most 1024 KiB", large_chunks},
    {"'Densities' is damaged: it is larger than the file", "", missing_chunks},
    {"'Densities' is damaged: it is larger than the file", "", small_chunks},
    {"'Densities' is damaged", "", short_plain_chunk},
    {"'Densities' is damaged", "", chunk_of_one_byte},
    {"'Densities' is damaged", "", long_chunk},
    {"'Densities' has the wrong type", "", odd_type},
    {"is damaged: it is larger than the file", "", many_names},
};

START_TEST(data_from_elsewhere_are_refused)
{
    write_snapshot("a.h5", 0);
    hid_t f = open_for_change("a.h5");
    changes[_i].change(f);
    close_and_seal(f, "a.h5");
    test_limit(20);
    expect_refusal("a.h5", SPH2D_FORMAT, SPH2D_CODE_FILE_FIELD, changes[_i].message);
    test_limit(0);
    ck_assert_msg(strstr(fixture.report.items[0].hint, changes[_i].hint) != NULL, "%s",
                  test_report_text(&fixture.report));
}
END_TEST

/** A link that the reader has no use for leads nowhere. */
START_TEST(other_links_are_not_followed)
{
    write_snapshot("a.h5", 0);
    hid_t f = open_for_change("a.h5");
    ck_assert_int_eq(mkfifo("pipe", 0644), 0);
    ck_assert_int_ge(H5Lcreate_external("pipe", "/a", f, "/VTKHDF/Other", H5P_DEFAULT, H5P_DEFAULT), 0);
    close_and_seal(f, "a.h5");
    test_limit(20);
    sph2d_snapshot_destroy(read_snapshot("a.h5"));
    test_limit(0);
}
END_TEST

/** What h5py, h5repack or this program may store: chunks without a filter, with deflate, and with shuffle before it. */
START_TEST(usual_storage_is_read)
{
    write_snapshot("a.h5", 0);
    size_t count = sph2d_sim_fluid(fixture.sim).count;
    hid_t f = open_for_change("a.h5"), properties = creation();
    if (_i == 2)
        H5Pset_shuffle(properties);
    if (_i > 0)
        H5Pset_deflate(properties, 9);
    replace(f, H5T_NATIVE_DOUBLE, count, 100, properties, true);
    close_and_seal(f, "a.h5");
    sph2d_snapshot_destroy(read_snapshot("a.h5"));
}
END_TEST

TCase *snapshot_storage(void)
{
    TCase *storage = tcase_create("storage");
    tcase_add_checked_fixture(storage, snapshot_set_up, snapshot_tear_down);
    tcase_add_loop_test(storage, data_from_elsewhere_are_refused, 0, sizeof changes / sizeof changes[0]);
    tcase_add_test(storage, other_links_are_not_followed);
    tcase_add_loop_test(storage, usual_storage_is_read, 0, 3);
    return storage;
}
