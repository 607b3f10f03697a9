/* SPDX-License-Identifier: MIT */
/** @file packing_room.c
 *  What fills the room around places that are packed: boundary particles, and beyond edges of the liquid what is
 *  missing there. */
#include <math.h>

#include "start/packer.h"

/* A boundary particle stands for what is nearer to it than this many spacings, on its side of the wall's surface. It
 * may be as near to part of a quarter of a cell whose middle is nearer than that. In quarters so many points are looked
 * at. */
static const double COVERED = 0.72, COVERED_IN_PART = 1.1;
enum { LOOKS = 8 };

/** Whether a boundary particle is part of layers, and stands for an area. */
static bool has_area(const sph2d__store *walls, size_t j)
{
    return walls->mass && walls->mass[j] > 0 && walls->bounce[j] < 0;
}

/** Whether a boundary particle is nearer to a place than a distance; `behind`: and on the same side of all surfaces, as
 *  it is not of a gap between the liquid and a wall. */
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
        if (has_area(w, j) && hypot(image.x - wall.x, image.y - wall.y) < distance * sim->scene.spacing &&
            !(behind && sph2d__sim_crosses_wall(sim, image, wall)))
            return true;
    }
    return false;
}

static sph2d_vec2 quarter_middle(const sph2d__packer *p, size_t cell, int q)
{
    const sph2d__region *r = p->region;
    return sph2d__region_place(r, (double)(cell % r->nx) + (q & 1 ? 0.75 : 0.25),
                               (double)(cell / r->nx) + (q & 2 ? 0.75 : 0.25));
}

/** What is missing of a quarter of a cell near boundary particles, in points. */
static int missing_beside_walls(const sph2d__packer *p, sph2d_vec2 middle, size_t cell, int q)
{
    const sph2d__region *r = p->region;
    bool wet = r->quarters[4 * cell + (size_t)q] > 0;
    int missing = 0;
    for (int k = 0; k < LOOKS * LOOKS; ++k) {
        double x = ((k % LOOKS + 0.5) / LOOKS - 0.5) / 2, y = ((k / LOOKS + 0.5) / LOOKS - 0.5) / 2;
        sph2d_vec2 at = {middle.x + (x * r->axis.x - y * r->axis.y) * r->size,
                         middle.y + (x * r->axis.y + y * r->axis.x) * r->size};
        missing += !(wet && sph2d__region_contains(r, at)) && !is_covered(p->sim, at, COVERED, true);
    }
    return missing * SPH2D__REGION_QUARTER / (LOOKS * LOOKS);
}

/** Spreads marks over a number of cells around them, along rows or columns. */
static void dilate(const sph2d__packer *p, unsigned char *marks, size_t reach, bool columns)
{
    const sph2d__region *r = p->region;
    size_t lines = columns ? r->nx : r->ny, length = columns ? r->ny : r->nx, step = columns ? r->nx : 1;
    for (size_t line = 0; line < lines; ++line) {
        unsigned char *m = marks + (columns ? line : line * r->nx);
        size_t left = 0; /* cells to mark still, behind a mark */
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

void sph2d__packer_spread(const sph2d__packer *p, unsigned char *marks, size_t reach)
{
    dilate(p, marks, reach, false);
    dilate(p, marks, reach, true);
}

void sph2d__packer_find_missing(sph2d__packer *p)
{
    size_t cells = sph2d__packer_cells(p);
    for (size_t cell = 0; cell < cells; ++cell) {
        unsigned char *quarters = p->region->quarters + 4 * cell;
        for (int q = 0; q < 4; ++q) {
            sph2d_vec2 middle = quarter_middle(p, cell, q);
            int missing = SPH2D__REGION_QUARTER - quarters[q];
            if (missing > 0 && is_covered(p->sim, middle, COVERED_IN_PART, false))
                missing = missing_beside_walls(p, middle, cell, q);
            quarters[q] = (unsigned char)missing;
            p->near_edge[cell] |= quarters[q] > 0;
        }
    }
    sph2d__packer_spread(p, p->near_edge, (size_t)ceil(p->support / p->size) + 1);
}

/** What is missing around a place: of each cell one place in the middle of it, so that what is beyond an edge is as
 *  coarse as the liquid. Against quarters, which are nearly an integral, the liquid beside an edge keeps a row's force
 *  less by 1/24 of its slope (the midpoint rule), and ends 0.04 spacings farther in. */
void sph2d__packer_add_missing(const sph2d__packer *p, sph2d_vec2 at, sph2d_vec2 *sum)
{
    const sph2d__region *r = p->region;
    if (!p->near_edge[sph2d__packer_cell(p, at)])
        return;
    double reach = p->support / p->size;
    sph2d_vec2 c = sph2d__region_in_cells(r, at);
    size_t i0 = (size_t)fmax(floor(c.x - reach), 0), i1 = (size_t)fmin(floor(c.x + reach), (double)r->nx - 1);
    size_t j0 = (size_t)fmax(floor(c.y - reach), 0), j1 = (size_t)fmin(floor(c.y + reach), (double)r->ny - 1);
    for (size_t j = j0; j <= j1; ++j)
        for (size_t i = i0; i <= i1; ++i) {
            size_t cell = j * r->nx + i;
            sph2d_vec2 m = {0, 0};
            double missing = 0;
            for (int q = 0; q < 4; ++q) {
                double part = r->quarters[4 * cell + (size_t)q];
                sph2d_vec2 middle = quarter_middle(p, cell, q);
                missing += part;
                m.x += part * middle.x;
                m.y += part * middle.y;
            }
            if (missing > 0)
                sph2d__packer_add_area(p, at.x - m.x / missing, at.y - m.y / missing, missing / SPH2D__REGION_WHOLE,
                                       sum);
        }
}

void sph2d__packer_add_walls(const sph2d__packer *p, sph2d_vec2 at, sph2d_vec2 *sum)
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
            sph2d__packer_add_area(p, at.x + ranges.x[r] - w->x[j], at.y + ranges.y[r] - w->y[j], w->mass[j] / area,
                                   sum);
}
