/* SPDX-License-Identifier: MIT */
/** @file plan.c
 *  The plan: numbers of a scene that are known before its run, as `check` prints them. */
#include <math.h>
#include <stdio.h>

#include "run/run.h"

static void write_formula(sph2d_plan *plan, const sph2d_scene *scene, const sph2d__derived *d)
{
    double g = d->gravity;
    char part[16] = ""; /* effective part of the stiffness in pair forces */
    if (d->stiffness_part != 1)
        snprintf(part, sizeof part, "%.3g * ", d->stiffness_part);
    if (scene->method.sound_speed > 0)
        snprintf(plan->sound_speed_formula, sizeof plan->sound_speed_formula,
                 "set by the scene; head %.4g m^2/s^2 gives compression %.3g %%", d->head,
                 100 * d->head / (d->sound_speed * d->sound_speed));
    else if (scene->method.stiffness > 0)
        snprintf(plan->sound_speed_formula, sizeof plan->sound_speed_formula,
                 "sqrt(%sstiffness) = sqrt(%s%g); head %.4g m^2/s^2 gives compression %.3g %%", part, part,
                 scene->method.stiffness, d->head, 100 * d->head / (d->sound_speed * d->sound_speed));
    else if (d->sound_speed <= d->ripple_speed)
        snprintf(plan->sound_speed_formula, sizeof plan->sound_speed_formula,
                 "sqrt(8 sigma/(rho dx)) = sqrt(8 * %g/(%g * %g)), for ripples", scene->fluid.surface_tension,
                 scene->fluid.density, scene->spacing);
    else
        snprintf(plan->sound_speed_formula, sizeof plan->sound_speed_formula,
                 "sqrt(2 (g h + U^2/2 + pull) / %smax_compression) = sqrt(2 (%.4g * %.4g + %.4g^2/2 + %.4g) / %g)",
                 d->soft_compression < scene->method.max_compression ? "0.1 " : "", g, d->height, d->speed, d->pull,
                 d->soft_compression);
}

static double outputs_until(sph2d_rate rate, double until)
{
    double interval = sph2d_rate_interval(rate);
    return interval > 0 ? floor(until / interval * (1 + 1e-12)) + 1 : 0;
}

static const char *limit_name(sph2d__limit limit)
{
    static const char *const names[SPH2D__LIMIT_COUNT] = {"acoustic", "force", "viscous", "fixed"};
    return (unsigned)limit < SPH2D__LIMIT_COUNT ? names[limit] : "unknown";
}

void sph2d__sim_make_plan(sph2d_sim *sim)
{
    const sph2d_scene *scene = &sim->world.scene;
    const sph2d__system *s = &sim->system;
    const sph2d__derived d = sim->world.derived;
    sph2d_plan *plan = &sim->plan;
    plan->fluid_particles = s->fluid.count;
    plan->wall_particles = s->walls.count;
    plan->particle_mass = s->mass;
    plan->support_radius = s->support;
    plan->sound_speed = s->sound_speed;
    write_formula(plan, scene, &d);
    plan->head = d.head;
    plan->capillary_head = d.capillary_head;
    plan->impact_compression = sqrt(2 * (d.head + d.capillary_head)) / s->sound_speed;
    plan->time_step = sim->record.next_step;
    plan->time_step_limit = limit_name((sph2d__limit)sim->record.next_limit);
    plan->steps = ceil(scene->run.until / plan->time_step);
    plan->memory = (double)sim->memory.bytes;
    plan->snapshots = outputs_until(scene->run.snapshots.rate, scene->run.until);
    plan->frames = outputs_until(scene->run.frames.rate, scene->run.until);
    plan->disk = plan->snapshots * sph2d__snapshot_bytes(sim, &plan->disk_of_particle);
    plan->disk_of_particle *= plan->snapshots;
}
