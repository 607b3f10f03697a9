/* SPDX-License-Identifier: MIT */
/** @file gaps.c */
#include "sim/gaps.h"

#include <math.h>

#include "base/parallel.h"
#include "scene/shape.h"
#include "scene/world.h"
#include "sim/simulation.h"

/* Distances in spacings. A piece has liquid in front of it within NEAR, and none if there is none within FAR: the first
 * row of liquid is half a spacing away. A gap is thin up to THIN; from WIDE on it is none, as particles enter it. Between
 * them both count in part, so that forces do not jump. The other wall is looked for BESIDE the normal. These and the
 * numbers below were chosen with boxes and circles on the floor of a full tank, by all methods (tests/test_gaps.c). */
static const double NEAR = 1, FAR = 1.5, THIN = 1, WIDE = 1.5, BESIDE = 0.75;
/* How far the pressure at an end is sampled; what liquid covers of a piece that it is near, but around a corner. */
static const double SAMPLE = 2, AROUND = 0.5;
/* Liquid in a gap with this part of its pressure exerts all of it: pressures fluctuate. */
static const double ENOUGH = 0.5;
/* Liquid enters a gap at this part of the speed of sound, and as fast its pressure follows that at the ends: about the
 * largest speed that a scene has. */
static const double ENTRY = 0.1;
/* Depth of the first layer of boundary particles; the least cosine between a piece's normal and that of a side. */
static const double LAYER = 0.5, FACING = 0.5;

/* ---- pieces ------------------------------------------------------------------------------------------------------ */

/** Cuts a segment into pieces of a spacing or less, and returns their number; sets them unless NULL. */
static size_t cut(const sph2d__segment *s, double spacing, double sense, sph2d__gap_piece *pieces)
{
    double x = s->b.x - s->a.x, y = s->b.y - s->a.y;
    size_t count = (size_t)fmax(1, ceil(hypot(x, y) / spacing - 1e-9));
    sph2d_vec2 normal = {sense * y / (double)count, -sense * x / (double)count};
    for (size_t k = 0; pieces && k < count; ++k) {
        double part = ((double)k + 0.5) / (double)count;
        pieces[k] = (sph2d__gap_piece){{s->a.x + part * x, s->a.y + part * y}, normal};
    }
    return count;
}

static size_t cut_outline(const sph2d_shape *outline, double spacing, sph2d__gap_piece *pieces)
{
    size_t count = 0, segments = sph2d__shape_pieces(outline, spacing);
    sph2d_vec2 origin = sph2d__shape_piece(outline, spacing, 0).a;
    double area = 0; /* twice; positive anticlockwise, when what lies on the right of a segment is outside */
    for (size_t k = 0; k < segments; ++k) {
        sph2d__segment s = sph2d__shape_piece(outline, spacing, k);
        area += (s.a.x - origin.x) * (s.b.y - origin.y) - (s.b.x - origin.x) * (s.a.y - origin.y);
    }
    for (size_t k = 0; k < segments; ++k) {
        sph2d__segment s = sph2d__shape_piece(outline, spacing, k);
        count += cut(&s, spacing, area > 0 ? 1 : -1, pieces ? pieces + count : NULL);
    }
    return count;
}

sph2d_status sph2d__gaps_create(sph2d_sim *sim)
{
    sph2d__gaps *g = &sim->bodies.gaps;
    size_t bodies = sim->world.scene.body_count, count = 0;
    double spacing = sim->system.spacing;
    g->first = sph2d__arena_alloc(&sim->arena, &sim->memory, bodies + 1, sizeof *g->first);
    if (!g->first)
        return SPH2D_NOMEM;
    for (size_t k = 0; k < bodies; ++k) {
        g->first[k] = count;
        count += cut_outline(&sim->world.scene.bodies[k].shape, spacing, NULL);
    }
    g->first[bodies] = count;
    g->pieces = sph2d__arena_alloc(&sim->arena, &sim->memory, count, sizeof *g->pieces);
    g->fronts = sph2d__arena_alloc(&sim->arena, &sim->memory, count, sizeof *g->fronts);
    if (!g->pieces || !g->fronts)
        return SPH2D_NOMEM;
    for (size_t k = 0; k < bodies; ++k)
        cut_outline(&sim->world.scene.bodies[k].shape, spacing, g->pieces + g->first[k]);
    return SPH2D_OK;
}

