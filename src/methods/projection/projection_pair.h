/* SPDX-License-Identifier: MIT */
/** @file projection_pair.h
 *  What a pair of particles adds to the sums of projection.h, and what becomes of a particle when all is summed. No
 *  loops; every lane is a particle with a neighbour of its own. */
#ifndef SPH2D_METHODS_PROJECTION_PROJECTION_PAIR_H
#define SPH2D_METHODS_PROJECTION_PROJECTION_PAIR_H

#include "kernels/kernel.h"
#include "methods/common/shortest.h"
#include "methods/projection/limited_viscosity_pair.h"
#include "methods/projection/projection.h"
#include "methods/terms/viscosity.h"

/* ---- density, gradients and viscosity ---------------------------------------------------------------------------- */

/** The particles of a slice and what is summed over their pairs. */
typedef struct slice {
    sph2d__lanes x, y, vx, vy;
    sph2d__lanes value;  /* f(q), weighted */
    sph2d__lanes square; /* of |G|, of boundary particles */
    sph2d__drag drag;
    gradient_sums gradient;
} slice;

/** What the sums over the pairs with one store need. */
typedef struct weights {
    double support, slope;
    sph2d__lanes weight; /* c m/rho0, or c/rho0 with masses given */
    const double *mass;  /* of each boundary particle; NULL: in the weight */
    bool viscous;        /* the velocities differ: drag */
    bool limited;        /* and their gradients are wanted */
    const sph2d__store *from;
    const sph2d__period *period;
} weights;

/** Adds the neighbours at `index` and returns their gradients G. */
SPH2D__INLINE sph2d__float2 gather_pair(slice *sum, const weights *w, sph2d_kernel kernel, const uint32_t *index)
{
    const sph2d__store *from = w->from;
    sph2d__lanes dx = sph2d__shortest(sum->x - sph2d__lanes_gather(from->x, index), w->period->length_x);
    sph2d__lanes dy = sph2d__shortest(sum->y - sph2d__lanes_gather(from->y, index), w->period->length_y);
    sph2d__lanes q = sph2d__lanes_sqrt(dx * dx + dy * dy) * (1 / w->support), share = w->weight;
    if (w->mass)
        share *= sph2d__lanes_gather(w->mass, index);
    sph2d__lanes g = share * w->slope * sph2d__kernel_slope(kernel, q), gx = g * dx, gy = g * dy;
    sum->value += share * sph2d__kernel_value(kernel, q);
    if (!w->mass)
        sum->square += gx * gx + gy * gy;
    if (w->viscous || w->limited) {
        sph2d__lanes ux = sum->vx - sph2d__lanes_gather(from->vx, index);
        sph2d__lanes uy = sum->vy - sph2d__lanes_gather(from->vy, index);
        if (w->viscous)
            sph2d__drag_add(&sum->drag, g, ux, uy);
        if (w->limited)
            gradient_pair(&sum->gradient, gx, gy, dx, dy, ux, uy);
    }
    return sph2d__float2_of(gx, gy);
}

/** Acceleration without pressure of the particle in lane l of a slice. */
SPH2D__INLINE void finish_acceleration(sph2d__system *s, size_t i, const slice *sum, int l)
{
    double drag = 2 * (s->viscosity / s->rest_density);
    double ax = drag * sum->drag.x[l], ay = drag * sum->drag.y[l];
    sph2d__forces_add(&s->forces, (sph2d__place){sum->x[l], sum->y[l], sum->vx[l], sum->vy[l]}, &ax, &ay);
    s->fluid.ax[i] = ax;
    s->fluid.ay[i] = ay;
}

/** Density of the fluid particles `first` on of a slice. */
SPH2D__INLINE void finish_fluid(sph2d__system *s, size_t first, const slice *sum, sph2d_kernel kernel)
{
    double h2 = s->support * s->support, own = s->calibration * s->mass / s->rest_density;
    sph2d__lanes all = sum->value + own * sph2d__kernel_value_at(kernel, 0);
    sph2d__lanes_store(s->fluid.density + first, s->rest_density * sph2d__kernel_constant(kernel) / h2 * all);
}

