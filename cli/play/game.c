/* SPDX-License-Identifier: MIT */
/** @file game.c
 *  What is played: its scenes, and the turns of the loop around the window. */
#include "game.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../clock.h"

void game_tell(game *g, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(g->message, sizeof g->message, format, arguments);
    va_end(arguments);
    g->told = clock_wall();
}

void game_tell_report(game *g, sph2d_status status, sph2d_report *report)
{
    if (status != SPH2D_OK)
        game_tell(g, "%s", live_reason(status, report));
    sph2d_report_clear(report);
}

game game_new(const cli_options *options, const sph2d_sim_options *sim_options)
{
    return (game){.options = options, .sim_options = *sim_options, .rate = 1, .help = true, .number = SIZE_MAX};
}

/* ---- scenes ------------------------------------------------------------------------------------------------------ */

void game_take_scene(game *g)
{
    frame_style style = frame_style_of_scene(sph2d_sim_scene(g->live.sim));
    style.name = g->live.scene.name; /* texts are the file's: simulations come and go */
    style.frames.color = g->live.scene.run.frames.color;
    style.frames.isolines = g->live.scene.run.frames.isolines;
    style.frames.follow = g->live.scene.run.frames.follow;
    style.frames.caption = SPH2D_SWITCH_ON;
    style.recent = 4000;                               /* lines of a long game would take longer than its liquid */
    style.frames.background = SPH2D_BACKGROUND_OPAQUE; /* there is nothing behind a window's picture */
    style.frames.style = g->options->style_given ? g->options->style : style.frames.style;
    style.frames.look = g->options->look_given ? g->options->look : style.frames.look;
    style.frames.color = g->options->color ? g->options->color : style.frames.color;
    g->style = style;
    g->color_range = (sph2d_vec2){INFINITY, -INFINITY};
    g->hand = hand_for(&g->live.scene);
}

sph2d_status game_open_file(game *g, sph2d_scene_file *file, sph2d_report *report)
{
    live next;
    const sph2d_status status = live_open(&next, file, &g->sim_options, report);
    if (status != SPH2D_OK) {
        for (size_t i = 0; i < report->count; ++i)
            sph2d_scene_file_locate(file, &report->items[i]); /* before the file is gone */
        live_close(&next);
        return status;
    }
    live_close(&g->live);
    g->live = next;
    g->fits_in = 0;
    game_take_scene(g);
    return SPH2D_OK;
}

sph2d_status game_open_text(game *g, const char *text, size_t length, const char *name, sph2d_report *report)
{
    sph2d_scene_file *file = NULL;
    const sph2d_status status =
        sph2d_scene_file_parse(text, length, name, g->options->overrides, g->options->override_count, &file, report);
    if (status != SPH2D_OK) {
        sph2d_scene_file_destroy(file);
        return status;
    }
    sph2d_report_clear(report); /* creating the simulation repeats warnings */
    return game_open_file(g, file, report);
}

static bool has_spacing(const cli_options *options)
{
    size_t k = 0;
    while (k < options->override_count && strcmp(options->overrides[k].path, "spacing") != 0)
        ++k;
    return k < options->override_count;
}

sph2d_status game_open_number(game *g, size_t number, sph2d_report *report)
{
    enum { LOOKED_AT = 10 }; /* pictures */
    const play_scene *from = &play_scenes[number];
    const sph2d_status status = game_open_text(g, from->text, strlen(from->text), from->name, report);
    g->number = number;
    g->fits_in = status == SPH2D_OK && !has_spacing(g->options) ? LOOKED_AT : 0;
    return status;
}

void game_fit(game *g, double part)
{
    static const double most_spacing = 1.5; /* that of the scene: solids have few spacings */
    enum { FEWEST = 1000, MOST = 16384 };
    const double count = (double)sph2d_sim_count(g->live.sim), now = g->live.scene.spacing;
    const double fitting = live_fitting_spacing(&g->live, part);
    if (count < FEWEST || !(fitting > 0)) /* it has not begun: a tap */
        return;
    sph2d_report report = {0};
    const double spacing = fmin(fmax(fitting, now * sqrt(count / MOST)), now * most_spacing);
    const sph2d_status status = live_restart(&g->live, spacing, &report);
    game_tell_report(g, status, &report);
    if (status == SPH2D_OK)
        game_take_scene(g);
}

void game_close(game *g)
{
    live_close(&g->live);
    frame_free(&g->buffers);
}

/* ---- the loop's turns -------------------------------------------------------------------------------------------- */

void game_hand(game *g, const sph2d_renderer *renderer, const play_input *input)
{
    sph2d_report report = {0};
    game_look(g, renderer, input);
    hand_scale(&g->hand, input->scroll);
    g->hand.still = g->paused;
    g->help = g->help && !input->left && !input->right; /* who acts wants to see */
    sph2d_vec2 at;
    if (!sph2d_renderer_locate(renderer, input->x, input->y, &at))
        return;
    game_tell_report(g, hand_move(&g->hand, &g->live, at, input->left, input->right, &report), &report);
    if (g->hand.note[0] != '\0')
        game_tell(g, "%s", g->hand.note);
}

void game_undo(game *g)
{
    if (g->hand.down || g->hand.pushes) {
        game_tell(g, "let go of the mouse to undo");
        return;
    }
    sph2d_report report = {0};
    const char *name;
    const double spacing = g->live.scene.spacing;
    const sph2d_status status = live_undo(&g->live, &name, &report);
    game_tell_report(g, status, &report);
    if (status != SPH2D_OK)
        return;
    if (g->live.scene.spacing != spacing)
        game_take_scene(g);
    if (name)
        game_tell(g, "undone: %s", name);
    else
        game_tell(g, "nothing to undo");
}

/* Tells once that liquid leaves, more than splashes, and again after it was brought back. */
static void tell_leak(game *g)
{
    const uint64_t left = live_left(&g->live);
    const bool leaks = 20 * left > left + sph2d_sim_count(g->live.sim);
    if (leaks && !g->leaks)
        game_tell(g, "liquid leaves through an open side; U undoes, R starts again");
    g->leaks = leaks;
}

void game_tell_steps(game *g, sph2d_status status, sph2d_report *report)
{
    game_tell_report(g, status, report);
    tell_leak(g);
}
