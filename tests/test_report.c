/* SPDX-License-Identifier: MIT */
/** @file test_report.c
 *  Statuses, codes and diagnostics. Values, names and codes are part of the ABI (sph2d/status.h), so they are pinned
 *  here as numbers and text, not through the header's own lists. */
#include <stdio.h>
#include <string.h>

#include "common.h"

START_TEST(statuses_keep_their_values_and_names)
{
    static const struct {
        sph2d_status status;
        int value;
        const char *name, *text;
    } expected[] = {
        {SPH2D_OK, 0, "OK", "success"},
        {SPH2D_INVALID, 1, "INVALID", "invalid argument"},
        {SPH2D_NOMEM, 2, "NOMEM", "out of memory"},
        {SPH2D_SCENE, 3, "SCENE", "scene rejected"},
        {SPH2D_GUARD, 4, "GUARD", "simulation stopped by a guard"},
        {SPH2D_NOINPUT, 5, "NOINPUT", "input missing or unreadable"},
        {SPH2D_FORMAT, 6, "FORMAT", "file content rejected"},
        {SPH2D_CANTCREAT, 7, "CANTCREAT", "output cannot be created"},
        {SPH2D_IO, 8, "IO", "reading or writing failed"},
        {SPH2D_RENDER, 9, "RENDER", "rendering unavailable"},
        {SPH2D_DEVICE, 10, "DEVICE", "a device failed"},
    };
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; ++i) {
        ck_assert_int_eq((int)expected[i].status, expected[i].value);
        ck_assert_str_eq(sph2d_status_name(expected[i].status), expected[i].name);
        ck_assert_str_eq(sph2d_status_text(expected[i].status), expected[i].text);
    }
    ck_assert_str_eq(sph2d_status_name((sph2d_status)11), "UNKNOWN");
    ck_assert_str_eq(sph2d_status_name((sph2d_status)-1), "UNKNOWN");
    ck_assert_ptr_nonnull(sph2d_status_text((sph2d_status)11));
}
END_TEST

START_TEST(codes_keep_their_text)
{
    static const struct {
        sph2d_code code;
        const char *text;
    } expected[] = {
        {SPH2D_CODE_GENERAL, "G000"},         {SPH2D_CODE_SYNTAX, "S100"},        {SPH2D_CODE_UNKNOWN_KEY, "S101"},
        {SPH2D_CODE_DUPLICATE_KEY, "S102"},   {SPH2D_CODE_WRONG_TYPE, "S103"},    {SPH2D_CODE_OUT_OF_RANGE, "S104"},
        {SPH2D_CODE_MISSING_KEY, "S105"},     {SPH2D_CODE_CONFLICT, "S106"},      {SPH2D_CODE_OUTSIDE, "S107"},
        {SPH2D_CODE_OVERLAP, "S108"},         {SPH2D_CODE_NO_PARTICLES, "S109"},  {SPH2D_CODE_TOO_MANY, "S110"},
        {SPH2D_CODE_UNSUPPORTED, "S111"},     {SPH2D_CODE_FILE_OPEN, "F201"},     {SPH2D_CODE_FILE_KIND, "F202"},
        {SPH2D_CODE_FILE_INCOMPLETE, "F203"}, {SPH2D_CODE_FILE_FIELD, "F204"},    {SPH2D_CODE_FILE_VERSION, "F205"},
        {SPH2D_CODE_FILE_WRITE, "F206"},      {SPH2D_CODE_FILE_EXISTS, "F207"},   {SPH2D_CODE_NOT_FINITE, "R301"},
        {SPH2D_CODE_ESCAPED, "R302"},         {SPH2D_CODE_STEP_COLLAPSE, "R303"}, {SPH2D_CODE_STEP_TOO_LARGE, "R304"},
        {SPH2D_CODE_NOT_CONVERGED, "R305"},   {SPH2D_CODE_DENSITY, "R306"},       {SPH2D_CODE_ENERGY, "R307"},
        {SPH2D_CODE_SUPERSONIC, "R308"},      {SPH2D_CODE_MOMENTUM, "R309"},      {SPH2D_CODE_GL_MISSING, "P401"},
        {SPH2D_CODE_GL_SHADER, "P402"},       {SPH2D_CODE_GL_FAILED, "P403"},     {SPH2D_CODE_DEVICE, "D501"},
    };
    ck_assert_uint_eq(sizeof expected / sizeof expected[0], SPH2D_CODE_COUNT);
    for (size_t i = 0; i < sizeof expected / sizeof expected[0]; ++i)
        ck_assert_str_eq(sph2d_code_text(expected[i].code), expected[i].text);
    ck_assert_str_eq(sph2d_code_text(SPH2D_CODE_COUNT), "G000");
    ck_assert_str_eq(sph2d_code_text((sph2d_code)-1), "G000");
}
END_TEST

START_TEST(a_report_keeps_twenty_and_counts_the_rest)
{
    static sph2d_report report;
    sph2d_report_clear(&report);
    for (int i = 0; i < 23; ++i) {
        sph2d_severity severity = i % 4 == 3 ? SPH2D_WARNING : SPH2D_ERROR;
        sph2d_diagnostic *d = sph2d_report_add(&report, severity, SPH2D_CODE_CONFLICT, "a.b", "number %d", i);
        ck_assert(i < 20 ? d == &report.items[i] : d == NULL);
        sph2d_diagnostic_hint(d, "hint %d", i); /* NULL must be fine */
    }
    ck_assert_uint_eq(SPH2D_REPORT_CAPACITY, 20);
    ck_assert_uint_eq(report.count, 20);
    ck_assert_uint_eq(report.dropped, 3);
    ck_assert_uint_eq(report.errors, 18); /* 3, 7, 11, 15 and 19 are warnings */
    ck_assert_str_eq(report.items[19].message, "number 19");
    ck_assert_str_eq(report.items[19].hint, "hint 19");
    ck_assert_str_eq(report.items[19].path, "a.b");
    ck_assert_int_eq(report.items[19].severity, SPH2D_WARNING);
    sph2d_report_clear(&report);
    ck_assert_uint_eq(report.count + report.dropped + report.errors, 0);
    /* A used item starts afresh. */
    sph2d_diagnostic *d = sph2d_report_add(&report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "again");
    ck_assert_str_eq(d->path, "");
    ck_assert_str_eq(d->hint, "");
    ck_assert_int_eq(d->line, 0);
}
END_TEST

