/* SPDX-License-Identifier: MIT */
/** @file device_scene.c
 *  Which scenes devices take. */
#include "scene/motion.h"
#include "scene/world.h"
#include "sph2d/device.h"

static bool is_known(const sph2d_method_options *method)
{
    return method->name == SPH2D_METHOD_MULLER || method->name == SPH2D_METHOD_CONSTRAINT ||
           method->name == SPH2D_METHOD_HYBRID ||
           (method->name == SPH2D_METHOD_WCSPH && method->operators != SPH2D_OPERATORS_FITTED);
}

static bool any_reflects(const sph2d_scene *scene)
{
    bool any = scene->walls == SPH2D_WALL_REFLECT;
    for (size_t i = 0; i < scene->obstacle_count; ++i)
        any = any || scene->obstacles[i].form == SPH2D_WALL_REFLECT;
    return any;
}

static bool any_moves(const sph2d_scene *scene)
{
    bool any = false;
    for (size_t i = 0; i < scene->obstacle_count; ++i)
        any = any || sph2d__motion_moves(&scene->obstacles[i].motion);
    return any;
}

static bool any_smooth(const sph2d_scene *scene)
{
    bool any = scene->wall_slip == SPH2D_SLIP_SMOOTH;
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side)
        any = any || sph2d__side_own_slip(scene, side) == SPH2D_WALL_SLIP_SMOOTH;
    for (size_t i = 0; i < scene->obstacle_count; ++i)
        any = any || scene->obstacles[i].slip == SPH2D_WALL_SLIP_SMOOTH;
    return any;
}

const char *sph2d_device_refuses(const sph2d_scene *scene)
{
    if (!scene)
        return "there is no scene";
    if (!is_known(&scene->method))
        return "devices know methods muller, wcsph, constraint and hybrid alone";
    if (scene->body_count > 0)
        return "devices do not know bodies";
    if (scene->method.name == SPH2D_METHOD_HYBRID && any_moves(scene))
        return "devices do not know obstacles that move in method hybrid";
    if (any_reflects(scene))
        return "devices do not know walls that reflect";
    if (scene->opening_count > 0)
        return "devices do not know openings";
    if (scene->fluid.model != SPH2D_RHEOLOGY_NEWTONIAN)
        return "devices know liquids with a constant viscosity alone";
    if (any_smooth(scene))
        return "devices do not know smooth walls";
    if (scene->fluid.surface_tension > 0)
        return "devices do not know surface tension";
    return NULL;
}
