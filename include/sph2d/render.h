/* SPDX-License-Identifier: MIT */
/** @file render.h
 *  Images of particles, as metaballs or points, drawn with OpenGL 3.3 into memory or into a window of the program.
 *  Library libsph2d-render.
 *
 *      sph2d_render_options options = sph2d_render_options_default();
 *      sph2d_renderer *renderer = NULL;
 *      if (sph2d_renderer_create(&options, &renderer, &report) == SPH2D_OK) {
 *          sph2d_view fluid = sph2d_sim_fluid(sim);
 *          sph2d_picture picture = {.view = scene.domain, .radius = 2 * scene.spacing,
 *                                   .count = fluid.count, .x = fluid.x, .y = fluid.y};
 *          if (sph2d_renderer_draw(renderer, &picture, &report) == SPH2D_OK)
 *              sph2d_renderer_write_png(renderer, "frame.png", &report);
 *      }
 *      sph2d_renderer_destroy(renderer);
 *
 *  A renderer is used by one thread at a time. Each call leaves the thread without an OpenGL context, so a program
 *  that draws with OpenGL itself must make its own context current again; or it gives its own context to the renderer:
 *
 *      options.get_proc_address = glfwGetProcAddress;
 *      ... each frame: sph2d_renderer_draw_to(renderer, 0, 0, 0, &picture, &report); glfwSwapBuffers(window);
 *
 *  The calls then need that context current, and leave it current. They change the bound framebuffer, viewport,
 *  program, vertex array and array buffer, blending, the scissor test, the clear colour, the pixel alignment, whether
 *  programs set the size of points, and the textures of units 0 to 4. An OpenGL ES needs GL_EXT_color_buffer_float or
 *  GL_EXT_color_buffer_half_float for metaballs.
 *
 *  The same picture gives the same pixels with the same version of the OpenGL driver. Mesa's software drivers used by
 *  "osmesa" and "egl" give the same, for any number of threads; "egl" uses a graphics card if it finds one, of any maker,
 *  without a display. */
#ifndef SPH2D_RENDER_H
#define SPH2D_RENDER_H

#include <stdint.h>

#include "sph2d/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An OpenGL context with shaders and buffers. */
typedef struct sph2d_renderer sph2d_renderer;

/** Any OpenGL function, and what finds one by its name in the context that is current. */
typedef void (*sph2d_gl_function)(void);
typedef sph2d_gl_function (*sph2d_gl_loader)(const char *name);

/** Options. Make one with sph2d_render_options_default(). */
typedef struct sph2d_render_options {
    /** Set by sph2d_render_options_default(); detects other versions and uninitialised structs. */
    size_t struct_size;

    /** Size of an image [pixels], 16 to 16384 each; default 1280 x 720. */
    unsigned width, height;

    /** A liquid surface or dots; default metaballs. */
    sph2d_style style;

    /** Shading of metaballs; default water. */
    sph2d_look look;

    /** What is behind the liquid; default opaque. With a transparent one sph2d_renderer_draw_to() leaves colours multiplied
     *  by their alpha in the framebuffer, as windows with transparency have them. */
    sph2d_background background;

    /** Kind of OpenGL context, "osmesa" or "egl"; default NULL: the first that this build has and that works. */
    const char *gl;

    /** Finds the functions of the caller's own context, glfwGetProcAddress for example, which is current now and in every
     *  later call; `gl` is NULL then. Default NULL: the renderer opens a context. */
    sph2d_gl_loader get_proc_address;

    /** A folder to read the shaders from, instead of the built-in ones; default NULL. All pixels of the liquid come from
     *  them: gradientball draws each particle's ball, blended by addition, metaballs makes a liquid of the sum. */
    const char *shader_dir;
} sph2d_render_options;

/** The default options. */
SPH2D_API sph2d_render_options sph2d_render_options_default(void);

/** What to draw: borrowed arrays. Particles whose position is not finite are omitted; particles outside the view are
 *  drawn if they are inside the image. With `values` a colour bar takes the right side of an image that is wide enough,
 *  and with a caption a strip its lower end: nothing else is drawn there.
 *  Start it with `{0}`. */
