/* SPDX-License-Identifier: MIT */
/** @file pair.h
 *  Shared by the pair loops of method `wcsph` with symmetric operators. */
#ifndef SPH2D_METHODS_WCSPH_PAIR_H
#define SPH2D_METHODS_WCSPH_PAIR_H

#include "kernels/kernel.h"
#include "methods/common/group.h"
#include "methods/common/packed.h"

/** Distances of a group from a candidate, q = r/H, and g of the kernel. */
typedef struct pair {
    sph2d__lanes dx, dy, r2, q, g;
} pair;

/** Positions of the particles of a group, plus the image offset of the candidates. */
typedef struct positions {
    sph2d__lanes x, y;
} positions;

SPH2D__INLINE positions positions_of(const sph2d__store *store, const sph2d__group *g, double offset_x, double offset_y)
{
    return (positions){sph2d__group_lanes(store->x + g->first, offset_x),
                       sph2d__group_lanes(store->y + g->first, offset_y)};
}

SPH2D__INLINE pair pair_with(sph2d_kernel kernel, sph2d__real inverse_support, const positions *at,
                             const sph2d__packed *from, size_t j)
{
    pair p;
    p.dx = at->x - from->x[j];
    p.dy = at->y - from->y[j];
    p.r2 = p.dx * p.dx + p.dy * p.dy;
    p.q = sph2d__lanes_sqrt(p.r2) * inverse_support;
    p.g = sph2d__kernel_slope(kernel, p.q);
    return p;
}

/** C/H^4: grad W is this times g r_ij. */
static inline double slope_scale(const sph2d__system *s)
{
    double h2 = s->support * s->support;
    return sph2d__kernel_constant(s->method.kernel) / (h2 * h2);
}

/* det M / (tr M)^2 is 0.25 in the bulk, about as much at a flat surface, and 0 if all neighbours are on one line, as in
 * a film on a wall; below this the inverse would amplify noise. */
static const double MIN_CONDITION = 0.1;

/** Sets (gx, gy) to the renormalised gradient M^-1 b, M and b without the same constant; zero if the neighbours are on
 *  one line. */
SPH2D__INLINE void renormalise(double xx, double xy, double yy, double bx, double by, double *gx, double *gy)
{
    double det = xx * yy - xy * xy;
    bool invertible = det > MIN_CONDITION * (xx + yy) * (xx + yy);
    *gx = invertible ? (yy * bx - xy * by) / det : 0;
    *gy = invertible ? (xx * by - xy * bx) / det : 0;
}

#endif
