/* SPDX-License-Identifier: MIT */
/** @file newton_rows.c
 *  Each pair once, by Newton's third law, in lanes: what a candidate gets is added to its sums in memory.
 *
 *  Only particles behind one in its own row and those in the row above are met. Blocks of candidates always begin a
 *  multiple of the lanes behind the beginning of their row, so that what one block writes the next one reads whole.
 *  Lanes before and behind a range are too far away to count, as in blocks_rows.c. Threads would need sums of their
 *  own, or to keep apart. */
#include <string.h>

#include "pair.h"

/** The candidates' side: p V^2 instead of pressure, and their sums. */
SPH2D__INLINE void add_both(sums *mine, sums *theirs, const terms *n, const receiver *me, sph2d__lanes volume,
                            const candidate *you, sph2d__lanes g_where, bool masked)
{
    sph2d__lanes dx = me->x - you->x, dy = me->y - you->y, r2 = dx * dx + dy * dy;
    sph2d__lanes g = sph2d__kernel_slope(SPH2D_KERNEL_WENDLAND_C2, sph2d__lanes_sqrt(r2) * n->inverse_support);
    if (masked)
        g = sph2d__lanes_where(g_where, (sph2d__lanes){0}, g);
    sph2d__lanes approach = (me->vx - you->vx) * dx + (me->vy - you->vy) * dy;
    sph2d__lanes spread = (me->density - you->density) * n->diffusion;
    sph2d__lanes stress = me->own + you->pressure;
    stress += approach / sph2d__lanes_max(r2, sph2d__lanes_all(TINY)) * (me->damping * you->volume);
    sph2d__lanes press = g * stress, px = press * dx, py = press * dy;
    mine->flux += g * (approach + spread * you->volume);
    mine->x += px;
    mine->y += py;
    theirs->flux += g * (approach - spread * volume);
    theirs->x -= px;
    theirs->y -= py;
}

SPH2D__INLINE candidate candidates_of(const sph2d__store *s, size_t first)
{
    candidate you = candidates_at(s, first);
    you.pressure *= you.volume * you.volume;
    return you;
}

SPH2D__INLINE sums sums_at(const sph2d__store *s, size_t first)
{
    return (sums){sph2d__lanes_load(s->density_rate + first), sph2d__lanes_load(s->ax + first),
                  sph2d__lanes_load(s->ay + first)};
}

SPH2D__INLINE void keep_sums(sph2d__store *s, size_t first, const sums *from)
{
    sph2d__lanes_store(s->density_rate + first, from->flux);
    sph2d__lanes_store(s->ax + first, from->x);
    sph2d__lanes_store(s->ay + first, from->y);
}

static void clear_sums(sph2d__store *s)
{
    memset(s->density_rate, 0, s->count * sizeof(double));
    memset(s->ax, 0, s->count * sizeof(double));
    memset(s->ay, 0, s->count * sizeof(double));
}

/** The first block of a row that holds `place` or what follows it. */
static inline size_t block_of(size_t place, size_t row)
{
    return place - (place - row) % SPH2D__LANES;
}

/* ---- one particle, candidates in blocks of lanes ----------------------------------------------------------------- */

SPH2D__INLINE void meet_block(sums *mine, sph2d__store *s, const terms *n, const receiver *me, sph2d__lanes volume,
                              size_t first, sph2d__lanes where, bool masked)
{
    candidate you = candidates_of(s, first);
    sums theirs = sums_at(s, first);
    add_both(mine, &theirs, n, me, volume, &you, where, masked);
    keep_sums(s, first, &theirs);
}

static void pass_half_blocks(field *f, const variant *v)
{
    (void)v;
    sph2d__store *s = &f->store;
    const terms n = terms_of(f);
    const sph2d__cells *c = &f->cells;
    const sph2d__lanes none = {0};
    sph2d__lanes lane = {0};
    for (int l = 0; l < SPH2D__LANES; ++l)
        lane[l] = l + 0.5;
    clear_sums(s);
    for (size_t i = 0; i < s->count; ++i) {
        uint32_t cell = c->cell[c->order[i]], row = cell / c->nx;
        const uint32_t *own = c->start + cell, *above = own + c->nx;
        const receiver me = receiver_at(s, &n, i);
        const sph2d__lanes volume = sph2d__lanes_all(s->volume[i]);
        sums sum = {0};
        size_t j = block_of(i, c->start[row * c->nx]);
        meet_block(&sum, s, &n, &me, volume, j, lane - (double)(i - j + 1), true);
        for (j += SPH2D__LANES; j < own[c->columns + 1]; j += SPH2D__LANES)
            meet_block(&sum, s, &n, &me, volume, j, none, false);
        j = block_of(*(above - c->columns), c->start[(row + 1) * c->nx]);
        for (; j < above[c->columns + 1]; j += SPH2D__LANES)
            meet_block(&sum, s, &n, &me, volume, j, none, false);
        write_sums(f, i, s->density_rate[i] + total(sum.flux), s->ax[i] + total(sum.x), s->ay[i] + total(sum.y));
    }
}

