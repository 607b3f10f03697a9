/* SPDX-License-Identifier: MIT */
/** @file splash.h
 *  Renderers that must work, some water for them to draw, and pixels that show it. */
#ifndef SPH2D_TESTS_SPLASH_H
#define SPH2D_TESTS_SPLASH_H

#include "common.h"
#include "sph2d/render.h"

static const double spacing = 0.01; /* [m] */

/** The ways to OpenGL. */
static const char *const ways[] = {"osmesa", "egl"};
enum { WAYS = sizeof ways / sizeof ways[0] };

/** A renderer that must work; NULL only where `gl` names a way that this build or machine lacks. */
sph2d_renderer *make_renderer(const char *gl, unsigned width, unsigned height, sph2d_style style);

/** Draws and returns the pixels. */
const unsigned char *draw(sph2d_renderer *renderer, const sph2d_picture *picture);

/** A copy of the pixels of a picture, drawn by a renderer of its own. */
unsigned char *draw_alone(const char *gl, unsigned width, unsigned height, sph2d_style style,
                          const sph2d_picture *picture);

/** Whether all tests share this process. */
bool not_forked(void);

enum { SIDE = 40, FLUID = SIDE * SIDE + 1, CORNERS = 4 };

/** Some water in a box of 1.28 m x 0.72 m: a disordered block, a drop, two lines. */
typedef struct splash {
    double x[FLUID], y[FLUID], values[FLUID], wall_x[CORNERS], wall_y[CORNERS];
    uint64_t outline[CORNERS], liquid[CORNERS];
    sph2d_picture picture;
} splash;

splash *make_splash(double offset);

/** Water is dark in the red channel, the background and what lies beside the view are light. */
bool is_water(const unsigned char *pixels, unsigned width, unsigned x, unsigned y);
size_t count_water(const unsigned char *pixels, unsigned width, unsigned height);

#endif
