/* SPDX-License-Identifier: MIT */
/** @file projection_pass.c
 *  The sums of projection.h over the neighbours that were gathered. Compiled once for each instruction set, named by
 *  SPH2D__ISA, and prediction in it once for each kernel. Every lane is a particle. */
#include "kernels/kernel.h"
#include "methods/projection.h"
#include "methods/shortest.h"

/** Runs the statement behind it for each slice of particles `first` to `end` - 1, its first particle being `i`. */
#define FOR_SLICES(first, end, i) for (size_t i = (first); i < (end); i += SPH2D__LANES)

/** The gradients of the slot whose pairs begin at k. */
#define GX(n, k) sph2d__lanes_load_float((n)->gx + (k))
#define GY(n, k) sph2d__lanes_load_float((n)->gy + (k))

static void spread(sph2d__system *s, sph2d__rows y, size_t first, size_t last)
{
    const sph2d__neighbours *n = &s->neighbours;
    sph2d__store *f = &s->fluid;
    FOR_SLICES(first, last, i)
    {
        const sph2d__slice *at = &n->slices[i / SPH2D__LANES];
        size_t walls = at->begin + (size_t)at->fluid * SPH2D__LANES, end = walls + (size_t)at->walls * SPH2D__LANES;
        sph2d__lanes own = sph2d__lanes_load(y.fluid + i), px = {0}, py = {0};
        for (size_t k = at->begin; k < walls; k += SPH2D__LANES) {
            sph2d__lanes both = own + sph2d__lanes_gather_late(y.fluid, n->index + k);
            px += both * GX(n, k);
            py += both * GY(n, k);
        }
        for (size_t k = walls; k < end; k += SPH2D__LANES) {
            sph2d__lanes both = own + sph2d__lanes_gather_late(y.walls, n->index + k);
            px += both * GX(n, k);
            py += both * GY(n, k);
        }
        sph2d__lanes_store(f->push_x + i, px);
        sph2d__lanes_store(f->push_y + i, py);
    }
}

static void collect_fluid(sph2d__system *s, double share, double *out, size_t first, size_t last)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    FOR_SLICES(first, last, i)
    {
        const sph2d__slice *at = &n->slices[i / SPH2D__LANES];
        size_t walls = at->begin + (size_t)at->fluid * SPH2D__LANES, end = walls + (size_t)at->walls * SPH2D__LANES;
        sph2d__lanes ux = sph2d__lanes_load(f->push_x + i), uy = sph2d__lanes_load(f->push_y + i), sx = {0}, sy = {0};
        for (size_t k = at->begin; k < walls; k += SPH2D__LANES) {
            sx += (ux - sph2d__lanes_gather_late(f->push_x, n->index + k)) * GX(n, k);
            sy += (uy - sph2d__lanes_gather_late(f->push_y, n->index + k)) * GY(n, k);
        }
        for (size_t k = walls; k < end; k += SPH2D__LANES) {
            sph2d__lanes wx = {0}, wy = {0};
            if (share != 0) {
                wx = share * sph2d__lanes_gather_late(w->vx, n->index + k);
                wy = share * sph2d__lanes_gather_late(w->vy, n->index + k);
            }
            sx += (ux - wx) * GX(n, k);
            sy += (uy - wy) * GY(n, k);
        }
        sph2d__lanes_store(out + i, sx + sy);
    }
}

static void collect_walls(sph2d__system *s, double share, double *out, size_t first, size_t last)
{
    const sph2d__neighbours *n = &s->wall_neighbours;
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    FOR_SLICES(first, last, b)
    {
        const sph2d__slice *at = &n->slices[b / SPH2D__LANES];
        size_t end = at->begin + (size_t)at->fluid * SPH2D__LANES;
        sph2d__lanes ux = share * sph2d__lanes_load(w->vx + b), uy = share * sph2d__lanes_load(w->vy + b), sum = {0};
        for (size_t k = at->begin; k < end; k += SPH2D__LANES)
            sum += (ux - sph2d__lanes_gather_late(f->push_x, n->index + k)) * GX(n, k) +
                   (uy - sph2d__lanes_gather_late(f->push_y, n->index + k)) * GY(n, k);
        sph2d__lanes_store(out + b, sum);
    }
}

/* ---- prediction -------------------------------------------------------------------------------------------------- */

/** f(q) for particles that will be at (x, y), and at (jx, jy). */
SPH2D__INLINE sph2d__lanes value_at(const sph2d__system *s, sph2d__lanes x, sph2d__lanes y, sph2d__lanes jx,
                                    sph2d__lanes jy, sph2d_kernel kernel)
{
    const sph2d__period *period = &s->fluid_cells.period;
    sph2d__lanes dx = sph2d__shortest(x - jx, period->length_x), dy = sph2d__shortest(y - jy, period->length_y);
    return sph2d__kernel_value(kernel, sph2d__lanes_sqrt(dx * dx + dy * dy) * (1 / s->support));
}

