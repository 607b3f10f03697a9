/* SPDX-License-Identifier: MIT */
/** @file hybrid.c
 *  Method `hybrid`: setup, densities, order of the particles, step. The pair loops are in hybrid_pass.c. */
#include "methods/hybrid/hybrid.h"

#include <math.h>

#include "base/parallel.h"
#include "kernels/kernel.h"
#include "methods/common/on_device.h"
#include "methods/hybrid/grid.h"
#include "methods/hybrid/hybrid_spans.h"
#include "methods/terms/tension.h"
#include "scene/method_table.h"
#include "sim/stages.h"

/* Lattice sites on either side of a particle. */
enum { REACH = 4 };

/** Sets the sum of f over a full lattice, and the factor of the sums of order(): with l and b in units of K. */
static void prepare(sph2d__system *s)
{
    double values = 0, squares = 0;
    for (int i = -REACH; i <= REACH; ++i)
        for (int j = -REACH; j <= REACH; ++j) {
            const double q = hypot(i, j) * s->spacing / s->support, t = fmax(1 - q, 0);
            values += sph2d__kernel_value_at(SPH2D_KERNEL_WENDLAND_C2, q);
            squares += pow(t, 6) * (i * i + j * j) * s->spacing * s->spacing;
        }
    const double slope = 20 / (values * s->support * s->support); /* grad W = -slope t^3 (x_i - x_j) */
    s->lattice_values = values;
    s->lattice_slopes = 1 / (slope * squares); /* slope K */
}

/* ---- packed copies ----------------------------------------------------------------------------------------------- */

static void pack(sph2d__system *s)
{
    sph2d__over_particles(s, s->fluid.count, pack_fluid, "pack_fluid_pass");
    sph2d__over_particles(s, s->walls.count, pack_walls, "wall_pack_pass");
    if (s->grid)
        s->grid->packed = s->fluid.capacity;
}

/* ---- one step ---------------------------------------------------------------------------------------------------- */

static bool evaluate(sph2d__system *s)
{
    const sph2d_phase before = sph2d__profile_enter(&s->profile, SPH2D_PHASE_DENSITY);
    pack(s);
    sph2d__over_particles(s, s->fluid.count, sph2d__hybrid_passes_best(s->isa)->density, "density_pass");
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_FORCES);
    sph2d__over_particles(s, s->fluid.count, accelerate, "accelerate_pass");
    sph2d__tension_add(s);
    sph2d__profile_enter(&s->profile, before);
    return true;
}

/** Begins to set the displacements e_i, in shift_x and shift_y [m], from places and densities at the start of a step: threads
 *  are at it while the caller is at the grid, and then waits for them by `omp taskwait`. */
static void begin_order(sph2d__system *s)
{
    if (s->grid->packed != s->fluid.capacity) { /* none were, or a source made room */
        pack(s);
        sph2d__over_particles(s, s->fluid.count, sph2d__hybrid_passes_best(s->isa)->pack, "pack_pass");
    }
    s->grid->packed = 0; /* until the places at the end of the step are */
    sph2d__begin_over_particles(s, s->fluid.count, sph2d__hybrid_passes_best(s->isa)->order, "order_pass");
}

/** Energy of the liquid, and the power of the forces without a potential. */
typedef struct energies {
    double energy, power;
} energies;

static energies energies_of(const sph2d_sim *sim)
{
    return (energies){sph2d__sim_energy_of_all(sim), sph2d__sim_power_of_forces(sim) - sph2d__bodies_power(sim)};
}

/** Evaluates densities and accelerations, then the energy of the surface; returns how much more that is [J/m]. */
static sph2d_status evaluate_all(sph2d_sim *sim, double *more)
{
    sph2d__grid *g = sim->system.grid;
    const double before = g->surface_energy;
    const bool ok = evaluate(&sim->system);
    g->surface_energy = sim->system.surface_tension > 0 ? sph2d__tension_energy(&sim->system) : 0;
    *more = g->surface_energy - before;
    return ok ? SPH2D_OK : SPH2D_NOMEM;
}

/** Sorts and evaluates again when particles came or went since the last step, or gravity or the pointer were set: at its end,
 *  both are of those there were. */
static sph2d_status take_in(sph2d_sim *sim)
{
    sph2d__grid *g = sim->system.grid;
    if (g->next_id == sim->record.next_id && g->count == sim->system.fluid.count && !sph2d__sim_is_steered(sim))
        return SPH2D_OK;
    const sph2d_status status = sph2d__sort_fluid(sim);
    if (status != SPH2D_OK)
        return status;
    g->next_id = sim->record.next_id;
    g->count = sim->system.fluid.count;
    sph2d__sim_act(sim);
    double brought;
    return evaluate_all(sim, &brought);
}

static sph2d_status step(sph2d_sim *sim, double dt)
{
    sph2d__system *s = &sim->system;
    sph2d__record *r = &sim->record;
    sph2d_status status = sph2d__grid_prepare(sim);
    if (status == SPH2D_OK)
        status = take_in(sim);
    if (status != SPH2D_OK)
        return status;
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_BOOKKEEPING);
    sph2d__host_reads_block(s, s->fluid_cells.start);
