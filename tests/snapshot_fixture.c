/* SPDX-License-Identifier: MIT */
/** @file snapshot_fixture.c
 *  A small simulation with something of everything, and files. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "snapshot_fixture.h"

static const char scene_text[] = "name: small\n"
                                 "domain: {min: [0, 0], max: [1, 1]}\n"
                                 "spacing: 0.04\n"
                                 "fluid: {dynamic_viscosity: 100}\n"
                                 "blocks:\n  - box: {min: [0, 0], max: [0.4, 0.8]}\n"
                                 "sources:\n  - {at: [0.7, 0.9], speed: 1, width: 0.1, spread: 0.1}\n"
                                 "obstacles:\n  - line: [[0.6, 0.1], [0.9, 0.1]]\n"
                                 "probes: [{name: e, kind: energy, every: 0.1}]\n"
                                 "run: {until: 2, frames: {per_second: 30, style: points, color: speed}}\n";

snapshot_fixture fixture;

void snapshot_set_up(void)
{
    fixture.text = scene_text;
    snprintf(fixture.folder, sizeof fixture.folder, "/tmp/sph2d-snapshot-XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(fixture.folder));
    ck_assert_int_eq(chdir(fixture.folder), 0);
    static const sph2d_override override = {"run.until", "1"};
    sph2d_status status = sph2d_scene_file_parse(fixture.text, strlen(fixture.text), "s.yaml", &override, 1,
                                                 &fixture.file, &fixture.report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&fixture.report));
    fixture.sim = test_create(sph2d_scene_file_scene(fixture.file), NULL);
    test_steps(fixture.sim, 60);
    sph2d_report_clear(&fixture.report);
}

void snapshot_tear_down(void)
{
    sph2d_sim_destroy(fixture.sim);
    sph2d_scene_file_destroy(fixture.file);
    ck_assert_int_eq(chdir("/"), 0);
    char command[64];
    snprintf(command, sizeof command, "rm -rf %s", fixture.folder);
    ck_assert_int_eq(system(command), 0);
    ck_assert_int_eq(H5Fget_obj_count((hid_t)H5F_OBJ_ALL, H5F_OBJ_ALL), 0);
}

void write_snapshot(const char *path, unsigned compress)
{
    sph2d_status status = sph2d_snapshot_write(fixture.sim, fixture.file, compress, path, &fixture.report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&fixture.report));
}

sph2d_snapshot *read_snapshot(const char *path)
{
    sph2d_snapshot *snapshot = NULL;
    sph2d_status status = sph2d_snapshot_read(path, &snapshot, &fixture.report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&fixture.report));
    ck_assert_ptr_nonnull(snapshot);
    return snapshot;
}

void *load_file(const char *path, size_t *size)
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

void store_file(const char *path, const void *bytes, size_t size)
{
    FILE *stream = fopen(path, "wb");
    ck_assert_ptr_nonnull(stream);
    ck_assert_uint_eq(fwrite(bytes, 1, size, stream), size);
    ck_assert_int_eq(fclose(stream), 0);
}

hid_t open_for_change(const char *path)
{
    hid_t file = H5Fopen(path, H5F_ACC_RDWR, H5P_DEFAULT);
    ck_assert_int_ge(file, 0);
    return file;
}

void close_and_seal(hid_t file, const char *path)
{
    static const char mark[8] = "SPH2Dxxh";
    ck_assert_int_ge(H5Fclose(file), 0);
    size_t size;
    unsigned char *bytes = load_file(path, &size), *sealed = calloc(1, size + 16);
    memcpy(sealed, bytes, size);
    memcpy(sealed + size, mark, sizeof mark);
    uint64_t sum = XXH64(bytes, size, 0);
    for (size_t i = 0; i < 8; ++i)
        sealed[size + 8 + i] = (unsigned char)(sum >> 8 * i);
    store_file(path, sealed, size + 16);
    free(sealed);
    free(bytes);
}

void expect_refusal(const char *path, sph2d_status status, sph2d_code code, const char *message)
{
    sph2d_report_clear(&fixture.report);
    sph2d_snapshot *snapshot = NULL;
    ck_assert_int_eq(sph2d_snapshot_read(path, &snapshot, &fixture.report), status);
    ck_assert_ptr_null(snapshot);
    const char *all = test_report_text(&fixture.report);
    ck_assert_uint_gt(fixture.report.errors, 0);
    ck_assert_msg(fixture.report.items[0].code == code && strstr(fixture.report.items[0].message, message) != NULL,
                  "%s", all);
    ck_assert_msg(status != SPH2D_FORMAT || strcmp(fixture.report.items[0].file, path) == 0, "%s", all);
}
