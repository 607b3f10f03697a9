/* SPDX-License-Identifier: MIT */
/** @file resolve.c
 *  Defaults that depend on the method. */
#include "scene/resolve.h"

#include <math.h>

#include "scene/bodies.h"
#include "scene/method_table.h"
#include "scene/wall_names.h"

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

bool sph2d__has_no_surface(const sph2d_scene *scene)
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

sph2d_wall_form sph2d__side_form(const sph2d_scene *scene)
{
    if (scene->walls != SPH2D_WALL_DEFAULT)
        return scene->walls;
    return sph2d__method_row_of(&scene->method)->side_form;
}

sph2d_wall_form sph2d__obstacle_form(const sph2d_scene *scene, const sph2d_obstacle *obstacle)
{
    if (obstacle->form != SPH2D_WALL_DEFAULT)
        return obstacle->form;
    return sph2d__method_row_of(&scene->method)->obstacle_form;
}

static sph2d_slip slip_or_scene(const sph2d_scene *scene, sph2d_wall_slip own)
{
    switch (own) {
    case SPH2D_WALL_SLIP_FREE:
        return SPH2D_SLIP_FREE;
    case SPH2D_WALL_SLIP_NONE:
        return SPH2D_SLIP_NONE;
    case SPH2D_WALL_SLIP_SMOOTH:
        return SPH2D_SLIP_SMOOTH;
    case SPH2D_WALL_SLIP_DEFAULT:
        break;
    }
    return scene->wall_slip;
}

sph2d_slip sph2d__side_slip(const sph2d_scene *scene, int side)
{
    const sph2d_side_slips *s = &scene->side_slip;
    const sph2d_wall_slip own[SPH2D__WALL_OBSTACLE] = {s->left, s->right, s->bottom, s->top};
    return slip_or_scene(scene, own[side]);
}

sph2d_slip sph2d__obstacle_slip(const sph2d_scene *scene, const sph2d_obstacle *obstacle)
{
    return slip_or_scene(scene, obstacle->slip);
}

/** The bit of a slip; none for one that is no word, which the checker reports. */
static unsigned bit_of(sph2d_slip slip)
{
    return (unsigned)slip <= SPH2D_SLIP_SMOOTH ? 1u << slip : 0;
}

unsigned sph2d__slips(const sph2d_scene *scene)
{
    unsigned slips = 0;
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side)
        if (sph2d__side_of(scene, side) == SPH2D_SIDE_WALL && sph2d__side_form(scene) == SPH2D_WALL_GENERALISED)
            slips |= bit_of(sph2d__side_slip(scene, side));
    for (size_t i = 0; i < scene->obstacle_count; ++i)
        if (sph2d__obstacle_form(scene, &scene->obstacles[i]) == SPH2D_WALL_GENERALISED)
            slips |= bit_of(sph2d__obstacle_slip(scene, &scene->obstacles[i]));
    return slips ? slips : bit_of(scene->wall_slip);
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
    double support = sph2d__method_resolve(scene->method).support_ratio;
    if (scene->method.name == SPH2D_METHOD_HYBRID)
        support += 2 * sqrt(2) * SPH2D__APART; /* two places, each moved along both axes */
    return fmax(support, scene->fluid.surface_tension > 0 ? 2 * SPH2D__OUTER_RADIUS : 0) * scene->spacing;
}
