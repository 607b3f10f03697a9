/* SPDX-License-Identifier: MIT */
/** @file study_text.h
 *  A text that is printed into, and becomes a file. */
#ifndef SPH2D_CLI_STUDY_TEXT_H
#define SPH2D_CLI_STUDY_TEXT_H

#include <stdbool.h>
#include <stdio.h>

#include <sph2d/status.h>

typedef struct study_text {
    FILE *out;
    char *text;
    size_t size;
} study_text;

/** False when memory is short; then there is nothing to end. */
bool study_text_begin(study_text *t);

/** Ends it and writes it to `path`, whole or not at all; NULL stands for a path that found no memory. Errors: those of
 *  sph2d_text_write. */
sph2d_status study_text_write(study_text *t, const char *path, sph2d_report *report);

/** Ends it and hands it over, to be freed by the caller; NULL when memory was short. */
char *study_text_take(study_text *t);

#endif
