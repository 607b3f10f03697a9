/* SPDX-License-Identifier: MIT */
/** @file metaballs.c
 *  Draws metaballs. The appearance of water is in the shaders; its extent is determined here.
 *
 *  The first pass (gradientball) draws every particle as a point with its field r^4 - r^2 + 1/4, r in units of R, and
 *  blending adds them up in a texture of floats, the "field". With few pixels per particle the field alone varies only in
 *  a thin rim, so the pass is repeated on a coarse grid with much wider balls of several particles each: the "depth", which
 *  rises slowly from the surface inwards, and which lighting and colour follow. The second pass (metaballs) makes a liquid
 *  of the two, tile by tile: nothing where there is none, and inside it by a program without a rim. All of it is done by
 *  OpenGL: the processor hands over the particles once a picture, and sums nothing. */
#include "render/metaballs.h"

#include <math.h>

#include "render/gl_loader.h"
#include "render/target.h"

/* Texture units of the second pass. */
enum { FIELD, COLORS, DEPTH, WALLS, KINDS, UNITS };

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

/* A ball's field ends at so many R. */
static const double ball_reach = 0.70710678;

/* The depth: balls wider by this factor, on a grid of squares of so many R. The field of a ball of radius R has the variance
 * R^2/16 along each axis. These have that of balls 9 times as wide whose weights are spread over the four nodes of the
 * grid around, which adds a sixth of a square: 9.33^2 = 9^2 + 16/6 1.5^2. */
static const double depth_ratio = 9.33, square_side = 1.5;

/* Squares around the image: as many as a wall outside is seen from inside, and a texel has two. */
enum { MARGIN = 4 };

/* The field from which a body of water counts as full, as metaballs.frag has it, and the least that it draws. */
static const double full = 0.36, lowest = 0.4 * 0.17675;

/* Cells of limits.frag, of which a tile has two by two; wider surroundings of a tile take more time than they save. */
enum { CELL = SPH2D__TILE / 2, WIDEST = 4 }; /* [px], [cells] */

/* What metaballs.frag knows a look by: where there may be a surface, and inside. */
static const char *const look_names[][2] = {[SPH2D_LOOK_WATER] = {"WATER", "WATER\n#define INSIDE"},
                                            [SPH2D_LOOK_FLAT] = {"FLAT", "FLAT\n#define INSIDE"},
                                            [SPH2D_LOOK_GLASS] = {"GLASS", "GLASS\n#define INSIDE"},
                                            [SPH2D_LOOK_INK] = {"INK", "INK\n#define INSIDE"}};

/* Number of squares of `texel` pixels that cover a length. */
static GLsizei texels(double pixels, double texel)
{
    return (GLsizei)ceil(pixels / texel);
}

/* Number of squares of the depth's grid along a side of the image. */
static GLsizei depth_squares(GLsizei pixels, double side)
{
    return texels(pixels, side) + 2 * MARGIN;
}

static sph2d_status no_memory(sph2d_report *report)
{
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory for drawing metaballs");
    return SPH2D_NOMEM;
}

/* Texels that hold two by two squares of a grid. */
static GLsizei half(GLsizei squares)
{
    return (squares + 1) / 2;
}

/* ---- creation ---------------------------------------------------------------------------------------------------- */

static sph2d_status build_programs(const sph2d__gl *gl, sph2d__metaballs *balls, const char *dir, sph2d_report *report)
{
    const struct {
        const char *names[2], *defined;
        GLuint *program;
    } wanted[] = {{{"gradientball", "gradientball"}, NULL, &balls->balls[0]},
                  {{"gradientball", "gradientball"}, "COLORED", &balls->balls[1]},
                  {{"grid", "depth"}, NULL, &balls->depth_program},
                  {{"grid", "limits"}, NULL, &balls->limits_program},
                  {{"grid", "kinds"}, NULL, &balls->kinds_program},
                  {{"tiles", "metaballs"}, look_names[balls->look][0], &balls->looks[0]},
                  {{"tiles", "metaballs"}, look_names[balls->look][1], &balls->looks[1]}};
    sph2d_status status = SPH2D_OK;
    for (size_t k = 0; k < sizeof wanted / sizeof *wanted && status == SPH2D_OK; ++k)
        status = sph2d__program_build(gl, dir, (const char *[2]){wanted[k].names[0], wanted[k].names[1]},
                                      wanted[k].defined, wanted[k].program, report);
    return status;
}

