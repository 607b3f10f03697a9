/* SPDX-License-Identifier: MIT */
/** @file transfer_pass.c
 *  Velocities from the particles to the grid of method `hybrid`, and back: hybrid.h has the equations. Compiled once for
 *  each instruction set, named by SPH2D__ISA. */
#include <string.h>

#include "methods/hybrid/grid.h"
#include "sim/stages.h"

/* ---- to the grid ------------------------------------------------------------------------------------------------- */

/** Four and eight floats, and the same at any place. */
typedef sph2d__quad quad;
typedef float pair __attribute__((vector_size(32)));
typedef float any_quad __attribute__((vector_size(16), aligned(4), may_alias));
typedef float any_pair __attribute__((vector_size(32), aligned(4), may_alias));

/** Bilinear weights of two neighbours, in as many floats each, by the place between them. */
static inline quad weights_of(float part)
{
    return (quad){1, 1, 0, 0} + part * (quad){-1, -1, 1, 1};
}

/** Rows of the grid, from `first` to `last` - 1. */
typedef struct band {
    const sph2d__grid *grid;
    int first, last;
} band;

static inline bool has(const band *b, int row)
{
    return row >= b->first && row < b->last;
}

/** Velocity of a particle, and its slopes a square further on: APIC (Jiang, Schroeder, Selle, Teran & Stomakhin, The affine
 *  particle-in-cell method, ACM TOG 34 (2015) 51). */
typedef struct motion {
    float u, v, u_x, u_y, v_x, v_y;
} motion;

/** Adds a velocity, `value` at the left one of two faces, to a row of the band; it grows from face to face by `slope`. */
static inline void add_faces(const band *b, sph2d__pair2 *sums, int row, int column, quad weights, float value,
                             float slope)
{
    if (has(b, row))
        *(any_quad *)(sums + sph2d__at(b->grid, column, row)) += weights * (quad){value, 1, value + slope, 1};
}

static inline void add_middles(const band *b, int row, int column, pair weighted)
{
    if (has(b, row))
        *(any_pair *)(b->grid->sums.middle + sph2d__at(b->grid, column, row)) += weighted;
}

/** Adds a particle at (x, y), in squares, to those of the rows around it that are the band's. */
static inline void add_particle(const band *b, float x, float y, const motion *p, quad m)
{
    const sph2d__sums *to = &b->grid->sums;
    const int i = (int)(x + 0.5F), j = (int)(y + 0.5F); /* middles of row j are at j - 1/2 ... */
    const float right = x + 0.5F - (float)i, up = y + 0.5F - (float)j;
    const int face_i = (int)x + 1, face_j = (int)y + 1; /* ... lower faces at j - 1 */
    const float beside = x + 1 - (float)face_i, above = y + 1 - (float)face_j;
    const quad across = weights_of(beside), along = weights_of(right);
    const float u = p->u - beside * p->u_x - up * p->u_y, v = p->v - right * p->v_x - above * p->v_y;
    const pair middles = (pair){1, 1, 1, 1, 0, 0, 0, 0} + right * (pair){-1, -1, -1, -1, 1, 1, 1, 1};
    const pair weighted = middles * (pair){m[0], m[1], m[2], m[3], m[0], m[1], m[2], m[3]};
    add_faces(b, to->x, j, face_i, (1 - up) * across, u, p->u_x);
    add_faces(b, to->x, j + 1, face_i, up * across, u + p->u_y, p->u_x);
    add_middles(b, j, i, (1 - up) * weighted);
    add_middles(b, j + 1, i, up * weighted);
    add_faces(b, to->y, face_j, i, (1 - above) * along, v, p->v_x);
    add_faces(b, to->y, face_j + 1, i, above * along, v + p->v_y, p->v_x);
}

/** The row of cells at y, in squares above the domain's lower side. */
static size_t row_at(const sph2d__cells *c, const sph2d__grid *g, double y)
{
    const double row = (g->low_y + y / g->inverse_y - c->origin_y) * c->inverse_y;
    return row > 0 ? row < c->ny - 1.0 ? (size_t)row : c->ny - 1 : 0;
}

