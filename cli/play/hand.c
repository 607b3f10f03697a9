/* SPDX-License-Identifier: MIT */
/** @file hand.c
 *  What the mouse does to the liquid. */
#include "hand.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- the body that is held --------------------------------------------------------------------------------------- */

/* The time in which a body comes to the hand [s], and its speed at most, in smaller sides of the domain a second. */
static const double REACHED_IN = 0.08, FASTEST = 6;

static sph2d_array outline_field(const sph2d_sim *sim, const char *name)
{
    for (size_t i = 0; i < sph2d_field_count(SPH2D_GROUP_OUTLINE); ++i) {
        const sph2d_array field = sph2d_field(sim, SPH2D_GROUP_OUTLINE, i);
        if (strcmp(field.name, name) == 0)
            return field;
    }
    return (sph2d_array){0};
}

/* Whether a place is inside the corners of one outline: by the sides that a ray to the right crosses. */
static bool is_inside(const double *x, const double *y, size_t count, sph2d_vec2 p)
{
    bool inside = false;
    for (size_t k = 0, j = count - 1; k < count; j = k++)
        if ((y[k] > p.y) != (y[j] > p.y) && p.x < x[k] + (p.y - y[k]) / (y[j] - y[k]) * (x[j] - x[k]))
            inside = !inside;
    return inside;
}

/* The outline of a body where it is now: corners from `from` up to `to`. */
typedef struct body_outline {
    const double *x, *y;
    size_t from, to, body;
} body_outline;

/* The next outline of a body after one, which starts with {0}; false after the last. */
static bool next_outline(const live *l, body_outline *o)
{
    const sph2d_array places = outline_field(l->sim, "Coordinates"), walls = outline_field(l->sim, "WallIDs");
    const uint64_t *wall = walls.data[0];
    o->x = places.data[0];
    o->y = places.data[1];
    while (places.name && walls.name && o->to < places.count) {
        o->from = o->to;
        while (o->to < places.count && wall[o->to] == wall[o->from])
            ++o->to;
        o->body = (size_t)wall[o->from] - l->scene.obstacle_count;
        if (wall[o->from] != UINT64_MAX && wall[o->from] >= l->scene.obstacle_count)
            return true;
    }
    return false;
}

/* Takes the body at a place, if there is one. */
static grip grip_take(const live *l, sph2d_vec2 at)
{
    body_outline o = {0};
    while (next_outline(l, &o))
        if (is_inside(o.x + o.from, o.y + o.from, o.to - o.from, at)) {
            const sph2d_body_state now = sph2d_sim_body(l->sim, o.body);
            return (grip){true, o.body, {at.x - now.center.x, at.y - now.center.y}, now.angle};
        }
    return (grip){0};
}

/* A body, where it is now, through which a line of this thickness [m] would go; SIZE_MAX for none. */
static size_t grip_in_way(const live *l, const sph2d_vec2 *corners, size_t count, double thickness)
{
    body_outline o = {0};
    while (next_outline(l, &o)) {
        bool hit = is_inside(o.x + o.from, o.y + o.from, o.to - o.from, corners[0]);
        for (size_t k = o.from, j = o.to - 1; k < o.to && !hit; j = k++) {
            const sph2d_vec2 side[2] = {{o.x[j], o.y[j]}, {o.x[k], o.y[k]}};
            for (size_t i = 0; i + 1 < count && !hit; ++i)
                hit = drawn_near(side, corners + i, thickness / 2);
        }
        if (hit)
            return o.body;
    }
    return SIZE_MAX;
}

/* Lets the body follow the hand for the next steps, by its velocity. Errors: as sph2d_sim_set_body_velocity. */
static sph2d_status grip_pull(const grip *g, live *l, sph2d_vec2 at)
{
    const sph2d_body_state now = sph2d_sim_body(l->sim, g->body);
    const double c = cos(now.angle - g->angle), s = sin(now.angle - g->angle);
    const double x = at.x - now.center.x - c * g->from.x + s * g->from.y,
                 y = at.y - now.center.y - s * g->from.x - c * g->from.y;
    const sph2d_box *d = &l->scene.domain;
    const double most = FASTEST * fmin(d->max.x - d->min.x, d->max.y - d->min.y), speed = hypot(x, y) / REACHED_IN;
    const double part = (speed > most ? most / speed : 1) / REACHED_IN;
    const sph2d_hold *hold = &l->scene.bodies[g->body].hold;
    const double rx = at.x - now.center.x, ry = at.y - now.center.y, r2 = rx * rx + ry * ry;
    const bool turns = hold->x == SPH2D_SWITCH_ON && hold->y == SPH2D_SWITCH_ON && r2 > 0; /* a wheel on its axle */
    const double rate = turns ? part * (rx * y - ry * x) / r2 : now.rate;
    return sph2d_sim_set_body_velocity(l->sim, g->body, (sph2d_vec2){part * x, part * y}, rate);
}

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
    return (hand){.radius = fmax(REACH * smaller_side(scene), 3 * scene->spacing)};
}

const char *hand_name(hand_tool tool)
{
    static const char *const names[] = {"pull", "pour", "wipe", "wall"};
    return names[tool];
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
            const sph2d_particle drop = {.x = (x + 0.5) * dx, .y = (y + 0.5) * dx};
            if (hypot(drop.x - h->at.x, drop.y - h->at.y) < h->radius)
                drops[count++] = drop;
        }
    return sph2d_sim_add_particles(l->sim, drops, count, NULL);
}

/* A jet as wide as the reach; while time stands still it would not come, and all is filled. */
static sph2d_status pour(const hand *h, live *l)
{
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
        return SPH2D_OK;
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

static sph2d_status erase_wall(hand *h, live *l, sph2d_report *report)
{
    bool found;
    const sph2d_status status = live_remove_wall(l, h->at, &found, report);
    if (status == SPH2D_OK)
        snprintf(h->note, sizeof h->note, found ? "wall taken away" : "no wall was drawn here");
    return status;
}

sph2d_status hand_move(hand *h, live *l, sph2d_vec2 at, bool left, bool right, sph2d_report *report)
{
    const bool pressed = left && !h->down, pushed = right && !h->pushes, draws = h->tool == HAND_WALL;
    h->note[0] = '\0';
    h->at = at;
    h->down = left;
    h->pushes = right;
    if (!left || h->tool != HAND_PULL)
        h->grip = (grip){0};
    else if (pressed)
        h->grip = grip_take(l, at);
    const sph2d_vec2 g = l->scene.gravity;
    const double strength = STRENGTH * fmax(hypot(g.x, g.y), smaller_side(&l->scene));
    const double pull = right && !draws ? -strength : left && h->tool == HAND_PULL && !h->grip.holds ? strength : 0;
    if (l->stopped != SPH2D_OK)
        return SPH2D_OK;
    if ((pressed || pushed) && !draws)
        live_remember(l, pushed ? "push" : h->grip.holds ? "move" : hand_name(h->tool));
    sph2d_status status = sph2d_sim_set_pointer(l->sim, at, h->radius, pull);
    if (status == SPH2D_OK && h->grip.holds)
        status = grip_pull(&h->grip, l, at);
    if (status == SPH2D_OK && left && h->tool == HAND_POUR)
        status = pour(h, l);
    if (status == SPH2D_OK && left && h->tool == HAND_WIPE)
        status = wipe(h, l);
    if (status == SPH2D_OK && draws)
        status = draw_wall(h, l, left, report);
    if (status == SPH2D_OK && draws && pushed)
        status = erase_wall(h, l, report);
    return status;
}