/* Gives the field room for colours, or takes it: they make the first pass slower. */
static sph2d_status create_field(const sph2d__gl *gl, sph2d__metaballs *balls, bool colored, sph2d_report *report)
{
    sph2d__target_destroy(gl, &balls->field);
    balls->colored = colored;
    return sph2d__target_create_float(gl, &balls->field, colored ? 2 : 1, GL_NEAREST, half(balls->width),
                                      half(balls->height), report);
}

static sph2d_status create_targets(const sph2d__gl *gl, sph2d__metaballs *balls, sph2d_report *report)
{
    const double finest = smallest_radius * square_side;
    const GLsizei columns = depth_squares(balls->width, finest), rows = depth_squares(balls->height, finest);
    const GLsizei across = texels(balls->width, CELL), down = texels(balls->height, CELL);
    sph2d_status status = create_field(gl, balls, false, report);
    if (status == SPH2D_OK)
        status = sph2d__target_create_float(gl, &balls->sums, 1, GL_NEAREST, half(columns), half(rows), report);
    if (status == SPH2D_OK)
        status = sph2d__target_create_float(gl, &balls->depth, 1, GL_LINEAR, columns, rows, report);
    if (status == SPH2D_OK)
        status = sph2d__target_create_float(gl, &balls->limits, 1, GL_NEAREST, across, down, report);
    if (status == SPH2D_OK)
        status = sph2d__target_create_color(gl, &balls->kinds, sph2d__tiles_count(balls->width),
                                            sph2d__tiles_count(balls->height), report);
    return status == SPH2D_OK && !sph2d__cover_create(&balls->cover, columns, rows) ? no_memory(report) : status;
}

sph2d_status sph2d__metaballs_create(const sph2d__gl *gl, sph2d__metaballs *balls, const char *shader_dir,
                                     sph2d_look look, GLsizei width, GLsizei height, sph2d_report *report)
{
    *balls = (sph2d__metaballs){.look = look, .width = width, .height = height};
    sph2d_status status = build_programs(gl, balls, shader_dir, report);
    if (status == SPH2D_OK)
        status = create_targets(gl, balls, report);
    if (status == SPH2D_OK)
        status = sph2d__dots_create(gl, &balls->walls, report);
    if (status != SPH2D_OK)
        sph2d__metaballs_destroy(gl, balls);
    return status;
}

/* ---- first pass: sums -------------------------------------------------------------------------------------------- */

/* Adds balls of a radius [px] to the target in use; those of opacity 1 count as `weight` particles. */
static void add_balls(const sph2d__gl *gl, GLuint program, const sph2d__dots *dots, const sph2d__raster *on,
                      double radius, double weight)
{
    gl->UseProgram(program);
    sph2d__program_set_float(gl, program, "unit", on->texel / radius);
    sph2d__program_set_float(gl, program, "weight", weight);
    sph2d__dots_draw(gl, dots, program, on, radius * ball_reach);
}

/* Makes balls of the walls on the coarse grid: one for each square that they cover, opaque where they cover all of it. */
static void find_walls(const sph2d__gl *gl, sph2d__metaballs *balls, const sph2d__view *view,
                       const sph2d_picture *picture)
{
    enum { BATCH = 256 };
    const double reach = balls->radius * depth_ratio * ball_reach, texel = balls->texel;
    sph2d__dot batch[BATCH];
    size_t filled = 0;
    sph2d__view grid = *view;
    grid.middle = (sph2d_vec2){view->middle.x / texel + MARGIN, view->middle.y / texel + MARGIN};
    grid.scale /= texel;
    sph2d__cover_clear(&balls->cover, balls->columns, balls->rows);
    sph2d__walls_cover(&balls->cover, &grid, picture, reach / view->scale);
    const int squares = balls->columns * balls->rows;
    sph2d__dots_reserve(gl, &balls->walls, (size_t)squares);
    for (int k = 0; k < squares; ++k) {
        const double x = k % balls->columns + 0.5 - MARGIN, y = k / balls->columns + 0.5 - MARGIN;
        const unsigned char covered = balls->cover.pixels[k];
        if (covered > 0)
            batch[filled++] = (sph2d__dot){{(float)(x * texel), (float)(y * texel)}, {0, 0, 0, covered}};
        if (filled == BATCH || k == squares - 1) {
            sph2d__dots_add(gl, &balls->walls, batch, filled);
            filled = 0;
        }
    }
}