static void sum(const sph2d_sim *sim, int first, int last, double dt)
{
    const sph2d__system *s = &sim->system;
    const sph2d__store *f = &s->fluid;
    const sph2d__grid *g = s->grid;
    const band b = {g, first, last};
    const float pressing = (float)(dt / s->rest_density), unit = (float)(1 / s->rest_density);
    const float nx = (float)g->nx, ny = (float)g->ny, hx = g->hx, hy = g->hy;
    const sph2d__cells *c = &s->fluid_cells;
    if (c->nx == 0 || c->ny == 0)
        return;
    const size_t end = c->start[(row_at(c, g, last - 0.5) + 1) * c->nx];
    for (size_t i = c->start[row_at(c, g, first - 2.0) * c->nx]; i < end; ++i) {
        const float x = (float)((f->x[i] - g->low_x) * g->inverse_x), y = (float)((f->y[i] - g->low_y) * g->inverse_y);
        if (!(x >= 0 && x <= nx && y >= 0 && y <= ny))
            continue;
        const float stretch = (float)f->stretch[i], shear = (float)f->shear[i], rotation = (float)f->rotation[i];
        const motion p = {(float)f->vx[i],         (float)f->vy[i],         hx * stretch,
                          hy * (shear - rotation), hx * (shear + rotation), -hy * stretch};
        add_particle(&b, x, y, &p,
                     (sph2d__quad){1, unit * (float)f->density[i] - 1, pressing * (float)f->pressure[i], 0});
    }
}

/* ---- back -------------------------------------------------------------------------------------------------------- */

/* Bounds of the displacements by particles and by the grid in a step [spacings]. */
static const double MOST_OF_ORDER = 0.2, MOST_OF_GRID = 0.3;

/** What the grid says at a place, along one axis. */
typedef struct reading {
    float value, displacement; /**< means over the faces that say something [m/s, m] */
    float known;               /**< their weight */
    float off_x, off_y;        /**< their middle, from the place [m] */
    float dx, dy;              /**< slopes of the velocity [1/s], */
    bool has_dx, has_dy;       /**< where faces on both sides say something */
} reading;

/** Reads between four faces of which some are not known. */
static reading read_some(const sph2d__grid *g, const sph2d__quad *low, float a, float b, sph2d__quad mean)
{
    const sph2d__quad *high = low + g->stride;
    const float known = mean[SPH2D__KNOWN];
    if (!(known > 0.01F))
        return (reading){0};
    const sph2d__quad one = mean / known;
    reading r = {.value = one[SPH2D__NEW], .displacement = one[SPH2D__DISPLACEMENT], .known = known};
    const float is[4] = {low[0][SPH2D__KNOWN], low[1][SPH2D__KNOWN], high[0][SPH2D__KNOWN], high[1][SPH2D__KNOWN]};
    const float dx[2] = {(1 - b) * is[0] * is[1], b * is[2] * is[3]},
                dy[2] = {(1 - a) * is[0] * is[2], a * is[1] * is[3]};
    r.has_dx = dx[0] + dx[1] > 0.01F;
    r.has_dy = dy[0] + dy[1] > 0.01F;
    if (r.has_dx)
        r.dx =
            (dx[0] * (low[1][SPH2D__NEW] - low[0][SPH2D__NEW]) + dx[1] * (high[1][SPH2D__NEW] - high[0][SPH2D__NEW])) /
            ((dx[0] + dx[1]) * g->hx);
    if (r.has_dy)
        r.dy =
            (dy[0] * (high[0][SPH2D__NEW] - low[0][SPH2D__NEW]) + dy[1] * (high[1][SPH2D__NEW] - low[1][SPH2D__NEW])) /
            ((dy[0] + dy[1]) * g->hy);
    r.off_x = (a * ((1 - b) * is[1] + b * is[3]) / known - a) * g->hx;
    r.off_y = (b * ((1 - a) * is[2] + a * is[3]) / known - b) * g->hy;
    return r;
}

