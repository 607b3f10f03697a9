/* SPDX-License-Identifier: MIT */
/** @file input.h
 *  What commands read: a scene, a snapshot, the snapshots that operands stand for (files, and folders of runs with all of
 *  theirs), the newest complete one in the folder of a run. */
#ifndef SPH2D_CLI_INPUT_H
#define SPH2D_CLI_INPUT_H

#include <stdbool.h>

#include <sph2d/io.h>

#include "folder.h"
#include "message.h"
#include "options.h"
#include "outputs.h"

/* ---- scenes ------------------------------------------------------------------------------------------------------ */

/** Whether an operand is the standard input; a file of that name is "./-". */
bool scene_input_is_stream(const char *operand);

/** Reads the scene of the first operand, with the overrides of --set. Returns as sph2d_scene_file_read(). */
sph2d_status scene_input_read(const cli_options *options, sph2d_scene_file **file, sph2d_report *report);

/* ---- snapshots --------------------------------------------------------------------------------------------------- */

static inline sph2d_status snapshot_read(const cli_options *options, const char *path, sph2d_snapshot **snapshot,
                                         sph2d_report *report)
{
    return options->no_checksum ? sph2d_snapshot_read_unchecked(path, snapshot, report)
                                : sph2d_snapshot_read(path, snapshot, report);
}

/** Says once for a command that snapshots are not verified. */
static inline void snapshot_note(const cli_options *options)
{
    if (options->no_checksum)
        message_note("checksums of snapshots are not checked");
}

typedef struct snapshot_list {
    char **paths; /**< owned */
    size_t count;
} snapshot_list;

/** Makes the list, in the order of the operands; those of a folder in that of their numbers. Returns an exit code;
 *  otherwise prints an error. Free it with snapshot_list_free() in any case. */
int snapshot_list_make(snapshot_list *list, const cli_options *options);
void snapshot_list_free(snapshot_list *list);

/** The numbers of all snapshots in a folder, the lowest first; the caller frees them. NULL for none; SPH2D_NOMEM goes to
 *  *status. */
uint64_t *snapshot_numbers(const char *folder, size_t *count, sph2d_status *status);

/* ---- the newest snapshot of a run, from which it goes on --------------------------------------------------------- */

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
