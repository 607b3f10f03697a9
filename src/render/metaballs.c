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

/* What metaballs.frag knows a look by. */
static const char *const look_names[] = {
    [SPH2D_LOOK_WATER] = "WATER", [SPH2D_LOOK_FLAT] = "FLAT", [SPH2D_LOOK_GLASS] = "GLASS", [SPH2D_LOOK_INK] = "INK"};

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
                                     sph2d_look look, GLsizei width, GLsizei height, sph2d_report *report)
{
    *balls = (sph2d__metaballs){.channels = 1};
    sph2d_status status = sph2d__program_build(gl, shader_dir, (const char *[2]){"gradientball", "gradientball"}, NULL,
                                               &balls->ball_program, report);
    if (status == SPH2D_OK)
        status = sph2d__program_build(gl, shader_dir, (const char *[2]){"tiles", "metaballs"}, look_names[look],
                                      &balls->surface_program, report);
    if (status == SPH2D_OK)
        status = sph2d__target_create_float(gl, &balls->field, 1, GL_NEAREST, width, height, report);
    if (status == SPH2D_OK)
        status = sph2d__target_create_float(gl, &balls->depth, 1, GL_LINEAR, depth_texels(width), depth_texels(height),
                                            report);
    if (status == SPH2D_OK)
        status = sph2d__lumps_create(&balls->lumps, depth_texels(width), depth_texels(height), report);
    if (status == SPH2D_OK && !sph2d__cover_create(&balls->walls, depth_texels(width), depth_texels(height))) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory for drawing metaballs");
        status = SPH2D_NOMEM;
    }
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

/* Counts walls as filled with liquid, so that water is not lighter at them. */
static void add_walls(sph2d__metaballs *balls, const sph2d__view *wide, const sph2d_picture *picture, int columns,
                      int rows, double radius, double texel)
{
    sph2d__view grid = *wide;
    grid.middle = (sph2d_vec2){wide->middle.x / texel, wide->middle.y / texel};
    grid.scale /= texel;
    sph2d__cover_clear(&balls->walls, columns, rows);
    sph2d__walls_cover(&balls->walls, &grid, picture, radius * sqrt(0.5) / wide->scale);
    const double side = radius / depth_ratio / 2; /* of a particle's square [px] */
    const float most = (float)(texel * texel / (side * side) / 255);
    for (size_t k = 0; k < (size_t)columns * (size_t)rows; ++k)
        balls->lumps.weights[k] += most * balls->walls.pixels[k];
}

/* Draws the depth by balls of a radius [px] on a grid of squares of `texel` pixels. */
static void add_depth(const sph2d__gl *gl, sph2d__metaballs *balls, sph2d__dots *dots, const sph2d__view *view,
                      const sph2d__dot_list *list, const sph2d_picture *picture, double radius, double texel)
{
    const sph2d__view wide = sph2d__view_widen(view, MARGIN * texel);
    const GLsizei columns = texels(wide.width, texel), rows = texels(wide.height, texel);
    begin_adding(gl, balls->ball_program, &balls->depth, columns, rows, radius, texel);
    sph2d__lumps_reset(&balls->lumps, columns, rows, texel);
    add_walls(balls, &wide, picture, columns, rows, radius, texel);
    sph2d__lumps_draw(gl, &balls->lumps, dots, &wide, list);
}

static void bind_texture(const sph2d__gl *gl, int unit, GLuint texture)
{
    gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    gl->BindTexture(GL_TEXTURE_2D, texture);
}

/* Second pass: the field as water over the background, in the tiles found. */
static void draw_surface(const sph2d__gl *gl, const sph2d__metaballs *balls, sph2d__dots *dots,
                         const sph2d__target *target, const sph2d_picture *picture, GLuint walls, double radius,
                         double texel)
{
    const GLuint program = balls->surface_program;
    sph2d__target_bind(gl, target);
    sph2d__target_blend(gl, target);
    gl->UseProgram(program);
    bind_texture(gl, 2, walls);
    bind_texture(gl, 1, balls->depth.texture);
    bind_texture(gl, 0, balls->field.texture);
    sph2d__program_set_vec2(gl, program, "image_size", target->width, target->height);
    sph2d__program_set_float(gl, program, "tile", SPH2D__TILE);
    sph2d__program_set_int(gl, program, "field", 0);
    sph2d__program_set_int(gl, program, "depth", 1);
    sph2d__program_set_int(gl, program, "walls", 2);
    sph2d__program_set_int(gl, program, "colored", picture->values != NULL);
    sph2d__program_set_int(gl, program, "charted", !picture->values && !picture->level_values);
    sph2d__program_set_float(gl, program, "radius", radius);
    sph2d__program_set_float(gl, program, "threshold", threshold);
    sph2d__program_set_float(gl, program, "texel", texel);
    sph2d__program_set_float(gl, program, "margin", MARGIN);
    sph2d__program_set_float(gl, program, "depth_inside", field_inside * depth_ratio * depth_ratio);
    sph2d__tiles_draw(gl, &balls->tiles, dots);
    for (int unit = 2; unit >= 0; --unit)
        bind_texture(gl, unit, 0); /* the next frame draws into them */
}

/* Gives the field room for colours, or takes it: they make the first pass slower. */
static sph2d_status set_channels(const sph2d__gl *gl, sph2d__metaballs *balls, int channels, sph2d_report *report)
{
    if (balls->channels == channels)
        return SPH2D_OK;
    const GLsizei width = balls->field.width, height = balls->field.height;
    sph2d__target_destroy(gl, &balls->field);
    balls->channels = channels;
    return sph2d__target_create_float(gl, &balls->field, channels, GL_NEAREST, width, height, report);
}

sph2d_status sph2d__metaballs_draw(const sph2d__gl *gl, sph2d__metaballs *balls, sph2d__dots *dots,
                                   const sph2d__target *target, const sph2d__view *view, sph2d__dot_list list,
                                   const sph2d_picture *picture, GLuint walls, sph2d_report *report)
{
    const sph2d_status status = set_channels(gl, balls, list.values ? 4 : 1, report);
    if (status != SPH2D_OK)
        return status;
    const double pixels = fmax(picture->radius * view->scale, smallest_radius);
    list.reach = pixels * sqrt(0.5);
    sph2d__tiles_find(&balls->tiles, view, &list);
    begin_adding(gl, balls->ball_program, &balls->field, target->width, target->height, pixels, 1);
    sph2d__dots_draw(gl, dots, view, &list);

    const double wide = pixels * depth_ratio;
    /* Balls larger than the image give a nearly uniform depth: no need for a larger grid. */
    const double texel = fmin(fmax(finest_texel, wide / texels_per_radius), view->width + view->height);
    list.reach = wide * sqrt(0.5);
    add_depth(gl, balls, dots, view, &list, picture, wide, texel);
    draw_surface(gl, balls, dots, target, picture, walls, pixels, texel);
    return SPH2D_OK;
}

void sph2d__metaballs_destroy(const sph2d__gl *gl, sph2d__metaballs *balls)
{
    gl->DeleteProgram(balls->ball_program); /* 0 is ignored */
    gl->DeleteProgram(balls->surface_program);
    sph2d__target_destroy(gl, &balls->field);
    sph2d__target_destroy(gl, &balls->depth);
    sph2d__lumps_destroy(&balls->lumps);
    sph2d__cover_destroy(&balls->walls);
    sph2d__tiles_destroy(&balls->tiles);
    *balls = (sph2d__metaballs){0};
}
