/* SPDX-License-Identifier: MIT */
/** @file snapshot.h
 *  Reads a snapshot as --no-checksum says. */
#ifndef SPH2D_CLI_SNAPSHOT_H
#define SPH2D_CLI_SNAPSHOT_H

#include "message.h"
#include "options.h"

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

#endif
