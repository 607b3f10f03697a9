/* SPDX-License-Identifier: MIT */
/** @file forcing.c
 *  What acts at a time: interactions, the pointer, moving obstacles. */
#include <math.h>

#include "base/pi.h"
#include "sim/simulation.h"

/** Place on a path at a time; false before its start and after its end. */
static bool on_path(const sph2d_path *path, double time, sph2d_vec2 *at)
{
    const sph2d_path_point *p = path->items;
    if (path->count == 1) {
        *at = (sph2d_vec2){p[0].x, p[0].y};
        return true;
    }
    for (size_t k = 1; k < path->count; ++k) {
        if (time < p[k - 1].t || time > p[k].t)
            continue;
        double f = (time - p[k - 1].t) / (p[k].t - p[k - 1].t);
        *at = (sph2d_vec2){p[k - 1].x + f * (p[k].x - p[k - 1].x), p[k - 1].y + f * (p[k].y - p[k - 1].y)};
        return true;
    }
    return false;
}

/** Displacement, velocity and acceleration of a motion at a time. */
static void follow(const sph2d_motion *motion, double time, sph2d_vec2 *at, sph2d_vec2 *v, sph2d_vec2 *a)
{
    double omega = 2 * SPH2D__PI * motion->frequency, angle = omega * time + motion->phase;
    double way = sin(angle) - sin(motion->phase), speed = omega * cos(angle), push = -omega * omega * sin(angle);
    *at = (sph2d_vec2){motion->amplitude.x * way, motion->amplitude.y * way};
    *v = (sph2d_vec2){motion->amplitude.x * speed, motion->amplitude.y * speed};
    *a = (sph2d_vec2){motion->amplitude.x * push, motion->amplitude.y * push};
    const sph2d_path *path = &motion->path;
    if (path->count == 0)
        return;
    const sph2d_path_point *last = &path->items[path->count - 1];
    sph2d_vec2 place = {time < path->items[0].t ? path->items[0].x : last->x,
                        time < path->items[0].t ? path->items[0].y : last->y};
    for (size_t k = 1; k < path->count; ++k) {
        const sph2d_path_point *p = &path->items[k - 1], *q = &path->items[k];
        if (time < p->t || time >= q->t)
            continue;
        sph2d_vec2 slope = {(q->x - p->x) / (q->t - p->t), (q->y - p->y) / (q->t - p->t)};
        place = (sph2d_vec2){p->x + (time - p->t) * slope.x, p->y + (time - p->t) * slope.y};
        v->x += slope.x;
        v->y += slope.y;
        break;
    }
    at->x += place.x;
    at->y += place.y;
}

void sph2d__sim_set_drift_interval(sph2d_sim *sim, double from, double to)
{
    for (size_t k = 0; k < sim->moving_count; ++k) {
        sph2d__moving *m = &sim->moving[k];
        sph2d_vec2 v, a;
        follow(m->motion, from, &m->from, &v, &a);
        follow(m->motion, to, &m->to, &v, &a);
        double span = to - from; /* below 0 in the stages of a scheme that goes back */
        m->velocity = (sph2d_vec2){(m->to.x - m->from.x) / span, (m->to.y - m->from.y) / span};
    }
}

/** Sorts the boundary particles from the order of their ids, so that the outcome is theirs alone and not that of their
 *  way. */
static bool sort_walls(sph2d__system *s)
{
    for (size_t i = 0; i < s->walls.count; ++i)
        s->wall_cells.order[s->walls.id[i]] = (uint32_t)i;
    sph2d__store_reorder(&s->walls, s->wall_cells.order, NULL);
    return sph2d__cells_build(&s->wall_cells, &s->walls, s->wall_reach, s->memory, NULL);
}

/** Puts the boundary particles of moving obstacles to where they are at a time, with their velocity and acceleration.
 */
static void move_bodies(sph2d_sim *sim, double time)
{
    sph2d__store *w = &sim->system.walls;
    const sph2d__period *period = &sim->system.wall_cells.period;
    for (size_t k = 0; k < sim->moving_count; ++k) {
        const sph2d__moving *m = &sim->moving[k];
        sph2d_vec2 at, v, a;
        follow(m->motion, time, &at, &v, &a);
        for (size_t i = 0; i < w->count; ++i)
            if (w->id[i] >= m->first_id && w->id[i] < m->end_id) {
                w->x[i] = sph2d__period_wrap(w->start_x[i] + at.x, period->low_x, period->length_x);
                w->y[i] = sph2d__period_wrap(w->start_y[i] + at.y, period->low_y, period->length_y);
                w->vx[i] = v.x;
                w->vy[i] = v.y;
                w->ax[i] = a.x;
                w->ay[i] = a.y;
            }
    }
}

sph2d_status sph2d__sim_update_forcing(sph2d_sim *sim, double time)
{
    const sph2d__record *r = &sim->record;
    sph2d__body *body = &sim->system.body;
    size_t count = 0;
    for (size_t i = 0; i < sim->scene.interaction_count; ++i) {
        const sph2d_interaction *force = &sim->scene.interactions[i];
        sph2d_vec2 at;
        if (on_path(&force->path, time, &at))
            sim->points[count++] = (sph2d__point_force){at.x, at.y, force->radius, force->acceleration};
    }
    if (r->pointer_acceleration != 0)
        sim->points[count++] =
            (sph2d__point_force){r->pointer_x, r->pointer_y, r->pointer_radius, r->pointer_acceleration};
    body->points = sim->points;
    body->point_count = count;
    body->gravity_x = r->gravity_x;
    body->gravity_y = r->gravity_y;
    if (sim->moving_count == 0)
        return SPH2D_OK;
    move_bodies(sim, time);
    if (!sort_walls(&sim->system))
        return SPH2D_NOMEM;
    if (sim->method->walls_placed)
        sim->method->walls_placed(&sim->system);
    return SPH2D_OK;
}
