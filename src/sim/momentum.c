/* SPDX-License-Identifier: MIT */
/** @file momentum.c
 *  The momentum balance: what liquid gets that neither walls nor bodies nor external forces gave it.
 *
 *  Over a step the momentum of the liquid changes by
 *
 *      dt sum_i m f_i - I        f_i gravity, interactions, the pointer, the frame of a tank, in the mean of both ends, or
 *                                as the step had it in methods that know it;
 *                                I  the impulse on all walls and bodies (loads.c),
 *
 *  as forces between particles are equal and opposite. What is left, over dt, is a force that comes from nothing,
 *  which is integrated over time by the trapezoidal rule. It is found in every step of methods with a projection, where
 *  the forces of all boundary particles take 0.5 % of a step, and in every 8th of others, where they take 3 %. Of a
 *  step before which particles came or went, whose first forces are those of the liquid before, the error counts for that
 *  step alone. Particles that openings hold have forces that are not known, and so have walls of fitted operators. */
#include <math.h>

#include "methods/common/on_device.h"
#include "methods/common/slabs.h"
#include "sim/balance.h"
#include "sim/simulation.h"

enum { WATCH_STEPS = 8 };

bool sph2d__sim_momentum_is_known(const sph2d_sim *sim)
{
    return sim->openings.count == 0 && sim->method->wall_force;
}

/** Whether a step is watched. */
static bool is_watched(const sph2d_sim *sim, uint64_t step)
{
    return (sim->method->mean_forces || step % WATCH_STEPS == 1) && sph2d__sim_momentum_is_known(sim);
}

/** Whether particles came or went since the step before. */
static bool has_changed(sph2d_sim *sim)
{
    sph2d__record *r = &sim->record;
    const uint64_t changes = 2 * r->next_id - sim->system.fluid.count, before = r->momentum_changes;
    r->momentum_changes = changes;
    return changes != before && r->steps > 0;
}

/** Momentum of the liquid, the external force on it, and the sum of the sizes of momenta. */
typedef struct sums {
    sph2d_vec2 momentum, force; /**< [kg/s], [N/m] */
    double moved;               /**< [kg/s] */
} sums;

static void sum_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const sph2d__forces *external = with;
    for (size_t i = slab->first; i < slab->last; ++i)
        sph2d__add_momentum(s, external, i, sum);
}

static sums sum(const sph2d_sim *sim, sph2d_vec2 gravity)
{
    sph2d__forces external = sim->system.forces;
    external.springs.stiffness = 0; /* which are walls */
    external.gravity.x = gravity.x;
    external.gravity.y = gravity.y;
    const sph2d__slab_sum s = sph2d__is_on_device(&sim->system)
                                  ? sph2d__device_sum(&sim->system, "sum_momentum", &gravity, sizeof gravity)
                                  : sph2d__sum_fluid(&sim->system, sum_slab, &external);
    const double m = sim->system.mass;
    return (sums){{m * s.x, m * s.y}, {m * s.first, m * s.second}, m * s.third};
}

/* The forces of the start of a step are those of the last evaluation: of the walls as loads have them, which so count
 * from one step before. */
void sph2d__momentum_begin(sph2d_sim *sim)
{
    const uint64_t step = sim->record.steps + 1;
    sim->momentum_cut = sim->record.momentum_changes == SPH2D__MOMENTUM_CUT;
    sim->momentum_changed = has_changed(sim);
    sim->momentum_watched = is_watched(sim, step);
    sim->loads.watched = sim->momentum_watched || is_watched(sim, step + 1);
    if (!sim->momentum_watched)
        return;
    if (sim->momentum_kept != step || sim->momentum_changed) {
        const sums s = sum(sim, (sph2d_vec2){sim->acting.gravity_x, sim->acting.gravity_y});
        sim->momentum_before = s.momentum;
        sim->force_before = s.force;
    }
    sim->loads.states[sim->loads.count].impulse = (sph2d__pull){0, 0, 0};
}

/** Adds an error that grows at a rate, which is integrated from its last sample on. */
static void book(double *error, double *last, double rate, double span)
{
    *error += span * (*last + rate) / 2;
    *last = rate;
}

void sph2d__momentum_end(sph2d_sim *sim, double dt)
{
    const bool cut =
        sim->momentum_cut && !sim->method->mean_forces; /* the forces of the start are of what is gone, too */
    if (!sim->momentum_watched)
        return;
    sph2d__record *r = &sim->record;
    const sph2d__pull *on_walls = &sim->loads.states[sim->loads.count].impulse;
    const sums s = sum(sim, (sph2d_vec2){sim->system.forces.gravity.x, sim->system.forces.gravity.y});
    const double now = r->time + dt, span = now - r->momentum_time, half = dt / 2;
    const sph2d_vec2 both = {sim->force_before.x + s.force.x, sim->force_before.y + s.force.y},
                     mean = sim->system.external;
    const bool known = sim->method->books_all;
    const double x = s.momentum.x - sim->momentum_before.x - (known ? dt * mean.x : half * both.x) + on_walls->x,
                 y = s.momentum.y - sim->momentum_before.y - (known ? dt * mean.y : half * both.y) + on_walls->y;
    if (sim->momentum_changed && !cut) {
        r->momentum_error_x += x;
        r->momentum_error_y += y;
    } else if (!cut) {
        book(&r->momentum_error_x, &r->momentum_rate_x, x / dt, span);
        book(&r->momentum_error_y, &r->momentum_rate_y, y / dt, span);
        r->momentum_time = now;
    }
    sim->momentum_before = s.momentum;
    sim->force_before = s.force;
    sim->momentum_kept = sim->world.scene.absorber_count == 0 ? r->steps + 2 : 0; /* this one is not counted yet */
    r->momentum_moved = fmax(r->momentum_moved, s.moved);
    r->momentum_worst = fmax(r->momentum_worst, hypot(r->momentum_error_x, r->momentum_error_y));
}
