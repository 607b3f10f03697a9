/* SPDX-License-Identifier: MIT */
/** @file implicit_close.c
 *  Close pairs, and what walls stop, in the matrix of an implicit step (implicit.c). What is done to velocities after the
 *  solve is not in D: each stop left theta of its neighbours too low, and tension drew the tip of a wedge together. And an
 *  explicit force may be as strong as the head alone in such a step, less than what presses rows of particles together.
 *
 *  The force of a pair at r is F t^2 a mass, t = 1 - r/r0, F = R/(rho0 dx^2), four times the head over dx. With t_0 at the
 *  start, t' where velocities at the start lead to, and e along the pair in the middle,
 *  towards the side on which it began, it is the secant
 *
 *      F (t_0^2 + (t_0 + t') (t_1 - t_0)) = k (r0 t_0^2/(t_0 + t') + r_0 - r_1),  k = F (t_0 + t')/r0
 *
 *  As t^2 is convex it takes at least the energy that the pair stores until t_1 <= t', and where particles part it gives
 *  at most what they had. As p follows from theta,
 *
 *      (w/(dt c0^2) + w^2 E E^T) q = w/dt s (r0 t_0^2/(t_0 + t') + min(r0 - r_0, 0)) + w E(v_0 + w g)
 *      E v = -s e . (v_i - v_j),  s^2 = k/c0^2,  acceleration of i by q: s e q
 *
 *  together with D and p; q has the norm of energy, as p has. A particle's image in an obstacle stops it, a friction by
 *  what is left of its approach at the end: with t in the middle and k = F t/r0,
 *
 *      (w/(dt c0^2) + w^2 E E^T) q = w E(v_0 + w g) - (dt - w) E(v_0)/2,  E v = -2 s n . (v - v_wall)
 *
 *  Conjugate gradients leave p . left + q . left = 0, not each: what a row's force does apart from its equation is friction,
 *  as what pressure does apart from its own is no energy of the liquid; it was up to 0.08 % of a drop's.
 *
 *  Neither draws: rows with q < 0 are dropped, and the rest is solved for once more. Each particle has rows of its own for its
 *  pairs, the same as the other's to the sign: half of each counts. */
#include "methods/wcsph/implicit_close.h"

#include "methods/common/on_device.h"
#include "methods/wcsph/wcsph.h"

/** The most rows that the particles of slab k have. */
static size_t most_of_slab(const sph2d__system *s, size_t k)
{
    size_t most = 0;
    for (size_t i = k * SPH2D__SLAB; i < (k + 1) * SPH2D__SLAB && i < s->fluid.count; ++i)
        most += most_rows(s, i);
    return most;
}

/** Where the rows of each slab of particles begin, and room for all of them. */
bool sph2d__close_reserve(sph2d__system *s)
{
    sph2d__frozen *z = s->frozen;
    const bool away = sph2d__is_on_device(s);
    const uint32_t *counts = away ? sph2d__device_read_by(s, "count_close", NULL, 0, sizeof *counts) : NULL;
    size_t wanted = 0;
    if (away && !counts)
        return false;
    for (size_t k = 0; k < sph2d__slabs(s->fluid.count); ++k) {
        z->close_starts[k] = wanted;
        wanted += away ? counts[k] : most_of_slab(s, k);
    }
    if (away)
        sph2d__host_changed_block(s, z->close_starts);
    if (wanted <= z->close_capacity)
        return true;
    void *block = z->close_rows;
    if (!sph2d__resize(s->memory, &block, z->close_capacity, wanted + wanted / 2, sizeof *z->close_rows))
        return false;
    z->close_rows = block;
    z->close_capacity = wanted + wanted / 2;
    return true;
}

/** One after another within a slab. */
static void find_some(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i)
        find_rows(s, i, i == first ? s->frozen->close_starts[first / SPH2D__SLAB] : s->frozen->end_close[i - 1]);
}

void sph2d__close_find(sph2d__system *s)
{
    sph2d__over_particles(s, s->fluid.count, find_some, "find_close");
}

void sph2d__close_free(sph2d__system *s)
{
    void *rows = s->frozen->close_rows;
    sph2d__release(s->memory, &rows, s->frozen->close_capacity, sizeof *s->frozen->close_rows);
}
