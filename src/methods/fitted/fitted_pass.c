/* SPDX-License-Identifier: MIT */
/** @file fitted_pass.c
 *  The pair loop of method `wcsph` with fitted operators. Compiled once for each instruction set and precision, named
 *  by SPH2D__ISA.
 *
 *  A fit costs so much more than a distance that candidates are first listed: those that are not near the box around
 *  a group, a quarter of them, are left out. Normal equations are solved for all particles of a group at once. */
#include <math.h>

#include "base/pi.h"
#include "kernels/kernel.h"
#include "methods/common/group.h"
#include "methods/common/packed.h"
#include "methods/common/state_equation.h"
#include "methods/common/traverse.h"
#include "methods/fitted/fitted.h"

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

/** The sums of a group, each particle's in a lane. */
typedef struct fit_sums {
    sph2d__lanes of[SUMS];
} fit_sums;

/** Constants of a pass. */
typedef struct constants {
    sph2d__packed liquid;
    sph2d__real inverse_support; /**< 1/H [1/m] */
    sph2d__real near;            /**< 1/f(dx/H) of Wendland's C2, times the fourth root of 0.2 */
    double crowd;                /**< 140/pi (dx/H)^2 */
    double viscosity;            /**< kinematic [m^2/s] */
} constants;

/* ---- neighbours -------------------------------------------------------------------------------------------------- */

/* Candidates that are listed before they are summed: more than a group has in liquid at rest. */
enum { LISTED = 128 };

/** Candidates that wait to be summed. */
typedef struct list {
    size_t count;
    uint32_t index[LISTED];
    sph2d__real x[LISTED + 1], y[LISTED + 1]; /**< from the group's first particle, in units of H */
} list;

/** The particles of a group, and the box around them: places in the same units. */
typedef struct receiver {
    sph2d__lanes x, y, vx, vy, density;
    double from_x, from_y;                    /**< the first particle [m] */
    sph2d__real low_x, low_y, high_x, high_y; /**< the box */
} receiver;

/** Lists those of the particles from j on, in range r, that are near the box. */
SPH2D__INLINE void list_block(list *to, const receiver *me, const sph2d__ranges *ranges, int r, size_t j,
                              const constants *k)
{
    const sph2d__real from_x = (sph2d__real)(ranges->x[r] + me->from_x);
    const sph2d__real from_y = (sph2d__real)(ranges->y[r] + me->from_y);
    sph2d__lanes x = (sph2d__lanes_load(k->liquid.x + j) - from_x) * k->inverse_support;
    sph2d__lanes y = (sph2d__lanes_load(k->liquid.y + j) - from_y) * k->inverse_support;
    sph2d__lanes dx = sph2d__above_zero(sph2d__lanes_max(me->low_x - x, x - me->high_x));
    sph2d__lanes dy = sph2d__above_zero(sph2d__lanes_max(me->low_y - y, y - me->high_y));
    unsigned near = sph2d__lanes_which(dx * dx + dy * dy, 1);
    size_t left = ranges->end[r] - j;
    if (left < SPH2D__LANES)
        near &= (1u << left) - 1;
    sph2d__lanes_pack_index(to->index + to->count, (uint32_t)j, near);
    sph2d__lanes_pack(to->x + to->count, x, near);
    sph2d__lanes_pack(to->y + to->count, y, near);
    to->count += (size_t)__builtin_popcount(near);
}

/** A candidate as the particles of a group see it: its place, and 1 - q where that is positive, else 0. */
typedef struct sight {
    sph2d__lanes x, y, t;
} sight;

SPH2D__INLINE sight sight_of(const list *from, size_t n, const receiver *me)
{
    sph2d__lanes x = from->x[n] - me->x, y = from->y[n] - me->y;
    return (sight){x, y, sph2d__above_zero(1 - sph2d__lanes_sqrt(x * x + y * y))};
}

/** Adds the differences d of a field, weighted by w. */
SPH2D__INLINE void add_field(fit_sums *to, int field, const sight *at, sph2d__lanes w, sph2d__lanes d)
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

/** Adds the moments, and the crowding. */
SPH2D__INLINE void add_moments(fit_sums *to, sph2d__lanes x, sph2d__lanes y, sph2d__lanes t, const constants *k)
{
    sph2d__lanes t2 = t * t, w = t2 * t, near = t2 * t2 * (5 * k->near - 4 * k->near * t);
    near *= near;
    sph2d__lanes wx = w * x, wy = w * y, crowd = 1 + near * near;
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
    to->of[CROWD_X] += crowd * wx;
    to->of[CROWD_Y] += crowd * wy;
}

