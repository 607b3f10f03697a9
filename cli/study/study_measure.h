/* SPDX-License-Identifier: MIT */
/** @file study_measure.h
 *  From records to the numbers of the table. */
#ifndef SPH2D_CLI_STUDY_MEASURE_H
#define SPH2D_CLI_STUDY_MEASURE_H

#include "study.h"

/** How many places along its line a profile is taken at, and where: 0 to 1 from end to end. */
size_t study_measure_places(const cli_study *s, size_t measure);
double study_measure_place(const cli_study *s, size_t measure, size_t place);

/** Whether a record holds all that the study measures now. */
bool study_measure_possible(const cli_study *s, const study_record *record);

/** Whether the error of a measure is that of a whole curve, so that it has no value of its own. */
bool study_measure_is_curve(const sph2d_study_measure *measure);

/** Fills in the values, errors and orders of all rows that are there. What a measure cannot say is NaN; with `tell` a
 *  warning says why. Errors: SPH2D_NOMEM. */
sph2d_status study_measure_all(cli_study *s, bool tell);

/** Tells every error that is above its bound and returns how many there are. */
size_t study_measure_misses(const cli_study *s);

#endif
