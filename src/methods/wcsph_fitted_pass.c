/* SPDX-License-Identifier: MIT */
/** @file wcsph_fitted_pass.c
 *  The pair loop of method `wcsph` with fitted operators. Compiled once for each instruction set, named by SPH2D__ISA.
 *
 *  A fit costs so much more than a distance that neighbours are first listed, then summed in full vectors, and the
 *  normal equations of as many particles as there are lanes are solved at once. */
#include "base/threads.h"
#include "kernels/kernel.h"
#include "methods/state_equation.h"
#include "methods/traverse.h"
#include "methods/wcsph_fitted.h"

/* Groups of particles that a thread takes at a time; neighbours that are listed before they are summed. */
enum { CHUNK = 32, LISTED = 64 };

/* What is summed over the neighbours of a particle. Moments of order 1 to 4 of (xi, eta), then of the differences of
 * u, v and rho: plain, and with each basis function. */
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
    CROWD_X,
    CROWD_Y,
    FIELDS,
    FIELD_SUMS = 6, /* sum w df, then b_1 to b_5 */
    SUMS = FIELDS + 3 * FIELD_SUMS
};

/** Neighbours of one particle that wait to be summed. */
typedef struct neighbours {
    size_t count;
    double xi[LISTED + SPH2D__LANES], eta[LISTED + SPH2D__LANES];
    uint32_t index[LISTED + SPH2D__LANES];
} neighbours;

/** Constants of a pass. */
typedef struct constants {
    double inverse_support; /**< 1/H [1/m] */
    double crowd;           /**< 140/pi (dx/H)^2 */
    double near;            /**< 1/f(dx/H) of Wendland's C2 */
} constants;

SPH2D__INLINE sph2d__lanes gather(const double *from, const uint32_t *index)
{
    sph2d__lanes a;
    for (int l = 0; l < SPH2D__LANES; ++l)
        a[l] = from[index[l]];
    return a;
}

/** Adds the listed neighbours to the sums. Lanes behind the last are filled with the particle itself, whose distance
 * and differences are zero, as is every term then. */
SPH2D__INLINE void sum_listed(sph2d__lanes *sums, neighbours *list, const sph2d__store *f, size_t i, const constants *k)
{
    for (int l = 0; l < SPH2D__LANES; ++l) {
        list->xi[list->count + (size_t)l] = list->eta[list->count + (size_t)l] = 0;
        list->index[list->count + (size_t)l] = (uint32_t)i;
    }
    const double *values[3] = {f->vx, f->vy, f->density};
    for (size_t n = 0; n < list->count; n += SPH2D__LANES) {
        sph2d__lanes x = sph2d__lanes_load(list->xi + n), y = sph2d__lanes_load(list->eta + n);
        sph2d__lanes xx = x * x, xy = x * y, yy = y * y;
        sph2d__lanes q = sph2d__lanes_sqrt(xx + yy), t = sph2d__above_zero(1 - q), w = t * t * t;
        sph2d__lanes near = sph2d__kernel_value(SPH2D_KERNEL_WENDLAND_C2, q) * k->near;
        near *= near;
        sph2d__lanes crowd = w * (1 + 0.2 * near * near);
        sums[CROWD_X] += crowd * x;
        sums[CROWD_Y] += crowd * y;
        sph2d__lanes wx = w * x, wy = w * y, wxx = w * xx, wxy = w * xy, wyy = w * yy;
        sums[M10] += wx;
        sums[M01] += wy;
        sums[M20] += wxx;
        sums[M11] += wxy;
        sums[M02] += wyy;
        sums[M30] += wxx * x;
        sums[M21] += wxx * y;
        sums[M12] += wyy * x;
        sums[M03] += wyy * y;
        sums[M40] += wxx * xx;
        sums[M31] += wxx * xy;
        sums[M22] += wxx * yy;
        sums[M13] += wyy * xy;
        sums[M04] += wyy * yy;
        for (int v = 0; v < 3; ++v) {
            sph2d__lanes d = gather(values[v], list->index + n) - values[v][i];
            sph2d__lanes *b = sums + FIELDS + v * FIELD_SUMS;
            b[0] += w * d;
            b[1] += wx * d;
            b[2] += wy * d;
            b[3] += wxx * d;
            b[4] += wxy * d;
            b[5] += wyy * d;
        }
    }
    list->count = 0;
}

