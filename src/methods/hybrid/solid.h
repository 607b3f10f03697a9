/* SPDX-License-Identifier: MIT */
/** @file solid.h
 *  Solids in a pose, as the grid of method `hybrid` sees them: how far a point is from one. */
#ifndef SPH2D_METHODS_HYBRID_SOLID_H
#define SPH2D_METHODS_HYBRID_SOLID_H

#include "scene/pose.h"
#include "scene/world.h"

typedef struct sph2d__solid {
    const sph2d_scene *scene;
    const sph2d__wall *wall;
    const sph2d__pose *pose;
    sph2d_box extent; /**< a rectangle around it */
    sph2d_box inside; /**< within the sides of the domain that are walls */
    bool reaches;     /**< such a side: of its outline only what is inside counts, as no solid ends along a side */
} sph2d__solid;

/** An obstacle as a solid in a pose; both stay the caller's. */
sph2d__solid sph2d__solid_of(const sph2d__world *world, const sph2d__wall *wall, const sph2d__pose *pose);

/** Distance of a point from a solid, negative in it [m]. Of a line or a hollow outline the solid are the layers behind it. */
double sph2d__solid_distance(const sph2d__solid *solid, sph2d_vec2 point);

#endif
