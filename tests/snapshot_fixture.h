/* SPDX-License-Identifier: MIT */
/** @file snapshot_fixture.h
 *  What the tests of snapshots share: a folder to work in, a simulation that has taken some steps, and files. */
#ifndef SPH2D_TESTS_SNAPSHOT_FIXTURE_H
#define SPH2D_TESTS_SNAPSHOT_FIXTURE_H

#include <hdf5.h>

#include "common.h"
#include "sph2d/io.h"

/** Made anew for every test, which runs in `folder`. */
typedef struct snapshot_fixture {
    char folder[32];
    const char *text; /**< of the scene */
    sph2d_scene_file *file;
    sph2d_sim *sim;
    sph2d_report report;
} snapshot_fixture;

extern snapshot_fixture fixture;

void snapshot_set_up(void);
void snapshot_tear_down(void);

/** Writes and reads what must not fail. */
void write_snapshot(const char *path, unsigned compress);
sph2d_snapshot *read_snapshot(const char *path);
/** Expects that a file is refused in these words, with the file's name where it is FORMAT. */
void expect_refusal(const char *path, sph2d_status status, sph2d_code code, const char *message);

/** A whole file, to be freed; and back. */
void *load_file(const char *path, size_t *size);
void store_file(const char *path, const void *bytes, size_t size);

/** Opens a snapshot for changes by HDF5. The other closes it and gives it a checksum, as anyone can. */
hid_t open_for_change(const char *path);
void close_and_seal(hid_t file, const char *path);

/** The tests of files that are refused, and of those refused for how or where they keep their data. */
void snapshot_refusals(Suite *suite);
TCase *snapshot_storage(void);

#endif
