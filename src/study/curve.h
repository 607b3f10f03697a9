/* SPDX-License-Identifier: MIT */
/** @file curve.h
 *  Reduces samples to one number, and two curves to an error. Between samples curves are linear. Undefined results are
 *  NaN. */
#ifndef SPH2D_STUDY_CURVE_H
#define SPH2D_STUDY_CURVE_H

#include "sph2d/study_results.h"

/** The x (number 0) and y (number `column`) of those of `count` rows, each of `width` numbers, that have a value and
 *  are from `from` to `to` (NaN: no limit). The curve is stored in `room`, which holds 2 * count numbers. */
sph2d_study_curve sph2d__curve_select(const double *rows, size_t width, size_t column, size_t count, double from,
                                      double to, double *room);

/** Reduces a curve by `take`, SPH2D_TAKE_DEFAULT being the last sample; `level` and `at` as in a measure. NaN if it is
 *  undefined: no sample, no crossing, fewer than two crossings for a period, `at` outside the samples. */
double sph2d__curve_reduce(sph2d_take take, sph2d_study_curve curve, double level, double at);

/** The curve at x; NaN before its first and after its last point, with a tolerance for rounding errors. */
double sph2d__curve_at(sph2d_study_curve curve, double x);

/** A norm of curve / scale - reference over the points of the reference inside the curve's range; NaN when there are
 *  none. The reference need not ascend; it is shifted by up to `shift` to minimise the norm. */
double sph2d__curve_compare(sph2d_study_curve curve, double scale, sph2d_study_curve reference, sph2d_norm norm,
                            double shift);

/** A norm of numbers; NaN when there is none, or one of them is NaN. */
double sph2d__norm(sph2d_norm norm, const double *values, size_t count);

/** |value - expect|, or |value/expect - 1|. */
double sph2d__error(double value, double expect, bool relative);

/** The order of convergence of two errors; NaN unless they and the spacings are above 0 and the spacings differ. */
double sph2d__order(double error_coarse, double error_fine, double spacing_coarse, double spacing_fine);

/** Makes the reference points of a measure: those of its file, or for a profile the positions at which the finest run
 *  is evaluated; none for other measures. Rows of the file with an empty cell or nan in one of the two columns are
 *  ignored; for a profile x must be from 0 to 1. Errors, each with file, line and column: SPH2D_NOINPUT,
 *  SPH2D_FORMAT, SPH2D_NOMEM. The caller frees *points, which is empty after an error. */
sph2d_status sph2d__reference_make(sph2d_study_curve *points, const sph2d_study_measure *measure, sph2d_report *report);

/** Frees a reference's points and empties them. */
void sph2d__reference_free(sph2d_study_curve *points);

#endif