/** Reads at column `x` and row `y` of the faces. */
static inline reading read_at(const sph2d__grid *g, const sph2d__quad *faces, float x, float y)
{
    const int i = (int)x, j = (int)y;
    const float a = x - (float)i, b = y - (float)j;
    const sph2d__quad *low = faces + (size_t)j * g->stride + (size_t)i, *high = low + g->stride;
    const sph2d__quad below = low[1] - low[0], above = high[1] - high[0];
    const sph2d__quad left = low[0] + a * below, up = high[0] + a * above - left, mean = left + b * up;
    const float unit_x = (float)g->inverse_x, unit_y = (float)g->inverse_y;
    if ((low[0] * low[1] * high[0] * high[1])[SPH2D__KNOWN] > 0)
        return (reading){.value = mean[SPH2D__NEW],
                         .displacement = mean[SPH2D__DISPLACEMENT],
                         .known = 1,
                         .dx = unit_x * (below + b * (above - below))[SPH2D__NEW],
                         .dy = unit_y * up[SPH2D__NEW],
                         .has_dx = true,
                         .has_dy = true};
    return read_some(g, low, a, b, mean);
}

/** Slopes of the velocity (u, v) at a particle [1/s]. */
typedef struct slopes {
    double u_x, u_y, v_x, v_y;
} slopes;

/** The slopes from the grid. One that it does not know, at a surface, is that without divergence, or that with which the
 *  particle keeps its rotation: without viscosity liquid does (Helmholtz). */
static inline slopes slopes_of(const reading *u, const reading *v, double rotation)
{
    slopes s = {(double)u->dx, (double)u->dy, (double)v->dx, (double)v->dy};
    if (!u->has_dx && v->has_dy)
        s.u_x = -s.v_y;
    if (!v->has_dy && u->has_dx)
        s.v_y = -s.u_x;
    if (!u->has_dy && v->has_dx)
        s.u_y = s.v_x - 2 * rotation;
    if (!v->has_dx && u->has_dy)
        s.v_x = s.u_y + 2 * rotation;
    return s;
}

/* In this form it is two instructions; fmax and fmin are calls. */
static inline double within(double bound, double value)
{
    const double low = value > -bound ? value : -bound;
    return low < bound ? low : bound;
}

/** The pressure at a place of the grid, in units of q; air has none. */
static float pressure_at(const sph2d__grid *g, float x, float y)
{
    const int i = (int)x, j = (int)y;
    const float a = x - (float)i, b = y - (float)j;
    const float *at = g->q + sph2d__at(g, i, j);
    const float low = at[0] + a * (at[1] - at[0]), high = at[g->stride] + a * (at[g->stride + 1] - at[g->stride]);
    return low + b * (high - low);
}

/** Where no pressure acts, a displacement e that keeps a particle from where its velocity takes it stops that velocity, by
 *  at most e/dt: else particles that lie on others would fall for ever, and get faster. */
static inline void stop(sph2d__batch *w, size_t k, double e_x, double e_y, double part, double dt)
{
    const double e2 = e_x * e_x + e_y * e_y, against = -(w->vx[k] * e_x + w->vy[k] * e_y);
    if (!(against > 0 && e2 > 0))
        return;
    const double change = part * (against < e2 / dt ? against / e2 : 1 / dt);
    w->vx[k] += change * e_x;
    w->vy[k] += change * e_y;
}

/** What the grid says at the particles of a batch. */
typedef struct taken {
    double u_x[SPH2D__BATCH], u_y[SPH2D__BATCH], v_x[SPH2D__BATCH], v_y[SPH2D__BATCH]; /**< slopes [1/s] */
    double e_x[SPH2D__BATCH], e_y[SPH2D__BATCH];                                       /**< displacements [m] */
    double inside[SPH2D__BATCH];                                                       /**< 1 in liquid, 0 in spray */
    double q[SPH2D__BATCH];
} taken;

