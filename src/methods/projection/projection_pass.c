/* SPDX-License-Identifier: MIT */
/** @file projection_pass.c
 *  The sums of projection.h over the neighbours that were gathered. Compiled once for each instruction set, named by
 *  SPH2D__ISA, and prediction in it once for each kernel. Every lane is a particle. */
#include "methods/projection/projection_pair.h"

/** Runs the statement behind it for each slice of particles `first` to `end` - 1, its first particle being `i`. */
#define FOR_SLICES(first, end, i) for (size_t i = (first); i < (end); i += SPH2D__LANES)

/** Where the pairs of a slice with fluid and with boundary particles end. */
typedef struct ends {
    size_t begin, fluid, walls;
} ends;

SPH2D__INLINE ends ends_of(const sph2d__neighbours *n, size_t first)
{
    const sph2d__slice *at = &n->slices[first / SPH2D__LANES];
    size_t fluid = at->begin + (size_t)at->fluid * SPH2D__LANES;
    return (ends){at->begin, fluid, fluid + (size_t)at->walls * SPH2D__LANES};
}

/* ---- spreading --------------------------------------------------------------------------------------------------- */

/** D' over the pairs from `first` to `end`, in floats as good as the gradients; `y` is of the other particles. */
SPH2D__INLINE sph2d__float2 transpose_over(const sph2d__neighbours *n, size_t first, size_t end, sph2d__float2 own,
                                           const double *y, sph2d__float2 sum)
{
    for (size_t k = first; k < end; k += SPH2D__LANES)
        sum += transpose_pair(own, sph2d__float2_gather(y, n->index + k), sph2d__float2_load(n->gradient + k));
    return sum;
}

SPH2D__INLINE sph2d__float2 transpose_slice(const sph2d__system *s, size_t i)
{
    const double *y = s->fluid.direction;
    ends at = ends_of(&s->neighbours, i);
    sph2d__float2 own = sph2d__float2_load(y + i);
    sph2d__float2 sum = transpose_over(&s->neighbours, at.begin, at.fluid, own, y, (sph2d__float2){0});
    return transpose_over(&s->neighbours, at.fluid, at.walls, own, s->walls.direction, sum);
}

static void move(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    double dt = s->step;
    FOR_SLICES (first, last, i) {
        sph2d__float2 push = transpose_slice(s, i);
        sph2d__lanes x = sph2d__lanes_load(f->vx + i) + dt * sph2d__lanes_load(f->ax + i);
        sph2d__lanes up = sph2d__lanes_load(f->vy + i) + dt * sph2d__lanes_load(f->ay + i);
        sph2d__lanes_store(f->next_x + i, sph2d__lanes_load(f->x + i) + (dt * x - sph2d__float2_x(push)));
        sph2d__lanes_store(f->next_y + i, sph2d__lanes_load(f->y + i) + (dt * up - sph2d__float2_y(push)));
    }
}

/** Takes `share` of D' multiplier off the acceleration. Summed in doubles: forces between two particles are opposite,
 *  and what momentum the sums lose stays as small as their rounding. */
static void press(sph2d__system *s, double share, size_t first, size_t last)
{
    const sph2d__neighbours *n = &s->neighbours;
    sph2d__store *f = &s->fluid;
    const double *walls = s->walls.multiplier;
    FOR_SLICES (first, last, i) {
        ends at = ends_of(n, i);
        sph2d__lanes own = sph2d__lanes_load(f->multiplier + i), px = {0}, py = {0};
        for (size_t k = at.begin; k < at.walls; k += SPH2D__LANES) {
            sph2d__lanes both = own + sph2d__lanes_gather_late(k < at.fluid ? f->multiplier : walls, n->index + k);
            sph2d__float2 g = sph2d__float2_load(n->gradient + k);
            px += both * sph2d__float2_x(g);
            py += both * sph2d__float2_y(g);
        }
        sph2d__lanes_store(f->ax + i, sph2d__lanes_load(f->ax + i) - share * px);
        sph2d__lanes_store(f->ay + i, sph2d__lanes_load(f->ay + i) - share * py);
    }
}

/* ---- reported pressure ------------------------------------------------------------------------------------------- */

