/* SPDX-License-Identifier: MIT */
/** @file play.c
 *  `sph2d play [SCENE]`: a scene in a window, to be played with. */
#include <math.h>

#include "../clock.h"
#include "../command.h"
#include "../exit.h"
#include "../message.h"
#include "../signals.h"
#include "../threads.h"
#include "game.h"

/* Pictures a second: at most, and those for which steps are cut short where the machine is slow; but steps have this long
 * in any case [s]. Then the size of the window at first. */
static const double MOST_PICTURES = 60, WANTED_PICTURES = 34, LEAST_STEPPING = 0.006;
enum { WIDTH = 960, HEIGHT = 540 };

/* The longest that is taken for one turn of the loop, as after the window was dragged [s]. */
static const double LONGEST_TURN = 0.1;

/* The loop around a window. */
typedef struct loop {
    play_window *window;
    sph2d_renderer *renderer;
    unsigned width, height; /* of the renderer */
    sph2d_style style;      /* ... and its style */
    double begun, last;     /* of the loop, of the last turn [s] */
    double drawing;         /* a picture's time [s] */
    double pictures;        /* a second, in the last second ... */
    double counted;         /* ... whose end this was, and the pictures before it */
    size_t shown, shown_then;
    double simulated, played; /* sum of simulated time, and of the clock's while not paused [s] */
} loop;

/* Makes the renderer anew for a window of another size, or another style. */
static sph2d_status fit_renderer(loop *p, const game *g, const play_input *input, sph2d_report *report)
{
    if (p->renderer && p->width == input->width && p->height == input->height && p->style == g->style.frames.style)
        return SPH2D_OK;
    sph2d_renderer_destroy(p->renderer);
    p->renderer = NULL;
    sph2d_render_options options = sph2d_render_options_default();
    options.width = p->width = input->width;
    options.height = p->height = input->height;
    options.style = p->style = g->style.frames.style;
    options.shader_dir = g->options->shader_dir;
    options.get_proc_address = play_window_loader();
    return sph2d_renderer_create(&options, &p->renderer, report);
}

/* One turn: input, steps, a picture. False at the end. */
static bool turn(loop *p, game *g, sph2d_report *report, sph2d_status *status)
{
    const double begun = clock_wall(), since = fmin(begun - p->last, LONGEST_TURN), from = sph2d_sim_time(g->live.sim);
    const play_input input = play_window_poll(p->window, fmax(1 / MOST_PICTURES - (begun - p->last), 0));
    p->last = begun;
    for (int k = 0; k < input.key_count; ++k)
        game_key(g, input.keys[k]);
    if (input.close || g->quits || signals_caught() != 0 ||
        (g->options->max_wall > 0 && begun - p->begun > g->options->max_wall))
        return false;
    const bool visible = input.width >= 16 && input.height >= 16;
    if (visible)
        game_hand(g, p->renderer, &input);
    game_advance(g, since, fmax(1 / WANTED_PICTURES - p->drawing, LEAST_STEPPING));
    p->played += g->paused ? 0 : since * g->rate;
    p->simulated += fmax(sph2d_sim_time(g->live.sim) - from, 0);
    if (!visible)
        return true;
    *status = fit_renderer(p, g, &input, report);
    if (*status != SPH2D_OK)
        return false;
    const double draws = clock_wall();
    game_show(g, p->renderer, p->pictures);
    play_window_show(p->window);
    p->drawing += 0.1 * (clock_wall() - draws - p->drawing);
    ++p->shown;
    if (begun - p->counted >= 1) {
        p->pictures = (double)(p->shown - p->shown_then) / (begun - p->counted);
        p->counted = begun;
        p->shown_then = p->shown;
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
    message_note("played %.3g s: %zu pictures, %.3g a second; simulated %.3g s of the %.3g s due; %zu particles",
                 seconds, p->shown, (double)p->shown / fmax(seconds, 1e-9), p->simulated, p->played,
                 sph2d_sim_fluid(g->live.sim).count);
}

static int play(game *g)
{
    sph2d_report report = {0};
    loop p = {0};
    sph2d_status status =
        play_window_open(g->options->width > 0 ? g->options->width : WIDTH,
                         g->options->height > 0 ? g->options->height : HEIGHT, "sph2d", &p.window, &report);
    if (status == SPH2D_OK) {
        signals_note();
        p.begun = p.last = p.counted = clock_wall();
        while (turn(&p, g, &report, &status))
            continue;
        sph2d_renderer_destroy(p.renderer);
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
    sim_options.threads = threads.count;
    sim_options.isa = options->isa;
    game g;
    code = game_open(&g, options, &sim_options);
    if (code == CLI_EXIT_SUCCESS)
        code = play(&g);
    game_close(&g);
    return code;
}
