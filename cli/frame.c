/* SPDX-License-Identifier: MIT */
/** @file frame.c
 *  Converts particles to the renderer's picture. */
#include "frame.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- what part of the plane a frame shows ------------------------------------------------------------------------ */

/* The thickness of walls in pictures, of the larger side of the domain; at least a spacing. */
static const double WALL_PART = 0.008;

/* The thickness with which walls are drawn [m]. */
static double wall_thickness(const frame_style *style)
{
    const sph2d_box *d = &style->domain;
    return fmax(style->spacing, WALL_PART * fmax(d->max.x - d->min.x, d->max.y - d->min.y));
}

/* The domain and its walls. */
static sph2d_box whole(const frame_style *style)
{
    sph2d_box d = style->domain;
    double beyond = wall_thickness(style);
    return (sph2d_box){{d.min.x - beyond, d.min.y - beyond}, {d.max.x + beyond, d.max.y + beyond}};
}

/* What is in front of walls; behind them are the reservoirs of openings. */
static sph2d_box front_of(const frame_style *style)
{
    const sph2d_boundary *b = &style->boundary;
    sph2d_box d = style->domain;
    double beyond = 4 * style->spacing;
    return (sph2d_box){{b->left == SPH2D_SIDE_WALL ? d.min.x - beyond : -INFINITY,
                        b->bottom == SPH2D_SIDE_WALL ? d.min.y - beyond : -INFINITY},
                       {b->right == SPH2D_SIDE_WALL ? d.max.x + beyond : INFINITY,
                        b->top == SPH2D_SIDE_WALL ? d.max.y + beyond : INFINITY}};
}

/* The number of an obstacle or body, as the outlines have it; SIZE_MAX if the scene has none of that name. */
static size_t number_of(const sph2d_scene *scene, const char *name)
{
    for (size_t k = 0; k < scene->obstacle_count; ++k)
        if (scene->obstacles[k].name && strcmp(scene->obstacles[k].name, name) == 0)
            return k;
    for (size_t k = 0; k < scene->body_count; ++k)
        if (scene->bodies[k].name && strcmp(scene->bodies[k].name, name) == 0)
            return scene->obstacle_count + k;
    return SIZE_MAX;
}

/* The same in the scene that the particles come from, which a snapshot has as a text. */
static sph2d_status find_number(const particle_source *source, const char *name, size_t *number, sph2d_report *report)
{
    sph2d_status status = SPH2D_OK;
    *number = SIZE_MAX;
    if (source->sim) {
        *number = number_of(sph2d_sim_scene(source->sim), name);
    } else {
        const char *text = sph2d_snapshot_get_info(source->snapshot).scene_text;
        sph2d_scene_file *file = NULL;
        sph2d_report ignored = {0}; /* it was checked when it ran */
        if (text)
            status = sph2d_scene_file_parse(text, strlen(text), "scene", NULL, 0, &file, &ignored);
        if (text && status == SPH2D_OK)
            *number = number_of(sph2d_scene_file_scene(file), name);
        sph2d_scene_file_destroy(file);
        sph2d_report_clear(&ignored);
    }
    if (status == SPH2D_NOMEM || *number != SIZE_MAX)
        return status;
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OUT_OF_RANGE, "run.frames.follow",
                     "the scene has no obstacle or body '%.64s' to follow", name);
    return SPH2D_SCENE;
}

/* Moves a view to the mean of a wall's corners, which turns with it. */
static sph2d_status follow(const particle_source *source, const char *name, const sph2d_picture *picture,
                           sph2d_box *view, sph2d_report *report)
{
    size_t number;
    const sph2d_status status = find_number(source, name, &number, report);
    if (status != SPH2D_OK)
        return status;
    const sph2d_array numbers = frame_field(source, SPH2D_GROUP_OUTLINE, "WallIDs");
    if (!numbers.name || numbers.count != picture->outline_count)
        return frame_field_missing(report, "WallIDs");
    const uint64_t *ids = numbers.data[0];
    double x = 0, y = 0, count = 0;
    for (size_t i = 0; i < picture->outline_count; ++i)
        if (ids[i] == number) {
            x += picture->outline_x[i];
            y += picture->outline_y[i];
            ++count;
        }
    if (count == 0)
        return SPH2D_OK;
    const double wide = (view->max.x - view->min.x) / 2, high = (view->max.y - view->min.y) / 2;
    *view = (sph2d_box){{x / count - wide, y / count - high}, {x / count + wide, y / count + high}};
    return SPH2D_OK;
}

