/* SPDX-License-Identifier: MIT */
/** @file hybrid_pairs.h
 *  The pair loops of method `hybrid`, in C and in OpenCL C, in floats: files that include it define SPH2D__MIXED. hybrid.h has
 *  the equations. */
#ifndef SPH2D_METHODS_HYBRID_HYBRID_PAIRS_H
#define SPH2D_METHODS_HYBRID_HYBRID_PAIRS_H

#include "kernels/kernel.h"
#include "methods/common/group.h"
#include "methods/hybrid/hybrid_spans.h"

/** What the loops read of a store: places, and two values of each particle. */
typedef struct rows {
    SPH2D__ARRAY const sph2d__real *x, *y, *first, *second;
} rows;

static rows rows_of(const sph2d__store *t)
{
    return (rows){sph2d__floats(t, t->packed_place, 0), sph2d__floats(t, t->packed_place, 1),
                  sph2d__floats(t, t->packed_state, 0), sph2d__floats(t, t->packed_state, 1)};
}

/** The kernel over its constant at a group's distance from (x, y); `weight`, if not NULL, of the particle there. */
SPH2D__INLINE sph2d__lanes value_sum(const sph2d__store *of, const sph2d__group *g, const sph2d__ranges *ranges,
                                     const rows *from, SPH2D__ARRAY const sph2d__real *weight, sph2d__real unit)
{
    sph2d__lanes sum = {0};
    for (int r = 0; from->x && r < ranges->count; ++r) {
        const sph2d__lanes x = sph2d__group_lanes(of->x + g->first, ranges->x[r]);
        const sph2d__lanes y = sph2d__group_lanes(of->y + g->first, ranges->y[r]);
        for (size_t j = ranges->begin[r]; j < ranges->end[r]; ++j) {
            const sph2d__lanes dx = x - from->x[j], dy = y - from->y[j];
            const sph2d__lanes value =
                sph2d__kernel_value(SPH2D_KERNEL_WENDLAND_C2, sph2d__lanes_sqrt(dx * dx + dy * dy) * unit);
            sum += weight ? value * weight[j] : value;
        }
    }
    return sum;
}

/** Sets l and b of particles `first` to first + count - 1, by their density over that at rest. */
SPH2D__INLINE void set_terms(const sph2d__store *f, size_t first, int count, sph2d__lanes relative)
{
    const sph2d__lanes more = relative - 1, deep = sph2d__above_zero(15 * more + (sph2d__real)1.5);
    const sph2d__lanes l = (sph2d__real)0.5 * sph2d__above_zero(more);
    const sph2d__lanes b = -sph2d__lanes_max(-deep, sph2d__lanes_all(-1));
    SPH2D__ARRAY sph2d__real *to_l = sph2d__floats(f, f->packed_state, 0) + first;
    SPH2D__ARRAY sph2d__real *to_b = sph2d__floats(f, f->packed_state, 1) + first;
    for (int k = 0; k < SPH2D__LANES && k < count; ++k) {
        to_l[k] = SPH2D__LANE(l, k);
        to_b[k] = SPH2D__LANE(b, k);
    }
}

/** The density over that at rest is a float: the quotient of one that was stored has its bits. */
static void pack(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__store *f = &s->fluid;
    for (size_t i = first; i < last; i += SPH2D__LANES) {
        sph2d__lanes relative = {0};
        const int count = last - i < SPH2D__LANES ? (int)(last - i) : SPH2D__LANES;
        for (int k = 0; k < count; ++k)
            SPH2D__LANE(relative, k) = (sph2d__real)(f->density[i + (size_t)k] / s->rest_density);
        set_terms(f, i, count, relative);
    }
}

static void density(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    const rows fluid = rows_of(f), walls = rows_of(&s->walls);
    const sph2d__real unit = (sph2d__real)(1 / s->support);
    const sph2d__real full = (sph2d__real)(1 / s->lattice_values);
    const sph2d__grouping by = sph2d__grouping_of(f, &s->fluid_cells, s->walls.count > 0 ? &s->wall_cells : NULL);
    SPH2D__FOR_GROUPS (&by, g, first, last) {
        sph2d__ranges ranges;
        sph2d__patch_ranges(by.cells, &g.patch, &ranges);
        sph2d__lanes sum = value_sum(f, &g, &ranges, &fluid, NULL, unit);
        if (sph2d__group_others(&by, &g, &ranges))
            sum += value_sum(f, &g, &ranges, &walls, walls.first, unit);
        const sph2d__lanes relative = full * sum;
        set_terms(f, g.first, g.count, relative);
        SPH2D__FOR_LANES (g, l)
            f->density[g.first + (size_t)l] = s->rest_density * (double)SPH2D__LANE(relative, l);
    }
}

