/* SPDX-License-Identifier: MIT */
/** @file groups_rows.c
 *  Some particles of a row at a time, one in each lane, and the candidates around all of them one by one: sifted, as
 *  the library does, and all of them, with cells of several widths, sorted every few steps, and of packed blocks. */
#include "sift.h"

/** The library's way: candidates are sifted by their distance from the group's box before pairs are computed. */
static void pass_library(field *f, const variant *v)
{
    (void)v;
    const sph2d__store *s = &f->store;
    const terms n = terms_of(f);
    const sph2d__grouping by = sph2d__grouping_of(s, &f->cells, NULL);
    sph2d__sieve sieve;
    SPH2D__FOR_GROUPS (&by, g, 0, s->count) {
        const receiver me = receivers_at(s, &n, g.first);
        sums sum = {0};
        sph2d__ranges near;
        sph2d__patch_ranges(by.cells, &g.patch, &near);
        sph2d__group_box(s, &g);
        sph2d__sieve_start(&sieve, &near, f->scene.support);
        while (sph2d__sift(&sieve, &g, &near, s->x, s->y)) {
            SPH2D__FOR_FOUND (sieve, j) {
                candidate you = candidate_at(s, j);
                add_pair(&sum, &n, &me, &you);
            }
        }
        const sums done = sum; /* the sums themselves can then stay in registers */
        write_lanes(f, g.first, g.count, &done);
    }
}

/** All candidates. Cells that were made for a few steps are wider by what particles move meanwhile. */
static void pass_groups(field *f, const variant *v)
{
    (void)v;
    const sph2d__store *s = &f->store;
    const terms n = terms_of(f);
    const sph2d__grouping by = sph2d__grouping_of(s, &f->cells, NULL);
    SPH2D__FOR_GROUPS (&by, g, 0, s->count) {
        const receiver me = receivers_at(s, &n, g.first);
        sums sum = {0};
        sph2d__ranges near;
        sph2d__patch_ranges(by.cells, &g.patch, &near);
        SPH2D__FOR_NEIGHBOURS (&near, r, j) {
            candidate you = candidate_at(s, j);
            add_pair(&sum, &n, &me, &you);
        }
        const sums done = sum; /* the sums themselves can then stay in registers */
        write_lanes(f, g.first, g.count, &done);
    }
}

/* Candidates of a group that are kept at a time. */
enum { KEPT = 512 };

/** Adds those that were kept. */
SPH2D__INLINE void add_kept(sums *sum, const sph2d__store *s, const terms *n, const receiver *me, const uint32_t *kept,
                            const uint32_t *last)
{
    for (; kept < last; ++kept) {
        candidate you = candidate_at(s, *kept);
        add_pair(sum, n, me, &you);
    }
}

/** Candidates are sifted by their distances from all particles of the group. */
static void pass_sifted(field *f, const variant *v)
{
    (void)v;
    const sph2d__store *s = &f->store;
    const terms n = terms_of(f);
    const double support2 = f->scene.support * f->scene.support;
    const sph2d__grouping by = sph2d__grouping_of(s, &f->cells, NULL);
    uint32_t kept[KEPT + SPH2D__LANES];
    SPH2D__FOR_GROUPS (&by, g, 0, s->count) {
        const receiver me = receivers_at(s, &n, g.first);
        sums sum = {0};
        sph2d__ranges near;
        uint32_t *to = kept;
        sph2d__patch_ranges(by.cells, &g.patch, &near);
        for (int r = 0; r < near.count; ++r)
            for (size_t j = near.begin[r], end; j < near.end[r]; j = end) {
                end = near.end[r] < j + KEPT ? near.end[r] : j + KEPT;
                if (to + (end - j) > kept + KEPT) {
                    add_kept(&sum, s, &n, &me, kept, to);
                    to = kept;
                }
                to = sift_by_all(s, &g, support2, j, end, to);
            }
        add_kept(&sum, s, &n, &me, kept, to);
        const sums done = sum;
        write_lanes(f, g.first, g.count, &done);
    }
}

/** The particles of a group, from packed blocks. */
SPH2D__INLINE receiver receivers_of(const block *from, const terms *n)
{
    double a[7][SPH2D__LANES];
    for (int l = 0; l < SPH2D__LANES; ++l, ++from) {
        a[0][l] = from->x;
        a[1][l] = from->y;
        a[2][l] = from->vx;
        a[3][l] = from->vy;
        a[4][l] = from->density;
        a[5][l] = from->pressure * from->volume * from->volume;
        a[6][l] = n->damping * from->volume;
    }
    return (receiver){sph2d__lanes_load(a[0]), sph2d__lanes_load(a[1]), sph2d__lanes_load(a[2]),
                      sph2d__lanes_load(a[3]), sph2d__lanes_load(a[4]), sph2d__lanes_load(a[5]),
                      sph2d__lanes_load(a[6])};
}

/** Packed blocks: what is read of a candidate is in one line of a cache. */
static void pass_packed(field *f, const variant *v)
{
    const terms n = terms_of(f);
    const sph2d__cells cells = {.columns = v->columns,
                                .nx = f->grid.nx,
                                .ny = f->grid.ny,
                                .start = f->start.at,
                                .cell = f->key.at,
                                .order = f->order.at};
    const sph2d__grouping by = sph2d__grouping_of(&f->store, &cells, NULL);
    SPH2D__FOR_GROUPS (&by, g, 0, f->store.count) {
        const receiver me = receivers_of(f->blocks + g.first, &n);
        sums sum = {0};
        sph2d__ranges near;
        sph2d__patch_ranges(&cells, &g.patch, &near);
        SPH2D__FOR_NEIGHBOURS (&near, r, j) {
            const block *b = &f->blocks[j];
            candidate you = {everywhere(b->x),       everywhere(b->y),        everywhere(b->vx),    everywhere(b->vy),
                             everywhere(b->density), everywhere(b->pressure), everywhere(b->volume)};
            add_pair(&sum, &n, &me, &you);
        }
        const sums done = sum;
        write_lanes(f, g.first, g.count, &done);
    }
}

const variant VARIANTS_OF(groups)[] = {
    {"groups sifted by their box (the library)", prepare_cells, pass_library, .columns = 4},
    {"groups sifted by their box, columns 1/8 H", prepare_cells, pass_library, .columns = 8},
    {"groups sifted by their particles", prepare_cells, pass_sifted, .columns = 4},
    {"groups, columns 1/4 H", prepare_cells, pass_groups, .columns = 4},
    {"groups, columns 1/8 H", prepare_cells, pass_groups, .columns = 8},
    {"groups, columns 1/2 H", prepare_cells, pass_groups, .columns = 2},
    {"groups, columns 1 H", prepare_cells, pass_groups, .columns = 1},
    {"groups, sorted every 2 steps", prepare_cells, pass_groups, .columns = 4, .steps = 2},
    {"groups, sorted every 4 steps", prepare_cells, pass_groups, .columns = 4, .steps = 4},
    {"groups, sorted every 8 steps", prepare_cells, pass_groups, .columns = 4, .steps = 8},
    {"groups, packed blocks", prepare_packed, pass_packed, .columns = 4, .packed = true},
    {0}};
