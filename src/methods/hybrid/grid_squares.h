/* SPDX-License-Identifier: MIT */
/** @file grid_squares.h
 *  What a solution does to one square of the grid of method `hybrid`, or to one of its lines, in C and in OpenCL C: grid_solve_pass.c. */
#ifndef SPH2D_METHODS_HYBRID_GRID_SQUARES_H
#define SPH2D_METHODS_HYBRID_GRID_SQUARES_H

#include <math.h>

#include "methods/hybrid/multigrid.h"

/* Squares with more of their full mass are liquid. */
SPH2D__FIXED float LIQUID = 0.5F;
/* The least part of the way from a square to a surface: nearer ones would make the equations stiff. */
SPH2D__FIXED float NEAREST = 0.1F;
/* Bounds of the density that is put right in a step; at a surface the density that is tolerated. */
SPH2D__FIXED float MOST = 0.1F, SURFACE = 0.02F;
static inline float ratio(float value, float weight)
{
    const float by = weight > 1e-6F ? weight : 1;
    return weight > 1e-6F ? value / by : 0;
}

static inline bool is_liquid(const sph2d__grid *g, size_t k)
{
    return g->mass[k] > LIQUID;
}

/* ---- means ------------------------------------------------------------------------------------------------------- */

/** Means of what was summed; walls' velocities on closed faces. There is no room in the ring. */
static inline void take_mean(const sph2d__grid *g, size_t k)
{
    const sph2d__pair2 x = g->sums.x[k], y = g->sums.y[k];
    const sph2d__quad m = g->sums.middle[k];
    g->mass[k] = SPH2D__PART(m, 0) * g->room[k];
    g->excess[k] = ratio(SPH2D__PART(m, 1), SPH2D__PART(m, 0));
    g->q[k] = ratio(SPH2D__PART(m, 2), SPH2D__PART(m, 0));
    g->u[k] = g->open_x[k] > 0 ? ratio(x.value, x.weight) : g->wall_x[k];
    g->v[k] = g->open_y[k] > 0 ? ratio(y.value, y.weight) : g->wall_y[k];
}

/** What sources emit, on their faces. */
static inline void set_jets(const sph2d__grid *g)
{
    for (size_t n = 0; n < g->nozzle_count; ++n) {
        const sph2d__nozzle z = g->nozzles[n];
        if (z.open && !((z.x ? g->open_x : g->open_y)[z.face] > 0))
            (z.x ? g->u : g->v)[z.face] = z.speed;
    }
}

/* ---- squares that solids cut ------------------------------------------------------------------------------------- */

/* Of squares whose middle is in a solid, how full they are is not yet known. */
SPH2D__FIXED float UNKNOWN = -1;

/** How full the part of a square outside solids is, by what it says itself or, where its middle is in one, in `known`. */
static inline float fullness(const sph2d__grid *g, SPH2D__ARRAY const float *known, size_t k)
{
    const float outside = 1 - g->hidden[k];
    return outside > 0.5F ? g->mass[k] / outside : known[k];
}

/** Adds how full a square beside another is, by the open part of the face between them. */
static inline void add_beside(const sph2d__grid *g, SPH2D__ARRAY const float *known, size_t k, float open, float *sum,
                              float *weight)
{
    const float full = fullness(g, known, k);
    if (open > 0 && full >= 0) {
        *sum += open * full;
        *weight += open;
    }
}

/** How full the squares beside one are, in the mean; UNKNOWN where there is none that tells. */
static inline float mean_beside(const sph2d__grid *g, SPH2D__ARRAY const float *known, size_t k)
{
    const size_t up = g->stride;
    float sum = 0, weight = 0;
    add_beside(g, known, k - 1, g->open_x[k], &sum, &weight);
    add_beside(g, known, k + 1, g->open_x[k + 1], &sum, &weight);
    add_beside(g, known, k - up, g->open_y[k], &sum, &weight);
    add_beside(g, known, k + up, g->open_y[k + up], &sum, &weight);
    return weight > 0 ? sum / (weight > 0 ? weight : 1) : UNKNOWN;
}

/** Whether a step sets a square. */
static inline bool is_set(const sph2d__grid *g, size_t k)
{
    const int j = (int)(k / g->stride), i = (int)(k % g->stride);
    return i >= g->begin[j] && i < g->end[j];
}

/** What a solid hides of a square is as full as what lies beside it: as air it would be a sink. `beside`, `known`: how full that is, by
 *  where the square's middle is. */
static inline void fill_hidden(const sph2d__grid *g, SPH2D__ARRAY const float *beside, SPH2D__ARRAY const float *known,
                               size_t k)
{
    const float by = g->hidden[k] < 0.5F ? beside[k] : known[k];
    g->mass[k] += by > 0 ? g->hidden[k] * by : 0;
}

/* ---- liquid ------------------------------------------------------------------------------------------------------ */

