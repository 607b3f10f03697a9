/* SPDX-License-Identifier: MIT */
/** @file wcsph_fitted_pass.c
 *  The pair loop of method `wcsph` with fitted operators. Compiled once for each instruction set, named by SPH2D__ISA.
 *
 *  A fit costs so much more than a distance that neighbours are first listed, then summed in full vectors, and the
 *  normal equations of as many particles as there are lanes are solved at once. */
#include "base/pi.h"
#include "kernels/kernel.h"
#include "methods/state_equation.h"
#include "methods/traverse.h"
#include "methods/wcsph_fitted.h"

/* Neighbours that are listed before they are summed. */
enum { LISTED = 64 };

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
    sph2d__lanes a = {0};
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
static void fit_linear(double sums[SUMS][SPH2D__LANES], int lane, int first, int end, fit *out)
{
    double a = sums[M20][lane], b = sums[M11][lane], c = sums[M02][lane], det = a * c - b * b;
    bool sound = det > 1e-6 * (a + c) * (a + c);
    for (int v = first; v < end; ++v) {
        double bx = sums[FIELDS + v * FIELD_SUMS + 1][lane], by = sums[FIELDS + v * FIELD_SUMS + 2][lane];
        out->x[v][lane] = sound ? (c * bx - b * by) / det : 0;
        out->y[v][lane] = sound ? (a * by - b * bx) / det : 0;
        out->laplacian[v][lane] = out->residual[v][lane] = 0;
    }
}

/* A pivot below this part of its diagonal says that the neighbours do not carry the fit. */
static const double SINGULAR = 1e-7;

/** The matrix A of the normal equations, its lower triangle row by row. */
enum { MATRIX = 15 };

/** A of the neighbours alone. */
static void fill_matrix(double sums[SUMS][SPH2D__LANES], double matrix[MATRIX][SPH2D__LANES])
{
    static const unsigned char moment[MATRIX] = {M20, M11, M02, M30, M21, M40, M21, M12,
                                                 M31, M22, M12, M03, M22, M13, M04};
    for (int n = 0; n < MATRIX; ++n)
        memcpy(matrix[n], sums[moment[n]], sizeof matrix[n]);
}

