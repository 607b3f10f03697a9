/* SPDX-License-Identifier: MIT */
/** @file grid_device.c
 *  What of the grid of method `hybrid` a device has: sums over its particles, and what faces say to them. The host solves in between. */
#include "methods/common/on_device.h"
#include "methods/hybrid/grid.h"

static const void *data_of(const sph2d__system *s)
{
    return s->grid;
}

static void place(const sph2d__system *s, void *copy)
{
    sph2d__grid *g = copy;
    *g = *s->grid;
    sph2d__place_block(s, &g->q, g->size * sizeof *g->q, SPH2D__OF_SCENE);
    sph2d__place_block(s, &g->face_x, g->size * sizeof *g->face_x, SPH2D__OF_SCENE);
    sph2d__place_block(s, &g->face_y, g->size * sizeof *g->face_y, SPH2D__OF_SCENE);
    sph2d__place_block(s, &g->jets, g->jet_count * sizeof *g->jets, SPH2D__OF_SCENE);
    sph2d__place_block(s, &g->sums.x, g->size * sizeof *g->sums.x, SPH2D__OF_GRID);
    sph2d__place_block(s, &g->sums.y, g->size * sizeof *g->sums.y, SPH2D__OF_GRID);
    sph2d__place_block(s, &g->sums.middle, g->size * sizeof *g->sums.middle, SPH2D__OF_GRID);
}

_Static_assert(sizeof(sph2d__grid) <= SPH2D__MOST_EXTRA, "kernels get a grid of this size");
const struct sph2d__extra sph2d__grid_extra = {sizeof(sph2d__grid), data_of, place};

void sph2d__grid_solved(const sph2d__system *s)
{
    const sph2d__grid *g = s->grid;
    void *const all[] = {g->q, g->face_x, g->face_y, g->jets};
    for (size_t k = 0; sph2d__is_on_device(s) && k < sizeof all / sizeof *all; ++k)
        sph2d__host_changed_block(s, all[k]);
}