/** Velocity, its slopes and more of particle k of a batch, which is at (x, y) in squares. */
static inline void take(const sph2d_sim *sim, sph2d__batch *w, size_t k, float x, float y, taken *t)
{
    const sph2d__grid *g = sim->system.grid;
    const reading ru = read_at(g, g->face_x, x + 1, y + 0.5F), rv = read_at(g, g->face_y, x + 0.5F, y + 1);
    const slopes s =
        ru.known > 0 && rv.known > 0 ? slopes_of(&ru, &rv, sim->system.fluid.rotation[w->first + k]) : (slopes){0};
    if (ru.known > 0)
        w->vx[k] = (double)ru.value - s.u_x * (double)ru.off_x - s.u_y * (double)ru.off_y;
    if (rv.known > 0)
        w->vy[k] = (double)rv.value - s.v_x * (double)rv.off_x - s.v_y * (double)rv.off_y;
    t->u_x[k] = s.u_x;
    t->u_y[k] = s.u_y;
    t->v_x[k] = s.v_x;
    t->v_y[k] = s.v_y;
    t->e_x[k] = (double)ru.displacement;
    t->e_y[k] = (double)rv.displacement;
    const double known = 4 * (double)(ru.known + rv.known) - 1;
    t->inside[k] = known > 1 ? 1 : known > 0 ? known : 0;
    t->q[k] = (double)pressure_at(g, x + 0.5F, y + 0.5F);
}

/** Sets slopes, pressures and displacements of a batch. Liquid moves by the new velocity: by the mean of both, waves would
 *  grow by (omega dt)^2/4 a step. Spray falls on parabolas. */
static void set_displacements(const sph2d_sim *sim, double dt, sph2d__batch *w, const taken *t)
{
    const sph2d__store *f = &sim->system.fluid;
    const size_t first = w->first;
    const double *restrict ax = f->ax + first, *restrict ay = f->ay + first, *restrict vx = w->vx, *restrict vy = w->vy;
    double *restrict shift_x = f->shift_x + first, *restrict shift_y = f->shift_y + first, *restrict dx = w->dx,
                     *restrict dy = w->dy, *restrict stretch = f->stretch + first, *restrict shear = f->shear + first,
                     *restrict rotation = f->rotation + first, *restrict pressure = f->pressure + first;
    const double of_order = MOST_OF_ORDER * sim->system.spacing, of_grid = MOST_OF_GRID * sim->system.spacing;
    const double pressing = sim->system.rest_density / dt, half = dt / 2;
    for (size_t k = 0; k < w->count; ++k) {
        const double u = vx[k], v = vy[k], inside = t->inside[k], outside = 1 - inside;
        const double u_x = t->u_x[k], u_y = t->u_y[k], v_x = t->v_x[k], v_y = t->v_y[k];
        shift_x[k] = within(of_order, shift_x[k]);
        shift_y[k] = within(of_order, shift_y[k]);
        dx[k] = dt * (u + half * (inside * (u * u_x + v * u_y) - outside * ax[k])) + within(of_grid, t->e_x[k]) +
                shift_x[k];
        dy[k] = dt * (v + half * (inside * (u * v_x + v * v_y) - outside * ay[k])) + within(of_grid, t->e_y[k]) +
                shift_y[k];
        stretch[k] = (u_x - v_y) / 2;
        shear[k] = (u_y + v_x) / 2;
        rotation[k] = (v_x - u_y) / 2;
        pressure[k] = pressing * t->q[k];
    }
}

static void move(sph2d_sim *sim, double dt, sph2d__batch *w)
{
    const sph2d__grid *g = sim->system.grid;
    const sph2d__store *f = &sim->system.fluid;
    taken t = {0};
    memcpy(w->vx, f->vx + w->first, w->count * sizeof *w->vx);
    memcpy(w->vy, f->vy + w->first, w->count * sizeof *w->vy);
    for (size_t k = 0, i = w->first; k < w->count; ++k, ++i) {
        const double x = (f->x[i] - g->low_x) * g->inverse_x, y = (f->y[i] - g->low_y) * g->inverse_y;
        if (x >= 0 && x <= g->nx && y >= 0 && y <= g->ny)
            take(sim, w, k, (float)x, (float)y, &t);
        else
            t.u_x[k] = t.u_y[k] = t.v_x[k] = t.v_y[k] = t.e_x[k] = t.e_y[k] = t.inside[k] = t.q[k] = 0;
    }
    set_displacements(sim, dt, w, &t);
    sph2d__grid_keep_pace(sim, dt, w);
    for (size_t k = 0; k < w->count; ++k)
        if (t.inside[k] < 1)
            stop(w, k, f->shift_x[w->first + k], f->shift_y[w->first + k], 1 - t.inside[k], dt);
}

const sph2d__transfer_passes SPH2D__OF_ISA(sph2d__transfer_passes) = {sum, move};
