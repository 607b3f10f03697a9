/* SPDX-License-Identifier: MIT */
/** @file study_record.h
 *  What a run of a row leaves behind: enough to take every measure from, and a text that can be kept.
 *
 *  A row runs in a process of its own. Its record goes to the study through a pipe, and with -o into a file, from which
 *  an interrupted study goes on. */
#ifndef SPH2D_CLI_STUDY_RECORD_H
#define SPH2D_CLI_STUDY_RECORD_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include <sph2d/study.h>

/** How a row ended. */
typedef enum study_end {
    STUDY_FINISHED,
    STUDY_GUARD,   /**< a guard stopped the run */
    STUDY_FAILED,  /**< it could not be made, or memory is gone */
    STUDY_STOPPED, /**< a signal asked to stop */
    STUDY_DIED     /**< its process was killed, or crashed */
} study_end;

/** The series of one probe. */
typedef struct study_series {
    char *probe;    /**< its name */
    char *headings; /**< of its columns, with units, in one line */
    size_t columns; /**< values in a row */
    double *time;   /**< [s] */
    double *values; /**< row after row */
    size_t count, room;
} study_series;

/** The liquid at some places along a line, at the end of the run. */
typedef struct study_samples {
    sph2d_vec2 ends[2]; /**< [m] */
    sph2d_quantity quantity;
    size_t count;
    double *along;  /**< places, 0 to 1 from end to end */
    double *values; /**< NaN where no particle is near */
} study_samples;

/** All of it. Start it with {0}; times are the least of the repeats. */
typedef struct study_record {
    study_end end;
    int code;         /**< the exit code that the row alone would have */
    char reason[320]; /**< why it did not finish */
    char isa[16];
    double spacing;     /**< [m] */
    double time;        /**< simulated [s] */
    uint64_t particles; /**< at the end */
    uint64_t left;      /**< lost through open sides */
    uint64_t steps, particle_steps;
    uint64_t repeats;                     /**< how often it was run */
    double cpu, wall;                     /**< of stepping alone [s]; wall is NaN beside other rows */
    double summary[SPH2D_SUMMARY_VALUES]; /**< by sph2d_summary_value */
    double start, probes;                 /**< CPU seconds of reading and placing, and of taking the probes */
    study_series *series;                 /**< one a probe of the scene; owned */
    size_t series_count;
    study_samples *samples; /**< one a profile of the study; owned */
    size_t samples_count;
} study_record;

/** Adds a row to a series; false when memory is short. */
bool study_series_add(study_series *series, double time, const double *values);

/** Room for `count` more places of one more line; NULL when memory is short. */
study_samples *study_record_add_samples(study_record *record, size_t count);

/** Writes it as text, every digit of it, so that equal records are equal texts. */
void study_record_write(const study_record *record, FILE *out);

/** Reads what study_record_write wrote into an empty record. False when it is damaged or memory is short; what was read
 *  is the caller's to free all the same. */
bool study_record_read(study_record *record, const char *text);

/** Frees what it owns and empties it. */
void study_record_free(study_record *record);

#endif
