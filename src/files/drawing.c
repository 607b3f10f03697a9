/* SPDX-License-Identifier: MIT */
/** @file drawing.c
 *  Shapes of a scene from drawings: the page is as wide as the domain and stands on its bottom, so that several shapes of a
 *  drawing keep their places. */
#include <stdlib.h>
#include <string.h>

#include "files/svg.h"
#include "files/table_kind.h"

enum { MOST_BYTES = 16 << 20 };

/** Chords may be so many spacings from their curve. An outline that is round and 10 spacings across then has 0.3 % less area,
 *  and so much less buoyancy: 2/3 of the distance times its length. */
static const double TOLERANCE = 0.01;

/** From the page, with y downwards, to the domain. */
static sph2d__affine page_to_domain(const sph2d__svg_element *element, const sph2d_box *domain)
{
    const double scale = (domain->max.x - domain->min.x) / element->size.x;
    return (sph2d__affine){scale,
                           0,
                           0,
                           -scale,
                           domain->min.x - scale * element->corner.x,
                           domain->min.y + scale * (element->corner.y + element->size.y)};
}

/** Makes a shape of an element. */
static sph2d_status take_element(const sph2d__file_input *in, const sph2d__svg_element *element, const char *id,
                                 sph2d_shape *shape)
{
    sph2d__svg_points drawn;
    sph2d_status status =
        sph2d__svg_flatten(element->path, sph2d__affine_of(page_to_domain(element, &in->scene->domain), element->place),
                           TOLERANCE * in->scene->spacing, &drawn);
    sph2d_vec2 *items = status == SPH2D_OK ? sph2d__pool_alloc(in->pool, drawn.count, sizeof *items) : NULL;
    if (items) {
        memcpy(items, drawn.items, drawn.count * sizeof *items);
        shape->points = (sph2d_points){items, drawn.count};
        shape->kind = drawn.closed || !in->kind->lists[1].key ? SPH2D_SHAPE_POLYGON : SPH2D_SHAPE_POLYLINE;
    } else if (status == SPH2D_OK) {
        status = SPH2D_NOMEM;
    } else if (status == SPH2D_FORMAT) {
        sph2d__svg_fault(element->at, in->report, "the path of '%.60s': %s", id, drawn.why);
    }
    free(drawn.items);
    return status;
}

/** Reads the shape that `path`, FILE#ID, names. */
static sph2d_status read_drawing(const sph2d__file_input *in, void *owner)
{
    const sph2d_box *domain = &in->scene->domain;
    if (!(in->scene->spacing > 0) || !(domain->max.x > domain->min.x))
        return SPH2D_OK; /* the check refuses such a scene, whatever it has */
    const char *mark = strrchr(in->path, '#'), *id = mark ? mark + 1 : "";
    char *file = sph2d__pool_text(in->pool, in->path, mark ? (size_t)(mark - in->path) : strlen(in->path));
    char *text = NULL;
    size_t length = 0;
    sph2d_status status = file ? sph2d__text_read(file, MOST_BYTES, &text, &length, in->report) : SPH2D_NOMEM;
    const sph2d__source source = {.name = file, .text = text, .length = length, .has_lines = true};
    sph2d__svg_element element;
    if (status == SPH2D_OK)
        status = sph2d__svg_find(&source, id, in->pool, &element, in->report);
    if (status == SPH2D_OK)
        status = take_element(in, &element, id, owner);
    free(text);
    return status;
}

#define POLYGON                                                                                                        \
    {                                                                                                                  \
        "polygon", offsetof(sph2d_shape, points), 2, offsetof(sph2d_shape, kind), SPH2D_SHAPE_POLYGON                  \
    }
#define POLYLINE                                                                                                       \
    {                                                                                                                  \
        "polyline", offsetof(sph2d_shape, points), 2, offsetof(sph2d_shape, kind), SPH2D_SHAPE_POLYLINE                \
    }

const sph2d__table_kind sph2d__closed_drawing = {
    .key = "svg", .file = offsetof(sph2d_shape, svg), .lists = {POLYGON}, .read = read_drawing};

const sph2d__table_kind sph2d__drawing = {
    .key = "svg", .file = offsetof(sph2d_shape, svg), .lists = {POLYGON, POLYLINE}, .read = read_drawing};