/** All sums of one particle, into lane `lane` of `out`. */
SPH2D__INLINE void sum_neighbours(const sph2d__system *s, const sph2d__cursor *cursor, size_t i, const constants *k,
                                  double out[SUMS][SPH2D__LANES], int lane)
{
    const sph2d__store *f = &s->fluid;
    neighbours list;
    list.count = 0;
    sph2d__lanes sums[SUMS] = {{0}};
    for (int r = 0; r < cursor->ranges.count; ++r) {
        double xi = f->x[i] + cursor->ranges.x[r], yi = f->y[i] + cursor->ranges.y[r];
        for (uint32_t j = cursor->ranges.begin[r]; j < cursor->ranges.end[r]; ++j) {
            double x = (f->x[j] - xi) * k->inverse_support, y = (f->y[j] - yi) * k->inverse_support;
            list.xi[list.count] = x;
            list.eta[list.count] = y;
            list.index[list.count] = j;
            list.count += x * x + y * y < 1;
            if (list.count == LISTED)
                sum_listed(sums, &list, f, i, k);
        }
    }
    sum_listed(sums, &list, f, i, k);
    for (int n = 0; n < SUMS; ++n)
        out[n][lane] = sph2d__lanes_total(sums[n]);
}

/** Gradient, second derivatives and residual of the three fields, each in units of H. */
typedef struct fit {
    sph2d__lanes x[3], y[3], laplacian[3], residual[3];
} fit;

/** Derivatives of a linear fit, for a particle whose neighbours cannot carry a quadratic one; none where they are all
 * on one line. */
static void fit_linear(double sums[SUMS][SPH2D__LANES], int lane, fit *out)
{
    double a = sums[M20][lane], b = sums[M11][lane], c = sums[M02][lane], det = a * c - b * b;
    bool sound = det > 1e-6 * (a + c) * (a + c);
    for (int v = 0; v < 3; ++v) {
        double bx = sums[FIELDS + v * FIELD_SUMS + 1][lane], by = sums[FIELDS + v * FIELD_SUMS + 2][lane];
        out->x[v][lane] = sound ? (c * bx - b * by) / det : 0;
        out->y[v][lane] = sound ? (a * by - b * bx) / det : 0;
        out->laplacian[v][lane] = out->residual[v][lane] = 0;
    }
}

/* A pivot below this part of its diagonal says that the neighbours do not carry the fit. */
static const double SINGULAR = 1e-7;

/** Solves the normal equations of all lanes by Cholesky's method. */
static void solve(double sums[SUMS][SPH2D__LANES], fit *out)
{
    static const unsigned char moment[5][5] = {
        {M20}, {M11, M02}, {M30, M21, M40}, {M21, M12, M31, M22}, {M12, M03, M22, M13, M04}};
    sph2d__lanes l[5][5], weakest = (sph2d__lanes){0} + 1.0;
    for (int a = 0; a < 5; ++a)
        for (int b = 0; b <= a; ++b) {
            sph2d__lanes whole = sph2d__lanes_load(sums[moment[a][b]]), rest = whole;
            for (int n = 0; n < b; ++n)
                rest -= l[a][n] * l[b][n];
            if (a == b) {
                sph2d__lanes pivot = sph2d__lanes_max(rest, whole * SINGULAR + 1e-300);
                weakest = sph2d__lanes_below(pivot - rest, 1e-300, weakest, (sph2d__lanes){0});
                l[a][a] = 1 / sph2d__lanes_sqrt(pivot);
            } else {
                l[a][b] = rest * l[b][b];
            }
        }
    sph2d__lanes scale =
        4 / sph2d__lanes_max(sph2d__lanes_load(sums[M20]) + sph2d__lanes_load(sums[M02]), (sph2d__lanes){0} + 1e-300);
    for (int v = 0; v < 3; ++v) {
        double(*b)[SPH2D__LANES] = sums + FIELDS + v * FIELD_SUMS;
        sph2d__lanes c[5], residual = sph2d__lanes_load(b[0]);
        for (int a = 0; a < 5; ++a) {
            c[a] = sph2d__lanes_load(b[a + 1]);
            for (int n = 0; n < a; ++n)
                c[a] -= l[a][n] * c[n];
            c[a] *= l[a][a];
        }
        for (int a = 4; a >= 0; --a) {
            for (int n = a + 1; n < 5; ++n)
                c[a] -= l[n][a] * c[n];
            c[a] *= l[a][a];
            residual -= c[a] * sph2d__lanes_load(sums[M10 + a]);
        }
        out->x[v] = c[0];
        out->y[v] = c[1];
        out->laplacian[v] = 2 * (c[2] + c[4]);
        out->residual[v] = residual * scale;
    }
    for (int lane = 0; lane < SPH2D__LANES; ++lane)
        if (weakest[lane] < 0.5)
            fit_linear(sums, lane, out);
}

