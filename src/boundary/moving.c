/* SPDX-License-Identifier: MIT */
/** @file moving.c */
#include "boundary/moving.h"

#include <math.h>

static void widen(sph2d_box *box, sph2d_vec2 p)
{
    box->min.x = fmin(box->min.x, p.x);
    box->min.y = fmin(box->min.y, p.y);
    box->max.x = fmax(box->max.x, p.x);
    box->max.y = fmax(box->max.y, p.y);
}

static sph2d_box nothing(void)
{
    return (sph2d_box){{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
}

void sph2d__moving_start(sph2d__moving *m, const sph2d__store *walls, sph2d_vec2 *normals)
{
    m->normals = normals;
    for (uint64_t i = m->first_id; normals && i < m->end_id; ++i)
        normals[i - m->first_id] = (sph2d_vec2){walls->normal_x[i], walls->normal_y[i]};
    m->bounds = nothing();
    for (size_t k = 0; k < m->barrier.count; ++k) {
        widen(&m->bounds, m->barrier.segments[k].ends.a);
        widen(&m->bounds, m->barrier.segments[k].ends.b);
    }
}

/* ---- drifts ------------------------------------------------------------------------------------------------------ */

/** Farthest corner of the bounds from the centre of turning [m]. */
static double radius_of(const sph2d__moving *m)
{
    sph2d_vec2 c = m->course.center;
    return hypot(fmax(c.x - m->bounds.min.x, m->bounds.max.x - c.x),
                 fmax(c.y - m->bounds.min.y, m->bounds.max.y - c.y));
}

double sph2d__moving_shift(const sph2d__moving *m)
{
    return hypot(m->to.displacement.x - m->from.displacement.x, m->to.displacement.y - m->from.displacement.y) +
           fabs(m->to.angle - m->from.angle) * radius_of(m);
}

/** Around the barrier at both ends of the drift, with the rise of the arcs between them. */
static sph2d_box swept_box(const sph2d__moving *m)
{
    const sph2d_box *b = &m->bounds;
    const sph2d_vec2 corners[4] = {b->min, {b->max.x, b->min.y}, b->max, {b->min.x, b->max.y}};
    sph2d_box box = nothing();
    for (int k = 0; k < 4; ++k) {
        widen(&box, sph2d__pose_apply(&m->from, corners[k]));
        widen(&box, sph2d__pose_apply(&m->to, corners[k]));
    }
    double turn = fmin(fabs(m->to.angle - m->from.angle), 4), rise = radius_of(m) * turn * turn / 8;
    double margin = m->barrier.clearance + rise;
    return (sph2d_box){{box.min.x - margin, box.min.y - margin}, {box.max.x + margin, box.max.y + margin}};
}

sph2d__pose sph2d__moving_at(const sph2d__moving *m, double time)
{
    return m->rigid ? sph2d__rigid_at(m->rigid, time) : sph2d__course_at(&m->course, time);
}

/** The pose at a fraction of the drift, with its mean rates. At the end it is that of the drift to the last bit. */
static sph2d__pose pose_between(const sph2d__moving *m, double part)
{
    const sph2d__pose *a = &m->from, *b = &m->to;
    sph2d__pose pose = part < 1 ? *a : *b;
    sph2d_vec2 way = {b->displacement.x - a->displacement.x, b->displacement.y - a->displacement.y};
    double turn = b->angle - a->angle;
    pose.velocity = (sph2d_vec2){way.x / m->span, way.y / m->span};
    pose.omega = turn / m->span;
    if (part <= 0 || part >= 1)
        return pose;
    pose.displacement.x += part * way.x;
    pose.displacement.y += part * way.y;
    pose.angle += part * turn;
    pose.cosine = cos(pose.angle);
    pose.sine = sin(pose.angle);
    return pose;
}

/** Sets the poses of the drift. */
static void set_poses(sph2d__moving *m)
{
    const double turn = fabs(m->to.angle - m->from.angle);
    const int wanted = (int)fmin(ceil(turn / SPH2D__LARGEST_TURN), SPH2D__MOST_CHORDS),
              chords = wanted > 1 ? wanted : 1;
    for (int k = 0; k <= chords; ++k)
        m->poses[k] = pose_between(m, k < chords ? (double)k / chords : 1);
    m->drift = (sph2d__drift){m->poses, chords, m->number, m->barrier};
}

void sph2d__moving_set_drift(sph2d__moving *m, double from, double to)
{
    m->from = sph2d__moving_at(m, from);
    m->to = sph2d__moving_at(m, to);
    m->span = to - from;
    m->swept = swept_box(m);
    set_poses(m);
}

bool sph2d__moving_far_from(const sph2d__moving *m, sph2d_vec2 low, sph2d_vec2 high, double distance)
{
    const sph2d_box *b = &m->swept;
    return low.x - distance > b->max.x || high.x + distance < b->min.x || low.y - distance > b->max.y ||
           high.y + distance < b->min.y;
}

/* ---- boundary particles ------------------------------------------------------------------------------------------ */

void sph2d__moving_place(const sph2d__moving *m, double time, sph2d__store *walls, const sph2d__period *period)
{
    sph2d__pose pose = sph2d__moving_at(m, time);
    for (uint64_t i = m->first_id; i < m->end_id; ++i) {
        sph2d_vec2 p = sph2d__pose_apply(&pose, (sph2d_vec2){walls->start_x[i], walls->start_y[i]});
        sph2d_vec2 v = sph2d__pose_velocity(&pose, p), a = sph2d__pose_acceleration(&pose, p);
        walls->x[i] = sph2d__period_wrap(p.x, period->low_x, period->length_x);
        walls->y[i] = sph2d__period_wrap(p.y, period->low_y, period->length_y);
        walls->vx[i] = v.x;
        walls->vy[i] = v.y;
        walls->ax[i] = a.x;
        walls->ay[i] = a.y;
        if (m->spins)
            m->spins[i - m->first_id] = pose.omega;
        if (m->normals) {
            sph2d_vec2 n = sph2d__pose_turn(&pose, m->normals[i - m->first_id]);
            walls->normal_x[i] = n.x;
            walls->normal_y[i] = n.y;
        }
    }
}

int sph2d__moving_sweep(const sph2d__moving *m, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v)
{
    return sph2d__drift_sweep(&m->drift, from, to, v);
}

bool sph2d__moving_crosses(const sph2d__moving *m, sph2d_vec2 from, sph2d_vec2 to)
{
    return sph2d__barrier_crosses(&m->barrier, sph2d__pose_invert(&m->to, from), sph2d__pose_invert(&m->to, to));
}
