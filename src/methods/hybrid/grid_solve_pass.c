/* SPDX-License-Identifier: MIT */
/** @file grid_solve_pass.c
 *  Liquid and air on the grid of method `hybrid`, their equations, and what faces say of the solution. */
#include <math.h>
#include <string.h>

#include "methods/hybrid/grid.h"

/* Squares with more of their full mass are liquid. */
static const float LIQUID = 0.5F;
/* The least part of the way from a square to a surface: nearer ones would make the equations stiff. */
static const float NEAREST = 0.1F;
/* Bounds of the density that is put right in a step; at a surface the density that is tolerated. */
static const float MOST = 0.1F, SURFACE = 0.02F;
/* Iterations for pressure, which starts from that of the step before, and for displacements. */
enum { PRESSURE_ITERATIONS = 3, VOLUME_ITERATIONS = 2, BODY_ITERATIONS = 3 };

static inline float ratio(float value, float weight)
{
    const float by = weight > 1e-6F ? weight : 1;
    return weight > 1e-6F ? value / by : 0;
}

/** Means of what was summed; walls' velocities on closed faces. There is no room in the ring. */
static void take_means(const sph2d__grid *g)
{
    const sph2d__sums *s = &g->sums;
    for (int j = g->first; j <= g->last; ++j)
        SPH2D__FOR_SPAN(g, j, k)
        {
            const sph2d__quad m = s->middle[k];
            g->mass[k] = m[0] * g->room[k];
            g->excess[k] = ratio(m[1], m[0]);
            g->q[k] = ratio(m[2], m[0]);
            g->u[k] = g->open_x[k] > 0 ? ratio(s->x[k].value, s->x[k].weight) : g->wall_x[k];
            g->v[k] = g->open_y[k] > 0 ? ratio(s->y[k].value, s->y[k].weight) : g->wall_y[k];
        }
    for (const sph2d__nozzle *z = g->nozzles, *end = z + g->nozzle_count; z < end; ++z)
        if (z->open && !((z->x ? g->open_x : g->open_y)[z->face] > 0))
            (z->x ? g->u : g->v)[z->face] = z->speed;
}

/* Of squares whose middle is in a solid, how full they are is not yet known. */
static const float UNKNOWN = -1;

/** How full the part of a square outside solids is, by what it says itself or, where its middle is in one, in `known`. */
static inline float fullness(const sph2d__grid *g, const float *known, size_t k)
{
    const float outside = 1 - g->hidden[k];
    return outside > 0.5F ? g->mass[k] / outside : known[k];
}

/** Adds how full a square beside another is, by the open part of the face between them. */
static inline void add_beside(const sph2d__grid *g, const float *known, size_t k, float open, float *sum, float *weight)
{
    const float full = fullness(g, known, k);
    if (open > 0 && full >= 0) {
        *sum += open * full;
        *weight += open;
    }
}

/** How full the squares beside one are, in the mean; UNKNOWN where there is none that tells. */
static float mean_beside(const sph2d__grid *g, const float *known, size_t k)
{
    const size_t up = g->stride;
    float sum = 0, weight = 0;
    add_beside(g, known, k - 1, g->open_x[k], &sum, &weight);
    add_beside(g, known, k + 1, g->open_x[k + 1], &sum, &weight);
    add_beside(g, known, k - up, g->open_y[k], &sum, &weight);
    add_beside(g, known, k + up, g->open_y[k + up], &sum, &weight);
    return weight > 0 ? sum / (weight > 0 ? weight : 1) : UNKNOWN;
}

/** Tells of `count` squares with their middle in a solid how full they are, by those beside them, one after the other: through
 *  gaps too narrow for particles to tell. */
static void spread_inwards(const sph2d__grid *g, float *known, uint32_t *left, size_t count)
{
    size_t before;
    do {
        before = count;
        for (size_t n = 0; n < count; ++n)
            g->filled[n] = mean_beside(g, known, left[n]);
        count = 0;
        for (size_t n = 0; n < before; ++n) {
            known[left[n]] = g->filled[n];
            if (g->filled[n] < 0)
                left[count++] = left[n];
        }
    } while (count < before);
}

/** What a solid hides of a square is as full as what lies beside it: as air it would be a sink. Of the squares that are cut
 *  those count that the step sets. */
