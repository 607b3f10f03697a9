/* SPDX-License-Identifier: MIT */
/** @file neighbours.c
 *  Memory of the neighbour lists. */
#include "particles/neighbours.h"

enum { GRADIENTS = 2, BLOCKS = 4 };

/** The blocks, and the items of each per slab. */
static void list_blocks(sph2d__neighbours *n, size_t each, sph2d__growth blocks[BLOCKS], size_t items[BLOCKS])
{
    const sph2d__growth all[BLOCKS] = {{&n->slices, sizeof *n->slices},
                                       {&n->index, sizeof *n->index},
                                       {&n->gradient, sizeof *n->gradient},
                                       {&n->found, sizeof *n->found}};
    const size_t lengths[BLOCKS] = {SPH2D__SLAB / SPH2D__NARROWEST, each * SPH2D__SLAB, each * SPH2D__SLAB,
                                    4 * each * SPH2D__WIDEST};
    for (int k = 0; k < BLOCKS; ++k) {
        blocks[k] = all[k];
        items[k] = lengths[k];
    }
}

bool sph2d__neighbours_reserve(sph2d__neighbours *n, sph2d__memory *memory, size_t count, size_t each, bool gradients)
{
    if (n->slices && count <= n->particles && each <= n->each)
        return true;
    size_t particles = count > n->particles ? count + count / 2 : n->particles;
    particles = particles > 0 ? particles : 1; /* no particle yet: sources may add some */
    each = each > n->each ? each : n->each;
    sph2d__neighbours_free(n, memory);
    sph2d__growth blocks[BLOCKS];
    size_t items[BLOCKS];
    list_blocks(n, each, blocks, items);
    items[GRADIENTS] *= gradients;
    n->particles = particles;
    n->each = each;
    for (int k = 0; k < BLOCKS; ++k)
        if (items[k] > 0 && !sph2d__grow_all(memory, &blocks[k], 1, 0, sph2d__slabs(particles) * items[k])) {
            sph2d__neighbours_free(n, memory);
            return false;
        }
    return true;
}

void sph2d__neighbours_free(sph2d__neighbours *n, sph2d__memory *memory)
{
    size_t lengths[BLOCKS], slabs = sph2d__slabs(n->particles);
    sph2d__growth blocks[BLOCKS];
    list_blocks(n, n->each, blocks, lengths);
    void *all[BLOCKS] = {n->slices, n->index, n->gradient, n->found};
    for (int k = 0; k < BLOCKS; ++k)
        sph2d__release(memory, &all[k], all[k] ? slabs * lengths[k] : 0, blocks[k].size);
    *n = (sph2d__neighbours){0};
}
