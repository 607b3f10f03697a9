/* SPDX-License-Identifier: MIT */
/** @file run.c
 *  `sph2d run SCENE -o DIR`: simulates a scene. */
#include <string.h>

#include <sph2d/contacts.h>

#include "command.h"
#include "exit.h"
#include "input.h"
#include "message.h"
#include "session.h"

static int check_usage(const cli_options *options)
{
    if (options->operand_count != 1) {
        message_usage("run", options->operand_count == 0 ? "a scene file must be given" : "one scene at a time");
        return CLI_EXIT_USAGE;
    }
    return CLI_EXIT_SUCCESS;
}

/* Whether a scene's title is the name of a folder here: one that is no path, not hidden, and no option to other
 * programs. */
static bool names_folder(const char *title)
{
    if (title[0] == '\0' || title[0] == '.' || title[0] == '-')
        return false;
    for (const unsigned char *c = (const unsigned char *)title; *c != '\0'; ++c)
        if (*c < 0x20 || *c == 0x7F || *c == '/')
            return false;
    return true;
}

/* The folder for the outputs: without -o it has the name of the scene. NULL when that has none of its own. */
static const char *choose_folder(const cli_options *options, const sph2d_scene *scene)
{
    if (options->output)
        return options->output;
    if (strcmp(scene->name, sph2d_scene_default().name) != 0 && names_folder(scene->name)) {
        message_note("the outputs go to the folder '%s', the name of the scene", scene->name);
        return scene->name;
    }
    if (strcmp(scene->name, sph2d_scene_default().name) == 0)
        message_usage("run", "a folder for the outputs must be given: -o DIR; the scene has no `name` to call it");
    else
        message_usage("run", "a folder for the outputs must be given: -o DIR; the scene's name, '%s', cannot be one's",
                      scene->name);
    return NULL;
}

/* All steps that may fail, before anything in the folder is changed. It is claimed before the slow ones, so that a second
 * run of the same folder is refused at once. */
static int prepare(cli_session *s)
{
    const cli_options *options = s->options;
    sph2d_status status = scene_input_read(options, &s->file, &s->report);
    int code = session_report_scene(s, status);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    const char *folder = choose_folder(options, sph2d_scene_file_scene(s->file));
    code = folder ? folder_claim(&s->folder, folder, options->force, NULL) : CLI_EXIT_USAGE;
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
    code = session_begin(&session, options);
    if (code == CLI_EXIT_SUCCESS)
        code = prepare(&session);
    if (code == CLI_EXIT_SUCCESS)
        code = clear_folder(&session);
    if (code == CLI_EXIT_SUCCESS)
        code = session_run(&session, SAVED_NOWHERE);
    session_end(&session, code);
    return code;
}
