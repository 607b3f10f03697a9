/* SPDX-License-Identifier: MIT */
/** @file grid_file.c
 *  A table of rows in any order becomes a grid: its lines are the different x and the different y. */
#include "files/grid_file.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "files/table_rows.h"
#include "sph2d/io.h"
#include "sph2d/key.h"

enum { X, Y, VX, VY, PRESSURE, COLUMNS };
static const sph2d_table_column columns[COLUMNS] = {
    [X] = {"x", "m", false},
    [Y] = {"y", "m", false},
    [VX] = {"vx", "m/s", true},
    [VY] = {"vy", "m/s", true},
    [PRESSURE] = {"pressure", "Pa", true},
};

/* Part of the width within which coordinates are the same. */
static const double SAME = 1e-9;

typedef struct lines {
    double *at;
    size_t count;
    double slack;
} lines;

static int by_size(const void *a, const void *b)
{
    double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}

/** The different values of a column, sorted. False when memory is short. */
static bool find_lines(const sph2d_table *table, size_t column, sph2d__pool *pool, lines *l)
{
    size_t rows = sph2d_table_rows(table);
    l->at = sph2d__pool_alloc(pool, rows, sizeof *l->at);
    if (!l->at)
        return false;
    for (size_t row = 0; row < rows; ++row)
        l->at[row] = sph2d_table_value(table, row, column);
    qsort(l->at, rows, sizeof *l->at, by_size);
    l->slack = SAME * (l->at[rows - 1] - l->at[0]);
    l->count = 1;
    for (size_t row = 1; row < rows; ++row)
        if (l->at[row] - l->at[l->count - 1] > l->slack)
            l->at[l->count++] = l->at[row];
    return true;
}

/** The line of a value: one of them is at most `slack` below it. */
static size_t line_of(const lines *l, double value)
{
    size_t low = 0, high = l->count;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (l->at[middle] <= value)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/** Checks that every row has all numbers, and that there are values and places. */
static sph2d_status check_rows(const sph2d_table *table, sph2d_report *report)
{
    size_t rows = sph2d_table_rows(table);
    if (!sph2d_table_has(table, VX) && !sph2d_table_has(table, VY) && !sph2d_table_has(table, PRESSURE))
        return sph2d__table_fault(table, 0, "a table of values needs one of the columns vx, vy, pressure", report);
    if (rows == 0)
        return sph2d__table_fault(table, 0, "this file has no rows", report);
    for (size_t row = 0; row < rows; ++row)
        for (size_t k = 0; k < COLUMNS; ++k) {
            double value = sph2d_table_has(table, k) ? sph2d_table_value(table, row, k) : 0;
            char message[100];
            if (fabs(value) <= SPH2D_LARGEST)
                continue;
            snprintf(message, sizeof message,
                     isnan(value) ? "this row lacks a number: its column '%s' is empty or nan"
                                  : "the number in column '%s' is larger than 1e12",
                     columns[k].name);
            return sph2d__table_fault(table, row, message, report);
        }
    return SPH2D_OK;
}

/** Checks that the numbers of lines and rows agree; two places of a grid may be the same, which is found later. */
static sph2d_status check_counts(const sph2d_table *table, const lines *x, const lines *y, sph2d_report *report)
{
    size_t rows = sph2d_table_rows(table);
    char message[160];
    if (x->count < 2 || y->count < 2) {
        snprintf(message, sizeof message,
                 "a grid needs two different x and two different y at least, this has %zu and %zu", x->count, y->count);
        return sph2d__table_fault(table, 0, message, report);
    }
    if (x->count * y->count / 2 <= rows)
        return SPH2D_OK;
    snprintf(message, sizeof message,
             "these points make no rectangular grid: %zu different x, %zu different y, but %zu rows", x->count,
             y->count, rows);
    return sph2d__table_fault(table, 0, message, report);
}

/** Finds the row of each place. `row_of` has zeros, and gets numbers of rows from 1. */
static sph2d_status assign(const sph2d_table *table, const lines *x, const lines *y, size_t *row_of,
                           sph2d_report *report)
{
    char message[160];
    for (size_t row = 0; row < sph2d_table_rows(table); ++row) {
        double px = sph2d_table_value(table, row, X), py = sph2d_table_value(table, row, Y);
        size_t *place = &row_of[line_of(y, py) * x->count + line_of(x, px)];
        if (*place > 0) {
            sph2d_diagnostic before = {.line = 0};
            sph2d_table_locate(table, *place - 1, &before);
            snprintf(message, sizeof message, "the point (%g, %g) is given twice, first on line %d", px, py,
                     before.line);
            return sph2d__table_fault(table, row, message, report);
        }
        *place = row + 1;
    }
    for (size_t k = 0; k < x->count * y->count; ++k)
        if (row_of[k] == 0) {
            snprintf(message, sizeof message,
                     "the point (%g, %g) is missing: a grid has all points of its %zu x and %zu y", x->at[k % x->count],
                     y->at[k / x->count], x->count, y->count);
            return sph2d__table_fault(table, SIZE_MAX, message, report);
        }
    return SPH2D_OK;
}

static sph2d_status fill(const sph2d_table *table, const lines *x, const lines *y, const size_t *row_of,
                         sph2d_grid *grid, sph2d__pool *pool)
{
    const double **values[COLUMNS] = {[VX] = &grid->vx, [VY] = &grid->vy, [PRESSURE] = &grid->pressure};
    size_t places = x->count * y->count;
    for (size_t column = VX; column < COLUMNS; ++column) {
        if (!sph2d_table_has(table, column))
            continue;
        double *items = sph2d__pool_alloc(pool, places, sizeof *items);
        if (!items)
            return SPH2D_NOMEM;
        for (size_t k = 0; k < places; ++k)
            items[k] = sph2d_table_value(table, row_of[k] - 1, column);
        *values[column] = items;
    }
    grid->x = x->at;
    grid->y = y->at;
    grid->nx = x->count;
    grid->ny = y->count;
    return SPH2D_OK;
}

static sph2d_status copy_table(const sph2d_table *table, sph2d_grid *grid, sph2d__pool *pool, sph2d_report *report)
{
    lines x, y;
    sph2d_status status = check_rows(table, report);
    if (status != SPH2D_OK)
        return status;
    if (!find_lines(table, X, pool, &x) || !find_lines(table, Y, pool, &y))
        return SPH2D_NOMEM;
    status = check_counts(table, &x, &y, report);
    if (status != SPH2D_OK)
        return status;
    size_t *row_of = sph2d__pool_alloc(pool, x.count * y.count, sizeof *row_of);
    if (!row_of)
        return SPH2D_NOMEM;
    status = assign(table, &x, &y, row_of, report);
    return status == SPH2D_OK ? fill(table, &x, &y, row_of, grid, pool) : status;
}

sph2d_status sph2d__grid_read(sph2d_grid *grid, const char *path, sph2d__pool *pool, sph2d_report *report)
{
    sph2d_table *table;
    sph2d_status status = sph2d_table_read(path, columns, COLUMNS, &table, report);
    if (status == SPH2D_OK)
        status = copy_table(table, grid, pool, report);
    sph2d_table_destroy(table);
    return status;
}
