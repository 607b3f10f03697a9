/* SPDX-License-Identifier: MIT */
/** @file curve.h
 *  Samples into one number, and two curves into an error. Between samples a curve is a straight line. What it cannot
 *  give is NaN. */
#ifndef SPH2D_STUDY_CURVE_H
#define SPH2D_STUDY_CURVE_H

#include "sph2d/study_results.h"

/** The x (number 0) and y (number `column`) of those of `count` rows, each of `width` numbers, that have a value and
 *  lie from `from` to `to` (NaN: no limit). The curve is made in `room`, which holds 2 * count numbers. */
sph2d_study_curve sph2d__curve_select(const double *rows, size_t width, size_t column, size_t count, double from,
                                      double to, double *room);

/** What `take` says of a curve, SPH2D_TAKE_DEFAULT being the last sample; `level` and `at` as in a measure. NaN where
 *  there is none: no sample, no crossing, fewer than two crossings for a period, `at` beyond the samples. */
double sph2d__curve_reduce(sph2d_take take, sph2d_study_curve curve, double level, double at);

/** The curve at x; NaN before its first and after its last point. A hair's breadth outside counts as inside. */
double sph2d__curve_at(sph2d_study_curve curve, double x);

/** A norm of curve / scale - reference over those points of the reference that lie inside the curve; NaN when none
 *  does. The reference need not ascend, and may be moved by up to `shift` to where the norm is least. */
double sph2d__curve_compare(sph2d_study_curve curve, double scale, sph2d_study_curve reference, sph2d_norm norm,
                            double shift);

/** A norm of numbers; NaN when there is none, or one of them is NaN. */
double sph2d__norm(sph2d_norm norm, const double *values, size_t count);

/** |value - expect|, or |value/expect - 1|. */
double sph2d__error(double value, double expect, bool relative);

/** The order that two errors show; NaN unless they and the spacings are above 0 and the spacings differ. */
double sph2d__order(double error_coarse, double error_fine, double spacing_coarse, double spacing_fine);

/** Makes the points that a measure is compared with: those of the file that it names, or for a profile the places where
 *  that of the finest run is; none for other measures. A row of the file with an empty cell or nan in one of the two
 *  columns is no point; for a profile x must lie from 0 to 1. Errors, each with file, line and column: SPH2D_NOINPUT,
 *  SPH2D_FORMAT, SPH2D_NOMEM. The caller frees *points, which is empty after an error. */
sph2d_status sph2d__reference_make(sph2d_study_curve *points, const sph2d_study_measure *measure, sph2d_report *report);

/** Frees a reference's points and empties them. */
void sph2d__reference_free(sph2d_study_curve *points);

#endif