/** f(q) summed over the fluid's pairs from `first` to `end`. */
SPH2D__INLINE sph2d__lanes values(const sph2d__system *s, const sph2d__neighbours *n, size_t first, size_t end,
                                  sph2d__lanes x, sph2d__lanes y, sph2d_kernel kernel)
{
    const sph2d__store *f = &s->fluid;
    sph2d__lanes sum = {0};
    for (size_t k = first; k < end; k += SPH2D__LANES)
        sum += value_at(s, x, y, sph2d__lanes_gather(f->next_x, n->index + k),
                        sph2d__lanes_gather(f->next_y, n->index + k), kernel);
    return sum;
}

/** The same over boundary particles, with their masses. */
SPH2D__INLINE sph2d__lanes wall_values(const sph2d__system *s, const sph2d__neighbours *n, size_t first, size_t end,
                                       sph2d__lanes x, sph2d__lanes y, sph2d_kernel kernel)
{
    const sph2d__store *w = &s->walls;
    sph2d__lanes sum = {0};
    for (size_t k = first; k < end; k += SPH2D__LANES) {
        const uint32_t *b = n->index + k;
        sph2d__lanes jx = sph2d__lanes_gather(w->x, b) + s->step * sph2d__lanes_gather(w->vx, b);
        sph2d__lanes jy = sph2d__lanes_gather(w->y, b) + s->step * sph2d__lanes_gather(w->vy, b);
        sum += sph2d__lanes_gather(w->mass, b) * value_at(s, x, y, jx, jy, kernel);
    }
    return sum;
}

/** Factor that makes a density over rest density of masses times f(q). */
static double scale_of(const sph2d__system *s, sph2d_kernel kernel)
{
    return s->calibration * sph2d__kernel_constant(kernel) / (s->support * s->support * s->rest_density);
}

SPH2D__INLINE void predict_fluid(sph2d__system *s, size_t first, size_t last, sph2d_kernel kernel)
{
    const sph2d__neighbours *n = &s->neighbours;
    sph2d__store *f = &s->fluid;
    double middle = sph2d__kernel_value_at(kernel, 0), scale = scale_of(s, kernel);
    FOR_SLICES(first, last, i)
    {
        const sph2d__slice *at = &n->slices[i / SPH2D__LANES];
        size_t walls = at->begin + (size_t)at->fluid * SPH2D__LANES, end = walls + (size_t)at->walls * SPH2D__LANES;
        sph2d__lanes x = sph2d__lanes_load(f->next_x + i), y = sph2d__lanes_load(f->next_y + i);
        sph2d__lanes sum = s->mass * (middle + values(s, n, at->begin, walls, x, y, kernel));
        sum += wall_values(s, n, walls, end, x, y, kernel);
        sph2d__lanes_store(f->residual + i, scale * sum - 1);
    }
}

SPH2D__INLINE void predict_walls(sph2d__system *s, size_t first, size_t last, sph2d_kernel kernel)
{
    const sph2d__neighbours *n = &s->wall_neighbours;
    sph2d__store *w = &s->walls;
    double scale = scale_of(s, kernel);
    FOR_SLICES(first, last, b)
    {
        const sph2d__slice *at = &n->slices[b / SPH2D__LANES];
        sph2d__lanes x = sph2d__lanes_load(w->x + b) + s->step * sph2d__lanes_load(w->vx + b);
        sph2d__lanes y = sph2d__lanes_load(w->y + b) + s->step * sph2d__lanes_load(w->vy + b);
        size_t end = at->begin + (size_t)at->fluid * SPH2D__LANES;
        sph2d__lanes added = scale * s->mass * values(s, n, at->begin, end, x, y, kernel);
        sph2d__lanes left = sph2d__lanes_load(w->mass + b) / s->mass * (added - sph2d__lanes_load(w->filled + b));
        const sph2d__lanes none = {0};
        sph2d__lanes_store(w->residual + b, sph2d__lanes_where(sph2d__lanes_load(w->diagonal + b), none, left));
    }
}

/* ---- one for every kernel ---------------------------------------------------------------------------------------- */

#define FOR_KERNEL(name, kernel)                                                                                       \
    static void fluid_##name(sph2d__system *s, size_t first, size_t last)                                              \
    {                                                                                                                  \
        predict_fluid(s, first, last, kernel);                                                                         \
    }                                                                                                                  \
    static void walls_##name(sph2d__system *s, size_t first, size_t last)                                              \
    {                                                                                                                  \
        predict_walls(s, first, last, kernel);                                                                         \
    }
FOR_KERNEL(c2, SPH2D_KERNEL_WENDLAND_C2)
FOR_KERNEL(c4, SPH2D_KERNEL_WENDLAND_C4)
FOR_KERNEL(c6, SPH2D_KERNEL_WENDLAND_C6)
FOR_KERNEL(cubic, SPH2D_KERNEL_CUBIC)
FOR_KERNEL(quintic, SPH2D_KERNEL_QUINTIC)

#define NAME_(isa) sph2d__projection_passes_##isa
#define NAME(isa) NAME_(isa)
const sph2d__projection_passes NAME(SPH2D__ISA) = {spread,
                                                   collect_fluid,
                                                   collect_walls,
                                                   {fluid_c2, fluid_c4, fluid_c6, fluid_cubic, fluid_quintic},
                                                   {walls_c2, walls_c4, walls_c6, walls_cubic, walls_quintic}};
