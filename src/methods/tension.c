/* SPDX-License-Identifier: MIT */
/** @file tension.c
 *  Surface tension as strings along the surface. */
#include "methods/tension.h"

#include <math.h>

#include "methods/slabs.h"
#include "methods/traverse.h"
#include "scene/derive.h"

/* The most neighbours that a particle can have before it counts as covered: ten times as many as liquid has. */
enum { MOST = 192 };

/** The particles whose discs can cover a point of a particle's circle. */
typedef struct crowd {
    int count, fluid;                      /**< those of the fluid come first */
    double x[MOST], y[MOST];               /**< from the particle [m] */
    double normal_x[MOST], normal_y[MOST]; /**< of boundary particles, towards the liquid; 0 where unknown */
    bool has_edges[MOST];
} crowd;

/** Whether a particle of the fluid can have edges. */
static bool can_have_edges(const sph2d__system *s, size_t i)
{
    return !s->fluid.surface || s->fluid.surface[i] < s->support;
}

/** Adds particle j of the fluid or of the walls at (dx, dy). */
static void add(crowd *c, const sph2d__system *s, const sph2d__store *from, size_t j, double dx, double dy)
{
    bool liquid = from == &s->fluid;
    int k = c->count++;
    c->x[k] = dx;
    c->y[k] = dy;
    c->normal_x[k] = !liquid && from->normal_x ? from->normal_x[j] : 0;
    c->normal_y[k] = !liquid && from->normal_y ? from->normal_y[j] : 0;
    c->has_edges[k] = !liquid || can_have_edges(s, j);
}

/** Adds the particles of `from` within two radii of (x, y), without the one there and without those that only reflect.
 *  False when there is no room. */
static bool gather(crowd *c, const sph2d__system *s, const sph2d__store *from, const sph2d__ranges *ranges, double x,
                   double y)
{
    double reach = 2 * SPH2D__DISC_RADIUS * s->spacing;
    SPH2D__FOR_NEIGHBOURS (ranges, r, j) {
        double dx = from->x[j] - (x + ranges->x[r]), dy = from->y[j] - (y + ranges->y[r]), r2 = dx * dx + dy * dy;
        if (!(r2 < reach * reach) || r2 == 0 || (from == &s->walls && from->bounce[j] >= 0))
            continue;
        if (c->count == MOST)
            return false;
        add(c, s, from, j, dx, dy);
    }
    return true;
}

/** Everything around particle i; nothing where it has no edges or no end of neighbours. */
static void gather_around(crowd *c, const sph2d__system *s, size_t i, sph2d__cursor *liquid, sph2d__cursor *walls)
{
    double x = s->fluid.x[i], y = s->fluid.y[i];
    c->count = c->fluid = 0;
    if (!can_have_edges(s, i) || !sph2d__cursor_move(liquid, &s->fluid_cells, x, y))
        return;
    bool room = gather(c, s, &s->fluid, &liquid->ranges, x, y);
    c->fluid = c->count;
    if (s->walls_press && sph2d__cursor_move(walls, &s->wall_cells, x, y))
        room &= gather(c, s, &s->walls, &walls->ranges, x, y);
    if (!room)
        c->count = c->fluid = 0;
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
    if (!c->has_edges[k])
        return 0;
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

double sph2d__tension_energy(const sph2d__system *s)
{
    double length = 0;
    sph2d__cursor liquid = SPH2D__CURSOR_START, walls = SPH2D__CURSOR_START;
    crowd c;
    for (size_t i = 0; s->surface_tension > 0 && i < s->fluid.count; ++i) {
        gather_around(&c, s, i, &liquid, &walls);
        for (int k = 0; k < c.fluid; ++k)
            length += bare_points(&c, k, SPH2D__DISC_RADIUS * s->spacing) * hypot(c.x[k], c.y[k]);
    }
    return s->surface_tension * length / 2; /* each edge was met from both its ends */
}

static void pull_particles(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    double scale = s->surface_tension / s->mass;
    sph2d__cursor liquid = SPH2D__CURSOR_START, walls = SPH2D__CURSOR_START;
    crowd c;
    for (size_t i = first; i < last; ++i) {
        gather_around(&c, s, i, &liquid, &walls);
        sph2d_vec2 pull = pull_on(&c, SPH2D__DISC_RADIUS * s->spacing);
        f->ax[i] += scale * pull.x;
        f->ay[i] += scale * pull.y;
    }
}

void sph2d__tension_add(sph2d__system *s)
{
    if (!(s->surface_tension > 0))
        return;
    sph2d_phase before = sph2d__profile_enter(&s->profile, SPH2D_PHASE_FORCES);
    sph2d__over_particles(s, s->fluid.count, pull_particles);
    sph2d__profile_enter(&s->profile, before);
}

double sph2d__tension_step(const sph2d__system *s)
{
    if (!(s->surface_tension > 0))
        return INFINITY;
    return 0.5 * sqrt(s->rest_density * s->spacing * s->spacing * s->spacing / s->surface_tension);
}
