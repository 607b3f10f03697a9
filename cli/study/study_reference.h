/* SPDX-License-Identifier: MIT */
/** @file study_reference.h
 *  Two columns of a CSV file: what a measure is compared with. */
#ifndef SPH2D_CLI_STUDY_REFERENCE_H
#define SPH2D_CLI_STUDY_REFERENCE_H

#include "study_reduce.h"

/** Points of a reference. Start it with {0}. */
typedef struct study_points {
    double *x, *y; /**< owned; in the order of the file */
    size_t count;
} study_points;

/** Reads the points that `reference` names, which must be empty. Lines that start with # and empty ones do not count,
 *  the first other line names the columns, and a row with an empty cell or nan in one of the two is no point. With
 *  `along` x must lie from 0 to 1. Errors, each with file, line and column: SPH2D_NOINPUT, SPH2D_FORMAT, SPH2D_NOMEM.
 *  What was read is the caller's to free, after a failure too. */
sph2d_status study_points_read(study_points *points, const sph2d_study_reference *reference, bool along,
                               sph2d_report *report);

/** The points as a curve, borrowed. */
study_curve study_points_curve(const study_points *points);

void study_points_free(study_points *points);

#endif
