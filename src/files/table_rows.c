/* SPDX-License-Identifier: MIT */
/** @file table_rows.c */
#include "files/table_rows.h"

#include <math.h>
#include <stdio.h>

sph2d_status sph2d__table_fault(const sph2d_table *table, size_t row, const char *message, sph2d_report *report)
{
    sph2d_table_locate(table, row, sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_FIELD, NULL, "%s", message));
    return SPH2D_FORMAT;
}

static sph2d_status fault_of_number(const sph2d_table *table, size_t row, const char *column, sph2d_report *report)
{
    char message[80];
    snprintf(message, sizeof message, "this row lacks a number: its column '%s' is empty or nan", column);
    return sph2d__table_fault(table, row, message, report);
}

sph2d_status sph2d__table_rows(const sph2d_table *table, const sph2d_table_column *columns, const size_t *which,
                               size_t width, const double *otherwise, sph2d__pool *pool, double **rows,
                               sph2d_report *report)
{
    size_t count = sph2d_table_rows(table);
    if (count == 0)
        return sph2d__table_fault(table, 0, "this file has no rows", report);
    *rows = sph2d__pool_alloc(pool, count, width * sizeof **rows);
    if (!*rows)
        return SPH2D_NOMEM;
    for (size_t row = 0; row < count; ++row) {
        double *p = &(*rows)[row * width];
        for (size_t k = 0; k < width; ++k) {
            bool here = sph2d_table_has(table, which[k]);
            p[k] = here ? sph2d_table_value(table, row, which[k]) : otherwise[k];
            if (!isfinite(p[k]))
                return fault_of_number(table, row, columns[which[k]].name, report);
        }
        if (row > 0 && !(p[0] > (*rows)[(row - 1) * width]))
            return sph2d__table_fault(table, row, "times must increase from row to row", report);
    }
    return SPH2D_OK;
}
