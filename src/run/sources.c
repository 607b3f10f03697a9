/* SPDX-License-Identifier: MIT */
/** @file sources.c
 *  Sources, which emit rows of particles, and drains and open sides, which remove them, between steps. */
#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "base/random.h"
#include "methods/common/on_device.h"
#include "methods/common/state_equation.h"
#include "methods/terms/tension.h"
#include "run/run.h"
#include "scene/resolve.h"
#include "scene/shape.h"
#include "sim/extremes.h"
#include "sim/stages.h"

/* A source emits no particle nearer than this many spacings to another. The rows of a jet are one spacing apart; the
 * middle of four particles of a lattice is 0.71 spacings from each. */
static const double MIN_DISTANCE = 0.75;

/* The clock is a sum of steps: the tolerance for its rounding at a due time. */
static const double REACHED = 1 + 1e-12;

/** Parameters of a source's emission. */
typedef struct emission {
    double ux, uy;   /**< unit vector of the jet */
    double columns;  /**< particles in a row */
    double across;   /**< between them [m] */
    double interval; /**< between rows [s], which gives each particle its area dx^2 */
} emission;

static emission emission_of(const sph2d_scene *scene, const sph2d_source *source)
{
    double dx = scene->spacing;
    double length = hypot(source->direction.x, source->direction.y);
    double width = fmax(source->width, dx);
    double rate = source->rate > 0 ? source->rate : width * source->speed;
    double columns = fmax(floor(width / dx + 0.5), 1);
    return (emission){source->direction.x / length, source->direction.y / length, columns, width / columns,
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

bool sph2d__sim_has_room(const sph2d_sim *sim, size_t sorted, sph2d_vec2 start, double x, double y)
{
    const sph2d__system *s = &sim->system;
    double distance = MIN_DISTANCE * s->spacing, margin = 0.25 * s->spacing;
    sph2d_box d = sim->world.box;
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

/** Emits one row, advanced by its age since its due time, so that rows are evenly spaced for any time steps. */
static sph2d_status emit_row(sph2d_sim *sim, size_t index, const emission *n, uint64_t row, double age, size_t sorted)
{
    const sph2d_source *source = &sim->world.scene.sources[index];
    sph2d__store *fluid = &sim->system.fluid;
    size_t columns = (size_t)n->columns;
    if (fluid->count + columns > SPH2D__MAX_PARTICLES || !sph2d__fluid_reserve(&sim->system, fluid->count + columns))
        return SPH2D_NOMEM;
    for (size_t k = 0; k < columns; ++k) {
        double across = ((double)k - (n->columns - 1) / 2) * n->across;
        double along = age * source->speed;
        double x = source->at.x + along * n->ux - across * n->uy;
        double y = source->at.y + along * n->uy + across * n->ux;
        if (!sph2d__sim_has_room(sim, sorted, source->at, x, y)) {
            ++sim->record.blocked;
            continue;
        }
        size_t i = sph2d__sim_add_liquid(sim, (sph2d_vec2){x, y}, source->color);
        double spread = source->spread * source->speed;
        fluid->density[i] = sim->world.scene.fluid.density;
        fluid->vx[i] = source->speed * n->ux + spread * sph2d__noise(source->seed, index, row, k, 0);
        fluid->vy[i] = source->speed * n->uy + spread * sph2d__noise(source->seed, index, row, k, 1);
        sph2d__forces_add(&sim->system.forces, (sph2d__place){x, y, fluid->vx[i], fluid->vy[i]}, &fluid->ax[i],
                          &fluid->ay[i]);
        sim->record.energy_fed += sph2d__sim_energy_of(sim, x, y, fluid->vx[i], fluid->vy[i]);
        ++sim->record.fed;
    }
    return SPH2D_OK;
}

/* ---- surface energy of added and removed particles --------------------------------------------------------------- */

/** An empty rectangle, to be extended. */
static const sph2d_box EMPTY_BOX = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};

/** Extends a rectangle by the reach of particle i's surface energy; in a periodic direction to all. */
static void extend_box(const sph2d_sim *sim, size_t i, sph2d_box *box)
{
    const sph2d__period *p = &sim->system.fluid_cells.period;
    double reach = 2 * SPH2D__OUTER_RADIUS * sim->system.spacing;
    double x = sim->system.fluid.x[i], y = sim->system.fluid.y[i];
    box->min.x = fmin(box->min.x, p->length_x > 0 ? -INFINITY : x - reach);
    box->max.x = fmax(box->max.x, p->length_x > 0 ? INFINITY : x + reach);
    box->min.y = fmin(box->min.y, p->length_y > 0 ? -INFINITY : y - reach);
    box->max.y = fmax(box->max.y, p->length_y > 0 ? INFINITY : y + reach);
}

sph2d_status sph2d__sim_sort_all_arrays(sph2d_sim *sim)
{
    sph2d__store *f = &sim->system.fluid;
    sph2d__set carried = f->carried;
    f->carried = f->has;
    sph2d_status status = sph2d__sort_fluid(sim);
    f->carried = carried;
    return status;
}

sph2d_status sph2d__sim_book_new_surface(sph2d_sim *sim, size_t sorted)
{
    sph2d__store *f = &sim->system.fluid;
    size_t count = f->count;
    if (!(sim->system.surface_tension > 0) || count == sorted)
        return SPH2D_OK;
    sph2d_box box = EMPTY_BOX;
    for (size_t i = sorted; i < count; ++i)
        extend_box(sim, i, &box);
    f->count = sorted;
    double before = sorted > 0 ? sph2d__tension_energy_within(&sim->system, box) : 0;
    f->count = count;
    sph2d_status status = sph2d__sim_sort_all_arrays(sim);
    if (status == SPH2D_OK)
        sim->record.energy_fed += sph2d__tension_energy_within(&sim->system, box) - before;
    return status;
}

/* ---- sources ----------------------------------------------------------------------------------------------------- */

/** Skips rows that were due so long ago that they would have left the domain by now. */
static void skip_rows(sph2d_sim *sim, size_t index, const emission *n)
{
    const sph2d_source *source = &sim->world.scene.sources[index];
    sph2d_box d = sim->world.box;
    double crossing_time = hypot(d.max.x - d.min.x, d.max.y - d.min.y) / source->speed;
    double oldest = sim->record.time - crossing_time;
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
    sph2d_status fed = sph2d__openings_feed(sim);
    if (fed != SPH2D_OK)
        return fed;
    for (size_t i = 0; i < sim->world.scene.source_count; ++i) {
        const sph2d_source *source = &sim->world.scene.sources[i];
        emission n = emission_of(&sim->world.scene, source);
        skip_rows(sim, i, &n);
        for (;;) {
            uint64_t row = sim->source_rows[i];
            double due = source->start + (double)row * n.interval;
            if (due > REACHED * sim->record.time || (source->stop > 0 && due >= source->stop))
                break;
            sph2d__host_reads(&sim->system, SPH2D__EVERYTHING);
            sph2d_status status = emit_row(sim, i, &n, row, fmax(sim->record.time - due, 0), sorted);
            if (status != SPH2D_OK)
                return status;
            sph2d__host_changed(&sim->system, SPH2D__EVERYTHING);
            sim->none_left = false;
            ++sim->source_rows[i];
        }
    }
    return sph2d__sim_book_new_surface(sim, sorted);
}

/* ---- drains and open sides --------------------------------------------------------------------------------------- */

static bool in_drain(const sph2d_sim *sim, double x, double y)
{
    for (size_t i = 0; i < sim->world.scene.drain_count; ++i) {
        const sph2d_drain *drain = &sim->world.scene.drains[i];
        bool open = sim->record.time >= drain->start && (drain->stop <= 0 || sim->record.time < drain->stop);
        if (open && sph2d__shape_contains(&drain->shape, (sph2d_vec2){x, y}))
            return true;
    }
    return false;
}

bool sph2d__sim_reserve_flags(sph2d_sim *sim)
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

/** Counts a particle that is removed, and its energy. */
static void count_removed(sph2d_sim *sim, size_t i)
{
    const sph2d__store *f = &sim->system.fluid;
    sph2d__record *r = &sim->record;
    uint64_t *left[4] = {&r->left_left, &r->left_right, &r->left_bottom, &r->left_top};
    int side = sph2d__side_left(&sim->world.box, f->x[i], f->y[i]);
    bool let_out = side < 0 && sph2d__openings_spent(sim, f->x[i], f->y[i]);
    if (let_out)
        sph2d__openings_count_out(sim, f->x[i], f->y[i]);
    ++*(side >= 0 ? left[side] : let_out ? &r->let_out : &r->drained);
    r->energy_fed -= sph2d__sim_energy_of(sim, f->x[i], f->y[i], f->vx[i], f->vy[i]);
    double elastic = sph2d__sim_elastic_falls(sim) ? 0 : sim->system.mass * sph2d__sim_elastic_of(sim, i);
    r->energy_fed -= elastic;
    r->energy_elastic -= elastic;
}

static bool removes_particles(const sph2d_scene *scene)
{
    const sph2d_boundary *b = &scene->boundary;
    return scene->drain_count > 0 || scene->opening_count > 0 || b->left == SPH2D_SIDE_OPEN ||
           b->right == SPH2D_SIDE_OPEN || b->bottom == SPH2D_SIDE_OPEN || b->top == SPH2D_SIDE_OPEN;
}

/** Flags the particles to remove; false if there are none. */
static bool flag_removed(sph2d_sim *sim)
{
    const sph2d__store *f = &sim->system.fluid;
    bool any = false;
#pragma omp taskloop num_tasks(sph2d__tasks(f->count, SPH2D__GRAIN)) if (f->count > SPH2D__GRAIN) shared(any)
    for (size_t i = 0; i < f->count; ++i) {
        sim->to_remove[i] = sph2d__side_left(&sim->world.box, f->x[i], f->y[i]) >= 0 ||
                            in_drain(sim, f->x[i], f->y[i]) || sph2d__openings_spent(sim, f->x[i], f->y[i]);
        if (sim->to_remove[i]) {
#pragma omp atomic write
            any = true;
        }
    }
    return any;
}

sph2d_status sph2d__sim_remove_flagged(sph2d_sim *sim)
{
    sph2d__store *f = &sim->system.fluid;
    bool surface = sim->system.surface_tension > 0;
    sph2d_box box = EMPTY_BOX;
    sph2d__host_reads(&sim->system, SPH2D__EVERYTHING);
    for (size_t i = 0; i < f->count; ++i)
        if (sim->to_remove[i]) {
            count_removed(sim, i);
            extend_box(sim, i, &box);
        }
    double before = surface ? sph2d__tension_energy_within(&sim->system, box) : 0;
    sph2d__store_remove(f, sim->to_remove);
    sph2d__host_changed(&sim->system, SPH2D__EVERYTHING);
    sph2d_status status = surface ? sph2d__sim_sort_all_arrays(sim) : SPH2D_OK;
    if (surface && status == SPH2D_OK)
        sim->record.energy_fed += sph2d__tension_energy_within(&sim->system, box) - before;
    return status;
}

sph2d_status sph2d__sim_drain(sph2d_sim *sim)
{
    if (!removes_particles(&sim->world.scene))
        return SPH2D_OK;
    if (sim->world.scene.drain_count == 0 && sim->world.scene.opening_count == 0 && sim->none_left)
        return SPH2D_OK;
    sph2d__host_reads(&sim->system, SPH2D__BIT(x) | SPH2D__BIT(y));
    if (!sph2d__sim_reserve_flags(sim))
        return SPH2D_NOMEM;
    return flag_removed(sim) ? sph2d__sim_remove_flagged(sim) : SPH2D_OK;
}