/** The rates of one particle from its fit. */
static void finish(sph2d__system *s, size_t i, const fit *fits, const double crowd[2], int lane)
{
    sph2d__store *f = &s->fluid;
    double h1 = 1 / s->support, h2 = h1 * h1;
    double dx[3], dy[3], laplacian[3];
    for (int v = 0; v < 3; ++v) {
        dx[v] = fits->x[v][lane] * h1;
        dy[v] = fits->y[v][lane] * h1;
        laplacian[v] = (fits->laplacian[v][lane] + s->residual_gain * fits->residual[v][lane]) * h2;
    }
    double shift = -s->shift_gain * s->speed, most = 0.5 * s->speed;
    double wx = shift * crowd[0], wy = shift * crowd[1], w = sqrt(wx * wx + wy * wy);
    double less = w > most ? most / w : 1;
    f->shift_x[i] = wx *= less;
    f->shift_y[i] = wy *= less;
    double rho = f->density[i], push = -sph2d__sound_speed2_at(s, rho) / rho, nu = s->viscosity / s->rest_density;
    double ax = push * dx[2] + nu * laplacian[0] + wx * dx[0] + wy * dy[0];
    double ay = push * dy[2] + nu * laplacian[1] + wx * dx[1] + wy * dy[1];
    sph2d__body_add(&s->body, f->x[i], f->y[i], f->vx[i], f->vy[i], &ax, &ay);
    f->ax[i] = ax;
    f->ay[i] = ay;
    double diffusion = s->method.density_diffusion / 2 * s->support * s->sound_speed * fits->residual[2][lane] * h2;
    f->density_rate[i] = -rho * (dx[0] + dy[1]) + wx * dx[2] + wy * dy[2] + diffusion;
}

/** The rates of particles i to i + LANES - 1, as far as there are any. */
static void rates_of_group(sph2d__system *s, sph2d__cursor *cursor, size_t i, const constants *k)
{
    const sph2d__store *f = &s->fluid;
    double sums[SUMS][SPH2D__LANES] __attribute__((aligned(64)));
    size_t left = f->count - i;
    int lanes = left < SPH2D__LANES ? (int)left : SPH2D__LANES;
    for (int lane = 0; lane < SPH2D__LANES; ++lane) {
        size_t p = i + (size_t)(lane < lanes ? lane : 0);
        sph2d__cursor_move(cursor, &s->fluid_cells, f->x[p], f->y[p]);
        sum_neighbours(s, cursor, p, k, sums, lane);
    }
    fit fits;
    solve(sums, &fits);
    for (int lane = 0; lane < lanes; ++lane) {
        double crowd[2] = {k->crowd * sums[CROWD_X][lane], k->crowd * sums[CROWD_Y][lane]};
        finish(s, i + (size_t)lane, &fits, crowd, lane);
    }
}

static void rates(sph2d__system *s)
{
    size_t groups = (s->fluid.count + SPH2D__LANES - 1) / SPH2D__LANES;
    double ratio = s->support / s->spacing;
    const double pi = 3.14159265358979323846;
    constants k = {1 / s->support, 140 / (pi * ratio * ratio),
                   1 / sph2d__kernel_value_at(SPH2D_KERNEL_WENDLAND_C2, 1 / ratio)};
    int threads = sph2d__threads_for(s->threads, s->fluid.count);
#pragma omp parallel num_threads(threads) if (threads > 1)
    {
        sph2d__cursor cursor = SPH2D__CURSOR_START;
#pragma omp for schedule(dynamic, CHUNK)
        for (size_t g = 0; g < groups; ++g)
            rates_of_group(s, &cursor, g * SPH2D__LANES, &k);
    }
}

#define NAME_(isa) sph2d__fitted_passes_##isa
#define NAME(isa) NAME_(isa)
const sph2d__fitted_passes NAME(SPH2D__ISA) = {rates};