/* ---- a particle in each lane, as many candidates at a time ------------------------------------------------------- */

/** Each lane's value goes to the lane before it, the first one's to the last. */
SPH2D__INLINE sph2d__lanes turn(sph2d__lanes a)
{
#if SPH2D__LANES == 2
    return __builtin_shufflevector(a, a, 1, 0);
#elif SPH2D__LANES == 4
    return __builtin_shufflevector(a, a, 1, 2, 3, 0);
#else
    return __builtin_shufflevector(a, a, 1, 2, 3, 4, 5, 6, 7, 0);
#endif
}

/** A group, turned by each number of lanes. */
typedef struct turned {
    receiver me[SPH2D__LANES];
    sph2d__lanes volume[SPH2D__LANES];
} turned;

SPH2D__INLINE void turn_group(const sph2d__store *s, const terms *n, size_t first, size_t count, turned *to)
{
    to->me[0] = receivers_at(s, n, first);
    for (size_t l = count; l < SPH2D__LANES; ++l) /* of the next row: the end of a row's last block may be near it */
        to->me[0].x[l] = -to->me[0].x[l];
    to->volume[0] = sph2d__lanes_load(s->volume + first);
    for (int k = 1; k < SPH2D__LANES; ++k) {
        const receiver *from = &to->me[k - 1];
        to->me[k] = (receiver){turn(from->x),       turn(from->y),   turn(from->vx),     turn(from->vy),
                               turn(from->density), turn(from->own), turn(from->damping)};
        to->volume[k] = turn(to->volume[k - 1]);
    }
}

/** All pairs of a group and a block of candidates: sums of the group are turned with it, those of the block stay. */
SPH2D__INLINE void meet_tile(sums *mine, sph2d__store *s, const terms *n, const turned *group, size_t first)
{
    const candidate you = candidates_of(s, first);
    sums theirs = {0};
    for (int k = 0; k < SPH2D__LANES; ++k) {
        add_both(mine, &theirs, n, &group->me[k], group->volume[k], &you, you.x, false);
        *mine = (sums){turn(mine->flux), turn(mine->x), turn(mine->y)};
    }
    sums had = sums_at(s, first);
    theirs = (sums){had.flux + theirs.flux, had.x + theirs.x, had.y + theirs.y};
    keep_sums(s, first, &theirs);
}

static void pass_tiles(field *f, const variant *v)
{
    (void)v;
    sph2d__store *s = &f->store;
    const terms n = terms_of(f);
    const sph2d__cells *c = &f->cells;
    clear_sums(s);
    for (uint32_t row = 1; row + 1 < c->ny; ++row) {
        const uint32_t *own = c->start + (size_t)row * c->nx, *above = own + c->nx;
        for (size_t i = own[0], count; i < above[0]; i += count) {
            count = above[0] - i < SPH2D__LANES ? above[0] - i : SPH2D__LANES;
            uint32_t left = c->cell[c->order[i]] - row * c->nx - c->columns;
            uint32_t right = c->cell[c->order[i + count - 1]] - row * c->nx + c->columns;
            turned group;
            turn_group(s, &n, i, count, &group);
            sums sum = {0};
            for (size_t j = i; j < i + count; ++j) { /* a group's own pairs are met from both sides */
                candidate you = candidate_at(s, j);
                add_pair(&sum, &n, &group.me[0], &you);
            }
            for (size_t j = i + SPH2D__LANES; j < own[right + 1]; j += SPH2D__LANES)
                meet_tile(&sum, s, &n, &group, j);
            for (size_t j = block_of(above[left], above[0]); j < above[right + 1]; j += SPH2D__LANES)
                meet_tile(&sum, s, &n, &group, j);
            const sums had = sums_at(s, i), done = {had.flux + sum.flux, had.x + sum.x, had.y + sum.y};
            write_lanes(f, i, (int)count, &done);
        }
    }
}

const variant VARIANTS_OF(newton)[] = {
    {"each pair once, blocks", prepare_cells, pass_half_blocks, .columns = 4},
    {"each pair once, groups by blocks (tiles)", prepare_cells, pass_tiles, .columns = 4},
    {"each pair once, tiles, columns 1/8 H", prepare_cells, pass_tiles, .columns = 8},
    {0}};