/** Two values of each particle of a group. */
typedef struct push {
    sph2d__lanes x, y;
} push;

/** How far the places of a group are moved, as those in its store's packed copy. */
SPH2D__INLINE push apart_of(const sph2d__system *s, const sph2d__group *g)
{
    push p = {{0}, {0}};
    SPH2D__FOR_LANES (*g, l) {
        const uint64_t id = s->fluid.id[g->first + (size_t)l];
        SPH2D__LANE(p.x, l) = (sph2d__real)(SPH2D__APART * s->spacing * sph2d__hybrid_jitter(id, 20));
        SPH2D__LANE(p.y, l) = (sph2d__real)(SPH2D__APART * s->spacing * sph2d__hybrid_jitter(id, 40));
    }
    return p;
}

/** Adds grad W over its constant, times a factor. */
SPH2D__INLINE void add_push(push *sum, sph2d__lanes dx, sph2d__lanes dy, sph2d__lanes factor, sph2d__real unit)
{
    const sph2d__lanes t = sph2d__above_zero(1 - sph2d__lanes_sqrt(dx * dx + dy * dy) * unit);
    factor *= t * t * t;
    sum->x += factor * dx;
    sum->y += factor * dy;
}

SPH2D__INLINE void push_by_fluid(push *sum, const sph2d__store *of, const sph2d__group *g, const sph2d__ranges *ranges,
                                 const rows *from, const push *apart, sph2d__real even, sph2d__real unit)
{
    const sph2d__lanes l = sph2d__lanes_load(from->first + g->first);
    const sph2d__lanes b = even * sph2d__lanes_load(from->second + g->first);
    for (int r = 0; r < ranges->count; ++r) {
        const sph2d__lanes x = sph2d__group_lanes(of->x + g->first, ranges->x[r]) + apart->x;
        const sph2d__lanes y = sph2d__group_lanes(of->y + g->first, ranges->y[r]) + apart->y;
        for (size_t j = ranges->begin[r]; j < ranges->end[r]; ++j)
            add_push(sum, x - from->x[j], y - from->y[j], l + from->first[j] + b * from->second[j], unit);
    }
}

SPH2D__INLINE void push_by_walls(push *sum, const sph2d__store *of, const sph2d__group *g, const sph2d__ranges *ranges,
                                 const rows *from, sph2d__lanes factor, sph2d__real unit)
{
    for (int r = 0; r < ranges->count; ++r) {
        const sph2d__lanes x = sph2d__group_lanes(of->x + g->first, ranges->x[r]);
        const sph2d__lanes y = sph2d__group_lanes(of->y + g->first, ranges->y[r]);
        for (size_t j = ranges->begin[r]; j < ranges->end[r]; ++j)
            add_push(sum, x - from->x[j], y - from->y[j], factor * from->first[j], unit);
    }
}

/* The even pressure inside, in units of K. Without it particles settle in lines half a spacing by two spacings apart; from
 * 0.15 on it overshoots (docs/notes/hybrid.md). */
SPH2D__FIXED sph2d__real EVEN = (sph2d__real)0.1;

static void order(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    const rows fluid = rows_of(f), walls = rows_of(&s->walls);
    const sph2d__real unit = (sph2d__real)(1 / s->support);
    const double gradient = s->lattice_slopes;
    if (!fluid.x || !fluid.first || !fluid.second) /* there are no particles */
        return;
    const sph2d__grouping by = sph2d__grouping_of(f, &s->fluid_cells, s->walls.count > 0 ? &s->wall_cells : NULL);
    SPH2D__FOR_GROUPS (&by, g, first, last) {
        sph2d__ranges ranges;
        sph2d__patch_ranges(by.cells, &g.patch, &ranges);
        push sum = {{0}, {0}};
        const push apart = apart_of(s, &g);
        push_by_fluid(&sum, f, &g, &ranges, &fluid, &apart, EVEN, unit);
        if (sph2d__group_others(&by, &g, &ranges))
            push_by_walls(
                &sum, f, &g, &ranges, &walls,
                2 * sph2d__lanes_load(fluid.first + g.first) + EVEN * sph2d__lanes_load(fluid.second + g.first), unit);
        SPH2D__FOR_LANES (g, l) {
            f->shift_x[g.first + (size_t)l] = gradient * (double)SPH2D__LANE(sum.x, l);
            f->shift_y[g.first + (size_t)l] = gradient * (double)SPH2D__LANE(sum.y, l);
        }
    }
}

#endif
