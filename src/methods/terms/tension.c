/* SPDX-License-Identifier: MIT */
/** @file tension.c
 *  Surface tension by the energy of a band along the surface. */
#include "methods/terms/tension.h"

#include <math.h>

#include "base/pi.h"
#include "methods/common/slabs.h"
#include "methods/common/traverse.h"
#include "scene/derive.h"
#include "scene/resolve.h"

#define INNER SPH2D__INNER_RADIUS
#define OUTER SPH2D__OUTER_RADIUS

/* A particle with more neighbours, four times as many as in liquid, counts as covered. */
enum { MAX_NEIGHBOURS = 192 };

/* Neighbours within this distance [dx], which bound most cells, are processed first. */
static const double NEAR = 1.6;

typedef enum kind { LIQUID, WALL } kind;

/** The particles whose Voronoi cells can share an edge with a particle's; relative to it, in spacings. */
typedef struct neighbourhood {
    int count, near; /**< near ones come first */
    double x[MAX_NEIGHBOURS], y[MAX_NEIGHBOURS];
    kind kind[MAX_NEIGHBOURS];
    uint32_t index[MAX_NEIGHBOURS]; /**< in their store */
} neighbourhood;

/** The edge between a particle's Voronoi cell and that of a neighbour, in spacings: on the bisector, at the distance
 *  `foot`, from `from` to `to`, counter-clockwise from the foot; empty unless `from` < `to`. */
typedef struct edge {
    double foot, from, to;
} edge;

/** Adds a neighbour, near ones before the others; the caller has checked the capacity. */
static void add_neighbour(neighbourhood *c, double x, double y, kind what, uint32_t index)
{
    int k = c->count++;
    if (x * x + y * y < NEAR * NEAR) {
        int first = c->near++;
        c->x[k] = c->x[first];
        c->y[k] = c->y[first];
        c->kind[k] = c->kind[first];
        c->index[k] = c->index[first];
        k = first;
    }
    c->x[k] = x;
    c->y[k] = y;
    c->kind[k] = what;
    c->index[k] = index;
}

/** Adds the particles of `from` whose cells can touch that of a particle at (x, y) within the band, without the one
 *  there and without those that only reflect. False when there are too many. */
static bool gather(neighbourhood *c, const sph2d__system *s, const sph2d__store *from, const sph2d__ranges *ranges,
                   double x, double y)
{
    double reach = 2 * OUTER * s->spacing, scale = 1 / s->spacing;
    SPH2D__FOR_NEIGHBOURS (ranges, r, j) {
        double dx = from->x[j] - (x + ranges->x[r]), dy = from->y[j] - (y + ranges->y[r]), r2 = dx * dx + dy * dy;
        if (!(r2 < reach * reach) || r2 == 0 || (from == &s->walls && from->bounce[j] >= 0))
            continue;
        if (c->count == MAX_NEIGHBOURS)
            return false;
        add_neighbour(c, dx * scale, dy * scale, from == &s->walls ? WALL : LIQUID, (uint32_t)j);
    }
    return true;
}

/** A convex polygon around a particle, in spacings. With more corners it counts as open. */
enum { MOST_CORNERS = 24 };
typedef struct polygon {
    int count;
    double x[MOST_CORNERS], y[MOST_CORNERS];
} polygon;

/** The part of a polygon that is nearer to the particle than to a neighbour at (x, y). */
static void cut(const polygon *from, double x, double y, polygon *to)
{
    const double middle = (x * x + y * y) / 2;
    to->count = 0;
    for (int k = 0; k < from->count && to->count + 2 <= MOST_CORNERS; ++k) {
        const int next = k + 1 < from->count ? k + 1 : 0;
        const double here = middle - (x * from->x[k] + y * from->y[k]);
        const double there = middle - (x * from->x[next] + y * from->y[next]);
        if (here >= 0) {
            to->x[to->count] = from->x[k];
            to->y[to->count++] = from->y[k];
        }
        if ((here > 0 && there < 0) || (here < 0 && there > 0)) {
            const double part = here / (here - there);
            to->x[to->count] = from->x[k] + part * (from->x[next] - from->x[k]);
            to->y[to->count++] = from->y[k] + part * (from->y[next] - from->y[k]);
        }
    }
}

/** Whether a part of a particle's cell is farther from it than the inner radius, and has energy: inside the liquid none is. */
static bool is_open(const neighbourhood *c)
{
    polygon cells[2] = {{4, {OUTER, -OUTER, -OUTER, OUTER}, {OUTER, OUTER, -OUTER, -OUTER}}};
    for (int k = 0; k < c->count; ++k) {
        const polygon *cell = &cells[(k + 1) % 2];
        cut(&cells[k % 2], c->x[k], c->y[k], &cells[(k + 1) % 2]);
        if (cell->count + 2 > MOST_CORNERS)
            return true;
        bool open = false;
        for (int n = 0; n < cell->count; ++n)
            open |= cell->x[n] * cell->x[n] + cell->y[n] * cell->y[n] > INNER * INNER;
        if (!open)
            return false;
    }
    return true;
}

