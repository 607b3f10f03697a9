/* SPDX-License-Identifier: MIT */
/** @file frame.h
 *  Converts particles to the renderer's picture, for the frames of a run and `sph2d render`, so that the same particles
 *  give the same pixels. */
#ifndef SPH2D_CLI_FRAME_H
#define SPH2D_CLI_FRAME_H

#include <stdint.h>

#include <sph2d/render.h>

#include "frame_field.h"

/** The style of frames: the scene's settings, name, domain and spacing. */
typedef struct frame_style {
    sph2d_frames frames;
    const char *name; /**< borrowed; NULL: none */
    sph2d_box domain; /**< [m] */
    sph2d_boundary boundary;
    double spacing;  /**< [m] */
    bool tinted;     /**< liquid has a colour: its own, or its material's ... */
    uint32_t tint;   /**< ... which is this, 0xRRGGBB */
    size_t recent;   /**< places of paths that are drawn, the last ones; 0: all */
    bool full_range; /**< colours that have no range go from the smallest value to the largest, not from the 1st to the
                          99th percentile */
} frame_style;

frame_style frame_style_of_scene(const sph2d_scene *scene);
frame_style frame_style_of_snapshot(const sph2d_snapshot *snapshot);

/** Checks the fields to draw. Errors: SPH2D_SCENE, at the key. */
sph2d_status frame_style_check(const frame_style *style, sph2d_report *report);

/** All that a picture borrows, so that it needs nothing of its source. Initialise with {0}, keep it as long as the picture,
 *  free it with frame_free. */
typedef struct frame_buffers {
    double *block; /**< arrays of the particles, one after the other */
    size_t capacity;
    double *outline_x, *outline_y;
    uint64_t *outline_id, *outline_liquid;
    size_t corners;          /**< for which these have room */
    double *path_x, *path_y; /**< of tracers ... */
    uint64_t *path_id;
    size_t places;    /**< ... for so many places */
    sph2d_vec2 range; /**< of the values in the view, where the style has none; (INFINITY, -INFINITY) without values */
    char label[96], level_label[96], caption[160];
} frame_buffers;

/** Makes a picture of the particles. Errors: SPH2D_FORMAT if a field is missing, SPH2D_SCENE for a name to
 *  follow that the scene has not, SPH2D_NOMEM. */
sph2d_status frame_make(const particle_source *source, const frame_style *style, frame_buffers *buffers,
                        sph2d_picture *picture, sph2d_report *report);
/** Widens a range by that of the values in view, for one range of several frames; (INFINITY, -INFINITY) is empty. Errors:
 *  as frame_make. */
sph2d_status frame_widen_range(const particle_source *source, const frame_style *style, frame_buffers *buffers,
                               sph2d_vec2 *range, sph2d_report *report);
void frame_free(frame_buffers *buffers);

/** Sets the paths of tracers (frame_paths.c). False: memory is short. */
bool frame_set_paths(const particle_source *source, const frame_style *style, frame_buffers *buffers,
                     sph2d_picture *picture);

/** Makes room for more corners behind those of the outlines of a picture. False: memory is short. */
bool frame_reserve_corners(frame_buffers *buffers, sph2d_picture *picture, size_t more);

#endif
