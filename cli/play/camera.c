/* SPDX-License-Identifier: MIT */
/** @file camera.c
 *  What part of the plane is shown. */
#include <math.h>

#include "game.h"

/* The smallest view [spacings across], and the largest, over the domain. */
static const double LEAST = 10, MOST = 4;

/* The view of the picture with a place of it where it is, `factor` times as large on the screen. */
static void zoom(game *g, sph2d_vec2 at, double factor)
{
    const sph2d_box now = g->picture.view, d = g->live.scene.domain;
    const double width = now.max.x - now.min.x, height = now.max.y - now.min.y;
    const double least = LEAST * g->live.scene.spacing / fmin(width, height);
    const double most = MOST * fmax((d.max.x - d.min.x) / width, (d.max.y - d.min.y) / height);
    const double size = fmin(fmax(1 / factor, fmin(least, 1)), fmax(most, 1));
    g->style.frames.view = (sph2d_box){{at.x + size * (now.min.x - at.x), at.y + size * (now.min.y - at.y)},
                                       {at.x + size * (now.max.x - at.x), at.y + size * (now.max.y - at.y)}};
}

/* The view with the plane moved. */
static void pan(game *g, sph2d_vec2 by)
{
    const sph2d_box now = g->picture.view;
    g->style.frames.view = (sph2d_box){{now.min.x - by.x, now.min.y - by.y}, {now.max.x - by.x, now.max.y - by.y}};
    g->style.frames.follow = NULL;
}

void game_look(game *g, const sph2d_renderer *renderer, const play_input *input)
{
    sph2d_vec2 at, from;
    const bool pans = input->middle && g->pans;
    if (g->prepared && sph2d_renderer_locate(renderer, input->x, input->y, &at) &&
        sph2d_renderer_locate(renderer, g->mouse.x, g->mouse.y, &from)) {
        if (pans && (at.x != from.x || at.y != from.y)) {
            pan(g, (sph2d_vec2){at.x - from.x, at.y - from.y});
            g->picture.view = g->style.frames.view; /* what is zoomed then */
        }
        if (input->zoom != 0)
            zoom(g, pans ? from : at, pow(1.1, input->zoom));
    }
    g->pans = input->middle;
    g->mouse = (sph2d_vec2){input->x, input->y};
}

void game_look_home(game *g)
{
    const sph2d_frames *own = &g->live.scene.run.frames;
    g->style.frames.view = own->view;
    g->style.frames.follow = own->follow;
}
