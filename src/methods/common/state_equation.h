/* SPDX-License-Identifier: MIT */
/** @file state_equation.h
 *  Pressure from density in method `wcsph`, and back.
 *
 *      fitted operators        p = c0^2 (rho - rho0)
 *      variational operators   p = c0^2 rho ln(rho/rho0)
 *
 *  Both have dp/drho = c0^2 at rest density. The elastic energy per mass of the first,
 *
 *      e = integral of p/rho^2 drho = c0^2 (ln x + 1/x - 1),   x = rho/rho0,
 *
 *  has its minimum, 0, at rest density. */
#ifndef SPH2D_METHODS_COMMON_STATE_EQUATION_H
#define SPH2D_METHODS_COMMON_STATE_EQUATION_H

#include <math.h>

#include "base/elementary.h"
#include "base/parallel.h"
#include "methods/common/system.h"

/** Whether p = rho c0^2 ln(rho/rho0): with the operators of methods/wcsph. */
static inline bool sph2d__is_logarithmic(const sph2d__system *s)
{
    return s->method.name == SPH2D_METHOD_CONSTRAINT ||
           (s->method.name == SPH2D_METHOD_WCSPH && s->method.operators == SPH2D_OPERATORS_VARIATIONAL);
}

static inline double sph2d__pressure_of(const sph2d__system *s, double density)
{
    double c2 = s->sound_speed * s->sound_speed;
    if (sph2d__is_logarithmic(s))
        return c2 * density * sph2d__log(density / s->rest_density);
    return c2 * (density - s->rest_density);
}

/** The inverse; at least a thousandth of the rest density, for pressures that the equation cannot give. */
static inline double sph2d__density_of(const sph2d__system *s, double pressure)
{
    double c2 = s->sound_speed * s->sound_speed;
    if (sph2d__is_logarithmic(s)) {
        double part = fmax(pressure / (s->rest_density * c2), -0.3), x = 1 + part; /* x ln x, at least -1/e */
        for (int k = 0; k < 6; ++k)
            x -= (x * sph2d__log(x) - part) / (sph2d__log(x) + 1);
        return x * s->rest_density;
    }
    return fmax(s->rest_density + pressure / c2, 1e-3 * s->rest_density);
}

/** e: elastic energy per mass [J/kg]. */
static inline double sph2d__elastic_of(const sph2d__system *s, double density)
{
    if (s->modulus > 0) { /* density by summation */
        double x = fmax(density / s->rest_density, 1);
        return s->modulus * (sph2d__log(x) + 1 / x - 1);
    }
    double x = density / s->rest_density;
    return s->sound_speed * s->sound_speed * (sph2d__log(x) + 1 / x - 1);
}

/** Sets the pressure of every fluid particle. */
static inline void sph2d__state_equation_apply(sph2d__system *s)
{
    const sph2d__store *f = &s->fluid;
#pragma omp taskloop num_tasks(sph2d__tasks(f->count, SPH2D__GRAIN)) if (f->count > SPH2D__GRAIN)
    for (size_t i = 0; i < f->count; ++i)
        f->pressure[i] = sph2d__pressure_of(s, f->density[i]);
}

#endif
