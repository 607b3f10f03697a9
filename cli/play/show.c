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
#include "sketch.h"

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
             g->style.name ? g->style.name : "", sph2d_sim_time(l->sim), pace, sph2d_sim_count(l->sim), left, pictures,
             hand_name(g->hand.tool), g->recording[0] ? "   filming" : "");
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

/** Outlines that are added to a picture. */
typedef struct marks {
    frame_buffers *buffers;
    size_t count;
    uint64_t next; /**< the number of the next outline */
} marks;

/* Corners of a circle, and of a shape at most. */
enum { CIRCLE = 49, SHOWN_CORNERS = 256 };

static void add_corner(marks *m, sph2d_vec2 at, sph2d_outline_liquid liquid)
{
    m->buffers->outline_x[m->count] = at.x;
    m->buffers->outline_y[m->count] = at.y;
    m->buffers->outline_id[m->count] = m->next;
    m->buffers->outline_liquid[m->count++] = liquid;
}

static void add_outline(marks *m, const sph2d_vec2 *corners, size_t count, sph2d_outline_liquid liquid)
{
    for (size_t k = 0; k < count; ++k)
        add_corner(m, corners[k], liquid);
    ++m->next;
}

static void add_circle(marks *m, sph2d_vec2 center, double radius)
{
    for (size_t k = 0; k < CIRCLE; ++k) {
        const double angle = 6.283185307179586 * (double)(k % (CIRCLE - 1)) / (CIRCLE - 1);
        add_corner(m, (sph2d_vec2){center.x + radius * cos(angle), center.y + radius * sin(angle)},
                   SPH2D_OUTLINE_LIQUID_BOTH);
    }
    ++m->next;
}

/* The wall that is drawn, as thick as it will be. */
static void add_wall(marks *m, const live *l, const hand *h)
{
    const double thickness = live_wall_thickness(l);
    const drawn_line line = live_divide(l, h->corners, h->corner_count);
    for (size_t k = 0; k < line.pieces; ++k) {
        sph2d_vec2 corners[2 * DRAWN_MOST_CORNERS];
        const size_t all = drawn_solid(&line, k, thickness, 0, corners);
        add_outline(m, corners, thickness > 0 ? all : all / 2,
                    thickness > 0 ? SPH2D_OUTLINE_LIQUID_OUTSIDE : SPH2D_OUTLINE_LIQUID_BOTH);
    }
}

/* The outline of a shape as a line, after a move if that is given. */
static void add_shape(marks *m, const live *l, const sph2d_shape *shape, const body_move *from, const body_move *then)
{
    sph2d_vec2 corners[SHOWN_CORNERS + 1];
    double piece = l->scene.spacing;
    while (sph2d_shape_corners(shape, piece, NULL) > SHOWN_CORNERS && shape->kind == SPH2D_SHAPE_CIRCLE)
        piece *= 2;
    const size_t count = sph2d_shape_corners(shape, piece, NULL);
    if (count == 0 || count > SHOWN_CORNERS)
        return;
    sph2d_shape_corners(shape, piece, corners);
    for (size_t k = 0; from && k < count; ++k)
        corners[k] = body_moved(then, body_moved(from, corners[k]));
    corners[count] = corners[0];
    add_outline(m, corners, count + 1, SPH2D_OUTLINE_LIQUID_BOTH);
}

/* Springs as lines to the points that do not move; a hinge is such a point. */
static void add_springs(marks *m, const live *l)
{
    for (size_t k = 0; k < l->scene.body_count; ++k)
        for (size_t i = 0; i < l->scene.bodies[k].spring_count; ++i) {
            const sph2d_spring *s = &l->scene.bodies[k].springs[i];
            const sph2d_vec2 line[2] = {live_spring_end(l, k, i), s->to};
            if (s->length > 0)
                add_outline(m, line, 2, SPH2D_OUTLINE_LIQUID_BOTH);
            add_circle(m, s->to, l->scene.spacing);
        }
}

/* What the hand is about to do: the reach while it acts, what it draws, where it puts a body. */
static void add_hand(marks *m, const live *l, const hand *h)
{
    sph2d_shape shape;
    const sph2d_vec2 line[2] = {h->grip.holds ? grip_place(&h->grip, l) : h->at, h->at};
    if ((h->down || h->pushes) && h->tool < HAND_WALL && !h->grip.holds)
        add_circle(m, h->at, h->radius);
    if (h->tool == HAND_WALL && h->corner_count > 1)
        add_wall(m, l, h);
    if (h->tool == HAND_HOLD && h->grip.holds)
        add_outline(m, line, 2, SPH2D_OUTLINE_LIQUID_BOTH);
    if (sketch_shape(h, l, &shape))
        add_shape(m, l, &shape, NULL, NULL);
    if (h->tool == HAND_PULL && h->grip.holds && h->still) {
        const body_move now = live_body_move(l, h->grip.body), then = grip_shift(&h->grip, l, h->at);
        add_shape(m, l, &l->scene.bodies[h->grip.body].shape, &now, &then);
    }
}

/* Adds lines that are in no simulation. */
static sph2d_status add_marks(game *g, sph2d_picture *picture)
{
    size_t springs = 0;
    for (size_t k = 0; k < g->live.scene.body_count; ++k)
        springs += g->live.scene.bodies[k].spring_count;
    const size_t most = CIRCLE + 4 * DRAWN_MOST_CORNERS + SHOWN_CORNERS + (CIRCLE + 2) * (springs + 1);
    if (!frame_reserve_corners(&g->buffers, picture, most))
        return SPH2D_NOMEM;
    const size_t count = picture->outline_count;
    marks m = {&g->buffers, count, count > 0 ? g->buffers.outline_id[count - 1] + 1 : 0};
    add_springs(&m, &g->live);
    add_hand(&m, &g->live, &g->hand);
    picture->outline_count = m.count;
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
        status = add_marks(g, &picture);
    picture.caption = g->caption;
    picture.notes = g->notes[0] != '\0' ? g->notes : NULL;
    g->picture = picture;
    g->picture_time = sph2d_sim_time(g->live.sim);
    g->prepared = status == SPH2D_OK;
    game_tell_report(g, status, &report);
}

void game_draw(game *g, sph2d_renderer *renderer, unsigned width, unsigned height)
{
    if (!g->prepared)
        return;
    sph2d_report report = {0};
    game_film_frame(g, renderer, width, height);
    game_tell_report(g, sph2d_renderer_draw_to(renderer, 0, 0, 0, &g->picture, &report), &report);
}
