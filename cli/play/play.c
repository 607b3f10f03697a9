/* SPDX-License-Identifier: MIT */
/** @file play.c
 *  `sph2d play [SCENE]`: a scene in a window, to be played with. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include "../clock.h"
#include "../command.h"
#include "../device.h"
#include "../exit.h"
#include "../input.h"
#include "../message.h"
#include "../threads.h"
#include "turn.h"

/* Pictures a second, at most; and the size of the window at first. */
static const double MOST_PICTURES = 60;
enum { WIDTH = 960, HEIGHT = 540 };

/* The loop around a window. */
typedef struct loop {
    play_window *window;
    turning turning;
    double begun, last; /* of the loop, of the last turn [s] */
} loop;

/* One turn: input, steps, a picture. False at the end. */
static bool turn(loop *p, game *g, sph2d_report *report, sph2d_status *status)
{
    const play_input input = play_window_poll(p->window, fmax(1 / MOST_PICTURES - (clock_wall() - p->last), 0));
    const double begun = clock_wall(), since = begun - p->last;
    p->last = begun;
    *status = turn_take(&p->turning, g, &input, play_window_loader(), since, report);
    if (*status != SPH2D_OK || input.close || g->quits || signals_caught() != 0 ||
        (g->options->max_wall > 0 && begun - p->begun > g->options->max_wall))
        return false;
    if (input.width > 0) {
        play_window_show(p->window);
        turn_shown(&p->turning, g);
    }
    return true;
}

static int check_usage(const cli_options *options)
{
    if (options->operand_count > 1) {
        message_usage("play", "one scene at a time");
        return CLI_EXIT_USAGE;
    }
    return CLI_EXIT_SUCCESS;
}

static void tell_end(const loop *p, const game *g)
{
    const double seconds = clock_wall() - p->begun;
    const turning *t = &p->turning;
    char left[64] = "";
    if (g->live.stopped != SPH2D_OK)
        message_note("stopped at t = %.4g s: %s", sph2d_sim_time(g->live.sim), g->live.why);
    if (live_left(&g->live) > 0)
        snprintf(left, sizeof left, ", %" PRIu64 " left through open sides", live_left(&g->live));
    message_note("played %.3g s: %zu pictures, %.3g a second; simulated %.3g s of the %.3g s due; %zu particles%s",
                 seconds, t->shown, (double)t->shown / fmax(seconds, 1e-9), t->simulated, t->played,
                 sph2d_sim_count(g->live.sim), left);
}

static int open_game(game *g, const cli_options *options, const sph2d_sim_options *sim_options)
{
    *g = game_new(options, sim_options);
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    sph2d_status status;
    if (options->operand_count == 0)
        status = game_open_number(g, 0, &report);
    else {
        status = scene_input_read(options, &file, &report);
        if (status == SPH2D_OK) {
            sph2d_report_clear(&report); /* creating the simulation repeats warnings */
            status = game_open_file(g, file, &report);
        }
    }
    message_report(status, &report, g->live.file);
    return exit_of_status(status);
}

static int play(game *g)
{
    sph2d_report report = {0};
    loop p = {0};
    threads_draw_here();
    sph2d_status status =
        play_window_open(g->options->width > 0 ? g->options->width : WIDTH,
                         g->options->height > 0 ? g->options->height : HEIGHT, "sph2d", &p.window, &report);
    if (status == SPH2D_OK) {
        signals_note();
        threads_count_caller();
        turn_beside(&p.turning);
        p.begun = p.last = clock_wall();
        while (turn(&p, g, &report, &status))
            continue;
        game_film_end(g);
        turn_end(&p.turning, g);
        tell_end(&p, g);
    }
    play_window_close(p.window);
    message_report(status, &report, NULL);
    if (status == SPH2D_OK && signals_caught() != 0)
        return 128 + signals_caught();
    return exit_of_status(status);
}

int command_play(const cli_options *options)
{
    int code = check_usage(options);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    signals_install();
    const thread_choice threads = threads_choose(options);
    sph2d_sim_options sim_options = sph2d_sim_options_default();
    sim_options.threads = threads.wanted;
    sim_options.isa = options->isa;
    device_choice device;
    code = device_choose(&device, options);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    device_set(&sim_options, &device);
    game g;
    code = open_game(&g, options, &sim_options);
    if (code == CLI_EXIT_SUCCESS) {
        device_tell(&device);
        code = play(&g);
    }
    game_close(&g);
    return code;
}
