/* SPDX-License-Identifier: MIT */
/** @file svg.h
 *  Outlines from drawings in SVG 1.1 or 2: the element with an id, its transforms, and its path as straight pieces. */
#ifndef SPH2D_FILES_SVG_H
#define SPH2D_FILES_SVG_H

#include "files/text.h"
#include "sph2d/scene.h"

/** x' = a x + c y + e, y' = b x + d y + f, as in matrix(a b c d e f). */
typedef struct sph2d__affine {
    double a, b, c, d, e, f;
} sph2d__affine;

/** The map that applies `inner` first. */
static inline sph2d__affine sph2d__affine_of(sph2d__affine outer, sph2d__affine inner)
{
    return (sph2d__affine){
        outer.a * inner.a + outer.c * inner.b,           outer.b * inner.a + outer.d * inner.b,
        outer.a * inner.c + outer.c * inner.d,           outer.b * inner.c + outer.d * inner.d,
        outer.a * inner.e + outer.c * inner.f + outer.e, outer.b * inner.e + outer.d * inner.f + outer.f};
}

/* ---- the element (svg_file.c) ------------------------------------------------------------------------------------ */

/** What a drawing says of one of its elements. */
typedef struct sph2d__svg_element {
    const char *path;    /**< its outline as path data, owned by the pool */
    sph2d__affine place; /**< from its coordinates to those of the page */
    sph2d_vec2 corner;   /**< upper left one of the page, whose y is downwards ... */
    sph2d_vec2 size;     /**< ... and its width and height */
    sph2d__place at;     /**< where it starts; the source has the text */
} sph2d__svg_element;

/** Finds an element of the drawing `source` by its id, or else by Inkscape's label, in the C locale. Errors, with a
 *  message: SPH2D_FORMAT, SPH2D_NOMEM. */
sph2d_status sph2d__svg_find(const sph2d__source *source, const char *id, sph2d__pool *pool,
                             sph2d__svg_element *element, sph2d_report *report);

/** Reports an error at a place of a drawing. Returns SPH2D_FORMAT. */
sph2d_status sph2d__svg_fault(sph2d__place place, sph2d_report *report, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* ---- attributes (svg_shape.c) ------------------------------------------------------------------------------------ */

/** The value of an attribute in expat's list of names and values; NULL if it is not there. */
const char *sph2d__svg_attribute(const char *const *attributes, const char *name);

/** A length such as "3", "3px", "1.5 mm", in user units of 1/96 inch. False for none, and for relative ones. */
bool sph2d__svg_length(const char *text, double *length);

/** The map that the attribute `transform` is. False if it is malformed. */
bool sph2d__svg_transform(const char *text, sph2d__affine *map);

/** Whether elements of this name are outlines. */
bool sph2d__svg_is_outline(const char *name);

/** The path data that an outline is equivalent to; NULL with `*why`, which is NULL when memory is short. */
const char *sph2d__svg_path_of(const char *name, const char *const *attributes, sph2d__pool *pool, const char **why);

/* ---- path data (svg_path.c) -------------------------------------------------------------------------------------- */

/** Reads a number at `*text` and moves behind it. False if there is none. */
bool sph2d__svg_number(const char **text, double *value);
/** Moves behind white space, and a comma in it. */
void sph2d__svg_skip(const char **text);

/** A path as points that straight lines join. */
typedef struct sph2d__svg_points {
    sph2d_vec2 *items; /**< free() it, also after an error */
    size_t count, capacity;
    bool closed;   /**< whether it ends where it begins; the first point is not there twice */
    char why[160]; /**< what is wrong with it */
} sph2d__svg_points;

/** Maps a path, and replaces its curves by chords that are at most `tolerance` from them; points as near to each other are
 *  one. Errors: SPH2D_FORMAT, with `why`, SPH2D_NOMEM. */
sph2d_status sph2d__svg_flatten(const char *path, sph2d__affine map, double tolerance, sph2d__svg_points *points);

#endif
