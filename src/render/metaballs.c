/* SPDX-License-Identifier: MIT */
/** @file metaballs.c
 *  Draws metaballs. The appearance of water is in the shaders; its extent is determined here.
 *
 *  First the fields of all particles, r^4 - r^2 + 1/4 with r in units of R, are added up for each pixel: the "field". With
 *  few pixels per particle the field alone varies only in a thin rim, so there is a second sum on a coarse grid, the
 *  "depth", of much wider balls of several particles each: it rises slowly from the surface inwards, and lighting and
 *  colour follow it. Then the tiles of the image where there is liquid are shaded: inside it by a shorter program. */
#include "render/metaballs.h"

#include <math.h>
#include <stdlib.h>

#include "render/colormap.h"
#include "render/shader.h"

/* Textures that the shader reads; the last one is the caller's. */
enum { FIELD, DEPTH, TINT, TEXTURES, WALLS = TEXTURES };
_Static_assert((int)TEXTURES == SPH2D__METABALL_TEXTURES, "each has a place in sph2d__metaballs");

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

/* The field from which a body of water counts as full, as metaballs.frag has it, and the least that it draws. */
static const double full = 0.36, lowest = 0.4 * 0.17675;

/* What metaballs.frag knows a look by: where there may be a surface, and inside. */
static const char *const look_names[][2] = {[SPH2D_LOOK_WATER] = {"WATER", "WATER\n#define INSIDE"},
                                            [SPH2D_LOOK_FLAT] = {"FLAT", "FLAT\n#define INSIDE"},
                                            [SPH2D_LOOK_GLASS] = {"GLASS", "GLASS\n#define INSIDE"},
                                            [SPH2D_LOOK_INK] = {"INK", "INK\n#define INSIDE"}};

/* Width of lines [px]. */
static double line_width(const sph2d__target *target)
{
    const GLsizei side = target->width < target->height ? target->width : target->height;
    return fmax(1.4, side / 300.0);
}

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

static sph2d_status no_memory(sph2d_report *report)
{
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory for drawing metaballs");
    return SPH2D_NOMEM;
}

static sph2d_status create_grids(sph2d__metaballs *balls, GLsizei width, GLsizei height, sph2d_report *report)
{
    const GLsizei columns = depth_texels(width), rows = depth_texels(height);
    const bool made = sph2d__field_grid_create(&balls->field, width, height, 1) &&
                      sph2d__field_grid_create(&balls->depth, columns, rows, 1) &&
                      sph2d__cover_create(&balls->walls, columns, rows);
    balls->rises = made ? malloc((size_t)columns * (size_t)rows * sizeof *balls->rises) : NULL;
    if (!balls->rises)
        return no_memory(report);
    const sph2d_status status = sph2d__lumps_create(&balls->lumps, columns, rows, report);
    return status == SPH2D_OK ? sph2d__tiles_create(&balls->tiles, width, height, report) : status;
}

static void create_textures(const sph2d__gl *gl, sph2d__metaballs *balls, GLsizei width, GLsizei height)
{
    gl->GenTextures(TEXTURES, balls->textures);
    sph2d__texture_prepare(gl, balls->textures[FIELD], GL_NEAREST);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, width, height, 0, GL_RED, GL_FLOAT, NULL);
    sph2d__texture_prepare(gl, balls->textures[DEPTH], GL_LINEAR);
    sph2d__texture_prepare(gl, balls->textures[TINT], GL_NEAREST); /* larger when there are colours */
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    gl->BindTexture(GL_TEXTURE_2D, 0);
}

sph2d_status sph2d__metaballs_create(const sph2d__gl *gl, sph2d__metaballs *balls, const char *shader_dir,
                                     sph2d_look look, GLsizei width, GLsizei height, sph2d_report *report)
{
    *balls = (sph2d__metaballs){.look = look};
    sph2d_status status = SPH2D_OK;
    for (int k = 0; k < 2 && status == SPH2D_OK; ++k)
        status = sph2d__program_build(gl, shader_dir, (const char *[2]){"tiles", "metaballs"}, look_names[look][k],
                                      &balls->programs[k], report);
    if (status == SPH2D_OK)
        status = create_grids(balls, width, height, report);
    if (status == SPH2D_OK) {
        create_textures(gl, balls, width, height);
        status = sph2d__gl_check(gl, "preparing to draw metaballs", report);
    }
    if (status != SPH2D_OK)
        sph2d__metaballs_destroy(gl, balls);
    return status;
}

