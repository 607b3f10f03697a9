/* SPDX-License-Identifier: MIT */
/** @file viscosity.c */
#include "methods/terms/viscosity.h"

#include <math.h>

#include "base/pi.h"
#include "kernels/kernel.h"

double sph2d__central_weight(sph2d_kernel kind, double support)
{
    enum { RINGS = 1000 };
    double integral = 0;
    for (int k = 0; k < RINGS; ++k) {
        double q = (k + 0.5) / RINGS;
        integral += 2 * SPH2D__PI / RINGS * pow(q, 3) * sph2d__kernel_value_at(kind, q);
    }
    return 4 / (sph2d__kernel_constant(kind) * integral * support * support);
}

double sph2d__viscosity_at_least(const sph2d__system *s)
{
    double least = s->method.artificial_viscosity * s->rest_density * s->sound_speed * s->support;
    return s->viscosity > least ? s->viscosity : least;
}

double sph2d__viscosity_step(sph2d_kernel kind)
{
    return 0.067 / (sph2d__kernel_constant(kind) * sph2d__kernel_value_at(kind, 0));
}
