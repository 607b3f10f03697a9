/* SPDX-License-Identifier: MIT */
/** @file packing_boundary.c
 *  The surroundings of packed particles: boundary particles, and the empty area beyond edges of the liquid, which
 *  counts as if it were filled. */
#include <math.h>

#include "start/packing_state.h"
#include "start/start.h"

/* A boundary particle represents the area within COVERED spacings on its side of the wall's surface. This can be part
 * of a quarter cell whose centre is within COVERED_IN_PART; such quarters are sampled at POINTS x POINTS points. */
static const double COVERED = 0.72, COVERED_IN_PART = 1.1;
enum { POINTS = 8 };
/* Particles are moved off a wall by a little more than they must be: at just that distance rounding decides whether they
 * are too near. */
static const double BEYOND = 1 + 1e-9;

/** Whether a boundary particle is part of layers, and so represents an area. */
static bool has_area(const sph2d__store *walls, size_t j)
{
    return walls->mass && walls->mass[j] > 0 && walls->bounce[j] < 0;
}

/** Whether a boundary particle is within a distance of a position; `behind`: and no surface lies between them, as it
 *  does for a gap between the liquid and a wall. */
static bool is_covered(const sph2d_sim *sim, sph2d_vec2 at, double distance, bool behind)
{
    const sph2d__store *w = &sim->system.walls;
    uint32_t cell = w->count > 0 ? sph2d__cells_find(&sim->system.wall_cells, at.x, at.y) : UINT32_MAX;
    if (cell == UINT32_MAX)
        return false;
    sph2d__ranges ranges;
    sph2d__cells_ranges(&sim->system.wall_cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
        sph2d_vec2 image = {at.x + ranges.x[r], at.y + ranges.y[r]}, wall = {w->x[j], w->y[j]};
        if (has_area(w, j) && hypot(image.x - wall.x, image.y - wall.y) < distance * sim->world.scene.spacing &&
            !(behind && sph2d__sim_crosses_wall(sim, image, wall)))
            return true;
    }
    return false;
}

static sph2d_vec2 quarter_centre(const sph2d__packing_state *p, size_t cell, int q)
{
    const sph2d__region *r = p->region;
    return sph2d__region_position(r, (double)(cell % r->nx) + (q & 1 ? 0.75 : 0.25),
                                  (double)(cell / r->nx) + (q & 2 ? 0.75 : 0.25));
}

/** The missing points of a quarter cell near boundary particles. */
static int missing_beside_walls(const sph2d__packing_state *p, sph2d_vec2 centre, size_t cell, int q)
{
    const sph2d__region *r = p->region;
    bool wet = r->quarters[4 * cell + (size_t)q] > 0;
    int missing = 0;
    for (int k = 0; k < POINTS * POINTS; ++k) {
        double x = ((k % POINTS + 0.5) / POINTS - 0.5) / 2, y = ((k / POINTS + 0.5) / POINTS - 0.5) / 2;
        sph2d_vec2 at = {centre.x + (x * r->axis.x - y * r->axis.y) * r->size,
                         centre.y + (x * r->axis.y + y * r->axis.x) * r->size};
        missing += !(wet && sph2d__region_contains(r, at)) && !is_covered(p->sim, at, COVERED, true);
    }
    return missing * SPH2D__QUARTER_POINTS / (POINTS * POINTS);
}

/** Dilates marks by a number of cells along rows or columns. */
static void dilate_lines(const sph2d__packing_state *p, unsigned char *marks, size_t reach, bool columns)
{
    const sph2d__region *r = p->region;
    size_t lines = columns ? r->nx : r->ny, length = columns ? r->ny : r->nx, step = columns ? r->nx : 1;
    for (size_t line = 0; line < lines; ++line) {
        unsigned char *m = marks + (columns ? line : line * r->nx);
        size_t left = 0; /* cells still to be marked after a mark */
        for (size_t k = 0; k < length; ++k) {
            left = m[k * step] == 1 ? reach + 1 : left;
            if (left > 0 && --left < reach && m[k * step] == 0)
                m[k * step] = 2;
        }
        left = 0;
        for (size_t k = length; k-- > 0;) {
            left = m[k * step] == 1 ? reach + 1 : left;
            if (left > 0 && --left < reach && m[k * step] == 0)
                m[k * step] = 2;
        }
        for (size_t k = 0; k < length; ++k)
            m[k * step] = m[k * step] != 0;
    }
}

void sph2d__packing_dilate(const sph2d__packing_state *p, unsigned char *marks, size_t reach)
{
    dilate_lines(p, marks, reach, false);
    dilate_lines(p, marks, reach, true);
}

