/* SPDX-License-Identifier: MIT */
/** @file coverage_density.c
 *  The mean density inside the liquid: reported by the particles, and counted on the grid. */
#include <math.h>

#include "methods/common/on_device.h"
#include "probes/coverage.h"

/* Distance from the surface of nodes that count as inside [cells], and the minimum number of particles for a mean. */
enum { INSIDE = 5 * SPH2D__COVERAGE_CELLS, MIN_INSIDE = 20 };

/** Marks the nodes of a rectangle around a position, given in nodes; there are none beyond the grid. */
static void mark_around(const sph2d__coverage *c, double x, double y, double reach_x, double reach_y,
                        unsigned char *marks)
{
    for (long j = (long)ceil(y - reach_y); j <= (long)floor(y + reach_y); ++j)
        for (long i = (long)ceil(x - reach_x); i <= (long)floor(x + reach_x); ++i) {
            size_t row = sph2d__coverage_node(j, c->nodes_y, c->ny);
            size_t column = sph2d__coverage_node(i, c->nodes_x, c->nx);
            if (row != SIZE_MAX && column != SIZE_MAX)
                marks[row * c->nodes_x + column] = 1;
        }
}

/** Marks the nodes near nodes without liquid. */
static void mark_near_empty(const sph2d__coverage *c, unsigned char *marks)
{
    for (size_t j = 0; j < c->nodes_y; ++j)
        for (size_t i = 0; i < c->nodes_x; ++i) {
            size_t left = j * c->nodes_x + (i + c->nodes_x - 1) % c->nodes_x;
            bool empty = (double)c->fill[j * c->nodes_x + i] < 0.5, first = i == 0 && c->nodes_x != c->nx;
            bool before = !first && (double)c->fill[left] < 0.5;
            if (empty) /* in a run of such nodes all but the first mark only their last column, which is new */
                mark_around(c, (double)i + (before ? INSIDE : 0), (double)j, before ? 0 : INSIDE, INSIDE, marks);
        }
}

/** Marks the nodes near boundary particles and sides. */
static void mark_walls(const sph2d__coverage *c, unsigned char *marks)
{
    const sph2d__store *w = &c->sim->system.walls;
    double h = SPH2D__COVERAGE_SUPPORT * c->sim->system.spacing;
    for (size_t b = 0; b < w->count; ++b)
        mark_around(c, (w->x[b] - c->origin.x) / c->size_x, (w->y[b] - c->origin.y) / c->size_y, h / c->size_x,
                    h / c->size_y, marks);
    for (size_t j = 0; j < c->nodes_y; ++j)
        for (size_t i = 0; i < c->nodes_x; ++i) {
            double x = c->origin.x + (double)i * c->size_x, y = c->origin.y + (double)j * c->size_y;
            for (int k = 0; k < 4; ++k) {
                sph2d_vec2 p = {x + (k == 0 ? -h : k == 1 ? h : 0), y + (k == 2 ? -h : k == 3 ? h : 0)};
                if (sph2d__coverage_beyond_wall(&c->sim->world, p))
                    marks[j * c->nodes_x + i] = 1;
            }
        }
}

/** The means over nodes and particles that are not marked; `inside`: the number of such particles. */
static sph2d_densities densities_of(const sph2d__coverage *c, const unsigned char *marks, size_t *inside)
{
    const sph2d__store *f = &c->sim->system.fluid;
    double counted = 0, reported = 0;
    size_t nodes = 0, particles = 0;
    for (size_t k = 0; k < c->nodes_x * c->nodes_y; ++k)
        if (!marks[k]) {
            counted += (double)c->fill[k];
            ++nodes;
        }
    for (size_t i = 0; i < f->count; ++i) {
        double x = (f->x[i] - c->origin.x) / c->size_x + 0.5, y = (f->y[i] - c->origin.y) / c->size_y + 0.5;
        size_t column = x >= 0 && x < (double)c->nx + 1 ? sph2d__coverage_node((long)x, c->nodes_x, c->nx) : SIZE_MAX;
        size_t row = y >= 0 && y < (double)c->ny + 1 ? sph2d__coverage_node((long)y, c->nodes_y, c->ny) : SIZE_MAX;
        if (column == SIZE_MAX || row == SIZE_MAX || marks[row * c->nodes_x + column])
            continue;
        reported += f->density[i] / c->sim->system.rest_density;
        ++particles;
    }
    *inside = particles;
    if (particles < MIN_INSIDE)
        return (sph2d_densities){NAN, NAN, NAN, SPH2D_OK};
    return (sph2d_densities){reported / (double)particles, counted / (double)nodes, NAN, SPH2D_OK};
}

static sph2d_densities densities_inside(const sph2d__coverage *c, size_t *inside)
{
    sph2d__memory *memory = c->sim->system.memory;
    size_t nodes = c->nodes_x * c->nodes_y;
    sph2d_densities found = {NAN, NAN, NAN, SPH2D_OK};
    void *marks = sph2d__alloc(memory, nodes, 1);
    if (marks) {
        mark_near_empty(c, marks);
        mark_walls(c, marks);
        found = densities_of(c, marks, inside);
    }
    sph2d__release(memory, &marks, marks ? nodes : 0, 1);
    return found;
}

/** The densities now, and the covered part if it is asked for. */
static sph2d_densities densities_now(const sph2d_sim *sim, size_t *inside, bool with_area)
{
    sph2d__coverage c;
    sph2d_densities found = {NAN, NAN, NAN, SPH2D_OK};
    size_t failures = sim->system.memory->failures;
    *inside = 0;
    sph2d__host_reads(&sim->system, SPH2D__EVERYTHING);
    if (sph2d__coverage_make(&c, sim)) {
        double placed = sph2d__placed_area(sim);
        found = densities_inside(&c, inside);
        found.covered = with_area && placed > 0 ? sph2d__coverage_area(&c) / placed : NAN;
        sph2d__coverage_free(&c);
    }
    if (sim->system.memory->failures != failures)
        found.status = SPH2D_NOMEM;
    return found;
}

sph2d_densities sph2d_sim_densities(const sph2d_sim *sim)
{
    if (!sim)
        return (sph2d_densities){NAN, NAN, NAN, SPH2D_INVALID};
    size_t inside;
    return densities_now(sim, &inside, true);
}

/* Steps between samples, each of which costs as much as some steps; and the minimum number of particles for a
 * comparison: among 20, one bubble is a sixth of the counted density. */
enum { DENSITY_STEPS = 500, MIN_COMPARED = 100 };

sph2d_status sph2d__sim_watch_density(sph2d_sim *sim)
{
    sph2d__record *r = &sim->record;
    if (r->steps % DENSITY_STEPS != 0)
        return SPH2D_OK;
    size_t inside;
    sph2d_densities now = densities_now(sim, &inside, false);
    if (inside >= MIN_COMPARED)
        r->density_apart = fmax(r->density_apart, fabs(now.reported - now.counted)); /* fmax ignores NaN */
    return now.status;
}
