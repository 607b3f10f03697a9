/* SPDX-License-Identifier: MIT */
/** @file streamlines.h
 *  Evenly spaced streamlines of the velocity of the moment. */
#ifndef SPH2D_RENDER_STREAMLINES_H
#define SPH2D_RENDER_STREAMLINES_H

#include "render/lines.h"

/** Adds the streamlines of a picture and their heads to `lines`, the same ones for the same picture; each line is followed
 *  by its heads. They end where `walls` covers half a pixel. Sets `failed` when memory is short. */
void sph2d__streamlines_find(sph2d__lines *lines, const sph2d__view *view, const sph2d_picture *picture,
                             const sph2d__cover *walls);

#endif
