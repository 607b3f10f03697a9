/* SPDX-License-Identifier: MIT */
/** @file study_reduce.h
 *  A series of samples into one number. Between samples a series is a straight line. What a series cannot give is NaN.
 */
#ifndef SPH2D_CLI_STUDY_REDUCE_H
#define SPH2D_CLI_STUDY_REDUCE_H

#include <stddef.h>

#include <sph2d/study.h>

/** Points of a curve, x ascending; every number is finite. The arrays are borrowed. */
typedef struct study_curve {
    const double *x, *y;
    size_t count;
} study_curve;

/** Copies the samples that have a value and lie from `from` to `to` (NaN: no limit) into `x_out` and `y_out`, which
 *  have room for `count`. `y` is every `stride`-th number. */
study_curve study_select(const double *x, const double *y, size_t stride, size_t count, double from, double to,
                         double *x_out, double *y_out);

/** What `take` says of a curve, SPH2D_TAKE_DEFAULT being the last sample; `level` and `at` as in a measure. NaN where
 *  there is none: no sample, no crossing, fewer than two crossings for a period, `at` beyond the samples. */
double study_reduce(sph2d_take take, study_curve curve, double level, double at);

/** The curve at x; NaN before its first and after its last point. A hair's breadth outside counts as inside. */
double study_at(study_curve curve, double x);

/** A norm of curve / scale - reference over those points of the reference that lie inside the curve; NaN when none
 *  does. The reference need not ascend, and may be moved by up to `shift` to where the norm is least. */
double study_compare(study_curve curve, double scale, study_curve reference, sph2d_norm norm, double shift);

/** The same norm of differences, `count` values; NaN when there is none, or when one is NaN. */
double study_norm(sph2d_norm norm, const double *values, size_t count);

/** |value - expect| or, relative, |value/expect - 1|. */
double study_error(double value, double expect, bool relative);

/** The observed order of convergence from a coarse to a fine spacing; NaN unless both errors and spacings are above 0
 *  and the spacings differ. */
double study_order(double error_coarse, double error_fine, double spacing_coarse, double spacing_fine);

#endif
