/* SPDX-License-Identifier: MIT */
/** @file resume.c
 *  `sph2d resume DIR`: continues a run from its newest complete snapshot. */
#include <string.h>
#include <unistd.h>

#include <sph2d/contacts.h>

#include "command.h"
#include "exit.h"
#include "input.h"
#include "message.h"
#include "session.h"

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
    const char *isa = sph2d_snapshot_get_info(snapshot).isa;
    if (status == SPH2D_OK && strcmp(isa, sph2d_isa_name(sph2d_sim_isa(s->sim))) != 0)
        message_note(
            "the run was one by %s; what a device does is what baseline does, which differs in the last digits", isa);
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
            summary_print(s, &nothing, "complete");
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
    code = session_begin(&session, options);
    newest_snapshot newest = {0};
    if (code == CLI_EXIT_SUCCESS)
        code = folder_reopen(&session.folder, options->operands[0]);
    if (code == CLI_EXIT_SUCCESS) {
        code = session_report(&session, newest_find(&newest, options, &session.folder, &session.report));
        if (!newest.snapshot && code == CLI_EXIT_SUCCESS) {
            message_error(SPH2D_CODE_FILE_OPEN,
                          "a run writes snapshots if its scene has run.snapshots, and a checkpoint when it is stopped",
                          "no complete snapshot in '%s'", session.folder.path);
            code = CLI_EXIT_NOINPUT;
        }
    }
    if (code == CLI_EXIT_SUCCESS) {
        sph2d_status status = sph2d_snapshot_scene(newest.snapshot, options->overrides, options->override_count,
                                                   &session.file, &session.report);
        code = session_report_scene(&session, status);
    }
    if (code == CLI_EXIT_SUCCESS)
        code = restore(&session, newest.snapshot);
    sph2d_snapshot_destroy(newest.snapshot);
    if (code == CLI_EXIT_SUCCESS)
        code = continue_run(&session, newest.saved);
    session_end(&session, code);
    return code;
}
