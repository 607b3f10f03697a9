/* SPDX-License-Identifier: MIT */
/** @file sources.c
 *  What comes and goes between steps: sources feed rows of particles, drains and open sides take them. */
#include <math.h>
#include <stdatomic.h>
#include <string.h>

#include "base/random.h"
#include "methods/common/state_equation.h"
#include "methods/terms/tension.h"
#include "run/run.h"
#include "scene/derive.h"
#include "sim/stages.h"

/* A place is taken when a particle is closer than this many spacings. A jet's own rows are one spacing apart; the
 * middle of four particles of full liquid is at 0.71 of all of them. */
static const double ROOM = 0.75;

/* The clock is a sum of steps: a due time that it misses by rounding alone is reached. */
static const double REACHED = 1 + 1e-12;

/* Cells name particles by 32 bits. */
static const size_t MOST_PARTICLES = 4000000000u;

/** A source in numbers that emission needs. */
typedef struct nozzle {
    double ux, uy;   /**< unit vector of the jet */
    double columns;  /**< particles in a row */
    double across;   /**< between them [m] */
    double interval; /**< between rows [s], which gives each particle its area dx^2 */
} nozzle;

static nozzle nozzle_of(const sph2d_scene *scene, const sph2d_source *source)
{
    double dx = scene->spacing;
    double length = hypot(source->direction.x, source->direction.y);
    double width = fmax(source->width, dx);
    double rate = source->rate > 0 ? source->rate : width * source->speed;
    double columns = fmax(floor(width / dx + 0.5), 1);
    return (nozzle){source->direction.x / length, source->direction.y / length, columns, width / columns,
                    columns * dx * dx / rate};
}

static bool near_any(const sph2d__cells *cells, const sph2d__store *store, double x, double y, double distance)
{
    uint32_t cell = sph2d__cells_find(cells, x, y);
    if (store->count == 0 || cell == UINT32_MAX)
        return false;
    sph2d__ranges ranges;
    sph2d__cells_ranges(cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, j)
        if (hypot(x + ranges.x[r] - store->x[j], y + ranges.y[r] - store->y[j]) < distance)
            return true;
    return false;
}

/** Whether a new particle has room: on the nozzle's side of every wall, away from liquid and boundary particles.
 *  `sorted` particles are in the cells, those behind are new. */
static bool has_room(const sph2d_sim *sim, size_t sorted, sph2d_vec2 start, double x, double y)
{
    const sph2d__system *s = &sim->system;
    double distance = ROOM * s->spacing, margin = 0.25 * s->spacing;
    sph2d_box d = sim->scene.domain;
    if (x < d.min.x + margin || x > d.max.x - margin || y < d.min.y + margin || y > d.max.y - margin)
        return false;
    if (sph2d__barrier_crosses(&sim->barrier, start, (sph2d_vec2){x, y}))
        return false;
    if (s->walls.count > 0 && near_any(&s->wall_cells, &s->walls, x, y, distance))
        return false;
    if (sorted > 0 && near_any(&s->fluid_cells, &s->fluid, x, y, distance))
        return false;
    for (size_t j = sorted; j < s->fluid.count; ++j)
        if (hypot(s->fluid.x[j] - x, s->fluid.y[j] - y) < distance)
            return false;
    return true;
}

/** Feeds one row. It has been under way since its due time, so that a jet is even whatever the steps are. */
static sph2d_status feed_row(sph2d_sim *sim, size_t index, const nozzle *n, uint64_t row, double age, size_t sorted)
{
    const sph2d_source *source = &sim->scene.sources[index];
    sph2d__store *fluid = &sim->system.fluid;
    size_t columns = (size_t)n->columns;
    if (fluid->count + columns > MOST_PARTICLES || !sph2d__store_reserve(fluid, &sim->memory, fluid->count + columns))
        return SPH2D_NOMEM;
    for (size_t k = 0; k < columns; ++k) {
        double across = ((double)k - (n->columns - 1) / 2) * n->across;
        double along = age * source->speed;
        double x = source->at.x + along * n->ux - across * n->uy;
        double y = source->at.y + along * n->uy + across * n->ux;
        if (!has_room(sim, sorted, source->at, x, y)) {
            ++sim->record.blocked;
            continue;
        }
        size_t i = sph2d__store_add(fluid, sim->record.next_id++, x, y);
        double spread = source->spread * source->speed;
        fluid->density[i] = sim->scene.fluid.density;
        fluid->vx[i] = source->speed * n->ux + spread * sph2d__noise(source->seed, index, row, k, 0);
        fluid->vy[i] = source->speed * n->uy + spread * sph2d__noise(source->seed, index, row, k, 1);
        sph2d__body_add(&sim->system.body, x, y, fluid->vx[i], fluid->vy[i], &fluid->ax[i], &fluid->ay[i]);
        sim->record.energy_fed += sph2d__sim_energy_of(sim, x, y, fluid->vx[i], fluid->vy[i]);
        ++sim->record.fed;
    }
    return SPH2D_OK;
}

