/* SPDX-License-Identifier: MIT */
/** @file test_series.c
 *  Time series, which grow row by row, and files that appear whole or not at all. */
#include <fcntl.h>
#include <locale.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/atomic_file.h"
#include "common.h"
#include "sph2d/io.h"

static char folder[] = "/tmp/sph2d-series-XXXXXX";
static sph2d_report report;

static void set_up(void)
{
    ck_assert_ptr_nonnull(mkdtemp(folder));
    ck_assert_int_eq(chdir(folder), 0);
    ck_assert_int_eq(chmod(folder, 0755), 0);
    sph2d_report_clear(&report);
}

static void tear_down(void)
{
    ck_assert_int_eq(chdir("/"), 0);
    char command[64];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    ck_assert_int_eq(system(command), 0);
}

static void store(const char *path, const char *text)
{
    FILE *stream = fopen(path, "w");
    ck_assert_ptr_nonnull(stream);
    ck_assert_int_ge(fputs(text, stream), 0);
    ck_assert_int_eq(fclose(stream), 0);
}

/** What is in a file. Static storage. */
static const char *text_of(const char *path)
{
    static char text[4096];
    FILE *stream = fopen(path, "r");
    ck_assert_ptr_nonnull(stream);
    text[fread(text, 1, sizeof text - 1, stream)] = '\0';
    fclose(stream);
    return text;
}

static sph2d_series *open_series(uint64_t keep)
{
    sph2d_series *series = NULL;
    sph2d_status status = sph2d_series_open("a.csv", "u [m/s],v [m/s]", keep, &series, &report);
    ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
    return series;
}

static void append(sph2d_series *series, double time, double u, double v)
{
    double values[2] = {u, v};
    ck_assert_int_eq(sph2d_series_append(series, time, values, 2, &report), SPH2D_OK);
}

#define HEADER "time [s],u [m/s],v [m/s]\n"

START_TEST(rows_have_every_digit_and_stand_at_once)
{
    sph2d_series *series = open_series(0);
    ck_assert_str_eq(text_of("a.csv"), HEADER);
    append(series, 0, 0.1, -1e-300);
    ck_assert_str_eq(text_of("a.csv"), HEADER "0,0.10000000000000001,-1e-300\n");
    append(series, 0.5, -NAN, 1.0 / 3);
    ck_assert_str_eq(text_of("a.csv"), HEADER "0,0.10000000000000001,-1e-300\n"
                                              "0.5,nan,0.33333333333333331\n");
    ck_assert(strtod(strrchr(text_of("a.csv"), ',') + 1, NULL) == 1.0 / 3);
    ck_assert_int_eq(sph2d_series_append(series, 1, NULL, 0, &report), SPH2D_OK);
    ck_assert_int_eq(sph2d_series_close(series, &report), SPH2D_OK);
    ck_assert_int_eq(sph2d_series_close(NULL, &report), SPH2D_OK);
}
END_TEST

START_TEST(points_stay_points_in_every_locale)
{
    setlocale(LC_NUMERIC, "de_DE.UTF-8"); /* nothing happens where it is not installed */
    sph2d_series *series = open_series(0);
    append(series, 0.5, 1.5, 2.5);
    ck_assert_str_eq(text_of("a.csv"), HEADER "0.5,1.5,2.5\n");
    sph2d_series_close(series, NULL);
}
END_TEST

START_TEST(a_resumed_series_is_cut_and_goes_on)
{
    store("a.csv", HEADER "0,1,2\n1,1,2\n2,1,2\n3,1"); /* the last row was being written */
    sph2d_series *series = open_series(2);
    ck_assert_str_eq(text_of("a.csv"), HEADER "0,1,2\n1,1,2\n");
    append(series, 2, 5, 6);
    ck_assert_str_eq(text_of("a.csv"), HEADER "0,1,2\n1,1,2\n2,5,6\n");
    sph2d_series_close(series, NULL);
    series = open_series(3); /* all of it */
    ck_assert_str_eq(text_of("a.csv"), HEADER "0,1,2\n1,1,2\n2,5,6\n");
    sph2d_series_close(series, NULL);
    series = open_series(0); /* from the start */
    ck_assert_str_eq(text_of("a.csv"), HEADER);
    sph2d_series_close(series, NULL);
}
END_TEST

