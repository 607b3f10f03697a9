/* SPDX-License-Identifier: MIT */
/** @file wcsph_gather_pass.c
 *  Gathers slab by slab. Compiled once for each instruction set, named by SPH2D__ISA, and in it once for each kernel. */
#include "methods/wcsph/wcsph.h"
#include "methods/wcsph/wcsph_gather.h"

/** Finds the faces that particles of slab k are before. */
static void see_slab(sph2d__system *s, size_t k)
{
    sph2d__neighbours *n = &s->neighbours;
    sph2d__pairs to = sph2d__pairs_start(n, k);
    const size_t begin = to.next, count = s->fluid.count,
                 end = (k + 1) * SPH2D__SLAB < count ? (k + 1) * SPH2D__SLAB : count;
    for (size_t i = k * SPH2D__SLAB; i < end && !to.full; i += SPH2D__LANES, to.next = begin) {
        sph2d__pairs_search(&to, &to.walls, &s->wall_cells, &s->walls, &s->fluid, i, s->support * s->support, false,
                            NULL);
        const uint32_t slots = sph2d__pairs_write(n, &to, s->walls.count);
        find_sight(s, i, begin, slots);
    }
}

/** Gathers for the particles of slab k. False when it is full. */
SPH2D__INLINE bool gather_slab(sph2d__system *s, size_t k, sph2d_kernel kernel)
{
    sph2d__pairs to = sph2d__pairs_start(&s->neighbours, k);
    const size_t count = s->fluid.count, end = (k + 1) * SPH2D__SLAB < count ? (k + 1) * SPH2D__SLAB : count;
    for (size_t i = k * SPH2D__SLAB; i < end && !to.full; i += SPH2D__LANES)
        gather_slice(s, &to, i, kernel);
    return !to.full;
}

/* ---- one for every kernel ---------------------------------------------------------------------------------------- */

#define FOR_KERNEL(name, word)                                                                                         \
    static bool gather_##word(sph2d__system *s, size_t k)                                                              \
    {                                                                                                                  \
        return gather_slab(s, k, SPH2D_KERNEL_##name);                                                                 \
    }
SPH2D_KERNEL_MAP(FOR_KERNEL)

#define ENTRY(name, word) [SPH2D_KERNEL_##name] = gather_##word,
const sph2d__wcsph_gather_pass SPH2D__OF_ISA(sph2d__wcsph_gather) = {
    .lanes = SPH2D__LANES, .see = see_slab, .gather = {SPH2D_KERNEL_MAP(ENTRY)}, .compare = compare};
