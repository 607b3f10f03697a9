/* SPDX-License-Identifier: MIT */
/** @file fitted_pair.h
 *  What a neighbour or a wall adds to the sums of a fit: fitted.h has the equations. No loops over particles. */
#ifndef SPH2D_METHODS_FITTED_FITTED_PAIR_H
#define SPH2D_METHODS_FITTED_FITTED_PAIR_H

#include <math.h>

#include "kernels/kernel.h"
#include "methods/common/group.h"
#include "methods/common/state_equation.h"
#include "methods/fitted/fitted.h"

/* Sums over the neighbours of a particle: moments of order 1 to 4 of (xi, eta), the concentration gradient, then the
 * differences of u, v and rho, by themselves and times each basis function. */
enum {
    M10,
    M01,
    M20,
    M11,
    M02,
    M30,
    M21,
    M12,
    M03,
    M40,
    M31,
    M22,
    M13,
    M04,
    GRAD_C_X,
    GRAD_C_Y,
    FIELDS,
    FIELD_SUMS = 6, /* sum w df, then b_1 to b_5 */
    SUMS = FIELDS + 3 * FIELD_SUMS
};

/** The sums of a group, each particle's in a lane. */
typedef struct fit_sums {
    sph2d__lanes of[SUMS];
} fit_sums;

/** The matrix A of the normal equations, its lower triangle row by row. */
enum { MATRIX = 15 };

/** Constants of a pass. */
typedef struct constants {
    const sph2d__store *liquid;
    sph2d__real inverse_support; /**< 1/H [1/m] */
    sph2d__real value_scale;     /**< 1/f(dx/H) of Wendland's C2, times the fourth root of 0.2 */
    double grad_c_scale;         /**< 140/pi (dx/H)^2 */
    double viscosity;            /**< kinematic [m^2/s] */
} constants;

/* ---- liquid ------------------------------------------------------------------------------------------------------ */

/** From the particles of a group to a candidate, in units of H, and 1 - q, at least 0. */
typedef struct offset {
    sph2d__lanes x, y, t;
} offset;

SPH2D__INLINE offset offset_to(sph2d__lanes x, sph2d__lanes y)
{
    return (offset){x, y, sph2d__above_zero(1 - sph2d__lanes_sqrt(x * x + y * y))};
}

/** Adds the differences d of a field, weighted by w. */
SPH2D__INLINE void add_field(fit_sums *to, int field, const offset *at, sph2d__lanes w, sph2d__lanes d)
{
    sph2d__lanes *b = to->of + FIELDS + field * FIELD_SUMS;
    sph2d__lanes wd = w * d, xd = wd * at->x, yd = wd * at->y;
    b[0] += wd;
    b[1] += xd;
    b[2] += yd;
    b[3] += xd * at->x;
    b[4] += xd * at->y;
    b[5] += yd * at->y;
}

/** Adds the moments and the concentration gradient. */
SPH2D__INLINE void add_moments(fit_sums *to, sph2d__lanes x, sph2d__lanes y, sph2d__lanes t, const constants *k)
{
    sph2d__lanes t2 = t * t, w = t2 * t, value = t2 * t2 * (5 * k->value_scale - 4 * k->value_scale * t);
    value *= value;
    sph2d__lanes wx = w * x, wy = w * y, factor = 1 + value * value;
    sph2d__lanes wxx = wx * x, wxy = wx * y, wyy = wy * y;
    sph2d__lanes w30 = wxx * x, w21 = wxx * y, w12 = wyy * x, w03 = wyy * y;
    to->of[M10] += wx;
    to->of[M01] += wy;
    to->of[M20] += wxx;
    to->of[M11] += wxy;
    to->of[M02] += wyy;
    to->of[M30] += w30;
    to->of[M21] += w21;
    to->of[M12] += w12;
    to->of[M03] += w03;
    to->of[M40] += w30 * x;
    to->of[M31] += w30 * y;
    to->of[M22] += w21 * y;
    to->of[M13] += w03 * x;
    to->of[M04] += w03 * y;
    to->of[GRAD_C_X] += factor * wx;
    to->of[GRAD_C_Y] += factor * wy;
}

