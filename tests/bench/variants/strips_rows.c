/* SPDX-License-Identifier: MIT */
/** @file strips_rows.c
 *  Strips a support radius high, particles sorted by x in each: what is near in x is found by moving two ends along
 *  (sweep and prune, Baraff 1992), with nothing of a column's width too much. */
#include "pair.h"

/** The particles of a strip that are near in x: `begin` to `end` - 1, before `last`. */
typedef struct sweep {
    size_t begin, end, last;
} sweep;

/** The strips around a row, swept from their left ends. */
static void sweep_start(const field *f, size_t row, sweep rows[3])
{
    for (size_t k = 0; k < 3; ++k) {
        size_t first = f->start.at[(row + k - 1) * f->grid.nx];
        rows[k] = (sweep){first, first, f->start.at[(row + k) * f->grid.nx]};
    }
}

/** Moves both ends along to what may be near particles from `low` to `high`. */
static inline void sweep_move(sweep *row, const double *x, double low, double high)
{
    while (row->begin < row->last && x[row->begin] < low)
        ++row->begin;
    while (row->end < row->last && x[row->end] < high)
        ++row->end;
}

/** A particle in each lane, candidates one by one. */
static void pass_strip_groups(field *f, const variant *v)
{
    (void)v;
    const sph2d__store *s = &f->store;
    const terms n = terms_of(f);
    const double support = f->scene.support;
    for (size_t row = 1; row + 1 < f->grid.ny; ++row) {
        sweep rows[3];
        sweep_start(f, row, rows);
        for (size_t i = f->start.at[row * f->grid.nx], last = rows[1].last; i < last; i += SPH2D__LANES) {
            size_t count = last - i < SPH2D__LANES ? last - i : SPH2D__LANES;
            const receiver me = receivers_at(s, &n, i);
            sums sum = {0};
            for (int k = 0; k < 3; ++k) {
                sweep_move(&rows[k], s->x, s->x[i] - support, s->x[i + count - 1] + support);
                for (size_t j = rows[k].begin; j < rows[k].end; ++j) {
                    candidate you = candidate_at(s, j);
                    add_pair(&sum, &n, &me, &you);
                }
            }
            const sums done = sum;
            write_lanes(f, i, (int)count, &done);
        }
    }
}

/** One particle, candidates in blocks of lanes. */
static void pass_strip_blocks(field *f, const variant *v)
{
    (void)v;
    const sph2d__store *s = &f->store;
    const terms n = terms_of(f);
    const double support = f->scene.support;
    for (size_t row = 1; row + 1 < f->grid.ny; ++row) {
        sweep rows[3];
        sweep_start(f, row, rows);
        for (size_t i = f->start.at[row * f->grid.nx]; i < rows[1].last; ++i) {
            const receiver me = receiver_at(s, &n, i);
            sums sum = {0};
            for (int k = 0; k < 3; ++k) {
                sweep_move(&rows[k], s->x, s->x[i] - support, s->x[i] + support);
                for (size_t j = rows[k].begin; j < rows[k].end; j += SPH2D__LANES) {
                    candidate you = candidates_at(s, j);
                    add_pair(&sum, &n, &me, &you);
                }
            }
            write_total(f, i, &sum);
        }
    }
}

const variant VARIANTS_OF(strips)[] = {{"strips sorted by x, groups", prepare_strips, pass_strip_groups, .columns = 8},
                                       {"strips sorted by x, blocks", prepare_strips, pass_strip_blocks, .columns = 8},
                                       {0}};
