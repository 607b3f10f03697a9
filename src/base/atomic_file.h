/* SPDX-License-Identifier: MIT */
/** @file atomic_file.h
 *  A file that appears under its final name complete or not at all: it is written as `DIR/.NAME.tmp.NUMBER`, synced and
 *  renamed, and then the folder is synced. The number is the writer's own: several processes may write one file at the
 *  same time, also on different machines, and the last to rename wins. */
#ifndef SPH2D_BASE_ATOMIC_FILE_H
#define SPH2D_BASE_ATOMIC_FILE_H

#include <stdio.h>

#include "sph2d/status.h"

typedef struct sph2d__atomic_file {
    char *final_path;
    char *temp_path; /**< the file to write */
} sph2d__atomic_file;

/** Names the temporary file beside `path`. Nothing is created. Errors: SPH2D_CANTCREAT where `path` names a folder, a
 *  device or nothing, SPH2D_NOMEM. */
sph2d_status sph2d__atomic_begin(sph2d__atomic_file *file, const char *path, sph2d_report *report);

/** Syncs the temporary file, which the caller has closed, and renames it to its final name. Frees `file` in any case;
 *  after a failure the temporary file is gone and the final name as it was. Errors: SPH2D_IO. */
sph2d_status sph2d__atomic_commit(sph2d__atomic_file *file, sph2d_report *report);

/** Removes the temporary file and frees `file`, which may be zeroed. */
void sph2d__atomic_abort(sph2d__atomic_file *file);

/** Reports a failed system call: "cannot WHAT 'PATH': strerror(error)". */
void sph2d__report_errno(sph2d_report *report, sph2d_code code, const char *what, const char *path, int error);

#endif