/** Gathers the neighbours of particle i; false if it is not at the surface or has too many. */
static bool gather_around(neighbourhood *c, const sph2d__system *s, size_t i, sph2d__cursor *liquid,
                          sph2d__cursor *walls)
{
    double x = s->fluid.x[i], y = s->fluid.y[i];
    c->count = c->near = 0;
    bool fits = !sph2d__cursor_move(liquid, &s->fluid_cells, x, y) || gather(c, s, &s->fluid, &liquid->ranges, x, y);
    if (s->walls_press && sph2d__cursor_move(walls, &s->wall_cells, x, y))
        fits &= gather(c, s, &s->walls, &walls->ranges, x, y);
    return fits && is_open(c);
}

/** The edge with neighbour k, within the outer radius. Clipping stops once the edge is within `clear` of its foot: it
 *  then lies in the inner circle. */
static edge edge_of(const neighbourhood *c, int k, double clear)
{
    double r = sqrt(c->x[k] * c->x[k] + c->y[k] * c->y[k]), half = sqrt(fmax(OUTER * OUTER - r * r / 4, 0));
    double ex = c->x[k] / r, ey = c->y[k] / r;
    edge b = {r / 2, -half, half};
    for (int j = 0; j < c->count && b.from < b.to && (b.to > clear || b.from < -clear); ++j) {
        double x = c->x[j], y = c->y[j], along = ex * y - ey * x, free = (x * (x - r * ex) + y * (y - r * ey)) / 2;
        if (j == k)
            continue;
        if (along > 0)
            b.to = b.to * along > free ? free / along : b.to;
        else if (along < 0)
            b.from = b.from * along > free ? free / along : b.from;
        else if (free < 0)
            b.to = b.from;
    }
    return b;
}

/* ---- the weight -------------------------------------------------------------------------------------------------- */

/** Distance from its foot at which an edge enters the band. */
static double entry_of(double foot)
{
    return sqrt(fmax(INNER * INNER - foot * foot, 0));
}

/** Integral of w = (d^2 - a1^2)(a2^2 - d^2), d^2 = foot^2 + t^2, over t in the band from the foot to t. */
static double weight_until(double foot, double t)
{
    double low = INNER * INNER - foot * foot, high = OUTER * OUTER - foot * foot, u = fabs(t), v = entry_of(foot);
    if (!(u > v))
        return 0;
    double at_u = u * (u * u * ((low + high) / 3 - u * u / 5) - low * high);
    double at_v = v * (v * v * ((low + high) / 3 - v * v / 5) - low * high);
    return copysign(at_u - at_v, t);
}

/** Integral of t w, likewise. */
static double moment_until(double foot, double t)
{
    double low = INNER * INNER - foot * foot, high = OUTER * OUTER - foot * foot, v = entry_of(foot);
    double u2 = fmax(t * t, v * v), v2 = v * v;
    double at_u = u2 * (u2 * ((low + high) / 4 - u2 / 6) - low * high / 2);
    double at_v = v2 * (v2 * ((low + high) / 4 - v2 / 6) - low * high / 2);
    return at_u - at_v;
}

/** Integral of w over a sector of angle 1 up to the outer radius: (a2^2 - a1^2)^3/12. */
static double sector(void)
{
    double width = OUTER * OUTER - INNER * INNER;
    return width * width * width / 12;
}

/** Integral of w over the triangle between the particle and its edge from the foot to t. With q = d^2 the integral over
 *  a sector of angle 1 is (c0 + c1 q + c2 q^2 + c3 q^3) from a1 on, and the derivative of the angle is foot/q. */
static double triangle_until(double foot, double t)
{
    const double low = INNER * INNER, high = OUTER * OUTER;
    const double c3 = -1.0 / 6, c2 = (low + high) / 4, c1 = -low * high / 2, c0 = low * low * (high / 4 - low / 12);
    double f2 = foot * foot, u = fabs(t), v = entry_of(foot), sum = 0;
    if (!(u > v))
        return 0;
    for (int k = 0; k < 2; ++k) {
        double p = k == 0 ? u : v, p2 = p * p;
        double at = foot * p * (c1 + c2 * (f2 + p2 / 3) + c3 * (f2 * f2 + p2 * (2 * f2 / 3 + p2 / 5)));
        sum += (k == 0 ? 1 : -1) * (at + c0 * atan2(p, foot));
    }
    return copysign(sum, t);
}

/* ---- force and energy -------------------------------------------------------------------------------------------- */

