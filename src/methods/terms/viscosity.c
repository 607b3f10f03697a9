/* SPDX-License-Identifier: MIT */
/** @file viscosity.c */
#include "methods/terms/viscosity.h"

#include <math.h>

#include "base/pi.h"
#include "kernels/kernel.h"

/* Steps of the Laplacian form over those of the central form, and of artificial viscosity. */
static const double CENTRAL = 2, ARTIFICIAL = 3;
/* The most that the rate of gathered particles shortens the step, with a margin: 1.1 in syrup poured from a jar. */
static const double GATHERED = 2;

static bool is_laplacian(const sph2d__system *s)
{
    return s->method.viscosity_form == SPH2D_VISCOSITY_MORRIS;
}

sph2d__viscosity sph2d__viscosity_apart(const sph2d__system *s, double laplacian, double central)
{
    double artificial = s->rest_density * s->method.artificial_viscosity * s->sound_speed * s->support / 16;
    return (sph2d__viscosity){.laplacian = is_laplacian(s) ? laplacian : 0,
                              .central = is_laplacian(s) ? 0 : s->central_weight * central,
                              .artificial = 8 * artificial};
}

sph2d__viscosity sph2d__viscosity_of(const sph2d__system *s)
{
    return sph2d__viscosity_apart(s, s->viscosity, s->viscosity);
}

sph2d__viscosity sph2d__viscosity_at(const sph2d__system *s, size_t i)
{
    double viscosity = s->viscosities ? s->viscosities[i] : s->viscosity;
    return sph2d__viscosity_apart(s, viscosity, viscosity);
}

double sph2d__viscosity_limiting(const sph2d__system *s)
{
    double artificial = s->method.artificial_viscosity * s->sound_speed * s->support / 16;
    double liquid = s->viscosity / s->rest_density;
    return ARTIFICIAL * artificial + (s->method.viscosity_form == SPH2D_VISCOSITY_MONAGHAN ? CENTRAL : 1) * liquid;
}

double sph2d__central_weight(sph2d_kernel kernel, double support)
{
    enum { RINGS = 1000 };
    double integral = 0;
    for (int k = 0; k < RINGS; ++k) {
        double q = (k + 0.5) / RINGS;
        integral += 2 * SPH2D__PI / RINGS * pow(q, 3) * sph2d__kernel_value_at(kernel, q);
    }
    return 4 / (sph2d__kernel_constant(kernel) * integral * support * support);
}

double sph2d__viscosity_at_least(const sph2d__system *s)
{
    double least = s->method.artificial_viscosity * s->rest_density * s->sound_speed * s->support;
    return s->viscosity > least ? s->viscosity : least;
}

double sph2d__viscosity_step(sph2d_kernel kernel)
{
    return 0.067 / (sph2d__kernel_constant(kernel) * sph2d__kernel_value_at(kernel, 0));
}

bool sph2d__viscosity_limits(const sph2d__system *s)
{
    double acoustic = s->method.cfl * s->support / s->sound_speed;
    double viscous = sph2d__viscosity_step(s->method.kernel) * s->support * s->support / sph2d__viscosity_limiting(s);
    sph2d__viscosity of = sph2d__viscosity_of(s);
    return of.central + of.artificial > 0 && !(s->method.time_step > 0) && viscous < GATHERED * acoustic;
}

void sph2d__viscous_rate_raise(sph2d__system *s, double rate)
{
    double most;
    __atomic_load(&s->viscous_rate, &most, __ATOMIC_RELAXED);
    while (rate > most &&
           !__atomic_compare_exchange(&s->viscous_rate, &most, &rate, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {}
}

sph2d_vec2 sph2d__viscosity_force(sph2d__viscosity viscosity, double share, double dx, double dy, double dvx,
                                  double dvy)
{
    double r2 = dx * dx + dy * dy, shear = 2 * viscosity.laplacian;
    double along = (viscosity.central + (r2 > 0 ? viscosity.artificial / r2 : 0)) * (dvx * dx + dvy * dy);
    return (sph2d_vec2){share * (along * dx + shear * dvx), share * (along * dy + shear * dvy)};
}
