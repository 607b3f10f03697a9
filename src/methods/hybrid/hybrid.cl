/* SPDX-License-Identifier: MIT */
/* The program of method `hybrid`. */
#define SPH2D__MIXED
#include "sim/shapes.cl"

#include "methods/hybrid/grid_data.h"

static inline sph2d__grid placed_grid(__global uchar *arena, __global const uchar *at)
{
    sph2d__grid g = *(__global const sph2d__grid *)at;
    g.q = BLOCK(float, g.q);
    g.face_x = BLOCK(sph2d__quad, g.face_x);
    g.face_y = BLOCK(sph2d__quad, g.face_y);
    g.jets = BLOCK(sph2d__jet, g.jets);
    g.sums.x = BLOCK(sph2d__pair2, g.sums.x);
    g.sums.y = BLOCK(sph2d__pair2, g.sums.y);
    g.sums.middle = BLOCK(sph2d__quad, g.sums.middle);
    return g;
}

#define SYSTEM                                                                                                         \
    sph2d__system s = placed(arena, numbers + system_at);                                                              \
    sph2d__grid grid = placed_grid(arena, numbers + system_at + sizeof(sph2d__system));                                \
    s.grid = &grid;
#include "sim/kernels.cl"

#include "methods/hybrid/hybrid_pairs.h"
#include "methods/hybrid/transfer.h"

/* ---- particles --------------------------------------------------------------------------------------------------- */

SPAN(pack_fluid_pass, pack_fluid)
SPAN(wall_pack_pass, pack_walls)
SPAN(pack_pass, pack)
SPAN(density_pass, density)
SPAN(order_pass, order)
SPAN(accelerate_pass, accelerate)
SPAN(kick_pass, kick)

static inline void nothing_after(const sph2d__system *s, double dt, size_t i)
{
}
ADVECT(way_of, nothing_after)

static inline void one_energy(const sph2d__system *s, size_t i, const int *none, sph2d__slab_sum *sum)
{
    sph2d__add_energy(s, i, 0, sum);
}
SUM(sum_energy, int, one_energy)

/* ---- to the grid ------------------------------------------------------------------------------------------------- */

/* Adds to a square, its left and its lower face the particles around it, in their order, as a row of the grid gets them. */
__kernel void grid_sum(ARGUMENTS)
{
    const size_t k = get_global_id(0);
    SYSTEM
    const units unit = units_of(&s, *(__global const double *)(numbers + own_at));
    const sph2d__cells *c = &s.fluid_cells;
    if (k >= count)
        return;
    sph2d__target to = {(int)(k % grid.stride), (int)(k / grid.stride), 0, 0, 0};
    size_t row, end;
    rows_touching(c, &grid, to.row, to.row + 1, &row, &end);
    const size_t left = column_at(c, &grid, to.column - 2.0), right = column_at(c, &grid, to.column + 0.5);
    for (; row <= end && c->nx > 0 && c->ny > 0; ++row)
        for (size_t i = c->start[row * c->nx + left]; i < c->start[row * c->nx + right + 1]; ++i)
            add_one(&s, unit, i, &to);
    grid.sums.x[k] = (sph2d__pair2){to.left.x, to.left.y};
    grid.sums.y[k] = (sph2d__pair2){to.lower.x, to.lower.y};
    grid.sums.middle[k] = to.middle;
}