/* Sets the view of a picture whose outlines are set. Errors: SPH2D_SCENE for a name to follow that the scene has not,
 * SPH2D_FORMAT if a snapshot has no numbers of walls, SPH2D_NOMEM. */
static sph2d_status find_view(const particle_source *source, const frame_style *style, sph2d_picture *picture,
                              sph2d_report *report)
{
    const sph2d_box *view = &style->frames.view;
    const bool given = view->min.x < view->max.x && view->min.y < view->max.y;
    picture->inside = whole(style);
    picture->view = given ? *view : picture->inside;
    return style->frames.follow ? follow(source, style->frames.follow, picture, &picture->view, report) : SPH2D_OK;
}

/* ---- the picture ------------------------------------------------------------------------------------------------- */

/* Gives a style the colour of a liquid. */
static frame_style with_fluid(frame_style style, const sph2d_fluid *fluid)
{
    style.tinted = sph2d_fluid_color(fluid, &style.tint);
    return style;
}

frame_style frame_style_of_scene(const sph2d_scene *scene)
{
    const frame_style style = {.frames = scene->run.frames,
                               .name = scene->name,
                               .domain = scene->domain,
                               .boundary = scene->boundary,
                               .spacing = scene->spacing};
    return with_fluid(style, &scene->fluid);
}

frame_style frame_style_of_snapshot(const sph2d_snapshot *snapshot)
{
    const sph2d_snapshot_info info = sph2d_snapshot_get_info(snapshot);
    const frame_style style = {.frames = info.frames,
                               .name = info.scene_name,
                               .domain = info.domain,
                               .boundary = info.boundary,
                               .spacing = info.spacing};
    return with_fluid(style, &info.fluid);
}

static sph2d_status check_field(const char *name, const char *path, sph2d_report *report)
{
    if (!name || frame_color_known(name))
        return SPH2D_OK;
    sph2d_diagnostic *d =
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OUT_OF_RANGE, path, "'%s' is not a field to draw", name);
    char colors[200];
    sph2d_diagnostic_hint(d, "one of: %s", frame_colors(colors, sizeof colors));
    return SPH2D_SCENE;
}

sph2d_status frame_style_check(const frame_style *style, sph2d_report *report)
{
    const sph2d_status color = check_field(style->frames.color, "run.frames.color", report);
    const sph2d_status isolines = check_field(style->frames.isolines, "run.frames.isolines", report);
    return color != SPH2D_OK ? color : isolines;
}

/* ---- arrays ------------------------------------------------------------------------------------------------------ */

/* The arrays of a picture, one after the other in a block of all particles each. */
enum { X, Y, VX, VY, VALUES, LEVELS, COLORS, SORTED, ARRAYS };

static double *array_of(const frame_buffers *buffers, int which, size_t count)
{
    return buffers->block + (size_t)which * count;
}

/* Colours are whole numbers of the same size. */
_Static_assert(sizeof(uint64_t) == sizeof(double), "colours are as large as other values");
static uint64_t *colors_of(const frame_buffers *buffers, size_t count)
{
    return (uint64_t *)(void *)array_of(buffers, COLORS, count);
}

static bool reserve(frame_buffers *buffers, size_t count)
{
    if (ARRAYS * count <= buffers->capacity)
        return true;
    double *grown = realloc(buffers->block, ARRAYS * count * sizeof *grown);
    if (!grown)
        return false;
    buffers->block = grown;
    buffers->capacity = ARRAYS * count;
    return true;
}

