/* SPDX-License-Identifier: MIT */
/** @file reference.c
 *  What a measure is compared with, and the points of a CSV file. */
#include <math.h>
#include <stdlib.h>

#include "study/curve.h"

bool sph2d_study_has_value(const sph2d_study_measure *m)
{
    if (!m)
        return false;
    bool whole =
        m->source == SPH2D_MEASURE_PROFILE || (m->source == SPH2D_MEASURE_PROBE && m->take == SPH2D_TAKE_DEFAULT);
    return m->expectation != SPH2D_EXPECT_REFERENCE && !(m->expectation == SPH2D_EXPECT_FINEST && whole);
}

bool sph2d_study_has_error(const sph2d_study_measure *m)
{
    return m && m->expectation != SPH2D_EXPECT_NOTHING;
}

/** Whether x lies on the line from 0 to 1; a fault otherwise. */
static bool is_along(const sph2d_table *table, size_t row, double x, sph2d_report *report)
{
    if (x >= 0 && x <= 1)
        return true;
    sph2d_diagnostic *d = sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OUT_OF_RANGE, NULL,
                                           "%g does not lie on the line: must be from 0, its first end, to 1", x);
    sph2d_table_locate(table, row, d);
    return false;
}

static sph2d_status copy_points(sph2d_study_curve *points, const sph2d_table *table, bool along, sph2d_report *report)
{
    size_t rows = sph2d_table_rows(table);
    double *room = malloc((2 * rows + 1) * sizeof *room);
    if (!room)
        return SPH2D_NOMEM;
    *points = (sph2d_study_curve){room, room + rows, 0};
    for (size_t row = 0; row < rows; ++row) {
        double x = sph2d_table_value(table, row, 0), y = sph2d_table_value(table, row, 1);
        if (isnan(x) || isnan(y))
            continue;
        if (along && !is_along(table, row, x, report))
            return SPH2D_FORMAT;
        room[points->count] = x;
        room[rows + points->count++] = y;
    }
    if (points->count > 0)
        return SPH2D_OK;
    sph2d_diagnostic *d =
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_FIELD, NULL, "there is no row with both numbers");
    sph2d_table_locate(table, rows, d);
    return SPH2D_FORMAT;
}

/** Places along the line of a profile that the finest run is compared at. */
static sph2d_status make_places(sph2d_study_curve *points)
{
    enum { PLACES = 101 };
    double *room = calloc(PLACES, sizeof *room);
    for (size_t i = 0; room && i < PLACES; ++i)
        room[i] = (double)i / (PLACES - 1);
    if (room)
        *points = (sph2d_study_curve){room, NULL, PLACES};
    return room ? SPH2D_OK : SPH2D_NOMEM;
}

sph2d_status sph2d__reference_make(sph2d_study_curve *points, const sph2d_study_measure *measure, sph2d_report *report)
{
    bool along = measure->source == SPH2D_MEASURE_PROFILE;
    const sph2d_study_reference *reference = &measure->reference;
    *points = (sph2d_study_curve){NULL, NULL, 0};
    if (measure->expectation != SPH2D_EXPECT_REFERENCE)
        return along ? make_places(points) : SPH2D_OK;
    const sph2d_table_column columns[2] = {{reference->x, NULL, false}, {reference->y, NULL, false}};
    sph2d_table *table;
    sph2d_status status = sph2d_table_read(reference->file, columns, 2, &table, report);
    if (status == SPH2D_OK)
        status = copy_points(points, table, along, report);
    if (status != SPH2D_OK)
        sph2d__reference_free(points);
    sph2d_table_destroy(table);
    return status;
}

void sph2d__reference_free(sph2d_study_curve *points)
{
    free((void *)(uintptr_t)points->x); /* the block begins there */
    *points = (sph2d_study_curve){NULL, NULL, 0};
}
