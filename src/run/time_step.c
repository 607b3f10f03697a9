/* SPDX-License-Identifier: MIT */
/** @file time_step.c
 *  The length of the next step. */
#include <math.h>

#include "run/run.h"

/* Maximum ratio of a step to the one before: sudden changes of the step add energy to a leapfrog. */
static const double STEP_GROWTH = 1.2;
/* Factor on the first step of liquid that starts with an impact on a wall, a body or other liquid: a full step would put half
 * of the impact's compression, v/c0, into one row of particles at once. Random scenes gained 0.2 to 1.3 % of energy by
 * that, and at most a tenth of it with a short first step. A start is an impact if the largest rate of density is above
 * IMPACT_RATE times that of a row that stops, rho0 v/dx. Growing from a tenth costs about eight steps more. */
static const double FIRST_STEP = 0.1, IMPACT_RATE = 0.05;

/** Largest speed of a particle that a source or opening may let in now. */
static double source_speed(const sph2d_sim *sim)
{
    double speed = 0, time = sim->record.time;
    for (size_t i = 0; i < sim->scene.opening_count; ++i)
        speed = fmax(speed, sph2d__opening_speed(&sim->given, &sim->scene.openings[i]));
    for (size_t i = 0; i < sim->scene.source_count; ++i) {
        const sph2d_source *source = &sim->scene.sources[i];
        if (time >= source->start && (source->stop <= 0 || time < source->stop))
            speed = fmax(speed, source->speed * (1 + source->spread * sqrt(2)));
    }
    return speed;
}

double sph2d__sim_start_speed(const sph2d_sim *sim)
{
    double speed = sph2d__bodies_speed(sim);
    for (size_t i = 0; i < sim->scene.block_count; ++i)
        speed = fmax(speed, hypot(sim->scene.blocks[i].velocity.x, sim->scene.blocks[i].velocity.y));
    return speed;
}

double sph2d__sim_first_step_factor(const sph2d_sim *sim)
{
    const sph2d__store *f = &sim->system.fluid;
    double speed = sph2d__sim_start_speed(sim), rate = 0;
    bool adaptive = !(sim->scene.method.time_step > 0), integrates_density = sim->method->density_rate;
    if (!(speed > 0) || !adaptive || !integrates_density || sim->record.steps > 0)
        return 1;
    for (size_t i = 0; i < f->count; ++i)
        rate = fmax(rate, fabs(f->density_rate[i]));
    return rate * sim->system.spacing > IMPACT_RATE * speed * sim->system.rest_density ? FIRST_STEP : 1;
}

void sph2d__sim_choose_step(sph2d_sim *sim, double fastest, double acceleration)
{
    sph2d__record *r = &sim->record;
    double speed = fmax(fmax(fastest, source_speed(sim)), sph2d__bodies_speed(sim));
    sph2d__limit limit = SPH2D__LIMIT_FIXED;
    double dt = sim->scene.method.time_step;
    if (!(dt > 0)) {
        dt = sim->method->stable_step(&sim->system, speed, acceleration, &limit);
        double bodies = sph2d__bodies_step(sim);
        limit = bodies < dt ? SPH2D__LIMIT_FORCE : limit;
        dt = fmin(dt, bodies);
        if (r->last_step > 0 && dt > STEP_GROWTH * r->last_step)
            dt = STEP_GROWTH * r->last_step;
        dt *= sph2d__sim_first_step_factor(sim);
    }
    r->next_step = dt;
    r->next_limit = limit;
}
