/* SPDX-License-Identifier: MIT */
/** @file grip.c
 *  Bodies under the mouse. */
#include "grip.h"

#include <math.h>
#include <string.h>

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
grip grip_take(const live *l, sph2d_vec2 at)
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
size_t grip_in_way(const live *l, const sph2d_vec2 *corners, size_t count, double thickness)
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
sph2d_status grip_pull(const grip *g, live *l, sph2d_vec2 at)
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

body_move grip_shift(const grip *g, const live *l, sph2d_vec2 at)
{
    const sph2d_hold *hold = &l->scene.bodies[g->body].hold;
    const body_move now = live_body_move(l, g->body);
    const sph2d_vec2 held = grip_place(g, l);
    const bool x = hold->x == SPH2D_SWITCH_ON, y = hold->y == SPH2D_SWITCH_ON;
    body_move shift = {now.to, {now.to.x + (x ? 0 : at.x - held.x), now.to.y + (y ? 0 : at.y - held.y)}, 0};
    if (x && y && hold->angle != SPH2D_SWITCH_ON)
        shift.angle = atan2(at.y - now.to.y, at.x - now.to.x) - atan2(held.y - now.to.y, held.x - now.to.x);
    return shift;
}

sph2d_vec2 grip_place(const grip *g, const live *l)
{
    const body_move now = live_body_move(l, g->body);
    const double c = cos(now.angle - g->angle), s = sin(now.angle - g->angle);
    return (sph2d_vec2){now.to.x + c * g->from.x - s * g->from.y, now.to.y + s * g->from.x + c * g->from.y};
}
