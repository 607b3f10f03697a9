/* SPDX-License-Identifier: MIT */
/** @file packing.c
 *  Places for as many particles as an area holds. One thread: it is done once, and few places move. */
#include "start/packing.h"
#include "start/start.h"

#include <math.h>

#include "kernels/kernel.h"
#include "start/packer.h"

/* Places move that are within so many cells of an edge which passes through cells. */
enum { BAND = 12 };
/* Support radius over spacing: half as much again as the method's between these two, or the method's where that is
 * more. By 2.4 places lie 0.1 to 0.4 % too dense inside, by 3 within 0.15 %; at H/dx = 1.6, where density is what the
 * nearest few make of it, the largest is 4 % too much by 2.4 and 7 % by 3. */
static const double LEAST_SUPPORT = 2.4, FAIR_SUPPORT = 3, WIDER = 1.5;

/* ---- how many, and where first ----------------------------------------------------------------------------------- */

/** Goes through the cells along a Z curve and chooses the one in which the covered area reaches the next whole particle
 *  and a half: over any part of the area the number of places is right within one or two. */
static void choose(sph2d__packer *p, size_t i, size_t j, size_t side, long *points)
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
    long before = (*points + SPH2D__REGION_WHOLE / 2) / SPH2D__REGION_WHOLE;
    *points += sph2d__region_cover(r, cell);
    p->chosen[cell] = (*points + SPH2D__REGION_WHOLE / 2) / SPH2D__REGION_WHOLE > before;
    p->count += p->chosen[cell];
}

/** Sets the first places, and which of them move. */
static bool set_places(sph2d__packer *p)
{
    sph2d__memory *memory = &p->sim->memory;
    size_t cells = sph2d__packer_cells(p), n = 0;
    unsigned char *moving = sph2d__alloc(memory, cells, 1);
    if (!moving)
        return false;
    for (size_t cell = 0; cell < cells; ++cell) {
        int cover = sph2d__region_cover(p->region, cell);
        if (p->chosen[cell]) {
            p->at[n] = sph2d__region_middle(p->region, cell);
            moving[cell] = sph2d__sim_taken(p->sim, p->at[n++], 1) != SPH2D__FREE;
        }
        moving[cell] |= cover > 0 && cover < SPH2D__REGION_WHOLE;
    }
    sph2d__packer_spread(p, moving, BAND);
    for (size_t i = 0; i < p->count; ++i)
        if (moving[sph2d__packer_cell(p, p->at[i])])
            p->mover[p->movers++] = (uint32_t)i;
    void *block = moving;
    sph2d__release(memory, &block, cells, 1);
    return true;
}

/* ---- all of it --------------------------------------------------------------------------------------------------- */

/** The kernel that places are packed by: the method's, or Wendland's kernel of about the same standard deviation where
 *  that is a spline. The Fourier transforms of splines are negative somewhere, so that sum W_ij is least where
 *  particles lie in pairs (Dehnen & Aly 2012): by the cubic spline at H = 3.9 dx they came within 1e-6 dx of each
 *  other. */
static sph2d_kernel packing_kernel(sph2d_kernel kernel)
{
    if (kernel == SPH2D_KERNEL_CUBIC)
        return SPH2D_KERNEL_WENDLAND_C2;
    return kernel == SPH2D_KERNEL_QUINTIC ? SPH2D_KERNEL_WENDLAND_C4 : kernel;
}

static sph2d__packer packer_of(sph2d_sim *sim, sph2d__region *region)
{
    sph2d__packer p = {
        .sim = sim, .region = region, .kernel = packing_kernel(sim->system.method.kernel), .size = region->size};
    double own = sim->system.support / sim->system.spacing;
    p.support = fmax(own, fmin(fmax(WIDER * own, LEAST_SUPPORT), FAIR_SUPPORT)) * p.size;
    double h2 = p.support * p.support;
    for (int k = 0; k <= SPH2D__PACKER_SLOPES; ++k)
        p.slope[k] = p.size * p.size * sph2d__kernel_constant(p.kernel) / (h2 * h2) *
                     sph2d__kernel_slope_at(p.kernel, sqrt((double)k / SPH2D__PACKER_SLOPES));
    p.bucket = p.support + SPH2D__PACKER_SKIN * p.size;
    p.bx = (size_t)ceil((double)region->nx * p.size / p.bucket) + 1;
    p.by = (size_t)ceil((double)region->ny * p.size / p.bucket) + 1;
    return p;
}

static size_t room_for(const sph2d__region *region)
{
    size_t side = 1;
    while (side < region->nx || side < region->ny)
        side *= 2;
    return side;
}

bool sph2d__pack(sph2d_sim *sim, sph2d__region *region, sph2d__packing *packing)
{
    sph2d__memory *memory = &sim->memory;
    sph2d__packer p = packer_of(sim, region);
    size_t cells = sph2d__packer_cells(&p), buckets = p.bx * p.by + 1;
    *packing = (sph2d__packing){0};
    void *marks[2] = {sph2d__alloc(memory, cells, 1), sph2d__alloc(memory, cells, 1)};
    p.chosen = marks[0];
    p.near_edge = marks[1];
    long points = 0;
    if (p.chosen)
        choose(&p, 0, 0, room_for(region), &points);
    const size_t n = p.count;
    void *vectors[4], *numbers[3], *start = sph2d__alloc(memory, buckets, sizeof *p.start);
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
    bool ok = p.chosen && p.near_edge && p.at && p.velocity && p.gradient && p.old && p.mover && p.order && p.first &&
              p.start && set_places(&p);
    if (ok) {
        sph2d__packer_find_missing(&p);
        ok = sph2d__packer_relax(&p, &packing->residual);
    }
    void *partner = p.partner;
    sph2d__release(memory, &partner, p.partner_capacity, sizeof *p.partner);
    sph2d__release(memory, &start, buckets, sizeof *p.start);
    for (int k = ok ? 1 : 0; k < 4; ++k)
        sph2d__release(memory, &vectors[k], n + 1, sizeof(sph2d_vec2));
    for (int k = 0; k < 3; ++k)
        sph2d__release(memory, &numbers[k], n + 1, sizeof(uint32_t));
    for (int k = 0; k < 2; ++k)
        sph2d__release(memory, &marks[k], cells, 1);
    packing->places = ok ? p.at : NULL;
    packing->count = ok ? n : 0;
    return ok;
}

void sph2d__packing_free(sph2d__packing *packing, sph2d__memory *memory)
{
    void *block = packing->places;
    sph2d__release(memory, &block, packing->count + 1, sizeof(sph2d_vec2));
    packing->places = NULL;
}