/** The missing area of a cell acts at its centroid, so that the area beyond an edge is as coarse as the liquid. If every
 *  quarter acted by itself, nearly an integral, the force on the first row would differ by the error of the midpoint
 *  rule, 1/24 of its slope, and the row would be 0.04 spacings too far inside. */
static sph2d__missing missing_of(const sph2d__packing_state *p, size_t cell)
{
    sph2d_vec2 m = {0, 0};
    double missing = 0;
    for (int q = 0; q < 4; ++q) {
        double part = p->region->quarters[4 * cell + (size_t)q];
        sph2d_vec2 centre = quarter_centre(p, cell, q);
        missing += part;
        m.x += part * centre.x;
        m.y += part * centre.y;
    }
    return missing > 0 ? (sph2d__missing){{m.x / missing, m.y / missing}, missing / SPH2D__REGION_POINTS}
                       : (sph2d__missing){0};
}

void sph2d__packing_find_missing(sph2d__packing_state *p)
{
    size_t cells = sph2d__packing_cell_count(p);
    for (size_t cell = 0; cell < cells; ++cell) {
        unsigned char *quarters = p->region->quarters + 4 * cell;
        for (int q = 0; q < 4; ++q) {
            sph2d_vec2 centre = quarter_centre(p, cell, q);
            int missing = SPH2D__QUARTER_POINTS - quarters[q];
            if (missing > 0 && is_covered(p->sim, centre, COVERED_IN_PART, false))
                missing = missing_beside_walls(p, centre, cell, q);
            quarters[q] = (unsigned char)missing;
            p->near_edge[cell] |= quarters[q] > 0;
        }
        p->missing[cell] = missing_of(p, cell);
    }
    sph2d__packing_dilate(p, p->near_edge, (size_t)ceil(p->support / p->size) + 1);
}

void sph2d__packing_add_missing(const sph2d__packing_state *p, sph2d_vec2 at, sph2d_vec2 *sum)
{
    const sph2d__region *r = p->region;
    if (!p->near_edge[sph2d__packing_cell(p, at)])
        return;
    double reach = p->support / p->size;
    sph2d_vec2 c = sph2d__region_in_cells(r, at);
    size_t i0 = (size_t)fmax(floor(c.x - reach), 0), i1 = (size_t)fmin(floor(c.x + reach), (double)r->nx - 1);
    size_t j0 = (size_t)fmax(floor(c.y - reach), 0), j1 = (size_t)fmin(floor(c.y + reach), (double)r->ny - 1);
    for (size_t j = j0; j <= j1; ++j)
        for (size_t i = i0; i <= i1; ++i) {
            const sph2d__missing *m = &p->missing[j * r->nx + i];
            if (m->part > 0)
                sph2d__packing_add_area(p, at.x - m->at.x, at.y - m->at.y, m->part, sum);
        }
}

void sph2d__packing_add_walls(const sph2d__packing_state *p, sph2d_vec2 at, sph2d_vec2 *sum)
{
    const sph2d__system *s = &p->sim->system;
    const sph2d__store *w = &s->walls;
    uint32_t cell = w->count > 0 ? sph2d__cells_find(&s->wall_cells, at.x, at.y) : UINT32_MAX;
    if (cell == UINT32_MAX)
        return;
    double area = s->rest_density * p->size * p->size;
    sph2d__ranges ranges;
    sph2d__cells_ranges(&s->wall_cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, j)
        if (has_area(w, j))
            sph2d__packing_add_area(p, at.x + ranges.x[r] - w->x[j], at.y + ranges.y[r] - w->y[j], w->mass[j] / area,
                                    sum);
}

sph2d_vec2 sph2d__packing_clear_of_walls(const sph2d__packing_state *p, sph2d_vec2 at)
{
    const sph2d__system *s = &p->sim->system;
    const sph2d__store *w = &s->walls;
    uint32_t cell = w->count > 0 ? sph2d__cells_find(&s->wall_cells, at.x, at.y) : UINT32_MAX;
    sph2d_vec2 clear = at;
    double deepest = 0;
    if (cell == UINT32_MAX)
        return at;
    sph2d__ranges ranges;
    sph2d__cells_ranges(&s->wall_cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
        double x = at.x + ranges.x[r] - w->x[j], y = at.y + ranges.y[r] - w->y[j], distance = hypot(x, y);
        double wanted = has_area(w, j) ? BEYOND * sph2d__sim_clear_distance(p->sim, j) : 0;
        if (wanted - distance > deepest && distance > 0) {
            deepest = wanted - distance;
            clear = (sph2d_vec2){at.x + deepest * x / distance, at.y + deepest * y / distance};
        }
    }
    return clear;
}
