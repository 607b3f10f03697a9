/* SPDX-License-Identifier: MIT */
/** @file bench_scenes.c
 *  The scenes that are timed: a dam that breaks, by every method, and vortices in a periodic box. */
#include <math.h>

#include "bench.h"

/** Liquid of 2 by 1, disturbed, in a tank of 4 by 2 with an open top. */
static void dam(sph2d_scene *scene, sph2d_block *block, double particles)
{
    scene->domain = (sph2d_box){{0, 0}, {4, 2}};
    scene->boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN};
    scene->gravity = (sph2d_vec2){0, -9.81};
    scene->spacing = 1 / round(sqrt(particles / 2));
    block->shape.kind = SPH2D_SHAPE_BOX;
    block->shape.box = (sph2d_box){{0, 0}, {2, 1}};
    block->perturb.amplitude = 0.1;
    scene->fluid.dynamic_viscosity = 0.01;
}

static void dam_wcsph(sph2d_scene *scene, sph2d_block *block, double particles)
{
    dam(scene, block, particles);
    scene->method.name = SPH2D_METHOD_WCSPH;
}

static void dam_muller(sph2d_scene *scene, sph2d_block *block, double particles)
{
    dam(scene, block, particles);
    scene->method.name = SPH2D_METHOD_MULLER;
    scene->fluid.dynamic_viscosity = 3;
}

static void dam_pcisph(sph2d_scene *scene, sph2d_block *block, double particles)
{
    dam(scene, block, particles);
    scene->method.name = SPH2D_METHOD_PCISPH;
}

static void dam_constraint(sph2d_scene *scene, sph2d_block *block, double particles)
{
    dam(scene, block, particles);
    scene->method.name = SPH2D_METHOD_CONSTRAINT;
}

/** Taylor and Green's vortices, Re 100. */
static void vortices(sph2d_scene *scene, sph2d_block *block, double particles)
{
    scene->domain = (sph2d_box){{0, 0}, {1, 1}};
    scene->boundary =
        (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
    scene->gravity = (sph2d_vec2){0, 0};
    scene->spacing = 1 / round(sqrt(particles));
    scene->fluid = (sph2d_fluid){.density = 1, .dynamic_viscosity = 0.01};
    scene->method.name = SPH2D_METHOD_WCSPH;
    scene->method.operators = SPH2D_OPERATORS_FITTED;
    scene->method.support_ratio = 2.5;
    scene->method.sound_speed = 10;
    block->shape.kind = SPH2D_SHAPE_BOX;
    block->shape.box = scene->domain;
    block->perturb.amplitude = 0.1;
    block->start.flow.kind = SPH2D_FLOW_TAYLOR_GREEN;
    block->start.flow.speed = block->start.flow.length = 1;
}

/* Of a pair, Wendland's C2: distance 7, slope 4. Rate of density: flux 7, diffusion 11. Force: pressure 12, Morris'
 * viscosity 6, artificial 8, slope of density 16. Shifting: 14 in the force, 22 in the rate. */
const bench_scene bench_scenes[] = {
    {"wcsph", "dam break, wcsph as it is", 120, 19, dam_wcsph},
    {"muller", "dam break, muller", 34, 8, dam_muller},
    {"pcisph", "dam break, pcisph, 1 %", 40, 6, dam_pcisph},
    {"constraint", "dam break, constraint, 1 %", 40, 6, dam_constraint},
    {"fitted", "Taylor-Green, wcsph with fitted operators, H/dx 2.5", 324, 15, vortices},
};
const size_t bench_scene_count = sizeof bench_scenes / sizeof *bench_scenes;
