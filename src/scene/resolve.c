/* SPDX-License-Identifier: MIT */
/** @file resolve.c
 *  The defaults that differ from method to method. */
#include "scene/resolve.h"

static double or_else(double value, double standard)
{
    return value > 0 ? value : standard;
}

/** H/dx of pcisph and constraint. Kernels that fall off faster reach farther, so that all are as wide, by the standard
 *  deviation (H over it: Dehnen & Aly 2012, table 1), as Wendland's C2 at 2.4: sums of narrower ones tell a lattice
 *  that is strained to 1:2 to be 7 to 13 % denser than it is, so that liquid swells; these 2 to 3 %. */
static double projected_support(sph2d_kernel kernel)
{
    switch (kernel) {
    case SPH2D_KERNEL_WENDLAND_C4:
    case SPH2D_KERNEL_QUINTIC:
        return 2.75;
    case SPH2D_KERNEL_WENDLAND_C6:
        return 3.05;
    case SPH2D_KERNEL_WENDLAND_C2:
    case SPH2D_KERNEL_CUBIC:
        break;
    }
    return 2.4;
}

sph2d_method_options sph2d__method_resolve(sph2d_method_options m)
{
    bool muller = m.name == SPH2D_METHOD_MULLER, wcsph = m.name == SPH2D_METHOD_WCSPH;
    bool fitted = m.operators == SPH2D_OPERATORS_FITTED;
    m.max_compression = or_else(m.max_compression, muller ? 0.1 : 0.01);
    double support = muller ? 2.0 : !wcsph ? projected_support(m.kernel) : fitted ? 2.5 : 3.0;
    m.support_ratio = or_else(m.support_ratio, support);
    m.cfl = or_else(m.cfl, muller ? 0.4 : !wcsph ? 0.4 / m.support_ratio : fitted ? 0.25 : 0.3);
    m.artificial_viscosity = or_else(m.artificial_viscosity, muller ? 0.1 : 0);
    m.tolerance = or_else(m.tolerance, m.max_compression / 100);
    return m;
}

/** Whether liquid fills its room from the start: no side is open, and one block covers the domain. */
static bool has_no_surface(const sph2d_scene *scene)
{
    const sph2d_boundary *b = &scene->boundary;
    const sph2d_box *d = &scene->domain;
    if (b->left == SPH2D_SIDE_OPEN || b->right == SPH2D_SIDE_OPEN || b->bottom == SPH2D_SIDE_OPEN ||
        b->top == SPH2D_SIDE_OPEN)
        return false;
    double near = scene->spacing / 2;
    for (size_t i = 0; i < scene->block_count; ++i) {
        const sph2d_shape *shape = &scene->blocks[i].shape;
        const sph2d_box *box = &shape->box;
        if (shape->kind == SPH2D_SHAPE_BOX && box->min.x <= d->min.x + near && box->min.y <= d->min.y + near &&
            box->max.x >= d->max.x - near && box->max.y >= d->max.y - near)
            return true;
    }
    return false;
}

sph2d_viscosity_form sph2d__viscosity_form(const sph2d_scene *scene)
{
    const sph2d_method_options *m = &scene->method;
    bool symmetric = m->name == SPH2D_METHOD_WCSPH && m->operators == SPH2D_OPERATORS_SYMMETRIC;
    if (m->viscosity_form != SPH2D_VISCOSITY_DEFAULT || !symmetric)
        return m->viscosity_form;
    return has_no_surface(scene) ? SPH2D_VISCOSITY_MORRIS : SPH2D_VISCOSITY_MONAGHAN;
}

sph2d_turbulence sph2d__turbulence(const sph2d_scene *scene)
{
    const sph2d_method_options *m = &scene->method;
    bool symmetric = m->name == SPH2D_METHOD_WCSPH && m->operators == SPH2D_OPERATORS_SYMMETRIC;
    if (m->turbulence != SPH2D_TURBULENCE_DEFAULT || !symmetric)
        return m->turbulence;
    bool eddies = m->shifting > 0 && !(m->artificial_viscosity > 0) && !has_no_surface(scene);
    return eddies ? SPH2D_TURBULENCE_SMAGORINSKY : SPH2D_TURBULENCE_NONE;
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