typedef struct sph2d_picture {
    /** The part of the plane to show [m]; fitted into the image with its aspect kept. */
    sph2d_box view;

    /** The part whose background is lighter: the domain [m]. Empty, its corners the same: the view. */
    sph2d_box inside;

    /** Radius of a metaball (R, where its field would rise again; it ends at R/sqrt 2) or of a point [m]. */
    double radius;

    /** Number of fluid particles. */
    size_t count;

    /** Their positions [m]. */
    const double *x, *y;

    /** One value per particle to colour by, NaN is grey; NULL: one colour. Metaballs have the mean of what is near. */
    const double *values;

    /** Values at the ends of the colour bar; both 0: the smallest and largest value. */
    double value_min, value_max;

    /** Colours for values of either sign, from blue over grey to red, and a range of values that is symmetric about 0 where
     *  both of its ends are 0. Default false: from dark blue over green to yellow. */
    bool diverging;

    /** One colour per particle, 65536 red + 256 green + blue, unless there are values; NULL: all have one. Metaballs have
     *  the mean of what is near. */
    const uint64_t *colors;

    /** Whether there is a colour for all of them, unless there are values or colours; default false: that of the look. */
    bool tinted;

    /** This colour, 65536 red + 256 green + blue. */
    uint32_t tint;

    /** Text at the colour bar, "speed [m/s]"; NULL for none. */
    const char *value_label;

    /** Spacing of the particles [m]; for arrows, streamlines and isolines, which need it. */
    double spacing;

    /** Their velocities [m/s], shown by arrows on a square lattice at whole multiples of its side; NULL: no arrows. One of
     *  the length of a round speed is in the strip of the caption. */
    const double *vx, *vy;

    /** Side of a square of that lattice [m], which is six pixels at least; 0: a 32nd of the larger side of the view. */
    double arrow_spacing;

    /** The speed whose arrow is as long as two of these sides [m/s]; 0: the largest of the particles. */
    double arrow_speed;

    /** Their velocities [m/s], shown by streamlines: lines along them, evenly spaced, with heads that show the direction.
     *  They end at surfaces and walls, and where the liquid is slower than a 200th of the fastest, or a thousandth of
     *  arrow_speed. NULL: none. */
    const double *stream_vx, *stream_vy;

    /** Distance between them [m], six pixels at least; 0: a 40th of the side of a square as large as the view. */
    double streamline_spacing;

    /** One value per particle, shown by isolines where they are whole multiples of level_step; NULL: none. */
    const double *level_values;

    /** The difference from line to line; it becomes larger where there were more than 200 lines. 0: a round number, for
     *  about ten. */
    double level_step;

    /** What the strip of the caption calls them, "Pressures [Pa]"; NULL: nothing. */
    const char *level_label;

    /** Number of places of paths, drawn as lines over the liquid. */
    size_t path_count;

    /** The places [m]. */
    const double *path_x, *path_y;

    /** The path of each place; those of one are next to each other. */
    const uint64_t *path_id;

    /** Number of corners of the outlines of walls and bodies, drawn as filled shapes over the liquid: the fields of
     *  SPH2D_GROUP_OUTLINE. An outline with a corner that is not finite, or millions of pixels away, is omitted. */
    size_t outline_count;

    /** The corners [m]. */
    const double *outline_x, *outline_y;

    /** The outline that each belongs to, those of one next to each other, and where its liquid is
     *  (sph2d_outline_liquid). */
    const uint64_t *outline_id, *outline_liquid;

    /** Thickness with which lines and sides are drawn, at least two pixels [m]; >= 0. */
    double wall_thickness;

    /** A line of UTF-8 text below the picture, beside a scale bar; NULL: no strip. */
    const char *caption;

    /** Lines of UTF-8 text in a box on the picture, in the upper left corner; NULL: no box. Texts have Latin, Greek and
     *  Cyrillic letters; what else there is becomes a box. */
    const char *notes;
} sph2d_picture;

