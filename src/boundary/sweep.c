/* SPDX-License-Identifier: MIT */
/** @file sweep.c
 *  Continuous collision of particles with straight wall segments, in C and in OpenCL C. */
#include <math.h>

#include "boundary/barrier.h"

/* A particle that slides at the clearance must not hit the same wall again by rounding. */
SPH2D__FIXED double TOUCH = 1 - 1e-6;

/** Smaller and larger of two numbers; fmin and fmax are slower, as they handle NaN. */
static inline double lesser(double a, double b)
{
    return a < b ? a : b;
}

static inline double greater(double a, double b)
{
    return a > b ? a : b;
}

/** A hit: fraction of the displacement, and the wall's normal on the particle's side. */
typedef struct hit {
    double t;
    sph2d_vec2 normal;
    double gap; /**< distance from the point of contact to the particle's new position, along the normal */
    uint32_t index;
} hit;

/** Intersects a displacement with the line at the clearance, or (beside a wall's end) with the wall itself. */
static bool hit_segment(SPH2D__ARRAY const sph2d__piece *piece, double clearance, sph2d_vec2 from, sph2d_vec2 to,
                        hit *m)
{
    const sph2d__segment at = piece->ends, *s = &at;
    double ex = piece->direction.x, ey = piece->direction.y, length = piece->length;
    double d0 = (from.y - s->a.y) * ex - (from.x - s->a.x) * ey;
    double d1 = (to.y - s->a.y) * ex - (to.x - s->a.x) * ey;
    double side = d0 < 0 ? -1 : 1;
    d0 *= side;
    d1 *= side;
    if (d1 >= TOUCH * clearance || d1 >= d0)
        return false;
    if (clearance == 0 && d0 == 0) /* a line that starts on the wall has no side */
        return false;
    double u0 = (from.x - s->a.x) * ex + (from.y - s->a.y) * ey;
    double u1 = (to.x - s->a.x) * ex + (to.y - s->a.y) * ey;
    m->normal = (sph2d_vec2){-ey * side, ex * side};
    double t = d0 > clearance ? (d0 - clearance) / (d0 - d1) : 0;
    double u = u0 + t * (u1 - u0);
    m->gap = d0 > clearance ? 0 : clearance - d0;
    if (u < 0 || u > length) { /* beyond its ends, where liquid slides on past a corner, only the wall itself stops */
        double overlap = (1 - TOUCH) * clearance; /* so that nothing passes between two walls that meet */
        if (d1 > 0)
            return false;
        t = d0 / (d0 - d1);
        u = u0 + t * (u1 - u0);
        m->gap = clearance;
        if (u < -overlap || u > length + overlap)
            return false;
    }
    m->t = t;
    return true;
}

/** The first wall that a displacement hits. Of equal hits the lower index counts, whatever its bucket. */
static bool find_first_hit(const sph2d__barrier *b, sph2d_vec2 from, sph2d_vec2 to, hit *first)
{
    double c = b->clearance;
    int x0 = sph2d__bucket_of(lesser(from.x, to.x) - c, b->origin_x, b->inverse_size, b->nx);
    int x1 = sph2d__bucket_of(greater(from.x, to.x) + c, b->origin_x, b->inverse_size, b->nx);
    int y0 = sph2d__bucket_of(lesser(from.y, to.y) - c, b->origin_y, b->inverse_size, b->ny);
    int y1 = sph2d__bucket_of(greater(from.y, to.y) + c, b->origin_y, b->inverse_size, b->ny);
    bool found = false;
    for (int iy = y0; iy <= y1; ++iy)
        for (int ix = x0; ix <= x1; ++ix) {
            size_t k = (size_t)iy * (size_t)b->nx + (size_t)ix;
            for (uint32_t n = b->start[k]; n < b->start[k + 1]; ++n) {
                hit m = {.index = b->items[n]};
                if (!hit_segment(&b->segments[m.index], c, from, to, &m))
                    continue;
                if (!found || m.t < first->t || (m.t == first->t && m.index < first->index)) {
                    *first = m;
                    found = true;
                }
            }
        }
    return found;
}

