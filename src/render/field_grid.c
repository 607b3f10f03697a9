/* SPDX-License-Identifier: MIT */
/** @file field_grid.c
 *  Sums of balls' fields, by vectors of four floats. */
#include "render/field_grid.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Vectors of four floats, an extension of GCC and Clang; their comparison gives all bits or none. */
enum { LANES = 4 };
typedef float lanes __attribute__((vector_size(LANES * sizeof(float))));
typedef int bits __attribute__((vector_size(LANES * sizeof(int))));

static lanes load(const float *from)
{
    lanes a;
    memcpy(&a, from, sizeof a);
    return a;
}

static void store(float *to, lanes a)
{
    memcpy(to, &a, sizeof a);
}

/* Floats of a row: the last vector may go beyond its end. */
static size_t stride_of(int columns)
{
    return (size_t)columns + LANES;
}

bool sph2d__field_grid_create(sph2d__field_grid *grid, int columns, int rows, int planes)
{
    const size_t row = stride_of(columns) * (size_t)planes;
    *grid = (sph2d__field_grid){.columns = columns, .planes = planes, .capacity = row * (size_t)rows};
    grid->sums = calloc(grid->capacity, sizeof *grid->sums);
    grid->across = calloc(stride_of(columns), sizeof *grid->across);
    if (!grid->sums || !grid->across) {
        sph2d__field_grid_destroy(grid);
        return false;
    }
    sph2d__field_grid_reset(grid, columns, rows);
    return true;
}

void sph2d__field_grid_reset(sph2d__field_grid *grid, int columns, int rows)
{
    if (grid->top < grid->bottom) {
        const size_t row = (size_t)grid->planes * grid->stride;
        memset(grid->sums + (size_t)grid->top * row, 0, (size_t)(grid->bottom - grid->top) * row * sizeof *grid->sums);
    }
    grid->columns = columns;
    grid->rows = rows;
    grid->stride = stride_of(columns);
    grid->top = rows;
    grid->bottom = 0;
}

/* The squares whose middles are within a distance of a coordinate. */
static void find_range(float at, float reach, int count, int *first, int *end)
{
    *first = (int)fminf(fmaxf(ceilf(at - reach - 0.5F), 0.0F), (float)count);
    *end = (int)fminf(fmaxf(floorf(at + reach - 0.5F) + 1.0F, 0.0F), (float)count);
}

/* Adds the ball to a row of the field, and of colours if there are any. */
static void add_row(const sph2d__field_grid *grid, float *row, size_t width, float down, float weight,
                    const float *color)
{
    const size_t stride = grid->stride;
    for (size_t k = 0; k < width; k += LANES) {
        const lanes fall = load(grid->across + k) - down, rest = (lanes)((bits)fall & (fall > 0.0F));
        const lanes field = weight * rest * rest;
        store(row + k, load(row + k) + field);
        for (size_t c = 1; color && c <= 3; ++c)
            store(row + c * stride + k, load(row + c * stride + k) + color[c - 1] * field);
    }
}

void sph2d__field_grid_add(sph2d__field_grid *grid, const float at[2], double radius, float weight,
                           const float color[3])
{
    const float reach = (float)(radius * sqrt(0.5)), unit = (float)(1.0 / radius);
    int left, right, top, bottom;
    find_range(at[0], reach, grid->columns, &left, &right);
    find_range(at[1], reach, grid->rows, &top, &bottom);
    if (left >= right || top >= bottom)
        return;
    const size_t width = (size_t)(right - left), row = (size_t)grid->planes * grid->stride;
    const lanes step = {0.5F, 1.5F, 2.5F, 3.5F};
    for (size_t k = 0; k < width; k += LANES) {
        const lanes x = unit * (((float)left - at[0] + (float)k) + step);
        store(grid->across + k, 0.5F - x * x);
    }
    for (int y = top; y < bottom; ++y) {
        const float down = unit * ((float)y + 0.5F - at[1]);
        add_row(grid, grid->sums + (size_t)y * row + left, width, down * down, weight, grid->planes > 1 ? color : NULL);
    }
    grid->top = top < grid->top ? top : grid->top;
    grid->bottom = bottom > grid->bottom ? bottom : grid->bottom;
}

static lanes choose(bits first, lanes a, lanes b)
{
    return (lanes)(((bits)a & first) | ((bits)b & ~first));
}

static sph2d__field_limits join(sph2d__field_limits a, float sum)
{
    return (sph2d__field_limits){sum < a.low ? sum : a.low, sum > a.high ? sum : a.high};
}

sph2d__field_limits sph2d__field_grid_limits(const sph2d__field_grid *grid, int left, int top, int right, int bottom)
{
    left = left > 0 ? left : 0;
    top = top > 0 ? top : 0;
    right = right < grid->columns ? right : grid->columns;
    bottom = bottom < grid->rows ? bottom : grid->rows;
    const float first = sph2d__field_grid_row(grid, top)[left];
    sph2d__field_limits all = {first, first};
    lanes low = (lanes){0} + first, high = low;
    for (int y = top; y < bottom; ++y) {
        const float *row = sph2d__field_grid_row(grid, y);
        int x = left;
        for (; x + LANES <= right; x += LANES) {
            const lanes sums = load(row + x);
            low = choose(sums < low, sums, low);
            high = choose(sums > high, sums, high);
        }
        for (; x < right; ++x)
            all = join(all, row[x]);
    }
    for (int k = 0; k < LANES; ++k) {
        all = join(all, low[k]);
        all = join(all, high[k]);
    }
    return all;
}

void sph2d__field_grid_destroy(sph2d__field_grid *grid)
{
    free(grid->sums);
    free(grid->across);
    *grid = (sph2d__field_grid){0};
}
