/* SPDX-License-Identifier: MIT */
/** @file study.h
 *  A study while it goes on: what was asked for, what is compared with, and the rows that are there. */
#ifndef SPH2D_CLI_STUDY_H
#define SPH2D_CLI_STUDY_H

#include <sph2d/study.h>

#include "../folder.h"
#include "../options.h"
#include "../threads.h"
#include "study_reference.h"

/** What one measure says of one run. NaN where it says nothing. */
typedef struct study_value {
    double value; /**< in units of the measure's scale */
    double error; /**< from what is expected */
    double order; /**< of convergence, from the coarser row before */
} study_value;

/** How a row ended. */
typedef enum study_end {
    STUDY_FINISHED,
    STUDY_GUARD,  /**< a guard stopped the run */
    STUDY_FAILED, /**< it could not be made, or memory is gone */
    STUDY_STOPPED /**< a signal asked to stop */
} study_end;

/** A run and what came out of it. */
typedef struct study_row {
    size_t number; /**< from 1, in the order of the study file */
    const sph2d_study_run *run;
    study_end end;
    int code;         /**< the exit code that the row alone would have */
    char reason[320]; /**< why it did not finish */
    double spacing;   /**< [m] */
    uint64_t particles, steps, particle_steps;
    double time;         /**< simulated [s] */
    double cpu, wall;    /**< of stepping alone [s] */
    study_value *values; /**< one a measure; owned */
} study_row;

typedef struct cli_study {
    const cli_options *options;
    const char *path; /**< of the study file */
    thread_choice threads;
    sph2d_study_file *file;
    const sph2d_study *study;
    study_points *references; /**< one a measure, empty where it has none */
    cli_folder folder;        /**< where -o is given */
    study_row *rows;          /**< those that were run, in their order */
    size_t row_count;
    bool stopped;    /**< by a signal, before all rows were there */
    const char *isa; /**< that the rows ran with; NULL before the first */
    sph2d_report report;
} cli_study;

/** Tells what the report says, faults of a row's overrides at their places in the study, and returns the exit code for
 *  `status`. `scene` is for the places of the others, `row` for those of the overrides; either may be NULL. */
int study_told(cli_study *s, sph2d_status status, const sph2d_scene_file *scene, const sph2d_study_run *row);

#endif
