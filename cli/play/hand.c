/* SPDX-License-Identifier: MIT */
/** @file hand.c
 *  What the mouse does. */
#include "hand.h"

#include <math.h>
#include <stdio.h>

#include "sketch.h"

/* ---- the hand ---------------------------------------------------------------------------------------------------- */

/* The reach at first, of the smaller side of the domain; and its acceleration at first over what makes liquid fall over
 * that side in a second, or over gravity if that is more. */
static const double REACH = 0.12, STRENGTH = 5;

static double smaller_side(const sph2d_scene *scene)
{
    const sph2d_box *d = &scene->domain;
    return fmin(d->max.x - d->min.x, d->max.y - d->min.y);
}

hand hand_for(const sph2d_scene *scene)
{
    return (hand){.radius = fmax(REACH * smaller_side(scene), 3 * scene->spacing), .density = 0.5};
}

const char *hand_name(hand_tool tool)
{
    static const char *const names[] = {"pull", "push", "pour", "wipe", "wall", "circle", "box", "outline", "hold"};
    return names[tool];
}

void hand_take(hand *h, hand_tool tool)
{
    h->tool = tool;
    h->corner_count = 0;
    h->grip = (grip){0};
}

void hand_scale(hand *h, double steps)
{
    h->radius *= pow(1.1, steps);
}

/* Fills the reach with liquid, on a lattice that stays in place while the hand moves. */
static sph2d_status fill(const hand *h, live *l)
{
    enum { MOST = 4096 };
    static sph2d_particle drops[MOST];
    const double dx = l->scene.spacing;
    size_t count = 0;
    for (double y = floor((h->at.y - h->radius) / dx); y * dx < h->at.y + h->radius && count < MOST; ++y)
        for (double x = floor((h->at.x - h->radius) / dx); x * dx < h->at.x + h->radius && count < MOST; ++x) {
            const sph2d_particle drop = {.x = (x + 0.5) * dx, .y = (y + 0.5) * dx, .color = l->nozzle.color};
            if (hypot(drop.x - h->at.x, drop.y - h->at.y) < h->radius)
                drops[count++] = drop;
        }
    return sph2d_sim_add_particles(l->sim, drops, count, NULL);
}

/* A jet as wide as the reach; while time stands still it would not come, and all is filled. */
static sph2d_status pour(const hand *h, live *l, sph2d_report *report)
{
    const sph2d_status status = l->nozzle.color > 0 ? live_give_colors(l, report) : SPH2D_OK;
    if (status != SPH2D_OK)
        return status;
    if (h->still)
        return fill(h, l);
    nozzle_open(&l->nozzle, &l->scene, l->sim, h->at, 2 * h->radius);
    return SPH2D_OK;
}

static sph2d_status wipe(const hand *h, live *l)
{
    const sph2d_shape shape = {.kind = SPH2D_SHAPE_CIRCLE, .circle = {h->at, h->radius}};
    return sph2d_sim_remove_particles(l->sim, &shape, NULL);
}

static bool is_far(const hand *h, const live *l, size_t corner)
{
    const sph2d_vec2 from = h->corners[corner];
    return hypot(h->at.x - from.x, h->at.y - from.y) > fmax(live_wall_thickness(l), l->scene.spacing);
}

static sph2d_status erase_wall(hand *h, live *l, sph2d_report *report)
{
    bool found;
    const sph2d_status status = live_remove_wall(l, h->at, &found, report);
    if (status == SPH2D_OK)
        snprintf(h->note, sizeof h->note, found ? "wall taken away" : "no wall was drawn here");
    return status;
}

/* Adds a corner where the hand is as far from the last one as the wall is thick, so that it can be mitred, and makes the wall
 * when the hand is lifted: it ends there. */
