/* SPDX-License-Identifier: MIT */
/** @file newest.c
 *  The newest complete snapshot of a run's folder. */
#include "newest.h"

#include <inttypes.h>
#include <stdlib.h>
#include <unistd.h>

#include "message.h"
#include "snapshot.h"
#include "snapshot_list.h"

sph2d_snapshot *newest_try(const cli_options *options, const char *path, sph2d_report *report, sph2d_status *status)
{
    sph2d_snapshot *snapshot = NULL;
    sph2d_status read = path ? snapshot_read(options, path, &snapshot, report) : SPH2D_NOMEM;
    if (read == SPH2D_NOMEM) /* which says nothing about the file */
        *status = read;
    if (read == SPH2D_OK || read == SPH2D_NOMEM)
        return snapshot;
    for (size_t i = 0; i < report->count; ++i)
        report->items[i].severity = SPH2D_WARNING;
    report->errors = 0;
    message_report(SPH2D_OK, report, NULL);
    message_warning(SPH2D_CODE_FILE_INCOMPLETE, "'%s' is skipped", path);
    return NULL;
}

/* The numbers of a run's snapshots increase with its steps, so the last valid one is the newest. */
static sph2d_status find_snapshot(newest_snapshot *newest, const cli_options *options, cli_folder *folder,
                                  sph2d_report *report)
{
    size_t count;
    sph2d_status status = SPH2D_OK;
    uint64_t *numbers = snapshot_numbers(folder->path, &count, &status);
    for (size_t i = count; i > 0 && !newest->snapshot && status == SPH2D_OK; --i) {
        const char *path = folder_file(folder, "snapshot_%06" PRIu64 ".h5", numbers[i - 1]);
        newest->snapshot = newest_try(options, path, report, &status);
        newest->number = numbers[i - 1];
    }
    free(numbers);
    return status;
}

/* A checkpoint is newer if it has more steps. */
static sph2d_status find_checkpoint(newest_snapshot *newest, const cli_options *options, cli_folder *folder,
                                    sph2d_report *report)
{
    sph2d_status status = SPH2D_OK;
    const char *path = folder_file(folder, "checkpoint.h5");
    if (path && access(path, F_OK) != 0)
        return SPH2D_OK;
    sph2d_snapshot *checkpoint = newest_try(options, path, report, &status);
    const uint64_t steps = newest->snapshot ? sph2d_snapshot_get_info(newest->snapshot).steps : 0;
    if (!checkpoint || (newest->snapshot && steps >= sph2d_snapshot_get_info(checkpoint).steps)) {
        sph2d_snapshot_destroy(checkpoint);
        return status;
    }
    sph2d_snapshot_destroy(newest->snapshot);
    *newest = (newest_snapshot){.snapshot = checkpoint, .saved = SAVED_IN_CHECKPOINT};
    return SPH2D_OK;
}

sph2d_status newest_find(newest_snapshot *newest, const cli_options *options, cli_folder *folder, sph2d_report *report)
{
    *newest = (newest_snapshot){.saved = SAVED_IN_SNAPSHOT};
    sph2d_status status = find_snapshot(newest, options, folder, report);
    if (status == SPH2D_OK)
        status = find_checkpoint(newest, options, folder, report);
    if (status != SPH2D_OK) {
        sph2d_snapshot_destroy(newest->snapshot);
        *newest = (newest_snapshot){.saved = SAVED_NOWHERE};
    }
    return status;
}