/** Wall time of a frame by stage. */
typedef struct sph2d_frame_times {
    /** Drawing, until OpenGL is done [s]. */
    double draw;

    /** Reading the pixels into memory [s]. */
    double read;

    /** Writing a PNG file, including the wait for the disk [s]; 0: not written. */
    double encode;
} sph2d_frame_times;

/** Creates a renderer. Errors: SPH2D_INVALID, SPH2D_RENDER (with a message that names the missing library or the line
 *  of the shader), SPH2D_NOINPUT (a file is missing in `shader_dir`), SPH2D_NOMEM. The caller owns *renderer (NULL
 *  after a failure). */
SPH2D_API sph2d_status sph2d_renderer_create(const sph2d_render_options *options, sph2d_renderer **renderer,
                                             sph2d_report *report);

/** Frees a renderer; NULL is fine. */
SPH2D_API void sph2d_renderer_destroy(sph2d_renderer *renderer);

/** Draws a picture. Errors: SPH2D_INVALID, SPH2D_RENDER, SPH2D_NOMEM. */
SPH2D_API sph2d_status sph2d_renderer_draw(sph2d_renderer *renderer, const sph2d_picture *picture,
                                           sph2d_report *report);

/** Draws a picture with the caller's context (get_proc_address) into its framebuffer object, 0 for the window's, the
 *  lower left corner at pixel (x, y); nothing is read back. Errors: SPH2D_INVALID (also for a renderer with a context of
 *  its own), SPH2D_RENDER, SPH2D_NOMEM. */
SPH2D_API sph2d_status sph2d_renderer_draw_to(sph2d_renderer *renderer, unsigned framebuffer, int x, int y,
                                              const sph2d_picture *picture, sph2d_report *report);

/** The last picture: width * height pixels of 4 bytes (red, green, blue, alpha: 255 but for a transparent background, and
 *  then not multiplied into the colours), top row first; valid until the next call
 *  with this renderer. NULL before the first draw and after sph2d_renderer_draw_to(). */
SPH2D_API const unsigned char *sph2d_renderer_pixels(const sph2d_renderer *renderer);

/** The place of the plane at a pixel of the last picture, counted from its upper left corner, fractions allowed [m]; for
 *  the mouse. False before the first draw. */
SPH2D_API bool sph2d_renderer_locate(const sph2d_renderer *renderer, double x, double y, sph2d_vec2 *at);

/** Writes the last picture as a PNG, RGB or with a transparent background RGBA, whole or not at all. Errors:
 *  SPH2D_INVALID (nothing drawn), SPH2D_CANTCREAT, SPH2D_IO, SPH2D_NOMEM. */
SPH2D_API sph2d_status sph2d_renderer_write_png(sph2d_renderer *renderer, const char *path, sph2d_report *report);

/** Writes width * height pixels of 4 bytes, top row first, as a PNG, RGBA for a transparent background and else RGB without
 *  the fourth byte, whole or not at all: what
 *  sph2d_renderer_write_png() does with a copy of the pixels, for another thread to do while the renderer draws on. The
 *  same pixels give the same bytes. Sides have 1 to 16384 pixels. Errors: SPH2D_INVALID, SPH2D_CANTCREAT, SPH2D_IO,
 *  SPH2D_NOMEM. */
SPH2D_API sph2d_status sph2d_png_write(const char *path, const unsigned char *pixels, unsigned width, unsigned height,
                                       sph2d_background background, sph2d_report *report);

/** The times of the last picture, and of its last writing. All 0 before the first draw. */
SPH2D_API sph2d_frame_times sph2d_renderer_times(const sph2d_renderer *renderer);

/** The context in use, "osmesa", "egl" or "current" for the caller's, and OpenGL's description of itself; valid as long as the renderer. */
SPH2D_API const char *sph2d_renderer_gl(const sph2d_renderer *renderer);
SPH2D_API const char *sph2d_renderer_gl_version(const sph2d_renderer *renderer);

/** The contexts that this build supports, "osmesa egl"; empty for none. Static storage. */
SPH2D_API const char *sph2d_render_backends(void);

#ifdef __cplusplus
}
#endif
#endif
