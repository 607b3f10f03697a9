/* SPDX-License-Identifier: MIT */
/** @file state.h
 *  The state of `sph2d study`, and the texts that it generates. */
#ifndef SPH2D_CLI_STUDY_STATE_H
#define SPH2D_CLI_STUDY_STATE_H

#include <stdio.h>

#include <sph2d/study_results.h>

#include "../device.h"
#include "../folder.h"
#include "../options.h"
#include "../threads.h"

typedef struct cli_study {
    const cli_options *options;
    const char *path; /**< of the study file */
    thread_choice threads;
    device_choice device;
    size_t jobs; /**< rows that run at the same time */
    char *made;  /**< the text of a study that was generated for a scene; owned, NULL otherwise */
    sph2d_study_file *file;
    const sph2d_study *study;
    sph2d_study_results *results;
    cli_folder folder; /**< of -o */
    bool percent;      /**< errors are printed in per cent */
    uint64_t repeat;   /**< how often a short row is run */
    double target;     /**< the error for which the cheapest row is reported */
    size_t kept;       /**< number of rows from earlier sessions of this study */
    size_t by_shards;  /**< number of rows that shards ran, on any processor with any number of threads */
    size_t missing;    /**< of a shard: number of wanted rows that are not in the folder yet */
    bool stopped;      /**< by a signal, before all rows were run */
    bool plotted;      /**< plots.gp and plots.dat were written ... */
    int pictures;      /**< ... and so many pictures drawn by gnuplot */
    sph2d_report report;
} cli_study;

/** Runs the statement that follows for each row with a record. */
#define STUDY_FOR_ROWS(s, row)                                                                                         \
    for (const sph2d_study_row *row = (s)->results->rows; row < (s)->results->rows + (s)->results->row_count; ++row)   \
        if (row->there)

/** Prints the report, and returns the exit code for `status`. */
int study_report(cli_study *s, sph2d_status status);

/** The first of two exit codes other than success. */
static inline int study_first(int code, int other)
{
    return code != 0 ? code : other;
}

/** Writes a file of the folder, completely or not at all: `put` prints it, more than
 *  once if it is long. Reports errors and returns an exit code. */
int study_write(cli_study *s, const char *name, void (*put)(const void *what, FILE *out), const void *what);

/** The text for {{name}} in a template. */
typedef struct study_slot {
    const char *name;
    void (*put)(const void *what, FILE *out);
} study_slot;

/** Prints a template with its slots filled; the last slot's name is NULL. */
void study_fill(FILE *out, const char *template, const study_slot *slots, const void *what);

/** Removes an incomplete character at the end, and replaces every byte of `others` by `by`. */
void study_clean(char *text, const char *others, char by);

#endif