/* ---- walls ------------------------------------------------------------------------------------------------------- */

/** Adds a point of a no-slip surface, where the velocity is known, to the velocity sums of a lane. */
static void add_surface(fit_sums *sums, int lane, double x, double y, const double known[2])
{
    double q2 = x * x + y * y;
    if (q2 >= 1)
        return;
    double t = 1 - sqrt(q2), w = t * t * t;
    double basis[6] = {1, x, y, x * x, x * y, y * y};
    double moments[14] = {
        x,         y,         x * x,         x * y,         y * y,         x * x * x,     x * x * y,
        x * y * y, y * y * y, x * x * x * x, x * x * x * y, x * x * y * y, x * y * y * y, y * y * y * y};
    for (int n = 0; n < 14; ++n)
        sums->of[M10 + n][lane] += (sph2d__real)(w * moments[n]);
    for (int v = 0; v < 2; ++v)
        for (int n = 0; n < FIELD_SUMS; ++n)
            sums->of[FIELDS + v * FIELD_SUMS + n][lane] += (sph2d__real)(w * basis[n] * known[v]);
}

/** Adds the density gradient along a wall's normal to the equations of a lane: pressure balances the body force and the
 *  wall's acceleration. */
static void add_normal_gradient(fit_sums *sums, sph2d__lanes matrix[MATRIX], int lane, double x, double y, double nx,
                                double ny, double known)
{
    double q2 = x * x + y * y;
    if (q2 >= 1)
        return;
    double t = 1 - sqrt(q2), w = GRADIENT_WEIGHT * t * t * t;
    double basis[5] = {nx, ny, 2 * x * nx, x * ny + y * nx, 2 * y * ny};
    for (int a = 0, n = 0; a < 5; ++a) {
        for (int b = 0; b <= a; ++b, ++n) /* n++ below would count twice: a bug of GCC 12 */
            matrix[n][lane] += (sph2d__real)(w * basis[a] * basis[b]);
        sums->of[FIELDS + 2 * FIELD_SUMS + 1 + a][lane] += (sph2d__real)(w * basis[a] * known);
    }
}

/** Adds boundary particle b at (x, y) from particle i [m]: to the concentration gradient, and, if it is in the first
 *  layer, the velocity and density gradient of the point of the surface in front of it. */
static void add_wall(const sph2d__system *s, size_t i, size_t b, double x, double y, const constants *k, fit_sums *sums,
                     fit_sums *velocity_sums, sph2d__lanes matrix[MATRIX], int lane)
{
    const sph2d__store *w = &s->walls, *f = &s->fluid;
    double q = sqrt(x * x + y * y) * k->inverse_support;
    if (q < 1) {
        double value = sph2d__kernel_value_at(SPH2D_KERNEL_WENDLAND_C2, q) * k->value_scale, t = 1 - q;
        double weight = t * t * t * (1 + value * value * value * value) * k->inverse_support;
        sums->of[GRAD_C_X][lane] += (sph2d__real)(weight * x);
        sums->of[GRAD_C_Y][lane] += (sph2d__real)(weight * y);
    }
    if (w->depth[b] > FIRST_LAYER * s->spacing)
        return;
    sph2d_vec2 surface = sph2d__surface_velocity(s, b);
    double known[2] = {surface.x - f->vx[i], surface.y - f->vy[i]};
    double foot_x = (x + w->depth[b] * w->normal_x[b]) * k->inverse_support;
    double foot_y = (y + w->depth[b] * w->normal_y[b]) * k->inverse_support;
    add_surface(velocity_sums, lane, foot_x, foot_y, known);
    double gradient = sph2d__fitted_slope(s, b, f->density[i], (sph2d_vec2){f->x[i], f->y[i]});
    add_normal_gradient(sums, matrix, lane, foot_x, foot_y, w->normal_x[b], w->normal_y[b], gradient);
}

#endif
