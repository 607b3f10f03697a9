/* SPDX-License-Identifier: MIT */
/** @file frame.c
 *  Converts particles to the renderer's picture. */
#include "frame.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "text.h"

frame_style frame_style_of_scene(const sph2d_scene *scene)
{
    return (frame_style){scene->run.frames, scene->name, scene->domain, scene->boundary, scene->spacing};
}

frame_style frame_style_of_snapshot(const sph2d_snapshot *snapshot)
{
    sph2d_snapshot_info info = sph2d_snapshot_get_info(snapshot);
    return (frame_style){info.frames, info.scene_name, info.domain, info.boundary, info.spacing};
}

/* ---- fields ------------------------------------------------------------------------------------------------------ */

/* A field by name; its name is NULL if there is none. */
static sph2d_array find_field(const particle_source *source, sph2d_group group, const char *name)
{
    if (source->snapshot) {
        const sph2d_array *array = sph2d_snapshot_array(source->snapshot, group, name);
        return array ? *array : (sph2d_array){0};
    }
    for (size_t i = 0; i < sph2d_field_count(group); ++i) {
        sph2d_array array = sph2d_field(source->sim, group, i);
        if (strcmp(array.name, name) == 0)
            return array;
    }
    return (sph2d_array){0};
}

/* A field of two contiguous doubles per particle; its name is NULL if it has another type or layout. */
static sph2d_array find_vectors(const particle_source *source, sph2d_group group, const char *name)
{
    sph2d_array array = find_field(source, group, name);
    bool usable = array.name && array.type == SPH2D_F64 && array.components == 2;
    return usable && (array.stride == 1 || array.count <= 1) ? array : (sph2d_array){0};
}

static sph2d_status missing_field(sph2d_report *report, const char *name)
{
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_FIELD, NULL, "no usable field '%s' to draw", name);
    return SPH2D_FORMAT;
}

/* ---- colours ----------------------------------------------------------------------------------------------------- */

bool frame_color_known(const char *name)
{
    if (strcmp(name, "speed") == 0)
        return true;
    for (size_t i = 0; i < sph2d_field_count(SPH2D_GROUP_FLUID); ++i) {
        sph2d_array field = sph2d_field(NULL, SPH2D_GROUP_FLUID, i);
        if (field.components == 1 && strcmp(field.name, name) == 0)
            return true;
    }
    return false;
}

char *frame_colors(char *out, size_t size)
{
    snprintf(out, size, "speed");
    for (size_t i = 0; i < sph2d_field_count(SPH2D_GROUP_FLUID); ++i) {
        sph2d_array field = sph2d_field(NULL, SPH2D_GROUP_FLUID, i);
        size_t used = strlen(out);
        if (field.components == 1)
            snprintf(out + used, size - used, ", %s", field.name);
    }
    return out;
}

sph2d_status frame_style_check(const frame_style *style, sph2d_report *report)
{
    const char *color = style->frames.color;
    if (!color || frame_color_known(color))
        return SPH2D_OK;
    sph2d_diagnostic *d = sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OUT_OF_RANGE, "run.frames.color",
                                           "'%s' is not a field to colour by", color);
    char colors[200];
    sph2d_diagnostic_hint(d, "one of: %s", frame_colors(colors, sizeof colors));
    return SPH2D_SCENE;
}

static bool reserve(double **block, size_t *capacity, size_t count)
{
    if (count <= *capacity)
        return true;
    double *grown = realloc(*block, count * sizeof *grown);
    if (!grown)
        return false;
    *block = grown;
    *capacity = count;
    return true;
}

static void fill_speeds(double *values, const sph2d_array *velocities)
{
    const double *vx = velocities->data[0], *vy = velocities->data[1];
    for (size_t i = 0; i < velocities->count; ++i)
        values[i] = sqrt(vx[i] * vx[i] + vy[i] * vy[i]);
}

static void fill_values(double *values, const sph2d_array *field)
{
    for (size_t i = 0; i < field->count; ++i)
        values[i] = field->type == SPH2D_F64 ? ((const double *)field->data[0])[i * field->stride]
                                             : (double)((const uint64_t *)field->data[0])[i * field->stride];
}

/* Sets the values that colour the points, and the label of the colour bar. */
static sph2d_status make_values(const particle_source *source, const frame_style *style, frame_buffers *buffers,
                                sph2d_picture *picture, sph2d_report *report)
{
    const char *name = style->frames.color;
    bool speed = strcmp(name, "speed") == 0;
    sph2d_array field =
        speed ? find_vectors(source, SPH2D_GROUP_FLUID, "Velocities") : find_field(source, SPH2D_GROUP_FLUID, name);
    if (!field.name || field.count != picture->count || (!speed && field.components != 1))
        return missing_field(report, speed ? "Velocities" : name);
    if (!reserve(&buffers->values, &buffers->capacity, field.count))
        return SPH2D_NOMEM;
    if (speed)
        fill_speeds(buffers->values, &field);
    else
        fill_values(buffers->values, &field);
    char unit[TEXT_SIZE];
    text_unit(unit, field.unit);
    snprintf(buffers->label, sizeof buffers->label, unit[0] != '\0' ? "%s [%s]" : "%s", name, unit);
    picture->values = buffers->values;
    picture->value_min = style->frames.color_range.x;
    picture->value_max = style->frames.color_range.y;
    picture->value_label = buffers->label;
    return SPH2D_OK;
}