static void fill_cut_squares(const sph2d__grid *g)
{
    float *beside = g->pressure.residual,
          *known = g->s; /* free before the pressure; s is 0 where the step sets nothing */
    uint32_t *here = g->pocket_end, *left = g->member; /* free before there are pockets */
    size_t count = 0, inside = 0;
    for (size_t n = 0; n < g->cut_count; ++n) {
        const uint32_t k = g->cut[n], j = k / (uint32_t)g->stride, i = k - j * (uint32_t)g->stride;
        if ((int)i >= g->begin[j] && (int)i < g->end[j]) {
            here[count++] = k;
            known[k] = UNKNOWN;
        }
    }
    for (size_t n = 0; n < count; ++n) {
        beside[here[n]] = mean_beside(g, known, here[n]);
        if (!(g->hidden[here[n]] < 0.5F))
            left[inside++] = here[n];
    }
    spread_inwards(g, known, left, inside);
    for (size_t n = 0; n < count; ++n) {
        const uint32_t k = here[n];
        const float by = g->hidden[k] < 0.5F ? beside[k] : known[k];
        g->mass[k] += by > 0 ? g->hidden[k] * by : 0;
    }
}

static inline bool is_liquid(const sph2d__grid *g, size_t k)
{
    return g->mass[k] > LIQUID;
}

/** Sets the first and the last liquid square of each row. In a periodic domain, whose ends are neighbours, rows are whole. */
static void find_liquid(const sph2d__grid *g)
{
    const sph2d__level *l = g->level;
    for (int j = 1; j <= g->ny; ++j) {
        const size_t row = sph2d__at(g, 0, j);
        int from = g->begin[j] > 1 ? g->begin[j] : 1, to = g->end[j] <= g->nx ? g->end[j] - 1 : g->nx;
        while (!(g->wraps_x || g->wraps_y) && to >= 1 && !is_liquid(g, row + (size_t)to))
            --to;
        while (!(g->wraps_x || g->wraps_y) && from < to && !is_liquid(g, row + (size_t)from))
            ++from;
        l->from[j] = to < 1 ? g->nx + 1 : from; /* none: beyond all others */
        l->to[j] = to;
    }
    l->from[0] = l->from[g->ny + 1] = g->nx + 1;
    l->to[0] = l->to[g->ny + 1] = 0;
}

/** Runs the statement behind it for the squares k of row j with a left or lower face that liquid touches. */
#define FOR_FACES(g, j, k)                                                                                             \
    for (size_t k = sph2d__at(g, 0, j) + (size_t)lower((g)->level->from[j], (g)->level->from[(j)-1]),                  \
                last_ = sph2d__at(g, 0, j) + (size_t)higher((g)->level->to[j], (g)->level->to[(j)-1]) + 1;             \
         k <= last_; ++k)

static int lower(int a, int b)
{
    return a < b ? a : b;
}

