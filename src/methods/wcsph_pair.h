/* SPDX-License-Identifier: MIT */
/** @file wcsph_pair.h
 *  What the pair loops of method `wcsph` with symmetric operators share. */
#ifndef SPH2D_METHODS_WCSPH_PAIR_H
#define SPH2D_METHODS_WCSPH_PAIR_H

#include "kernels/kernel.h"
#include "methods/packed.h"
#include "methods/traverse.h"

/** Distance to a block's particles, in units of the support radius too, and g of the kernel there, 0 in lanes that
 * count as nothing. */
typedef struct pair {
    sph2d__lanes dx, dy, r2, q, g;
} pair;

SPH2D__INLINE pair pair_with(sph2d_kernel kernel, double support, double x, double y, const sph2d__ranges *ranges,
                             int range, const sph2d__packed *from, size_t j, double left)
{
    pair p;
    p.dx = (sph2d__real)(x + ranges->x[range]) - sph2d__lanes_load(from->x + j);
    p.dy = (sph2d__real)(y + ranges->y[range]) - sph2d__lanes_load(from->y + j);
    p.r2 = p.dx * p.dx + p.dy * p.dy;
    p.q = sph2d__lanes_sqrt(p.r2) * (sph2d__real)(1 / support);
    p.g = sph2d__lanes_first(sph2d__kernel_slope(kernel, p.q), left);
    return p;
}

/** C/H^4: grad W is this times g times the distance. */
static inline double slope_scale(const sph2d__system *s)
{
    double h2 = s->support * s->support;
    return sph2d__kernel_constant(s->method.kernel) / (h2 * h2);
}

/** Whether boundary particles are near; then the cursor is at their ranges. */
SPH2D__INLINE bool near_walls(const sph2d__system *s, sph2d__cursor *cursor, double x, double y)
{
    return s->walls_press && sph2d__cursor_move(cursor, &s->wall_cells, x, y);
}

/* det M / (tr M)^2 is 0.25 in the bulk, about as much at a flat surface, and 0 where all neighbours are on one line, as
 * in a film on a wall; below this the inverse would magnify noise. */
static const double SOUND = 0.1;

/** Inverts M and gives a gradient from its sums, both without the same constant; zero where neighbours are on a line.
 */
SPH2D__INLINE void corrected(double xx, double xy, double yy, double bx, double by, double *gx, double *gy)
{
    double det = xx * yy - xy * xy;
    bool sound = det > SOUND * (xx + yy) * (xx + yy);
    *gx = sound ? (yy * bx - xy * by) / det : 0;
    *gy = sound ? (xx * by - xy * bx) / det : 0;
}

#endif
