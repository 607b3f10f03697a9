/* SPDX-License-Identifier: MIT */
/** @file start.c */
#include "scene/start.h"

#include <math.h>

bool sph2d__starts_from_snapshot(const sph2d_scene *scene)
{
    const sph2d_cloud *snapshot = &scene->start.snapshot;
    return (snapshot->file || snapshot->count > 0) && !scene->particles.file && scene->particles.count == 0;
}

bool sph2d__liquid_is_from_file(const sph2d_scene *scene)
{
    return scene->particles.file || sph2d__starts_from_snapshot(scene);
}

double sph2d__start_speed(const sph2d_start *start)
{
    const sph2d_grid *grid = &start->table;
    const sph2d_cloud *cloud = &start->snapshot;
    double speed = fabs(start->flow.speed);
    if (start->top_speed > 0)
        return start->top_speed;
    for (size_t k = 0; k < grid->nx * grid->ny; ++k)
        speed = fmax(speed, hypot(grid->vx ? grid->vx[k] : 0, grid->vy ? grid->vy[k] : 0));
    for (size_t k = 0; cloud->items && k < cloud->count; ++k)
        speed = fmax(speed, hypot(cloud->items[k].vx, cloud->items[k].vy));
    return speed;
}