static const struct {
    const char *text; /**< NULL: no file */
    sph2d_status status;
    sph2d_code code;
    const char *message;
} unsound[] = {
    {NULL, SPH2D_CANTCREAT, SPH2D_CODE_FILE_WRITE, "cannot open 'a.csv': No such file"},
    {"", SPH2D_FORMAT, SPH2D_CODE_FILE_FIELD, "the header differs"},
    {"time [s],p [Pa]\n0,1\n1,1\n", SPH2D_FORMAT, SPH2D_CODE_FILE_FIELD, "the header differs"},
    {HEADER "0,1,2\n", SPH2D_FORMAT, SPH2D_CODE_FILE_FIELD, "fewer rows"},
    {HEADER "0,1,2\n1,1", SPH2D_FORMAT, SPH2D_CODE_FILE_FIELD, "fewer rows"},
};

START_TEST(a_series_that_cannot_go_on_stays_as_it_is)
{
    if (unsound[_i].text)
        store("a.csv", unsound[_i].text);
    sph2d_series *series = NULL;
    ck_assert_int_eq(sph2d_series_open("a.csv", "u [m/s],v [m/s]", 2, &series, &report), unsound[_i].status);
    ck_assert_ptr_null(series);
    ck_assert_uint_eq(report.errors, 1);
    ck_assert_int_eq(report.items[0].code, unsound[_i].code);
    ck_assert_msg(strstr(report.items[0].message, unsound[_i].message) != NULL, "%s", test_report_text(&report));
    if (unsound[_i].text)
        ck_assert_str_eq(text_of("a.csv"), unsound[_i].text);
}
END_TEST

START_TEST(series_that_cannot_be_written)
{
    sph2d_series *series = NULL;
    ck_assert_int_eq(sph2d_series_open("missing/a.csv", "x", 0, &series, &report), SPH2D_CANTCREAT);
    ck_assert_int_eq(sph2d_series_open(folder, "x", 0, &series, &report), SPH2D_CANTCREAT);
    ck_assert_int_eq(sph2d_series_open("/dev/full", "x", 0, &series, &report), SPH2D_IO);
    ck_assert_uint_eq(report.errors, 3);
    ck_assert_msg(strstr(report.items[2].message, "No space left") != NULL, "%s", test_report_text(&report));
    ck_assert_int_eq(sph2d_series_open(NULL, "x", 0, &series, NULL), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_series_open("a.csv", "x", 0, NULL, NULL), SPH2D_INVALID);
    ck_assert_int_eq(sph2d_series_append(NULL, 0, NULL, 0, NULL), SPH2D_INVALID);
}
END_TEST

START_TEST(a_row_without_room_is_no_half_row)
{
    sph2d_series *series = open_series(0);
    append(series, 0, 1, 2);
    struct rlimit limit = {sizeof HEADER - 1 + 10, RLIM_INFINITY}, none = {RLIM_INFINITY, RLIM_INFINITY};
    signal(SIGXFSZ, SIG_IGN);
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &limit), 0);
    double values[2] = {1, 2};
    ck_assert_int_eq(sph2d_series_append(series, 1, values, 2, &report), SPH2D_IO);
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &none), 0);
    ck_assert_msg(strstr(report.items[0].message, "'a.csv': File too large") != NULL, "%s", test_report_text(&report));
    ck_assert_str_eq(text_of("a.csv"), HEADER "0,1,2\n");
    append(series, 1, 1, 2); /* there is room again */
    ck_assert_str_eq(text_of("a.csv"), HEADER "0,1,2\n1,1,2\n");
    sph2d_series_close(series, NULL);
}
END_TEST

/* ---- whole or not at all ----------------------------------------------------------------------------------------- */

START_TEST(a_file_takes_its_name_when_it_is_done)
{
    sph2d__atomic_file file;
    store("a.txt", "old");
    ck_assert_int_eq(sph2d__atomic_begin(&file, "a.txt", &report), SPH2D_OK);
    char beside[64];
    snprintf(beside, sizeof beside, ".a.txt.tmp.%ld", (long)getpid());
    size_t named = strlen(beside);
    ck_assert_int_eq(strncmp(file.temp_path, beside, named), 0);
    ck_assert_uint_eq(strspn(file.temp_path + named, "0123456789"), 9);
    ck_assert_uint_eq(strlen(file.temp_path), named + 9);
    snprintf(beside, sizeof beside, "%s", file.temp_path);
    store(file.temp_path, "new");
    ck_assert_str_eq(text_of("a.txt"), "old");
    ck_assert_int_eq(sph2d__atomic_commit(&file, &report), SPH2D_OK);
    ck_assert_str_eq(text_of("a.txt"), "new");
    ck_assert_int_ne(access(beside, F_OK), 0);
    ck_assert_int_eq(mkdir("in", 0755), 0);
    ck_assert_int_eq(sph2d__atomic_begin(&file, "in/b.txt", &report), SPH2D_OK);
    ck_assert_int_eq(strncmp(file.temp_path, "in/.b.txt.tmp.", 14), 0);
    store(file.temp_path, "b");
    ck_assert_int_eq(sph2d__atomic_commit(&file, &report), SPH2D_OK);
    ck_assert_str_eq(text_of("in/b.txt"), "b");
    ck_assert_uint_eq(report.count, 0);
}
END_TEST

