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

/** Adds the rows of refinement `step`: the rows on the front of those with the smallest spacing so far, each with the
 *  step's overrides on top. Errors: SPH2D_NOMEM. */
sph2d_status study_front_refine(cli_study *s, size_t step);

/** What the study's `along` key is in a row: its spacing, or the number that it sets; NaN where it sets none. */
double study_along(const cli_study *s, const study_row *row);

/** Whether two rows differ in nothing but the `along` key. */
bool study_belong(const cli_study *s, const study_row *a, const study_row *b);

/** The order that the errors of rows show which belong to `row`: the slope of log(error) over log(along), by least
 *  squares. *count is how many rows that are; NaN below two values. */
double study_front_order(const cli_study *s, const study_row *row, size_t *count);

/** "For an error of 1 % (speed L1) the cheapest is 'coarse': 0.14 % in 0.31 CPU s.", or what is to be said instead when
 *  no row is good enough; "" when none has an error. Returns `out`, cut at `size`. */
char *study_verdict(const cli_study *s, char *out, size_t size);

#endif
