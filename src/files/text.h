/* SPDX-License-Identifier: MIT */
/** @file text.h
 *  Source text of a scene, places in it, and the errors found there. */
#ifndef SPH2D_FILES_TEXT_H
#define SPH2D_FILES_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "files/pool.h"
#include "sph2d/status.h"

/** A source of text: a file, or one override. */
typedef struct sph2d__source {
    const char *name; /**< for messages: the path, or `--set PATH=VALUE` */
    const char *text;
    size_t length;
    bool has_lines; /**< whether messages have line and column; not for an override, which is quoted itself */
} sph2d__source;

/** A byte of a source. */
typedef struct sph2d__place {
    const sph2d__source *source;
    size_t offset; /**< SPH2D__NOWHERE: the source as a whole */
} sph2d__place;

#define SPH2D__NOWHERE SIZE_MAX

/** The errors of one reading. They are counted here, too, since the report may be NULL or full. */
typedef struct sph2d__faults {
    sph2d_report *report;
    sph2d__pool *pool;
    size_t errors;
    struct sph2d__fault_path *paths; /**< of invalid values ... */
    size_t invalid;                  /**< ... and their number */
    bool short_of_memory;
} sph2d__faults;

/** Reports an error at a place. `path` may be NULL. Returns the diagnostic for a hint, or NULL. */
sph2d_diagnostic *sph2d__fault(sph2d__faults *faults, sph2d_code code, sph2d__place place, const char *path,
                               const char *format, ...) __attribute__((format(printf, 5, 6)));

/** Records that the value at a path is invalid. */
void sph2d__faults_mark_invalid(sph2d__faults *faults, const char *path);
/** Whether a path, or one above or below it, is invalid. */
bool sph2d__faults_affect(const sph2d__faults *faults, const char *path);

/** Sorts the diagnostics from `first` on by their place in the file; those without a line come first. NULL is
 *  allowed. */
void sph2d__faults_sort(sph2d_report *report, size_t first);

/** Fills in file, line, column and source line. */
void sph2d__place_describe(sph2d__place place, sph2d_diagnostic *diagnostic);
/** The line of a place, counted from 1; 0 when unknown. */
int sph2d__place_line(sph2d__place place);

/** Reads a whole file of at most `limit` bytes and ends it with a NUL. Errors: SPH2D_NOINPUT, SPH2D_SCENE (too long),
 *  SPH2D_NOMEM. The caller frees *text. */
sph2d_status sph2d__text_read(const char *path, size_t limit, char **text, size_t *length, sph2d_report *report);
/** The same of a file that is open, from where it stands; `name` is for messages. It stays open. */
sph2d_status sph2d__text_read_open(int descriptor, const char *name, size_t limit, char **text, size_t *length,
                                   sph2d_report *report);

/** Gives a key path to the diagnostics from number `first` on that have no file: that of a file that cannot be opened is
 *  where the scene names it. */
void sph2d__report_key(sph2d_report *report, size_t first, const char *key);

/** Replaces every byte that is not text by '?', so that messages cannot contain terminal escapes from a file. */
void sph2d__text_clean(char *text);

/** Whether a source is UTF-8 without control characters; reports the first invalid byte otherwise. */
bool sph2d__text_check(const sph2d__source *source, sph2d__faults *faults);

#endif