static int higher(int a, int b)
{
    return a > b ? a : b;
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

static void clear(const sph2d__grid *g, float *field)
{
    for (int j = g->first; j <= g->last; ++j)
        memset(field + sph2d__at(g, g->begin[j], j), 0, (size_t)(g->end[j] - g->begin[j]) * sizeof *field);
}

/** Couplings of the faces. */
static void couple(sph2d__grid *g)
{
    const sph2d__level *l = g->level;
    const float across = g->hy / g->hx, along = g->hx / g->hy;
    const size_t up = g->stride;
    for (int j = 1; j <= g->ny + 1; ++j)
        FOR_FACES(g, j, k)
        {
            couple_face(g->mass[k], g->mass[k - 1], g->open_x[k], across, &l->left[k], &g->air_x[k], &g->wet_x[k]);
            couple_face(g->mass[k], g->mass[k - up], g->open_y[k], along, &l->below[k], &g->air_y[k], &g->wet_y[k]);
        }
}

/** What flows through a face, per length. */
static inline float flow(float open, float u, float wall)
{
    return open * u + (1 - open) * wall;
}

/** Diagonals and right sides: what flows in. */
static void set_equations(sph2d__grid *g)
{
    const sph2d__level *l = g->level;
    const float across = g->hy / g->hx, along = g->hx / g->hy;
    const size_t up = g->stride;
    for (int j = 1; j <= g->ny; ++j)
        for (size_t k = sph2d__at(g, l->from[j], j), end = sph2d__at(g, l->to[j] + 1, j); k < end; ++k) {
            const float liquid = is_liquid(g, k) ? 1 : 0;
            l->air[k] = liquid * (across * (g->open_x[k] * g->air_x[k] + g->open_x[k + 1] * g->air_x[k + 1]) +
                                  along * (g->open_y[k] * g->air_y[k] + g->open_y[k + up] * g->air_y[k + up]));
            const float sum = l->left[k] + l->left[k + 1] + l->below[k] + l->below[k + up] + l->air[k];
            l->inverse[k] = sum > 0 ? 1 / (sum > 0 ? sum : 1) : 0;
            g->pressure.residual[k] = liquid * (g->hy * (flow(g->open_x[k], g->u[k], g->wall_x[k]) -
                                                         flow(g->open_x[k + 1], g->u[k + 1], g->wall_x[k + 1])) +
                                                g->hx * (flow(g->open_y[k], g->v[k], g->wall_y[k]) -
                                                         flow(g->open_y[k + up], g->v[k + up], g->wall_y[k + up])));
        }
}

/** Adds what sources emit. */
static void feed(const sph2d__grid *g)
{
    for (const sph2d__nozzle *z = g->nozzles, *end = z + g->nozzle_count; z < end; ++z)
        if (z->open && is_liquid(g, z->square))
            g->pressure.residual[z->square] += z->flow;
}

/** The right side for displacements. */
static void set_volumes(sph2d__grid *g)
{
    const sph2d__level *l = g->level;
    clear(g, g->s);
    for (int j = 1; j <= g->ny; ++j)
        for (size_t k = sph2d__at(g, l->from[j], j), end = sph2d__at(g, l->to[j] + 1, j); k < end; ++k) {
            const float e = g->excess[k] > MOST ? MOST : g->excess[k] < -MOST ? -MOST : g->excess[k];
            const float at_air = e > SURFACE ? e - SURFACE : 0, wrong = l->air[k] > 0 ? at_air : e;
            const float part = 0.5F + depth_of(1 - g->hidden[k]), full = part > 1 ? 1 : part > 0 ? part : 0;
            g->volume.residual[k] = is_liquid(g, k) ? g->hx * g->hy * full * wrong : 0;
        }
}

/** What a face says: `part` of the difference of q and s over a square's side. */
static inline sph2d__quad face_of(float part, float velocity, float change, float displacement)
{
    return part > 0 ? (sph2d__quad){velocity + part * change, part * displacement, 1} : (sph2d__quad){0};
}

/** A side's wall is known where liquid touches it, and so is a source. */
static void close_sides(sph2d__grid *g)
{
    for (const sph2d__nozzle *z = g->nozzles, *end = z + g->nozzle_count; z < end; ++z)
        if (z->open && z->part > 0.5F && is_liquid(g, z->square))
            (z->x ? g->face_x : g->face_y)[z->face] = (sph2d__quad){z->speed, 0, 1};
    for (int side = 0; side < 4; ++side) {
        const bool vertical = side < 2;
        if (g->open[side] || (vertical ? g->wraps_x : g->wraps_y))
            continue;
        const int n = vertical ? g->ny : g->nx, at = side % 2 == 0 ? 1 : vertical ? g->nx + 1 : g->ny + 1;
        for (int m = 1; m <= n; ++m) {
            const size_t k = vertical ? sph2d__at(g, at, m) : sph2d__at(g, m, at);
            const size_t in = side % 2 == 0 ? k : vertical ? k - 1 : k - g->stride;
            if (is_liquid(g, in))
                (vertical ? g->face_x : g->face_y)[k][SPH2D__KNOWN] = 1;
        }
    }
}

/** Pressure beyond a closed face: it turns what flows there into the velocity of the wall. It is what particles near walls
 *  read, where several faces lead to a square their mean. */
static void continue_pressure(sph2d__grid *g)
{
    const sph2d__level *l = g->level;
    const size_t up = g->stride;
    float *sum = g->pressure.residual, *count = g->pressure.direction;
    clear(g, sum);
    clear(g, count);
    for (int j = 1; j <= g->ny + 1; ++j)
        FOR_FACES(g, j, k)
        {
            const sph2d__pair2 u = g->sums.x[k], v = g->sums.y[k];
            if (!(g->open_x[k] > 0) && is_liquid(g, k) != is_liquid(g, k - 1)) {
                const float x = g->hx * (g->wall_x[k] - ratio(u.value, u.weight));
                const size_t to = is_liquid(g, k) ? k - 1 : k;
                sum[to] += is_liquid(g, k) ? g->q[k] + x : g->q[k - 1] - x;
                count[to] += 1;
            }
            if (!(g->open_y[k] > 0) && is_liquid(g, k) != is_liquid(g, k - up)) {
                const float y = g->hy * (g->wall_y[k] - ratio(v.value, v.weight));
                const size_t to = is_liquid(g, k) ? k - up : k;
                sum[to] += is_liquid(g, k) ? g->q[k] + y : g->q[k - up] - y;
                count[to] += 1;
            }
        }
    for (int j = g->first; j <= g->last; ++j)
        SPH2D__FOR_SPAN(g, j, k)
    if (count[k] > 0 && !(l->inverse[k] > 0))
        g->q[k] = sum[k] / count[k];
}

static void set_faces(sph2d__grid *g)
{
    const float nx = 1 / g->hx, ny = 1 / g->hy;
    const size_t up = g->stride;
    for (int j = 1; j <= g->ny + 1; ++j)
        FOR_FACES(g, j, k)
        {
            g->face_x[k] = face_of(g->wet_x[k], g->u[k], nx * (g->q[k - 1] - g->q[k]), nx * (g->s[k - 1] - g->s[k]));
            g->face_y[k] = face_of(g->wet_y[k], g->v[k], ny * (g->q[k - up] - g->q[k]), ny * (g->s[k - up] - g->s[k]));
        }
    close_sides(g);
}

/** Adds `factor` times what pressure changes velocities by. */
static void press(sph2d__grid *g, float factor)
{
    const float nx = factor / g->hx, ny = factor / g->hy;
    const size_t up = g->stride;
    for (int j = 1; j <= g->ny + 1; ++j)
        FOR_FACES(g, j, k)
        {
            g->u[k] += nx * g->wet_x[k] * (g->q[k - 1] - g->q[k]);
            g->v[k] += ny * g->wet_y[k] * (g->q[k - up] - g->q[k]);
        }
    sph2d__level_wrap(g, g->level, g->u);
    sph2d__level_wrap(g, g->level, g->v);
}

/** Viscosity acts on what the pressure of the last step leaves of the forces: on all of them it would hold up liquid at rest
 *  along walls without slip, as high as if it weighed less within sqrt(nu dt) of them. */
static void apply_viscosity(sph2d__grid *g, double viscosity)
{
    if (!sph2d__grid_is_viscous(g, viscosity))
        return;
    for (int j = g->first; j <= g->last; ++j)
        SPH2D__FOR_SPAN(g, j, k)
    g->q[k] = is_liquid(g, k) ? g->q[k] : 0;
    sph2d__level_wrap(g, g->level, g->q);
    press(g, 1);
    sph2d__grid_viscosity(g, viscosity);
    press(g, -1);
}

static void wrap_quads(const sph2d__grid *g, sph2d__quad *a)
{
    for (int j = 1; j <= g->ny + 1 && g->wraps_x; ++j) {
        sph2d__quad *row = a + (size_t)j * g->stride;
        row[0] = row[g->nx];
        row[g->nx + 1] = row[1];
        row[g->nx + 2] = row[2];
    }
    if (g->wraps_y) {
        memcpy(a, a + (size_t)g->ny * g->stride, g->stride * sizeof *a);
        memcpy(a + (size_t)(g->ny + 1) * g->stride, a + g->stride, 2 * g->stride * sizeof *a);
    }
}

static void solve(sph2d__grid *g, double viscosity)
{
    const sph2d__level *l = g->level;
    take_means(g);
    sph2d__level_wrap(g, l, g->mass);
    fill_cut_squares(g);
    sph2d__level_wrap(g, l, g->mass);
    find_liquid(g);
    couple(g);
    float *const ringed[] = {g->u, g->v, g->wet_x, g->wet_y};
    for (size_t n = 0; n < sizeof ringed / sizeof *ringed; ++n)
        sph2d__level_wrap(g, l, ringed[n]);
    apply_viscosity(g, viscosity);
    set_equations(g);
    feed(g);
    sph2d__grid_find_pockets(g);
    set_volumes(g);
    sph2d__grid_level_pockets(g, g->pressure.residual);
    sph2d__grid_level_pockets(g, g->volume.residual);
    for (int j = g->first; j <= g->last; ++j)
        SPH2D__FOR_SPAN(g, j, k)
    g->q[k] = l->inverse[k] > 0 ? g->q[k] : 0;
    sph2d__grid_wet_parts(g);
    sph2d__grid_send(g);
    g->solver->prepare(g);
#pragma omp task if (!g->on_device)
    g->solver->solve(g, &g->volume, g->s, false, VOLUME_ITERATIONS); /* around bodies where they are */
    g->solver->solve(g, &g->pressure, g->q, true, PRESSURE_ITERATIONS + BODY_ITERATIONS * (int)g->body_count);
#pragma omp taskwait
    sph2d__grid_fetch(g);
    sph2d__grid_level_pockets(g, g->q);
    sph2d__level_wrap(g, l, g->q);
    sph2d__level_wrap(g, l, g->s);
    set_faces(g);
    continue_pressure(g);
    wrap_quads(g, g->face_x);
    wrap_quads(g, g->face_y);
}

const sph2d__grid_passes SPH2D__OF_ISA(sph2d__grid_passes) = {solve};