START_TEST(a_file_that_is_given_up_leaves_nothing)
{
    sph2d__atomic_file file = {NULL, NULL};
    sph2d__atomic_abort(&file); /* of zeros */
    store("a.txt", "old");
    ck_assert_int_eq(sph2d__atomic_begin(&file, "a.txt", &report), SPH2D_OK);
    store(file.temp_path, "new");
    char beside[64];
    snprintf(beside, sizeof beside, "%s", file.temp_path);
    sph2d__atomic_abort(&file);
    ck_assert_ptr_null(file.temp_path);
    ck_assert_int_ne(access(beside, F_OK), 0);
    ck_assert_str_eq(text_of("a.txt"), "old");
    /* a rename that fails gives up, too: a folder came in between */
    ck_assert_int_eq(sph2d__atomic_begin(&file, "b.txt", &report), SPH2D_OK);
    snprintf(beside, sizeof beside, "%s", file.temp_path);
    store(file.temp_path, "new");
    ck_assert_int_eq(mkdir("b.txt", 0755), 0);
    ck_assert_int_eq(sph2d__atomic_commit(&file, &report), SPH2D_IO);
    ck_assert_int_eq(report.items[0].code, SPH2D_CODE_FILE_WRITE);
    ck_assert_str_eq(report.items[0].message, "cannot rename to 'b.txt': Is a directory");
    ck_assert_int_ne(access(beside, F_OK), 0);
    /* and so does one that was never written */
    ck_assert_int_eq(sph2d__atomic_begin(&file, "a.txt", &report), SPH2D_OK);
    ck_assert_int_eq(sph2d__atomic_commit(&file, &report), SPH2D_IO);
    ck_assert_str_eq(text_of("a.txt"), "old");
}
END_TEST

START_TEST(names_that_no_file_can_take)
{
    static const char *const paths[] = {"", "in/", "in", "/dev/null", "/dev/full"};
    ck_assert_int_eq(mkdir("in", 0755), 0);
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; ++i) {
        sph2d__atomic_file file;
        sph2d_report_clear(&report);
        ck_assert_int_eq(sph2d__atomic_begin(&file, paths[i], &report), SPH2D_CANTCREAT);
        ck_assert_uint_eq(report.errors, 1);
        ck_assert_int_eq(report.items[0].code, SPH2D_CODE_FILE_WRITE);
        ck_assert_ptr_null(file.temp_path);
        sph2d__atomic_abort(&file);
    }
}
END_TEST

Suite *suite_series(void)
{
    Suite *suite = suite_create("series");
    TCase *rows = tcase_create("rows");
    tcase_add_checked_fixture(rows, set_up, tear_down);
    tcase_add_test(rows, rows_have_every_digit_and_stand_at_once);
    tcase_add_test(rows, points_stay_points_in_every_locale);
    tcase_add_test(rows, a_resumed_series_is_cut_and_goes_on);
    tcase_add_loop_test(rows, a_series_that_cannot_go_on_stays_as_it_is, 0, sizeof unsound / sizeof unsound[0]);
    tcase_add_test(rows, series_that_cannot_be_written);
    tcase_add_test(rows, a_row_without_room_is_no_half_row);
    suite_add_tcase(suite, rows);
    TCase *whole = tcase_create("whole or not at all");
    tcase_add_checked_fixture(whole, set_up, tear_down);
    tcase_add_test(whole, a_file_takes_its_name_when_it_is_done);
    tcase_add_test(whole, a_file_that_is_given_up_leaves_nothing);
    tcase_add_test(whole, names_that_no_file_can_take);
    suite_add_tcase(suite, whole);
    return suite;
}
