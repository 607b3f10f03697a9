/* SPDX-License-Identifier: MIT */
/** @file colormap.h
 *  Maps numbers to colours. */
#ifndef SPH2D_RENDER_COLORMAP_H
#define SPH2D_RENDER_COLORMAP_H

#include <stdbool.h>

/** The opaque colour of `t` from 0 to 1, clamped; grey where it is NaN. `diverging`: of two hues that meet in a light grey
 *  at 1/2, for values of either sign. */
void sph2d__colormap(double t, bool diverging, unsigned char color[4]);

#endif
