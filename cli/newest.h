/* SPDX-License-Identifier: MIT */
/** @file newest.h
 *  The newest complete snapshot of a run's folder, from which it goes on. */
#ifndef SPH2D_CLI_NEWEST_H
#define SPH2D_CLI_NEWEST_H

#include "folder.h"
#include "options.h"
#include "outputs.h"

typedef struct newest_snapshot {
    sph2d_snapshot *snapshot; /**< the caller's; NULL if there is none */
    saved_in saved;           /**< the kind of its file ... */
    uint64_t number;          /**< ... and that of a snapshot's name */
} newest_snapshot;

/** Reads one snapshot, whose errors are told as warnings, as the others may do without it. NULL if it cannot be read, or
 *  memory is short: then *status is SPH2D_NOMEM. */
sph2d_snapshot *newest_try(const cli_options *options, const char *path, sph2d_report *report, sph2d_status *status);

/** Finds and reads it. Files that cannot be read are skipped with a warning. Errors: SPH2D_NOMEM; `newest` then has none.
 */
sph2d_status newest_find(newest_snapshot *newest, const cli_options *options, cli_folder *folder, sph2d_report *report);

#endif