/* A pass over a target that computes each texel from a texture, by a program that is in use and calls it `name`. */
static void compute(const sph2d__gl *gl, GLuint program, const sph2d__target *target, GLsizei columns, GLsizei rows,
                    const char *name, GLuint texture)
{
    sph2d__target_bind(gl, target);
    gl->Viewport(0, 0, columns, rows);
    gl->Disable(GL_BLEND);
    gl->BindVertexArray(gl->no_vertices);
    sph2d__texture_bind(gl, 0, texture);
    sph2d__program_set_int(gl, program, name, 0);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    sph2d__texture_bind(gl, 0, 0);
}

/* Sums the wide balls of the particles, and of the walls: these count as filled with liquid, so that water is not lighter
 * at them. */
static void sum_depth(const sph2d__gl *gl, sph2d__metaballs *balls, const sph2d__dots *dots)
{
    const double radius = balls->radius * depth_ratio, side = balls->radius / 2; /* of a particle's square [px] */
    const double square = balls->texel * balls->texel / (side * side);           /* [particles] */
    const sph2d__raster on = {half(balls->columns), half(balls->rows), 2 * balls->texel, MARGIN / 2, 2};
    sph2d__target_begin_sum(gl, &balls->sums);
    add_balls(gl, balls->balls[0], &balls->walls, &on, radius, square);
    add_balls(gl, balls->balls[0], dots, &on, radius, 1.0);

    const GLuint program = balls->depth_program;
    gl->UseProgram(program);
    sph2d__program_set_float(gl, program, "part", 1.0 / (field_inside * depth_ratio * depth_ratio));
    gl->Uniform2i(gl->GetUniformLocation(program, "last"), balls->columns - 1, balls->rows - 1);
    compute(gl, program, &balls->depth, balls->columns, balls->rows, "sums", balls->sums.texture);
}

/* Width of lines [px]. */
static double line_width(const sph2d__metaballs *balls)
{
    return fmax(1.4, fmin(balls->width, balls->height) / 300.0);
}

/* A tile is inside where no pixel would differ: the rim is flat, the surface farther than its slope at this place tells
 * and, where there is a line along it, the line too. */
static void find_kinds(const sph2d__gl *gl, sph2d__metaballs *balls)
{
    GLuint program = balls->limits_program;
    gl->UseProgram(program);
    compute(gl, program, &balls->limits, balls->limits.width, balls->limits.height, "field", balls->field.texture);

    const double pixels = balls->look == SPH2D_LOOK_WATER ? 0.9 : line_width(balls) + 0.5;
    const double around = ceil((0.4 * balls->radius + 1.0) / CELL);
    program = balls->kinds_program;
    gl->UseProgram(program);
    sph2d__program_set_float(gl, program, "lowest", lowest);
    sph2d__program_set_float(gl, program, "full", around <= WIDEST ? full : 1.0e9);
    sph2d__program_set_float(gl, program, "range", sqrt(2.0) * (full - threshold) / pixels);
    sph2d__program_set_int(gl, program, "around", around <= WIDEST ? (int)around : 0);
    compute(gl, program, &balls->kinds, balls->kinds.width, balls->kinds.height, "limits", balls->limits.texture);
}

/* Sets R, and the squares of the depth. Balls larger than the image give a nearly uniform one: no need for a larger grid. */
static void set_radius(sph2d__metaballs *balls, double radius)
{
    balls->radius = radius;
    balls->texel = fmin(square_side * radius, balls->width + balls->height);
    balls->columns = depth_squares(balls->width, balls->texel);
    balls->rows = depth_squares(balls->height, balls->texel);
}

sph2d_status sph2d__metaballs_sum(const sph2d__gl *gl, sph2d__metaballs *balls, sph2d__dots *dots,
                                  const sph2d__view *view, sph2d__dot_list list, const sph2d_picture *picture,
                                  uint64_t walls_mark, sph2d_report *report)
{
    const bool colored = list.values || list.colors;
    const bool ready = balls->field.framebuffer && balls->colored == colored;
    const sph2d_status status = ready ? SPH2D_OK : create_field(gl, balls, colored, report);
    if (status != SPH2D_OK)
        return status;
    const double radius = fmax(picture->radius * view->scale, smallest_radius);
    if (radius != balls->radius || walls_mark != balls->walls_mark) {
        set_radius(balls, radius);
        find_walls(gl, balls, view, picture);
        balls->walls_mark = walls_mark;
    }
    list.reach = radius * depth_ratio * ball_reach;
    sph2d__dots_fill(gl, dots, view, &list);
    const sph2d__raster image = {balls->field.width, balls->field.height, 2.0, 0, 2};
    sph2d__target_begin_sum(gl, &balls->field);
    add_balls(gl, balls->balls[colored], dots, &image, radius, 1.0);
    if (balls->look != SPH2D_LOOK_FLAT) /* one colour */
        sum_depth(gl, balls, dots);
    find_kinds(gl, balls);
    return SPH2D_OK;
}

