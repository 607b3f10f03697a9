/* SPDX-License-Identifier: MIT */
/** @file session.c
 *  The common part of `run` and `resume`. */
#include "session.h"

#include <inttypes.h>

#include "clock.h"
#include "exit.h"
#include "message.h"
#include "text.h"

int session_begin(cli_session *s, const cli_options *options)
{
    *s = (cli_session){.options = options, .begun = clock_wall(), .folder = FOLDER_CLOSED};
    s->threads = threads_choose(options);
    signals_install();
    return device_choose(&s->device, options);
}

sph2d_sim_options session_sim_options(const cli_session *s)
{
    sph2d_sim_options sim = sph2d_sim_options_default();
    sim.threads = s->threads.wanted;
    sim.isa = s->options->isa;
    sim.profile = s->options->profile;
    device_set(&sim, &s->device);
    return sim;
}

int session_report_scene(cli_session *s, sph2d_status status)
{
    if (status == SPH2D_OK)
        sph2d_report_clear(&s->report);
    return session_report(s, status);
}

int session_report(cli_session *s, sph2d_status status)
{
    message_report(status, &s->report, s->file);
    return exit_of_status(status);
}

int session_create_frame_writer(cli_session *s)
{
    const sph2d_scene *scene = sph2d_sim_scene(s->sim);
    if (!outputs_want_frames(scene) || s->options->no_frames)
        return CLI_EXIT_SUCCESS;
    frame_style style = frame_style_of_scene(scene);
    sph2d_status status = frame_writer_create(&style, s->options, &s->writer, &s->report);
    char description[200];
    if (status == SPH2D_OK)
        message_detail("drawing with %s", frame_writer_describe(s->writer, description, sizeof description));
    int code = session_report(s, status);
    if (status == SPH2D_RENDER)
        message_note("the scene has frames; --no-frames simulates without them");
    return code;
}

static void report_start(const cli_session *s)
{
    const sph2d_plan *plan = sph2d_sim_plan(s->sim);
    message_note("%s: %zu particles, %zu in walls, from t = %g s to %g s", sph2d_sim_scene(s->sim)->name,
                 sph2d_sim_count(s->sim), sph2d_sim_walls(s->sim).count, sph2d_sim_time(s->sim),
                 sph2d_sim_scene(s->sim)->run.until);
    device_tell(&s->device);
    message_detail("support radius %g m, sound speed %g m/s (%s)", plan->support_radius, plan->sound_speed,
                   plan->sound_speed_formula);
    char in_use[TEXT_SIZE];
    message_detail("next step %g s; %s, %s", sph2d_sim_time_step(s->sim),
                   threads_describe(in_use, sph2d_sim_threads(s->sim), &s->threads),
                   sph2d_isa_name(sph2d_sim_isa(s->sim)));
}

static const char *end_name(const loop_result *result)
{
    switch (result->end) {
    case LOOP_FINISHED:
        return "finished";
    case LOOP_SIGNAL:
        return signals_name(result->signal);
    case LOOP_MAX_WALL:
        return "max-wall";
    case LOOP_GUARD:
        return "guard";
    case LOOP_FAILED:
        return "failed";
    }
    return "failed";
}

static int end_code(const loop_result *result)
{
    switch (result->end) {
    case LOOP_FINISHED:
        return CLI_EXIT_SUCCESS;
    case LOOP_SIGNAL:
        return 128 + result->signal;
    case LOOP_MAX_WALL:
        return CLI_EXIT_STOPPED;
    case LOOP_GUARD:
    case LOOP_FAILED:
        break;
    }
    return exit_of_status(result->status);
}

/* Where to look for what went wrong: the moment of the guard, and the last snapshot before. */
static void tell_saved(const cli_session *s)
{
    const uint64_t snapshots = sph2d_sim_output_count(s->sim, SPH2D_OUTPUT_SNAPSHOT);
    if (snapshots > 0)
        message_note("state saved to '%s/guard.h5'; the last snapshot before is 'snapshot_%06" PRIu64 ".h5'",
                     s->folder.path, snapshots - 1);
    else
        message_note("state saved to '%s/guard.h5'", s->folder.path);
}

int session_run(cli_session *s, saved_in saved)
{
    const sph2d_scene *scene = sph2d_sim_scene(s->sim);
    cli_outputs outputs;
    sph2d_status status = outputs_open(&outputs, &s->folder, s->sim, s->file, s->writer, saved, &s->report);
    int code = session_report(s, status);
    if (status == SPH2D_OK) {
        report_start(s);
        if (s->threads.count > 1)
            outputs_work_beside(&outputs);
        cli_progress progress = progress_begin(s->options, sph2d_sim_time(s->sim), scene->run.until);
        double deadline = s->options->max_wall > 0 ? s->begun + s->options->max_wall : 0;
        loop_result result = loop_run(s->sim, &outputs, &progress, deadline, &s->report);
        session_report(s, result.status);
        char folder[TEXT_WORD_SIZE];
        text_word(folder, s->folder.path);
        if (result.end == LOOP_SIGNAL || result.end == LOOP_MAX_WALL)
            message_note("stopped by %s at t = %g s; 'sph2d resume %s' continues", end_name(&result),
                         sph2d_sim_time(s->sim), folder);
        if (result.end == LOOP_FAILED && outputs.saved != SAVED_NOWHERE)
            message_note("what was written before is complete; %s, 'sph2d resume %s' continues",
                         result.status == SPH2D_DEVICE ? "with --device cpu" : "when there is room or memory again",
                         folder);
        if (result.end == LOOP_GUARD)
            tell_saved(s);
        if (result.end == LOOP_FINISHED && outputs.last_only)
            message_note("there were no outputs to write, so the last moment is in '%s/snapshot_%06" PRIu64 ".h5'; "
                         "`run: {snapshots: {per_second: 60}}` in the scene writes all the others",
                         s->folder.path, sph2d_sim_output_count(s->sim, SPH2D_OUTPUT_SNAPSHOT) - 1);
        summary_print(s, &result, end_name(&result));
        code = end_code(&result);
    }
    sph2d_status closed = outputs_close(&outputs, &s->report);
    int close_code = session_report(s, closed);
    return code == CLI_EXIT_SUCCESS ? close_code : code;
}

void session_end(cli_session *s, int code)
{
    frame_writer_destroy(s->writer);
    sph2d_sim_destroy(s->sim);
    sph2d_scene_file_destroy(s->file);
    if (code == CLI_EXIT_SUCCESS)
        folder_close(&s->folder);
    else
        folder_abandon(&s->folder);
}
