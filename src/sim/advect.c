/* SPDX-License-Identifier: MIT */
/** @file advect.c
 *  Advection: particles are moved by their displacements, stopped by walls and wrapped at periodic sides. */
#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "sim/device_steps.h"
#include "sim/stages.h"

/** The moving obstacles that a batch of particles can meet: those that `count` indices name, or all of them. */
enum { MOST_NEAR = 16 };
typedef struct near_obstacles {
    bool all;
    size_t count, items[MOST_NEAR];
} near_obstacles;

/** What a particle may meet: advect_one.h. */
typedef struct passage {
    const sph2d__system *system;
    const sph2d__barrier *walls;
    double quantum;
    bool holds;
    sph2d_sim *sim;
    const near_obstacles *near;
} passage;

static void note_contact(const passage *p, sph2d__events *met, int wall, sph2d_vec2 at, sph2d_vec2 change, double work)
{
    (void)met;
    sph2d__loads_contact(p->sim, wall, at, change, work);
}

/** Reflects a velocity at the nearest reflecting boundary particle within one spacing, if the particle approaches it:
 *  the component along the line between the two is reversed and damped. */
static bool reflect(const passage *by, sph2d_vec2 p, sph2d_vec2 *v)
{
    const sph2d__system *s = by->system;
    uint32_t cell = sph2d__cells_find(&s->wall_cells, p.x, p.y);
    if (cell == UINT32_MAX)
        return false;
    sph2d__ranges ranges;
    sph2d__cells_ranges(&s->wall_cells, cell, &ranges);
    double nearest2 = s->spacing * s->spacing;
    size_t nearest = SIZE_MAX;
    double nx = 0, ny = 0;
    SPH2D__FOR_NEIGHBOURS (&ranges, r, b) {
        double dx = p.x + ranges.x[r] - s->walls.x[b], dy = p.y + ranges.y[r] - s->walls.y[b];
        double r2 = dx * dx + dy * dy;
        if (s->walls.bounce[b] >= 0 && r2 < nearest2 && r2 > 0) {
            nearest2 = r2;
            nearest = b;
            nx = dx;
            ny = dy;
        }
    }
    if (nearest == SIZE_MAX)
        return false;
    double along = (v->x * nx + v->y * ny) / nearest2;
    if (along >= 0)
        return false;
    double change = (1 + s->walls.bounce[nearest]) * along;
    v->x -= change * nx;
    v->y -= change * ny;
    sph2d__loads_reflect(by->sim, nearest, p, (sph2d_vec2){-change * nx, -change * ny});
    return true;
}

/** Brings a place to the period in which a body is drawn: bodies cross periodic sides whole. */
static sph2d_vec2 to_image(const sph2d_sim *sim, const sph2d__moving *moving, sph2d_vec2 p)
{
    const sph2d__period *period = &sim->system.fluid_cells.period;
    sph2d_vec2 arm = sph2d__pose_arm(&moving->to, p);
    return (sph2d_vec2){p.x + sph2d__period_nearest(arm.x, period->length_x) - arm.x,
                        p.y + sph2d__period_nearest(arm.y, period->length_y) - arm.y};
}

static uint64_t sweep_one(const passage *p, sph2d__events *met, const sph2d__moving *moving, sph2d__kicked k,
                          sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v, double *to_bodies)
{
    sph2d_sim *sim = p->sim;
    const sph2d__system *s = p->system;
    sph2d_vec2 at = *to, before = *v, shift = {0, 0};
    if (moving->rigid) {
        sph2d_vec2 image = to_image(sim, moving, from);
        shift = (sph2d_vec2){image.x - from.x, image.y - from.y};
        from = image;
        *to = (sph2d_vec2){to->x + shift.x, to->y + shift.y};
    }
    int hits = sph2d__moving_sweep(moving, from, to, v);
    if (moving->rigid)
        *to = hits > 0 ? (sph2d_vec2){to->x - shift.x, to->y - shift.y} : at;
    if (hits > 0 && moving->rigid) {
        double share = sph2d__bodies_share(sim, moving, from, (sph2d_vec2){v->x - before.x, v->y - before.y});
        *v = (sph2d_vec2){before.x + share * (v->x - before.x), before.y + share * (v->y - before.y)};
        *to_bodies +=
            sph2d__energy_kicked(s, k, (sph2d__end){*to, *v}) - sph2d__energy_kicked(s, k, (sph2d__end){at, before});
        sph2d__bodies_strike(sim, moving, from, (sph2d_vec2){v->x - before.x, v->y - before.y});
    }
    if (hits > 0 && sph2d__loads_wanted(sim))
        note_contact(p, met, moving->number, from, (sph2d_vec2){v->x - before.x, v->y - before.y},
                     sph2d__energy_kicked(s, k, (sph2d__end){*to, *v}) -
                         sph2d__energy_kicked(s, k, (sph2d__end){at, before}));
    return (uint64_t)hits;
}