/* ---- what is in front of a piece --------------------------------------------------------------------------------- */

/** 1 up to `from`, 0 from `to` on. */
static double fade(double value, double from, double to)
{
    return fmax(0, fmin(1, (to - value) / (to - from)));
}

/** The ranges of particles around a position; false where there are none. */
static bool ranges_at(const sph2d__cells *cells, sph2d_vec2 at, sph2d__ranges *to)
{
    uint32_t cell = sph2d__cells_find(cells, at.x, at.y);
    if (cell != UINT32_MAX)
        sph2d__cells_ranges(cells, cell, to);
    return cell != UINT32_MAX;
}

static sph2d_vec2 wrapped(const sph2d__period *p, sph2d_vec2 at)
{
    return (sph2d_vec2){sph2d__period_wrap(at.x, p->low_x, p->length_x),
                        sph2d__period_wrap(at.y, p->low_y, p->length_y)};
}

/** The distance along a piece's normal to the nearest side of the domain that is a wall, also without particles. */
static double distance_of_sides(const sph2d__world *world, sph2d_vec2 at, sph2d_vec2 normal)
{
    const double out[SPH2D__WALL_OBSTACLE] = {-normal.x, normal.x, -normal.y, normal.y};
    double length = hypot(normal.x, normal.y), nearest = INFINITY;
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side)
        if (sph2d__side_of(&world->scene, side) == SPH2D_SIDE_WALL && out[side] > FACING * length)
            nearest = fmin(nearest, sph2d__side_distance(&world->box, side, at) * length / out[side]);
    return nearest;
}

/** The distance of the nearest other wall along a piece's normal [spacings], infinite if there is none near. */
static double find_wall(const sph2d_sim *sim, const sph2d__rigid *r, sph2d__gap_front *front, sph2d_vec2 normal)
{
    const sph2d__system *s = &sim->system;
    const sph2d__store *w = &s->walls;
    sph2d__ranges ranges;
    sph2d_vec2 at = wrapped(&s->wall_cells.period, front->at);
    double length = hypot(normal.x, normal.y), nearest = distance_of_sides(&sim->world, at, normal) / s->spacing;
    front->beside = UINT64_MAX;
    if (!ranges_at(&s->wall_cells, at, &ranges))
        return nearest;
    SPH2D__FOR_NEIGHBOURS (&ranges, k, b) {
        if (w->id[b] >= r->first_id && w->id[b] < r->end_id)
            continue;
        double x = w->x[b] - at.x - ranges.x[k], y = w->y[b] - at.y - ranges.y[k];
        double along = (x * normal.x + y * normal.y) / (length * s->spacing) - LAYER;
        double across = fabs(x * normal.y - y * normal.x) / (length * s->spacing);
        if (across < BESIDE && along > -2 * LAYER && along < nearest) {
            nearest = along;
            front->beside = w->id[b];
        }
    }
    return nearest;
}

