/* SPDX-License-Identifier: MIT */
/** @file colors.h
 *  Colours of liquid. Where a scene gives one, each particle has its own, as 0xRRGGBB. */
#ifndef SPH2D_SCENE_COLORS_H
#define SPH2D_SCENE_COLORS_H

#include "sph2d/scene.h"

/** Whether a scene gives any liquid a colour; that of its material alone, which all have, is none. */
bool sph2d__has_colors(const sph2d_scene *scene);

/** The colour of liquid that has `own` (NULL: none): that, or the fluid's, or its material's, or that of water. */
uint32_t sph2d__color_of(const sph2d_scene *scene, const char *own);

/** Whether a number is the colour of a particle, or 0 for none. */
static inline bool sph2d__is_color(double color)
{
    return color >= 0 && color <= 0xffffff && color == (double)(uint32_t)color;
}

#endif
