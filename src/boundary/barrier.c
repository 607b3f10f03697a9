/* SPDX-License-Identifier: MIT */
/** @file barrier.c
 *  Continuous collision of particles with straight wall segments. */
#include "boundary/barrier.h"

#include <math.h>

enum { MAX_BUCKETS = 512 };

/* A particle that slides at the clearance must not hit the same wall again by rounding. */
static const double TOUCH = 1 - 1e-6;

bool sph2d__barrier_add(sph2d__barrier *barrier, sph2d__segment segment, sph2d__memory *memory)
{
    if (!sph2d__room_for_one(memory, &barrier->segments, barrier->count, &barrier->capacity, sizeof *barrier->segments))
        return false;
    double ex = segment.b.x - segment.a.x, ey = segment.b.y - segment.a.y, length = hypot(ex, ey);
    barrier->segments[barrier->count++] = (sph2d__piece){segment, {ex / length, ey / length}, length, barrier->wall};
    return true;
}

static void lay_buckets(sph2d__barrier *b, double bucket)
{
    double min_x = INFINITY, min_y = INFINITY, max_x = -INFINITY, max_y = -INFINITY;
    for (size_t i = 0; i < b->count; ++i) {
        const sph2d__segment *s = &b->segments[i].ends;
        min_x = fmin(min_x, fmin(s->a.x, s->b.x));
        min_y = fmin(min_y, fmin(s->a.y, s->b.y));
        max_x = fmax(max_x, fmax(s->a.x, s->b.x));
        max_y = fmax(max_y, fmax(s->a.y, s->b.y));
    }
    double extent = fmax(max_x - min_x, max_y - min_y);
    double size = fmax(bucket, extent / (MAX_BUCKETS - 4));
    b->inverse_size = 1 / size;
    b->origin_x = min_x - size;
    b->origin_y = min_y - size;
    b->nx = (int)((max_x - min_x) / size) + 3;
    b->ny = (int)((max_y - min_y) / size) + 3;
}

/** Whether a segment is within 3/4 of the bucket size (half its diagonal is 0.71) plus the clearance of its centre. */
static bool touches(const sph2d__barrier *b, const sph2d__segment *s, int ix, int iy)
{
    double size = 1 / b->inverse_size;
    sph2d_vec2 centre = {b->origin_x + (ix + 0.5) * size, b->origin_y + (iy + 0.5) * size};
    return sph2d__segment_distance(s, centre) <= 0.75 * size + b->clearance;
}

/** Visits each bucket that a segment touches: counts into start, or fills items. */
static void visit_segment(sph2d__barrier *b, size_t index, bool fill)
{
    const sph2d__segment *s = &b->segments[index].ends;
    double c = 1 / b->inverse_size;
    int x0 = sph2d__bucket_of(fmin(s->a.x, s->b.x) - c, b->origin_x, b->inverse_size, b->nx);
    int x1 = sph2d__bucket_of(fmax(s->a.x, s->b.x) + c, b->origin_x, b->inverse_size, b->nx);
    int y0 = sph2d__bucket_of(fmin(s->a.y, s->b.y) - c, b->origin_y, b->inverse_size, b->ny);
    int y1 = sph2d__bucket_of(fmax(s->a.y, s->b.y) + c, b->origin_y, b->inverse_size, b->ny);
    for (int iy = y0; iy <= y1; ++iy)
        for (int ix = x0; ix <= x1; ++ix) {
            if (!touches(b, s, ix, iy))
                continue;
            uint32_t *slot = &b->start[(size_t)iy * (size_t)b->nx + (size_t)ix];
            if (fill)
                b->items[(*slot)++] = (uint32_t)index;
            else
                ++*slot;
        }
}

