/* SPDX-License-Identifier: MIT */
/** @file metaballs.c
 *  Draws metaballs. The appearance of water is in the shaders; its extent is determined here.
 *
 *  The first pass draws every particle as a disc with its field r^4 - r^2 + 1/4 (r in units of R) and adds them up in a
 *  texture of floats, the "field". The second pass shades it. With few pixels per particle the field alone varies only
 *  in a thin rim, so the first pass is repeated on a coarse grid, the "depth", with much wider balls of several
 *  particles each: it rises slowly from the surface inwards, and lighting and colour follow it. */
#include "render/metaballs.h"

#include <math.h>

#include "render/shader.h"

/* There is water where the summed field exceeds T. An isolated ball is then drawn with radius R sqrt(1/2 - sqrt T);
 * this T makes that R/(2 sqrt pi), so that with the usual R of two spacings an isolated particle covers its own area,
 * the square of the spacing: sqrt T = 1/2 - 1/(4 pi). The edge of a body of water is where its outer particles' areas
 * end. */
static const double threshold = 0.17675;

/* Mean field inside a body of water: pi R^2 / 24 per spacing squared, at R = 2 spacings. A square lattice
 * has 0.50 to 0.56. */
static const double field_inside = 0.5236;

/* Smaller balls would fall between the pixels. */
static const double smallest_radius = 3.6; /* [px] */

/* The depth: balls wider by this factor, on a grid of squares that are a fraction of their radius. */
static const double depth_ratio = 9.0, texels_per_radius = 6.0;
static const double finest_texel = 4.0; /* [px] */
enum { MARGIN = 2 };                    /* texels around the image, to interpolate with at its edge */

/* Number of squares of `texel` pixels that cover a length. */
static GLsizei texels(double pixels, double texel)
{
    return (GLsizei)ceil(pixels / texel);
}

/* The same for the finest grid of the depth; its margins may need one more by rounding. */
static GLsizei depth_texels(GLsizei pixels)
{
    return texels(pixels, finest_texel) + 2 * MARGIN + 1;
}

sph2d_status sph2d__metaballs_create(const sph2d__gl *gl, sph2d__metaballs *balls, const char *shader_dir,
                                     GLsizei width, GLsizei height, sph2d_report *report)
{
    *balls = (sph2d__metaballs){0};
    sph2d_status status = sph2d__program_build(gl, shader_dir, "gradientball", &balls->ball_program, report);
    if (status == SPH2D_OK)
        status = sph2d__program_build(gl, shader_dir, "metaballs", &balls->surface_program, report);
    if (status == SPH2D_OK)
        status = sph2d__target_create_float(gl, &balls->field, GL_NEAREST, width, height, report);
    if (status == SPH2D_OK)
        status =
            sph2d__target_create_float(gl, &balls->depth, GL_LINEAR, depth_texels(width), depth_texels(height), report);
    if (status == SPH2D_OK)
        status = sph2d__lumps_create(&balls->lumps, depth_texels(width), depth_texels(height), report);
    if (status == SPH2D_OK)
        status = sph2d__tiles_create(&balls->tiles, width, height, report);
    if (status != SPH2D_OK)
        sph2d__metaballs_destroy(gl, balls);
    return status;
}

/* First pass: prepares to add up the fields of balls of a radius [px] on a grid of squares of `texel` pixels. */
static void begin_adding(const sph2d__gl *gl, GLuint program, const sph2d__target *target, GLsizei columns,
                         GLsizei rows, double radius, double texel)
{
    sph2d__target_bind(gl, target);
    gl->ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    gl->Clear(GL_COLOR_BUFFER_BIT);
    gl->Viewport(0, 0, columns, rows);
    gl->Enable(GL_BLEND);
    gl->BlendEquation(GL_FUNC_ADD);
    gl->BlendFunc(GL_ONE, GL_ONE);
    gl->UseProgram(program);
    sph2d__program_set_vec2(gl, program, "image_size", columns * texel, rows * texel);
    sph2d__program_set_float(gl, program, "radius", radius);
}

