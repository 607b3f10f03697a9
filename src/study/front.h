/* SPDX-License-Identifier: MIT */
/** @file front.h
 *  Error against time: which rows are worth their time. Time is CPU time of stepping, which other jobs disturb least. */
#ifndef SPH2D_STUDY_FRONT_H
#define SPH2D_STUDY_FRONT_H

#include "sph2d/study_results.h"

/** Whether a row came to its end, so that it has numbers. */
static inline bool sph2d__row_counts(const sph2d_study_row *row)
{
    return row->there && row->record.end == SPH2D_STUDY_FINISHED;
}

/** The measure that rows are judged by: `judge` of the study, else the first that has an error; measure_count when none
 *  has. */
size_t sph2d__judge(const sph2d_study *study);

/** Marks the rows on the front: no other row has a smaller error in less time, or in the same. */
void sph2d__front_mark(sph2d_study_results *results);

/** Whether a row is on the front of those with at least the spacing `from` and at most `to`. */
bool sph2d__front_holds(const sph2d_study_results *results, const sph2d_study_row *row, double from, double to);

/** The row that `finest` means: of those that finished with the smallest spacing the last one; NULL for none. */
const sph2d_study_row *sph2d__finest(const sph2d_study_results *results);

#endif