SPH2D__LINKED bool sph2d__barrier_crosses(const sph2d__barrier *barrier, sph2d_vec2 from, sph2d_vec2 to)
{
    if (barrier->count == 0)
        return false;
    sph2d__barrier without_clearance = *barrier;
    without_clearance.clearance = 0;
    hit m;
    return find_first_hit(&without_clearance, from, to, &m);
}

/** Notes a hit that changed the velocity from `before` to `after`. */
static void note(sph2d__stops *stops, int wall, sph2d_vec2 before, sph2d_vec2 after)
{
    if (!stops)
        return;
    stops->items[stops->count].wall = wall;
    stops->items[stops->count++].change = (sph2d_vec2){after.x - before.x, after.y - before.y};
}

SPH2D__LINKED int sph2d__barrier_resolve(const sph2d__barrier *barrier, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v,
                                         sph2d__stops *stops)
{
    int hits = 0;
    if (stops)
        stops->count = 0;
    hit m;
    if (!find_first_hit(barrier, from, *to, &m))
        return 0;
    do {
        ++hits;
        int wall = barrier->segments[m.index].wall;
        sph2d_vec2 n = m.normal, before = *v;
        double inward = v->x * n.x + v->y * n.y;
        if (inward < 0) {
            v->x -= inward * n.x;
            v->y -= inward * n.y;
        }
        sph2d_vec2 stop = {from.x + m.t * (to->x - from.x) + m.gap * n.x,
                           from.y + m.t * (to->y - from.y) + m.gap * n.y};
        double rest_x = (1 - m.t) * (to->x - from.x), rest_y = (1 - m.t) * (to->y - from.y);
        double rest_n = rest_x * n.x + rest_y * n.y;
        bool stuck = hits == SPH2D__MAX_STOPS || sph2d__barrier_crosses(barrier, from, stop);
        if (stuck)
            *v = (sph2d_vec2){0, 0};
        note(stops, wall, before, *v);
        if (stuck) {
            *to = from;
            return hits;
        }
        from = stop;
        *to = (sph2d_vec2){from.x + rest_x - rest_n * n.x, from.y + rest_y - rest_n * n.y};
    } while (find_first_hit(barrier, from, *to, &m));
    return hits;
}

/** Sweeps a part of a displacement between two poses. */
static inline int sweep_chord(const sph2d__barrier *barrier, const sph2d__pose *a, const sph2d__pose *b,
                              sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v)
{
    sph2d_vec2 start = sph2d__pose_invert(a, from), end = sph2d__pose_invert(b, *to);
    sph2d_vec2 wall = sph2d__pose_velocity(b, *to);
    sph2d_vec2 relative = sph2d__pose_turn_back(b, (sph2d_vec2){v->x - wall.x, v->y - wall.y});
    int hits = sph2d__barrier_sweep(barrier, start, &end, &relative, NULL);
    if (hits == 0)
        return 0;
    *to = sph2d__pose_apply(b, end);
    wall = sph2d__pose_velocity(b, *to);
    relative = sph2d__pose_turn(b, relative);
    *v = (sph2d_vec2){relative.x + wall.x, relative.y + wall.y};
    return hits;
}

SPH2D__LINKED int sph2d__drift_sweep(const sph2d__drift *d, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v)
{
    const int chords = d->chords;
    const sph2d_vec2 step = {(to->x - from.x) / chords, (to->y - from.y) / chords};
    sph2d_vec2 at = from;
    int hits = 0;
    for (int k = 1; k <= chords; ++k) {
        const sph2d__pose a = d->poses[k - 1], b = d->poses[k];
        sph2d_vec2 next = k < chords || hits > 0 ? (sph2d_vec2){at.x + step.x, at.y + step.y} : *to;
        hits += sweep_chord(&d->barrier, &a, &b, at, &next, v);
        at = next;
    }
    *to = at;
    return hits;
}
