/* SPDX-License-Identifier: MIT */
/** @file study.h
 *  A study while it goes on: what was asked for, what is compared with, and the rows that are there. */
#ifndef SPH2D_CLI_STUDY_H
#define SPH2D_CLI_STUDY_H

#include <sys/types.h>

#include <sph2d/study.h>

#include "../folder.h"
#include "../options.h"
#include "../threads.h"
#include "study_record.h"
#include "study_reference.h"

/** What one measure says of one run. NaN where it says nothing. */
typedef struct study_value {
    double value; /**< in units of the measure's scale */
    double error; /**< from what is expected */
    double order; /**< of convergence, from a coarser row before */
} study_value;

/** A run and what came out of it. */
typedef struct study_row {
    size_t number;       /**< from 1: runs in the order of the study file, then refinements */
    sph2d_study_run run; /**< what it points at is the study file's, or the row's own */
    bool owned;          /**< name and lists of the run are the row's own: it is a refinement */
    bool wanted;         /**< it is to be run */
    bool there;          /**< the record is */
    study_record record;
    study_value *values; /**< one a measure; owned */
    bool on_front;       /**< no other row has both a smaller error and less time */
} study_row;

typedef struct cli_study {
    const cli_options *options;
    const char *path; /**< of the study file */
    pid_t process;    /**< that the rows are started from */
    thread_choice threads;
    size_t jobs; /**< rows that run at a time */
    sph2d_study_file *file;
    char *made; /**< the text of a study that was made for a scene; owned, NULL otherwise */
    const sph2d_study *study;
    study_points *references; /**< one a measure, empty where it has none */
    cli_folder folder;        /**< where -o is given */
    study_row *rows;
    size_t row_count;
    size_t judge;    /**< the measure whose error is weighed against the time; measure_count: none */
    bool percent;    /**< errors are printed in per cent */
    uint64_t repeat; /**< how often a short row is run */
    double target;   /**< the error that the cheapest row is named for */
    size_t kept;     /**< rows that an earlier session of this study ran */
    bool stopped;    /**< by a signal, before all rows were there */
    sph2d_report report;
} cli_study;

/** Whether a row came to its end, so that it has numbers. */
static inline bool study_row_counts(const study_row *row)
{
    return row->there && row->record.end == STUDY_FINISHED;
}

/** Tells what the report says, faults of a row's overrides at their places in the study, and returns the exit code for
 *  `status`. `scene` is for the places of the others, `row` for those of the overrides; either may be NULL. */
int study_report(cli_study *s, sph2d_status status, const sph2d_scene_file *scene, const sph2d_study_run *row);

#endif
