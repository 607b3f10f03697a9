/* SPDX-License-Identifier: MIT */
/** @file wall_names.c */
#include "scene/wall_names.h"

#include <string.h>

static const char *const words[SPH2D__WALL_OBSTACLE] = {"left", "right", "bottom", "top"};

const char *sph2d__side_word(int side)
{
    return words[side];
}

sph2d_side sph2d__side_of(const sph2d_scene *scene, int side)
{
    const sph2d_side sides[] = {scene->boundary.left, scene->boundary.right, scene->boundary.bottom,
                                scene->boundary.top};
    return sides[side];
}

double sph2d__side_distance(const sph2d_scene *scene, int side, sph2d_vec2 p)
{
    const sph2d_box *d = &scene->domain;
    const double within[] = {p.x - d->min.x, d->max.x - p.x, p.y - d->min.y, d->max.y - p.y};
    return within[side];
}

int sph2d__wall_named(const sph2d_scene *scene, const char *name)
{
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side)
        if (strcmp(words[side], name) == 0)
            return side;
    for (size_t k = 0; k < scene->obstacle_count; ++k)
        if (scene->obstacles[k].name && strcmp(scene->obstacles[k].name, name) == 0)
            return SPH2D__WALL_OBSTACLE + (int)k;
    return SPH2D__WALL_ALL;
}
