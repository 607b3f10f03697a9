/* SPDX-License-Identifier: MIT */
/** @file fitted_solve.h
 *  From the sums of fitted_pair.h to derivatives, for all particles of a group at once, and from these to rates. */
#ifndef SPH2D_METHODS_FITTED_FITTED_SOLVE_H
#define SPH2D_METHODS_FITTED_FITTED_SOLVE_H

#include "methods/fitted/fitted_pair.h"

/* ---- fits -------------------------------------------------------------------------------------------------------- */

/** Gradient, second derivatives and residual of the three fields, each in units of H. */
typedef struct fit {
    sph2d__lanes x[3], y[3], laplacian[3], residual[3];
} fit;

/** Derivatives of a linear fit, for a particle whose neighbours do not determine a quadratic one; zero if they are all
 *  on one line. */
static void fit_linear(const fit_sums *sums, int lane, int first, int end, fit *out)
{
    double a = sums->of[M20][lane], b = sums->of[M11][lane], c = sums->of[M02][lane], det = a * c - b * b;
    bool invertible = det > 1e-6 * (a + c) * (a + c);
    for (int v = first; v < end; ++v) {
        double bx = sums->of[FIELDS + v * FIELD_SUMS + 1][lane], by = sums->of[FIELDS + v * FIELD_SUMS + 2][lane];
        out->x[v][lane] = invertible ? (sph2d__real)((c * bx - b * by) / det) : 0;
        out->y[v][lane] = invertible ? (sph2d__real)((a * by - b * bx) / det) : 0;
        out->laplacian[v][lane] = out->residual[v][lane] = 0;
    }
}

/* Least pivot over its diagonal element: below, the neighbours do not determine the fit. And the lower bound of divisors. */
static const double MIN_PIVOT = 1e-7, TINY = 1e-300;

/** Sets the matrix A from the moments. */
static void fill_matrix(const fit_sums *sums, sph2d__lanes matrix[MATRIX])
{
    static const unsigned char moment[MATRIX] = {M20, M11, M02, M30, M21, M40, M21, M12,
                                                 M31, M22, M12, M03, M22, M13, M04};
    for (int n = 0; n < MATRIX; ++n)
        matrix[n] = sums->of[moment[n]];
}

/** Solves the normal equations of all lanes by Cholesky's method without square roots, A = L D L^T, for the fields
 *  `first` to `end` - 1. */
static void solve(const fit_sums *sums, int lanes, const sph2d__lanes matrix[MATRIX], int first, int end, fit *out)
{
    sph2d__lanes l[5][5], inverse[5] = {{0}},
                          regular = sph2d__lanes_all(1); /* above the diagonal of l: L D, transposed */
    for (int a = 0; a < 5; ++a)
        for (int b = 0; b <= a; ++b) {
            sph2d__lanes element = matrix[a * (a + 1) / 2 + b], rest = element;
            for (int n = 0; n < b; ++n)
                rest -= l[n][a] * l[b][n];
            if (a == b) {
                sph2d__lanes pivot = sph2d__lanes_max(rest, element * MIN_PIVOT + TINY);
                regular = sph2d__lanes_below(pivot - rest, TINY, regular, (sph2d__lanes){0});
                inverse[a] = 1 / pivot;
            } else {
                l[b][a] = rest;
                l[a][b] = rest * inverse[b];
            }
        }
    sph2d__lanes scale = 4 / sph2d__lanes_max(sums->of[M20] + sums->of[M02], sph2d__lanes_all(TINY));
    for (int v = first; v < end; ++v) {
        const sph2d__lanes *b = sums->of + FIELDS + v * FIELD_SUMS;
        sph2d__lanes c[5], residual = b[0];
        for (int a = 0; a < 5; ++a) {
            c[a] = b[a + 1];
            for (int n = 0; n < a; ++n)
                c[a] -= l[a][n] * c[n];
        }
        for (int a = 4; a >= 0; --a) {
            c[a] *= inverse[a];
            for (int n = a + 1; n < 5; ++n)
                c[a] -= l[n][a] * c[n];
            residual -= c[a] * sums->of[M10 + a];
        }
        out->x[v] = c[0];
        out->y[v] = c[1];
        out->laplacian[v] = 2 * (c[2] + c[4]);
        out->residual[v] = residual * scale;
    }
    for (int lane = 0; lane < lanes; ++lane)
        if (regular[lane] < 0.5)
            fit_linear(sums, lane, first, end, out);
}

/** Sets the rates of a group from its fits. */
static void finish(sph2d__system *s, const sph2d__group *g, const fit_sums *sums, const fit *fits, const constants *k)
{
    sph2d__store *f = &s->fluid;
    const sph2d__real h1 = k->inverse_support, h2 = h1 * h1, max_shift = (sph2d__real)(0.5 * s->speed);
    const sph2d__real diffusion = (sph2d__real)(s->method.density_diffusion / 2 * s->support * s->sound_speed * h2);
    const sph2d__real gain = (sph2d__real)s->residual_gain;
    sph2d__lanes dx[3], dy[3], shift = sph2d__lanes_all(-s->shift_gain * s->speed * k->grad_c_scale);
    for (int v = 0; v < 3; ++v) {
        dx[v] = fits->x[v] * h1;
        dy[v] = fits->y[v] * h1;
    }
    sph2d__lanes wx = shift * sums->of[GRAD_C_X], wy = shift * sums->of[GRAD_C_Y];
    sph2d__lanes w = sph2d__lanes_sqrt(wx * wx + wy * wy),
                 factor = max_shift / sph2d__lanes_max(w, sph2d__lanes_all(max_shift + TINY));
    wx *= factor;
    wy *= factor;
    sph2d__lanes rho = sph2d__group_lanes(f->density + g->first, 0), nu = sph2d__lanes_all(k->viscosity * h2);
    sph2d__lanes ax = nu * (fits->laplacian[0] + gain * fits->residual[0]);
    sph2d__lanes ay = nu * (fits->laplacian[1] + gain * fits->residual[1]);
    sph2d__lanes rate = diffusion * fits->residual[2] - rho * (dx[0] + dy[1]);
    sph2d__lanes advection[3];
    for (int v = 0; v < 3; ++v)
        advection[v] = wx * dx[v] + wy * dy[v];
    for (int lane = 0; lane < g->count; ++lane) {
        size_t i = g->first + (size_t)lane;
        double push = -(s->sound_speed * s->sound_speed) / f->density[i];
        double own_ax = ax[lane] + push * dx[2][lane], own_ay = ay[lane] + push * dy[2][lane];
        sph2d__forces_add(&s->forces, (sph2d__place){f->x[i], f->y[i], f->vx[i], f->vy[i]}, &own_ax, &own_ay);
        f->ax[i] = own_ax;
        f->ay[i] = own_ay;
        f->density_rate[i] = rate[lane];
        f->shift_x[i] = wx[lane];
        f->shift_y[i] = wy[lane];
        f->shift_ax[i] = advection[0][lane];
        f->shift_ay[i] = advection[1][lane];
        f->shift_density_rate[i] = advection[2][lane];
    }
}

#endif
