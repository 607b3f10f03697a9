/* SPDX-License-Identifier: MIT */
/* The program of method `hybrid`. */
#define SPH2D__MIXED
#include "sim/shapes.cl"

#include "methods/hybrid/grid_data.h"

static inline sph2d__grid placed_grid(__global uchar *arena, __global const uchar *at)
{
    sph2d__grid g = *(__global const sph2d__grid *)at;
#define PLACE(name) g.name = BLOCK(float, g.name);
    SPH2D__GRID_FIELDS(PLACE)
    PLACE(pressure.residual)
    PLACE(volume.residual)
    PLACE(level[0].left)
    PLACE(level[0].below)
    PLACE(level[0].air)
    PLACE(level[0].inverse)
#undef PLACE
    g.level[0].from = BLOCK(int, g.level[0].from);
    g.level[0].to = BLOCK(int, g.level[0].to);
    g.begin = BLOCK(int, g.begin);
    g.end = BLOCK(int, g.end);
    g.cut = BLOCK(uint32_t, g.cut);
    g.face_x = BLOCK(sph2d__quad, g.face_x);
    g.face_y = BLOCK(sph2d__quad, g.face_y);
    g.nozzles = BLOCK(sph2d__nozzle, g.nozzles);
    g.jets = BLOCK(sph2d__jet, g.jets);
    g.sums.x = BLOCK(sph2d__pair2, g.sums.x);
    g.sums.y = BLOCK(sph2d__pair2, g.sums.y);
    g.sums.middle = BLOCK(sph2d__quad, g.sums.middle);
    return g;
}