/* ---- the surface of what comes and goes -------------------------------------------------------------------------- */

/** An empty rectangle, to be widened. */
static const sph2d_box NOWHERE = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};

/** Widens a rectangle to hold all whose surface particle i has a part in; through a period that is everybody. */
static void widen(const sph2d_sim *sim, size_t i, sph2d_box *box)
{
    const sph2d__period *p = &sim->system.fluid_cells.period;
    double reach = 2 * SPH2D__OUTER_RADIUS * sim->system.spacing;
    double x = sim->system.fluid.x[i], y = sim->system.fluid.y[i];
    box->min.x = fmin(box->min.x, p->length_x > 0 ? -INFINITY : x - reach);
    box->max.x = fmax(box->max.x, p->length_x > 0 ? INFINITY : x + reach);
    box->min.y = fmin(box->min.y, p->length_y > 0 ? -INFINITY : y - reach);
    box->max.y = fmax(box->max.y, p->length_y > 0 ? INFINITY : y + reach);
}

/** Brings the cells up to date between steps, where every value of a particle goes along to its new place. */
static sph2d_status renew_cells(sph2d_sim *sim)
{
    sph2d__store *f = &sim->system.fluid;
    sph2d__set carried = f->carried;
    f->carried = f->has;
    sph2d_status status = sph2d__sort_fluid(sim);
    f->carried = carried;
    return status;
}

/** Books the surface that the particles from `sorted` on, which are not yet in the cells, have brought or closed. */
static sph2d_status book_surface_fed(sph2d_sim *sim, size_t sorted)
{
    sph2d__store *f = &sim->system.fluid;
    size_t count = f->count;
    if (!(sim->system.surface_tension > 0) || count == sorted)
        return SPH2D_OK;
    sph2d_box box = NOWHERE;
    for (size_t i = sorted; i < count; ++i)
        widen(sim, i, &box);
    f->count = sorted;
    double before = sorted > 0 ? sph2d__tension_energy_within(&sim->system, box) : 0;
    f->count = count;
    sph2d_status status = renew_cells(sim);
    if (status == SPH2D_OK)
        sim->record.energy_fed += sph2d__tension_energy_within(&sim->system, box) - before;
    return status;
}

/* ---- sources ----------------------------------------------------------------------------------------------------- */

/** Passes over the rows that were due so long ago that they would be outside the domain by now. */
static void skip_rows(sph2d_sim *sim, size_t index, const nozzle *n)
{
    const sph2d_source *source = &sim->scene.sources[index];
    sph2d_box d = sim->scene.domain;
    double under_way = hypot(d.max.x - d.min.x, d.max.y - d.min.y) / source->speed;
    double oldest = sim->record.time - under_way;
    if (source->stop > 0)
        oldest = fmin(oldest, source->stop);
    double due = source->start + (double)sim->source_rows[index] * n->interval;
    double skipped = fmin(floor((oldest - due) / n->interval), 1e18);
    if (skipped > 0) {
        sim->source_rows[index] += (uint64_t)skipped;
        sim->record.blocked += (uint64_t)(skipped * n->columns);
    }
}

sph2d_status sph2d__sim_emit(sph2d_sim *sim)
{
    size_t sorted = sim->system.fluid.count;
    for (size_t i = 0; i < sim->scene.source_count; ++i) {
        const sph2d_source *source = &sim->scene.sources[i];
        nozzle n = nozzle_of(&sim->scene, source);
        skip_rows(sim, i, &n);
        for (;;) {
            uint64_t row = sim->source_rows[i];
            double due = source->start + (double)row * n.interval;
            if (due > REACHED * sim->record.time || (source->stop > 0 && due >= source->stop))
                break;
            sph2d_status status = feed_row(sim, i, &n, row, fmax(sim->record.time - due, 0), sorted);
            if (status != SPH2D_OK)
                return status;
            ++sim->source_rows[i];
        }
    }
    return book_surface_fed(sim, sorted);
}

/* ---- drains and open sides --------------------------------------------------------------------------------------- */

/** Through which open side a particle has left for good: 0 to 3 for left, right, bottom, top, or -1. It may come back
 *  as long as it is within one more width or height of the domain. */
static int side_left(const sph2d_scene *scene, double x, double y)
{
    sph2d_box d = scene->domain;
    double width = d.max.x - d.min.x, height = d.max.y - d.min.y;
    if (x < d.min.x - width)
        return 0;
    if (x > d.max.x + width)
        return 1;
    if (y < d.min.y - height)
        return 2;
    return y > d.max.y + height ? 3 : -1;
}

