/* SPDX-License-Identifier: MIT */
/** @file scene_file_on_disk.c
 *  Scene files that are missing, unreadable, endless or garbage: refused in a sentence, and soon. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "common.h"
#include "sph2d/io.h"

/** A scene without a warning. */
static const char sound[] = "domain: {min: [0, 0], max: [1, 1]}\n"
                            "spacing: 0.1\n"
                            "fluid: {dynamic_viscosity: 100}\n"
                            "blocks: [{box: {min: [0, 0], max: [0.4, 0.8]}}]\n";

static char folder[] = "/tmp/sph2d-scene-XXXXXX";

static void make_folder(void)
{
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
    ck_assert_int_eq(chmod(folder, 0755), 0);
}

static void remove_folder(void)
{
    remove("x.yaml");
    ck_assert_int_eq(chdir("/"), 0);
    rmdir(folder);
}

/** Writes x.yaml: `text` over and over, up to `length` bytes. */
static void write_file(const char *text, size_t length)
{
    FILE *stream = fopen("x.yaml", "w");
    ck_assert_ptr_nonnull(stream);
    size_t period = strlen(text);
    char block[8192];
    size_t whole_periods = sizeof block / period * period;
    for (size_t i = 0; i < whole_periods; ++i)
        block[i] = text[i % period];
    for (size_t done = 0; done < length;) {
        size_t part = length - done < whole_periods ? length - done : whole_periods;
        ck_assert_uint_eq(fwrite(block, 1, part, stream), part);
        done += part;
    }
    ck_assert_int_eq(fclose(stream), 0);
}

static void expect_refusal(const char *path, sph2d_status status, sph2d_code code, const char *message)
{
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    ck_assert_int_eq(sph2d_scene_file_read(path, NULL, 0, &file, &report), status);
    ck_assert_ptr_null(file);
    ck_assert_uint_eq(report.errors, 1);
    ck_assert_msg(report.items[0].code == code, "%s", test_report_text(&report));
    ck_assert_msg(strstr(report.items[0].message, message) != NULL, "%s", test_report_text(&report));
}

START_TEST(a_file_is_read)
{
    write_file(sound, strlen(sound));
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    ck_assert_int_eq(sph2d_scene_file_read("x.yaml", NULL, 0, &file, &report), SPH2D_OK);
    ck_assert_str_eq(sph2d_scene_file_text(file), sound);
    sph2d_scene_file_destroy(file);
}
END_TEST

START_TEST(files_that_cannot_be_read)
{
    expect_refusal("missing.yaml", SPH2D_NOINPUT, SPH2D_CODE_FILE_OPEN, "'missing.yaml': No such file");
    expect_refusal(folder, SPH2D_NOINPUT, SPH2D_CODE_FILE_OPEN, "Is a directory");
    expect_refusal("/dev/null", SPH2D_SCENE, SPH2D_CODE_SYNTAX, "it is empty");
    expect_refusal("/dev/zero", SPH2D_SCENE, SPH2D_CODE_FILE_KIND, "too long");
    write_file(sound, strlen(sound));
    ck_assert_int_eq(chmod("x.yaml", 0), 0);
    if (geteuid() == 0) /* root may read anything; nobody may not */
        ck_assert_int_eq(seteuid(65534), 0);
    expect_refusal("x.yaml", SPH2D_NOINPUT, SPH2D_CODE_FILE_OPEN, "Permission denied");
    if (getuid() == 0)
        ck_assert_int_eq(seteuid(0), 0);
}
END_TEST

/** Text by the megabyte that is no scene. */
static const struct {
    const char *text;
    sph2d_code code;
    const char *message;
} garbage[] = {
    {"\x01\xfe\x80", SPH2D_CODE_SYNTAX, "this is not text"},
    {"[", SPH2D_CODE_SYNTAX, "more than a million values"},
    {"{\"a\":", SPH2D_CODE_SYNTAX, "more than a million values"},
    {"- ", SPH2D_CODE_SYNTAX, "nested too deeply"},
    {"- a\n", SPH2D_CODE_SYNTAX, "more than a million values"},
    {"&", SPH2D_CODE_SYNTAX, "more than a million values"},
    {"lorem ipsum ", SPH2D_CODE_SYNTAX, "expected the keys of a scene"},
    {"#\n", SPH2D_CODE_SYNTAX, "it is empty"},
};

START_TEST(garbage_is_refused_soon)
{
    write_file(garbage[_i].text, 12 << 20);
    expect_refusal("x.yaml", SPH2D_SCENE, garbage[_i].code, garbage[_i].message);
}
END_TEST

START_TEST(files_beyond_the_limit_are_not_read)
{
    write_file(sound, strlen(sound));
    ck_assert_int_eq(truncate("x.yaml", 100000000), 0);
    expect_refusal("x.yaml", SPH2D_SCENE, SPH2D_CODE_FILE_KIND, "too long");
}
END_TEST

TCase *scene_file_on_disk(void)
{
    TCase *files = tcase_create("files");
    tcase_add_checked_fixture(files, make_folder, remove_folder);
    tcase_add_test(files, a_file_is_read);
    tcase_add_test(files, files_that_cannot_be_read);
    tcase_add_loop_test(files, garbage_is_refused_soon, 0, sizeof garbage / sizeof garbage[0]);
    tcase_add_test(files, files_beyond_the_limit_are_not_read);
    return files;
}
