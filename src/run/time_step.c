/* SPDX-License-Identifier: MIT */
/** @file time_step.c
 *  The length of the next step. */
#include <math.h>

#include "run/run.h"

/* Maximum ratio of a step to the one before: sudden changes of the step add energy to a leapfrog. */
static const double STEP_GROWTH = 1.2;
/** Largest speed of a particle that a source or opening may let in now. */
static double source_speed(const sph2d_sim *sim)
{
    double speed = 0, time = sim->record.time;
    for (size_t i = 0; i < sim->world.scene.opening_count; ++i)
        speed = fmax(speed, sph2d__opening_speed(&sim->world.scene, &sim->world.scene.openings[i]));
    for (size_t i = 0; i < sim->world.scene.source_count; ++i) {
        const sph2d_source *source = &sim->world.scene.sources[i];
        if (time >= source->start && (source->stop <= 0 || time < source->stop))
            speed = fmax(speed, source->speed * (1 + source->spread * sqrt(2)));
    }
    return speed;
}

void sph2d__sim_choose_step(sph2d_sim *sim, double fastest, double acceleration)
{
    sph2d__record *r = &sim->record;
    double speed = fmax(fmax(fastest, source_speed(sim)), sph2d__bodies_speed(sim));
    sph2d__limit limit = SPH2D__LIMIT_FIXED;
    double dt = sim->world.scene.method.time_step;
    if (!(dt > 0)) {
        dt = sim->method->stable_step(&sim->system, speed, acceleration, &limit);
        double bodies = sph2d__bodies_step(sim);
        limit = bodies < dt ? SPH2D__LIMIT_FORCE : limit;
        dt = fmin(dt, bodies);
        if (r->last_step > 0 && dt > STEP_GROWTH * r->last_step)
            dt = STEP_GROWTH * r->last_step;
    }
    r->next_step = dt;
    r->next_limit = limit;
}
