/* SPDX-License-Identifier: MIT */
/** @file viscosity.c */
#include "methods/terms/viscosity.h"

#include "kernels/kernel.h"

/* The central form damps compression three times as fast as shear. */
static const double CENTRAL = 3;
/* The most that the rate of gathered particles shortens the step: 2.2 to 2.8 for moments in honey poured from a jar. */
static const double GATHERED = 3;

static bool is_laplacian(const sph2d__system *s)
{
    return s->method.viscosity_form == SPH2D_VISCOSITY_MORRIS;
}

sph2d__viscosity sph2d__viscosity_apart(const sph2d__system *s, double laplacian, double central)
{
    double artificial = s->rest_density * s->method.artificial_viscosity * s->sound_speed * s->support / 16;
    return (sph2d__viscosity){.laplacian = is_laplacian(s) ? laplacian : 0,
                              .central = artificial + (is_laplacian(s) ? 0 : central)};
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
    return CENTRAL * artificial + (s->method.viscosity_form == SPH2D_VISCOSITY_MONAGHAN ? CENTRAL : 1) * liquid;
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

double sph2d__viscous_rate(sph2d__viscosity viscosity, double block)
{
    return 2 * 8 * viscosity.central * block;
}

bool sph2d__viscosity_limits(const sph2d__system *s)
{
    double acoustic = s->method.cfl * s->support / s->sound_speed;
    double viscous = sph2d__viscosity_step(s->method.kernel) * s->support * s->support / sph2d__viscosity_limiting(s);
    return sph2d__viscosity_of(s).central > 0 && !(s->method.time_step > 0) && viscous < GATHERED * acoustic;
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
    double r2 = dx * dx + dy * dy, approach = r2 > 0 ? (dvx * dx + dvy * dy) / r2 : 0;
    double shear = 2 * viscosity.laplacian;
    return (sph2d_vec2){share * (8 * viscosity.central * approach * dx + shear * dvx),
                        share * (8 * viscosity.central * approach * dy + shear * dvy)};
}
