/* SPDX-License-Identifier: MIT */
/** @file rheology.c */
#include "methods/terms/rheology.h"

#include <math.h>

#include "methods/common/slabs.h"

/** g^(n-1), for n < 1 not of less than 1/m. */
static double power_of(const sph2d_fluid *fluid, double g)
{
    double n = fluid->index;
    if (n == 1 || n == 0)
        return 1;
    return pow(n < 1 ? fmax(g, 1 / fluid->regularisation) : g, n - 1);
}

/** (1 - exp(-m g))/g, m at rest. */
static double yielding(double m, double g)
{
    return m * g > 1e-8 ? -expm1(-m * g) / g : m;
}

double sph2d__rheology_viscosity(const sph2d_fluid *fluid, double g)
{
    switch (fluid->model) {
    case SPH2D_RHEOLOGY_POWER_LAW:
        return fluid->consistency * power_of(fluid, g);
    case SPH2D_RHEOLOGY_CARREAU: {
        double lg = fluid->relaxation_time * g, more = fluid->dynamic_viscosity - fluid->infinite_viscosity;
        return fluid->infinite_viscosity + more * pow(1 + lg * lg, (fluid->index - 1) / 2);
    }
    case SPH2D_RHEOLOGY_HERSCHEL_BULKLEY:
        return fluid->consistency * power_of(fluid, g) + fluid->yield_stress * yielding(fluid->regularisation, g);
    case SPH2D_RHEOLOGY_NEWTONIAN:
        break;
    }
    return fluid->dynamic_viscosity;
}

/** g of fluid particle i [1/s]. */
static double shear_rate(const sph2d__store *f, size_t i)
{
    return 2 * sqrt(f->stretch[i] * f->stretch[i] + f->shear[i] * f->shear[i]);
}

static void set_some(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i)
        s->viscosities[i] = sph2d__rheology_viscosity(s->liquid, shear_rate(&s->fluid, i));
}

/** As many as the fluid's store has room for: loops over groups read beyond the last particle. */
static bool reserve(sph2d__system *s)
{
    size_t wanted = s->fluid.capacity + SPH2D__PADDING;
    void *block = s->viscosities;
    if (s->viscosity_capacity >= wanted)
        return true;
    if (!sph2d__resize(s->memory, &block, s->viscosity_capacity, wanted, sizeof(double)))
        return false;
    s->viscosities = block;
    s->viscosity_capacity = wanted;
    return true;
}

bool sph2d__rheology_set(sph2d__system *s)
{
    if (s->liquid->model == SPH2D_RHEOLOGY_NEWTONIAN)
        return true;
    if (!reserve(s))
        return false;
    sph2d__over_particles(s, s->fluid.count, set_some, NULL);
    double most = 0;
    for (size_t i = 0; i < s->fluid.count; ++i)
        most = fmax(most, s->viscosities[i]);
    s->viscosity = s->fluid.count > 0 ? most : sph2d__rheology_viscosity(s->liquid, 0);
    return true;
}
