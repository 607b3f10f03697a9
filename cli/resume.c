/* SPDX-License-Identifier: MIT */
/** @file resume.c
 *  `sph2d resume DIR`: continues a run from its newest complete snapshot. */
#include <dirent.h>
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <sph2d/contacts.h>

#include "command.h"
#include "exit.h"
#include "message.h"
#include "session.h"
#include "signals.h"
#include "snapshot.h"
#include "summary.h"

/* ---- the newest snapshot ----------------------------------------------------------------------------------------- */

static int compare_descending(const void *a, const void *b)
{
    uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x < y) - (x > y);
}

/* The numbers of all snapshots in the folder, the highest first; the caller frees them. SPH2D_NOMEM goes to *status. */
static uint64_t *list_snapshots(const char *path, size_t *count, sph2d_status *status)
{
    *count = 0;
    DIR *listing = opendir(path);
    if (!listing) {
        *status = errno == ENOMEM ? SPH2D_NOMEM : SPH2D_OK;
        return NULL;
    }
    uint64_t *numbers = NULL;
    uint64_t number;
    const struct dirent *entry;
    while ((entry = readdir(listing))) {
        if (!folder_numbered(entry->d_name, "snapshot_", ".h5", &number))
            continue;
        if ((*count & (*count + 1)) == 0) { /* full: 0, 1, 3, 7, ... */
            uint64_t *grown = realloc(numbers, (2 * *count + 1) * sizeof *grown);
            if (!grown) {
                *status = SPH2D_NOMEM;
                break;
            }
            numbers = grown;
        }
        numbers[(*count)++] = number;
    }
    closedir(listing);
    if (*count > 0)
        qsort(numbers, *count, sizeof *numbers, compare_descending);
    return numbers;
}

/* Reads one snapshot; errors are reported as warnings, since an older one may be usable. But a lack of memory, which
 * goes to *status, says nothing about the file. */
static sph2d_snapshot *try_snapshot(cli_session *s, const char *path, sph2d_status *status)
{
    sph2d_snapshot *snapshot = NULL;
    sph2d_status read = path ? snapshot_read(s->options, path, &snapshot, &s->report) : SPH2D_NOMEM;
    if (read == SPH2D_NOMEM)
        *status = read;
    if (read == SPH2D_OK || read == SPH2D_NOMEM)
        return snapshot;
    for (size_t i = 0; i < s->report.count; ++i)
        s->report.items[i].severity = SPH2D_WARNING;
    s->report.errors = 0;
    message_report(SPH2D_OK, &s->report, NULL);
    message_warning(SPH2D_CODE_FILE_INCOMPLETE, "'%s' is skipped", path);
    return NULL;
}

/* The numbers of a run's snapshots increase with its steps, so the last valid one is the newest; a checkpoint is newer
 * if it has more steps. NULL if there is none, or memory was short: then *status is SPH2D_NOMEM. */
static sph2d_snapshot *newest_snapshot(cli_session *s, saved_in *saved, sph2d_status *status)
{
    size_t count;
    *status = SPH2D_OK;
    uint64_t *numbers = list_snapshots(s->folder.path, &count, status);
    sph2d_snapshot *newest = NULL;
    for (size_t i = 0; i < count && !newest && *status == SPH2D_OK; ++i)
        newest = try_snapshot(s, folder_file(&s->folder, "snapshot_%06" PRIu64 ".h5", numbers[i]), status);
    free(numbers);
    *saved = SAVED_IN_SNAPSHOT;
    const char *path = folder_file(&s->folder, "checkpoint.h5");
    if (*status == SPH2D_OK && path && access(path, F_OK) != 0)
        return newest;
    sph2d_snapshot *checkpoint = *status == SPH2D_OK ? try_snapshot(s, path, status) : NULL;
    if (*status != SPH2D_OK) {
        sph2d_snapshot_destroy(newest);
        return NULL;
    }
    if (!checkpoint)
        return newest;
    if (newest && sph2d_snapshot_get_info(newest).steps >= sph2d_snapshot_get_info(checkpoint).steps) {
        sph2d_snapshot_destroy(checkpoint);
        return newest;
    }
    sph2d_snapshot_destroy(newest);
    *saved = SAVED_IN_CHECKPOINT;
    return checkpoint;
}