/** Keeps a displacement on its side of moving obstacles. */
static uint64_t sweep_moving(const passage *p, sph2d__events *met, sph2d__kicked who, sph2d_vec2 from, sph2d_vec2 *to,
                             sph2d_vec2 *v, double *to_bodies)
{
    const near_obstacles *near = p->near;
    uint64_t hits = 0;
    for (size_t k = 0; near->all ? k < p->sim->moving_count : k < near->count; ++k)
        hits += sweep_one(p, met, &p->sim->moving[near->all ? k : near->items[k]], who, from, to, v, to_bodies);
    return hits;
}

#include "sim/advect_one.h"

/** Around the ends of a batch's displacements, which are no longer than `longest`. */
typedef struct reach {
    sph2d_vec2 low, high;
    double longest;
    bool finite;
} reach;

static reach reach_of(const sph2d_sim *sim, const sph2d__batch *batch)
{
    const double *x = sim->system.fluid.x + batch->first, *y = sim->system.fluid.y + batch->first;
    sph2d_vec2 low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    double longest = 0, sum = 0;
    for (size_t k = 0; k < batch->count; ++k) {
        double to_x = x[k] + batch->dx[k], to_y = y[k] + batch->dy[k], length = fabs(batch->dx[k]) + fabs(batch->dy[k]);
        low.x = to_x < low.x ? to_x : low.x;
        low.y = to_y < low.y ? to_y : low.y;
        high.x = to_x > high.x ? to_x : high.x;
        high.y = to_y > high.y ? to_y : high.y;
        longest = length > longest ? length : longest;
        sum += to_x + to_y + (batch->vx[k] + batch->vy[k]);
    }
    return (reach){low, high, longest, isfinite(sum)};
}

/** Whether no particle of a batch can meet a moving obstacle. A body may be drawn in another period. */
static bool is_far(const sph2d_sim *sim, const sph2d__moving *moving, const reach *r, double shift)
{
    const sph2d__period *p = &sim->system.fluid_cells.period;
    if (!moving->rigid || (!(p->length_x > 0) && !(p->length_y > 0)))
        return sph2d__moving_far_from(moving, r->low, r->high, r->longest + shift);
    double across = fmax(moving->rigid->radius, 0) + r->longest + shift + 2 * sph2d__moving_shift(moving);
    sph2d_vec2 middle = {(r->low.x + r->high.x) / 2, (r->low.y + r->high.y) / 2};
    sph2d_vec2 arm = sph2d__pose_arm(&moving->to, middle);
    return fabs(sph2d__period_nearest(arm.x, p->length_x)) > across + (r->high.x - r->low.x) / 2 ||
           fabs(sph2d__period_nearest(arm.y, p->length_y)) > across + (r->high.y - r->low.y) / 2;
}

/** Finds the moving obstacles in reach of a batch, and of what another one pushes by up to `shift` [m]. */
static void find_near(const sph2d_sim *sim, const reach *r, double shift, near_obstacles *near)
{
    near->count = 0;
    near->all = sim->system.walls_reflect || !r->finite;
    for (size_t k = 0; k < sim->moving_count && !near->all; ++k) {
        if (is_far(sim, &sim->moving[k], r, shift))
            continue;
        if (near->count == MOST_NEAR)
            near->all = true;
        else
            near->items[near->count++] = k;
    }
    near->all = near->all && sim->moving_count > 0;
}

/** Whether no particle of a batch can meet a wall at rest or a periodic side, and all values are finite: the usual case,
 *  and the only cheap one. */
static bool moves_freely(const sph2d_sim *sim, const reach *r)
{
    const sph2d__period *period = &sim->system.fluid_cells.period;
    return !sim->system.walls_reflect && r->finite && sph2d__period_holds(period, r->low.x, r->low.y) &&
           sph2d__period_holds(period, r->high.x, r->high.y) &&
           sph2d__barrier_far_from(&sim->barrier, r->low, r->high, r->longest);
}