/** Minus the gradient of the energy by the edge with neighbour k. */
static sph2d_vec2 pull_across(const neighbourhood *c, int k)
{
    const sph2d_vec2 none = {0, 0};
    double clear = entry_of(sqrt(c->x[k] * c->x[k] + c->y[k] * c->y[k]) / 2);
    edge b = edge_of(c, k, clear);
    if (!(b.from < b.to) || (b.to <= clear && b.from >= -clear))
        return none;
    double along = weight_until(b.foot, b.to) - weight_until(b.foot, b.from), across = 0, r = 2 * b.foot;
    if (c->kind[k] == WALL) {
        across = -(moment_until(b.foot, b.to) - moment_until(b.foot, b.from)) / r;
        along /= 2;
    }
    return (sph2d_vec2){(along * c->x[k] - across * c->y[k]) / r, (along * c->y[k] + across * c->x[k]) / r};
}

/** Minus the gradient of the energy around a particle. */
static sph2d_vec2 pull_on(const neighbourhood *c)
{
    sph2d_vec2 sum = {0, 0};
    for (int k = 0; k < c->count; ++k) {
        sph2d_vec2 pull = pull_across(c, k);
        sum.x += pull.x;
        sum.y += pull.y;
    }
    return sum;
}

/** Integral of w over the particle's cell. */
static double energy_of(const neighbourhood *c)
{
    double sum = 0, angle = 2 * SPH2D__PI;
    for (int k = 0; k < c->count; ++k) {
        edge b = edge_of(c, k, 0);
        if (!(b.from < b.to))
            continue;
        sum += triangle_until(b.foot, b.to) - triangle_until(b.foot, b.from);
        angle -= atan2(b.to, b.foot) - atan2(b.from, b.foot);
    }
    return sum + fmax(angle, 0) * sector();
}

/** The factor e: sigma over the mean of force and energy per length of each surface of a single row of particles. */
static double strength(const sph2d__system *s)
{
    const neighbourhood row = {.count = 2, .x = {1, -1}, .kind = {LIQUID, LIQUID}};
    edge b = edge_of(&row, 0, 0);
    double pull = weight_until(b.foot, b.to), energy = energy_of(&row) / 2;
    return s->surface_tension * 2 / (pull + energy);
}

double sph2d__tension_energy_within(const sph2d__system *s, sph2d_box box)
{
    const sph2d__store *f = &s->fluid;
    double sum = 0;
    sph2d__cursor liquid = SPH2D__CURSOR_START, walls = SPH2D__CURSOR_START;
    neighbourhood c;
    for (size_t i = 0; s->surface_tension > 0 && i < f->count; ++i) {
        bool inside = f->x[i] >= box.min.x && f->x[i] <= box.max.x && f->y[i] >= box.min.y && f->y[i] <= box.max.y;
        if (inside && gather_around(&c, s, i, &liquid, &walls))
            sum += energy_of(&c);
    }
    return strength(s) * s->spacing * sum;
}

double sph2d__tension_energy(const sph2d__system *s)
{
    return sph2d__tension_energy_within(s, (sph2d_box){{-INFINITY, -INFINITY}, {INFINITY, INFINITY}});
}

static void add_accelerations(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    double scale = strength(s) / s->mass;
    sph2d__cursor liquid = SPH2D__CURSOR_START, walls = SPH2D__CURSOR_START;
    neighbourhood c;
    for (size_t i = first; i < last; ++i) {
        if (!gather_around(&c, s, i, &liquid, &walls))
            continue;
        sph2d_vec2 pull = pull_on(&c);
        f->ax[i] += scale * pull.x;
        f->ay[i] += scale * pull.y;
    }
}

void sph2d__tension_add(sph2d__system *s)
{
    if (!(s->surface_tension > 0))
        return;
    sph2d_phase before = sph2d__profile_enter(&s->profile, SPH2D_PHASE_FORCES);
    sph2d__over_particles(s, s->fluid.count, add_accelerations, NULL);
    sph2d__profile_enter(&s->profile, before);
}

void sph2d__tension_of_walls(const sph2d__system *s, sph2d_vec2 *forces)
{
    double scale = strength(s);
    sph2d__cursor liquid = SPH2D__CURSOR_START, walls = SPH2D__CURSOR_START;
    neighbourhood c;
    for (size_t i = 0; s->surface_tension > 0 && s->walls_press && i < s->fluid.count; ++i) {
        if (!gather_around(&c, s, i, &liquid, &walls))
            continue;
        for (int k = 0; k < c.count; ++k) {
            if (c.kind[k] != WALL)
                continue;
            sph2d_vec2 pull = pull_across(&c, k);
            forces[c.index[k]].x += scale * pull.x;
            forces[c.index[k]].y += scale * pull.y;
        }
    }
}

double sph2d__tension_step(const sph2d__system *s)
{
    if (!(s->surface_tension > 0))
        return INFINITY;
    return 0.5 * sqrt(s->rest_density * s->spacing * s->spacing * s->spacing / s->surface_tension);
}
