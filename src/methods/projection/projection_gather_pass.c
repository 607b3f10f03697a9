/* SPDX-License-Identifier: MIT */
/** @file projection_gather_pass.c
 *  Finds the neighbours of methods with a pressure that follows from density, and sums what does not change while the
 *  pressure is solved for. Compiled once for each instruction set, named by SPH2D__ISA, and in it once for each kernel.
 *  Neighbours are searched for one particle after another, a block of candidates at a time; what is summed over them
 *  is summed for a slice of particles at once. */
#include "methods/common/slices.h"
#include "methods/projection/projection_pair.h"

/* ---- sums -------------------------------------------------------------------------------------------------------- */

/** Sums over `slots` slots whose pairs begin at `at`, and keeps their gradients. */
SPH2D__INLINE void sum_slots(sph2d__neighbours *n, size_t at, uint32_t slots, const weights *w, sph2d_kernel kernel,
                             slice *to)
{
    slice sum = *to;
    for (uint32_t k = 0; k < slots; ++k, at += SPH2D__LANES)
        sph2d__float2_store(n->gradient + at, gather_pair(&sum, w, kernel, n->index + at));
    *to = sum;
}

/** Everything about the fluid particles `first` on of a slice. */
SPH2D__INLINE void gather_slice(sph2d__system *s, sph2d__pairs *to, size_t first, sph2d_kernel kernel)
{
    sph2d__neighbours *n = &s->neighbours;
    sph2d__store *f = &s->fluid;
    sph2d__slice *at = &n->slices[first / SPH2D__LANES];
    double h2 = s->support * s->support, own = s->calibration * s->mass / s->rest_density;
    slice sum = {sph2d__lanes_load(f->x + first), sph2d__lanes_load(f->y + first), sph2d__lanes_load(f->vx + first),
                 sph2d__lanes_load(f->vy + first), .value = {0}};
    weights w = {.support = s->support,
                 .slope = sph2d__kernel_constant(kernel) / (h2 * h2),
                 .weight = (sph2d__lanes){0} + own,
                 .viscous = s->viscosity > 0,
                 .limited = sph2d__limited_viscosity_of(s) > 0,
                 .from = f,
                 .period = &s->fluid_cells.period};
    *at = (sph2d__slice){.begin = to->next};
    sph2d__pairs_search(to, &to->fluid, &s->fluid_cells, f, f, first, h2, true, NULL);
    at->fluid = sph2d__pairs_write(n, to, f->count);
    sum_slots(n, at->begin, at->fluid, &w, kernel, &sum);
    bool limited = w.limited;
    if (s->walls_press) {
        w.weight = (sph2d__lanes){0} + s->calibration / s->rest_density;
        w.mass = s->walls.mass;
        w.from = &s->walls;
        w.viscous = w.limited = false;
        sph2d__pairs_search(to, &to->walls, &s->wall_cells, &s->walls, f, first, h2, false, NULL);
        at->walls = sph2d__pairs_write(n, to, s->walls.count);
        sum_slots(n, at->begin + (size_t)at->fluid * SPH2D__LANES, at->walls, &w, kernel, &sum);
    }
    if (limited)
        finish_gradient(f, first, &sum.gradient, s->rest_density);
    finish_fluid(s, first, &sum, kernel);
    for (int l = 0; l < SPH2D__LANES && first + (size_t)l < f->count; ++l)
        finish_acceleration(s, first + (size_t)l, &sum, l);
}

/** Everything about boundary particles `first` on: their pairs where they have rows, and what liquid adds there. */
SPH2D__INLINE void gather_walls(sph2d__system *s, sph2d__pairs *to, size_t first, sph2d_kernel kernel)
{
    sph2d__neighbours *n = &s->wall_neighbours;
    sph2d__store *w = &s->walls;
    sph2d__slice *at = &n->slices[first / SPH2D__LANES];
    double h2 = s->support * s->support;
    sph2d__lanes mass = sph2d__lanes_load(w->mass + first);
    slice sum = {sph2d__lanes_load(w->x + first), sph2d__lanes_load(w->y + first), .value = {0}};
    weights weigh = {.support = s->support,
                     .slope = sph2d__kernel_constant(kernel) / (h2 * h2),
                     .weight = s->calibration / s->rest_density * mass,
                     .from = &s->fluid,
                     .period = &s->fluid_cells.period};
    *at = (sph2d__slice){.begin = to->next};
    sph2d__pairs_search(to, &to->fluid, &s->fluid_cells, &s->fluid, w, first, h2, false, w->filled);
    at->fluid = sph2d__pairs_write(n, to, s->fluid.count);
    sum_slots(n, at->begin, at->fluid, &weigh, kernel, &sum);
    for (int l = 0; l < SPH2D__LANES && first + (size_t)l < w->count; ++l)
        finish_wall(s, first + (size_t)l, &sum, l, kernel, to->counts[l] > 0);
}

/* ---- one for every kernel ---------------------------------------------------------------------------------------- */

/** Gathers for the particles of slab k. False when it is full. */
SPH2D__INLINE bool gather_slab(sph2d__system *s, bool walls, size_t k, sph2d_kernel kernel)
{
    sph2d__pairs to = sph2d__pairs_start(walls ? &s->wall_neighbours : &s->neighbours, k);
    size_t count = walls ? s->walls.count : s->fluid.count;
    size_t end = (k + 1) * SPH2D__SLAB < count ? (k + 1) * SPH2D__SLAB : count;
    for (size_t i = k * SPH2D__SLAB; i < end && !to.full; i += SPH2D__LANES) {
        if (walls)
            gather_walls(s, &to, i, kernel);
        else
            gather_slice(s, &to, i, kernel);
    }
    return !to.full;
}

#define FOR_KERNEL(name, word)                                                                                         \
    static bool fluid_##word(sph2d__system *s, size_t k)                                                               \
    {                                                                                                                  \
        return gather_slab(s, false, k, SPH2D_KERNEL_##name);                                                          \
    }                                                                                                                  \
    static bool walls_##word(sph2d__system *s, size_t k)                                                               \
    {                                                                                                                  \
        return gather_slab(s, true, k, SPH2D_KERNEL_##name);                                                           \
    }
SPH2D_KERNEL_MAP(FOR_KERNEL)

#define FLUID_ENTRY(name, word) [SPH2D_KERNEL_##name] = fluid_##word,
#define WALLS_ENTRY(name, word) [SPH2D_KERNEL_##name] = walls_##word,
const sph2d__projection_gather_pass SPH2D__OF_ISA(sph2d__projection_gather) = {
    .lanes = SPH2D__LANES, .fluid = {SPH2D_KERNEL_MAP(FLUID_ENTRY)}, .walls = {SPH2D_KERNEL_MAP(WALLS_ENTRY)}};
