/* SPDX-License-Identifier: MIT */
/** @file parts.h
 *  Internal interfaces of the library. */
#ifndef SPH2D_STUDY_PARTS_H
#define SPH2D_STUDY_PARTS_H

#include "sph2d/study_results.h"

/** Whether a row has finished, so that it has values. */
static inline bool sph2d__row_counts(const sph2d_study_row *row)
{
    return row->there && row->record.end == SPH2D_STUDY_FINISHED;
}

/* ---- records (record.c, measure.c) ------------------------------------------------------------------------------- */

/** Adds an empty series of `columns` values per row with a capacity of `room` rows; NULL when memory is short. Pointers
 *  to other series become invalid. */
sph2d_study_series *sph2d__record_add(sph2d_study_record *record, size_t columns, size_t room);

/** Adds a row to a series; false when memory is short. */
bool sph2d__series_add(sph2d_study_series *series, double x, const double *values);

/** Whether a record has everything that the study measures. */
bool sph2d__record_serves(const sph2d_study_results *results, const sph2d_study_record *record);

/* ---- scenes (row_scene.c, row_check.c) --------------------------------------------------------------------------- */

/** Sets the positions of the diagnostics from number `first` on: of key paths in the scene's file (NULL: none), of the
 *  study's overrides in the study's file. */
void sph2d__row_locate(const sph2d_study_results *results, const sph2d_study_run *run, const sph2d_scene_file *scene,
                       sph2d_report *report, size_t first);

/** A scene as text; NULL when memory is short. The caller frees it. */
char *sph2d__scene_text(const sph2d_scene *scene);

/** Reports errors in the scene of a run, and measures of things that it does not have. With `place` the particles are
 *  placed too. Errors: as sph2d_study_run_scene() and sph2d_sim_create(). */
sph2d_status sph2d__row_check(const sph2d_study_results *results, const sph2d_study_run *run, bool place,
                              sph2d_report *report);

/** Finds the column `name` in a probe's line of headings, which have units; false when it is not there. */
bool sph2d__column_find(const char *headings, const char *name, size_t *column);

/* ---- rows (settings.c, refine.c, results.c) ---------------------------------------------------------------------- */

/** The final value that a row sets a key to; NULL if it does not set it. */
const char *sph2d__setting(const sph2d_study_run *run, const char *path);

/** Whether two rows set the same keys, except `but`, to the same values; with `any` to any values. */
bool sph2d__same_settings(const sph2d_study_run *a, const sph2d_study_run *b, const char *but, bool any);

/** A row with the overrides of `base` and those of `step` on top, and space for the values of `measures`. The row owns
 *  its lists and its name, also when memory is short: then false. */
bool sph2d__refine_row(sph2d_study_row *row, const sph2d_study_run *base, const sph2d_study_run *step, size_t measures);

/** Frees what a row owns. */
void sph2d__row_free(sph2d_study_row *row);

/* ---- results (front.c, order.c); time is CPU time of stepping, which other jobs affect least --------------------- */

/** The measure that ranks rows: `judge` of the study, else the first that has an error; measure_count when none has. */
size_t sph2d__judge(const sph2d_study *study);

/** Marks the rows on the Pareto front: no other row has a smaller error in less time, or in the same. */
void sph2d__front_mark(sph2d_study_results *results);

/** Whether a row is on the Pareto front of those with spacings from `from` to `to`. */
bool sph2d__front_holds(const sph2d_study_results *results, const sph2d_study_row *row, double from, double to);

/** The finest row: the last of those that finished with the smallest spacing; NULL for none. */
const sph2d_study_row *sph2d__finest(const sph2d_study_results *results);

/** Sets the orders of all rows, each from the nearest coarser row before it with the same settings; among individually
 *  listed rows otherwise from the nearest that sets the same keys. */
void sph2d__order_all(sph2d_study_results *results);

#endif