#pragma omp task if (!s->grid->on_device)
    sph2d__grid_find_spans(sim, s->grid);
    const energies before = energies_of(sim);
    const double booked = r->energy_stopped - r->energy_walls;
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_MOVE);
    sph2d__over_particles(s, s->fluid.count, kick, "kick_pass");
    sph2d__bodies_fall(sim, dt);
    sph2d__sim_set_drift_interval(sim, r->time, r->time + dt);
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_SOLVE);
#pragma omp taskwait
    if (!sph2d__grid_cut(sim, s->grid))
        status = SPH2D_NOMEM; /* returned once the threads are done */
    sph2d__grid_open_nozzles(sim, s->grid);
    sph2d__grid_sum(sim, s->grid, dt);
    begin_order(s);
    sph2d__grid_passes_find(s->isa)->solve(s->grid, dt * s->viscosity / s->rest_density);
#pragma omp taskwait
    if (status != SPH2D_OK)
        return status;
    if (sim->moving_count > sim->bodies.count)
        r->energy_walls += sph2d__grid_wall_work(s->grid, s->rest_density);
    const double fed = sph2d__grid_nozzle_work(s->grid, s->rest_density);
    r->energy_fed += fed;
    double on_bodies = 0;
    if (s->grid->body_count > 0) {
        sph2d__grid_impulses(s->grid, s->rest_density, s->grid->impulses);
        status = sph2d__bodies_push(sim, dt, s->grid->impulses, &on_bodies);
        if (status != SPH2D_OK)
            return status;
        sph2d__sim_set_drift_interval(sim, r->time, r->time + dt);
    }
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_MOVE);
    status = sph2d__advect(sim, dt, sph2d__transfer_passes_find(s->isa)->move, NULL);
    if (status != SPH2D_OK)
        return status;
    status = sph2d__sort_fluid(sim);
    if (status != SPH2D_OK)
        return status;
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_BOOKKEEPING);
    const energies after = energies_of(sim);
    r->work_pressed += on_bodies + after.energy - before.energy - dt * (before.power + after.power) / 2 +
                       (r->energy_stopped - r->energy_walls - booked) - fed;
    status = sph2d__sim_update_forcing(sim, r->time + dt);
    if (status != SPH2D_OK)
        return status;
    double more;
    status = evaluate_all(sim, &more);
    r->work_pressed += more;
    return status;
}

/* ---- the method -------------------------------------------------------------------------------------------------- */

/** Pressure keeps the density, and stores nothing. */
static double elastic(const sph2d__system *s, size_t i, bool stepped)
{
    (void)s;
    (void)i;
    (void)stepped;
    return 0;
}

/* The part of its energy by which liquid may swing in a central force of rate B, as it is B dt/2: places are half a step
 * ahead of velocities. */
static const double SWING = 0.01;

/** The liquid as fast as it can fall goes cfl H: one step for all, so that a drop may be faster. */
static double stable_step(const sph2d__system *s, double speed, double acceleration, sph2d__limit *limit)
{
    (void)acceleration;
    const double fall = sqrt(2 * s->head);
    *limit = SPH2D__LIMIT_FIXED;
    const double fastest = fall > 0 ? fall : speed > 0 ? speed : s->support;
    const double swung = s->forces.central.rate2 > 0 ? 2 * SWING / sqrt(s->forces.central.rate2) : INFINITY;
    return fmin(fmin(s->method.cfl * s->support / fastest, swung), sph2d__tension_step(s));
}

const sph2d__method sph2d__hybrid = {
    .name = "hybrid",
    .step = step,
    .fluid = SPH2D__STORE_BASIC | SPH2D__BIT(ax) | SPH2D__BIT(ay) | SPH2D__BIT(density) | SPH2D__BIT(pressure) |
             SPH2D__BIT(shift_x) | SPH2D__BIT(shift_y) | SPH2D__BIT(stretch) | SPH2D__BIT(shear) |
             SPH2D__BIT(rotation) | SPH2D__BIT(packed_place) | SPH2D__BIT(packed_state),
    .carried = SPH2D__STORE_BASIC | SPH2D__BIT(stretch) | SPH2D__BIT(shear) | SPH2D__BIT(rotation) | SPH2D__BIT(ax) |
               SPH2D__BIT(ay) | SPH2D__BIT(density) | SPH2D__BIT(pressure),
    .walls = SPH2D__STORE_BASIC | SPH2D__BIT(normal_x) | SPH2D__BIT(normal_y) | SPH2D__BIT(depth) | SPH2D__BIT(ax) |
             SPH2D__BIT(ay) | SPH2D__BIT(start_x) | SPH2D__BIT(start_y) | SPH2D__BIT(mass) | SPH2D__BIT(bounce) |
             SPH2D__BIT(density) | SPH2D__BIT(pressure) | SPH2D__BIT(packed_place) | SPH2D__BIT(packed_state),
    .prepare = prepare,
    .evaluate = evaluate,
    .elastic = elastic,
    .books_pressure = true,
    .books_walls = true,
    .couples_bodies = true,
    .walls_hold = true,
    .stable_step = stable_step,
};
