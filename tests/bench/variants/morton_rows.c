/* SPDX-License-Identifier: MIT */
/** @file morton_rows.c
 *  Cells in Morton's order instead of row by row: neighbours lie nearer in memory, but in nine ranges instead of three,
 *  and a group must be in one cell. */
#include "methods/common/group.h"
#include "pair.h"

/** The candidates of one cell after the other. */
SPH2D__INLINE void add_cells(field *f, const terms *n, size_t first, size_t last, const sph2d__ranges *near)
{
    const sph2d__store *s = &f->store;
    for (size_t i = first; i < last; i += SPH2D__LANES) {
        const receiver me = receivers_at(s, n, i);
        sums sum = {0};
        SPH2D__FOR_NEIGHBOURS (near, r, j) {
            candidate you = candidate_at(s, j);
            add_pair(&sum, n, &me, &you);
        }
        const sums done = sum;
        write_lanes(f, i, (int)(last - i < SPH2D__LANES ? last - i : SPH2D__LANES), &done);
    }
}

/** Every cell after the other in Morton's order, as its particles say where it is. */
static void pass_morton(field *f, const variant *v)
{
    (void)v;
    const terms n = terms_of(f);
    const uint32_t *start = f->start.at, *spread_x = f->spread_x.at, *spread_y = f->spread_y.at;
    for (size_t i = 0, last; i < f->store.count; i = last) {
        uint32_t column = grid_column(&f->grid, f->store.x[i]), row = grid_row(&f->grid, f->store.y[i]);
        sph2d__ranges near = {0};
        for (uint32_t y = row - 1; y <= row + 1; ++y)
            for (uint32_t x = column - 1; x <= column + 1; ++x) {
                uint32_t cell = spread_y[y] | spread_x[x];
                near.begin[near.count] = start[cell];
                near.end[near.count++] = start[cell + 1];
            }
        last = start[(spread_y[row] | spread_x[column]) + 1];
        add_cells(f, &n, i, last, &near);
    }
}

/** The same with cells row by row, as far as order alone makes a difference: groups in one cell each. */
static void pass_rows(field *f, const variant *v)
{
    (void)v;
    const terms n = terms_of(f);
    const sph2d__cells *c = &f->cells;
    for (size_t i = 0, last; i < f->store.count; i = last) {
        uint32_t cell = c->cell[c->order[i]];
        sph2d__ranges near;
        sph2d__cells_ranges(c, cell, &near);
        last = c->start[cell + 1];
        add_cells(f, &n, i, last, &near);
    }
}

const variant VARIANTS_OF(morton)[] = {
    {"groups in one cell of 1 H each, row by row", prepare_cells, pass_rows, .columns = 1},
    {"groups in one cell of 1 H each, Morton order", prepare_morton, pass_morton, .columns = 1},
    {0}};
