/* SPDX-License-Identifier: MIT */
/** @file picture.h
 *  From particles to what the renderer draws. A run's frames and `sph2d render` both come through here, so that the
 *  same particles give the same pixels. */
#ifndef SPH2D_CLI_PICTURE_H
#define SPH2D_CLI_PICTURE_H

#include <sph2d/io.h>
#include <sph2d/render.h>

/** How particles are to look: the scene's frames, and what its lengths are measured by. */
typedef struct cli_look {
    sph2d_frames frames;
    sph2d_box domain; /**< [m] */
    double spacing;   /**< [m] */
} cli_look;

cli_look look_of_scene(const sph2d_scene *scene);
cli_look look_of_snapshot(const sph2d_snapshot *snapshot);

/** Whether points can be coloured as the look wants. Errors: SPH2D_SCENE, with the key to blame. */
sph2d_status look_check(const cli_look *look, sph2d_report *report);

/** Where particles come from: one of the two. */
typedef struct particle_source {
    const sph2d_sim *sim;
    const sph2d_snapshot *snapshot;
} particle_source;

/** Numbers that a picture borrows; start it with {0}, keep it as long as the picture, free it with picture_free. */
typedef struct picture_buffers {
    double *values;
    size_t capacity;
    char label[96];
} picture_buffers;

/** Makes a picture of the particles. Errors: SPH2D_FORMAT when a field is missing, SPH2D_NOMEM. */
sph2d_status picture_make(const particle_source *source, const cli_look *look, picture_buffers *buffers,
                          sph2d_picture *picture, sph2d_report *report);
void picture_free(picture_buffers *buffers);

/** Whether points can be coloured by this name. */
bool picture_color_known(const char *name);
/** All such names, "speed, Densities, ...". Returns `out`. */
char *picture_colors(char *out, size_t size);

#endif
