/* SPDX-License-Identifier: MIT */
/** @file tension.c
 *  Surface tension as strings along the surface. */
#include "methods/tension.h"

#include <math.h>

#include "base/threads.h"
#include "methods/traverse.h"

/* Particles that a thread takes at a time, and the most neighbours that one can have before it counts as covered. */
enum { CHUNK = 256, MOST = 96 };

/* Radius of the discs in spacings. A square lattice is covered from 0.71 on, what flows from 1.1; up to 1.5, half the
 * support radius, drops rest and swing alike. */
static const double RADIUS = 1.25;

/** The particles whose discs can cover a point of a particle's circle. */
typedef struct crowd {
    int count, fluid;        /**< those of the fluid come first */
    double x[MOST], y[MOST]; /**< from the particle [m] */
    double normal_x[MOST],
        normal_y[MOST]; /**< of boundary particles, towards the liquid, any length; 0 where unknown */
} crowd;

/** Adds the particles of `from` within `reach` of (x, y), without the one there. False when there is no room. */
static bool gather(crowd *c, const sph2d__store *from, const sph2d__ranges *ranges, double x, double y, double reach)
{
    for (int r = 0; r < ranges->count; ++r)
        for (size_t j = ranges->begin[r]; j < ranges->end[r]; ++j) {
            double dx = from->x[j] - (x + ranges->x[r]), dy = from->y[j] - (y + ranges->y[r]), r2 = dx * dx + dy * dy;
            if (!(r2 < reach * reach) || r2 == 0)
                continue;
            if (c->count == MOST)
                return false;
            c->x[c->count] = dx;
            c->y[c->count] = dy;
            c->normal_x[c->count] = from->normal_x ? from->normal_x[j] : 0;
            c->normal_y[c->count] = from->normal_y ? from->normal_y[j] : 0;
            ++c->count;
        }
    return true;
}

/** Whether another disc than that of `but` covers the point. */
static bool is_covered(const crowd *c, int but, double x, double y, double radius)
{
    for (int k = 0; k < c->count; ++k) {
        double dx = c->x[k] - x, dy = c->y[k] - y;
        if (k != but && dx * dx + dy * dy < radius * radius)
            return true;
    }
    return false;
}

/** How many of the two points where the circle of neighbour k meets the particle's own are bare. */
static int bare_points(const crowd *c, int k, double radius)
{
    double x = c->x[k] / 2, y = c->y[k] / 2, half2 = x * x + y * y;
    double off = sqrt((radius * radius - half2) / half2);
    return !is_covered(c, k, x - off * y, y + off * x, radius) + !is_covered(c, k, x + off * y, y - off * x, radius);
}

/** The strings' pull on a particle over sigma. */
static sph2d_vec2 pull_on(const crowd *c, double radius)
{
    sph2d_vec2 pull = {0, 0};
    for (int k = 0; k < c->count; ++k) {
        int bare = bare_points(c, k, radius);
        if (bare == 0)
            continue;
        bool wall = k >= c->fluid;
        double x = wall ? -c->normal_x[k] : c->x[k], y = wall ? -c->normal_y[k] : c->y[k], r = sqrt(x * x + y * y);
        pull.x += r > 0 ? bare * x / r : 0;
        pull.y += r > 0 ? bare * y / r : 0;
    }
    return pull;
}

void sph2d__tension_add(sph2d__system *s)
{
    if (!(s->surface_tension > 0))
        return;
    sph2d__store *f = &s->fluid;
    double radius = RADIUS * s->spacing, scale = s->surface_tension / s->mass;
    int threads = sph2d__threads_for(s->threads, f->count);
#pragma omp parallel num_threads(threads) if (threads > 1)
    {
        sph2d__cursor cursor = SPH2D__CURSOR_START, beside = SPH2D__CURSOR_START;
        crowd c;
#pragma omp for schedule(dynamic, CHUNK)
        for (size_t i = 0; i < f->count; ++i) {
            double x = f->x[i], y = f->y[i];
            if (f->surface && !(f->surface[i] < s->support))
                continue; /* far inside */
            c.count = 0;
            sph2d__cursor_move(&cursor, &s->fluid_cells, x, y);
            bool room = gather(&c, f, &cursor.ranges, x, y, 2 * radius);
            c.fluid = c.count;
            if (s->walls_press && sph2d__cursor_move(&beside, &s->wall_cells, x, y))
                room &= gather(&c, &s->walls, &beside.ranges, x, y, 2 * radius);
            if (!room)
                continue;
            sph2d_vec2 pull = pull_on(&c, radius);
            f->ax[i] += scale * pull.x;
            f->ay[i] += scale * pull.y;
        }
    }
}

double sph2d__tension_step(const sph2d__system *s)
{
    if (!(s->surface_tension > 0))
        return INFINITY;
    return 0.5 * sqrt(s->rest_density * s->spacing * s->spacing * s->spacing / s->surface_tension);
}
