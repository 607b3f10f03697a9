/* SPDX-License-Identifier: MIT */
/** @file frame_field.c
 *  Fields by name, and the quantities that pictures show. */
#include "frame_field.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "text.h"

/* What is computed from velocities. */
static const char speed[] = "speed", vorticity[] = "vorticity";

sph2d_array frame_field(const particle_source *source, sph2d_group group, const char *name)
{
    if (source->snapshot) {
        const sph2d_array *array = sph2d_snapshot_array(source->snapshot, group, name);
        return array ? *array : (sph2d_array){0};
    }
    for (size_t i = 0; i < sph2d_field_count(group); ++i)
        if (strcmp(sph2d_field(NULL, group, i).name, name) == 0)
            return sph2d_field(source->sim, group, i); /* the only one that a device has to hand over */
    return (sph2d_array){0};
}

sph2d_array frame_vectors(const particle_source *source, sph2d_group group, const char *name)
{
    sph2d_array array = frame_field(source, group, name);
    bool usable = array.name && array.type == SPH2D_F64 && array.components == 2;
    return usable && (array.stride == 1 || array.count <= 1) ? array : (sph2d_array){0};
}

sph2d_status frame_field_missing(sph2d_report *report, const char *name)
{
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_FIELD, NULL, "no usable field '%s' to draw", name);
    return SPH2D_FORMAT;
}

bool frame_diverging(const char *name)
{
    return strcmp(name, vorticity) == 0;
}

bool frame_color_known(const char *name)
{
    if (strcmp(name, speed) == 0 || strcmp(name, vorticity) == 0)
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
    snprintf(out, size, "%s, %s", speed, vorticity);
    for (size_t i = 0; i < sph2d_field_count(SPH2D_GROUP_FLUID); ++i) {
        sph2d_array field = sph2d_field(NULL, SPH2D_GROUP_FLUID, i);
        size_t used = strlen(out);
        if (field.components == 1)
            snprintf(out + used, size - used, ", %s", field.name);
    }
    return out;
}

static void fill_speeds(double *values, const sph2d_array *velocities)
{
    const double *vx = velocities->data[0], *vy = velocities->data[1];
    for (size_t i = 0; i < velocities->count; ++i)
        values[i] = sqrt(vx[i] * vx[i] + vy[i] * vy[i]);
}

static double spacing_of(const particle_source *source)
{
    return source->snapshot ? sph2d_snapshot_get_info(source->snapshot).spacing : sph2d_sim_scene(source->sim)->spacing;
}

static sph2d_status fill_vorticities(double *values, const particle_source *source, const sph2d_array *velocities,
                                     sph2d_report *report)
{
    const sph2d_array places = frame_vectors(source, SPH2D_GROUP_FLUID, "Coordinates");
    if (!places.name || places.count != velocities->count)
        return frame_field_missing(report, "Coordinates");
    return sph2d_vorticity(places.count, places.data[0], places.data[1], velocities->data[0], velocities->data[1],
                           spacing_of(source), values, report);
}

static void fill_values(double *values, const sph2d_array *field)
{
    for (size_t i = 0; i < field->count; ++i)
        values[i] = field->type == SPH2D_F64 ? ((const double *)field->data[0])[i * field->stride]
                                             : (double)((const uint64_t *)field->data[0])[i * field->stride];
}

sph2d_status frame_values(const particle_source *source, const char *name, size_t count, double *values, char *label,
                          size_t size, sph2d_report *report)
{
    const bool is_speed = strcmp(name, speed) == 0, is_vorticity = strcmp(name, vorticity) == 0;
    const bool derived = is_speed || is_vorticity;
    const sph2d_array field =
        derived ? frame_vectors(source, SPH2D_GROUP_FLUID, "Velocities") : frame_field(source, SPH2D_GROUP_FLUID, name);
    if (!field.name || field.count != count || (!derived && field.components != 1))
        return frame_field_missing(report, derived ? "Velocities" : name);
    char unit[TEXT_SIZE] = "1/s";
    if (!is_vorticity)
        text_unit(unit, field.unit);
    snprintf(label, size, unit[0] != '\0' ? "%s [%s]" : "%s", name, unit);
    if (is_vorticity)
        return fill_vorticities(values, source, &field, report);
    if (is_speed)
        fill_speeds(values, &field);
    else
        fill_values(values, &field);
    return SPH2D_OK;
}
