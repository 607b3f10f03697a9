/* SPDX-License-Identifier: MIT */
/** @file turn.c
 *  One turn of the loop around a window or a page. */
#include "turn.h"

#include <math.h>

#include "../clock.h"

/* Pictures a second for which steps are cut short where the machine is slow; but steps have this long in any case [s]. */
static const double WANTED_PICTURES = 34, LEAST_STEPPING = 0.006;

/* The part of the time left by pictures that a scene of play takes for steps at first; a splash takes more. */
static const double STEPPED = 0.6;

/* The longest that is taken for one turn, as after the window was dragged [s]. */
static const double LONGEST_TURN = 0.1;

/* Makes the renderer anew for a window of another size, another style or look. */
static sph2d_status fit_renderer(turning *t, const game *g, const play_input *input, sph2d_gl_loader loader,
                                 sph2d_report *report)
{
    const sph2d_frames *frames = &g->style.frames;
    if (t->renderer && t->width == input->width && t->height == input->height && t->style == frames->style &&
        t->look == frames->look)
        return SPH2D_OK;
    sph2d_renderer_destroy(t->renderer);
    t->renderer = NULL;
    sph2d_render_options options = sph2d_render_options_default();
    options.width = t->width = input->width;
    options.height = t->height = input->height;
    options.style = t->style = frames->style;
    options.look = t->look = frames->look;
    options.shader_dir = g->options->shader_dir;
    options.get_proc_address = loader;
    return sph2d_renderer_create(&options, &t->renderer, report);
}

static void average(double *mean, double value)
{
    *mean += 0.1 * (value - *mean);
}

static void step(void *steps_)
{
    stepping *s = steps_;
    const double begun = clock_wall();
    s->status = live_advance(s->live, s->seconds, s->budget, &s->report);
    s->taken = clock_wall() - begun;
}

/* Begins the steps of a turn; without a thread beside they are then done. */
static void begin_steps(turning *t, game *g, double passed, bool beside)
{
    const double picture = 1 / WANTED_PICTURES;
    t->from = sph2d_sim_time(g->live.sim);
    t->steps = (stepping){.live = &g->live,
                          .seconds = g->paused ? 0 : passed * g->rate,
                          .budget = fmax(beside ? picture : picture - t->drawing, LEAST_STEPPING)};
    t->played += g->paused ? 0 : passed * g->rate;
    if (beside)
        worker_begin(t->worker);
    else
        step(&t->steps);
}

/* What follows once they are done. */
static void end_steps(turning *t, game *g)
{
    if (t->worker)
        worker_wait(t->worker);
    if (!t->steps.live)
        return;
    t->steps.live = NULL;
    t->simulated += fmax(sph2d_sim_time(g->live.sim) - t->from, 0);
    average(&t->stepping, t->steps.taken);
    game_tell_steps(g, t->steps.status, &t->steps.report);
    if (g->fits_in > 0 && --g->fits_in == 0)
        game_fit(g,
                 STEPPED * (t->worker ? 1 : fmax(1 - WANTED_PICTURES * t->drawing, LEAST_STEPPING * WANTED_PICTURES)));
}

sph2d_status turn_take(turning *t, game *g, const play_input *input, sph2d_gl_loader loader, double since,
                       sph2d_report *report)
{
    const double passed = fmin(since, LONGEST_TURN);
    const bool visible = input->width >= 16 && input->height >= 16, beside = visible && t->worker;
    g->hand.down &= input->left; /* a key finds the buttons as they are */
    g->hand.pushes &= input->right;
    if (input->left || input->middle || input->right || input->zoom != 0 ||
        input->key_count > 0) /* nobody's doing is to begin again */
        g->fits_in = 0;
    for (int k = 0; k < input->key_count; ++k)
        game_key(g, input->keys[k]);
    if (visible)
        game_hand(g, t->renderer, input);
    if (beside)
        game_prepare(g, t->pictures);
    begin_steps(t, g, passed, beside);
    if (!beside)
        end_steps(t, g);
    t->draws = clock_wall();
    if (!visible)
        return SPH2D_OK;
    const sph2d_status status = fit_renderer(t, g, input, loader, report);
    if (status != SPH2D_OK)
        return status;
    if (!beside)
        game_prepare(g, t->pictures);
    game_draw(g, t->renderer, t->width, t->height);
    return SPH2D_OK;
}

void turn_beside(turning *t)
{
    t->worker = worker_start(step, &t->steps);
}

void turn_shown(turning *t, game *g)
{
    const double now = clock_wall();
    average(&t->drawing, now - t->draws);
    ++t->shown;
    if (t->counted == 0)
        t->counted = now;
    if (now - t->counted >= 1) {
        t->pictures = (double)(t->shown - t->shown_then) / (now - t->counted);
        t->counted = now;
        t->shown_then = t->shown;
    }
    end_steps(t, g);
}

void turn_end(turning *t, game *g)
{
    end_steps(t, g);
    worker_stop(t->worker);
    t->worker = NULL;
    sph2d_renderer_destroy(t->renderer);
    t->renderer = NULL;
}