/* Draws the depth by balls of a radius [px] on a grid of squares of `texel` pixels. */
static void add_depth(const sph2d__gl *gl, sph2d__metaballs *balls, sph2d__dots *dots, const sph2d__view *view,
                      const sph2d__dot_list *list, double radius, double texel)
{
    const sph2d__view wide = sph2d__view_widen(view, MARGIN * texel);
    const GLsizei columns = texels(wide.width, texel), rows = texels(wide.height, texel);
    begin_adding(gl, balls->ball_program, &balls->depth, columns, rows, radius, texel);
    sph2d__lumps_reset(&balls->lumps, columns, rows, texel);
    sph2d__lumps_draw(gl, &balls->lumps, dots, &wide, list);
}

/* Second pass: the field as water over the background, in the tiles found. */
static void draw_surface(const sph2d__gl *gl, const sph2d__metaballs *balls, sph2d__dots *dots,
                         const sph2d__target *target, double radius, double texel)
{
    const GLuint program = balls->surface_program;
    sph2d__target_bind(gl, target);
    gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE); /* the image stays opaque */
    gl->UseProgram(program);
    gl->ActiveTexture(GL_TEXTURE1);
    gl->BindTexture(GL_TEXTURE_2D, balls->depth.texture);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D, balls->field.texture);
    sph2d__program_set_vec2(gl, program, "image_size", target->width, target->height);
    sph2d__program_set_float(gl, program, "tile", SPH2D__TILE);
    sph2d__program_set_int(gl, program, "field", 0);
    sph2d__program_set_int(gl, program, "depth", 1);
    sph2d__program_set_float(gl, program, "radius", radius);
    sph2d__program_set_float(gl, program, "threshold", threshold);
    sph2d__program_set_float(gl, program, "texel", texel);
    sph2d__program_set_float(gl, program, "margin", MARGIN);
    sph2d__program_set_float(gl, program, "depth_inside", field_inside * depth_ratio * depth_ratio);
    sph2d__tiles_draw(gl, &balls->tiles, dots);
    gl->BindTexture(GL_TEXTURE_2D, 0); /* the next frame draws into them */
    gl->ActiveTexture(GL_TEXTURE1);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->ActiveTexture(GL_TEXTURE0);
}

void sph2d__metaballs_draw(const sph2d__gl *gl, sph2d__metaballs *balls, sph2d__dots *dots, const sph2d__target *target,
                           const sph2d__view *view, sph2d__dot_list list, double radius)
{
    const double pixels = fmax(radius * view->scale, smallest_radius);
    list.reach = pixels * sqrt(0.5);
    sph2d__tiles_find(&balls->tiles, view, &list);
    begin_adding(gl, balls->ball_program, &balls->field, target->width, target->height, pixels, 1);
    sph2d__dots_draw(gl, dots, view, &list);

    const double wide = pixels * depth_ratio;
    /* Balls larger than the image give a nearly uniform depth: no need for a larger grid. */
    const double texel = fmin(fmax(finest_texel, wide / texels_per_radius), view->width + view->height);
    list.reach = wide * sqrt(0.5);
    add_depth(gl, balls, dots, view, &list, wide, texel);
    draw_surface(gl, balls, dots, target, pixels, texel);
}

void sph2d__metaballs_destroy(const sph2d__gl *gl, sph2d__metaballs *balls)
{
    gl->DeleteProgram(balls->ball_program); /* 0 is ignored */
    gl->DeleteProgram(balls->surface_program);
    sph2d__target_destroy(gl, &balls->field);
    sph2d__target_destroy(gl, &balls->depth);
    sph2d__lumps_destroy(&balls->lumps);
    sph2d__tiles_destroy(&balls->tiles);
    *balls = (sph2d__metaballs){0};
}
