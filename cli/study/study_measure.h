/* SPDX-License-Identifier: MIT */
/** @file study_measure.h
 *  From series and simulation to the numbers of the table. */
#ifndef SPH2D_CLI_STUDY_MEASURE_H
#define SPH2D_CLI_STUDY_MEASURE_H

#include "study_run.h"

/** Fills in the values and errors of a row that has come to its end. What a measure cannot say is NaN, with a warning
 *  that tells why. `series` is one a probe of the scene. Errors: SPH2D_NOMEM. */
sph2d_status study_measure(cli_study *s, study_row *row, const sph2d_sim *sim, const study_series *series);

/** Fills in the orders of convergence of the last row, each from the nearest row before with a coarser spacing. */
void study_measure_orders(cli_study *s);

/** Tells every error that is above its bound and returns how many there are. */
size_t study_measure_misses(const cli_study *s);

#endif