/** Sets the first and the last liquid square of row j. In a periodic domain, whose ends are neighbours, rows are whole. */
static inline void find_liquid_of(const sph2d__grid *g, int j)
{
    const sph2d__level *l = g->level;
    const size_t row = sph2d__at(g, 0, j);
    const bool wraps = g->wraps_x || g->wraps_y;
    int from = g->nx + 1, to = 0;
    if (j >= 1 && j <= g->ny) {
        from = g->begin[j] > 1 ? g->begin[j] : 1;
        to = g->end[j] <= g->nx ? g->end[j] - 1 : g->nx;
        while (!wraps && to >= 1 && !is_liquid(g, row + (size_t)to))
            --to;
        while (!wraps && from < to && !is_liquid(g, row + (size_t)from))
            ++from;
    }
    l->from[j] = to < 1 ? g->nx + 1 : from; /* none: beyond all others */
    l->to[j] = to;
}

/** The distance of a square's middle below a straight surface, in squares, by its mass, the part of its bilinear weight
 *  below that surface: m = 1 - (1 - z)^2/2 from 0 on, (1 + z)^2/2 below. */
static inline float depth_of(float mass)
{
    const float full = mass > 1 ? 0 : 1 - mass, empty = mass > 0 ? mass : 0;
    return mass > 0.5F ? 1 - sqrtf(2 * full) : sqrtf(2 * empty) - 1;
}

/** 1 over the part of the way from a liquid square to the surface before its neighbour. */
static inline float air_of(float liquid, float air)
{
    const float below = depth_of(liquid), part = below / (below - depth_of(air) + 1e-6F);
    return 1 / (part > NEAREST ? part : NEAREST);
}

/** Couplings of a face between two squares: *inner between liquid, *air between liquid and air. */
static inline void couple_face(float one, float other, float open, float factor, float *inner, float *air, float *wet)
{
    const float most = one > other ? one : other, least = one > other ? other : one;
    const float both = least > LIQUID && open > 0 ? 1 : 0, edge = most > LIQUID && open > 0 ? 1 - both : 0;
    *inner = both * factor * open;
    *air = edge * air_of(most, least);
    *wet = both + *air;
}

/** Couplings of a square's left and lower face. */
static inline void couple_faces(const sph2d__grid *g, size_t k)
{
    const sph2d__level *l = g->level;
    const float across = g->hy / g->hx, along = g->hx / g->hy;
    float inner, air, wet;
    couple_face(g->mass[k], g->mass[k - 1], g->open_x[k], across, &inner, &air, &wet);
    l->left[k] = inner;
    g->air_x[k] = air;
    g->wet_x[k] = wet;
    couple_face(g->mass[k], g->mass[k - g->stride], g->open_y[k], along, &inner, &air, &wet);
    l->below[k] = inner;
    g->air_y[k] = air;
    g->wet_y[k] = wet;
}

/* ---- equations --------------------------------------------------------------------------------------------------- */

/** What flows through a face, per length. */
static inline float flow(float open, float u, float wall)
{
    return open * u + (1 - open) * wall;
}

/** Diagonal and right side of a square: what flows in. */
static inline void set_equation(const sph2d__grid *g, size_t k)
{
    const sph2d__level *l = g->level;
    const float across = g->hy / g->hx, along = g->hx / g->hy, liquid = is_liquid(g, k) ? 1 : 0;
    const size_t up = g->stride;
    l->air[k] = liquid * (across * (g->open_x[k] * g->air_x[k] + g->open_x[k + 1] * g->air_x[k + 1]) +
                          along * (g->open_y[k] * g->air_y[k] + g->open_y[k + up] * g->air_y[k + up]));
    const float sum = l->left[k] + l->left[k + 1] + l->below[k] + l->below[k + up] + l->air[k];
    l->inverse[k] = sum > 0 ? 1 / (sum > 0 ? sum : 1) : 0;
    g->pressure.residual[k] =
        liquid *
        (g->hy * (flow(g->open_x[k], g->u[k], g->wall_x[k]) - flow(g->open_x[k + 1], g->u[k + 1], g->wall_x[k + 1])) +
         g->hx *
             (flow(g->open_y[k], g->v[k], g->wall_y[k]) - flow(g->open_y[k + up], g->v[k + up], g->wall_y[k + up])));
}

/** Adds what sources emit. */
static inline void feed(const sph2d__grid *g)
{
    for (size_t n = 0; n < g->nozzle_count; ++n) {
        const sph2d__nozzle z = g->nozzles[n];
        if (z.open && is_liquid(g, z.square))
            g->pressure.residual[z.square] += z.flow;
    }
}

/** The right side for displacements. */
static inline void set_volume(const sph2d__grid *g, size_t k)
{
    const float e = g->excess[k] > MOST ? MOST : g->excess[k] < -MOST ? -MOST : g->excess[k];
    const float at_air = e > SURFACE ? e - SURFACE : 0, wrong = g->level->air[k] > 0 ? at_air : e;
    const float part = 0.5F + depth_of(1 - g->hidden[k]), full = part > 1 ? 1 : part > 0 ? part : 0;
    g->volume.residual[k] = is_liquid(g, k) ? g->hx * g->hy * full * wrong : 0;
}

