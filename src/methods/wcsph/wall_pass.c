/* SPDX-License-Identifier: MIT */
/** @file wall_pass.c
 *  The loops of method `wcsph` over boundary particles; the pair terms are in wall_pair.h. Compiled once for each
 *  instruction set, named by SPH2D__ISA, and within it once for each kernel. */
#include "methods/wcsph/wall_pair.h"

SPH2D__INLINE void walls_with(sph2d__system *s, size_t first, size_t last, sph2d_kernel kernel, wall_output what)
{
    const sph2d__packed f = sph2d__packed_of(s, &s->fluid, false);
    const sph2d__grouping by = sph2d__grouping_of(&s->walls, &s->wall_cells, &s->fluid_cells);
    const sph2d__real inverse_support = (sph2d__real)(1 / s->support);
    SPH2D__FOR_GROUPS (&by, g, first, last) {
        wall_sums sums = {0};
        sph2d__sieve sieve;
        sph2d__ranges ranges = {0};
        const group_state own = group_state_of(s, g.first);
        sph2d__group_others(&by, &g, &ranges);
        sph2d__sieve_start(&sieve, &ranges, s->support);
        while (sph2d__sift(&sieve, &g, &ranges, f.x, f.y)) {
            positions at = positions_of(&s->walls, &g, sieve.offset_x, sieve.offset_y);
            SPH2D__FOR_FOUND (sieve, j) {
                pair p = pair_with(kernel, inverse_support, &at, &f, j);
                add_candidate(&sums, s, &f, j, kernel, what, &p, &own);
            }
        }
        const wall_sums done = sums; /* a copy, so that the sums can stay in registers */
        SPH2D__FOR_LANES (g, l)
            finish_wall(s, g.first + (size_t)l, &done, l, what);
    }
}

/* ---- one for each kernel ----------------------------------------------------------------------------------------- */

#define FOR_KERNEL(name, word)                                                                                         \
    static void rates_##word(sph2d__system *s, size_t first, size_t last)                                              \
    {                                                                                                                  \
        walls_with(s, first, last, SPH2D_KERNEL_##name, RATES);                                                        \
    }                                                                                                                  \
    static void wall_##word(sph2d__system *s, size_t first, size_t last)                                               \
    {                                                                                                                  \
        if (s->walls_rough)                                                                                            \
            walls_with(s, first, last, SPH2D_KERNEL_##name, PRESSURES_AND_IMAGES);                                     \
        else                                                                                                           \
            walls_with(s, first, last, SPH2D_KERNEL_##name, PRESSURES);                                                \
    }
SPH2D_KERNEL_MAP(FOR_KERNEL)

#define RATES_ENTRY(name, word) [SPH2D_KERNEL_##name] = rates_##word,
const sph2d__wcsph_pass SPH2D__OF_ISA(sph2d__wcsph_wall_rate) = {{SPH2D_KERNEL_MAP(RATES_ENTRY)}};
#define WALL_ENTRY(name, word) [SPH2D_KERNEL_##name] = wall_##word,
const sph2d__wcsph_pass SPH2D__OF_ISA(sph2d__wcsph_wall) = {{SPH2D_KERNEL_MAP(WALL_ENTRY)}};