START_TEST(no_report_is_fine)
{
    sph2d_report_clear(NULL);
    ck_assert_ptr_null(sph2d_report_add(NULL, SPH2D_ERROR, SPH2D_CODE_GENERAL, "x", "%d", 1));
    sph2d_diagnostic_hint(NULL, "%d", 1);
}
END_TEST

START_TEST(long_text_is_cut_at_its_capacity)
{
    static sph2d_report report;
    char text[1000];
    memset(text, 'x', sizeof text);
    text[sizeof text - 1] = '\0';
    sph2d_diagnostic *d = sph2d_report_add(&report, SPH2D_ERROR, SPH2D_CODE_GENERAL, text, "%s", text);
    sph2d_diagnostic_hint(d, "%s", text);
    ck_assert_uint_eq(strlen(d->path), sizeof d->path - 1);
    ck_assert_uint_eq(strlen(d->message), sizeof d->message - 1);
    ck_assert_uint_eq(strlen(d->hint), sizeof d->hint - 1);
}
END_TEST

/** The example of status.h, `scene.yaml:12:9: error[S104]: message`, source line, caret, hint. */
static sph2d_diagnostic located(void)
{
    return (sph2d_diagnostic){.severity = SPH2D_ERROR,
                              .code = SPH2D_CODE_OUT_OF_RANGE,
                              .file = "scene.yaml",
                              .line = 12,
                              .column = 9,
                              .excerpt = "spacing: -1",
                              .message = "message",
                              .hint = "do this"};
}

START_TEST(a_located_diagnostic_shows_its_line)
{
    char text[512];
    sph2d_diagnostic d = located();
    size_t length = sph2d_diagnostic_format(&d, text, sizeof text);
    ck_assert_uint_eq(length, strlen(text));
    ck_assert_int_eq(strncmp(text, "scene.yaml:12:9: error[S104]: message\n", 38), 0);
    const char *source = strstr(text, "spacing: -1\n"), *caret = strchr(text, '^');
    ck_assert_ptr_nonnull(source);
    ck_assert_ptr_nonnull(caret);
    const char *caret_line = source + strlen("spacing: -1\n");
    /* The caret stands under column 9 of the source line, wherever that is indented to. */
    const char *source_line = source;
    while (source_line[-1] != '\n')
        --source_line;
    ck_assert_int_eq(caret - caret_line, (source - source_line) + 9 - 1);
    ck_assert_ptr_nonnull(strstr(caret, "\n"));
    ck_assert_ptr_nonnull(strstr(caret, "do this"));
    ck_assert_int_ne(text[length - 1], '\n');
}
END_TEST

START_TEST(a_bare_diagnostic_is_one_line)
{
    char text[512];
    sph2d_diagnostic d = {.severity = SPH2D_WARNING, .code = SPH2D_CODE_GENERAL, .message = "something"};
    sph2d_diagnostic_format(&d, text, sizeof text);
    ck_assert_str_eq(text, "warning[G000]: something");
    snprintf(d.path, sizeof d.path, "blocks[0].box.max");
    sph2d_diagnostic_format(&d, text, sizeof text);
    ck_assert_ptr_nonnull(strstr(text, "blocks[0].box.max"));
    ck_assert_ptr_nonnull(strstr(text, "something"));
    ck_assert_ptr_null(strchr(text, '\n'));
    snprintf(d.file, sizeof d.file, "scene.yaml"); /* the line is not known */
    sph2d_diagnostic_format(&d, text, sizeof text);
    ck_assert_int_eq(strncmp(text, "scene.yaml: warning[G000]: ", 27), 0);
}
END_TEST

START_TEST(formatting_works_like_snprintf)
{
    char whole[512], part[512];
    sph2d_diagnostic d = located();
    size_t length = sph2d_diagnostic_format(&d, whole, sizeof whole);
    ck_assert_uint_eq(sph2d_diagnostic_format(&d, NULL, 0), length);
    for (size_t size = 1; size <= length + 1; ++size) {
        memset(part, '#', sizeof part);
        size_t needed = sph2d_diagnostic_format(&d, part, size);
        bool ok =
            needed == length && strlen(part) == size - 1 && strncmp(part, whole, size - 1) == 0 && part[size] == '#';
        ck_assert_msg(ok, "buffer of %zu bytes", size);
    }
}
END_TEST

Suite *suite_report(void)
{
    Suite *suite = suite_create("report");
    TCase *tests = tcase_create("report");
    tcase_add_test(tests, statuses_keep_their_values_and_names);
    tcase_add_test(tests, codes_keep_their_text);
    tcase_add_test(tests, a_report_keeps_twenty_and_counts_the_rest);
    tcase_add_test(tests, no_report_is_fine);
    tcase_add_test(tests, long_text_is_cut_at_its_capacity);
    tcase_add_test(tests, a_located_diagnostic_shows_its_line);
    tcase_add_test(tests, a_bare_diagnostic_is_one_line);
    tcase_add_test(tests, formatting_works_like_snprintf);
    suite_add_tcase(suite, tests);
    return suite;
}
