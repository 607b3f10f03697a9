/* SPDX-License-Identifier: MIT */
/** @file motion.c */
#include "scene/motion.h"

#include <math.h>

#include "base/pi.h"
#include "scene/shape.h"

static bool swings(sph2d_swing s)
{
    return s.frequency > 0 && (s.amplitude.x != 0 || s.amplitude.y != 0 || s.angle != 0);
}

/** The motion's own oscillation. */
static sph2d_swing own_swing(const sph2d_motion *m)
{
    return (sph2d_swing){m->amplitude, m->angle, m->frequency, m->phase};
}

/** Oscillation k of a motion, from 0 to swing_count: the last one is its own. */
static sph2d_swing swing_of(const sph2d_motion *m, size_t k)
{
    return k < m->swing_count ? m->swings[k] : own_swing(m);
}

bool sph2d__motion_moves(const sph2d_motion *m)
{
    bool moves = m->path.count > 0 || m->rate != 0;
    for (size_t k = 0; k <= m->swing_count; ++k)
        moves = moves || swings(swing_of(m, k));
    return moves;
}

bool sph2d__motion_turns(const sph2d_motion *m)
{
    bool turns = m->rate != 0;
    for (size_t k = 0; k <= m->swing_count; ++k)
        turns = turns || (swings(swing_of(m, k)) && swing_of(m, k).angle != 0);
    for (size_t k = 0; k < m->path.count; ++k)
        turns = turns || m->path.items[k].angle != 0;
    return turns;
}

sph2d__frequencies sph2d__motion_frequencies(const sph2d_motion *m)
{
    sph2d__frequencies f = {0, 0};
    for (size_t k = 0; k <= m->swing_count; ++k) {
        sph2d_swing s = swing_of(m, k);
        if (!swings(s))
            continue;
        f.lowest = f.lowest > 0 ? fmin(f.lowest, s.frequency) : s.frequency;
        f.highest = fmax(f.highest, s.frequency);
    }
    return f;
}

/* ---- paths ------------------------------------------------------------------------------------------------------- */

size_t sph2d__motion_bends(const sph2d_motion *m)
{
    return m->between == SPH2D_BETWEEN_CUBIC && m->path.count > 2 ? m->path.count : 0;
}

/** The second derivatives of natural cubic splines through the points, 0 at both ends: the tridiagonal equations
 *
 *      h_k-1 s_k-1 + 2 (h_k-1 + h_k) s_k + h_k s_k+1 = 6 ((y_k+1 - y_k)/h_k - (y_k - y_k-1)/h_k-1)
 *
 *  (de Boor 1978, A Practical Guide to Splines, ch. IV). `t` of a bend keeps the factors of the elimination. */
static void find_bends(const sph2d_pose_path *path, sph2d_pose_point *s)
{
    const sph2d_pose_point *p = path->items;
    const size_t last = path->count - 1;
    s[0] = s[last] = (sph2d_pose_point){0, 0, 0, 0};
    for (size_t k = 1; k < last; ++k) {
        double h0 = p[k].t - p[k - 1].t, h1 = p[k + 1].t - p[k].t, pivot = 2 * (h0 + h1) - h0 * s[k - 1].t;
        double x = 6 * ((p[k + 1].x - p[k].x) / h1 - (p[k].x - p[k - 1].x) / h0);
        double y = 6 * ((p[k + 1].y - p[k].y) / h1 - (p[k].y - p[k - 1].y) / h0);
        double angle = 6 * ((p[k + 1].angle - p[k].angle) / h1 - (p[k].angle - p[k - 1].angle) / h0);
        s[k] = (sph2d_pose_point){h1 / pivot, (x - h0 * s[k - 1].x) / pivot, (y - h0 * s[k - 1].y) / pivot,
                                  (angle - h0 * s[k - 1].angle) / pivot};
    }
    for (size_t k = last; k-- > 1;) {
        s[k].x -= s[k].t * s[k + 1].x;
        s[k].y -= s[k].t * s[k + 1].y;
        s[k].angle -= s[k].t * s[k + 1].angle;
    }
}

/** A value with its first and second derivative. */
typedef struct jet {
    double value, rate, bend;
} jet;

/** Between (t0, a) and (t1, b), with second derivatives s0 and s1 there. */
static jet between(double t0, double a, double s0, double t1, double b, double s1, double t)
{
    double h = t1 - t0, slope = (b - a) / h, q = (t - t0) / h, p = 1 - q;
    return (jet){a + (t - t0) * slope + h * h / 6 * ((p * p * p - p) * s0 + (q * q * q - q) * s1),
                 slope + h / 6 * ((3 * q * q - 1) * s1 - (3 * p * p - 1) * s0), p * s0 + q * s1};
}

/** The first point of a path after a time, by bisection: `time` lies between its first and last point. */
static size_t next_point(const sph2d_pose_path *path, double time)
{
    size_t low = 0, high = path->count - 1;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        *(path->items[middle].t <= time ? &low : &high) = middle;
    }
    return high;
}

static void add_jets(sph2d__pose *pose, jet x, jet y, jet angle)
{
    pose->displacement.x += x.value;
    pose->displacement.y += y.value;
    pose->angle += angle.value;
    pose->velocity.x += x.rate;
    pose->velocity.y += y.rate;
    pose->omega += angle.rate;
    pose->acceleration.x += x.bend;
    pose->acceleration.y += y.bend;
    pose->alpha += angle.bend;
}

