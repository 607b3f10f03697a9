/* SPDX-License-Identifier: MIT */
/** @file table_kind.h
 *  What tables are about that a scene may name, and how rows become a list of the scene. */
#ifndef SPH2D_FILES_TABLE_KIND_H
#define SPH2D_FILES_TABLE_KIND_H

#include "files/pool.h"
#include "sph2d/io.h"

enum { SPH2D__TABLE_COLUMNS = 7 };

/** Any list of numbers in a scene: sph2d_path, sph2d_pose_path, sph2d_history and the end of sph2d_particles look like
 *  this. */
typedef struct sph2d__list {
    const void *items; /**< doubles */
    size_t count;
} sph2d__list;

/** Where a sph2d__list is. */
typedef struct sph2d__list_slot {
    const char *key;  /**< of the list; NULL: it has none, only the file has */
    size_t at;        /**< offset in the struct */
    size_t width;     /**< numbers of an item */
    size_t choice_at; /**< offset of the int that says which of several lists is there ... */
    int choice;       /**< ... and its value for this one; 0: the list says so itself */
} sph2d__list_slot;

/** A table that becomes part of a scene. */
typedef struct sph2d__table_input {
    const struct sph2d__table_kind *kind;
    const sph2d_table *table;
    sph2d__pool *pool; /**< owns what is made of it */
    sph2d_report *report;
} sph2d__table_input;

/** A file of another kind that becomes part of a scene. */
typedef struct sph2d__file_input {
    const struct sph2d__table_kind *kind;
    const char *path;
    const sph2d_scene *scene; /**< its numbers are read, but not checked */
    sph2d__pool *pool;
    sph2d_report *report;
} sph2d__file_input;

/** A kind of table. It fills a struct of the scene, in which is also the key that names the file. */
typedef struct sph2d__table_kind {
    const char *key; /**< that names the file */
    size_t file;     /**< offset of that name in the struct */
    sph2d_table_column columns[SPH2D__TABLE_COLUMNS];
    size_t column_count;
    const char *lacks_all; /**< message about a file without any of the optional columns; NULL: it may lack them */

    /** Lists of which the table becomes one, up to one of width 0. One with a key takes the place of the file, which is
     *  named no more, and snapshots keep it, so that a run is resumed without the file. */
    sph2d__list_slot lists[6];

    /** Fills the struct. Errors: SPH2D_FORMAT, with a message, and SPH2D_NOMEM. */
    sph2d_status (*take)(const sph2d__table_input *in, void *owner);

    /** Or else reads a file that is no table, and fills the struct. Errors: as `take`, and SPH2D_NOINPUT. */
    sph2d_status (*read)(const sph2d__file_input *in, void *owner);

    /** Of sph2d__table_take: says what is wrong with a row, NULL for nothing ... */
    const char *(*refuse)(const sph2d_table *table, size_t row);
    /** ... and the offset of the numbers, one for each column but the first, in place of columns that the file lacks;
     *  0: these are 0. */
    size_t otherwise;

    /** Sets what else depends on whether the list is from a file; NULL: nothing does. */
    void (*settle)(void *owner);
} sph2d__table_kind;

/** A `take`: each row, as it stands, is an item of the first list. */
sph2d_status sph2d__table_take(const sph2d__table_input *in, void *owner);

/** A `refuse`: the first column, the time, must increase. */
const char *sph2d__table_refuse_time(const sph2d_table *table, size_t row);

/** What of a row is an item. */
typedef struct sph2d__row_form {
    size_t width;                           /**< numbers of an item */
    size_t columns[SPH2D__TABLE_COLUMNS];   /**< from which they are */
    double otherwise[SPH2D__TABLE_COLUMNS]; /**< if the file lacks the column */
    const char *(*refuse)(const sph2d_table *table, size_t row);
} sph2d__row_form;

/** Makes a list, a sph2d__list, of all rows. Errors: SPH2D_FORMAT where there is no row, a number is missing, or a row
 *  is refused; SPH2D_NOMEM. */
sph2d_status sph2d__table_rows(const sph2d__table_input *in, const sph2d__row_form *form, void *list);

/** Reports an error of a row, or of the whole, if it has no such row. Returns SPH2D_FORMAT. */
sph2d_status sph2d__table_fault(const sph2d__table_input *in, size_t row, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
/** The same for a number that is not there. */
sph2d_status sph2d__table_lacks(const sph2d__table_input *in, size_t row, size_t column);

/** What a sph2d_opening prescribes over time, velocity also over place. */
extern const sph2d__table_kind sph2d__history_table;

/** A shape in a drawing, a sph2d_shape: it becomes a polygon, of obstacles also a polyline where the path is open. */
extern const sph2d__table_kind sph2d__closed_drawing, sph2d__drawing;

/** Velocity and pressure over a rectangular grid, a sph2d_grid: rows in any order. Coordinates that differ by less than
 *  1e-9 of the table's width, or height, are the same. */
extern const sph2d__table_kind sph2d__grid_table;

#endif
