/* SPDX-License-Identifier: MIT */
/** @file stick.h
 *  Velocities behind walls to which liquid sticks, pair by pair: boundary particle b has for particle i of the liquid
 *  the velocity that makes the liquid's equal to the wall's at the surface,
 *
 *      v_w - (d_b/d_i) (v_i - v_w),     d_b behind the surface, d_i before it
 *
 *  (Takeda, Miyama & Sekiya 1994; Morris, Fox & Zhu 1997), exact for a linear profile. */
#ifndef SPH2D_METHODS_TERMS_STICK_H
#define SPH2D_METHODS_TERMS_STICK_H

#include <math.h>

#include "methods/common/system.h"

/* The least distance of liquid from a wall, over the spacing, and the gain of a boundary particle that lies behind no
 * single surface, in a corner: that of one as far behind it as the liquid is before it. */
SPH2D__FIXED double SPH2D__NEAREST = 0.25, SPH2D__IN_CORNERS = 2;

/** d_i: how far a fluid particle at (dx, dy) from b is before the surface in front of b [m]. */
static inline double sph2d__before(const sph2d__system *s, size_t b, double dx, double dy)
{
    const sph2d__store *w = &s->walls;
    double before = dx * w->normal_x[b] + dy * w->normal_y[b] - w->depth[b], least = SPH2D__NEAREST * s->spacing;
    return before > least ? before : least;
}

/** 1 + d_b/d_i of a fluid particle at (dx, dy) from boundary particle b; 0 where that lets it slip. */
static inline double sph2d__stick(const sph2d__system *s, size_t b, double dx, double dy)
{
    const sph2d__store *w = &s->walls;
    if (sph2d__slip_of(s, b) != SPH2D_SLIP_NONE)
        return 0;
    double depth = w->depth[b];
    if (!(depth > 0 && depth < INFINITY))
        return SPH2D__IN_CORNERS;
    return 1 + depth / sph2d__before(s, b, dx, dy);
}

/** The velocity (ux, uy) of that particle relative to b, plus what it has relative to the image: v_w of a wall that
 *  turns is that at the particle. */
static inline sph2d_vec2 sph2d__stick_jump(const sph2d__system *s, size_t b, double stick, double dx, double dy,
                                           double ux, double uy)
{
    double spin = (stick - 1) * (s->wall_spin ? s->wall_spin[s->walls.id[b]] : 0);
    return (sph2d_vec2){stick * ux + spin * dy, stick * uy - spin * dx};
}

#endif
