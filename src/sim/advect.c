/* SPDX-License-Identifier: MIT */
/** @file advect.c
 *  Advection: particles are moved by their displacements, stopped by walls and wrapped at periodic sides. */
#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "sim/stages.h"

/** Reflects a velocity at the nearest reflecting boundary particle within one spacing, if the particle approaches it:
 *  the component along the line between the two is reversed and damped. */
static bool reflect(sph2d_sim *sim, sph2d_vec2 p, sph2d_vec2 *v)
{
    const sph2d__system *s = &sim->system;
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
    sph2d__loads_reflect(sim, nearest, p, (sph2d_vec2){-change * nx, -change * ny});
    return true;
}

/** A particle, and for how long its acceleration acted in the kick before this displacement [s]. */
typedef struct kicked {
    size_t particle;
    double duration;
} kicked;

/** By how much the liquid's own forces changed its velocity in the kick. Elastic energy pays for it, by the velocity that
 *  the wall leaves: a particle that pressure pulls against a wall, which stops it in each step, loses nothing. Without
 *  this 16 particles that fell on the upper end of a line lost 58 % of the energy scale more, and two that a rim held
 *  63 J/m per second, 70 times their potential energy. */
static sph2d_vec2 push_of(const sph2d_sim *sim, kicked k)
{
    const sph2d__store *f = &sim->system.fluid;
    size_t i = k.particle;
    double bx = 0, by = 0;
    if (!(k.duration > 0))
        return (sph2d_vec2){0, 0};
    sph2d__forces_add(&sim->system.forces, (sph2d__place){f->x[i], f->y[i], f->vx[i], f->vy[i]}, &bx, &by);
    return (sph2d_vec2){k.duration * (f->ax[i] - bx), k.duration * (f->ay[i] - by)};
}

/** Energy of a particle whose position and velocity a wall changes [J/m]: kinetic and potential, less what the kick has
 *  added before elastic energy paid for it. */
static double energy_at(const sph2d_sim *sim, kicked k, sph2d_vec2 at, sph2d_vec2 v)
{
    sph2d_vec2 push = push_of(sim, k);
    return sph2d__sim_energy_of(sim, at.x, at.y, v.x, v.y) - sim->system.mass * (push.x * v.x + push.y * v.y);
}

/** Brings a place to the period in which a body is drawn: bodies cross periodic sides whole. */
static sph2d_vec2 to_image(const sph2d_sim *sim, const sph2d__moving *moving, sph2d_vec2 p)
{
    const sph2d__period *period = &sim->system.fluid_cells.period;
    sph2d_vec2 arm = sph2d__pose_arm(&moving->to, p);
    return (sph2d_vec2){p.x + sph2d__period_nearest(arm.x, period->length_x) - arm.x,
                        p.y + sph2d__period_nearest(arm.y, period->length_y) - arm.y};
}

static uint64_t sweep_one(sph2d_sim *sim, const sph2d__moving *moving, kicked k, sph2d_vec2 from, sph2d_vec2 *to,
                          sph2d_vec2 *v, double *to_bodies)
{
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
        *to_bodies += energy_at(sim, k, *to, *v) - energy_at(sim, k, at, before);
        sph2d__bodies_strike(sim, moving, from, (sph2d_vec2){v->x - before.x, v->y - before.y});
    }
    if (hits > 0 && sph2d__loads_wanted(sim))
        sph2d__loads_contact(sim, moving->number, from, (sph2d_vec2){v->x - before.x, v->y - before.y},
                             energy_at(sim, k, *to, *v) - energy_at(sim, k, at, before));
    return (uint64_t)hits;
}

/** The moving obstacles that a batch of particles can meet: those that `count` indices name, or all of them. */
enum { MOST_NEAR = 16 };
typedef struct near_obstacles {
    bool all;
    size_t count, items[MOST_NEAR];
} near_obstacles;

/** Keeps a displacement on its side of moving obstacles. */
static uint64_t sweep_moving(sph2d_sim *sim, const near_obstacles *near, kicked who, sph2d_vec2 from, sph2d_vec2 *to,
                             sph2d_vec2 *v, double *to_bodies)
{
    uint64_t hits = 0;
    for (size_t k = 0; near->all ? k < sim->moving_count : k < near->count; ++k)
        hits += sweep_one(sim, &sim->moving[near->all ? k : near->items[k]], who, from, to, v, to_bodies);
    return hits;
}

/** Keeps a displacement on its side of every wall at rest. */
static uint64_t sweep_fixed(sph2d_sim *sim, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v)
{
    const bool wanted = sph2d__loads_wanted(sim);
    sph2d__stops stops;
    stops.count = 0;
    int hits = sph2d__barrier_sweep(&sim->barrier, from, to, v, wanted ? &stops : NULL);
    for (int k = 0; k < stops.count; ++k)
        sph2d__loads_contact(sim, stops.items[k].wall, from, stops.items[k].change, 0);
    return (uint64_t)hits;
}

/** What happened to particles during an advection. */
typedef struct events {
    uint64_t hits, reflections, not_finite;
    /** Energy lost to walls, gained from moving ones, and lost by changes of density, in quanta (simulation.h). */
    int64_t stopped, driven, diffused;
} events;

/** Position and velocity of a particle after its displacement. */
typedef struct end {
    sph2d_vec2 at, v;
} end;

static void add_events(events *to, const events *met)
{
    to->hits += met->hits;
    to->reflections += met->reflections;
    to->not_finite += met->not_finite;
    to->stopped += met->stopped;
    to->driven += met->driven;
    to->diffused += met->diffused;
}

