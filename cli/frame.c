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
    return (frame_style){scene->run.frames, scene->domain, scene->boundary, scene->spacing};
}

frame_style frame_style_of_snapshot(const sph2d_snapshot *snapshot)
{
    sph2d_snapshot_info info = sph2d_snapshot_get_info(snapshot);
    return (frame_style){info.frames, info.domain, info.boundary, info.spacing};
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
    if (style->frames.style != SPH2D_STYLE_POINTS || !color || frame_color_known(color))
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

/** The domain and a spacing around it, so that the first layer of every wall is in the image. */
static sph2d_box view_of(const frame_style *style)
{
    sph2d_box d = style->domain;
    double dx = style->spacing;
    return (sph2d_box){{d.min.x - dx, d.min.y - dx}, {d.max.x + dx, d.max.y + dx}};
}

/* Layers of walls that are drawn, and a spacing more: behind them are the reservoirs of openings. */
static const double BEHIND_WALLS = 4;

static sph2d_box shown_of(const frame_style *style)
{
    const sph2d_boundary *b = &style->boundary;
    sph2d_box d = style->domain;
    double beyond = BEHIND_WALLS * style->spacing;
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
    const size_t fluid = picture->count, walls = picture->wall_count;
    if (!reserve(&buffers->places, &buffers->place_capacity, 2 * (fluid + walls)))
        return SPH2D_NOMEM;
    double *x = buffers->places, *y = x + fluid, *wall_x = y + fluid, *wall_y = wall_x + walls;
    double *values = picture->values ? buffers->values : NULL;
    picture->count = keep_within(&box, picture->x, picture->y, fluid, x, y, values);
    picture->wall_count = keep_within(&box, picture->wall_x, picture->wall_y, walls, wall_x, wall_y, NULL);
    picture->x = x;
    picture->y = y;
    picture->wall_x = wall_x;
    picture->wall_y = wall_y;
    return SPH2D_OK;
}

sph2d_status frame_make(const particle_source *source, const frame_style *style, frame_buffers *buffers,
                        sph2d_picture *picture, sph2d_report *report)
{
    sph2d_array fluid = find_vectors(source, SPH2D_GROUP_FLUID, "Coordinates");
    sph2d_array walls = find_vectors(source, SPH2D_GROUP_WALL, "Coordinates");
    if (!fluid.name || !walls.name)
        return missing_field(report, "Coordinates");
    bool points = style->frames.style == SPH2D_STYLE_POINTS;
    double default_radius = (points ? 0.5 : 2) * style->spacing;
    *picture = (sph2d_picture){
        .view = view_of(style),
        .radius = style->frames.radius > 0 ? style->frames.radius : default_radius,
        .count = fluid.count,
        .x = fluid.data[0],
        .y = fluid.data[1],
        .wall_count = walls.count,
        .wall_x = walls.data[0],
        .wall_y = walls.data[1],
        .wall_radius = 0.5 * style->spacing,
    };
    sph2d_status status =
        points && style->frames.color ? make_values(source, style, buffers, picture, report) : SPH2D_OK;
    return status == SPH2D_OK ? cut_reservoirs(style, buffers, picture) : status;
}

void frame_free(frame_buffers *buffers)
{
    free(buffers->values);
    free(buffers->places);
    *buffers = (frame_buffers){0};
}
