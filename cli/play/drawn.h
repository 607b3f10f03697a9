/* SPDX-License-Identifier: MIT */
/** @file drawn.h
 *  Walls that are drawn by hand: lines with liquid on both sides, of which a simulation makes solids. A line that turns
 *  sharply, or comes back to itself, makes none: it is drawn as several lines that meet. */
#ifndef SPH2D_CLI_PLAY_DRAWN_H
#define SPH2D_CLI_PLAY_DRAWN_H

#include <stdbool.h>

#include <sph2d/scene.h>

enum { DRAWN_MOST_CORNERS = 64 };

/** A line through corners, as pieces that each make a solid: piece k goes from corner start[k] to start[k + 1]. */
typedef struct drawn_line {
    const sph2d_vec2 *corners; /**< borrowed, two to DRAWN_MOST_CORNERS */
    size_t pieces, start[DRAWN_MOST_CORNERS];
} drawn_line;

/** Divides a line for solids of a thickness [m]. */
drawn_line drawn_divide(const sph2d_vec2 *corners, size_t count, double thickness);

/** Whether two segments, of two corners each, come nearer than a distance to each other [m]. */
bool drawn_near(const sph2d_vec2 *s, const sph2d_vec2 *t, double reach);

/** How far a place is from the segment between two corners [m]. */
double drawn_distance(const sph2d_vec2 *line, sph2d_vec2 p);

/** The corners of piece k as a solid of a thickness, longer at both ends by `more` [m]: along its left, then back along
 *  its right. Returns their number, 2 DRAWN_MOST_CORNERS at most. */
size_t drawn_solid(const drawn_line *line, size_t k, double thickness, double more,
                   sph2d_vec2 out[2 * DRAWN_MOST_CORNERS]);

/** Gives a scene lists of its own (lists_copy): its obstacles but the ones from `from` up to `to`, then the pieces of a line,
 *  NULL for none. The caller frees the block. NULL when memory is short. */
void *drawn_list(sph2d_scene *scene, size_t from, size_t to, const drawn_line *line);

/** The drawn walls that meet at a place, within a reach [m]: obstacles *from up to *to, none if these are equal. Those
 *  from `given` on are drawn. */
void drawn_find(const sph2d_scene *scene, size_t given, sph2d_vec2 at, double reach, size_t *from, size_t *to);

#endif
