/* SPDX-License-Identifier: MIT */
/** @file stable_step.c */
#include "methods/terms/stable_step.h"

#include <math.h>

#include "methods/terms/tension.h"

double sph2d__shortest_step(const sph2d__system *s, double sound_speed, double speed, double acceleration, double nu,
                            double viscous, double force, sph2d__limit *limit)
{
    double limits[3] = {
        [SPH2D__LIMIT_ACOUSTIC] = s->method.cfl * s->support / (sound_speed + speed),
        [SPH2D__LIMIT_FORCE] =
            fmin(acceleration > 0 ? force * sqrt(s->support / acceleration) : INFINITY, sph2d__tension_step(s)),
        [SPH2D__LIMIT_VISCOUS] = nu > 0 ? viscous * s->support * s->support / nu : INFINITY};
    *limit = SPH2D__LIMIT_ACOUSTIC;
    for (int k = 0; k < 3; ++k)
        if (limits[k] < limits[*limit])
            *limit = (sph2d__limit)k;
    return limits[*limit];
}