static sph2d_status draw_wall(hand *h, live *l, bool down, sph2d_report *report)
{
    if (!down && h->corner_count == 0)
        return SPH2D_OK;
    if ((h->corner_count == 0 || is_far(h, l, h->corner_count - 1)) && h->corner_count < DRAWN_MOST_CORNERS)
        h->corners[h->corner_count++] = h->at;
    if (down)
        return SPH2D_OK;
    if (h->corner_count > 1 && h->corner_count < DRAWN_MOST_CORNERS && is_far(h, l, h->corner_count - 2))
        h->corners[h->corner_count - 1] = h->at;
    const size_t count = h->corner_count;
    size_t removed = 0;
    h->corner_count = 0;
    if (count < 2)
        return erase_wall(h, l, report);
    const size_t body = grip_in_way(l, h->corners, count, live_wall_thickness(l));
    if (body != SIZE_MAX) {
        const char *name = l->scene.bodies[body].name;
        snprintf(h->note, sizeof h->note, "no wall: it would go through %.40s", name ? name : "a body");
        return SPH2D_OK;
    }
    live_remember(l, "wall");
    const sph2d_status status = live_add_wall(l, h->corners, count, &removed, report);
    if (status != SPH2D_OK)
        past_drop(&l->past);
    else if (removed > 0)
        snprintf(h->note, sizeof h->note, "the wall took the place of %zu particles; U brings them back", removed);
    return status;
}

/* What the tool draws, while the button is down and when it comes up; and what the right one takes away. */
static sph2d_status draw(hand *h, live *l, bool down, bool erases, sph2d_report *report)
{
    const sph2d_status status = h->tool == HAND_WALL   ? draw_wall(h, l, down, report)
                                : h->tool == HAND_HOLD ? sketch_hold(h, l, down, report)
                                                       : sketch_body(h, l, down, report);
    if (status != SPH2D_OK || !erases)
        return status;
    return h->tool == HAND_WALL ? erase_wall(h, l, report) : sketch_erase(h, l, report);
}

/* Pulls liquid, or the body that is held: while time stands still that is put where it is let go. */
static sph2d_status pull(hand *h, live *l, bool down, sph2d_report *report)
{
    if (!h->grip.holds || (down && h->still))
        return SPH2D_OK;
    return down ? grip_pull(&h->grip, l, h->at) : h->still ? sketch_put(h, l, report) : SPH2D_OK;
}

sph2d_status hand_move(hand *h, live *l, sph2d_vec2 at, bool left, bool right, sph2d_report *report)
{
    const bool pressed = left && !h->down, pushed = right && !h->pushes, draws = h->tool >= HAND_WALL;
    h->note[0] = '\0';
    h->at = at;
    h->down = left;
    h->pushes = right;
    if (pressed && h->tool == HAND_PULL)
        h->grip = grip_take(l, at);
    const sph2d_vec2 g = l->scene.gravity;
    const double strength = STRENGTH * fmax(hypot(g.x, g.y), smaller_side(&l->scene));
    const bool pushes = (right && !draws) || (left && h->tool == HAND_PUSH);
    const double acts = pushes ? -strength : left && h->tool == HAND_PULL && !h->grip.holds ? strength : 0;
    if (l->stopped != SPH2D_OK)
        return SPH2D_OK;
    if ((pressed || pushed) && !draws)
        live_remember(l, pushed ? "push" : h->grip.holds ? "move" : hand_name(h->tool));
    sph2d_status status = sph2d_sim_set_pointer(l->sim, at, h->radius, acts);
    if (status == SPH2D_OK && h->tool == HAND_PULL)
        status = pull(h, l, left, report);
    if (status == SPH2D_OK && left && h->tool == HAND_POUR)
        status = pour(h, l, report);
    if (status == SPH2D_OK && left && h->tool == HAND_WIPE)
        status = wipe(h, l);
    if (status == SPH2D_OK && draws)
        status = draw(h, l, left, pushed, report);
    if (!left)
        h->grip = (grip){0};
    return status;
}
