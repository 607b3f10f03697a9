/* SPDX-License-Identifier: MIT */
/** @file place_snapshot.c
 *  The liquid of a snapshot, with particles of another size: as many as have its mass, where its particles cover most of
 *  the plane. The volume is then right, and the surface where it was: on a flat one the cover falls by a tenth in a
 *  twentieth of the spacing of the snapshot.
 *
 *  Particles are on a square lattice over the domain. Where walls lie across it the area is packed instead, like a
 *  block's (packing.h). */
#include <math.h>
#include <stdlib.h>

#include "scene/liquid.h"
#include "start/cloud.h"
#include "start/packing.h"
#include "start/start.h"

/* Cover of places that must not be lost, a little more than on a surface. */
static const double INSIDE = 0.55;

/* Distance from boundary particles in layers [spacings]: more than the half diagonal of their squares, so that no place is
 * behind a line. */
static const double LEAST_DISTANCE = 0.75;

/** A free place of the lattice. */
typedef struct place {
    sph2d_vec2 at;
    double cover;
    size_t number; /**< in the lattice */
} place;

/** The lattice, and the places of it that may be taken. */
typedef struct lattice {
    sph2d_vec2 first;
    double x, y; /**< spacings [m] */
    size_t nx, ny;
    place *places;
    size_t count, size;
    size_t lost; /**< places inside the liquid that walls take */
} lattice;

/** Columns, or rows, across a length: stretched by at most 2 % to fit it. */
static size_t divide(double length, double spacing, double *step)
{
    double count = fmax(floor(length / spacing + 0.5), 1);
    *step = fabs(length / count - spacing) <= 0.02 * spacing ? length / count : spacing;
    return (size_t)fmax(floor(length / *step + 0.01), 1);
}

/** Whether a place is in the layers of a wall, or nearer to one of their particles than liquid may be. */
static bool is_in_layers(const sph2d_sim *sim, sph2d_vec2 p)
{
    const sph2d__store *w = &sim->system.walls;
    uint32_t cell = w->count > 0 ? sph2d__cells_find(&sim->system.wall_cells, p.x, p.y) : UINT32_MAX;
    if (cell == UINT32_MAX)
        return false;
    sph2d__ranges ranges;
    sph2d__cells_ranges(&sim->system.wall_cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
        bool layer = w->mass && w->mass[j] > 0 && w->bounce[j] < 0;
        double distance = hypot(p.x + ranges.x[r] - w->x[j], p.y + ranges.y[r] - w->y[j]);
        if (layer && distance < LEAST_DISTANCE * sim->world.scene.spacing)
            return true;
    }
    return false;
}

/** Whether a place is in the domain and in no block. */
static bool is_own(const sph2d_sim *sim, sph2d_vec2 p)
{
    const sph2d_box *d = &sim->world.scene.domain;
    return p.x > d->min.x && p.x < d->max.x && p.y > d->min.y && p.y < d->max.y &&
           !sph2d__in_block(&sim->world.scene, p);
}

/** The number of particles that the liquid of the snapshot makes, as far as it is in the domain and has room. */
static double count_wanted(const sph2d_sim *sim, const sph2d_cloud *given)
{
    const sph2d__period *period = &sim->system.fluid_cells.period;
    double count = 0, size = given->spacing / sim->world.scene.spacing;
    for (size_t k = 0; k < given->count; ++k) {
        sph2d_vec2 p = {sph2d__period_wrap(given->items[k].x, period->low_x, period->length_x),
                        sph2d__period_wrap(given->items[k].y, period->low_y, period->length_y)};
        count += is_own(sim, p) && sph2d__sim_occupancy(sim, p, 0) == SPH2D__FREE;
    }
    return count * size * size;
}

/** Finds the places. False when memory is short. */
static bool find_places(sph2d_sim *sim, const sph2d__cloud *cloud, lattice *l)
{
    l->size = l->nx * l->ny;
    l->places = sph2d__alloc(&sim->memory, l->size, sizeof *l->places);
    for (size_t n = 0; l->places && n < l->size; ++n) {
        sph2d_vec2 p = {l->first.x + (double)(n % l->nx) * l->x, l->first.y + (double)(n / l->nx) * l->y};
        double cover = is_own(sim, p) ? sph2d__cloud_cover(cloud, p) : 0;
        if (cover < SPH2D__LEAST_COVER)
            continue;
        if (sph2d__sim_occupancy(sim, p, 1) == SPH2D__FREE && !is_in_layers(sim, p))
            l->places[l->count++] = (place){p, cover, n};
        else
            l->lost += cover > INSIDE;
    }
    return l->places;
}

