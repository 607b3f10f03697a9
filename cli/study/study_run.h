/* SPDX-License-Identifier: MIT */
/** @file study_run.h
 *  Runs one row of a study. */
#ifndef SPH2D_CLI_STUDY_RUN_H
#define SPH2D_CLI_STUDY_RUN_H

#include "study.h"

/** The series of one probe, in memory. Start it with {0}. */
typedef struct study_series {
    bool wanted;    /**< some measure needs it */
    size_t columns; /**< values in a row */
    double *time;
    double *values; /**< row after row */
    size_t count, room;
} study_series;

/** Runs a row, whose `run` and `number` are set, measures it and fills in the rest. What goes wrong is told. */
void study_run(cli_study *s, study_row *row);

#endif
