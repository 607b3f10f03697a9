/* SPDX-License-Identifier: MIT */
/** @file colormap.h
 *  Maps numbers to colours. */
#ifndef SPH2D_RENDER_COLORMAP_H
#define SPH2D_RENDER_COLORMAP_H

/** The opaque colour of `t` from 0 to 1, clamped; grey where it is NaN. */
void sph2d__colormap(double t, unsigned char color[4]);

#endif