/* Sets the values that colour the particles, and the label of the colour bar. */
static sph2d_status set_values(const particle_source *source, const frame_style *style, frame_buffers *buffers,
                               sph2d_picture *picture, sph2d_report *report)
{
    double *values = array_of(buffers, VALUES, picture->count);
    picture->values = values;
    picture->value_min = style->frames.color_range.x;
    picture->value_max = style->frames.color_range.y;
    picture->value_label = buffers->label;
    picture->diverging = frame_diverging(style->frames.color);
    return frame_values(source, style->frames.color, picture->count, values, buffers->label, sizeof buffers->label,
                        report);
}

static int compare(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

static bool is_in_view(const sph2d_picture *picture, size_t i)
{
    const sph2d_box *v = &picture->view;
    const double x = picture->x[i], y = picture->y[i];
    return x >= v->min.x && x <= v->max.x && y >= v->min.y && y <= v->max.y;
}

/* Part of the values in view that are beyond either end of their colours: a few at a splash would else leave all others
 * one colour. */
static const double beyond = 0.01;

/* The range of the values in view, of either sign symmetric about 0; `sorted` has room for them. */
static sph2d_vec2 range_in_view(const sph2d_picture *picture, bool full, double *sorted)
{
    size_t count = 0;
    for (size_t i = 0; i < picture->count; ++i)
        if (isfinite(picture->values[i]) && is_in_view(picture, i))
            sorted[count++] = picture->diverging ? fabs(picture->values[i]) : picture->values[i];
    if (count == 0)
        return (sph2d_vec2){INFINITY, -INFINITY};
    qsort(sorted, count, sizeof *sorted, compare);
    const size_t last = count - 1, out = full ? 0 : (size_t)(beyond * (double)last + 0.5);
    sph2d_vec2 range = {sorted[out], sorted[last - out]};
    if (!(range.x < range.y)) /* nearly all are the same */
        range = (sph2d_vec2){sorted[0], sorted[last]};
    return picture->diverging ? (sph2d_vec2){0 - range.y, range.y} : range;
}

/* Sets the velocities for arrows and streamlines. */
static sph2d_status set_velocities(const particle_source *source, const frame_style *style, frame_buffers *buffers,
                                   sph2d_picture *picture, sph2d_report *report)
{
    const sph2d_array velocities = frame_vectors(source, SPH2D_GROUP_FLUID, "Velocities");
    if (!velocities.name || velocities.count != picture->count)
        return frame_field_missing(report, "Velocities");
    const size_t bytes = picture->count * sizeof(double);
    if (bytes > 0) {
        memcpy(array_of(buffers, VX, picture->count), velocities.data[0], bytes);
        memcpy(array_of(buffers, VY, picture->count), velocities.data[1], bytes);
    }
    const double *vx = array_of(buffers, VX, picture->count), *vy = array_of(buffers, VY, picture->count);
    if (style->frames.arrows == SPH2D_SWITCH_ON) {
        picture->vx = vx;
        picture->vy = vy;
    }
    if (style->frames.streamlines == SPH2D_SWITCH_ON) {
        picture->stream_vx = vx;
        picture->stream_vy = vy;
    }
    picture->arrow_spacing = style->frames.arrow_spacing;
    picture->arrow_speed = style->frames.arrow_speed;
    picture->streamline_spacing = style->frames.streamline_spacing;
    return SPH2D_OK;
}

/* Sets the values of isolines, and what the caption calls them. */
static sph2d_status set_isolines(const particle_source *source, const frame_style *style, frame_buffers *buffers,
                                 sph2d_picture *picture, sph2d_report *report)
{
    double *values = array_of(buffers, LEVELS, picture->count);
    picture->level_values = values;
    picture->level_step = style->frames.isoline_step;
    picture->level_label = buffers->level_label;
    return frame_values(source, style->frames.isolines, picture->count, values, buffers->level_label,
                        sizeof buffers->level_label, report);
}

/* Sets the particles' colours, if they have some. */
static void set_colors(const particle_source *source, frame_buffers *buffers, sph2d_picture *picture)
{
    const sph2d_array *array =
        source->snapshot ? sph2d_snapshot_array(source->snapshot, SPH2D_GROUP_FLUID, "Colors") : NULL;
    const bool usable = array && array->type == SPH2D_U64 && array->stride == 1 && array->count == picture->count;
    const uint64_t *colors = source->sim ? sph2d_sim_colors(source->sim) : usable ? array->data[0] : NULL;
    if (!colors || picture->count == 0)
        return;
    memcpy(colors_of(buffers, picture->count), colors, picture->count * sizeof *colors);
    picture->colors = colors_of(buffers, picture->count);
}

/* Copies the particles in front of walls alone; in their place, but for the positions. */
static void cut_reservoirs(const frame_style *style, frame_buffers *buffers, sph2d_picture *picture)
{
    const sph2d_box box = front_of(style);
    const double *x = picture->x, *y = picture->y;
    double *arrays[ARRAYS];
    uint64_t *colors = colors_of(buffers, picture->count);
    for (int k = 0; k < ARRAYS; ++k)
        arrays[k] = array_of(buffers, k, picture->count);
    size_t kept = 0;
    for (size_t i = 0; i < picture->count; ++i) {
        if (x[i] < box.min.x || x[i] > box.max.x || y[i] < box.min.y || y[i] > box.max.y)
            continue;
        arrays[X][kept] = x[i];
        arrays[Y][kept] = y[i];
        if (picture->vx || picture->stream_vx) {
            arrays[VX][kept] = arrays[VX][i];
            arrays[VY][kept] = arrays[VY][i];
        }
        if (picture->values)
            arrays[VALUES][kept] = arrays[VALUES][i];
        if (picture->level_values)
            arrays[LEVELS][kept] = arrays[LEVELS][i];
        if (picture->colors)
            colors[kept] = colors[i];
        ++kept;
    }
    picture->count = kept;
    picture->x = arrays[X];
    picture->y = arrays[Y];
}

/* ---- frames ------------------------------------------------------------------------------------------------------ */

bool frame_reserve_corners(frame_buffers *buffers, sph2d_picture *picture, size_t more)
{
    const size_t most = picture->outline_count + more;
    void *const arrays[] = {&buffers->outline_x, &buffers->outline_y, &buffers->outline_id, &buffers->outline_liquid};
    _Static_assert(sizeof(double) == sizeof(uint64_t), "the arrays have one size");
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays && most > buffers->corners; ++k) {
        void *grown = realloc(*(void **)arrays[k], most * sizeof(double));
        if (!grown)
            return false;
        *(void **)arrays[k] = grown;
    }
    buffers->corners = most > buffers->corners ? most : buffers->corners;
    picture->outline_x = buffers->outline_x;
    picture->outline_y = buffers->outline_y;
    picture->outline_id = buffers->outline_id;
    picture->outline_liquid = buffers->outline_liquid;
    return true;
}

