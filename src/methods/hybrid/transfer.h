/* SPDX-License-Identifier: MIT */
/** @file transfer.h
 *  Velocities of a particle to the grid of method `hybrid`, and back, in C and in OpenCL C: hybrid.h has the equations. */
#ifndef SPH2D_METHODS_HYBRID_TRANSFER_H
#define SPH2D_METHODS_HYBRID_TRANSFER_H

#include "methods/hybrid/target.h"
#include "sim/displaced.h"

/* ---- to the grid ------------------------------------------------------------------------------------------------- */

/** Bilinear weights of two neighbours, in as many floats each, by the place between them. */
static inline sph2d__quad weights_of(float part)
{
    return SPH2D__QUAD(1, 1, 0, 0) + part * SPH2D__QUAD(-1, -1, 1, 1);
}

/** Velocity of a particle, and its slopes a square further on: APIC (Jiang, Schroeder, Selle, Teran & Stomakhin, The affine
 *  particle-in-cell method, ACM TOG 34 (2015) 51). */
typedef struct motion {
    float u, v, u_x, u_y, v_x, v_y;
} motion;

/** A velocity, `value` at the left one of two faces, and its weights: it grows from face to face by `slope`. */
static inline sph2d__quad faces_of(sph2d__quad weights, float value, float slope)
{
    return weights * SPH2D__QUAD(value, 1, value + slope, 1);
}

/** Adds a particle at (x, y), in squares, to those around it that are the target's. */
static inline void add_particle(sph2d__target *to, float x, float y, const motion *p, sph2d__quad m)
{
    const int i = (int)(x + 0.5F), j = (int)(y + 0.5F); /* middles of row j are at j - 1/2 ... */
    const float right = x + 0.5F - (float)i, up = y + 0.5F - (float)j;
    const int face_i = (int)x + 1, face_j = (int)y + 1; /* ... lower faces at j - 1 */
    const float beside = x + 1 - (float)face_i, above = y + 1 - (float)face_j;
    const sph2d__quad across = weights_of(beside), along = weights_of(right);
    const float u = p->u - beside * p->u_x - up * p->u_y, v = p->v - right * p->v_x - above * p->v_y;
    const sph2d__oct middles = SPH2D__OCT(1, 1, 1, 1, 0, 0, 0, 0) + right * SPH2D__OCT(-1, -1, -1, -1, 1, 1, 1, 1);
    const sph2d__oct weighted =
        middles * SPH2D__OCT(SPH2D__PART(m, 0), SPH2D__PART(m, 1), SPH2D__PART(m, 2), SPH2D__PART(m, 3),
                             SPH2D__PART(m, 0), SPH2D__PART(m, 1), SPH2D__PART(m, 2), SPH2D__PART(m, 3));
    sph2d__add_left(to, j, face_i, faces_of((1 - up) * across, u, p->u_x));
    sph2d__add_left(to, j + 1, face_i, faces_of(up * across, u + p->u_y, p->u_x));
    sph2d__add_middles(to, j, i, (1 - up) * weighted);
    sph2d__add_middles(to, j + 1, i, up * weighted);
    sph2d__add_lower(to, face_j, i, faces_of((1 - above) * along, v, p->v_x));
    sph2d__add_lower(to, face_j + 1, i, faces_of(above * along, v + p->v_y, p->v_x));
}

/** The row of cells at y, in squares above the grid's lower side. */
static inline size_t row_at(const sph2d__cells *c, const sph2d__grid *g, double y)
{
    const double row = (g->low_y + y / g->inverse_y - c->origin_y) * c->inverse_y;
    return row > 0 ? row < c->ny - 1.0 ? (size_t)row : c->ny - 1 : 0;
}

/** The column of cells at x. */
static inline size_t column_at(const sph2d__cells *c, const sph2d__grid *g, double x)
{
    const double column = (g->low_x + x / g->inverse_x - c->origin_x) * c->inverse_x;
    return column > 0 ? column < c->nx - 1.0 ? (size_t)column : c->nx - 1 : 0;
}

