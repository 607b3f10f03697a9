/* SPDX-License-Identifier: MIT */
/** @file frame_view.c
 *  What part of the plane a frame shows. */
#include "frame_view.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* The thickness of walls in pictures, of the larger side of the domain; at least a spacing. */
static const double WALL_PART = 0.008;

double frame_wall_thickness(const frame_style *style)
{
    const sph2d_box *d = &style->domain;
    return fmax(style->spacing, WALL_PART * fmax(d->max.x - d->min.x, d->max.y - d->min.y));
}

/* The domain and its walls. */
static sph2d_box whole(const frame_style *style)
{
    sph2d_box d = style->domain;
    double beyond = frame_wall_thickness(style);
    return (sph2d_box){{d.min.x - beyond, d.min.y - beyond}, {d.max.x + beyond, d.max.y + beyond}};
}

sph2d_box frame_front(const frame_style *style)
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

sph2d_status frame_find_view(const particle_source *source, const frame_style *style, sph2d_picture *picture,
                             sph2d_report *report)
{
    const sph2d_box *view = &style->frames.view;
    const bool given = view->min.x < view->max.x && view->min.y < view->max.y;
    picture->inside = whole(style);
    picture->view = given ? *view : picture->inside;
    return style->frames.follow ? follow(source, style->frames.follow, picture, &picture->view, report) : SPH2D_OK;
}
