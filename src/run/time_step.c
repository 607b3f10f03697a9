/* SPDX-License-Identifier: MIT */
/** @file time_step.c
 *  The length of the next step. */
#include <math.h>

#include "run/run.h"

/* A step may be so much longer than the one before it, since jumps pump energy into a leapfrog. */
static const double STEP_GROWTH = 1.2;
/* The first step of liquid that starts in motion against a wall or other liquid, over the one that its speed allows:
 * such a step would put half of the impact's compression, v/c0, into one row of particles at once. Random scenes gained
 * 0.2 to 1.3 % of their energy so, and with this a tenth of that at most. It starts so where density changes by more
 * than this part of what a row would that stops. Ten short steps cost eight more in all. */
static const double FIRST_STEP = 0.1, MEETS = 0.05;

/** Fastest particle that a source may feed at the present moment. */
static double source_speed(const sph2d_sim *sim)
{
    double speed = 0, time = sim->record.time;
    for (size_t i = 0; i < sim->scene.source_count; ++i) {
        const sph2d_source *source = &sim->scene.sources[i];
        if (time >= source->start && (source->stop <= 0 || time < source->stop))
            speed = fmax(speed, source->speed * (1 + source->spread * sqrt(2)));
    }
    return speed;
}

double sph2d__sim_start_speed(const sph2d_sim *sim)
{
    double speed = 0;
    for (size_t i = 0; i < sim->scene.block_count; ++i)
        speed = fmax(speed, hypot(sim->scene.blocks[i].velocity.x, sim->scene.blocks[i].velocity.y));
    return speed;
}

double sph2d__sim_step_part(const sph2d_sim *sim)
{
    const sph2d__store *f = &sim->system.fluid;
    double speed = sph2d__sim_start_speed(sim), rate = 0;
    bool chosen = !(sim->scene.method.time_step > 0), sound = sim->method->density_rate != NULL;
    if (!(speed > 0) || !chosen || !sound || sim->record.steps > 0)
        return 1;
    for (size_t i = 0; i < f->count; ++i)
        rate = fmax(rate, fabs(f->density_rate[i]));
    return rate * sim->system.spacing > MEETS * speed * sim->system.rest_density ? FIRST_STEP : 1;
}

void sph2d__sim_choose_step(sph2d_sim *sim, double fastest, double acceleration)
{
    sph2d__record *r = &sim->record;
    double speed = fmax(fastest, source_speed(sim));
    sph2d__limit limit = SPH2D__LIMIT_FIXED;
    double dt = sim->scene.method.time_step;
    if (!(dt > 0)) {
        dt = sim->method->stable_step(&sim->system, speed, acceleration, &limit);
        if (r->last_step > 0 && dt > STEP_GROWTH * r->last_step)
            dt = STEP_GROWTH * r->last_step;
        dt *= sph2d__sim_step_part(sim);
    }
    r->next_step = dt;
    r->next_limit = limit;
}
