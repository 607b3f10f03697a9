/* SPDX-License-Identifier: MIT */
/** @file pose.c */
#include "boundary/pose.h"

#include <math.h>

#include "base/pi.h"

bool sph2d__motion_moves(const sph2d_motion *m)
{
    return m->path.count > 0 || (m->frequency > 0 && (m->amplitude.x != 0 || m->amplitude.y != 0));
}

/** Adds the displacement and velocity of a path; before its start and after its end it is at rest. */
static void add_path(const sph2d_path *path, double time, sph2d__pose *pose)
{
    const sph2d_path_point *last = &path->items[path->count - 1];
    sph2d_vec2 position = {time < path->items[0].t ? path->items[0].x : last->x,
                           time < path->items[0].t ? path->items[0].y : last->y};
    for (size_t k = 1; k < path->count; ++k) {
        const sph2d_path_point *p = &path->items[k - 1], *q = &path->items[k];
        if (time < p->t || time >= q->t)
            continue;
        sph2d_vec2 slope = {(q->x - p->x) / (q->t - p->t), (q->y - p->y) / (q->t - p->t)};
        position = (sph2d_vec2){p->x + (time - p->t) * slope.x, p->y + (time - p->t) * slope.y};
        pose->velocity.x += slope.x;
        pose->velocity.y += slope.y;
        break;
    }
    pose->displacement.x += position.x;
    pose->displacement.y += position.y;
}

sph2d__pose sph2d__pose_at(const sph2d_motion *motion, double time)
{
    double omega = 2 * SPH2D__PI * motion->frequency, angle = omega * time + motion->phase;
    double swing = sin(angle) - sin(motion->phase), rate = omega * cos(angle),
           acceleration = -omega * omega * sin(angle);
    const sph2d_vec2 *amplitude = &motion->amplitude;
    sph2d__pose pose = {.displacement = {amplitude->x * swing, amplitude->y * swing},
                        .velocity = {amplitude->x * rate, amplitude->y * rate},
                        .acceleration = {amplitude->x * acceleration, amplitude->y * acceleration}};
    if (motion->path.count > 0)
        add_path(&motion->path, time, &pose);
    return pose;
}
