/* SPDX-License-Identifier: MIT */
/** @file barrier.c
 *  The grid over the segments of walls. */
#include "boundary/barrier.h"

#include <math.h>

enum { MAX_BUCKETS = 512 };

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

void sph2d__barrier_free(sph2d__barrier *barrier, sph2d__memory *memory)
{
    void *blocks[4] = {barrier->segments, barrier->start, barrier->items, barrier->near};
    sph2d__release(memory, &blocks[0], barrier->capacity, sizeof *barrier->segments);
    sph2d__release(memory, &blocks[1], barrier->start_capacity, sizeof *barrier->start);
    sph2d__release(memory, &blocks[2], barrier->item_capacity, sizeof *barrier->items);
    sph2d__release(memory, &blocks[3], barrier->near ? barrier->start_capacity - 1 : 0, 1);
    *barrier = (sph2d__barrier){0};
}