/** Rows of cells with the particles that touch rows `first` to `last` - 1 of the grid: from *begin to *end. */
static inline void rows_touching(const sph2d__cells *c, const sph2d__grid *g, int first, int last, size_t *begin,
                                 size_t *end)
{
    *begin = row_at(c, g, first - 2.0);
    *end = row_at(c, g, last - 0.5);
}

/** What makes weights and pressures of the grid of those of particles. */
typedef struct units {
    float density, pressure; /**< 1/rho0, dt/rho0 */
} units;

static inline units units_of(const sph2d__system *s, double dt)
{
    return (units){(float)(1 / s->rest_density), (float)(dt / s->rest_density)};
}

/** Adds particle i. */
static inline void add_one(const sph2d__system *s, units unit, size_t i, sph2d__target *to)
{
    const sph2d__grid *g = s->grid;
    const sph2d__store *f = &s->fluid;
    const float x = (float)((f->x[i] - g->low_x) * g->inverse_x), y = (float)((f->y[i] - g->low_y) * g->inverse_y);
    if (!(x >= 0 && x <= (float)g->nx && y >= 0 && y <= (float)g->ny))
        return;
    const float stretch = (float)f->stretch[i], shear = (float)f->shear[i], rotation = (float)f->rotation[i];
    const motion p = {
        (float)f->vx[i], (float)f->vy[i], g->hx * stretch, g->hy * (shear - rotation), g->hx * (shear + rotation),
        -g->hy * stretch};
    add_particle(to, x, y, &p,
                 SPH2D__QUAD(1, unit.density * (float)f->density[i] - 1, unit.pressure * (float)f->pressure[i], 0));
}

/* ---- back -------------------------------------------------------------------------------------------------------- */

/* Bounds of the displacements by particles and by the grid in a step [spacings]. */
SPH2D__FIXED double MOST_OF_ORDER = 0.2, MOST_OF_GRID = 0.3;

/** What the grid says at a place, along one axis. */
typedef struct reading {
    float value, displacement; /**< means over the faces that say something [m/s, m] */
    float known;               /**< their weight */
    float off_x, off_y;        /**< their middle, from the place [m] */
    float dx, dy;              /**< slopes of the velocity [1/s], */
    bool has_dx, has_dy;       /**< where faces on both sides say something */
} reading;

/** Reads between four faces of which some are not known. */
static inline reading read_some(const sph2d__grid *g, SPH2D__ARRAY const sph2d__quad *low, float a, float b,
                                sph2d__quad mean)
{
    SPH2D__ARRAY const sph2d__quad *high = low + g->stride;
    const float known = SPH2D__KNOWN(mean);
    if (!(known > 0.01F))
        return (reading){0};
    const sph2d__quad one = mean / known;
    reading r = {.value = SPH2D__NEW(one), .displacement = SPH2D__DISPLACEMENT(one), .known = known};
    const float is[4] = {SPH2D__KNOWN(low[0]), SPH2D__KNOWN(low[1]), SPH2D__KNOWN(high[0]), SPH2D__KNOWN(high[1])};
    const float dx[2] = {(1 - b) * is[0] * is[1], b * is[2] * is[3]},
                dy[2] = {(1 - a) * is[0] * is[2], a * is[1] * is[3]};
    r.has_dx = dx[0] + dx[1] > 0.01F;
    r.has_dy = dy[0] + dy[1] > 0.01F;
    if (r.has_dx)
        r.dx =
            (dx[0] * (SPH2D__NEW(low[1]) - SPH2D__NEW(low[0])) + dx[1] * (SPH2D__NEW(high[1]) - SPH2D__NEW(high[0]))) /
            ((dx[0] + dx[1]) * g->hx);
    if (r.has_dy)
        r.dy =
            (dy[0] * (SPH2D__NEW(high[0]) - SPH2D__NEW(low[0])) + dy[1] * (SPH2D__NEW(high[1]) - SPH2D__NEW(low[1]))) /
            ((dy[0] + dy[1]) * g->hy);
    r.off_x = (a * ((1 - b) * is[1] + b * is[3]) / known - a) * g->hx;
    r.off_y = (b * ((1 - a) * is[2] + a * is[3]) / known - b) * g->hy;
    return r;
}