/* One level of it: as a thread's own array of all, which it would index, they would be in slow memory. */
static inline sph2d__level placed_level(__global uchar *arena, __global const uchar *at, int n)
{
    sph2d__level l = ((__global const sph2d__grid *)at)->level[n];
    l.left = BLOCK(float, l.left);
    l.below = BLOCK(float, l.below);
    l.air = BLOCK(float, l.air);
    l.inverse = BLOCK(float, l.inverse);
    l.from = BLOCK(int, l.from);
    l.to = BLOCK(int, l.to);
    return l;
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

static inline sph2d__way one_way(const sph2d__system *s, double dt, size_t i)
{
    const pace p = pace_of(s, dt);
    return way_of(s, &p, i);
}
ADVECT(one_way, nothing_after)

static inline void one_energy(const sph2d__system *s, size_t i, const int *none, sph2d__slab_sum *sum)
{
    sph2d__add_energy(s, i, 0, sum);
}
SUM(sum_energy, int, one_energy)

/* ---- to the grid ------------------------------------------------------------------------------------------------- */

/* Adds to a square, its left and its lower face the particles around it, in their order, as a row of the grid gets them. */
KERNEL(grid_sum)
{
    const size_t k = get_global_id(0);
    SYSTEM
    const units unit = units_of(&s, *(__global const double *)(numbers + own_at));
    const sph2d__cells *c = &s.fluid_cells;
    if (k >= count)
        return;
    sph2d__target to = {.column = (int)(k % grid.stride), .row = (int)(k / grid.stride)};
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

/* ---- multigrid --------------------------------------------------------------------------------------------------- */

#include "methods/hybrid/multigrid.h"

/* The work of a kernel, its fields, the level that it works on, and the next finer one. */
#define WORK                                                                                                           \
    const size_t k = get_global_id(0);                                                                                 \
    const sph2d__grid_work with = *(__global const sph2d__grid_work *)(numbers + own_at);                              \
    __global const uchar *grid_at = numbers + system_at + sizeof(sph2d__system);                                       \
    __global float *a = BLOCK(float, with.field[0]), *b = BLOCK(float, with.field[1]),                                 \
                   *c = BLOCK(float, with.field[2]), *d = BLOCK(float, with.field[3]);                                 \
    const sph2d__level l = placed_level(arena, grid_at, with.level);                                                   \
    const int i = (int)(k % l.stride), j = (int)(k / l.stride);                                                        \
    const couplings by = couplings_of(&l);

/* A kernel that does something to liquid squares k. */
#define ON_LIQUID(name, something)                                                                                     \
    KERNEL(name)                                                                                                       \
    {                                                                                                                  \
        WORK                                                                                                           \
        if (k < count && is_within(&l, i, j)) {                                                                        \
            something;                                                                                                 \
        }                                                                                                              \
    }

ON_LIQUID(grid_multiply, b[k] = product_at(&by, a, k))
ON_LIQUID(grid_start, a[k] = DAMPING * l.inverse[k] * b[k])
ON_LIQUID(grid_sweep, a[k] += DAMPING * l.inverse[k] * (b[k] - c[k]))
ON_LIQUID(grid_invert, l.inverse[k] = inverse_at(&by, k))
ON_LIQUID(grid_rest, a[k] = l.inverse[k] > 0 ? a[k] - b[k] : 0)
ON_LIQUID(grid_direct, a[k] = with.times > 0 ? b[k] + with.factor * a[k] : b[k])
ON_LIQUID(grid_advance, a[k] += with.factor * c[k]; b[k] -= with.factor * d[k])
ON_LIQUID(grid_restrict, const sph2d__level fine = placed_level(arena, grid_at, with.level - 1);
          a[k] = l.inverse[k] > 0 ? left_in(&fine, b, c, i, j) : 0)
ON_LIQUID(grid_prolong, const sph2d__level coarse = placed_level(arena, grid_at, with.level + 1);
          a[k] += l.inverse[k] > 0 ? b[coarse_of(&coarse, i, j)] : 0)

KERNEL(grid_coarsen_rows)
{
    WORK
    const sph2d__level fine = placed_level(arena, grid_at, with.level - 1);
    if (k < (size_t)l.ny + 2)
        coarsen_row(&fine, &l, (int)k);
}

KERNEL(grid_coarsen)
{
    WORK
    const sph2d__level fine = placed_level(arena, grid_at, with.level - 1);
    if (k >= count)
        return;
    l.left[k] = l.below[k] = l.air[k] = l.inverse[k] = 0;
    if (has_faces(&l, i, j))
        couple(&fine, &l, i, j);
}

static inline void wrap_one(const sph2d__grid *g, const sph2d__level *l, __global float *field, size_t k)
{
    const int i = (int)(k % l->stride), j = (int)(k / l->stride);
    const size_t inside = sph2d__inside_of(g, l, i, j);
    if (inside != k && (j > 0 || g->wraps_y) && (j <= l->ny || (g->wraps_y && j == l->ny + 1)))
        field[k] = field[inside];
}

KERNEL(grid_wrap)
{
    WORK
    const sph2d__grid grid = *(__global const sph2d__grid *)grid_at;
    if (k < count)
        wrap_one(&grid, &l, a, k);
}

/* All sweeps on a small level, by one group. */
KERNEL(grid_smooth)
{
    WORK
    const sph2d__grid grid = *(__global const sph2d__grid *)grid_at;
#define FOR_SQUARES(some)                                                                                              \
    barrier(CLK_GLOBAL_MEM_FENCE);                                                                                     \
    for (size_t n = k; n < l.size; n += SPH2D__SLAB)                                                                   \
        if (some)
#define IS_LIQUID is_within(&l, (int)(n % l.stride), (int)(n / l.stride))
    FOR_SQUARES(IS_LIQUID)
    a[n] = DAMPING * l.inverse[n] * b[n];
    for (int sweep = 0; sweep < with.times; ++sweep) {
        FOR_SQUARES(grid.wraps_x || grid.wraps_y)
        wrap_one(&grid, &l, a, n);
        FOR_SQUARES(IS_LIQUID)
        c[n] = product_at(&by, a, n);
        FOR_SQUARES(IS_LIQUID)
        a[n] += DAMPING * l.inverse[n] * (b[n] - c[n]);
    }
#undef FOR_SQUARES
#undef IS_LIQUID
}

/* The products of a row, each thread those of every eighth square. */
KERNEL(grid_dot)
{
    __local float parts[SPH2D__SLAB];
    const size_t row = get_global_id(0) / SIDE_BY_SIDE, n = get_global_id(0) % SIDE_BY_SIDE, l = get_local_id(0);
    const sph2d__grid_work with = *(__global const sph2d__grid_work *)(numbers + own_at);
    const sph2d__level of = placed_level(arena, numbers + system_at + sizeof(sph2d__system), 0);
    __global const float *a = BLOCK(float, with.field[0]), *b = BLOCK(float, with.field[1]);
    float sum = 0;
    if (row >= 1 && row <= of.ny) {
        const size_t at = row * of.stride, end = at + (size_t)of.to[row] + 1;
        size_t k = at + (size_t)of.from[row];
        for (; k + SIDE_BY_SIDE <= end; k += SIDE_BY_SIDE)
            sum += a[k + n] * b[k + n];
        for (; k < end && n == 0; ++k)
            sum += a[k] * b[k];
    }
    parts[l] = sum;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (n > 0)
        return;
    float all[SIDE_BY_SIDE];
    for (int m = 0; m < SIDE_BY_SIDE; ++m)
        all[m] = parts[l + m];
    ((__global float *)results)[row] = sum_of_row(all);
}

/* ---- equations and faces ----------------------------------------------------------------------------------------- */

#include "methods/hybrid/grid_squares.h"

/* The grid, level 0 of which has square k, and the number of a kernel's work. */
#define GRID                                                                                                           \
    const size_t k = get_global_id(0);                                                                                 \
    const sph2d__grid_work with = *(__global const sph2d__grid_work *)(numbers + own_at);                              \
    sph2d__grid grid = placed_grid(arena, numbers + system_at + sizeof(sph2d__system));                                \
    const sph2d__grid *g = &grid;

/* A kernel that does something to squares, or lines, k that fulfil a condition. */
#define ON_GRID(name, condition, something)                                                                            \
    KERNEL(name)                                                                                                       \
    {                                                                                                                  \
        GRID                                                                                                           \
        if (k < count && (condition)) {                                                                                \
            something;                                                                                                 \
        }                                                                                                              \
    }
#define HAS_FACES has_faces(&grid.level[0], (int)(k % grid.stride), (int)(k / grid.stride))
#define HAS_LIQUID is_within(&grid.level[0], (int)(k % grid.stride), (int)(k / grid.stride))

ON_GRID(grid_clear, true, grid.mass[k] = grid.excess[k] = grid.u[k] = grid.v[k] = grid.q[k] = grid.s[k] = 0;
        grid.air_x[k] = grid.air_y[k] = grid.wet_x[k] = grid.wet_y[k] = 0;
        grid.level[0].left[k] = grid.level[0].below[k] = grid.level[0].air[k] = grid.level[0].inverse[k] = 0;
        grid.face_x[k] = grid.face_y[k] = SPH2D__QUAD(0, 0, 0, 0))
ON_GRID(grid_fold, true,
        sph2d__fold_line(&grid.sums, with.times ? k : k * grid.stride, with.times ? grid.ny : grid.nx,
                         with.times ? grid.stride : 1))
ON_GRID(grid_means, is_set(g, k), take_mean(g, k))
ON_GRID(grid_set_jets, true, set_jets(g))
ON_GRID(grid_find_liquid, true, find_liquid_of(g, (int)k))
ON_GRID(grid_couple_faces, HAS_FACES, couple_faces(g, k))
ON_GRID(grid_set_equations, HAS_LIQUID, set_equation(g, k))
ON_GRID(grid_feed, true, feed(g))
ON_GRID(grid_set_volumes, is_set(g, k), grid.s[k] = 0; if (HAS_LIQUID) set_volume(g, k))
ON_GRID(grid_keep_liquid, is_set(g, k), grid.q[k] = is_liquid(g, k) ? grid.q[k] : 0)
ON_GRID(grid_keep_known, is_set(g, k), grid.q[k] = grid.level[0].inverse[k] > 0 ? grid.q[k] : 0)
ON_GRID(grid_press, HAS_FACES, press_faces(g, with.factor, k))
ON_GRID(grid_set_faces, HAS_FACES, set_faces_of(g, k))
ON_GRID(grid_close_jets, true, close_jets(g))
ON_GRID(grid_close_sides, true, close_side(g, (int)(k % 4), (int)(k / 4) + 1))
ON_GRID(grid_continue, is_set(g, k), continue_pressure_to(g, k))
ON_GRID(grid_wrap_faces, true, wrap_quad(g, grid.face_x, (int)(k % grid.stride), (int)(k / grid.stride));
        wrap_quad(g, grid.face_y, (int)(k % grid.stride), (int)(k / grid.stride)))

/* Of squares that solids cut, k in their list. */
#define CUT grid.cut[k]
#define IS_INSIDE (is_set(g, CUT) && !(grid.hidden[CUT] < 0.5F))
ON_GRID(grid_begin_cut, is_set(g, CUT), grid.s[CUT] = UNKNOWN)
ON_GRID(grid_look_at_cut, is_set(g, CUT), grid.pressure.residual[CUT] = mean_beside(g, grid.s, CUT))
ON_GRID(grid_look_beside, IS_INSIDE && grid.s[CUT] < 0, grid.filled[k] = mean_beside(g, grid.s, CUT))
ON_GRID(grid_fill_cut, is_set(g, CUT), fill_hidden(g, grid.pressure.residual, grid.s, CUT))

KERNEL(grid_spread)
{
    __local uint32_t counts[SPH2D__SLAB];
    const size_t k = get_global_id(0), l = get_local_id(0);
    sph2d__grid grid = placed_grid(arena, numbers + system_at + sizeof(sph2d__system));
    const sph2d__grid *g = &grid;
    counts[l] = 0;
    if (k < count && IS_INSIDE && grid.s[CUT] < 0) {
        grid.s[CUT] = grid.filled[k];
        counts[l] = grid.filled[k] < 0;
    }
    barrier(CLK_LOCAL_MEM_FENCE);
    if (l > 0)
        return;
    uint32_t sum = 0;
    for (size_t n = 0; n < SPH2D__SLAB; ++n)
        sum += counts[n];
    ((__global uint32_t *)results)[get_group_id(0)] = sum;
}