/** Adds the listed candidates to the sums: of the fields in one loop, all others in a second, as all at once need more
 *  registers than there are. The next candidate's root is under way while one is summed: that spares 8 % of the time.
 *  */
static void sum_listed(fit_sums *to, list *from, const receiver *me, const constants *k)
{
    const sph2d__packed *f = &k->liquid;
    sph2d__lanes kept[LISTED];
    fit_sums sums = *to;
    from->x[from->count] = from->y[from->count] = 0;
    sight next = sight_of(from, 0, me);
    for (size_t n = 0; n < from->count; ++n) {
        const size_t j = from->index[n];
        const sight at = next;
        sph2d__lanes w = at.t * at.t * at.t;
        next = sight_of(from, n + 1, me);
        kept[n] = at.t;
        add_field(&sums, 0, &at, w, f->vx[j] - me->vx);
        add_field(&sums, 1, &at, w, f->vy[j] - me->vy);
        add_field(&sums, 2, &at, w, f->density[j] - me->density);
    }
    for (size_t n = 0; n < from->count; ++n)
        add_moments(&sums, from->x[n] - me->x, from->y[n] - me->y, kept[n], k);
    *to = sums;
    from->count = 0;
}

/** All sums of a group over the liquid. */
static void sum_liquid(const sph2d__system *s, const sph2d__group *g, const constants *k, fit_sums *to)
{
    const sph2d__store *f = &s->fluid;
    const size_t i = g->first;
    const double x0 = f->x[i], y0 = f->y[i];
    const sph2d__real unit = k->inverse_support;
    const receiver me = {.x = sph2d__group_lanes(f->x + i, -x0) * unit,
                         .y = sph2d__group_lanes(f->y + i, -y0) * unit,
                         .vx = sph2d__lanes_load(k->liquid.vx + i),
                         .vy = sph2d__lanes_load(k->liquid.vy + i),
                         .density = sph2d__lanes_load(k->liquid.density + i),
                         .from_x = x0,
                         .from_y = y0,
                         .low_x = (sph2d__real)(g->low_x - x0) * unit,
                         .low_y = (sph2d__real)(g->low_y - y0) * unit,
                         .high_x = (sph2d__real)(g->high_x - x0) * unit,
                         .high_y = (sph2d__real)(g->high_y - y0) * unit};
    sph2d__ranges ranges;
    list found;
    found.count = 0;
    for (int n = 0; n < SUMS; ++n)
        to->of[n] = (sph2d__lanes){0};
    sph2d__patch_ranges(&s->fluid_cells, &g->patch, &ranges);
    for (int r = 0; r < ranges.count; ++r)
        for (size_t j = ranges.begin[r]; j < ranges.end[r]; j += SPH2D__LANES) {
            list_block(&found, &me, &ranges, r, j, k);
            if (found.count > LISTED - SPH2D__LANES)
                sum_listed(to, &found, &me, k);
        }
    sum_listed(to, &found, &me, k);
}

/* ---- fits -------------------------------------------------------------------------------------------------------- */

/** Gradient, second derivatives and residual of the three fields, each in units of H. */
typedef struct fit {
    sph2d__lanes x[3], y[3], laplacian[3], residual[3];
} fit;

/** Derivatives of a linear fit, for a particle whose neighbours cannot carry a quadratic one; none where they are all
 *  on one line. */
static void fit_linear(const fit_sums *sums, int lane, int first, int end, fit *out)
{
    double a = sums->of[M20][lane], b = sums->of[M11][lane], c = sums->of[M02][lane], det = a * c - b * b;
    bool sound = det > 1e-6 * (a + c) * (a + c);
    for (int v = first; v < end; ++v) {
        double bx = sums->of[FIELDS + v * FIELD_SUMS + 1][lane], by = sums->of[FIELDS + v * FIELD_SUMS + 2][lane];
        out->x[v][lane] = sound ? (sph2d__real)((c * bx - b * by) / det) : 0;
        out->y[v][lane] = sound ? (sph2d__real)((a * by - b * bx) / det) : 0;
        out->laplacian[v][lane] = out->residual[v][lane] = 0;
    }
}

/* A pivot below this part of its diagonal says that the neighbours do not carry the fit; in floats it may be rounding.
 * And what divisors are never below. */
#ifdef SPH2D__MIXED
static const float SINGULAR = 1e-5F, TINY = 1e-30F;
#else
static const double SINGULAR = 1e-7, TINY = 1e-300;
#endif