/** Adds `factor` times what pressure changes the velocities of a square's faces by. */
static inline void press_faces(const sph2d__grid *g, float factor, size_t k)
{
    const float nx = factor / g->hx, ny = factor / g->hy;
    g->u[k] += nx * g->wet_x[k] * (g->q[k - 1] - g->q[k]);
    g->v[k] += ny * g->wet_y[k] * (g->q[k - g->stride] - g->q[k]);
}

/* ---- faces ------------------------------------------------------------------------------------------------------- */

/** What a face says: `part` of the difference of q and s over a square's side. */
static inline sph2d__quad face_of(float part, float velocity, float change, float displacement)
{
    return part > 0 ? SPH2D__QUAD(velocity + part * change, part * displacement, 1, 0) : SPH2D__QUAD(0, 0, 0, 0);
}

static inline void set_faces_of(const sph2d__grid *g, size_t k)
{
    const float nx = 1 / g->hx, ny = 1 / g->hy;
    const size_t up = g->stride;
    g->face_x[k] = face_of(g->wet_x[k], g->u[k], nx * (g->q[k - 1] - g->q[k]), nx * (g->s[k - 1] - g->s[k]));
    g->face_y[k] = face_of(g->wet_y[k], g->v[k], ny * (g->q[k - up] - g->q[k]), ny * (g->s[k - up] - g->s[k]));
}

/** A source is known where liquid touches it ... */
static inline void close_jets(const sph2d__grid *g)
{
    for (size_t n = 0; n < g->nozzle_count; ++n) {
        const sph2d__nozzle z = g->nozzles[n];
        if (z.open && z.part > 0.5F && is_liquid(g, z.square))
            (z.x ? g->face_x : g->face_y)[z.face] = SPH2D__QUAD(z.speed, 0, 1, 0);
    }
}

/** ... and so is a side's wall, here its face m from 1 on. */
static inline void close_side(const sph2d__grid *g, int side, int m)
{
    const bool vertical = side < 2;
    const int n = vertical ? g->ny : g->nx, at = side % 2 == 0 ? 1 : vertical ? g->nx + 1 : g->ny + 1;
    if (g->open[side] || (vertical ? g->wraps_x : g->wraps_y) || m > n)
        return;
    const size_t k = vertical ? sph2d__at(g, at, m) : sph2d__at(g, m, at);
    const size_t in = side % 2 == 0 ? k : vertical ? k - 1 : k - g->stride;
    if (is_liquid(g, in))
        SPH2D__KNOWN((vertical ? g->face_x : g->face_y)[k]) = 1;
}

/** Pressure beyond a closed face, on the side without liquid, which is square `to`: it turns what flows there into the velocity of the
 *  wall. */
static inline void add_beyond(const sph2d__grid *g, size_t k, bool x, size_t to, float *sum, float *count)
{
    const size_t other = x ? k - 1 : k - g->stride, wet = to == k ? other : k;
    if ((x ? g->open_x : g->open_y)[k] > 0 || is_liquid(g, to) || !is_liquid(g, wet))
        return;
    const sph2d__pair2 mean = (x ? g->sums.x : g->sums.y)[k];
    const float more = (x ? g->hx : g->hy) * ((x ? g->wall_x : g->wall_y)[k] - ratio(mean.value, mean.weight));
    *sum += to == k ? g->q[wet] - more : g->q[wet] + more;
    *count += 1;
}

/** Continues pressure into square k, where several faces lead to it as their mean. It is what particles near walls read. */
static inline void continue_pressure_to(const sph2d__grid *g, size_t k)
{
    const sph2d__level *l = g->level;
    const int i = (int)(k % g->stride), j = (int)(k / g->stride);
    float sum = 0, count = 0;
    if (l->inverse[k] > 0)
        return;
    if (has_faces(l, i, j)) {
        add_beyond(g, k, true, k, &sum, &count);
        add_beyond(g, k, false, k, &sum, &count);
    }
    if (has_faces(l, i + 1, j))
        add_beyond(g, k + 1, true, k, &sum, &count);
    if (has_faces(l, i, j + 1))
        add_beyond(g, k + g->stride, false, k, &sum, &count);
    if (count > 0)
        g->q[k] = sum / count;
}

/** What the ring of a periodic domain has of faces, which is a square wider than that of squares. */
static inline void wrap_quad(const sph2d__grid *g, SPH2D__ARRAY sph2d__quad *a, int i, int j)
{
    const int column = !g->wraps_x ? i : i == 0 ? g->nx : i == g->nx + 1 || i == g->nx + 2 ? i - g->nx : i;
    const int row = !g->wraps_y ? j : j == 0 ? g->ny : j == g->ny + 1 || j == g->ny + 2 ? j - g->ny : j;
    if ((column != i || row != j) && (g->wraps_y ? j <= g->ny + 2 : j >= 1 && j <= g->ny + 1))
        a[sph2d__at(g, i, j)] = a[sph2d__at(g, column, row)];
}

#endif