/** Most covered first; of equal ones that which is first in the lattice. */
static int by_cover(const void *a, const void *b)
{
    const place *p = a, *q = b;
    if (p->cover != q->cover)
        return p->cover > q->cover ? -1 : 1;
    return p->number < q->number ? -1 : 1;
}

static int by_number(const void *a, const void *b)
{
    const place *p = a, *q = b;
    return p->number < q->number ? -1 : 1;
}

/** Takes the places that are covered most, in the order of the lattice. False when memory is short. */
static bool take(sph2d_sim *sim, lattice *l, size_t wanted)
{
    sph2d__store *f = &sim->system.fluid;
    size_t count = wanted < l->count ? wanted : l->count;
    if (!sph2d__store_reserve(f, &sim->memory, f->count + count))
        return false;
    qsort(l->places, l->count, sizeof *l->places, by_cover);
    qsort(l->places, count, sizeof *l->places, by_number);
    for (size_t k = 0; k < count; ++k) {
        size_t i = sph2d__sim_add_liquid(sim, l->places[k].at, NULL);
        f->density[i] = sim->world.scene.fluid.density;
    }
    return true;
}

/** Fills the area of the liquid by a packing. False when memory is short. */
static bool pack(sph2d_sim *sim, const sph2d__cloud *cloud, double wanted)
{
    sph2d__store *f = &sim->system.fluid;
    const sph2d_shape domain = {.kind = SPH2D_SHAPE_BOX, .box = sim->world.scene.domain};
    double margin = ceil(sim->system.support / sim->world.scene.spacing) + 1;
    sph2d__region region;
    sph2d__packing packing;
    if (!sph2d__region_make_covered(&region, sim, &domain, cloud, domain.box.min, sim->world.scene.spacing, (int)margin,
                                    wanted))
        return false;
    bool ok = sph2d__pack(sim, &region, &packing);
    sph2d__region_free(&region, &sim->memory);
    if (!ok)
        return false;
    ok = sph2d__store_reserve(f, &sim->memory, f->count + packing.count);
    for (size_t k = 0; ok && k < packing.count; ++k) {
        size_t i = sph2d__sim_add_liquid(sim, packing.positions[k], NULL);
        f->density[i] = sim->world.scene.fluid.density;
    }
    sph2d__packing_free(&packing, &sim->memory);
    return ok;
}

/** Adds what was taken to the plan. */
static void add_to_plan(sph2d_sim *sim, double wanted, size_t taken)
{
    double area = sim->world.scene.spacing * sim->world.scene.spacing;
    sim->plan.area_asked += wanted * area;
    sim->plan.area_placed += (double)taken * area;
}

sph2d_status sph2d__sim_place_snapshot(sph2d_sim *sim, sph2d_report *report)
{
    const sph2d_cloud *given = &sim->world.scene.start.snapshot;
    const sph2d_box *d = &sim->world.scene.domain;
    lattice l = {0};
    size_t first = sim->system.fluid.count;
    l.nx = divide(d->max.x - d->min.x, sim->world.scene.spacing, &l.x);
    l.ny = divide(d->max.y - d->min.y, sim->world.scene.spacing, &l.y);
    l.first = (sph2d_vec2){d->min.x + l.x / 2, d->min.y + l.y / 2};
    double wanted = given->count > 0 ? count_wanted(sim, given) : 0;
    if (sph2d__sim_too_many(sim, fmax(wanted, (double)l.nx * (double)l.ny), "start.snapshot", report))
        return SPH2D_SCENE;
    sph2d__cloud cloud;
    bool ok = sph2d__cloud_make(&cloud, given, sim);
    ok = ok && find_places(sim, &cloud, &l);
    if (ok)
        ok = l.lost > 0 ? pack(sim, &cloud, wanted) : take(sim, &l, (size_t)floor(wanted + 0.5));
    void *places = l.places;
    sph2d__release(&sim->memory, &places, l.size, sizeof *l.places);
    sph2d__cloud_free(&cloud, &sim->memory);
    if (!ok)
        return SPH2D_NOMEM;
    add_to_plan(sim, wanted, sim->system.fluid.count - first);
    return sph2d__sim_start(sim, &sim->world.scene.start, first, "start", false, report);
}
