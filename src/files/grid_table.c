/* SPDX-License-Identifier: MIT */
/** @file grid_table.c
 *  A table of rows in any order becomes a grid: its lines are the different x and the different y. */
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include "files/table_kind.h"
#include "sph2d/key.h"

enum { X, Y, VX, VY, PRESSURE, COLUMNS };

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

/** Checks that every row has all numbers, and that there is one. */
static sph2d_status check_rows(const sph2d__table_input *in)
{
    const sph2d_table *table = in->table;
    size_t rows = sph2d_table_rows(table);
    if (rows == 0)
        return sph2d__table_fault(in, 0, "this file has no rows");
    for (size_t row = 0; row < rows; ++row)
        for (size_t k = 0; k < COLUMNS; ++k) {
            double value = sph2d_table_has(table, k) ? sph2d_table_value(table, row, k) : 0;
            if (isnan(value))
                return sph2d__table_lacks(in, row, k);
            if (fabs(value) > SPH2D_LARGEST)
                return sph2d__table_fault(in, row, "the number in column '%s' is larger than 1e12",
                                          in->kind->columns[k].name);
        }
    return SPH2D_OK;
}

/** Checks that the numbers of lines and rows agree; two places of a grid may be the same, which is found later. */
static sph2d_status check_counts(const sph2d__table_input *in, const lines *x, const lines *y)
{
    size_t rows = sph2d_table_rows(in->table);
    if (x->count < 2 || y->count < 2)
        return sph2d__table_fault(in, 0,
                                  "a grid needs two different x and two different y at least, this has %zu and %zu",
                                  x->count, y->count);
    if (x->count * y->count / 2 > rows)
        return sph2d__table_fault(
            in, 0, "these points make no rectangular grid: %zu different x, %zu different y, but %zu rows", x->count,
            y->count, rows);
    return SPH2D_OK;
}

/** Finds the row of each place. `row_of` has zeros, and gets numbers of rows from 1. */
static sph2d_status assign(const sph2d__table_input *in, const lines *x, const lines *y, size_t *row_of)
{
    for (size_t row = 0; row < sph2d_table_rows(in->table); ++row) {
        double px = sph2d_table_value(in->table, row, X), py = sph2d_table_value(in->table, row, Y);
        size_t *place = &row_of[line_of(y, py) * x->count + line_of(x, px)];
        if (*place > 0) {
            sph2d_diagnostic before = {.line = 0};
            sph2d_table_locate(in->table, *place - 1, &before);
            return sph2d__table_fault(in, row, "the point (%g, %g) is given twice, first on line %d", px, py,
                                      before.line);
        }
        *place = row + 1;
    }
    for (size_t k = 0; k < x->count * y->count; ++k)
        if (row_of[k] == 0)
            return sph2d__table_fault(in, SIZE_MAX,
                                      "the point (%g, %g) is missing: a grid has all points of its %zu x and %zu y",
                                      x->at[k % x->count], y->at[k / x->count], x->count, y->count);
    return SPH2D_OK;
}

static sph2d_status fill(const sph2d__table_input *in, const lines *x, const lines *y, const size_t *row_of,
                         sph2d_grid *grid)
{
    const double **values[COLUMNS] = {[VX] = &grid->vx, [VY] = &grid->vy, [PRESSURE] = &grid->pressure};
    size_t places = x->count * y->count;
    for (size_t column = VX; column < COLUMNS; ++column) {
        if (!sph2d_table_has(in->table, column))
            continue;
        double *items = sph2d__pool_alloc(in->pool, places, sizeof *items);
        if (!items)
            return SPH2D_NOMEM;
        for (size_t k = 0; k < places; ++k)
            items[k] = sph2d_table_value(in->table, row_of[k] - 1, column);
        *values[column] = items;
    }
    grid->x = x->at;
    grid->y = y->at;
    grid->nx = x->count;
    grid->ny = y->count;
    return SPH2D_OK;
}

static sph2d_status take_grid(const sph2d__table_input *in, void *owner)
{
    lines x, y;
    sph2d_status status = check_rows(in);
    if (status != SPH2D_OK)
        return status;
    if (!find_lines(in->table, X, in->pool, &x) || !find_lines(in->table, Y, in->pool, &y))
        return SPH2D_NOMEM;
    status = check_counts(in, &x, &y);
    if (status != SPH2D_OK)
        return status;
    size_t *row_of = sph2d__pool_alloc(in->pool, x.count * y.count, sizeof *row_of);
    if (!row_of)
        return SPH2D_NOMEM;
    status = assign(in, &x, &y, row_of);
    return status == SPH2D_OK ? fill(in, &x, &y, row_of, owner) : status;
}

const sph2d__table_kind sph2d__grid_table = {
    .key = "table",
    .file = offsetof(sph2d_grid, file),
    .columns =
        {
            [X] = {"x", "m", false},
            [Y] = {"y", "m", false},
            [VX] = {"vx", "m/s", true},
            [VY] = {"vy", "m/s", true},
            [PRESSURE] = {"pressure", "Pa", true},
        },
    .column_count = COLUMNS,
    .lacks_all = "a table of values needs one of the columns vx, vy, pressure",
    .take = take_grid,
};
