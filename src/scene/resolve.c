/* SPDX-License-Identifier: MIT */
/** @file resolve.c
 *  The defaults that differ from method to method. */
#include "scene/resolve.h"

static double or_else(double value, double standard)
{
    return value > 0 ? value : standard;
}

sph2d_method_options sph2d__method_resolve(sph2d_method_options m)
{
    bool muller = m.name == SPH2D_METHOD_MULLER, wcsph = m.name == SPH2D_METHOD_WCSPH;
    bool fitted = m.operators == SPH2D_OPERATORS_FITTED;
    m.max_compression = or_else(m.max_compression, muller ? 0.1 : 0.01);
    m.support_ratio = or_else(m.support_ratio, muller ? 2.0 : !wcsph ? 2.4 : fitted ? 2.5 : 3.0);
    m.cfl = or_else(m.cfl, muller ? 0.4 : !wcsph ? 0.4 / m.support_ratio : fitted ? 0.25 : 0.3);
    m.artificial_viscosity = or_else(m.artificial_viscosity, muller ? 0.1 : 0);
    m.tolerance = or_else(m.tolerance, m.max_compression / 100);
    return m;
}

sph2d_wall_form sph2d__side_form(const sph2d_scene *scene)
{
    if (scene->walls != SPH2D_WALL_DEFAULT)
        return scene->walls;
    return scene->method.name != SPH2D_METHOD_MULLER ? SPH2D_WALL_GENERALISED : SPH2D_WALL_SPRING;
}

sph2d_wall_form sph2d__obstacle_form(const sph2d_scene *scene, const sph2d_obstacle *obstacle)
{
    if (obstacle->form != SPH2D_WALL_DEFAULT)
        return obstacle->form;
    return scene->method.name != SPH2D_METHOD_MULLER ? SPH2D_WALL_GENERALISED : SPH2D_WALL_HEAVY;
}

double sph2d__period_x(const sph2d_scene *scene)
{
    return scene->boundary.left == SPH2D_SIDE_PERIODIC ? scene->domain.max.x - scene->domain.min.x : 0;
}

double sph2d__period_y(const sph2d_scene *scene)
{
    return scene->boundary.bottom == SPH2D_SIDE_PERIODIC ? scene->domain.max.y - scene->domain.min.y : 0;
}
