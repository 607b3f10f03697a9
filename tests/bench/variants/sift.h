/* SPDX-License-Identifier: MIT */
/** @file sift.h
 *  Which candidates of a range are near a group: tested a block of lanes at a time, their numbers written one behind
 *  the other. Those behind a range's end are too far away to be kept. */
#ifndef SPH2D_TESTS_BENCH_SIFT_H
#define SPH2D_TESTS_BENCH_SIFT_H

#include "methods/common/group.h"
#include "pair.h"

/** Those within a distance of a group's box. Returns where the next one goes. */
SPH2D__INLINE uint32_t *sift_by_box(const sph2d__store *s, const sph2d__group *g, double reach2, size_t first,
                                    size_t end, uint32_t *to)
{
    const sph2d__lanes zero = {0};
    for (size_t j = first; j < end; j += SPH2D__LANES) {
        sph2d__lanes x = sph2d__lanes_load(s->x + j), y = sph2d__lanes_load(s->y + j);
        sph2d__lanes dx = sph2d__lanes_max(sph2d__lanes_max(g->low_x - x, x - g->high_x), zero);
        sph2d__lanes dy = sph2d__lanes_max(sph2d__lanes_max(g->low_y - y, y - g->high_y), zero);
        unsigned near = sph2d__lanes_which(dx * dx + dy * dy, reach2);
        sph2d__lanes_pack_index(to, (uint32_t)j, near);
        to += __builtin_popcount(near);
    }
    return to;
}

/** Those within a distance of any of its particles. Lanes behind the last one hold others: they keep too much. */
SPH2D__INLINE uint32_t *sift_by_all(const sph2d__store *s, const sph2d__group *g, double reach2, size_t first,
                                    size_t end, uint32_t *to)
{
    const double *x = s->x + g->first, *y = s->y + g->first;
    for (size_t j = first; j < end; j += SPH2D__LANES) {
        sph2d__lanes xj = sph2d__lanes_load(s->x + j), yj = sph2d__lanes_load(s->y + j);
        sph2d__lanes nearest = sph2d__lanes_all(-INFINITY); /* less the least squared distance */
        for (int l = 0; l < SPH2D__LANES; ++l) {
            sph2d__lanes dx = x[l] - xj, dy = y[l] - yj;
            nearest = sph2d__lanes_max(nearest, -(dx * dx) - dy * dy);
        }
        unsigned near = sph2d__lanes_which(-nearest, reach2);
        sph2d__lanes_pack_index(to, (uint32_t)j, near);
        to += __builtin_popcount(near);
    }
    return to;
}

#endif
