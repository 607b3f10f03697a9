/* SPDX-License-Identifier: MIT */
/** @file resolve.c
 *  Defaults of the method, the search radius, and periods. */
#include "scene/resolve.h"

#include <math.h>

#include "scene/method_table.h"

/* What may be left of the equations of method constraint, over their right side. A dam break is the same with 1e-2; the
 * pressures of a tank at rest tremble by 0.7 % of rho g H with that, by 0.4 % with 3e-3 and less. */
static const double TOLERANCE = 5e-3;

static double or_else(double value, double default_value)
{
    return value > 0 ? value : default_value;
}

sph2d_method_options sph2d__method_resolve(sph2d_method_options m)
{
    const sph2d__method_row *row = sph2d__method_row_of(&m);
    m.max_compression = or_else(m.max_compression, row->info.max_compression);
    double support = row->support_of_kernel ? row->support_of_kernel(m.kernel) : row->info.support_ratio;
    m.support_ratio = or_else(m.support_ratio, support);
    m.cfl = or_else(m.cfl, row->cfl_by_spacing ? row->cfl / m.support_ratio : row->cfl);
    m.artificial_viscosity = or_else(m.artificial_viscosity, row->artificial_viscosity);
    m.tolerance = or_else(m.tolerance, TOLERANCE);
    return m;
}

double sph2d__period_x(const sph2d_scene *scene)
{
    return scene->boundary.left == SPH2D_SIDE_PERIODIC ? scene->domain.max.x - scene->domain.min.x : 0;
}

double sph2d__period_y(const sph2d_scene *scene)
{
    return scene->boundary.bottom == SPH2D_SIDE_PERIODIC ? scene->domain.max.y - scene->domain.min.y : 0;
}

double sph2d__scene_reach(const sph2d_scene *scene)
{
    double support = scene->method.support_ratio;
    if (scene->method.name == SPH2D_METHOD_HYBRID)
        support += 2 * sqrt(2) * SPH2D__APART; /* two places, each moved along both axes */
    return fmax(support, scene->fluid.surface_tension > 0 ? 2 * SPH2D__OUTER_RADIUS : 0) * scene->spacing;
}