/** Adds the pose of a path; before its start and after its end it is at rest. */
static void add_path(const sph2d__course *course, double time, sph2d__pose *pose)
{
    const sph2d_pose_path *path = &course->motion->path;
    const sph2d_pose_point *first = path->items, *last = &first[path->count - 1];
    if (time < first->t || time >= last->t) {
        const sph2d_pose_point *rest = time < first->t ? first : last;
        add_jets(pose, (jet){rest->x, 0, 0}, (jet){rest->y, 0, 0}, (jet){rest->angle, 0, 0});
        return;
    }
    size_t k = next_point(path, time);
    const sph2d_pose_point *p = &first[k - 1], *q = &first[k], none = {0, 0, 0, 0};
    const sph2d_pose_point *b = course->bends ? &course->bends[k - 1] : &none;
    const sph2d_pose_point *c = course->bends ? &course->bends[k] : &none;
    add_jets(pose, between(p->t, p->x, b->x, q->t, q->x, c->x, time), between(p->t, p->y, b->y, q->t, q->y, c->y, time),
             between(p->t, p->angle, b->angle, q->t, q->angle, c->angle, time));
}

/* ---- oscillations ------------------------------------------------------------------------------------------------ */

/** The ramp at a time, 10 s^3 - 15 s^4 + 6 s^5 with s = t/ramp: its value, first and second derivative. */
static jet ramp_at(double ramp, double time)
{
    if (!(ramp > 0) || time >= ramp)
        return (jet){1, 0, 0};
    double s = fmax(time, 0) / ramp;
    return (jet){s * s * s * (10 + s * (6 * s - 15)), 30 * s * s * (1 - s) * (1 - s) / ramp,
                 60 * s * (1 - s) * (1 - 2 * s) / (ramp * ramp)};
}

/** The integral of the ramp from 0 to a time [s]. */
static double ramp_integral(double ramp, double time)
{
    if (!(ramp > 0))
        return time;
    double s = fmax(fmin(time / ramp, 1), 0);
    return ramp * s * s * s * s * (2.5 + s * (s - 3)) + fmax(time - ramp, 0);
}

static jet scaled(double a, jet j)
{
    return (jet){a * j.value, a * j.rate, a * j.bend};
}

static void add_swing(sph2d_swing s, jet ramp, double time, sph2d__pose *pose)
{
    double omega = 2 * SPH2D__PI * s.frequency, angle = omega * time + s.phase;
    double swing = sin(angle) - sin(s.phase), rate = omega * cos(angle), bend = -omega * omega * sin(angle);
    jet j = {ramp.value * swing, ramp.value * rate + ramp.rate * swing,
             ramp.value * bend + 2 * ramp.rate * rate + ramp.bend * swing};
    add_jets(pose, scaled(s.amplitude.x, j), scaled(s.amplitude.y, j), scaled(s.angle, j));
}

/* ---- courses ----------------------------------------------------------------------------------------------------- */

sph2d__course sph2d__course_of(const sph2d_motion *motion, const sph2d_shape *outline, sph2d_pose_point *bends)
{
    sph2d_vec2 c = motion->center;
    if (isnan(c.x) || isnan(c.y))
        c = sph2d_shape_centroid(outline);
    if (bends)
        find_bends(&motion->path, bends);
    return (sph2d__course){motion, c, bends};
}

sph2d__pose sph2d__course_at(const sph2d__course *course, double time)
{
    const sph2d_motion *m = course->motion;
    sph2d__pose pose = {.center = course->center};
    jet ramp = ramp_at(m->ramp, time), none = {0, 0, 0};
    for (size_t k = 0; k <= m->swing_count; ++k)
        add_swing(swing_of(m, k), ramp, time, &pose);
    if (m->path.count > 0)
        add_path(course, time, &pose);
    if (m->rate != 0)
        add_jets(&pose, none, none,
                 (jet){m->rate * ramp_integral(m->ramp, time), m->rate * ramp.value, m->rate * ramp.rate});
    pose.cosine = cos(pose.angle);
    pose.sine = sin(pose.angle);
    return pose;
}

sph2d_pose_point sph2d__course_path_at(const sph2d__course *course, double time)
{
    sph2d__pose pose = {.angle = 0};
    add_path(course, time, &pose);
    return (sph2d_pose_point){time, pose.displacement.x, pose.displacement.y, pose.angle};
}

/** The largest speed along a path, of points within a distance of the centre; in cubics of eight parts of each. */
static double path_speed(const sph2d__course *course, double distance)
{
    enum { PARTS = 8 };
    const sph2d_pose_path *path = &course->motion->path;
    double speed = 0;
    for (size_t k = 1; k < path->count; ++k) {
        const sph2d_pose_point *p = &path->items[k - 1], *q = &path->items[k];
        for (int part = 0; part < (course->bends ? PARTS : 1); ++part) {
            sph2d__pose pose = {.angle = 0};
            add_path(course, p->t + (q->t - p->t) * part / PARTS, &pose);
            speed = fmax(speed, hypot(pose.velocity.x, pose.velocity.y) + fabs(pose.omega) * distance);
        }
    }
    return speed;
}

static double swing_speed(sph2d_swing s, double ramp, double distance)
{
    const double STEEPEST = 1.875; /* of the ramp, in its middle */
    double size = hypot(s.amplitude.x, s.amplitude.y) + fabs(s.angle) * distance;
    return size * (2 * SPH2D__PI * s.frequency + (ramp > 0 ? 2 * STEEPEST / ramp : 0));
}

double sph2d__course_speed(const sph2d__course *course, double distance)
{
    const sph2d_motion *m = course->motion;
    double speed = path_speed(course, distance) + fabs(m->rate) * distance;
    for (size_t k = 0; k <= m->swing_count; ++k)
        if (swings(swing_of(m, k)))
            speed += swing_speed(swing_of(m, k), m->ramp, distance);
    return speed;
}