/* ---- second pass: a liquid --------------------------------------------------------------------------------------- */

/* Draws the tiles of a kind. */
static void shade_tiles(const sph2d__gl *gl, const sph2d__metaballs *balls, const sph2d__target *target,
                        const sph2d_picture *picture, int kind)
{
    const GLuint program = balls->looks[kind == SPH2D__TILE_INSIDE];
    gl->UseProgram(program);
    sph2d__program_set_int(gl, program, "field", FIELD);
    sph2d__program_set_int(gl, program, "colors", COLORS);
    sph2d__program_set_int(gl, program, "depth", DEPTH);
    sph2d__program_set_int(gl, program, "walls", WALLS);
    gl->Uniform2i(gl->GetUniformLocation(program, "last"), balls->width - 1, balls->height - 1);
    sph2d__program_set_int(gl, program, "colored", picture->values || picture->colors);
    unsigned char tint[3];
    sph2d__color_split(picture->tint, tint);
    const bool tinted = !picture->values && (picture->colors || picture->tinted);
    gl->Uniform4f(gl->GetUniformLocation(program, "tint"), (float)tint[0] / 255.0F, (float)tint[1] / 255.0F,
                  (float)tint[2] / 255.0F, tinted ? 1.0F : 0.0F);
    sph2d__program_set_int(gl, program, "charted", !picture->values && !picture->level_values);
    sph2d__program_set_float(gl, program, "radius", balls->radius);
    sph2d__program_set_float(gl, program, "threshold", threshold);
    sph2d__program_set_float(gl, program, "line_width", line_width(balls));
    sph2d__program_set_float(gl, program, "texel", balls->texel);
    sph2d__program_set_float(gl, program, "margin", MARGIN);
    sph2d__tiles_draw(gl, program, target, KINDS, kind);
}

void sph2d__metaballs_shade(const sph2d__gl *gl, const sph2d__metaballs *balls, const sph2d__target *target,
                            const sph2d_picture *picture, GLuint walls)
{
    const GLuint textures[UNITS] = {[FIELD] = balls->field.texture,
                                    [COLORS] = balls->field.second,
                                    [DEPTH] = balls->depth.texture,
                                    [WALLS] = walls,
                                    [KINDS] = balls->kinds.texture};
    for (int unit = UNITS - 1; unit >= 0; --unit)
        sph2d__texture_bind(gl, unit, textures[unit]);
    sph2d__target_blend(gl, target);
    shade_tiles(gl, balls, target, picture, SPH2D__TILE_TOUCHED);
    if (balls->look != SPH2D_LOOK_GLASS) /* opaque inside */
        gl->Disable(GL_BLEND);
    shade_tiles(gl, balls, target, picture, SPH2D__TILE_INSIDE);
    for (int unit = UNITS - 1; unit >= 0; --unit)
        sph2d__texture_bind(gl, unit, 0); /* the next picture draws into them */
}

void sph2d__metaballs_destroy(const sph2d__gl *gl, sph2d__metaballs *balls)
{
    for (int k = 0; k < 2; ++k) {
        gl->DeleteProgram(balls->balls[k]); /* 0 is ignored */
        gl->DeleteProgram(balls->looks[k]);
    }
    gl->DeleteProgram(balls->depth_program);
    gl->DeleteProgram(balls->limits_program);
    gl->DeleteProgram(balls->kinds_program);
    sph2d__target_destroy(gl, &balls->field);
    sph2d__target_destroy(gl, &balls->sums);
    sph2d__target_destroy(gl, &balls->depth);
    sph2d__target_destroy(gl, &balls->limits);
    sph2d__target_destroy(gl, &balls->kinds);
    sph2d__dots_destroy(gl, &balls->walls);
    sph2d__cover_destroy(&balls->cover);
    *balls = (sph2d__metaballs){0};
}
