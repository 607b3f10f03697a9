/* SPDX-License-Identifier: MIT */
/** @file state.h
 *  A study while the command is at it, and the texts that it makes. */
#ifndef SPH2D_CLI_STUDY_STATE_H
#define SPH2D_CLI_STUDY_STATE_H

#include <stdio.h>

#include <sph2d/study_results.h>

#include "../folder.h"
#include "../options.h"
#include "../threads.h"

typedef struct cli_study {
    const cli_options *options;
    const char *path; /**< of the study file */
    thread_choice threads;
    size_t jobs; /**< rows that run at a time */
    char *made;  /**< the text of a study that was made for a scene; owned, NULL otherwise */
    sph2d_study_file *file;
    const sph2d_study *study;
    sph2d_study_results *results;
    cli_folder folder; /**< where -o is given */
    bool percent;      /**< errors are printed in per cent */
    uint64_t repeat;   /**< how often a short row is run */
    double target;     /**< the error that the cheapest row is named for */
    size_t kept;       /**< rows that an earlier session of this study ran */
    bool stopped;      /**< by a signal, before all rows were there */
    sph2d_report report;
} cli_study;

/** Goes through the rows that are there. */
#define STUDY_FOR_ROWS(s, row)                                                                                         \
    for (const sph2d_study_row *row = (s)->results->rows; row < (s)->results->rows + (s)->results->row_count; ++row)   \
        if (row->there)

/** Tells what the report says, and returns the exit code for `status`. */
int study_report(cli_study *s, sph2d_status status);

/** The first of two exit codes that is none of success. */
static inline int study_first(int code, int other)
{
    return code != 0 ? code : other;
}

/** A text that is printed into. */
typedef struct study_text {
    FILE *out;
    char *text;
    size_t size;
} study_text;

/** False when memory is short; then there is nothing to end. */
bool study_text_begin(study_text *t);

/** Ends it and hands it over, to be freed by the caller; NULL when memory was short. */
char *study_text_take(study_text *t);

/** Writes a file of the folder, whole or not at all: `put` prints it. Tells what goes wrong and returns an exit code.
 */
int study_write(cli_study *s, const char *name, void (*put)(const void *what, FILE *out), const void *what);

/** What stands in a template for {{name}}. */
typedef struct study_slot {
    const char *name;
    void (*put)(const void *what, FILE *out);
} study_slot;

/** Prints a template with its slots, of which NULL names the end, filled. */
void study_fill(FILE *out, const char *template, const study_slot *slots, const void *what);

/** Takes away what a cut left of a character, and every byte that is one of `others`: it becomes `by`. */
void study_clean(char *text, const char *others, char by);

#endif
