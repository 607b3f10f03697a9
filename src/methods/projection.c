/* SPDX-License-Identifier: MIT */
/** @file projection.c
 *  The pair loops of projection.h for the instruction set in use, and what comes before them. */
#include "methods/projection.h"

#include <math.h>

#include "base/threads.h"
#include "kernels/kernel.h"
#include "methods/tension.h"

static const sph2d__projection_passes *passes(sph2d_isa isa)
{
#ifdef SPH2D__ISA_X86
    if (isa == SPH2D_ISA_AVX512)
        return &sph2d__projection_passes_avx512;
    if (isa == SPH2D_ISA_AVX2)
        return &sph2d__projection_passes_avx2;
#else
    (void)isa;
#endif
    return &sph2d__projection_passes_baseline;
}

static const sph2d__projection_gather_pass *gathers(sph2d_isa isa)
{
#ifdef SPH2D__ISA_X86
    if (isa == SPH2D_ISA_AVX512)
        return &sph2d__projection_gather_avx512;
    if (isa == SPH2D_ISA_AVX2)
        return &sph2d__projection_gather_avx2;
#else
    (void)isa;
#endif
    return &sph2d__projection_gather_baseline;
}

/** Pairs of a particle in a filled lattice, half as many again for disorder, and walls. */
static size_t usual_pairs(const sph2d__system *s)
{
    double ratio = s->support / s->spacing;
    return (size_t)(1.5 * SPH2D__PI * ratio * ratio) + 8;
}

/** Puts the particle that shorter lists end with where no kernel reaches: behind the last one of a store. */
static void put_far(const sph2d__store *store, double *x, double *y)
{
    if (store->capacity > 0)
        x[store->count] = y[store->count] = 1e30;
}

/** Gathers all slabs of one store. False when one is full. */
static bool gather_store(sph2d__system *s, const sph2d__store *store, bool (*pass)(sph2d__system *, size_t))
{
    int threads = sph2d__threads_for(s->threads, store->count), full = 0;
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1) reduction(+ : full)
    for (size_t k = 0; k < sph2d__slabs(store->count); ++k)
        full += !pass(s, k);
    return full == 0;
}

static bool gather(sph2d__system *s)
{
    const sph2d__projection_gather_pass *pass = gathers(s->isa);
    put_far(&s->fluid, s->fluid.x, s->fluid.y);
    put_far(&s->walls, s->walls.x, s->walls.y);
    return gather_store(s, &s->fluid, pass->fluid[s->method.kernel]) &&
           (!s->walls_press || gather_store(s, &s->walls, pass->walls[s->method.kernel]));
}

bool sph2d__projection_gather(sph2d__system *s)
{
    size_t each = usual_pairs(s);
    for (;; each = 2 * s->neighbours.each) {
        if (!sph2d__neighbours_reserve(&s->neighbours, s->memory, s->fluid.count, each) ||
            (s->walls_press && !sph2d__neighbours_reserve(&s->wall_neighbours, s->memory, s->walls.count, each)))
            return false;
        if (gather(s))
            break;
    }
    sph2d__tension_add(s);
    return true;
}

/** Runs the statement behind it for each slab, shared among threads: particles `first` to `last` - 1. */
#define FOR_SHARED_SLABS(count, first, last)                                                                           \
    for (size_t first = 0; first < (count); first += SPH2D__SLAB)                                                      \
        for (size_t last = first + SPH2D__SLAB < (count) ? first + SPH2D__SLAB : (count), once_ = 1; once_; once_ = 0)

void sph2d__projection_spread(sph2d__system *s, sph2d__rows y)
{
    const sph2d__projection_passes *pass = passes(s->isa);
    int threads = sph2d__threads_for(s->threads, s->fluid.count);
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1)
    FOR_SHARED_SLABS(s->fluid.count, first, last)
    pass->spread(s, y, first, last);
}

void sph2d__projection_collect(sph2d__system *s, double share, sph2d__rows out)
{
    const sph2d__projection_passes *pass = passes(s->isa);
    int threads = sph2d__threads_for(s->threads, s->fluid.count);
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1)
    FOR_SHARED_SLABS(s->fluid.count, first, last)
    pass->collect_fluid(s, share, out.fluid, first, last);
    size_t walls = s->walls_press ? s->walls.count : 0;
    threads = sph2d__threads_for(s->threads, walls);
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1)
    FOR_SHARED_SLABS(walls, first, last)
    pass->collect_walls(s, share, out.walls, first, last);
}

void sph2d__projection_move(sph2d__system *s, sph2d__rows y)
{
    const sph2d__projection_passes *pass = passes(s->isa);
    const sph2d__store *f = &s->fluid;
    double dt = s->step;
    int threads = sph2d__threads_for(s->threads, f->count);
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1)
    FOR_SHARED_SLABS(f->count, first, last)
    {
        pass->spread(s, y, first, last);
        for (size_t i = first; i < last; ++i) { /* at once, while the slab is at hand */
            f->next_x[i] = f->x[i] + (dt * (f->vx[i] + dt * f->ax[i]) - f->push_x[i]);
            f->next_y[i] = f->y[i] + (dt * (f->vy[i] + dt * f->ay[i]) - f->push_y[i]);
        }
    }
}

void sph2d__projection_predict(sph2d__system *s)
{
    const sph2d__projection_passes *pass = passes(s->isa);
    const sph2d__store *f = &s->fluid;
    put_far(f, f->next_x, f->next_y);
    int threads = sph2d__threads_for(s->threads, f->count);
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1)
    FOR_SHARED_SLABS(f->count, first, last)
    pass->predict_fluid[s->method.kernel](s, first, last);
    size_t walls = s->walls_press ? s->walls.count : 0;
    threads = sph2d__threads_for(s->threads, walls);
