/* SPDX-License-Identifier: MIT */
/** @file wcsph_limits.c
 *  How long a step of methods `wcsph` and `constraint` may be, and into how many acoustic ones it is cut. */
#include <math.h>

#include "methods/terms/tension.h"
#include "methods/wcsph/wcsph.h"
#include "scene/derive.h"

/* Acoustic steps in a step, at most. */
enum { MOST_STEPS = 5 };
/* Way of the fastest particle in a step, over H. */
static const double WAY = 0.125;

double sph2d__head_of_sound(const sph2d__system *s)
{
    return s->sound_speed * s->sound_speed * s->method.max_compression / SPH2D__OVERSHOOT;
}

/* Part of the longest step that a lattice bears: a tank at rest melts from 0.95 on, with any kernel and support. */
static const double STEADY = 0.83;

/** The longest step in which pairs may stand still. What is out of place by u under a pressure p is pushed back by
 *  K p u/(rho dx^2) with K the lattice's stiffness, 2.8 for the default kernel, as in a leapfrog: dt^2 K p/(rho dx^2) < 4. */
static double steady_step(const sph2d__system *s)
{
    const double c2 = s->sound_speed * s->sound_speed;
    double pressed = fmax(s->head, sph2d__head_of_sound(s));
    pressed = fmax(pressed, c2 * s->max_log_density);
    return STEADY * 2 * s->spacing / sqrt(s->lattice_stiffness * pressed);
}

/* Part of the longest acoustic step that is stable with viscosity: of 1 over half the largest rate in a lattice. */
static const double VISCOUS = 0.5;

/** Half the largest rate in a lattice [1/s]. */
static double viscous_rate(const sph2d__system *s)
{
    return s->viscosity / s->rest_density * s->central_weight * s->lattice_slopes;
}

bool sph2d__viscous_at_once(const sph2d__system *s, double dt)
{
    return viscous_rate(s) * dt <= VISCOUS;
}

/** The longest acoustic step, and what limits it. */
static double acoustic_step(const sph2d__system *s, double speed, sph2d__limit *limit)
{
    const double sound = s->method.cfl * s->support / (s->sound_speed + speed);
    const double rate = viscous_rate(s);
    *limit = rate * sound > VISCOUS ? SPH2D__LIMIT_VISCOUS : SPH2D__LIMIT_ACOUSTIC;
    return rate * sound > VISCOUS ? VISCOUS / rate : sound;
}

size_t sph2d__acoustic_steps(const sph2d__system *s, double dt)
{
    sph2d__limit limit;
    return (size_t)fmax(1, ceil(dt / acoustic_step(s, s->speed, &limit) * (1 - 1e-12)));
}

double sph2d__wcsph_stable_step(const sph2d__system *s, double speed, double acceleration, sph2d__limit *limit)
{
    const double step = acoustic_step(s, speed, limit), capillary = sph2d__tension_step(s);
    const double steps = speed > 0 ? floor(WAY * s->support / (speed * step)) : MOST_STEPS;
    (void)acceleration;
    const double most = step * fmax(1, fmin(fmin(steps, MOST_STEPS), floor(steady_step(s) / step)));
    if (most > capillary)
        *limit = SPH2D__LIMIT_FORCE;
    return fmin(most, capillary);
}

/* The same where particles are shifted, which a step does only so far: with 1 the wake of a circle opens a void. */
static const double SHIFTED_WAY = 0.5;

double sph2d__implicit_stable_step(const sph2d__system *s, double speed, double acceleration, sph2d__limit *limit)
{
    const double part = s->fills ? SHIFTED_WAY : 1;
    const double way = part * s->method.cfl * s->support / fmax(speed, 1e-300), longest = steady_step(s);
    (void)acceleration;
    *limit = way < longest ? SPH2D__LIMIT_ACOUSTIC : SPH2D__LIMIT_FORCE;
    const double capillary = sph2d__tension_step(s), most = fmin(way, longest);
    if (most > capillary)
        *limit = SPH2D__LIMIT_FORCE;
    return fmin(most, capillary);
}
