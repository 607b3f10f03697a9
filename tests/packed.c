/* SPDX-License-Identifier: MIT */
/** @file packed.c
 *  The scenes of packed.h. */
#include "packed.h"

#include <math.h>

test_packed packed;

void packed_start(void)
{
    packed.scene = sph2d_scene_default();
    packed.scene.domain = (sph2d_box){{-0.2, -0.2}, {1.2, 1.2}};
    packed.scene.boundary = (sph2d_boundary){SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    packed.scene.spacing = DX;
    packed.scene.method.name = SPH2D_METHOD_WCSPH;
    packed.block = test_block(0, 0, 0.6, 0.4);
    packed.scene.blocks = &packed.block;
    packed.scene.block_count = 1;
    packed.obstacle = sph2d_obstacle_default();
    packed.scene.obstacles = &packed.obstacle;
    packed.scene.obstacle_count = 0;
}

void packed_set_polygon(size_t count)
{
    packed.block = sph2d_block_default();
    packed.block.shape.kind = SPH2D_SHAPE_POLYGON;
    packed.block.shape.points = (sph2d_points){packed.corners, count};
}

void packed_set_line(size_t count)
{
    packed.obstacle.shape.kind = SPH2D_SHAPE_POLYLINE;
    packed.obstacle.shape.points = (sph2d_points){packed.line, count};
    packed.scene.obstacle_count = 1;
}

double packed_set_wedge(double degrees)
{
    double half = tan(degrees / 2 * TEST_PI / 180), depth = fmin(0.5, 0.5 / half), rim = 1.2 * depth;
    packed.line[0] = (sph2d_vec2){0.5 - rim * half, rim};
    packed.line[1] = (sph2d_vec2){0.5, 0};
    packed.line[2] = (sph2d_vec2){0.5 + rim * half, rim};
    packed_set_line(3);
    packed.corners[0] = packed.line[1];
    packed.corners[1] = (sph2d_vec2){0.5 + depth * half, depth};
    packed.corners[2] = (sph2d_vec2){0.5 - depth * half, depth};
    packed_set_polygon(3);
    return depth * depth * half;
}

void packed_set_turned_tank(double degrees)
{
    static const sph2d_vec2 tank[4] = {{0, 0.4}, {0, 0}, {0.6, 0}, {0.6, 0.4}};
    static const sph2d_vec2 liquid[4] = {{0, 0}, {0.6, 0}, {0.6, 0.3}, {0, 0.3}};
    double c = cos(degrees * TEST_PI / 180), s = sin(degrees * TEST_PI / 180);
    for (int k = 0; k < 4; ++k) {
        packed.line[k] = (sph2d_vec2){0.3 + c * tank[k].x - s * tank[k].y, 0.1 + s * tank[k].x + c * tank[k].y};
        packed.corners[k] =
            (sph2d_vec2){0.3 + c * liquid[k].x - s * liquid[k].y, 0.1 + s * liquid[k].x + c * liquid[k].y};
    }
    packed_set_line(4);
    packed_set_polygon(4);
    packed.scene.gravity = (sph2d_vec2){9.81 * s, -9.81 * c};
}