/** Reads at column `x` and row `y` of the faces. */
static inline reading read_at(const sph2d__grid *g, SPH2D__ARRAY const sph2d__quad *faces, float x, float y)
{
    const int i = (int)x, j = (int)y;
    const float a = x - (float)i, b = y - (float)j;
    SPH2D__ARRAY const sph2d__quad *low = faces + (size_t)j * g->stride + (size_t)i, *high = low + g->stride;
    const sph2d__quad below = low[1] - low[0], above = high[1] - high[0];
    const sph2d__quad left = low[0] + a * below, up = high[0] + a * above - left, mean = left + b * up;
    const float unit_x = (float)g->inverse_x, unit_y = (float)g->inverse_y;
    if (SPH2D__KNOWN(low[0] * low[1] * high[0] * high[1]) > 0)
        return (reading){.value = SPH2D__NEW(mean),
                         .displacement = SPH2D__DISPLACEMENT(mean),
                         .known = 1,
                         .dx = unit_x * SPH2D__NEW(below + b * (above - below)),
                         .dy = unit_y * SPH2D__NEW(up),
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
static inline float pressure_at(const sph2d__grid *g, float x, float y)
{
    const int i = (int)x, j = (int)y;
    const float a = x - (float)i, b = y - (float)j;
    SPH2D__ARRAY const float *at = g->q + sph2d__at(g, i, j);
    const float low = at[0] + a * (at[1] - at[0]), high = at[g->stride] + a * (at[g->stride + 1] - at[g->stride]);
    return low + b * (high - low);
}

/** Where no pressure acts, a displacement e that keeps a particle from where its velocity takes it stops that velocity, by
 *  at most e/dt: else particles that lie on others would fall for ever, and get faster. */
static inline void stop(sph2d_vec2 *v, double e_x, double e_y, double part, double dt)
{
    const double e2 = e_x * e_x + e_y * e_y, against = -(v->x * e_x + v->y * e_y);
    if (!(against > 0 && e2 > 0))
        return;
    const double change = part * (against < e2 / dt ? against / e2 : 1 / dt);
    v->x += change * e_x;
    v->y += change * e_y;
}

/** What the grid says at a particle. */
typedef struct taken {
    double u_x, u_y, v_x, v_y; /**< slopes [1/s] */
    double e_x, e_y;           /**< displacements [m] */
    double inside;             /**< 1 in liquid, 0 in spray */
    double q;
} taken;

/** This at particle i, and its velocity there. */
static inline taken take(const sph2d__system *s, size_t i, sph2d_vec2 *velocity)
{
    const sph2d__grid *g = s->grid;
    const sph2d__store *f = &s->fluid;
    const double at_x = (f->x[i] - g->low_x) * g->inverse_x, at_y = (f->y[i] - g->low_y) * g->inverse_y;
    if (!(at_x >= 0 && at_x <= g->nx && at_y >= 0 && at_y <= g->ny))
        return (taken){0};
    const float x = (float)at_x, y = (float)at_y;
    const reading ru = read_at(g, g->face_x, x + 1, y + 0.5F), rv = read_at(g, g->face_y, x + 0.5F, y + 1);
    const slopes by = ru.known > 0 && rv.known > 0 ? slopes_of(&ru, &rv, f->rotation[i]) : (slopes){0};
    if (ru.known > 0)
        velocity->x = (double)ru.value - by.u_x * (double)ru.off_x - by.u_y * (double)ru.off_y;
    if (rv.known > 0)
        velocity->y = (double)rv.value - by.v_x * (double)rv.off_x - by.v_y * (double)rv.off_y;
    const double known = 4 * (double)(ru.known + rv.known) - 1;
    const double inside = known > 1 ? 1 : known > 0 ? known : 0;
    return (taken){by.u_x,
                   by.u_y,
                   by.v_x,
                   by.v_y,
                   (double)ru.displacement,
                   (double)rv.displacement,
                   inside,
                   (double)pressure_at(g, x + 0.5F, y + 0.5F)};
}

/** What a move has the same for all particles: its length [s], bounds [m], the pressure of q. */
typedef struct pace {
    double dt, of_order, of_grid, pressing;
} pace;

static inline pace pace_of(const sph2d__system *s, double dt)
{
    return (pace){dt, MOST_OF_ORDER * s->spacing, MOST_OF_GRID * s->spacing, s->rest_density / dt};
}

/** The displacement of particle i by what it took, with its velocity. Liquid moves by the new velocity: by the mean of both, waves
 *  would grow by (omega dt)^2/4 a step. Spray falls on parabolas. */
static inline sph2d_vec2 displacement_of(const sph2d__system *s, const pace *p, size_t i, sph2d_vec2 v, const taken *t)
{
    const sph2d__store *f = &s->fluid;
    const double middle = p->dt / 2, outside = 1 - t->inside;
    const sph2d_vec2 shift = {within(p->of_order, f->shift_x[i]), within(p->of_order, f->shift_y[i])};
    const double ax = t->inside * (v.x * t->u_x + v.y * t->u_y) - outside * f->ax[i];
    const double ay = t->inside * (v.x * t->v_x + v.y * t->v_y) - outside * f->ay[i];
    f->shift_x[i] = shift.x;
    f->shift_y[i] = shift.y;
    f->stretch[i] = (t->u_x - t->v_y) / 2;
    f->shear[i] = (t->u_y + t->v_x) / 2;
    f->rotation[i] = (t->v_x - t->u_y) / 2;
    f->pressure[i] = p->pressing * t->q;
    return (sph2d_vec2){p->dt * (v.x + middle * ax) + within(p->of_grid, t->e_x) + shift.x,
                        p->dt * (v.y + middle * ay) + within(p->of_grid, t->e_y) + shift.y};
}

/** Within a spacing before the mouth of a source liquid goes at least as fast as its jet, or the next row had no room. */
static inline void keep_pace(const sph2d__system *s, const sph2d__jet *jet, double dt, size_t i, sph2d_vec2 *way)
{
    const double x = s->fluid.x[i] - jet->x, y = s->fluid.y[i] - jet->y, along = x * jet->ux + y * jet->uy;
    const double late = dt * jet->speed - (way->x * jet->ux + way->y * jet->uy);
    if (jet->open && along >= 0 && along < s->spacing && fabs(y * jet->ux - x * jet->uy) < jet->half_width &&
        late > 0) {
        way->x += late * jet->ux;
        way->y += late * jet->uy;
    }
}

/** The way of particle i in a step; sets its slopes and its pressure. */
static inline sph2d__way way_of(const sph2d__system *s, const pace *p, size_t i)
{
    const sph2d__store *f = &s->fluid;
    sph2d_vec2 v = {f->vx[i], f->vy[i]};
    const taken t = take(s, i, &v);
    sph2d_vec2 way = displacement_of(s, p, i, v, &t);
    for (size_t k = 0; k < s->grid->jet_count; ++k) {
        const sph2d__jet jet = s->grid->jets[k];
        keep_pace(s, &jet, p->dt, i, &way);
    }
    if (t.inside < 1)
        stop(&v, f->shift_x[i], f->shift_y[i], 1 - t.inside, p->dt);
    return (sph2d__way){way.x, way.y, v, 0, 0};
}

#endif
