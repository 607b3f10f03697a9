/* SPDX-License-Identifier: MIT */
/** @file advance.c
 *  One step of method `hybrid`, and what particles take from the grid: hybrid.h has the equations. */
#include <math.h>

#include "base/parallel.h"
#include "methods/hybrid/grid.h"
#include "methods/hybrid/hybrid.h"
#include "sim/stages.h"

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

/** Reads at column `x` and row `y` of the faces. */
static inline reading read_at(const sph2d__grid *g, const sph2d__quad *faces, float x, float y)
{
    const int i = (int)x, j = (int)y;
    const float a = x - (float)i, b = y - (float)j;
    const sph2d__quad *low = faces + (size_t)j * g->stride + (size_t)i, *high = low + g->stride;
    const sph2d__quad below = low[0] + a * (low[1] - low[0]), above = high[0] + a * (high[1] - high[0]);
    const sph2d__quad mean = below + b * (above - below);
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

/* fmax and fmin are calls, as they look for values that are no numbers. */
static inline double within(double bound, double value)
{
    return value > bound ? bound : value < -bound ? -bound : value;
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

/** Velocity, its slopes and displacement of particle i, which is at (x, y) in squares: k of the batch. */
static void take(sph2d_sim *sim, sph2d__batch *w, size_t k, float x, float y, double dt)
{
    const sph2d__grid *g = sim->system.grid;
    sph2d__store *f = &sim->system.fluid;
    const size_t i = w->first + k;
    const double bound = MOST_OF_GRID * sim->system.spacing;
    const reading ru = read_at(g, g->face_x, x + 1, y + 0.5F), rv = read_at(g, g->face_y, x + 0.5F, y + 1);
    const slopes s = ru.known > 0 && rv.known > 0 ? slopes_of(&ru, &rv, f->rotation[i]) : (slopes){0};
    if (ru.known > 0)
        w->vx[k] = (double)ru.value - s.u_x * (double)ru.off_x - s.u_y * (double)ru.off_y;
    if (rv.known > 0)
        w->vy[k] = (double)rv.value - s.v_x * (double)rv.off_x - s.v_y * (double)rv.off_y;
    f->stretch[i] = (s.u_x - s.v_y) / 2;
    f->shear[i] = (s.u_y + s.v_x) / 2;
    f->rotation[i] = (s.v_x - s.u_y) / 2;
    /* Liquid moves by the new velocity: by the mean of both, waves would grow by (omega dt)^2/4 a step. Spray falls on
     * parabolas. */
    const double u = w->vx[k], v = w->vy[k], known = 4 * (double)(ru.known + rv.known) - 1;
    const double inside = known > 1 ? 1 : known < 0 ? 0 : known, outside = (1 - inside) * dt / 2;
    w->dx[k] = dt * (u + inside * dt / 2 * (u * s.u_x + v * s.u_y) - outside * f->ax[i]) +
               within(bound, (double)ru.displacement) + f->shift_x[i];
    w->dy[k] = dt * (v + inside * dt / 2 * (u * s.v_x + v * s.v_y) - outside * f->ay[i]) +
               within(bound, (double)rv.displacement) + f->shift_y[i];
    stop(w, k, f->shift_x[i], f->shift_y[i], 1 - inside, dt);
    f->pressure[i] = (double)pressure_at(g, x + 0.5F, y + 0.5F) * sim->system.rest_density / dt;
}

static void move(sph2d_sim *sim, double dt, sph2d__batch *w)
{
    const sph2d__grid *g = sim->system.grid;
    sph2d__store *f = &sim->system.fluid;
    for (size_t k = 0, i = w->first; k < w->count; ++k, ++i) {
        const double x = (f->x[i] - g->low_x) * g->inverse_x, y = (f->y[i] - g->low_y) * g->inverse_y;
        w->vx[k] = f->vx[i];
        w->vy[k] = f->vy[i];
        f->shift_x[i] = within(MOST_OF_ORDER * sim->system.spacing, f->shift_x[i]);
        f->shift_y[i] = within(MOST_OF_ORDER * sim->system.spacing, f->shift_y[i]);
        if (x >= 0 && x <= g->nx && y >= 0 && y <= g->ny)
            take(sim, w, k, (float)x, (float)y, dt);
        else {
            w->dx[k] = dt * (w->vx[k] - dt / 2 * f->ax[i]) + f->shift_x[i];
            w->dy[k] = dt * (w->vy[k] - dt / 2 * f->ay[i]) + f->shift_y[i];
            stop(w, k, f->shift_x[i], f->shift_y[i], 1, dt);
            f->pressure[i] = f->stretch[i] = f->shear[i] = f->rotation[i] = 0;
        }
    }
}

static void kick(sph2d__store *f, double dt)
{
#pragma omp taskloop num_tasks(sph2d__tasks(f->count, SPH2D__GRAIN)) if (f->count > SPH2D__GRAIN)
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] += dt * f->ax[i];
        f->vy[i] += dt * f->ay[i];
    }
}