/** The pressure of the liquid around a position, there, and how far liquid covers a piece of the outline there. */
static double find_liquid(const sph2d_sim *sim, sph2d_vec2 place, sph2d_vec2 normal, double *pressure)
{
    const sph2d__system *s = &sim->system;
    const sph2d__store *f = &s->fluid;
    sph2d__ranges ranges;
    sph2d_vec2 at = wrapped(&s->fluid_cells.period, place);
    double front = INFINITY, nearest = INFINITY, sum = 0, count = 0;
    if (!ranges_at(&s->fluid_cells, at, &ranges))
        return 0;
    SPH2D__FOR_NEIGHBOURS (&ranges, k, j) {
        double x = f->x[j] - at.x - ranges.x[k], y = f->y[j] - at.y - ranges.y[k], d = hypot(x, y) / s->spacing;
        if (d >= SAMPLE)
            continue;
        sum += f->pressure[j] - s->rest_density * (s->forces.gravity.x * x + s->forces.gravity.y * y);
        ++count;
        nearest = fmin(nearest, d);
        if (x * normal.x + y * normal.y > 0)
            front = fmin(front, d);
    }
    /* No lasting pressure is above that of the scene's head; particles that are squeezed beside a gap have more. */
    *pressure = count > 0 ? fmin(sum / count, s->rest_density * s->head) : 0;
    return fmax(fade(front, NEAR, FAR), AROUND * fade(nearest, NEAR, FAR));
}

/** Looks what is in front of the pieces of body k. Around one that no wall is near liquid is not looked for. */
static void look(const sph2d_sim *sim, size_t k)
{
    const sph2d__gaps *g = &sim->bodies.gaps;
    const sph2d__rigid *r = &sim->bodies.items[k];
    sph2d__pose pose = sph2d__rigid_at(r, r->now);
    bool thin = false;
    for (size_t i = g->first[k]; i < g->first[k + 1]; ++i) {
        sph2d__gap_front *front = &g->fronts[i];
        *front = (sph2d__gap_front){.at = sph2d__pose_apply(&pose, g->pieces[i].at)};
        front->part = fade(find_wall(sim, r, front, sph2d__pose_turn(&pose, g->pieces[i].normal)), THIN, WIDE);
        thin = thin || front->part > 0;
    }
    for (size_t i = g->first[k]; thin && i < g->first[k + 1]; ++i)
        g->fronts[i].liquid =
            find_liquid(sim, g->fronts[i].at, sph2d__pose_turn(&pose, g->pieces[i].normal), &g->fronts[i].pressure);
}

/* ---- forces ------------------------------------------------------------------------------------------------------ */

/** The body with a boundary particle; NULL if it is another wall's. */
static sph2d__rigid *body_of(const sph2d_sim *sim, uint64_t id)
{
    size_t low = 0, high = sim->bodies.count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (id < sim->bodies.items[middle].first_id)
            high = middle;
        else if (id >= sim->bodies.items[middle].end_id)
            low = middle + 1;
        else
            return &sim->bodies.items[middle];
    }
    return NULL;
}

static void push(const sph2d_sim *sim, sph2d__rigid *r, sph2d_vec2 at, double x, double y)
{
    const sph2d__period *p = &sim->system.wall_cells.period;
    sph2d_vec2 center = sph2d__rigid_center(r, r->now);
    double arm_x = sph2d__period_nearest(at.x - center.x, p->length_x);
    double arm_y = sph2d__period_nearest(at.y - center.y, p->length_y);
    r->state->gap = sph2d__twist_add(r->state->gap, 1, (sph2d__twist){x, y, arm_x * y - arm_y * x});
}

/** rho g.x: what pressure gains by gravity. */
static double weight_at(const sph2d_sim *sim, sph2d_vec2 at)
{
    const sph2d__forces *b = &sim->system.forces;
    return sim->system.rest_density * (b->gravity.x * at.x + b->gravity.y * at.y);
}

/** All gaps of a body with liquid at both ends. */
typedef struct gap_sum {
    double length;     /**< [m] */
    sph2d_vec2 middle; /**< times the length */
    double head;       /**< p - rho g.x, summed over the ends [Pa] */
    size_t ends;
} gap_sum;

