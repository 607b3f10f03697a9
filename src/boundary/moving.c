/* SPDX-License-Identifier: MIT */
/** @file moving.c */
#include "boundary/moving.h"

void sph2d__moving_set_drift(sph2d__moving *m, double from, double to)
{
    m->from = sph2d__pose_at(m->motion, from);
    m->to = sph2d__pose_at(m->motion, to);
    double span = to - from; /* negative in the stages of a scheme that moves back in time */
    m->velocity = (sph2d_vec2){(m->to.displacement.x - m->from.displacement.x) / span,
                               (m->to.displacement.y - m->from.displacement.y) / span};
}

void sph2d__moving_place(const sph2d__moving *m, double time, sph2d__store *walls, const sph2d__period *period)
{
    sph2d__pose pose = sph2d__pose_at(m->motion, time);
    for (size_t i = 0; i < walls->count; ++i) {
        if (walls->id[i] < m->first_id || walls->id[i] >= m->end_id)
            continue;
        sph2d_vec2 p = sph2d__pose_apply(&pose, (sph2d_vec2){walls->start_x[i], walls->start_y[i]});
        walls->x[i] = sph2d__period_wrap(p.x, period->low_x, period->length_x);
        walls->y[i] = sph2d__period_wrap(p.y, period->low_y, period->length_y);
        walls->vx[i] = pose.velocity.x;
        walls->vy[i] = pose.velocity.y;
        walls->ax[i] = pose.acceleration.x;
        walls->ay[i] = pose.acceleration.y;
    }
}

int sph2d__moving_sweep(const sph2d__moving *m, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v)
{
    sph2d_vec2 start = sph2d__pose_invert(&m->from, from), end = sph2d__pose_invert(&m->to, *to);
    sph2d_vec2 relative = {v->x - m->velocity.x, v->y - m->velocity.y};
    int hits = sph2d__barrier_sweep(&m->barrier, start, &end, &relative, NULL);
    if (hits > 0) {
        *to = sph2d__pose_apply(&m->to, end);
        *v = (sph2d_vec2){relative.x + m->velocity.x, relative.y + m->velocity.y};
    }
    return hits;
}

bool sph2d__moving_crosses(const sph2d__moving *m, sph2d_vec2 from, sph2d_vec2 to)
{
    return sph2d__barrier_crosses(&m->barrier, sph2d__pose_invert(&m->to, from), sph2d__pose_invert(&m->to, to));
}
