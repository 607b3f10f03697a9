/* SPDX-License-Identifier: MIT */
/** @file flow_context.c */
#include "sim/simulation.h"

sph2d_flow_context sph2d__sim_flow_context(const sph2d_sim *sim)
{
    const sph2d_scene *scene = &sim->world.scene;
    return (sph2d_flow_context){.density = scene->fluid.density,
                                .dynamic_viscosity = scene->fluid.dynamic_viscosity,
                                .surface_tension = scene->fluid.surface_tension,
                                .gravity = {scene->gravity.x, scene->gravity.y},
                                .central_rate = scene->central_force.rate};
}