/** A look at all particles. */
typedef struct census {
    sph2d_sim *sim;
    atomic_size_t count; /**< of those that are looked for */
} census;

static void count_left(void *with, size_t first, size_t last)
{
    census *c = with;
    const sph2d__store *f = &c->sim->system.fluid;
    size_t left = 0;
    for (size_t i = first; i < last; ++i)
        left += side_left(&c->sim->scene, f->x[i], f->y[i]) >= 0;
    atomic_fetch_add(&c->count, left);
}

/** Whether any particle has left. */
static bool any_left(sph2d_sim *sim)
{
    census c = {.sim = sim};
    sph2d__share(sim->system.team, sim->system.fluid.count, SPH2D__GRAIN, count_left, &c);
    return c.count > 0;
}

static bool in_drain(const sph2d_sim *sim, double x, double y)
{
    for (size_t i = 0; i < sim->scene.drain_count; ++i) {
        const sph2d_drain *drain = &sim->scene.drains[i];
        bool open = sim->record.time >= drain->start && (drain->stop <= 0 || sim->record.time < drain->stop);
        if (open && sph2d__shape_contains(&drain->shape, (sph2d_vec2){x, y}))
            return true;
    }
    return false;
}

static bool reserve_flags(sph2d_sim *sim)
{
    size_t capacity = sim->system.fluid.capacity;
    if (sim->to_remove_capacity >= capacity)
        return true;
    void *block = sim->to_remove;
    if (!sph2d__resize(&sim->memory, &block, sim->to_remove_capacity, capacity, 1))
        return false;
    sim->to_remove = block;
    sim->to_remove_capacity = capacity;
    return true;
}

/** Takes note of a particle that goes. */
static void count_lost(sph2d_sim *sim, size_t i)
{
    const sph2d__store *f = &sim->system.fluid;
    sph2d__record *r = &sim->record;
    uint64_t *left[4] = {&r->left_left, &r->left_right, &r->left_bottom, &r->left_top};
    int side = side_left(&sim->scene, f->x[i], f->y[i]);
    ++*(side >= 0 ? left[side] : &r->drained);
    r->energy_fed -= sph2d__sim_energy_of(sim, f->x[i], f->y[i], f->vx[i], f->vy[i]);
    double elastic = sph2d__sim_elastic_falls(sim) ? 0 : sim->system.mass * sph2d__sim_elastic_of(sim, i);
    r->energy_fed -= elastic;
    r->energy_elastic -= elastic;
}

static bool can_lose(const sph2d_scene *scene)
{
    const sph2d_boundary *b = &scene->boundary;
    return scene->drain_count > 0 || b->left == SPH2D_SIDE_OPEN || b->right == SPH2D_SIDE_OPEN ||
           b->bottom == SPH2D_SIDE_OPEN || b->top == SPH2D_SIDE_OPEN;
}

/** Flags those that go. */
static void flag_lost(void *with, size_t first, size_t last)
{
    census *c = with;
    sph2d_sim *sim = c->sim;
    const sph2d__store *f = &sim->system.fluid;
    size_t lost = 0;
    for (size_t i = first; i < last; ++i) {
        sim->to_remove[i] = side_left(&sim->scene, f->x[i], f->y[i]) >= 0 || in_drain(sim, f->x[i], f->y[i]);
        lost += sim->to_remove[i];
    }
    atomic_fetch_add(&c->count, lost);
}

sph2d_status sph2d__sim_drain(sph2d_sim *sim)
{
    if (!can_lose(&sim->scene))
        return SPH2D_OK;
    sph2d__store *f = &sim->system.fluid;
    if (sim->scene.drain_count == 0 && !any_left(sim))
        return SPH2D_OK;
    if (!reserve_flags(sim))
        return SPH2D_NOMEM;
    census lost = {.sim = sim};
    sph2d__share(sim->system.team, f->count, SPH2D__GRAIN, flag_lost, &lost);
    if (lost.count == 0)
        return SPH2D_OK;
    bool surface = sim->system.surface_tension > 0;
    sph2d_box box = NOWHERE;
    for (size_t i = 0; i < f->count; ++i)
        if (sim->to_remove[i]) {
            count_lost(sim, i);
            widen(sim, i, &box);
        }
    double before = surface ? sph2d__tension_energy_within(&sim->system, box) : 0;
    sph2d__store_remove(f, sim->to_remove);
    sph2d_status status = surface ? renew_cells(sim) : SPH2D_OK;
    if (surface && status == SPH2D_OK)
        sim->record.energy_fed += sph2d__tension_energy_within(&sim->system, box) - before;
    return status;
}
