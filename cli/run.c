/* SPDX-License-Identifier: MIT */
/** @file run.c
 *  `sph2d run SCENE -o DIR`: simulates a scene. */
#include <sph2d/contacts.h>

#include "command.h"
#include "exit.h"
#include "message.h"
#include "session.h"
#include "signals.h"

static int check_usage(const cli_options *options)
{
    if (options->operand_count != 1) {
        message_usage("run", options->operand_count == 0 ? "a scene file must be given" : "one scene at a time");
        return CLI_EXIT_USAGE;
    }
    if (!options->output && !options->dry_run) {
        message_usage("run", "a folder for the outputs must be given: -o DIR");
        return CLI_EXIT_USAGE;
    }
    return CLI_EXIT_SUCCESS;
}

/* All steps that may fail, before anything in the folder is changed. It is claimed before the slow ones, so that a second
 * run of the same folder is refused at once. */
static int prepare(cli_session *s, const char *scene)
{
    const cli_options *options = s->options;
    sph2d_status status =
        sph2d_scene_file_read(scene, options->overrides, options->override_count, &s->file, &s->report);
    int code = session_report_scene(s, status);
    if (code == CLI_EXIT_SUCCESS)
        code = folder_claim(&s->folder, options->output, options->force, NULL);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    sph2d_sim_options sim_options = session_sim_options(s);
    frame_style style = frame_style_of_scene(sph2d_scene_file_scene(s->file));
    sph2d_status style_status = frame_style_check(&style, &s->report);
    status = sph2d_sim_create(sph2d_scene_file_scene(s->file), &sim_options, &s->sim, &s->report);
    sph2d_contacts_attach(s->sim);
    code = session_report(s, status != SPH2D_OK ? status : style_status);
    if (code == CLI_EXIT_SUCCESS)
        code = session_create_frame_writer(s);
    return code;
}

static int clear_folder(cli_session *s)
{
    signals_note();
    int code = folder_clear(&s->folder, s->options->force ? FOLDER_CLEAR_RUN : FOLDER_KEEP);
    if (code == CLI_EXIT_SUCCESS && s->writer)
        code = folder_make_inside(&s->folder, "frames");
    return code;
}

int command_run(const cli_options *options)
{
    int code = check_usage(options);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    if (options->dry_run)
        return command_check(options);
    cli_session session;
    session_begin(&session, options);
    code = prepare(&session, options->operands[0]);
    if (code == CLI_EXIT_SUCCESS)
        code = clear_folder(&session);
    if (code == CLI_EXIT_SUCCESS)
        code = session_run(&session, SAVED_NOWHERE);
    session_end(&session, code);
    return code;
}
