/* SPDX-License-Identifier: MIT */
/** @file study_reference.c
 *  Two columns of a CSV file. */
#include "study_reference.h"

#include <math.h>
#include <stdlib.h>

/* Points whose x does not lie on the line from 0 to 1. */
static bool is_along(const sph2d_table *table, size_t row, double x, sph2d_report *report)
{
    if (x >= 0 && x <= 1)
        return true;
    sph2d_diagnostic *d = sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OUT_OF_RANGE, NULL,
                                           "%g does not lie on the line: must be from 0, its first end, to 1", x);
    sph2d_table_locate(table, row, d);
    return false;
}

static sph2d_status copy_points(study_points *points, const sph2d_table *table, bool along, sph2d_report *report)
{
    size_t rows = sph2d_table_rows(table);
    points->x = malloc((rows + 1) * sizeof *points->x);
    points->y = malloc((rows + 1) * sizeof *points->y);
    if (points->x == NULL || points->y == NULL)
        return SPH2D_NOMEM;
    for (size_t row = 0; row < rows; ++row) {
        double x = sph2d_table_value(table, row, 0), y = sph2d_table_value(table, row, 1);
        if (isnan(x) || isnan(y))
            continue;
        if (along && !is_along(table, row, x, report))
            return SPH2D_FORMAT;
        points->x[points->count] = x;
        points->y[points->count++] = y;
    }
    if (points->count > 0)
        return SPH2D_OK;
    sph2d_diagnostic *d =
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_FIELD, NULL, "there is no row with both numbers");
    sph2d_table_locate(table, rows, d);
    return SPH2D_FORMAT;
}

sph2d_status study_points_read(study_points *points, const sph2d_study_reference *reference, bool along,
                               sph2d_report *report)
{
    const sph2d_table_column columns[2] = {{reference->x, NULL, false}, {reference->y, NULL, false}};
    sph2d_table *table;
    sph2d_status status = sph2d_table_read(reference->file, columns, 2, &table, report);
    if (status == SPH2D_OK)
        status = copy_points(points, table, along, report);
    sph2d_table_destroy(table);
    return status;
}

study_curve study_points_curve(const study_points *points)
{
    return (study_curve){points->x, points->y, points->count};
}

void study_points_free(study_points *points)
{
    free(points->x);
    free(points->y);
    *points = (study_points){0};
}
