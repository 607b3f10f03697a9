/* SPDX-License-Identifier: MIT */
/** @file show.c
 *  The picture of what is played, and the frames of a film. */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../clock.h"
#include "game.h"

/* How long a message is shown [s]. */
static const double message_time = 4;

/* The line below the picture. */
static void write_caption(const game *g, double pictures, char *out, size_t size)
{
    const live *l = &g->live;
    char pace[64], left[40] = "";
    if (live_left(l) > 0)
        snprintf(left, sizeof left, ", %" PRIu64 " left", live_left(l));
    if (l->stopped != SPH2D_OK)
        snprintf(pace, sizeof pace, "stopped; R starts again");
    else if (g->paused)
        snprintf(pace, sizeof pace, "paused");
    else
        snprintf(pace, sizeof pace, "%.2f x the clock", g->rate * l->ratio);
    snprintf(out, size, "%.40s   t = %.2f s   %s   %zu particles%s   %.0f pictures/s   %s%s",
             g->style.name ? g->style.name : "", sph2d_sim_time(l->sim), pace, sph2d_sim_fluid(l->sim).count, left,
             pictures, hand_name(g->hand.tool), g->recording[0] ? "   filming" : "");
}

/* Makes the picture, with a range of colours that only widens. */
static sph2d_status make_picture(game *g, sph2d_picture *picture, sph2d_report *report)
{
    const particle_source source = {.sim = g->live.sim};
    frame_style style = g->style;
    if (style.frames.color && style.frames.color_range.x == 0 && style.frames.color_range.y == 0) {
        sph2d_status status = frame_widen_range(&source, &style, &g->buffers, &g->color_range, report);
        if (status != SPH2D_OK)
            return status;
        if (g->color_range.x < g->color_range.y)
            style.frames.color_range = g->color_range;
    }
    return frame_make(&source, &style, &g->buffers, picture, report);
}

/* Adds the reach of the hand while it acts, as a line, and the wall that it draws, as thick as it will be. */
static sph2d_status add_hand(game *g, sph2d_picture *picture)
{
    enum { CIRCLE = 49 };
    const hand *h = &g->hand;
    const double thickness = live_wall_thickness(&g->live);
    if (!frame_reserve_corners(&g->buffers, picture, CIRCLE + 4 * DRAWN_MOST_CORNERS))
        return SPH2D_NOMEM;
    double *x = g->buffers.outline_x, *y = g->buffers.outline_y;
    uint64_t *id = g->buffers.outline_id, *liquid = g->buffers.outline_liquid;
    size_t count = picture->outline_count;
    const uint64_t next = count > 0 ? id[count - 1] + 1 : 0;
    for (size_t k = 0; k < CIRCLE && (h->down || h->pushes) && h->tool != HAND_WALL && !h->grip.holds; ++k, ++count) {
        const double angle = 6.283185307179586 * (double)(k % (CIRCLE - 1)) / (CIRCLE - 1);
        x[count] = h->at.x + h->radius * cos(angle);
        y[count] = h->at.y + h->radius * sin(angle);
        id[count] = next;
        liquid[count] = SPH2D_OUTLINE_LIQUID_BOTH;
    }
    const drawn_line line = h->corner_count > 1 ? live_divide(&g->live, h->corners, h->corner_count) : (drawn_line){0};
    for (size_t k = 0; k < line.pieces; ++k) {
        sph2d_vec2 corners[2 * DRAWN_MOST_CORNERS];
        const size_t all = drawn_solid(&line, k, thickness, 0, corners), shown = thickness > 0 ? all : all / 2;
        for (size_t i = 0; i < shown; ++i, ++count) {
            x[count] = corners[i].x;
            y[count] = corners[i].y;
            id[count] = next + 1 + k;
            liquid[count] = thickness > 0 ? SPH2D_OUTLINE_LIQUID_OUTSIDE : SPH2D_OUTLINE_LIQUID_BOTH;
        }
    }
    picture->outline_count = count;
    return SPH2D_OK;
}

void game_prepare(game *g, double pictures)
{
    sph2d_report report = {0};
    sph2d_picture picture;
    sph2d_status status = make_picture(g, &picture, &report);
    write_caption(g, pictures, g->caption, sizeof g->caption);
    const bool fresh = g->message[0] != '\0' && clock_wall() - g->told < message_time;
    const char *const told = g->told_elsewhere ? "" : fresh ? g->message : g->live.why;
    snprintf(g->notes, sizeof g->notes, "%s%s%s", told, told[0] != '\0' && g->help ? "\n" : "",
             g->help ? game_help : "");
    if (status == SPH2D_OK)
        status = add_hand(g, &picture);
    picture.caption = g->caption;
    picture.notes = g->notes[0] != '\0' ? g->notes : NULL;
    g->picture = picture;
    g->picture_time = sph2d_sim_time(g->live.sim);
    g->prepared = status == SPH2D_OK;
    game_tell_report(g, status, &report);
}

void game_draw(game *g, sph2d_renderer *renderer)
{
    if (!g->prepared)
        return;
    sph2d_report report = {0};
    game_film_frame(g, renderer);
    game_tell_report(g, sph2d_renderer_draw_to(renderer, 0, 0, 0, &g->picture, &report), &report);
}
