/* SPDX-License-Identifier: MIT */
/** @file snapshot_list.h
 *  The snapshots that operands stand for: files, and folders of runs with all of theirs. */
#ifndef SPH2D_CLI_SNAPSHOT_LIST_H
#define SPH2D_CLI_SNAPSHOT_LIST_H

#include "options.h"

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

#endif
