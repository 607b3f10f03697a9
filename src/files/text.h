/* SPDX-License-Identifier: MIT */
/** @file text.h
 *  Text that a scene is read from, places in it, and the faults found there. */
#ifndef SPH2D_FILES_TEXT_H
#define SPH2D_FILES_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "files/pool.h"
#include "sph2d/status.h"

/** Where text comes from: a file, or one override. */
typedef struct sph2d__source {
    const char *name; /**< for messages: the path, or `--set PATH=VALUE` */
    const char *text;
    size_t length;
    bool has_lines; /**< messages tell line and column; an override is its own line already */
} sph2d__source;

/** A byte of a source. */
typedef struct sph2d__place {
    const sph2d__source *source;
    size_t offset; /**< SPH2D__NOWHERE: the source as a whole */
} sph2d__place;

#define SPH2D__NOWHERE SIZE_MAX

/** The faults of one reading. It counts and remembers by itself, since the report may be NULL or full. */
typedef struct sph2d__faults {
    sph2d_report *report;
    sph2d__pool *pool;
    size_t errors;
    struct sph2d__fault_path *paths; /**< of values that could not be read ... */
    size_t spoiled;                  /**< ... and how many */
    bool short_of_memory;
} sph2d__faults;

/** Reports an error at a place. `path` may be NULL. Returns the diagnostic for a hint, or NULL. */
sph2d_diagnostic *sph2d__fault(sph2d__faults *faults, sph2d_code code, sph2d__place place, const char *path,
                               const char *format, ...) __attribute__((format(printf, 5, 6)));

/** Remembers that there is no trustworthy value at a path. */
void sph2d__faults_spoil(sph2d__faults *faults, const char *path);
/** Whether a path, something above it or something below it was spoiled. */
bool sph2d__faults_touch(const sph2d__faults *faults, const char *path);

/** Puts the diagnostics from `first` on into the order of the file; what has no line comes first. NULL is fine. */
void sph2d__faults_sort(sph2d_report *report, size_t first);

/** Fills in file, line, column and source line. */
void sph2d__place_describe(sph2d__place place, sph2d_diagnostic *diagnostic);
/** The line of a place, counted from 1; 0 when unknown. */
int sph2d__place_line(sph2d__place place);

/** Reads a whole file of at most `limit` bytes and ends it with a NUL. Errors: SPH2D_NOINPUT, SPH2D_SCENE (too long),
 *  SPH2D_NOMEM. The caller frees *text. */
sph2d_status sph2d__text_read(const char *path, size_t limit, char **text, size_t *length, sph2d_report *report);

/** Puts '?' for every byte that is no text, so that a message cannot hold what a file meant for the terminal. */
void sph2d__text_clean(char *text);

/** Whether a source is UTF-8 without control characters; otherwise a fault at the first bad byte. */
bool sph2d__text_check(const sph2d__source *source, sph2d__faults *faults);

#endif