/* ---- sums -------------------------------------------------------------------------------------------------------- */

/* Gives the field room for colours, or takes it: they make the sums slower. */
static bool set_planes(const sph2d__gl *gl, sph2d__metaballs *balls, int planes)
{
    const int columns = balls->field.columns, rows = balls->field.rows;
    if (balls->field.planes == planes)
        return true;
    unsigned char(*tints)[4] = planes > 1 ? malloc((size_t)columns * (size_t)rows * sizeof *tints) : NULL;
    sph2d__field_grid field = {0};
    if ((planes > 1 && !tints) || !sph2d__field_grid_create(&field, columns, rows, planes)) {
        free(tints);
        return false;
    }
    sph2d__field_grid_destroy(&balls->field);
    free(balls->tints);
    balls->field = field;
    balls->tints = tints;
    if (tints) {
        gl->BindTexture(GL_TEXTURE_2D, balls->textures[TINT]);
        gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, columns, rows, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    }
    return true;
}

/* Adds up the balls of a list, with colours where it has values. */
static void sum_field(sph2d__field_grid *field, const sph2d__view *view, const sph2d__dot_list *list, double radius)
{
    sph2d__field_grid_reset(field, field->columns, field->rows);
    for (size_t i = 0; i < list->count; ++i) {
        float pixel[2];
        unsigned char color[4] = {0};
        if (!sph2d__view_place(view, list->x[i], list->y[i], list->reach, pixel))
            continue;
        if (list->values)
            sph2d__colormap((list->values[i] - list->value_min) / (list->value_max - list->value_min), list->diverging,
                            color);
        sph2d__field_grid_add(field, pixel, radius, 1.0F, (float[3]){color[0], color[1], color[2]});
    }
}

/* The mean colours of some rows, where anything is drawn. */
static void find_tints(sph2d__metaballs *balls, int top, int bottom)
{
    const sph2d__field_grid *field = &balls->field;
    const float least = (float)(0.5 * lowest);
    for (int y = top; y < bottom; ++y) {
        const float *sum = sph2d__field_grid_row(field, y), *red = sum + field->stride, *green = red + field->stride,
                    *blue = green + field->stride;
        unsigned char(*tint)[4] = balls->tints + (size_t)y * (size_t)field->columns;
        for (int x = 0; x < field->columns; ++x) {
            const float part = 1.0F / (sum[x] > least ? sum[x] : 1.0F);
            tint[x][0] = (unsigned char)(red[x] * part + 0.5F);
            tint[x][1] = (unsigned char)(green[x] * part + 0.5F);
            tint[x][2] = (unsigned char)(blue[x] * part + 0.5F);
            tint[x][3] = 255;
        }
    }
}