static sph2d_status set_outlines(const particle_source *source, frame_buffers *buffers, sph2d_picture *picture,
                                 sph2d_report *report)
{
    sph2d_array corners = frame_vectors(source, SPH2D_GROUP_OUTLINE, "Coordinates");
    sph2d_array ids = frame_field(source, SPH2D_GROUP_OUTLINE, "OutlineIDs");
    sph2d_array liquid = frame_field(source, SPH2D_GROUP_OUTLINE, "LiquidSides");
    if (!corners.name || !ids.name || !liquid.name)
        return frame_field_missing(report, "Outlines");
    if (!frame_reserve_corners(buffers, picture, corners.count))
        return SPH2D_NOMEM;
    picture->outline_count = corners.count;
    const size_t bytes = corners.count * sizeof(double);
    if (bytes > 0) {
        memcpy(buffers->outline_x, corners.data[0], bytes);
        memcpy(buffers->outline_y, corners.data[1], bytes);
        memcpy(buffers->outline_id, ids.data[0], bytes);
        memcpy(buffers->outline_liquid, liquid.data[0], bytes);
    }
    return SPH2D_OK;
}

/* "dam_break   t = 0.250 s", with as many decimals as time in which sound crosses some spacings. */
static void set_caption(const particle_source *source, const frame_style *style, frame_buffers *buffers,
                        sph2d_picture *picture)
{
    double time, speed;
    if (source->snapshot) {
        sph2d_snapshot_info info = sph2d_snapshot_get_info(source->snapshot);
        time = info.time;
        speed = info.sound_speed;
    } else {
        time = sph2d_sim_time(source->sim);
        speed = sph2d_sim_plan(source->sim)->sound_speed;
    }
    double digits = speed > 0 ? ceil(-log10(10 * style->spacing / speed)) : 3;
    snprintf(buffers->caption, sizeof buffers->caption, "%.120s%st = %.*f s", style->name ? style->name : "",
             style->name ? "   " : "", (int)fmin(fmax(digits, 0), 9), time);
    picture->caption = buffers->caption;
}

