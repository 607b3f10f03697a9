/* SPDX-License-Identifier: MIT */
/** @file packing.c
 *  Packs an area with particles. By one thread: it is done once, and few particles move. */
#include "start/packing.h"
#include "start/start.h"

#include <math.h>

#include "kernels/kernel.h"
#include "start/packing_state.h"

/* Particles move if they are within so many cells of an edge that cuts cells. */
enum { BAND = 12 };
/* Support radius over spacing: 1.5 times the method's, clamped between these two, or the method's if that is larger.
 * With 2.4 particles are 0.1 to 0.4 % too dense inside, with 3 within 0.15 %; for methods with H/dx = 1.6, whose
 * density depends on few neighbours, the largest density is 4 % too high with 2.4 and 7 % with 3. */
static const double MIN_SUPPORT = 2.4, MAX_SUPPORT = 3, SUPPORT_FACTOR = 1.5;

/* ---- number and initial positions -------------------------------------------------------------------------------- */

/** Visits the cells along a Z curve and chooses each in which the accumulated area reaches the next half-integer number
 *  of particles: in any part of the area the number of particles is right within one or two. */
static void choose(sph2d__packing_state *p, size_t i, size_t j, size_t side, long *points)
{
    const sph2d__region *r = p->region;
    if (i >= r->nx || j >= r->ny)
        return;
    if (side > 1) {
        side /= 2;
        for (int k = 0; k < 4; ++k)
            choose(p, i + (k & 1 ? side : 0), j + (k & 2 ? side : 0), side, points);
        return;
    }
    size_t cell = j * r->nx + i;
    long before = (*points + SPH2D__REGION_POINTS / 2) / SPH2D__REGION_POINTS;
    *points += sph2d__region_covered(r, cell);
    p->chosen[cell] = (*points + SPH2D__REGION_POINTS / 2) / SPH2D__REGION_POINTS > before;
    p->count += p->chosen[cell];
}

/** Sets the initial positions, and which particles move. */
static bool set_positions(sph2d__packing_state *p)
{
    sph2d__memory *memory = &p->sim->memory;
    size_t cells = sph2d__packing_cell_count(p), n = 0;
    unsigned char *moving = sph2d__alloc(memory, cells, 1);
    if (!moving)
        return false;
    for (size_t cell = 0; cell < cells; ++cell) {
        int cover = sph2d__region_covered(p->region, cell);
        if (p->chosen[cell]) {
            p->at[n] = sph2d__region_place(p->region, cell);
            moving[cell] = sph2d__sim_occupancy(p->sim, p->at[n++], 1) != SPH2D__FREE;
        }
        moving[cell] |= cover > 0 && cover < SPH2D__REGION_POINTS;
    }
    sph2d__packing_dilate(p, moving, BAND);
    for (size_t i = 0; i < p->count; ++i)
        if (moving[sph2d__packing_cell(p, p->at[i])])
            p->mover[p->movers++] = (uint32_t)i;
    void *block = moving;
    sph2d__release(memory, &block, cells, 1);
    return true;
}

/* ---- packing ----------------------------------------------------------------------------------------------------- */

static sph2d__packing_state state_of(sph2d_sim *sim, sph2d__region *region)
{
    sph2d__packing_state p = {.sim = sim, .region = region, .kernel = sim->system.method.kernel, .size = region->size};
    double ratio = sim->system.support / sim->system.spacing;
    p.support = fmax(ratio, fmin(fmax(SUPPORT_FACTOR * ratio, MIN_SUPPORT), MAX_SUPPORT)) * p.size;
    double h2 = p.support * p.support;
    for (int k = 0; k <= SPH2D__PACKING_SLOPES; ++k)
        p.slope[k] = p.size * p.size * sph2d__kernel_constant(p.kernel) / (h2 * h2) *
                     sph2d__kernel_slope_at(p.kernel, sqrt((double)k / SPH2D__PACKING_SLOPES));
    p.bucket = p.support + SPH2D__PACKING_SKIN * p.size;
    p.bx = (size_t)ceil((double)region->nx * p.size / p.bucket) + 1;
    p.by = (size_t)ceil((double)region->ny * p.size / p.bucket) + 1;
    return p;
}

static size_t side_for(const sph2d__region *region)
{
    size_t side = 1;
    while (side < region->nx || side < region->ny)
        side *= 2;
    return side;
}

bool sph2d__pack(sph2d_sim *sim, sph2d__region *region, sph2d__packing *packing)
{
    sph2d__memory *memory = &sim->memory;
    sph2d__packing_state p = state_of(sim, region);
    size_t cells = sph2d__packing_cell_count(&p), buckets = p.bx * p.by + 1;
    *packing = (sph2d__packing){0};
    void *marks[2] = {sph2d__alloc(memory, cells, 1), sph2d__alloc(memory, cells, 1)};
    p.chosen = marks[0];
    p.near_edge = marks[1];
    long points = 0;
    if (p.chosen)
        choose(&p, 0, 0, side_for(region), &points);
    const size_t n = p.count;
    void *vectors[4], *numbers[3], *start = sph2d__alloc(memory, buckets, sizeof *p.start);
    void *missing = sph2d__alloc(memory, cells, sizeof *p.missing);
    for (int k = 0; k < 4; ++k)
        vectors[k] = sph2d__alloc(memory, n + 1, sizeof(sph2d_vec2));
    for (int k = 0; k < 3; ++k)
        numbers[k] = sph2d__alloc(memory, n + 1, sizeof(uint32_t));
    p.at = vectors[0];
    p.velocity = vectors[1];
    p.gradient = vectors[2];
    p.old = vectors[3];
    p.mover = numbers[0];
    p.order = numbers[1];
    p.first = numbers[2];
    p.start = start;
    p.missing = missing;
    bool ok = p.missing && p.chosen && p.near_edge && p.at && p.velocity && p.gradient && p.old && p.mover && p.order &&
              p.first && p.start && set_positions(&p);
    if (ok) {
        sph2d__packing_find_missing(&p);
        ok = sph2d__packing_relax(&p, &packing->residual);
    }
    void *neighbour = p.neighbour;
    sph2d__release(memory, &neighbour, p.neighbour_capacity, sizeof *p.neighbour);
    sph2d__release(memory, &start, buckets, sizeof *p.start);
    sph2d__release(memory, &missing, cells, sizeof *p.missing);
    for (int k = ok ? 1 : 0; k < 4; ++k)
        sph2d__release(memory, &vectors[k], n + 1, sizeof(sph2d_vec2));
    for (int k = 0; k < 3; ++k)
        sph2d__release(memory, &numbers[k], n + 1, sizeof(uint32_t));
    for (int k = 0; k < 2; ++k)
        sph2d__release(memory, &marks[k], cells, 1);
    packing->positions = ok ? p.at : NULL;
    packing->count = ok ? n : 0;
    return ok;
}

void sph2d__packing_free(sph2d__packing *packing, sph2d__memory *memory)
{
    void *block = packing->positions;
    sph2d__release(memory, &block, packing->count + 1, sizeof(sph2d_vec2));
    packing->positions = NULL;
}