/** Adds the gap of `count` pieces after piece `start`, or drops it if an end is dry. */
static void add_gap(const sph2d_sim *sim, size_t k, size_t start, size_t count, gap_sum *sum)
{
    const sph2d__gaps *g = &sim->bodies.gaps;
    size_t first = g->first[k], all = g->first[k + 1] - first;
    const sph2d__gap_front *from = &g->fronts[first + start % all], *to = &g->fronts[first + (start + count + 1) % all];
    bool wet = from->liquid > 0 && to->liquid > 0;
    for (size_t n = 1; n <= count; ++n) {
        size_t i = first + (start + n) % all;
        sph2d__gap_front *front = &g->fronts[i];
        double length = front->part * hypot(g->pieces[i].normal.x, g->pieces[i].normal.y);
        front->part = wet ? front->part : 0;
        sum->length += wet ? length : 0;
        sum->middle.x += wet ? length * front->at.x : 0;
        sum->middle.y += wet ? length * front->at.y : 0;
    }
    if (count > 0 && wet) {
        sum->head += from->pressure - weight_at(sim, from->at) + to->pressure - weight_at(sim, to->at);
        sum->ends += 2;
    }
}

static gap_sum sum_gaps(const sph2d_sim *sim, size_t k)
{
    const sph2d__gaps *g = &sim->bodies.gaps;
    const sph2d__gap_front *fronts = &g->fronts[g->first[k]];
    size_t all = g->first[k + 1] - g->first[k], start = 0, count = 0;
    gap_sum sum = {0};
    while (start < all && fronts[start].part > 0)
        ++start;
    for (size_t n = 1; start < all && n <= all; ++n) {
        bool ends = !(fronts[(start + n) % all].part > 0);
        if (ends)
            add_gap(sim, k, start + n - count - 1, count, &sum);
        count = ends ? 0 : count + 1;
    }
    return sum;
}

/** Presses on a piece of a gap with its pressure p, and on the body in front, as far as liquid does not: some particles
 *  may have been shut in, without pressure. Of two bodies the first one of the scene has the gap. */
static void press_piece(sph2d_sim *sim, sph2d__rigid *r, const sph2d__pose *pose, size_t i, double p)
{
    const sph2d__gap_front *front = &sim->bodies.gaps.fronts[i];
    sph2d__rigid *other = body_of(sim, front->beside);
    if (!(p > 0) || (other && other < r))
        return;
    double exerted = fmax(0, fmin(1, front->pressure / (ENOUGH * p)));
    double missing = p * front->part * (1 - front->liquid * exerted);
    sph2d_vec2 normal = sph2d__pose_turn(pose, sim->bodies.gaps.pieces[i].normal);
    push(sim, r, front->at, -missing * normal.x, -missing * normal.y);
    if (other)
        push(sim, other, front->at, missing * normal.x, missing * normal.y);
}

static void press_gaps_of(sph2d_sim *sim, size_t k)
{
    const sph2d__system *s = &sim->system;
    const sph2d__gaps *g = &sim->bodies.gaps;
    sph2d__rigid *r = &sim->bodies.items[k];
    gap_sum sum = sum_gaps(sim, k);
    double *pressure = &r->state->gap_pressure;
    if (!(sum.length > 0)) {
        *pressure = 0;
        return;
    }
    sph2d_vec2 middle = {sum.middle.x / sum.length, sum.middle.y / sum.length};
    double wanted = sum.head / (double)sum.ends + weight_at(sim, middle);
    double follow = fmin(1, s->step * s->sound_speed * ENTRY / sum.length);
    *pressure += follow * (wanted - *pressure);
    sph2d__pose pose = sph2d__rigid_at(r, r->now);
    for (size_t i = g->first[k]; i < g->first[k + 1]; ++i)
        if (g->fronts[i].part > 0)
            press_piece(sim, r, &pose, i, *pressure + weight_at(sim, g->fronts[i].at) - weight_at(sim, middle));
}

void sph2d__gaps_press(sph2d_sim *sim)
{
    size_t bodies = sim->bodies.count;
#pragma omp taskloop num_tasks(sph2d__tasks(bodies, 1)) if (bodies > 1)
    for (size_t k = 0; k < bodies; ++k)
        look(sim, k);
    for (size_t k = 0; k < bodies; ++k)
        sim->bodies.items[k].state->gap = (sph2d__twist){0, 0, 0};
    for (size_t k = 0; k < bodies; ++k)
        press_gaps_of(sim, k);
}