/* No particle of a valid run has this many quanta. */
static const double MAX_QUANTA = 1e15;

static int64_t quanta_of(const sph2d_sim *sim, double energy)
{
    double quanta = energy / sph2d__sim_energy_quantum(sim);
    return fabs(quanta) < MAX_QUANTA ? (int64_t)quanta : 0;
}

/** The difference of a particle's energy between two of them, in quanta. */
static int64_t quanta_between(const sph2d_sim *sim, kicked k, end more, end less)
{
    return quanta_of(sim, energy_at(sim, k, more.at, more.v) - energy_at(sim, k, less.at, less.v));
}

/** Moves one particle that may meet a wall or a periodic side. */
static void advect_one(sph2d_sim *sim, const near_obstacles *near, const sph2d__batch *batch, size_t k, events *met)
{
    sph2d__store *f = &sim->system.fluid;
    const sph2d__period *period = &sim->system.fluid_cells.period;
    const size_t i = batch->first + k;
    const kicked who = {i, batch->kick};
    double dx = batch->dx[k], dy = batch->dy[k];
    sph2d_vec2 from = {f->x[i], f->y[i]}, v = {batch->vx[k], batch->vy[k]};
    end free = {{from.x + dx, from.y + dy}, v};
    uint64_t reflected = 0, stopped, pushed = 0;
    if (sim->system.walls_reflect) {
        sph2d_vec2 before = v;
        if (reflect(sim, from, &v)) {
            ++reflected;
            double dt = sim->system.step;
            dx += dt * (v.x - before.x);
            dy += dt * (v.y - before.y);
        }
    }
    sph2d_vec2 to = {from.x + dx, from.y + dy};
    stopped = sweep_fixed(sim, from, &to, &v);
    if (reflected + stopped > 0)
        met->stopped += quanta_between(sim, who, free, (end){to, v});
    if (near->all || near->count > 0) {
        end before = {to, v};
        double to_bodies = 0;
        pushed = sweep_moving(sim, near, who, from, &to, &v, &to_bodies);
        if (pushed > 0 && sim->method->walls_hold)
            stopped += sweep_fixed(sim, from, &to, &v);
        if (pushed > 0) {
            int64_t bodies = quanta_of(sim, to_bodies);
            met->driven += quanta_between(sim, who, (end){to, v}, before) - bodies;
            met->stopped -= bodies;
        }
    }
    sph2d_vec2 in = {sph2d__period_wrap(to.x, period->low_x, period->length_x),
                     sph2d__period_wrap(to.y, period->low_y, period->length_y)};
    if (in.x != to.x || in.y != to.y) { /* the displacement ends at the opposite periodic side */
        end before = {in, v};
        from = (sph2d_vec2){from.x + in.x - to.x, from.y + in.y - to.y};
        uint64_t held = sweep_fixed(sim, from, &in, &v);
        if (held > 0)
            met->stopped += quanta_between(sim, who, before, (end){in, v});
        stopped += held;
    }
    met->reflections += reflected;
    met->hits += stopped + pushed;
    met->not_finite += isfinite(in.x + in.y + v.x + v.y) ? 0 : 1;
    f->x[i] = in.x;
    f->y[i] = in.y;
    f->vx[i] = v.x;
    f->vy[i] = v.y;
}

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

static void advect_batch(sph2d_sim *sim, double shift, const sph2d__batch *batch, events *met)
{
    reach r = reach_of(sim, batch);
    near_obstacles near;
    find_near(sim, &r, shift, &near);
    if (!near.all && near.count == 0 && moves_freely(sim, &r)) {
        advect_free(&sim->system.fluid, batch);
        return;
    }
    for (size_t k = 0; k < batch->count; ++k)
        advect_one(sim, &near, batch, k, met);
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

sph2d_status sph2d__advect(sph2d_sim *sim, double dt, sph2d__batch_work *set, sph2d__batch_work *after)
{
    const size_t count = sim->system.fluid.count, batches = (count + SPH2D__BATCH - 1) / SPH2D__BATCH;
    const double shift = shift_of_walls(sim);
    events all = {0};
#pragma omp taskloop num_tasks(sph2d__tasks(batches, BATCHES)) if (batches > BATCHES) shared(all)                      \
    firstprivate(set, after)
    for (size_t first = 0; first < batches; first += BATCHES) {
        events met = {0};
        for (size_t n = first; n < batches && n < first + BATCHES; ++n) {
            sph2d__batch batch;
            batch.first = n * SPH2D__BATCH;
            batch.kick = batch.diffused = 0;
            batch.count = count - batch.first < SPH2D__BATCH ? count - batch.first : SPH2D__BATCH;
            set(sim, dt, &batch);
            met.diffused += quanta_of(sim, batch.diffused);
            advect_batch(sim, shift, &batch, &met);
            if (after)
                after(sim, dt, &batch);
        }
#pragma omp critical(sph2d_events)
        add_events(&all, &met);
    }
    sim->record.backstop_hits += all.hits;
    sim->record.reflections += all.reflections;
    sim->record.energy_stopped += (double)all.stopped * sph2d__sim_energy_quantum(sim);
    sim->record.energy_walls += (double)all.driven * sph2d__sim_energy_quantum(sim);
    sim->record.energy_diffused += (double)all.diffused * sph2d__sim_energy_quantum(sim);
    return all.not_finite == 0 ? SPH2D_OK : SPH2D_GUARD;
}