/* The arrays that the style asks for. */
static sph2d_status set_arrays(const particle_source *source, const frame_style *style, frame_buffers *buffers,
                               sph2d_picture *picture, sph2d_report *report)
{
    if (!reserve(buffers, picture->count))
        return SPH2D_NOMEM;
    sph2d_status status = SPH2D_OK;
    if (style->frames.color)
        status = set_values(source, style, buffers, picture, report);
    else
        set_colors(source, buffers, picture);
    if (status == SPH2D_OK && (style->frames.arrows == SPH2D_SWITCH_ON || style->frames.streamlines == SPH2D_SWITCH_ON))
        status = set_velocities(source, style, buffers, picture, report);
    if (status == SPH2D_OK && style->frames.isolines)
        status = set_isolines(source, style, buffers, picture, report);
    if (status != SPH2D_OK)
        return status;
    double *sorted = array_of(buffers, SORTED, picture->count);
    cut_reservoirs(style, buffers, picture);
    if (picture->values && picture->value_min == 0 && picture->value_max == 0) {
        buffers->range = range_in_view(picture, style->full_range, sorted);
        if (buffers->range.x < buffers->range.y) { /* else the renderer chooses one about the value that all have */
            picture->value_min = buffers->range.x;
            picture->value_max = buffers->range.y;
        }
    }
    return SPH2D_OK;
}

sph2d_status frame_make(const particle_source *source, const frame_style *style, frame_buffers *buffers,
                        sph2d_picture *picture, sph2d_report *report)
{
    sph2d_array fluid = frame_vectors(source, SPH2D_GROUP_FLUID, "Coordinates");
    if (!fluid.name)
        return frame_field_missing(report, "Coordinates");
    double default_radius = (style->frames.style == SPH2D_STYLE_POINTS ? 0.5 : 2) * style->spacing;
    *picture = (sph2d_picture){
        .radius = style->frames.radius > 0 ? style->frames.radius : default_radius,
        .count = fluid.count,
        .x = fluid.data[0],
        .y = fluid.data[1],
        .spacing = style->spacing,
        .wall_thickness = wall_thickness(style),
        .tinted = style->tinted,
        .tint = style->tint,
    };
    if (style->frames.caption != SPH2D_SWITCH_OFF)
        set_caption(source, style, buffers, picture);
    sph2d_status status = set_outlines(source, buffers, picture, report);
    if (status == SPH2D_OK && !frame_set_paths(source, style, buffers, picture))
        status = SPH2D_NOMEM;
    if (status == SPH2D_OK)
        status = find_view(source, style, picture, report);
    return status == SPH2D_OK ? set_arrays(source, style, buffers, picture, report) : status;
}

sph2d_status frame_widen_range(const particle_source *source, const frame_style *style, frame_buffers *buffers,
                               sph2d_vec2 *range, sph2d_report *report)
{
    sph2d_picture picture;
    buffers->range = (sph2d_vec2){INFINITY, -INFINITY};
    const sph2d_status status = frame_make(source, style, buffers, &picture, report);
    if (status != SPH2D_OK)
        return status;
    range->x = fmin(range->x, buffers->range.x);
    range->y = fmax(range->y, buffers->range.y);
    return SPH2D_OK;
}

void frame_free(frame_buffers *buffers)
{
    free(buffers->block);
    free(buffers->outline_x);
    free(buffers->outline_y);
    free(buffers->outline_id);
    free(buffers->outline_liquid);
    free(buffers->path_x);
    free(buffers->path_y);
    free(buffers->path_id);
    *buffers = (frame_buffers){0};
}