/* ---- frames ------------------------------------------------------------------------------------------------------ */

/* The thickness of walls in pictures, of the larger side of the domain; at least a spacing. */
static const double WALL_PART = 0.008;

static double wall_thickness(const frame_style *style)
{
    const sph2d_box *d = &style->domain;
    return fmax(style->spacing, WALL_PART * fmax(d->max.x - d->min.x, d->max.y - d->min.y));
}

/** The domain and its walls. */
static sph2d_box view_of(const frame_style *style)
{
    sph2d_box d = style->domain;
    double beyond = wall_thickness(style);
    return (sph2d_box){{d.min.x - beyond, d.min.y - beyond}, {d.max.x + beyond, d.max.y + beyond}};
}

/* What is in front of walls; behind them are the reservoirs of openings. */
static sph2d_box shown_of(const frame_style *style)
{
    const sph2d_boundary *b = &style->boundary;
    sph2d_box d = style->domain;
    double beyond = 4 * style->spacing;
    return (sph2d_box){{b->left == SPH2D_SIDE_WALL ? d.min.x - beyond : -INFINITY,
                        b->bottom == SPH2D_SIDE_WALL ? d.min.y - beyond : -INFINITY},
                       {b->right == SPH2D_SIDE_WALL ? d.max.x + beyond : INFINITY,
                        b->top == SPH2D_SIDE_WALL ? d.max.y + beyond : INFINITY}};
}

/* Copies the positions within a box, and their values in place; returns their number. */
static size_t keep_within(const sph2d_box *box, const double *x, const double *y, size_t count, double *to_x,
                          double *to_y, double *values)
{
    size_t kept = 0;
    for (size_t i = 0; i < count; ++i) {
        if (x[i] < box->min.x || x[i] > box->max.x || y[i] < box->min.y || y[i] > box->max.y)
            continue;
        to_x[kept] = x[i];
        to_y[kept] = y[i];
        if (values)
            values[kept] = values[i];
        ++kept;
    }
    return kept;
}

/* Leaves out what is behind walls. */
static sph2d_status cut_reservoirs(const frame_style *style, frame_buffers *buffers, sph2d_picture *picture)
{
    const sph2d_box box = shown_of(style);
    if (!reserve(&buffers->places, &buffers->place_capacity, 2 * picture->count))
        return SPH2D_NOMEM;
    double *x = buffers->places, *y = x + picture->count;
    double *values = picture->values ? buffers->values : NULL;
    picture->count = keep_within(&box, picture->x, picture->y, picture->count, x, y, values);
    picture->x = x;
    picture->y = y;
    return SPH2D_OK;
}

static sph2d_status set_outlines(const particle_source *source, sph2d_picture *picture, sph2d_report *report)
{
    sph2d_array corners = find_vectors(source, SPH2D_GROUP_OUTLINE, "Coordinates");
    sph2d_array ids = find_field(source, SPH2D_GROUP_OUTLINE, "OutlineIDs");
    sph2d_array liquid = find_field(source, SPH2D_GROUP_OUTLINE, "LiquidSides");
    if (!corners.name || !ids.name || !liquid.name)
        return missing_field(report, "Outlines");
    picture->outline_count = corners.count;
    picture->outline_x = corners.data[0];
    picture->outline_y = corners.data[1];
    picture->outline_id = ids.data[0];
    picture->outline_liquid = liquid.data[0];
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
    snprintf(buffers->caption, sizeof buffers->caption, "%.80s%st = %.*f s", style->name ? style->name : "",
             style->name ? "   " : "", (int)fmin(fmax(digits, 0), 9), time);
    picture->caption = buffers->caption;
}

sph2d_status frame_make(const particle_source *source, const frame_style *style, frame_buffers *buffers,
                        sph2d_picture *picture, sph2d_report *report)
{
    sph2d_array fluid = find_vectors(source, SPH2D_GROUP_FLUID, "Coordinates");
    if (!fluid.name)
        return missing_field(report, "Coordinates");
    double default_radius = (style->frames.style == SPH2D_STYLE_POINTS ? 0.5 : 2) * style->spacing;
    *picture = (sph2d_picture){
        .view = view_of(style),
        .radius = style->frames.radius > 0 ? style->frames.radius : default_radius,
        .count = fluid.count,
        .x = fluid.data[0],
        .y = fluid.data[1],
        .wall_thickness = wall_thickness(style),
    };
    if (style->frames.caption != SPH2D_SWITCH_OFF)
        set_caption(source, style, buffers, picture);
    sph2d_status status = set_outlines(source, picture, report);
    if (status == SPH2D_OK && style->frames.color)
        status = make_values(source, style, buffers, picture, report);
    return status == SPH2D_OK ? cut_reservoirs(style, buffers, picture) : status;
}

sph2d_status frame_widen_range(const particle_source *source, const frame_style *style, frame_buffers *buffers,
                               sph2d_vec2 *range, sph2d_report *report)
{
    sph2d_picture picture;
    sph2d_status status = frame_make(source, style, buffers, &picture, report);
    for (size_t i = 0; status == SPH2D_OK && picture.values && i < picture.count; ++i) {
        range->x = fmin(range->x, picture.values[i]); /* NaN is left out */
        range->y = fmax(range->y, picture.values[i]);
    }
    return status;
}

void frame_free(frame_buffers *buffers)
{
    free(buffers->values);
    free(buffers->places);
    *buffers = (frame_buffers){0};
}