#pragma omp parallel for schedule(dynamic) num_threads(threads) if (threads > 1)
    FOR_SHARED_SLABS(walls, first, last)
    pass->predict_walls[s->method.kernel](s, first, last);
}

static void scale_into(double *to, const double *from, double factor, size_t count, int limit)
{
    int threads = sph2d__threads_for(limit, count);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (size_t i = 0; i < count; ++i)
        to[i] = from[i] > 0 ? factor * from[i] : 0;
}

void sph2d__projection_begin(sph2d__system *s)
{
    double factor = s->step * s->step / (s->rest_density * s->moment);
    scale_into(s->fluid.multiplier, s->fluid.pressure, factor, s->fluid.count, s->threads);
    scale_into(s->walls.multiplier, s->walls.pressure, factor, s->walls.count, s->threads);
}

void sph2d__projection_end(sph2d__system *s)
{
    sph2d__store *f = &s->fluid, *w = &s->walls;
    double share = 1 / (s->step * s->step), factor = s->moment * s->rest_density * share;
    scale_into(f->multiplier, f->multiplier, 1, f->count, s->threads);
    scale_into(w->multiplier, w->multiplier, 1, w->count, s->threads);
    scale_into(f->pressure, f->multiplier, factor, f->count, s->threads);
    scale_into(w->pressure, w->multiplier, factor, w->count, s->threads);
    sph2d__projection_spread(s, (sph2d__rows){f->multiplier, w->multiplier});
    int threads = sph2d__threads_for(s->threads, f->count);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (size_t i = 0; i < f->count; ++i) {
        f->ax[i] -= share * f->push_x[i];
        f->ay[i] -= share * f->push_y[i];
    }
}

double sph2d__projection_step(const sph2d__system *s, double speed, double acceleration, double viscous, double force,
                              sph2d__limit *limit)
{
    double push = sqrt(s->hardest / s->rest_density);
    return sph2d__shortest_step(s, 0, push > speed ? push : speed, acceleration, s->viscosity / s->rest_density,
                                viscous, force, limit);
}

/** f(q) of the kernel summed over a filled square lattice, the particle in the middle included. */
static double lattice_sum(const sph2d__system *s)
{
    int reach = (int)(s->support / s->spacing) + 1;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j)
            sum += sph2d__kernel_value_at(s->method.kernel, hypot(i, j) * s->spacing / s->support);
    return sum;
}

/** k = -sum_j x_ij . G_ij / 2 of a filled square lattice. */
static double lattice_moment(const sph2d__system *s)
{
    int reach = (int)(s->support / s->spacing) + 1;
    double sum = 0, ratio = s->spacing / s->support;
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j) {
            double q = hypot(i, j) * ratio;
            sum -= q * q * sph2d__kernel_slope_at(s->method.kernel, q);
        }
    return s->calibration * sph2d__kernel_constant(s->method.kernel) * ratio * ratio * sum / 2;
}

/** m_b = rho0 / (c sum_b' W(r_bb')) where the wall is one row of boundary particles (Akinci et al. 2012, eq. 4); those
 *  of layers have their mass by their area. */
static void weigh_rows(sph2d__system *s, double lattice)
{
    sph2d__store *w = &s->walls;
    for (size_t b = 0; b < w->count; ++b) {
        if (w->bounce[b] >= 0 || w->mass[b] > 0)
            continue;
        sph2d__ranges ranges = sph2d__cells_ranges(&s->wall_cells, sph2d__cells_find(&s->wall_cells, w->x[b], w->y[b]));
        double sum = 0;
        SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
            double dx = w->x[b] + ranges.x[r] - w->x[j], dy = w->y[b] + ranges.y[r] - w->y[j];
            if (w->bounce[j] < 0)
                sum += sph2d__kernel_value_at(s->method.kernel, hypot(dx, dy) / s->support);
        }
        w->mass[b] = s->mass * lattice / sum;
    }
}

/** What a lattice in front of a straight wall adds to the density at a boundary particle, over rest density. */
static double filled_at(const sph2d__system *s, double depth)
{
    int reach = (int)(s->support / s->spacing) + 1;
    double sum = 0, dx = s->spacing;
    for (int row = 0; row <= reach; ++row)
        for (int column = -reach; column <= reach; ++column)
            sum += sph2d__kernel_value_at(s->method.kernel, hypot(column * dx, depth + (row + 0.5) * dx) / s->support);
    double ratio = dx / s->support;
    return s->calibration * sph2d__kernel_constant(s->method.kernel) * ratio * ratio * sum;
}

/** Boundary particles of layers have rows, but in corners, where the surface is not straight. Those of the domain's
 * sides know the room around them, those of obstacles take their surface for straight. */
static void fill_layers(sph2d__system *s)
{
    sph2d__store *w = &s->walls;
    double scale = s->calibration * sph2d__kernel_constant(s->method.kernel);
    for (size_t b = 0; b < w->count; ++b) {
        bool straight = w->bounce[b] < 0 && w->depth[b] > 0 && w->depth[b] < INFINITY;
        double room = w->filled[b];
        w->filled[b] = !straight ? 0 : room > 0 ? scale * room : filled_at(s, w->depth[b]);
    }
}

void sph2d__projection_prepare(sph2d__system *s)
{
    double lattice = lattice_sum(s), ratio = s->support / s->spacing;
    s->calibration = ratio * ratio / (lattice * sph2d__kernel_constant(s->method.kernel));
    s->moment = lattice_moment(s);
    weigh_rows(s, lattice);
    fill_layers(s);
}
