/* SPDX-License-Identifier: MIT */
/** @file run.c
 *  `sph2d run SCENE -o DIR`: simulates a scene. */
#include "command.h"
#include "exit.h"
#include "message.h"
#include "session.h"

static int usage_fault(const cli_options *options)
{
    if (options->operand_count != 1) {
        message_usage("run", options->operand_count == 0 ? "a scene file must be given" : "one scene at a time");
        return CLI_EXIT_USAGE;
    }
    if (options->output == NULL && !options->dry_run) {
        message_usage("run", "a folder for the outputs must be given: -o DIR");
        return CLI_EXIT_USAGE;
    }
    return CLI_EXIT_SUCCESS;
}

/* Everything that may be refused comes before the folder is touched. */
static int prepare(cli_session *s, const char *scene)
{
    const cli_options *options = s->options;
    sph2d_status status =
        sph2d_scene_file_read(scene, options->overrides, options->override_count, &s->file, &s->report);
    int code = session_report_scene(s, status);
    if (code == CLI_EXIT_SUCCESS)
        code = folder_refuse(options->output, options->force);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    sph2d_sim_options sim_options = session_sim_options(s);
    cli_look look = look_of_scene(sph2d_scene_file_scene(s->file));
    sph2d_status look_status = look_check(&look, &s->report);
    status = sph2d_sim_create(sph2d_scene_file_scene(s->file), &sim_options, &s->sim, &s->report);
    code = session_report(s, status != SPH2D_OK ? status : look_status);
    if (code == CLI_EXIT_SUCCESS)
        code = session_make_painter(s);
    return code;
}

static int take_folder(cli_session *s)
{
    int code = folder_open_new(&s->folder, s->options->output, s->options->force ? FOLDER_CLEAR_RUN : FOLDER_KEEP);
    if (code == CLI_EXIT_SUCCESS && s->painter != NULL)
        code = folder_make_inside(&s->folder, "frames");
    return code;
}

int command_run(const cli_options *options)
{
    int code = usage_fault(options);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    if (options->dry_run)
        return command_check(options);
    cli_session session;
    session_begin(&session, options);
    code = prepare(&session, options->operands[0]);
    if (code == CLI_EXIT_SUCCESS)
        code = take_folder(&session);
    if (code == CLI_EXIT_SUCCESS)
        code = session_run(&session, SAVED_NOWHERE);
    session_end(&session);
    return code;
}