/** Marks the buckets from which a displacement of one bucket's width can reach a wall. */
static void mark_near(sph2d__barrier *b)
{
    for (int iy = 0; iy < b->ny; ++iy)
        for (int ix = 0; ix < b->nx; ++ix) {
            size_t k = (size_t)iy * (size_t)b->nx + (size_t)ix;
            if (b->start[k] == b->start[k + 1])
                continue;
            for (int y = iy > 0 ? iy - 1 : 0; y <= iy + 1 && y < b->ny; ++y)
                for (int x = ix > 0 ? ix - 1 : 0; x <= ix + 1 && x < b->nx; ++x)
                    b->near[(size_t)y * (size_t)b->nx + (size_t)x] = 1;
        }
}

bool sph2d__barrier_build(sph2d__barrier *barrier, double bucket, double clearance, sph2d__memory *memory)
{
    sph2d__barrier *b = barrier;
    if (b->count == 0)
        return true;
    b->clearance = clearance;
    lay_buckets(b, bucket);
    size_t buckets = (size_t)b->nx * (size_t)b->ny;
    b->start = sph2d__alloc(memory, buckets + 1, sizeof *b->start);
    if (!b->start)
        return false;
    b->start_capacity = buckets + 1;
    b->near = sph2d__alloc(memory, buckets, 1);
    if (!b->near)
        return false;
    for (size_t i = 0; i < b->count; ++i)
        visit_segment(b, i, false);
    uint32_t total = 0;
    for (size_t k = 0; k <= buckets; ++k) {
        uint32_t here = b->start[k];
        b->start[k] = total;
        total += here;
    }
    b->items = sph2d__alloc(memory, total > 0 ? total : 1, sizeof *b->items);
    if (!b->items)
        return false;
    b->item_capacity = total > 0 ? total : 1;
    for (size_t i = 0; i < b->count; ++i)
        visit_segment(b, i, true);
    /* Filling moved each start to its bucket's end: shift them back by one bucket. */
    for (size_t k = buckets; k > 0; --k)
        b->start[k] = b->start[k - 1];
    b->start[0] = 0;
    mark_near(b);
    return true;
}

bool sph2d__barrier_far_from(const sph2d__barrier *b, sph2d_vec2 low, sph2d_vec2 high, double distance)
{
    if (b->count == 0)
        return true;
    if (!((distance + b->clearance) * b->inverse_size < 1))
        return false;
    int x0 = sph2d__bucket_of(low.x - distance, b->origin_x, b->inverse_size, b->nx);
    int x1 = sph2d__bucket_of(high.x + distance, b->origin_x, b->inverse_size, b->nx);
    int y0 = sph2d__bucket_of(low.y - distance, b->origin_y, b->inverse_size, b->ny);
    int y1 = sph2d__bucket_of(high.y + distance, b->origin_y, b->inverse_size, b->ny);
    for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x)
            if (b->near[(size_t)y * (size_t)b->nx + (size_t)x])
                return false;
    return true;
}

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
static bool hit_segment(const sph2d__piece *piece, double clearance, sph2d_vec2 from, sph2d_vec2 to, hit *m)
{
    const sph2d__segment *s = &piece->ends;
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

bool sph2d__barrier_crosses(const sph2d__barrier *barrier, sph2d_vec2 from, sph2d_vec2 to)
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

int sph2d__barrier_resolve(const sph2d__barrier *barrier, sph2d_vec2 from, sph2d_vec2 *to, sph2d_vec2 *v,
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

void sph2d__barrier_free(sph2d__barrier *barrier, sph2d__memory *memory)
{
    void *blocks[4] = {barrier->segments, barrier->start, barrier->items, barrier->near};
    sph2d__release(memory, &blocks[0], barrier->capacity, sizeof *barrier->segments);
    sph2d__release(memory, &blocks[1], barrier->start_capacity, sizeof *barrier->start);
    sph2d__release(memory, &blocks[2], barrier->item_capacity, sizeof *barrier->items);
    sph2d__release(memory, &blocks[3], barrier->near ? barrier->start_capacity - 1 : 0, 1);
    *barrier = (sph2d__barrier){0};
}
