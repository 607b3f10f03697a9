/* SPDX-License-Identifier: MIT */
/** @file implicit_viscosity_pair.h
 *  Pair terms of implicit_viscosity.h. No loops. */
#ifndef SPH2D_METHODS_PROJECTION_IMPLICIT_VISCOSITY_PAIR_H
#define SPH2D_METHODS_PROJECTION_IMPLICIT_VISCOSITY_PAIR_H

#include <math.h>

#include "methods/common/system.h"

/* The least distance of liquid from a wall, over the spacing, and the gain of a boundary particle that lies behind no
 * single surface, in a corner: that of one as far behind it as the liquid is before it. */
static const double SPH2D__NEAREST = 0.25, SPH2D__IN_CORNERS = 2;

/** 1 + d_b/d_i of a fluid particle at (dx, dy) from boundary particle b; 0 where that lets it slip. */
static inline double sph2d__stick(const sph2d__system *s, size_t b, double dx, double dy)
{
    const sph2d__store *w = &s->walls;
    if (w->bounce[b] >= 0 || sph2d__slip_of(s, b) != SPH2D_SLIP_NONE)
        return 0;
    double depth = w->depth[b];
    if (!(depth > 0 && depth < INFINITY))
        return SPH2D__IN_CORNERS;
    double before = dx * w->normal_x[b] + dy * w->normal_y[b] - depth, least = SPH2D__NEAREST * s->spacing;
    return 1 + depth / (before > least ? before : least);
}

#endif
