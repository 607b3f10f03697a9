/* SPDX-License-Identifier: MIT */
/** @file where.c
 *  Describes a position by the nearest parts of the scene: a wall, and a block or source. */
#include <math.h>
#include <stdio.h>

#include "scene/shape.h"
#include "sim/simulation.h"

/** The nearest part so far. */
typedef struct nearest {
    char name[48];
    double distance; /**< [m] */
} nearest;

static void update_nearest(nearest *n, double distance, const char *list, size_t index)
{
    if (!(distance < n->distance))
        return;
    n->distance = distance;
    snprintf(n->name, sizeof n->name, "%s[%zu]", list, index);
}

sph2d__pose sph2d__sim_pose_of(const sph2d_sim *sim, const sph2d__wall *wall)
{
    for (size_t k = 0; k < sim->moving_count; ++k)
        if (sim->moving[k].wall == wall)
            return sim->moving[k].to;
    return (sph2d__pose){.cosine = 1};
}

bool sph2d__sim_crosses_wall(const sph2d_sim *sim, sph2d_vec2 from, sph2d_vec2 to)
{
    bool crossed = sph2d__barrier_crosses(&sim->barrier, from, to);
    for (size_t k = 0; k < sim->moving_count && !crossed; ++k)
        crossed = sph2d__moving_crosses(&sim->moving[k], from, to);
    return crossed;
}

static double distance_to(const sph2d_sim *sim, const sph2d__wall *wall, sph2d_vec2 p)
{
    double least = INFINITY;
    sph2d__pose pose = sph2d__sim_pose_of(sim, wall);
    sph2d_vec2 q = sph2d__pose_invert(&pose, p);
    size_t pieces = sph2d__shape_pieces(&wall->shape, sim->world.scene.spacing);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment piece = sph2d__shape_piece(&wall->shape, sim->world.scene.spacing, k);
        least = fmin(least, sph2d__segment_distance(&piece, q));
    }
    return least;
}

static void update_nearest_wall(nearest *n, const sph2d_sim *sim, size_t k, sph2d_vec2 p)
{
    double distance = distance_to(sim, &sim->world.walls[k], p);
    if (!(distance < n->distance))
        return;
    n->distance = distance;
    sph2d__wall_path(n->name, sizeof n->name, &sim->world.walls[k], "");
}

static nearest nearest_wall(const sph2d_sim *sim, sph2d_vec2 p)
{
    const sph2d_box d = sim->world.box;
    const sph2d_boundary b = sim->world.scene.boundary;
    const struct {
        sph2d_side kind;
        double distance;
        const char *name;
    } sides[4] = {{b.left, p.x - d.min.x, "left side"},
                  {b.right, d.max.x - p.x, "right side"},
                  {b.bottom, p.y - d.min.y, "bottom side"},
                  {b.top, d.max.y - p.y, "top side"}};
    nearest n = {"", INFINITY};
    for (int k = 0; k < 4; ++k)
        if (sides[k].kind == SPH2D_SIDE_WALL && fabs(sides[k].distance) < n.distance) {
            n.distance = fabs(sides[k].distance);
            snprintf(n.name, sizeof n.name, "the %s", sides[k].name);
        }
    for (size_t k = SPH2D__WALL_OBSTACLE; k < sim->world.wall_count; ++k)
        update_nearest_wall(&n, sim, k, p);
    return n;
}

/** The block or source that was nearest to a position at the start. */
static nearest nearest_liquid(const sph2d_sim *sim, sph2d_vec2 p)
{
    const sph2d_scene *scene = &sim->world.scene;
    nearest n = {"", INFINITY};
    for (size_t k = 0; k < scene->block_count; ++k) {
        sph2d_box b = sph2d__shape_bounds(&scene->blocks[k].shape);
        double x = fmax(fmax(b.min.x - p.x, p.x - b.max.x), 0), y = fmax(fmax(b.min.y - p.y, p.y - b.max.y), 0);
        update_nearest(&n, hypot(x, y), "blocks", k);
    }
    for (size_t k = 0; k < scene->source_count; ++k)
        update_nearest(&n, hypot(scene->sources[k].at.x - p.x, scene->sources[k].at.y - p.y), "sources", k);
    return n;
}

const char *sph2d__sim_where(const sph2d_sim *sim, sph2d_vec2 p, char text[SPH2D__WHERE_SIZE])
{
    nearest wall = nearest_wall(sim, p), liquid = nearest_liquid(sim, p);
    if (wall.distance < INFINITY && liquid.distance < INFINITY)
        snprintf(text, SPH2D__WHERE_SIZE, "%.2g spacings from %s, nearest to %s",
                 wall.distance / sim->world.scene.spacing, wall.name, liquid.name);
    else if (wall.distance < INFINITY)
        snprintf(text, SPH2D__WHERE_SIZE, "%.2g spacings from %s", wall.distance / sim->world.scene.spacing, wall.name);
    else if (liquid.distance < INFINITY)
        snprintf(text, SPH2D__WHERE_SIZE, "nearest to %s", liquid.name);
    else
        snprintf(text, SPH2D__WHERE_SIZE, "in the open");
    return text;
}
