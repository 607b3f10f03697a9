/* SPDX-License-Identifier: MIT */
/** @file methods.c
 *  The table of methods. */
#include "methods/method.h"

#include <math.h>

#include "kernels/kernel.h"
#include "methods/constraint.h"
#include "methods/muller.h"
#include "methods/pcisph.h"
#include "methods/tension.h"
#include "methods/wcsph.h"
#include "methods/wcsph_fitted.h"

const char *sph2d__limit_name(sph2d__limit limit)
{
    static const char *const names[SPH2D__LIMIT_COUNT] = {"acoustic", "force", "viscous", "fixed"};
    return (unsigned)limit < SPH2D__LIMIT_COUNT ? names[limit] : "unknown";
}

const sph2d__method *sph2d__method_find(const sph2d_method_options *options)
{
    if (options->name == SPH2D_METHOD_MULLER)
        return &sph2d__muller;
    if (options->name == SPH2D_METHOD_PCISPH)
        return &sph2d__pcisph;
    if (options->name == SPH2D_METHOD_CONSTRAINT)
        return &sph2d__constraint;
    return options->operators == SPH2D_OPERATORS_FITTED ? &sph2d__wcsph_fitted : &sph2d__wcsph;
}

double sph2d__viscous_limit(sph2d_kernel kernel)
{
    return 0.067 / (sph2d__kernel_constant(kernel) * sph2d__kernel_value_at(kernel, 0));
}

double sph2d__shortest_step(const sph2d__system *s, double sound, double speed, double acceleration, double nu,
                            double viscous, double force, sph2d__limit *limit)
{
    double limits[3] = {
        [SPH2D__LIMIT_ACOUSTIC] = s->method.cfl * s->support / (sound + speed),
        [SPH2D__LIMIT_FORCE] =
            fmin(acceleration > 0 ? force * sqrt(s->support / acceleration) : INFINITY, sph2d__tension_step(s)),
        [SPH2D__LIMIT_VISCOUS] = nu > 0 ? viscous * s->support * s->support / nu : INFINITY};
    *limit = SPH2D__LIMIT_ACOUSTIC;
    for (int k = 0; k < 3; ++k)
        if (limits[k] < limits[*limit])
            *limit = (sph2d__limit)k;
    return limits[*limit];
}