/** Solves the normal equations of all lanes by Cholesky's method, for the fields `first` to `end` - 1. */
static void solve(double sums[SUMS][SPH2D__LANES], double matrix[MATRIX][SPH2D__LANES], int first, int end, fit *out)
{
    sph2d__lanes l[5][5], weakest = (sph2d__lanes){0} + 1.0;
    for (int a = 0; a < 5; ++a)
        for (int b = 0; b <= a; ++b) {
            sph2d__lanes whole = sph2d__lanes_load(matrix[a * (a + 1) / 2 + b]), rest = whole;
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
    for (int v = first; v < end; ++v) {
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
            fit_linear(sums, lane, first, end, out);
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

/* ---- walls ------------------------------------------------------------------------------------------------------- */

/* Boundary particles of the first layer stand for the surface. */
static const double FIRST_LAYER = 0.75;
/* Weight of what a wall knows of the slope of density beside what neighbours say. Without it the slope at a wall is an
 * extrapolation, and a cavity at Re 1000 diverged. */
static const double SLOPE_WEIGHT = 0.1;

/** Adds a point of a no-slip surface to the velocity's sums of a lane: the wall's velocity is known there. */
static void add_surface(double sums[SUMS][SPH2D__LANES], int lane, double x, double y, const double known[2])
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
        sums[M10 + n][lane] += w * moments[n];
    for (int v = 0; v < 2; ++v)
        for (int n = 0; n < FIELD_SUMS; ++n)
            sums[FIELDS + v * FIELD_SUMS + n][lane] += w * basis[n] * known[v];
}

/** Adds what a wall knows of the slope of density to the equations of a lane: along its normal the pressure balances
 * the body force and the wall's acceleration. */
static void add_slope(double sums[SUMS][SPH2D__LANES], double matrix[MATRIX][SPH2D__LANES], int lane, double x,
                      double y, double nx, double ny, double known)
{
    double q2 = x * x + y * y;
    if (q2 >= 1)
        return;
    double t = 1 - sqrt(q2), w = SLOPE_WEIGHT * t * t * t;
    double basis[5] = {nx, ny, 2 * x * nx, x * ny + y * nx, 2 * y * ny};
    for (int a = 0, n = 0; a < 5; ++a) {
        for (int b = 0; b <= a; ++b)
            matrix[n++][lane] += w * basis[a] * basis[b];
        sums[FIELDS + 2 * FIELD_SUMS + 1 + a][lane] += w * basis[a] * known;
    }
}

/** Adds the walls near particle i: all layers to its crowding, the surface to the sums of its velocity. */
static void add_walls(const sph2d__system *s, const sph2d__cursor *cursor, size_t i, const constants *k,
                      double sums[SUMS][SPH2D__LANES], double rough[SUMS][SPH2D__LANES],
                      double matrix[MATRIX][SPH2D__LANES], int lane)
{
    const sph2d__store *w = &s->walls, *f = &s->fluid;
    SPH2D__FOR_NEIGHBOURS (&cursor->ranges, r, b) {
        if (w->bounce[b] >= 0)
            continue;
        double x = w->x[b] - f->x[i] - cursor->ranges.x[r], y = w->y[b] - f->y[i] - cursor->ranges.y[r];
        double q = sqrt(x * x + y * y) * k->inverse_support;
        if (q < 1) {
            double near = sph2d__kernel_value_at(SPH2D_KERNEL_WENDLAND_C2, q) * k->near, t = 1 - q;
            double crowd = t * t * t * (1 + 0.2 * near * near * near * near) * k->inverse_support;
            sums[CROWD_X][lane] += crowd * x;
            sums[CROWD_Y][lane] += crowd * y;
        }
        if (w->depth[b] > FIRST_LAYER * s->spacing)
            continue;
        double known[2] = {w->vx[b] - f->vx[i], w->vy[b] - f->vy[i]};
        double foot_x = (x + w->depth[b] * w->normal_x[b]) * k->inverse_support;
        double foot_y = (y + w->depth[b] * w->normal_y[b]) * k->inverse_support;
        add_surface(rough, lane, foot_x, foot_y, known);
        double gx = -w->ax[b], gy = -w->ay[b];
        sph2d__body_add(&s->body, f->x[i], f->y[i], w->vx[b], w->vy[b], &gx, &gy);
        double slope = f->density[i] / sph2d__sound_speed2_at(s, f->density[i]) * s->support *
                       (gx * w->normal_x[b] + gy * w->normal_y[b]);
        add_slope(sums, matrix, lane, foot_x, foot_y, w->normal_x[b], w->normal_y[b], slope);
    }
}

/* ---- groups of particles ----------------------------------------------------------------------------------------- */

/** Where a thread is. */
typedef struct place {
    sph2d__cursor liquid, walls;
} place;

/** The rates of particles i to i + LANES - 1, as far as there are any. */
static void rates_of_group(sph2d__system *s, place *at, size_t i, const constants *k)
{
    const sph2d__store *f = &s->fluid;
    double sums[SUMS][SPH2D__LANES] __attribute__((aligned(64)));
    double rough[SUMS][SPH2D__LANES] __attribute__((aligned(64)));
    size_t left = f->count - i;
    int lanes = left < SPH2D__LANES ? (int)left : SPH2D__LANES;
    for (int lane = 0; lane < SPH2D__LANES; ++lane) {
        size_t p = i + (size_t)(lane < lanes ? lane : 0);
        sph2d__cursor_move(&at->liquid, &s->fluid_cells, f->x[p], f->y[p]);
        sum_neighbours(s, &at->liquid, p, k, sums, lane);
    }
    double matrix[MATRIX][SPH2D__LANES] __attribute__((aligned(64)));
    fill_matrix(sums, matrix);
    bool walled = false;
    for (int lane = 0; lane < lanes && s->walls_press; ++lane) {
        size_t p = i + (size_t)lane;
        if (!sph2d__cursor_move(&at->walls, &s->wall_cells, f->x[p], f->y[p]))
            continue;
        if (!walled)
            memcpy(rough, sums, sizeof rough);
        walled = true;
        add_walls(s, &at->walls, p, k, sums, rough, matrix, lane);
    }
    fit fits;
    if (walled) {
        solve(sums, matrix, 2, 3, &fits);
        fill_matrix(rough, matrix);
        solve(rough, matrix, 0, 2, &fits);
    } else {
        solve(sums, matrix, 0, 3, &fits);
    }
    for (int lane = 0; lane < lanes; ++lane) {
        double crowd[2] = {k->crowd * sums[CROWD_X][lane], k->crowd * sums[CROWD_Y][lane]};
        finish(s, i + (size_t)lane, &fits, crowd, lane);
    }
}

static void rates(sph2d__system *s, size_t first, size_t last)
{
    double ratio = s->support / s->spacing;
    constants k = {1 / s->support, 140 / (SPH2D__PI * ratio * ratio),
                   1 / sph2d__kernel_value_at(SPH2D_KERNEL_WENDLAND_C2, 1 / ratio)};
    place at = {SPH2D__CURSOR_START, SPH2D__CURSOR_START};
    for (size_t i = first; i < last; i += SPH2D__LANES)
        rates_of_group(s, &at, i, &k);
}

#define NAME_(isa) sph2d__fitted_passes_##isa
#define NAME(isa) NAME_(isa)
const sph2d__fitted_passes NAME(SPH2D__ISA) = {rates};
