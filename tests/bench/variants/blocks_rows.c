/* SPDX-License-Identifier: MIT */
/** @file blocks_rows.c
 *  One particle at a time, candidates in blocks of lanes, sums added up over lanes at the end.
 *
 *  The last block of a range runs over its end. Ranges hold all that is within the support radius, so that what follows
 *  counts as nothing without being told apart; where periods have ends it would have to be. */
#include "pair.h"

SPH2D__INLINE void add_range(sums *sum, const sph2d__store *s, const terms *n, const receiver *me, size_t begin,
                             size_t end)
{
    for (size_t j = begin; j < end; j += SPH2D__LANES) {
        candidate you = candidates_at(s, j);
        add_pair(sum, n, me, &you);
    }
}

/** The same where what follows a range may be near: the last block is told where it ends. */
SPH2D__INLINE void add_cut_range(sums *sum, const sph2d__store *s, const terms *n, const receiver *me,
                                 sph2d__lanes lane, size_t begin, size_t end)
{
    size_t whole = begin + (end - begin) / SPH2D__LANES * SPH2D__LANES;
    add_range(sum, s, n, me, begin, whole);
    if (whole == end)
        return;
    candidate you = candidates_at(s, whole);
    you.x = sph2d__lanes_where(everywhere((double)(end - whole)), lane, you.x); /* the origin is far away */
    add_pair(sum, n, me, &you);
}

/** Three rows of cells, or five of half the size: all within `reach` cells. */
SPH2D__INLINE void pass_around(field *f, uint32_t reach_x, uint32_t reach_y)
{
    const sph2d__store *s = &f->store;
    const terms n = terms_of(f);
    const sph2d__cells *c = &f->cells;
    const uint32_t ny = c->ny;
    for (uint32_t row = reach_y; row < ny - reach_y; ++row)
        for (uint32_t column = reach_x; column < c->nx - reach_x; ++column) {
            const uint32_t *middle = c->start + (size_t)row * c->nx + column;
            for (size_t i = middle[0]; i < middle[1]; ++i) {
                const receiver me = receiver_at(s, &n, i);
                sums sum = {0};
                const uint32_t *start = middle - (size_t)reach_y * c->nx;
                for (uint32_t k = 0; k < 2 * reach_y + 1; ++k, start += c->nx)
                    add_range(&sum, s, &n, &me, *(start - reach_x), start[reach_x + 1]);
                write_total(f, i, &sum);
            }
        }
}

/** Cells of a support radius, and narrower ones. */
static void pass_blocks(field *f, const variant *v)
{
    pass_around(f, v->columns > 0 ? v->columns : 1, 1);
}

/** Cells of half a radius: 25 of them are 6.25 squares of it instead of 9. */
static void pass_halves(field *f, const variant *v)
{
    (void)v;
    pass_around(f, 2, 2);
}

/** Ranges cut at their ends, as periods and narrow scenes need it. */
static void pass_cut(field *f, const variant *v)
{
    (void)v;
    const sph2d__store *s = &f->store;
    const terms n = terms_of(f);
    sph2d__lanes lane = {0};
    for (int l = 0; l < SPH2D__LANES; ++l)
        lane[l] = l;
    const sph2d__lanes lanes = lane;
    for (size_t i = 0; i < s->count; ++i) {
        const receiver me = receiver_at(s, &n, i);
        sums sum = {0};
        sph2d__ranges near;
        sph2d__cells_ranges(&f->cells, f->cells.cell[f->cells.order[i]], &near);
        for (int r = 0; r < near.count; ++r)
            add_cut_range(&sum, s, &n, &me, lanes, near.begin[r], near.end[r]);
        write_total(f, i, &sum);
    }
}

/** Cells of two radii: what is near lies in the four around the corner that a particle is next to, 16 squares. */
static void pass_quadrants(field *f, const variant *v)
{
    (void)v;
    const sph2d__store *s = &f->store;
    const terms n = terms_of(f);
    const sph2d__cells *c = &f->cells;
    for (size_t i = 0; i < s->count; ++i) {
        const receiver me = receiver_at(s, &n, i);
        double x = (s->x[i] - c->origin_x) * c->inverse_x - 0.5, y = (s->y[i] - c->origin_y) * c->inverse_y - 0.5;
        const uint32_t *start = c->start + (size_t)(uint32_t)y * c->nx + (uint32_t)x;
        sums sum = {0};
        add_range(&sum, s, &n, &me, start[0], start[2]);
        add_range(&sum, s, &n, &me, start[c->nx], start[c->nx + 2]);
        write_total(f, i, &sum);
    }
}

const variant VARIANTS_OF(blocks)[] = {
    {"blocks, cells 1 H", prepare_cells, pass_blocks, .columns = 1},
    {"blocks, columns 1/4 H", prepare_cells, pass_blocks, .columns = 4},
    {"blocks, columns 1/4 H, ends of ranges cut", prepare_cells, pass_cut, .columns = 4},
    {"blocks, cells 1/2 H (5x5)", prepare_cells, pass_halves, .columns = 1, .cell = 0.5},
    {"blocks, cells 2 H (four of them)", prepare_cells, pass_quadrants, .columns = 1, .cell = 2},
    {0}};
