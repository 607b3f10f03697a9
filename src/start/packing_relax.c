/* SPDX-License-Identifier: MIT */
/** @file packing_relax.c
 *  Gradient descent with momentum of packed particles to a vanishing concentration gradient, and its neighbour
 *  lists. */
#include <math.h>
#include <string.h>

#include "start/packing_state.h"

/* Step for a gradient of 1/dx [dx]; momentum, the fraction of the last step that is kept; longest step [dx]; gradient
 * at convergence [1/dx]. */
static const double RATE = 0.5, MOMENTUM = 0.9, MAX_STEP = 0.1, TOLERANCE = 3e-4;
enum { MAX_ITERATIONS = 400 };

/* ---- neighbours -------------------------------------------------------------------------------------------------- */

/** The row or column of the bucket at a distance of so many cells from the first. */
static size_t bucket_of(const sph2d__packing_state *p, double cells, size_t n)
{
    return (size_t)fmin(fmax(floor(cells * p->size / p->bucket), 0), (double)n - 1);
}

/** Sorts the particles into buckets, keeping their order. */
static void fill_buckets(sph2d__packing_state *p)
{
    size_t buckets = p->bx * p->by;
    memset(p->start, 0, (buckets + 1) * sizeof *p->start);
    for (int pass = 0; pass < 2; ++pass) {
        for (size_t i = 0; i < p->count; ++i) {
            sph2d_vec2 c = sph2d__region_in_cells(p->region, p->at[i]);
            size_t b = bucket_of(p, c.y, p->by) * p->bx + bucket_of(p, c.x, p->bx);
            if (pass == 0)
                ++p->start[b + 1];
            else
                p->order[p->start[b]++] = (uint32_t)i;
        }
        for (size_t b = 0; b < buckets && pass == 0; ++b)
            p->start[b + 1] += p->start[b];
    }
    memmove(p->start + 1, p->start, buckets * sizeof *p->start);
    p->start[0] = 0;
}

static bool add_neighbour(sph2d__packing_state *p, size_t used, uint32_t j)
{
    if (used == p->neighbour_capacity) {
        void *block = p->neighbour;
        size_t grown = 2 * p->neighbour_capacity + 64 * p->movers;
        if (!sph2d__resize(&p->sim->memory, &block, p->neighbour_capacity, grown, sizeof *p->neighbour))
            return false;
        p->neighbour = block;
        p->neighbour_capacity = grown;
    }
    p->neighbour[used] = j;
    return true;
}

/** Builds the neighbour lists of the movers; false when memory is short. */
static bool find_neighbours(sph2d__packing_state *p)
{
    size_t used = 0;
    const double reach2 = p->bucket * p->bucket;
    fill_buckets(p);
    memcpy(p->old, p->at, p->count * sizeof *p->at);
    for (size_t m = 0; m < p->movers; ++m) {
        size_t i = p->mover[m];
        sph2d_vec2 c = sph2d__region_in_cells(p->region, p->at[i]);
        size_t x = bucket_of(p, c.x, p->bx), y = bucket_of(p, c.y, p->by);
        p->first[m] = (uint32_t)used;
        for (size_t b = y > 0 ? y - 1 : 0; b <= y + 1 && b < p->by; ++b) {
            size_t from = p->start[b * p->bx + (x > 0 ? x - 1 : 0)];
            size_t to = p->start[b * p->bx + (x + 1 < p->bx ? x + 1 : x) + 1];
            for (size_t k = from; k < to; ++k) {
                uint32_t j = p->order[k];
                const double dx = p->at[i].x - p->at[j].x, dy = p->at[i].y - p->at[j].y;
                if (j == i || dx * dx + dy * dy > reach2)
                    continue;
                if (!add_neighbour(p, used++, j))
                    return false;
            }
        }
    }
    p->first[p->movers] = (uint32_t)used;
    return true;
}

static bool neighbours_are_stale(const sph2d__packing_state *p)
{
    for (size_t m = 0; m < p->movers; ++m) {
        size_t i = p->mover[m];
        if (hypot(p->at[i].x - p->old[i].x, p->at[i].y - p->old[i].y) > SPH2D__PACKING_SKIN / 2 * p->size)
            return true;
    }
    return false;
}

/* ---- the descent ------------------------------------------------------------------------------------------------- */

