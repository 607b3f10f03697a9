/* SPDX-License-Identifier: MIT */
/** @file study_front.h
 *  Error against time: which rows are worth their time, and which is the cheapest for a wanted error. Time is CPU time
 *  of stepping, which other jobs disturb least. */
#ifndef SPH2D_CLI_STUDY_FRONT_H
#define SPH2D_CLI_STUDY_FRONT_H

#include "study.h"

/** The measure that rows are judged by: `judge` of the study, else the first that has an error; measure_count when none
 *  has. */
size_t study_front_judge(const sph2d_study *study);

/** The error that a row is judged by; NaN when it has none. */
double study_front_error(const cli_study *s, const study_row *row);

/** Marks the rows on the front: no other row has a smaller error in less time, or in the same. */
void study_front_mark(cli_study *s);

/** The row with the least time of those whose error is at most `target`, and the row with the smallest error; NULL when
 *  there is none. */
const study_row *study_front_cheapest(const cli_study *s, double target);
const study_row *study_front_best(const cli_study *s);

/** Whether a row is on the front of those with at least the spacing `from` and at most `to`. */
bool study_front_holds(const cli_study *s, const study_row *row, double from, double to);

/** The row that `finest` means: of those that finished with the smallest spacing the last one; row_count for none. */
size_t study_finest(const cli_study *s);

#endif
