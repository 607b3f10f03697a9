/* SPDX-License-Identifier: MIT */
/** @file near.c
 *  Points in hashed buckets. */
#include "start/near.h"

#include <math.h>

static size_t slot_of(const sph2d__near *n, double column, double row)
{
    uint64_t hash = (uint64_t)(int64_t)column * 0x9E3779B97F4A7C15u ^ (uint64_t)(int64_t)row * 0xC2B2AE3D27D4EB4Fu;
    return (size_t)(hash >> 32) & (n->slots - 1);
}

static size_t slot_of_point(const sph2d__near *n, double x, double y)
{
    return slot_of(n, floor(x / n->distance), floor(y / n->distance));
}

bool sph2d__near_build(sph2d__near *near, const double *x, const double *y, size_t count, double distance,
                       sph2d__memory *memory)
{
    *near = (sph2d__near){.distance = distance, .count = count, .slots = 1};
    while (near->slots < count)
        near->slots *= 2;
    near->end = sph2d__alloc(memory, near->slots, sizeof *near->end);
    near->points = sph2d__alloc(memory, count + 1, sizeof *near->points);
    near->index = sph2d__alloc(memory, count + 1, sizeof *near->index);
    if (!near->end || !near->points || !near->index) {
        sph2d__near_free(near, memory);
        return false;
    }
    for (size_t i = 0; i < count; ++i)
        ++near->end[slot_of_point(near, x[i], y[i])];
    uint32_t before = 0;
    for (size_t k = 0; k < near->slots; ++k) { /* from how many to where the slot begins */
        uint32_t here = near->end[k];
        near->end[k] = before;
        before += here;
    }
    for (size_t i = 0; i < count; ++i) {
        uint32_t at = near->end[slot_of_point(near, x[i], y[i])]++;
        near->points[at] = (sph2d_vec2){x[i], y[i]};
        near->index[at] = (uint32_t)i;
    }
    return true;
}

bool sph2d__near_any(const sph2d__near *near, sph2d_vec2 p)
{
    double column = floor(p.x / near->distance), row = floor(p.y / near->distance);
    for (int k = 0; k < 9 && near->count > 0; ++k) {
        size_t slot = slot_of(near, column + k % 3 - 1, row + k / 3 - 1);
        for (uint32_t m = slot > 0 ? near->end[slot - 1] : 0; m < near->end[slot]; ++m)
            if (hypot(near->points[m].x - p.x, near->points[m].y - p.y) < near->distance)
                return true;
    }
    return false;
}

/* Two cells may share a slot, so that a point counts only for its own. */
void sph2d__near_each(const sph2d__near *near, sph2d_vec2 p,
                      void (*visit)(void *with, uint32_t index, double x, double y), void *with)
{
    double column = floor(p.x / near->distance), row = floor(p.y / near->distance);
    for (int k = 0; k < 9 && near->count > 0; ++k) {
        double i = column + k % 3 - 1, j = row + k / 3 - 1;
        size_t slot = slot_of(near, i, j);
        for (uint32_t m = slot > 0 ? near->end[slot - 1] : 0; m < near->end[slot]; ++m) {
            sph2d_vec2 q = near->points[m];
            bool here = floor(q.x / near->distance) == i && floor(q.y / near->distance) == j;
            if (here && hypot(q.x - p.x, q.y - p.y) < near->distance)
                visit(with, near->index[m], q.x - p.x, q.y - p.y);
        }
    }
}

void sph2d__near_free(sph2d__near *near, sph2d__memory *memory)
{
    void *end = near->end, *points = near->points, *index = near->index;
    sph2d__release(memory, &end, near->slots, sizeof *near->end);
    sph2d__release(memory, &points, near->count + 1, sizeof *near->points);
    sph2d__release(memory, &index, near->count + 1, sizeof *near->index);
    *near = (sph2d__near){0};
}
