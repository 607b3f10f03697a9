/* SPDX-License-Identifier: MIT */
/** @file body_rows.c */
#include "methods/projection/body_rows.h"

#include <string.h>

#include "base/parallel.h"
#include "boundary/rigid.h"
#include "simd/lanes.h"

/* ---- pairs ------------------------------------------------------------------------------------------------------- */

void sph2d__body_pairs_free(sph2d__body_pairs *pairs, sph2d__memory *memory)
{
    void *blocks[2] = {pairs->items, pairs->first};
    sph2d__release(memory, &blocks[0], pairs->capacity, sizeof *pairs->items);
    sph2d__release(memory, &blocks[1], pairs->first ? pairs->bodies + 1 : 0, sizeof *pairs->first);
    *pairs = (sph2d__body_pairs){0};
}

/** The body of a boundary particle; the count for none. Bodies' ids follow each other. */
static size_t body_of(const sph2d__system *s, uint64_t id)
{
    size_t low = 0, high = s->rigid_count;
    if (id < s->rigids[0].first_id || id >= s->rigids[high - 1].end_id)
        return high;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        *(s->rigids[middle].first_id <= id ? &low : &high) = middle;
    }
    return low;
}

/** Counts the pairs of each body in first[body + 1], or enters them from first[body] on. */
static void visit(sph2d__system *s, bool enter)
{
    const sph2d__neighbours *n = &s->neighbours;
    sph2d__body_pairs *pairs = &s->body_pairs;
    for (size_t i = 0; i < s->fluid.count; ++i) {
        const sph2d__slice *at = &n->slices[i / n->lanes];
        size_t k = at->begin + at->fluid * n->lanes + i % n->lanes,
               end = at->begin + (at->fluid + at->walls) * n->lanes;
        for (; k < end; k += n->lanes) {
            float g[2];
            memcpy(g, &n->gradient[k], sizeof g);
            size_t body = g[0] != 0 || g[1] != 0 ? body_of(s, s->walls.id[n->index[k]]) : s->rigid_count;
            if (body == s->rigid_count)
                continue;
            if (enter)
                pairs->items[pairs->first[body]++] = (sph2d__body_pair){(uint32_t)i, n->index[k], g[0], g[1]};
            else
                ++pairs->first[body + 1];
        }
    }
}

/** Makes room for the pairs that were counted. */
static bool reserve(sph2d__system *s, size_t count)
{
    sph2d__body_pairs *p = &s->body_pairs;
    void *block = p->items;
    size_t capacity = count + count / 2;
    if (count <= p->capacity)
        return true;
    if (!sph2d__resize(s->memory, &block, p->capacity, capacity, sizeof *p->items))
        return false;
    p->items = block;
    p->capacity = capacity;
    return true;
}

static sph2d_vec2 arm_of(const sph2d__system *s, const sph2d__rigid *r, size_t b)
{
    const sph2d__period *p = &s->wall_cells.period;
    sph2d_vec2 center = sph2d__rigid_center(r, r->now);
    return (sph2d_vec2){sph2d__period_nearest(s->walls.x[b] - center.x, p->length_x),
                        sph2d__period_nearest(s->walls.y[b] - center.y, p->length_y)};
}

/** (m/M, m/M, m/I) where the body is free. */
static sph2d__twist ease_of(const sph2d__system *s, const sph2d__rigid *r)
{
    return sph2d__rigid_accelerate(r, (sph2d__twist){s->mass, s->mass, s->mass});
}

bool sph2d__body_rows_gather(sph2d__system *s)
{
    sph2d__body_pairs *p = &s->body_pairs;
    if (s->rigid_count == 0)
        return true;
    if (!p->first) {
        p->first = sph2d__alloc(s->memory, s->rigid_count + 1, sizeof *p->first);
        p->bodies = s->rigid_count;
    }
    if (!p->first)
        return false;
    memset(p->first, 0, (s->rigid_count + 1) * sizeof *p->first);
    visit(s, false);
    for (size_t k = 0; k < s->rigid_count; ++k)
        p->first[k + 1] += p->first[k];
    if (!reserve(s, p->first[s->rigid_count]))
        return false;
    visit(s, true);
    for (size_t k = s->rigid_count; k > 0; --k) /* entering moved each to where the next begins */
        p->first[k] = p->first[k - 1];
    p->first[0] = 0;
    return true;
}

/* ---- motion ------------------------------------------------------------------------------------------------------ */

/** (D' y)_body with the directions, which are floats, or in the end the multipliers. */
static sph2d__twist transpose(const sph2d__system *s, size_t body, bool ends)
{
    const sph2d__body_pairs *pairs = &s->body_pairs;
    const sph2d__rigid *r = &s->rigids[body];
    sph2d__twist sum = {0, 0, 0};
    for (size_t k = pairs->first[body]; k < pairs->first[body + 1]; ++k) {
        const sph2d__body_pair *pair = &pairs->items[k];
        double y = ends ? s->fluid.multiplier[pair->fluid] + s->walls.multiplier[pair->wall]
                        : sph2d__splat_value(s->fluid.direction[pair->fluid]) +
                              sph2d__splat_value(s->walls.direction[pair->wall]);
        sph2d_vec2 arm = arm_of(s, r, pair->wall);
        double fx = -y * (double)pair->gx, fy = -y * (double)pair->gy;
        sum = sph2d__twist_add(sum, 1, (sph2d__twist){fx, fy, arm.x * fy - arm.y * fx});
    }
    return sum;
}

/** Velocities of the boundary particles of a body. */
static void move(sph2d__system *s, const sph2d__rigid *r, sph2d__twist by)
{
    uint64_t first = s->rigids[0].first_id;
    for (uint64_t id = r->first_id; id < r->end_id; ++id) {
        size_t b = s->rigid_index[id - first];
        sph2d_vec2 arm = arm_of(s, r, b);
        s->walls.vx[b] = by.x - by.turn * arm.y;
        s->walls.vy[b] = by.y + by.turn * arm.x;
    }
}

/** V + dt a - (m/M, m/M, m/I) D' y/dt. */
static void predict_body(sph2d__system *s, size_t k, bool ends)
{
    const sph2d__rigid *r = &s->rigids[k];
    const double keep = -1 / s->step;
    sph2d__twist ease = ease_of(s, r), sum = transpose(s, k, ends);
    sph2d__twist push = {keep * ease.x * sum.x, keep * ease.y * sum.y, keep * ease.turn * sum.turn};
    push = sph2d__twist_add(push, s->step, sph2d__rigid_accelerate(r, r->other));
    move(s, r, sph2d__twist_add(r->state->velocity, 1, push));
}

static void predict(sph2d__system *s, bool ends)
{
    size_t count = s->rigid_count;
#pragma omp taskloop num_tasks(sph2d__tasks(count, 1)) if (count > 1)
    for (size_t k = 0; k < count; ++k)
        predict_body(s, k, ends);
}

void sph2d__body_rows_predict(sph2d__system *s)
{
    predict(s, false);
}

void sph2d__body_rows_end(sph2d__system *s)
{
    predict(s, true);
}
