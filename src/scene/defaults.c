/* SPDX-License-Identifier: MIT */
/** @file defaults.c
 *  The default of every field of a scene. */
#include <math.h>

#include "sph2d/scene.h"

sph2d_scene sph2d_scene_default(void)
{
    return (sph2d_scene){
        .struct_size = sizeof(sph2d_scene),
        .name = "scene",
        .boundary = {SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN},
        .wall_damping = 0.1,
        .gravity = {0.0, -9.81},
        .motion = {.center = {NAN, NAN}},
        .fluid = {.density = 1000.0, .dynamic_viscosity = 1.0e-3},
        .method = {.name = SPH2D_METHOD_WCSPH, .density_diffusion = 0.1, .shifting = 1, .max_iterations = 1000},
        .run = {.until = 1.0, .frames = {.size = {1280, 720}, .caption = SPH2D_SWITCH_ON}},
    };
}

sph2d_block sph2d_block_default(void)
{
    return (sph2d_block){.perturb = {.seed = 1}};
}

sph2d_source sph2d_source_default(void)
{
    return (sph2d_source){.direction = {0.0, -1.0}, .seed = 1};
}

sph2d_drain sph2d_drain_default(void)
{
    return (sph2d_drain){0};
}

sph2d_absorber sph2d_absorber_default(void)
{
    return (sph2d_absorber){0};
}

sph2d_opening sph2d_opening_default(void)
{
    return (sph2d_opening){.from = NAN, .to = NAN, .velocity = NAN, .flow_rate = NAN, .pressure = NAN, .level = NAN};
}

sph2d_obstacle sph2d_obstacle_default(void)
{
    return (sph2d_obstacle){.restitution = 0.5, .motion = sph2d_motion_default()};
}

sph2d_motion sph2d_motion_default(void)
{
    return (sph2d_motion){.center = {NAN, NAN}};
}

sph2d_body sph2d_body_default(void)
{
    return (sph2d_body){.center = {NAN, NAN}, .friction = 0.3};
}

sph2d_spring sph2d_spring_default(void)
{
    return (sph2d_spring){.at = {NAN, NAN}, .length = NAN};
}

sph2d_interaction sph2d_interaction_default(void)
{
    return (sph2d_interaction){0};
}

sph2d_probe sph2d_probe_default(void)
{
    return (sph2d_probe){.at = {NAN, NAN}, .along = {0, 1}, .rise_time = NAN};
}

double sph2d_rate_interval(sph2d_rate rate)
{
    return rate.every > 0 ? rate.every : rate.per_second > 0 ? 1.0 / rate.per_second : 0.0;
}

double sph2d_rate_due(sph2d_rate rate, uint64_t n)
{
    return rate.every > 0 ? (double)n * rate.every : (double)n / rate.per_second;
}