/** Evaluates the gradient at each mover. Returns the largest one times the spacing. */
static double evaluate_gradients(sph2d__packing_state *p)
{
    double largest = 0;
    for (size_t m = 0; m < p->movers; ++m) {
        size_t i = p->mover[m];
        sph2d_vec2 sum = {0, 0};
        for (uint32_t k = p->first[m]; k < p->first[m + 1]; ++k) {
            sph2d_vec2 other = p->at[p->neighbour[k]];
            sph2d__packing_add_area(p, p->at[i].x - other.x, p->at[i].y - other.y, 1, &sum);
        }
        sph2d__packing_add_walls(p, p->at[i], &sum);
        sph2d__packing_add_missing(p, p->at[i], &sum);
        p->gradient[i] = sum;
        largest = fmax(largest, hypot(sum.x, sum.y) * p->size);
    }
    return largest;
}

/** Distance to the nearest side of the domain with a spring wall, which repels particles within half a spacing. */
static double distance_to_springs(const sph2d_sim *sim, sph2d_vec2 at)
{
    const sph2d__world *world = &sim->world;
    return world->scene.walls == SPH2D_WALL_SPRING ? sph2d__walled_distance(&world->scene, &world->box, at) : INFINITY;
}

/** Whether a particle may move: within the area, not across a wall, not into the range of spring walls. */
static bool may_move(const sph2d__packing_state *p, sph2d_vec2 from, sph2d_vec2 to)
{
    double distance = distance_to_springs(p->sim, to);
    if (distance < p->size / 2 && distance < distance_to_springs(p->sim, from))
        return false;
    if (p->near_edge[sph2d__packing_cell(p, to)] && !sph2d__region_contains(p->region, to))
        return false;
    return !sph2d__sim_crosses_wall(p->sim, from, to);
}

/** Moves the particles that are too near to boundary particles off them. True if there were any. */
static bool clear_walls(sph2d__packing_state *p)
{
    bool any = false;
    for (size_t m = 0; m < p->movers; ++m) {
        sph2d_vec2 *at = &p->at[p->mover[m]], clear = sph2d__packing_clear_of_walls(p, *at);
        if (clear.x == at->x && clear.y == at->y)
            continue;
        any = true;
        if (may_move(p, *at, clear))
            *at = clear;
    }
    return any;
}

/** Makes one step of the descent. Momentum is dropped when it leads uphill. */
static void descend(sph2d__packing_state *p)
{
    double downhill = 0;
    for (size_t m = 0; m < p->movers; ++m) {
        size_t i = p->mover[m];
        downhill -= p->velocity[i].x * p->gradient[i].x + p->velocity[i].y * p->gradient[i].y;
    }
    double momentum = downhill < 0 ? 0 : MOMENTUM;
    for (size_t m = 0; m < p->movers; ++m) {
        size_t i = p->mover[m];
        double x = momentum * p->velocity[i].x - RATE * p->size * p->size * p->gradient[i].x;
        double y = momentum * p->velocity[i].y - RATE * p->size * p->size * p->gradient[i].y;
        double shorten = fmin(MAX_STEP * p->size / fmax(hypot(x, y), 1e-300), 1);
        sph2d_vec2 to = {p->at[i].x + shorten * x, p->at[i].y + shorten * y};
        bool moves = may_move(p, p->at[i], to);
        p->velocity[i] = moves ? (sph2d_vec2){shorten * x, shorten * y} : (sph2d_vec2){0, 0};
        p->at[i] = moves ? to : p->at[i];
    }
}

/** Descends; with `clear` only to places that are clear of walls. False when memory is short. */
static bool descend_all(sph2d__packing_state *p, bool clear, double *residual)
{
    for (int iteration = 0; iteration < MAX_ITERATIONS; ++iteration) {
        if ((iteration == 0 || neighbours_are_stale(p)) && !find_neighbours(p))
            return false;
        *residual = evaluate_gradients(p);
        if (*residual < TOLERANCE)
            break;
        descend(p);
        if (clear)
            clear_walls(p);
    }
    return true;
}

bool sph2d__packing_relax(sph2d__packing_state *p, double *residual)
{
    *residual = 0;
    if (p->movers == 0)
        return true;
    /* what thin solids represent is little, and does not keep all particles off them */
    return descend_all(p, false, residual) && (!clear_walls(p) || descend_all(p, true, residual));
}