/** Moves a batch that meets no wall or side. */
static void advect_free(sph2d__store *f, const sph2d__batch *batch)
{
    double *restrict x = f->x + batch->first, *restrict y = f->y + batch->first;
    for (size_t k = 0; k < batch->count; ++k) {
        x[k] += batch->dx[k];
        y[k] += batch->dy[k];
    }
    memcpy(f->vx + batch->first, batch->vx, batch->count * sizeof(double));
    memcpy(f->vy + batch->first, batch->vy, batch->count * sizeof(double));
}

static void advect_batch(sph2d_sim *sim, double shift, const sph2d__batch *batch, sph2d__events *met)
{
    reach r = reach_of(sim, batch);
    near_obstacles near;
    find_near(sim, &r, shift, &near);
    if (!near.all && near.count == 0 && moves_freely(sim, &r)) {
        advect_free(&sim->system.fluid, batch);
        return;
    }
    const passage by = {&sim->system, &sim->barrier, sph2d__sim_energy_quantum(sim), sim->method->walls_hold,
                        sim,          &near};
    for (size_t k = 0; k < batch->count; ++k) {
        const sph2d__way way = {batch->dx[k], batch->dy[k], {batch->vx[k], batch->vy[k]}, batch->kick, 0};
        advect_one(&by, batch->first + k, way, met);
    }
}

static double shift_of_walls(const sph2d_sim *sim)
{
    double shift = 0;
    for (size_t k = 0; k < sim->moving_count; ++k)
        shift = fmax(shift, sph2d__moving_shift(&sim->moving[k]) + 2 * sim->moving[k].barrier.clearance);
    return shift;
}

/* Batches in a task. */
enum { BATCHES = 512 / SPH2D__BATCH };

static void book_events(sph2d_sim *sim, const sph2d__events *met)
{
    sim->record.backstop_hits += met->hits;
    sim->record.reflections += met->reflections;
    sim->record.energy_stopped += (double)met->stopped * sph2d__sim_energy_quantum(sim);
    sim->record.energy_walls += (double)met->driven * sph2d__sim_energy_quantum(sim);
    sim->record.energy_diffused += (double)met->diffused * sph2d__sim_energy_quantum(sim);
}

static sph2d_status advect_on_device(sph2d_sim *sim, double dt)
{
    const sph2d__events met = sph2d__device_advect(sim, dt, sph2d__sim_energy_quantum(sim), sph2d__loads_wanted(sim));
    for (uint64_t k = 0; k < met.noted; ++k) {
        const sph2d__contact *c = &sim->contacts[k];
        sph2d__loads_contact(sim, c->wall, c->at, c->change, c->work);
    }
    book_events(sim, &met);
    return met.not_finite == 0 ? SPH2D_OK : SPH2D_GUARD;
}

sph2d_status sph2d__advect(sph2d_sim *sim, double dt, sph2d__batch_work *set, sph2d__batch_work *after)
{
    if (sph2d__is_on_device(&sim->system))
        return advect_on_device(sim, dt);
    const size_t count = sim->system.fluid.count, batches = (count + SPH2D__BATCH - 1) / SPH2D__BATCH;
    const double shift = shift_of_walls(sim);
    sph2d__events all = {0};
#pragma omp taskloop num_tasks(sph2d__tasks(batches, BATCHES)) if (batches > BATCHES) shared(all)                      \
    firstprivate(set, after)
    for (size_t first = 0; first < batches; first += BATCHES) {
        sph2d__events met = {0};
        for (size_t n = first; n < batches && n < first + BATCHES; ++n) {
            sph2d__batch batch;
            batch.first = n * SPH2D__BATCH;
            batch.kick = 0;
            batch.diffused = 0;
            batch.count = count - batch.first < SPH2D__BATCH ? count - batch.first : SPH2D__BATCH;
            set(sim, dt, &batch);
            met.diffused += batch.diffused;
            advect_batch(sim, shift, &batch, &met);
            if (after)
                after(sim, dt, &batch);
        }
#pragma omp critical(sph2d_events)
        sph2d__add_events(&all, met);
    }
    book_events(sim, &all);
    return all.not_finite == 0 ? SPH2D_OK : SPH2D_GUARD;
}