/* Uploads the rows of the field that differ from 0, and those that the shader reads around their tiles. */
static void upload_field(const sph2d__gl *gl, sph2d__metaballs *balls, double radius)
{
    const sph2d__field_grid *field = &balls->field;
    const int around = (int)fmin(0.4 * radius + 2.0 + SPH2D__TILE, field->rows);
    const int top = field->top > around ? field->top - around : 0;
    const int bottom = field->bottom < field->rows - around ? field->bottom + around : field->rows;
    if (field->top >= field->bottom)
        return;
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl->PixelStorei(GL_UNPACK_ROW_LENGTH, (GLint)((size_t)field->planes * field->stride));
    gl->BindTexture(GL_TEXTURE_2D, balls->textures[FIELD]);
    gl->TexSubImage2D(GL_TEXTURE_2D, 0, 0, top, field->columns, bottom - top, GL_RED, GL_FLOAT,
                      sph2d__field_grid_row(field, top));
    gl->PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
    if (field->planes == 1)
        return;
    find_tints(balls, top, bottom);
    gl->BindTexture(GL_TEXTURE_2D, balls->textures[TINT]);
    gl->TexSubImage2D(GL_TEXTURE_2D, 0, 0, top, field->columns, bottom - top, GL_RGBA, GL_UNSIGNED_BYTE,
                      balls->tints[(size_t)top * (size_t)field->columns]);
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

/* Adds up the depth by balls of a radius [px] on a grid of squares of `texel` pixels. */
static void sum_depth(sph2d__metaballs *balls, const sph2d__view *view, const sph2d__dot_list *list,
                      const sph2d_picture *picture, double radius, double texel)
{
    const sph2d__view wide = sph2d__view_widen(view, MARGIN * texel);
    const GLsizei columns = texels(wide.width, texel), rows = texels(wide.height, texel);
    sph2d__field_grid_reset(&balls->depth, columns, rows);
    sph2d__lumps_reset(&balls->lumps, columns, rows, texel);
    add_walls(balls, &wide, picture, columns, rows, radius, texel);
    sph2d__lumps_sum(&balls->lumps, &balls->depth, &wide, list, radius);
}

/* Uploads how much the depth rises to the right and down and its mean, from the four places around each, in units of the
 * depth of a large body of water. Not by half precision where that can be: the lines of INK show its steps. */
static void upload_depth(const sph2d__gl *gl, sph2d__metaballs *balls)
{
    const float part = (float)(1.0 / (field_inside * depth_ratio * depth_ratio));
    const int columns = balls->depth.columns, rows = balls->depth.rows;
    float(*rise)[4] = balls->rises;
    for (int y = 0; y < rows; ++y) {
        const float *here = sph2d__field_grid_row(&balls->depth, y);
        const float *above = sph2d__field_grid_row(&balls->depth, y > 0 ? y - 1 : y);
        const float *below = sph2d__field_grid_row(&balls->depth, y < rows - 1 ? y + 1 : y);
        for (int x = 0; x < columns; ++x, ++rise) {
            const float left = part * here[x > 0 ? x - 1 : x], right = part * here[x < columns - 1 ? x + 1 : x];
            (*rise)[0] = right - left;
            (*rise)[1] = part * (below[x] - above[x]);
            (*rise)[2] = 0.25F * (right + left + part * (below[x] + above[x]));
            (*rise)[3] = 1.0F;
        }
    }
    gl->BindTexture(GL_TEXTURE_2D, balls->textures[DEPTH]);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl->TexImage2D(GL_TEXTURE_2D, 0, gl->half ? GL_RGBA16F : GL_RGBA32F, columns, rows, 0, GL_RGBA, GL_FLOAT,
                   balls->rises);
}

/* ---- drawing ----------------------------------------------------------------------------------------------------- */

static void bind_texture(const sph2d__gl *gl, int unit, GLuint texture)
{
    gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    gl->BindTexture(GL_TEXTURE_2D, texture);
}

/* Draws the tiles of a kind. */
static void draw_tiles(const sph2d__gl *gl, const sph2d__metaballs *balls, sph2d__dots *dots,
                       const sph2d__target *target, const sph2d_picture *picture, unsigned char kind, double radius,
                       double texel)
{
    const GLuint program = balls->programs[kind == SPH2D__TILE_INSIDE];
    gl->UseProgram(program);
    sph2d__program_set_vec2(gl, program, "image_size", target->width, target->height);
    sph2d__program_set_float(gl, program, "tile", SPH2D__TILE);
    sph2d__program_set_int(gl, program, "field", FIELD);
    sph2d__program_set_int(gl, program, "depth", DEPTH);
    sph2d__program_set_int(gl, program, "tint", TINT);
    sph2d__program_set_int(gl, program, "walls", WALLS);
    sph2d__program_set_int(gl, program, "colored", picture->values != NULL);
    sph2d__program_set_int(gl, program, "charted", !picture->values && !picture->level_values);
    sph2d__program_set_float(gl, program, "radius", radius);
    sph2d__program_set_float(gl, program, "threshold", threshold);
    sph2d__program_set_float(gl, program, "line_width", line_width(target));
    sph2d__program_set_float(gl, program, "texel", texel);
    sph2d__program_set_float(gl, program, "margin", MARGIN);
    sph2d__tiles_draw(gl, &balls->tiles, dots, kind);
}

/* Draws the liquid over what is in the target. */
static void draw_surface(const sph2d__gl *gl, const sph2d__metaballs *balls, sph2d__dots *dots,
                         const sph2d__target *target, const sph2d_picture *picture, GLuint walls, double radius,
                         double texel)
{
    sph2d__target_bind(gl, target);
    sph2d__target_blend(gl, target);
    bind_texture(gl, WALLS, walls);
    for (int unit = TEXTURES - 1; unit >= 0; --unit)
        bind_texture(gl, unit, balls->textures[unit]);
    draw_tiles(gl, balls, dots, target, picture, SPH2D__TILE_TOUCHED, radius, texel);
    if (balls->look != SPH2D_LOOK_GLASS) /* opaque inside */
        gl->Disable(GL_BLEND);
    draw_tiles(gl, balls, dots, target, picture, SPH2D__TILE_INSIDE, radius, texel);
    for (int unit = WALLS; unit >= 0; --unit)
        bind_texture(gl, unit, 0);
}

/* A tile is inside where no pixel would differ: the rim is flat, the surface farther than its slope at this place tells
 * and, where there is a line along it, the line too. */
static sph2d__tile_rule rule_of(const sph2d__metaballs *balls, const sph2d__target *target, double radius)
{
    const double pixels = balls->look == SPH2D_LOOK_WATER ? 0.9 : line_width(target) + 0.5;
    return (sph2d__tile_rule){.lowest = (float)lowest,
                              .full = (float)full,
                              .range = (float)(sqrt(2.0) * (full - threshold) / pixels),
                              .around = 0.4 * radius + 1.0};
}

sph2d_status sph2d__metaballs_draw(const sph2d__gl *gl, sph2d__metaballs *balls, sph2d__dots *dots,
                                   const sph2d__target *target, const sph2d__view *view, sph2d__dot_list list,
                                   const sph2d_picture *picture, GLuint walls, sph2d_report *report)
{
    if (!set_planes(gl, balls, list.values ? 4 : 1))
        return no_memory(report);
    const double pixels = fmax(picture->radius * view->scale, smallest_radius);
    list.reach = pixels * sqrt(0.5);
    sum_field(&balls->field, view, &list, pixels);
    upload_field(gl, balls, pixels);
    const sph2d__tile_rule rule = rule_of(balls, target, pixels);
    sph2d__tiles_find(&balls->tiles, &balls->field, &rule);

    const double wide = pixels * depth_ratio;
    /* Balls larger than the image give a nearly uniform depth: no need for a larger grid. */
    const double texel = fmin(fmax(finest_texel, wide / texels_per_radius), view->width + view->height);
    list.reach = wide * sqrt(0.5);
    sum_depth(balls, view, &list, picture, wide, texel);
    upload_depth(gl, balls);
    draw_surface(gl, balls, dots, target, picture, walls, pixels, texel);
    return SPH2D_OK;
}

void sph2d__metaballs_destroy(const sph2d__gl *gl, sph2d__metaballs *balls)
{
    for (int k = 0; k < 2; ++k)
        gl->DeleteProgram(balls->programs[k]); /* 0 is ignored */
    gl->DeleteTextures(TEXTURES, balls->textures);
    sph2d__field_grid_destroy(&balls->field);
    sph2d__field_grid_destroy(&balls->depth);
    free(balls->tints);
    free(balls->rises);
    sph2d__lumps_destroy(&balls->lumps);
    sph2d__cover_destroy(&balls->walls);
    sph2d__tiles_destroy(&balls->tiles);
    *balls = (sph2d__metaballs){0};
}