/** Energy of the liquid, and the power of the forces without a potential. */
typedef struct energies {
    double energy, power;
} energies;

static energies energies_of(const sph2d_sim *sim)
{
    return (energies){sph2d__sim_energy_of_all(sim), sph2d__sim_power_of_forces(sim) - sph2d__bodies_power(sim)};
}

/** Sorts and evaluates again when particles came or went since the last step: at its end, both are of those there were. */
static sph2d_status take_in(sph2d_sim *sim)
{
    sph2d__grid *g = sim->system.grid;
    if (g->next_id == sim->record.next_id && g->count == sim->system.fluid.count)
        return SPH2D_OK;
    const sph2d_status status = sph2d__sort_fluid(sim);
    if (status != SPH2D_OK)
        return status;
    g->next_id = sim->record.next_id;
    g->count = sim->system.fluid.count;
    return sim->method->evaluate(&sim->system) ? SPH2D_OK : SPH2D_NOMEM;
}

sph2d_status sph2d__hybrid_step(sph2d_sim *sim, double dt)
{
    sph2d__system *s = &sim->system;
    sph2d__record *r = &sim->record;
    sph2d_status status = sph2d__grid_prepare(sim);
    if (status == SPH2D_OK)
        status = take_in(sim);
    if (status != SPH2D_OK)
        return status;
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_FORCES);
    sph2d__hybrid_pack(s);
    sph2d__hybrid_order(s);
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_BOOKKEEPING);
    const energies before = energies_of(sim);
    const double booked = r->energy_stopped - r->energy_walls;
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_MOVE);
    kick(&s->fluid, dt);
    sph2d__bodies_fall(sim, dt);
    sph2d__sim_set_drift_interval(sim, r->time, r->time + dt);
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_SOLVE);
    sph2d__grid_cut(sim, s->grid);
    sph2d__grid_sum(sim, s->grid, dt);
    sph2d__grid_passes_find(s->isa)->solve(s->grid, dt * s->viscosity / s->rest_density);
    double on_bodies = 0;
    if (s->grid->body_count > 0) {
        sph2d__grid_impulses(s->grid, s->rest_density, s->grid->impulses);
        status = sph2d__bodies_push(sim, dt, s->grid->impulses, &on_bodies);
        if (status != SPH2D_OK)
            return status;
        sph2d__sim_set_drift_interval(sim, r->time, r->time + dt);
    }
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_MOVE);
    status = sph2d__advect(sim, dt, move, NULL);
    if (status != SPH2D_OK)
        return status;
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_BOOKKEEPING);
    const energies after = energies_of(sim);
    r->work_pressed += on_bodies + after.energy - before.energy - dt * (before.power + after.power) / 2 +
                       (r->energy_stopped - r->energy_walls - booked);
    status = sph2d__sort_fluid(sim);
    if (status == SPH2D_OK)
        status = sph2d__sim_update_forcing(sim, r->time + dt);
    if (status != SPH2D_OK)
        return status;
    return sim->method->evaluate(s) ? SPH2D_OK : SPH2D_NOMEM;
}
