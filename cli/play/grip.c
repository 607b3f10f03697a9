/* SPDX-License-Identifier: MIT */
/** @file grip.c
 *  A body that the mouse holds: it is where a body's outline has the mouse inside, and its velocity is set anew in each
 *  turn, so that what the liquid and other bodies do to it counts in between. */
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

grip grip_take(const live *l, sph2d_vec2 at)
{
    const sph2d_array places = outline_field(l->sim, "Coordinates"), walls = outline_field(l->sim, "WallIDs");
    if (!places.name || !walls.name)
        return (grip){0};
    const double *x = places.data[0], *y = places.data[1];
    const uint64_t *wall = walls.data[0];
    const size_t first = l->scene.obstacle_count;
    for (size_t from = 0, to = 0; from < places.count; from = to) {
        while (to < places.count && wall[to] == wall[from])
            ++to;
        if (wall[from] == UINT64_MAX || wall[from] < first || !is_inside(x + from, y + from, to - from, at))
            continue;
        const size_t body = (size_t)wall[from] - first;
        const sph2d_body_state now = sph2d_sim_body(l->sim, body);
        return (grip){true, body, {at.x - now.center.x, at.y - now.center.y}, now.angle};
    }
    return (grip){0};
}

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