/** The matrix A of the normal equations, its lower triangle row by row. */
enum { MATRIX = 15 };

/** A of the neighbours alone. */
static void fill_matrix(const fit_sums *sums, sph2d__lanes matrix[MATRIX])
{
    static const unsigned char moment[MATRIX] = {M20, M11, M02, M30, M21, M40, M21, M12,
                                                 M31, M22, M12, M03, M22, M13, M04};
    for (int n = 0; n < MATRIX; ++n)
        matrix[n] = sums->of[moment[n]];
}

/** Solves the normal equations of all lanes by Cholesky's method without roots, A = L D L^T, for the fields `first` to
 *  `end` - 1. */
static void solve(const fit_sums *sums, int lanes, const sph2d__lanes matrix[MATRIX], int first, int end, fit *out)
{
    sph2d__lanes l[5][5], inverse[5] = {{0}},
                          weakest = sph2d__lanes_all(1); /* above the diagonal of l: L D, transposed */
    for (int a = 0; a < 5; ++a)
        for (int b = 0; b <= a; ++b) {
            sph2d__lanes whole = matrix[a * (a + 1) / 2 + b], rest = whole;
            for (int n = 0; n < b; ++n)
                rest -= l[n][a] * l[b][n];
            if (a == b) {
                sph2d__lanes pivot = sph2d__lanes_max(rest, whole * SINGULAR + TINY);
                weakest = sph2d__lanes_below(pivot - rest, TINY, weakest, (sph2d__lanes){0});
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
        if (weakest[lane] < 0.5)
            fit_linear(sums, lane, first, end, out);
}

/** The rates of a group from its fits. */
static void finish(sph2d__system *s, const sph2d__group *g, const fit_sums *sums, const fit *fits, const constants *k)
{
    sph2d__store *f = &s->fluid;
    const sph2d__real h1 = k->inverse_support, h2 = h1 * h1, most = (sph2d__real)(0.5 * s->speed);
    const sph2d__real diffusion = (sph2d__real)(s->method.density_diffusion / 2 * s->support * s->sound_speed * h2);
    const sph2d__real gain = (sph2d__real)s->residual_gain;
    sph2d__lanes dx[3], dy[3], shift = sph2d__lanes_all(-s->shift_gain * s->speed * k->crowd);
    for (int v = 0; v < 3; ++v) {
        dx[v] = fits->x[v] * h1;
        dy[v] = fits->y[v] * h1;
    }
    sph2d__lanes wx = shift * sums->of[CROWD_X], wy = shift * sums->of[CROWD_Y];
    sph2d__lanes w = sph2d__lanes_sqrt(wx * wx + wy * wy),
                 less = most / sph2d__lanes_max(w, sph2d__lanes_all(most + TINY));
    wx *= less;
    wy *= less;
    sph2d__lanes rho = sph2d__group_lanes(f->density + g->first, 0), nu = sph2d__lanes_all(k->viscosity * h2);
    sph2d__lanes ax = nu * (fits->laplacian[0] + gain * fits->residual[0]);
    sph2d__lanes ay = nu * (fits->laplacian[1] + gain * fits->residual[1]);
    sph2d__lanes rate = diffusion * fits->residual[2] - rho * (dx[0] + dy[1]);
    sph2d__lanes way[3];
    for (int v = 0; v < 3; ++v)
        way[v] = wx * dx[v] + wy * dy[v];
    for (int lane = 0; lane < g->count; ++lane) {
        size_t i = g->first + (size_t)lane;
        double push = -sph2d__sound_speed2_at(s, f->density[i]) / f->density[i];
        double own_ax = ax[lane] + push * dx[2][lane], own_ay = ay[lane] + push * dy[2][lane];
        sph2d__body_add(&s->body, f->x[i], f->y[i], f->vx[i], f->vy[i], &own_ax, &own_ay);
        f->ax[i] = own_ax;
        f->ay[i] = own_ay;
        f->density_rate[i] = rate[lane];
        f->shift_x[i] = wx[lane];
        f->shift_y[i] = wy[lane];
        f->shift_ax[i] = way[0][lane];
        f->shift_ay[i] = way[1][lane];
        f->shift_density_rate[i] = way[2][lane];
    }
}

/* ---- walls ------------------------------------------------------------------------------------------------------- */

/* Boundary particles of the first layer stand for the surface. */
static const double FIRST_LAYER = 0.75;
/* Weight of what a wall knows of the slope of density beside what neighbours say. Without it the slope at a wall is an
 * extrapolation, and a cavity at Re 1000 diverged. */
static const double SLOPE_WEIGHT = 0.1;

/** Adds a point of a no-slip surface to the velocity's sums of a lane: the wall's velocity is known there. */
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

/** Adds what a wall knows of the slope of density to the equations of a lane: along its normal the pressure balances
 *  the body force and the wall's acceleration. */
static void add_slope(fit_sums *sums, sph2d__lanes matrix[MATRIX], int lane, double x, double y, double nx, double ny,
                      double known)
{
    double q2 = x * x + y * y;
    if (q2 >= 1)
        return;
    double t = 1 - sqrt(q2), w = SLOPE_WEIGHT * t * t * t;
    double basis[5] = {nx, ny, 2 * x * nx, x * ny + y * nx, 2 * y * ny};
    for (int a = 0, n = 0; a < 5; ++a) {
        for (int b = 0; b <= a; ++b, ++n) /* n++ below would count twice: a bug of GCC 12 */
            matrix[n][lane] += (sph2d__real)(w * basis[a] * basis[b]);
        sums->of[FIELDS + 2 * FIELD_SUMS + 1 + a][lane] += (sph2d__real)(w * basis[a] * known);
    }
}

/** Adds the walls near particle i: all layers to its crowding, the surface to the sums of its velocity. */
static void add_walls(const sph2d__system *s, const sph2d__cursor *cursor, size_t i, const constants *k, fit_sums *sums,
                      fit_sums *rough, sph2d__lanes matrix[MATRIX], int lane)
{
    const sph2d__store *w = &s->walls, *f = &s->fluid;
    SPH2D__FOR_NEIGHBOURS (&cursor->ranges, r, b) {
        if (w->bounce[b] >= 0)
            continue;
        double x = w->x[b] - f->x[i] - cursor->ranges.x[r], y = w->y[b] - f->y[i] - cursor->ranges.y[r];
        double q = sqrt(x * x + y * y) * k->inverse_support;
        if (q < 1) {
            double near = sph2d__kernel_value_at(SPH2D_KERNEL_WENDLAND_C2, q) * k->near, t = 1 - q;
            double crowd = t * t * t * (1 + near * near * near * near) * k->inverse_support;
            sums->of[CROWD_X][lane] += (sph2d__real)(crowd * x);
            sums->of[CROWD_Y][lane] += (sph2d__real)(crowd * y);
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

/** The rates of a group; `walls` stays where the last particle was. */
static void rates_of_group(sph2d__system *s, const sph2d__group *g, sph2d__cursor *walls, const constants *k)
{
    const sph2d__store *f = &s->fluid;
    fit_sums sums, rough;
    sum_liquid(s, g, k, &sums);
    sph2d__lanes matrix[MATRIX];
    fill_matrix(&sums, matrix);
    bool walled = false;
    for (int lane = 0; lane < g->count && s->walls_press; ++lane) {
        size_t i = g->first + (size_t)lane;
        if (!sph2d__cursor_move(walls, &s->wall_cells, f->x[i], f->y[i]))
            continue;
        if (!walled)
            rough = sums;
        walled = true;
        add_walls(s, walls, i, k, &sums, &rough, matrix, lane);
    }
    fit fits;
    if (walled) {
        solve(&sums, g->count, matrix, 2, 3, &fits);
        fill_matrix(&rough, matrix);
        solve(&rough, g->count, matrix, 0, 2, &fits);
    } else {
        solve(&sums, g->count, matrix, 0, 3, &fits);
    }
    finish(s, g, &sums, &fits, k);
}

static void rates(sph2d__system *s, size_t first, size_t last)
{
    double ratio = s->support / s->spacing;
    const double beside = sph2d__kernel_value_at(SPH2D_KERNEL_WENDLAND_C2, 1 / ratio);
    const constants k = {.liquid = sph2d__packed_of(s, &s->fluid, false),
                         .inverse_support = (sph2d__real)(1 / s->support),
                         .near = (sph2d__real)(pow(0.2, 0.25) / beside),
                         .crowd = 140 / (SPH2D__PI * ratio * ratio),
                         .viscosity = s->viscosity / s->rest_density};
    const sph2d__grouping by = sph2d__grouping_of(&s->fluid, &s->fluid_cells, NULL);
    sph2d__cursor walls = SPH2D__CURSOR_START;
    SPH2D__FOR_GROUPS (&by, g, first, last) {
        sph2d__group_box(&s->fluid, &g);
        rates_of_group(s, &g, &walls, &k);
    }
}

const sph2d__fitted_passes SPH2D__OF_ISA(sph2d__fitted_passes) = {rates};