static void average(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__period *period = &s->fluid_cells.period;
    const sph2d__store *w = &s->walls;
    sph2d__store *f = &s->fluid;
    const double unit = 1 / s->support, first_layer = 0.75 * s->spacing;
    FOR_SLICES (first, last, i) {
        ends at = ends_of(n, i);
        mean_sums sum = {0};
        sph2d__lanes x = sph2d__lanes_load(f->x + i), y = sph2d__lanes_load(f->y + i);
        sph2d__lanes p = sph2d__lanes_load(f->acting_pressure + i);
        for (size_t k = at.begin; k < at.fluid; k += SPH2D__LANES) {
            const uint32_t *j = n->index + k;
            sph2d__lanes dx = sph2d__shortest(sph2d__lanes_gather(f->x, j) - x, period->length_x) * unit;
            sph2d__lanes dy = sph2d__shortest(sph2d__lanes_gather(f->y, j) - y, period->length_y) * unit;
            mean_pair(&sum, dx, dy, sph2d__lanes_gather(f->acting_pressure, j) - p);
        }
        for (size_t k = at.fluid; k < at.walls; k += SPH2D__LANES) {
            const uint32_t *b = n->index + k;
            sph2d__lanes dx = sph2d__shortest(sph2d__lanes_gather(w->x, b) - x, period->length_x) * unit;
            sph2d__lanes dy = sph2d__shortest(sph2d__lanes_gather(w->y, b) - y, period->length_y) * unit;
            sph2d__lanes pb = sph2d__lanes_gather(w->acting_pressure, b), none = {0};
            /* Too far away: the dry, and those behind the first layer, which carry what is left. */
            dx += sph2d__lanes_below(pb, 1e-300, none + 2, none);
            dx += sph2d__lanes_below(sph2d__lanes_gather(w->depth, b), first_layer, none, none + 2);
            mean_pair(&sum, dx, dy, pb - p);
        }
        for (int l = 0; l < SPH2D__LANES && i + (size_t)l < f->count; ++l)
            f->pressure[i + (size_t)l] = fmax(p[l] + finish_mean(&sum, l), 0);
    }
}

/* ---- prediction -------------------------------------------------------------------------------------------------- */

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
    sph2d__lanes sum = {0};
    for (size_t k = first; k < end; k += SPH2D__LANES)
        sum += wall_value_at(s, x, y, n->index + k, kernel);
    return sum;
}

SPH2D__INLINE void predict_fluid(sph2d__system *s, size_t first, size_t last, sph2d_kernel kernel)
{
    const sph2d__neighbours *n = &s->neighbours;
    sph2d__store *f = &s->fluid;
    double middle = sph2d__kernel_value_at(kernel, 0), scale = density_scale(s, kernel);
    FOR_SLICES (first, last, i) {
        ends at = ends_of(n, i);
        sph2d__lanes x = sph2d__lanes_load(f->next_x + i), y = sph2d__lanes_load(f->next_y + i);
        sph2d__lanes sum = s->mass * (middle + values(s, n, at.begin, at.fluid, x, y, kernel));
        sum += wall_values(s, n, at.fluid, at.walls, x, y, kernel);
        sph2d__lanes_store(f->residual + i, scale * sum - 1);
    }
}

SPH2D__INLINE void predict_walls(sph2d__system *s, size_t first, size_t last, sph2d_kernel kernel)
{
    const sph2d__neighbours *n = &s->wall_neighbours;
    sph2d__store *w = &s->walls;
    double scale = density_scale(s, kernel);
    FOR_SLICES (first, last, b) {
        ends at = ends_of(n, b);
        sph2d__lanes x = sph2d__lanes_load(w->x + b) + s->step * sph2d__lanes_load(w->vx + b);
        sph2d__lanes y = sph2d__lanes_load(w->y + b) + s->step * sph2d__lanes_load(w->vy + b);
        sph2d__lanes added = scale * s->mass * values(s, n, at.begin, at.fluid, x, y, kernel);
        sph2d__lanes left = sph2d__lanes_load(w->mass + b) / s->mass * (added - sph2d__lanes_load(w->filled + b));
        const sph2d__lanes none = {0};
        sph2d__lanes_store(w->residual + b, sph2d__lanes_where(sph2d__lanes_load(w->diagonal + b), none, left));
    }
}

/* ---- one for every kernel ---------------------------------------------------------------------------------------- */

#define FOR_KERNEL(name, word)                                                                                         \
    static void fluid_##word(sph2d__system *s, size_t first, size_t last)                                              \
    {                                                                                                                  \
        predict_fluid(s, first, last, SPH2D_KERNEL_##name);                                                            \
    }                                                                                                                  \
    static void walls_##word(sph2d__system *s, size_t first, size_t last)                                              \
    {                                                                                                                  \
        predict_walls(s, first, last, SPH2D_KERNEL_##name);                                                            \
    }
SPH2D_KERNEL_MAP(FOR_KERNEL)

#define FLUID_ENTRY(name, word) [SPH2D_KERNEL_##name] = fluid_##word,
#define WALLS_ENTRY(name, word) [SPH2D_KERNEL_##name] = walls_##word,
const sph2d__projection_passes SPH2D__OF_ISA(sph2d__projection_passes) = {
    .move = move,
    .press = press,
    .average = average,
    .predict_fluid = {SPH2D_KERNEL_MAP(FLUID_ENTRY)},
    .predict_walls = {SPH2D_KERNEL_MAP(WALLS_ENTRY)}};
