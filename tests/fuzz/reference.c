/* SPDX-License-Identifier: MIT */
/** @file reference.c
 *  The CSV file that a study compares with: its points, of a series and of a profile, and a curve compared with them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study/curve.h"

#include "fuzz.h"
#include "input_file.h"

enum { NAME_SIZE = 200, MAX_POINTS = 2000 };

/** The heading at `text`, without its unit; returns where the next one begins, or NULL. */
static const char *take_name(const char *text, char *name)
{
    size_t length = strcspn(text, ",\r\n"), kept = length < NAME_SIZE ? length : NAME_SIZE - 1;
    memcpy(name, text, kept);
    name[kept] = '\0';
    char *unit = strstr(name, " [");
    if (unit)
        *unit = '\0';
    return text[length] == ',' ? text + length + 1 : NULL;
}

/** The first two headings of a table, so that files with any are read. */
static void find_names(const uint8_t *data, size_t size, char *x, char *y)
{
    char head[2 * NAME_SIZE];
    size_t start = 0;
    while (start < size && data[start] == '#') {
        const uint8_t *end = memchr(data + start, '\n', size - start);
        start = end ? (size_t)(end - data) + 1 : size;
    }
    size_t length = size - start < sizeof head - 1 ? size - start : sizeof head - 1;
    memcpy(head, data + start, length);
    head[length] = '\0';
    const char *next = take_name(head, x);
    take_name(next ? next : "y", y);
}

static void compare(const sph2d_study_measure *m, sph2d_report *report)
{
    static const double times[] = {0, 0.25, 1, 3}, values[] = {1, 2, -1, 0};
    sph2d_study_curve points, curve = {times, values, 4};
    sph2d_status status = sph2d__reference_make(&points, m, report);
    if (status != SPH2D_OK && report->errors == 0)
        abort(); /* refused without a word */
    for (int norm = SPH2D_NORM_MAX; norm <= SPH2D_NORM_MEAN && points.count < MAX_POINTS; ++norm)
        sph2d__curve_compare(curve, m->scale, points, (sph2d_norm)norm, m->reference.shift);
    for (int take = SPH2D_TAKE_LAST; take <= SPH2D_TAKE_DECAY; ++take)
        sph2d__curve_reduce((sph2d_take)take, points, NAN, 0.5);
    sph2d__reference_free(&points);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char x[NAME_SIZE], y[NAME_SIZE];
    find_names(data, size, x, y);
    input_file_write("reference.csv", data, size, "", 0);
    sph2d_study_measure m = {.name = "m", .expectation = SPH2D_EXPECT_REFERENCE, .scale = 1};
    m.reference = (sph2d_study_reference){"reference.csv", x, y, 0.2};
    for (int profile = 0; profile < 2; ++profile) {
        sph2d_report report = {0};
        m.source = profile ? SPH2D_MEASURE_PROFILE : SPH2D_MEASURE_PROBE;
        compare(&m, &report);
    }
    return 0;
}
