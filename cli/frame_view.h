/* SPDX-License-Identifier: MIT */
/** @file frame_view.h
 *  What part of the plane a frame shows. */
#ifndef SPH2D_CLI_FRAME_VIEW_H
#define SPH2D_CLI_FRAME_VIEW_H

#include "frame.h"

/** The thickness with which walls are drawn [m]. */
double frame_wall_thickness(const frame_style *style);

/** What is in front of walls; behind them are the reservoirs of openings. */
sph2d_box frame_front(const frame_style *style);

/** Sets the view of a picture whose outlines are set. Errors: SPH2D_SCENE for a name to follow that the scene has not,
 *  SPH2D_FORMAT if a snapshot has no numbers of walls, SPH2D_NOMEM. */
sph2d_status frame_find_view(const particle_source *source, const frame_style *style, sph2d_picture *picture,
                             sph2d_report *report);

#endif