/** What liquid adds at boundary particle b, g_b, as a density, and the diagonal: `near` of its neighbours are liquid. */
SPH2D__INLINE void finish_wall(sph2d__system *s, size_t b, const slice *sum, int l, sph2d_kernel kernel, bool near)
{
    sph2d__store *w = &s->walls;
    double h2 = s->support * s->support;
    double added = sph2d__kernel_constant(kernel) / h2 * s->mass / w->mass[b] * sum->value[l];
    w->density[b] = s->rest_density * (1 + (near ? added - w->filled[b] : 0));
    w->diagonal[b] = sum->square[l];
}

/* ---- D and its transpose ----------------------------------------------------------------------------------------- */

/** (y_i + y_j) G_ij: a pair's part of D' y, in floats as good as the gradients. */
SPH2D__INLINE sph2d__float2 transpose_pair(sph2d__float2 own, sph2d__float2 other, sph2d__float2 gradient)
{
    return (own + other) * gradient;
}

/* ---- reported pressure ------------------------------------------------------------------------------------------- */

/** Sums of a linear least-squares fit around the particles of a slice: w = 1 - q, distances in units of H, pressures
 *  from the particle's own. */
typedef struct mean_sums {
    sph2d__lanes weight, x, y, xx, xy, yy;
    sph2d__lanes p, px, py;
} mean_sums;

/** Adds neighbours at (dx, dy) from the particles, in units of H, whose pressure is `dp` above theirs. */
SPH2D__INLINE void mean_pair(mean_sums *sum, sph2d__lanes dx, sph2d__lanes dy, sph2d__lanes dp)
{
    sph2d__lanes w = sph2d__above_zero(1 - sph2d__lanes_sqrt(dx * dx + dy * dy));
    sph2d__lanes wx = w * dx, wy = w * dy;
    sum->weight += w;
    sum->x += wx;
    sum->y += wy;
    sum->xx += wx * dx;
    sum->xy += wx * dy;
    sum->yy += wy * dy;
    sum->p += w * dp;
    sum->px += wx * dp;
    sum->py += wy * dp;
}

/** What the fit's value at the particle in lane l is above its own pressure; of the plain mean where the neighbours are
 *  on a line. */
SPH2D__INLINE double finish_mean(const mean_sums *sum, int l)
{
    const double min_condition = 0.01; /* det/tr^2 is 0.25 inside and 0.1 at a flat surface */
    double weight = 1 + sum->weight[l], x = sum->x[l], y = sum->y[l], p = sum->p[l];
    double xx = sum->xx[l], xy = sum->xy[l], yy = sum->yy[l], det = xx * yy - xy * xy;
    if (!(det > min_condition * (xx + yy) * (xx + yy)))
        return p / weight;
    double ux = (yy * x - xy * y) / det, uy = (xx * y - xy * x) / det;
    return (p - ux * (double)sum->px[l] - uy * (double)sum->py[l]) / (weight - ux * x - uy * y);
}

/* ---- density at the end of a step -------------------------------------------------------------------------------- */

/** f(q) for particles that will be at (x, y), and at (jx, jy). */
SPH2D__INLINE sph2d__lanes value_at(const sph2d__system *s, sph2d__lanes x, sph2d__lanes y, sph2d__lanes jx,
                                    sph2d__lanes jy, sph2d_kernel kernel)
{
    const sph2d__period *period = &s->fluid_cells.period;
    sph2d__lanes dx = sph2d__shortest(x - jx, period->length_x), dy = sph2d__shortest(y - jy, period->length_y);
    return sph2d__kernel_value(kernel, sph2d__lanes_sqrt(dx * dx + dy * dy) * (1 / s->support));
}

/** m_b f(q) of the boundary particles at `b`, moved on by their velocities over the step. */
SPH2D__INLINE sph2d__lanes wall_value_at(const sph2d__system *s, sph2d__lanes x, sph2d__lanes y, const uint32_t *b,
                                         sph2d_kernel kernel)
{
    const sph2d__store *w = &s->walls;
    sph2d__lanes jx = sph2d__lanes_gather(w->x, b) + s->step * sph2d__lanes_gather(w->vx, b);
    sph2d__lanes jy = sph2d__lanes_gather(w->y, b) + s->step * sph2d__lanes_gather(w->vy, b);
    return sph2d__lanes_gather(w->mass, b) * value_at(s, x, y, jx, jy, kernel);
}

/** Factor that makes a density over rest density of masses times f(q). */
static inline double density_scale(const sph2d__system *s, sph2d_kernel kernel)
{
    return s->calibration * sph2d__kernel_constant(kernel) / (s->support * s->support * s->rest_density);
}

#endif