/* ---- continuing -------------------------------------------------------------------------------------------------- */

/* Only the end of a run may change: with any other change it would be another run. */
static int check_usage(const cli_options *options)
{
    if (options->operand_count != 1) {
        message_usage("resume",
                      options->operand_count == 0 ? "the folder of a run must be given" : "one folder at a time");
        return CLI_EXIT_USAGE;
    }
    for (size_t i = 0; i < options->override_count; ++i) {
        if (strcmp(options->overrides[i].path, "run.until") == 0)
            continue;
        message_usage("resume", "--set: '%s' cannot change in the middle of a run; only run.until can",
                      options->overrides[i].path);
        return CLI_EXIT_USAGE;
    }
    return CLI_EXIT_SUCCESS;
}

static int restore(cli_session *s, const sph2d_snapshot *snapshot)
{
    sph2d_state state = sph2d_snapshot_state(snapshot);
    sph2d_sim_options options = session_sim_options(s);
    sph2d_status status = sph2d_sim_restore(sph2d_scene_file_scene(s->file), &options, &state, &s->sim, &s->report);
    sph2d_contacts_attach(s->sim);
    return session_report(s, status);
}

/* A run that was killed at its end may have left a checkpoint beside a newer snapshot. */
static void remove_obsolete(cli_session *s, saved_in saved)
{
    const char *checkpoint = folder_file(&s->folder, "checkpoint.h5");
    if (saved == SAVED_IN_SNAPSHOT && checkpoint)
        unlink(checkpoint);
}

/* Continues the run, unless it is complete. */
static int continue_run(cli_session *s, saved_in saved)
{
    const sph2d_scene *scene = sph2d_sim_scene(s->sim);
    if (loop_done(s->sim)) {
        message_note("the run in '%s' is complete: t = %g s, run.until = %g s", s->folder.path, sph2d_sim_time(s->sim),
                     scene->run.until);
        remove_obsolete(s, saved);
        loop_result nothing = {.end = LOOP_FINISHED};
        if (s->options->json)
            summary_print(s->sim, &nothing, "complete", &s->threads, s->options);
        return CLI_EXIT_SUCCESS;
    }
    int code = session_create_frame_writer(s);
    signals_note();
    if (code == CLI_EXIT_SUCCESS && s->writer)
        code = folder_make_inside(&s->folder, "frames");
    if (code != CLI_EXIT_SUCCESS)
        return code;
    /* A guard that fires again writes its file again. */
    const char *guard = folder_file(&s->folder, "guard.h5");
    if (guard)
        unlink(guard);
    return session_run(s, saved);
}

int command_resume(const cli_options *options)
{
    int code = check_usage(options);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    snapshot_note(options);
    cli_session session;
    session_begin(&session, options);
    sph2d_snapshot *snapshot = NULL;
    saved_in saved = SAVED_NOWHERE;
    code = folder_reopen(&session.folder, options->operands[0]);
    if (code == CLI_EXIT_SUCCESS) {
        sph2d_status status;
        snapshot = newest_snapshot(&session, &saved, &status);
        code = session_report(&session, status);
        if (!snapshot && code == CLI_EXIT_SUCCESS) {
            message_error(SPH2D_CODE_FILE_OPEN,
                          "a run writes snapshots if its scene has run.snapshots, and a checkpoint when it is stopped",
                          "no complete snapshot in '%s'", session.folder.path);
            code = CLI_EXIT_NOINPUT;
        }
    }
    if (code == CLI_EXIT_SUCCESS) {
        sph2d_status status =
            sph2d_snapshot_scene(snapshot, options->overrides, options->override_count, &session.file, &session.report);
        code = session_report_scene(&session, status);
    }
    if (code == CLI_EXIT_SUCCESS)
        code = restore(&session, snapshot);
    sph2d_snapshot_destroy(snapshot);
    if (code == CLI_EXIT_SUCCESS)
        code = continue_run(&session, saved);
    session_end(&session, code);
    return code;
}
