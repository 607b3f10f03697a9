/* SPDX-License-Identifier: MIT */
/** @file wcsph_spans.h
 *  What a step of method `wcsph` does to particles one by one, besides its sweeps, in C and in OpenCL C. */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_SPANS_H
#define SPH2D_METHODS_WCSPH_WCSPH_SPANS_H

#include "methods/wcsph/wcsph_mirror.h"
#include "sim/displaced.h"

/** Puts the particles where they will be in the middle of the step; next_x and next_y keep where they were. */
SPH2D__INLINE void go_to_middle(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    const sph2d__period *p = &s->fluid_cells.period;
    for (size_t i = first; i < last; ++i) {
        f->next_x[i] = f->x[i];
        f->next_y[i] = f->y[i];
        f->x[i] = sph2d__period_wrap(f->x[i] + s->step / 2 * f->vx[i], p->low_x, p->length_x);
        f->y[i] = sph2d__period_wrap(f->y[i] + s->step / 2 * f->vy[i], p->low_y, p->length_y);
    }
}

SPH2D__INLINE void go_back(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    for (size_t i = first; i < last; ++i) {
        f->x[i] = f->next_x[i];
        f->y[i] = f->next_y[i];
    }
}

/** What sides store of a particle more where shifting takes it [J/kg]. */
SPH2D__INLINE double stored_by_shift(const sph2d__system *s, size_t i)
{
    const sph2d__frozen *z = s->frozen;
    return side_energy(s, z->px[i] + z->shift_x[i], z->py[i] + z->shift_y[i]) - side_energy(s, z->px[i], z->py[i]);
}

/** By how much shifting lifts a particle [J/kg]. */
SPH2D__INLINE double lifted(const sph2d__system *s, size_t i)
{
    const sph2d__frozen *z = s->frozen;
    return sph2d__forces_potential(&s->forces, z->px[i] + z->shift_x[i], z->py[i] + z->shift_y[i]) -
           sph2d__forces_potential(&s->forces, z->px[i], z->py[i]);
}

/** What a particle's theta changes by, in a part of its way to the sum. */
SPH2D__INLINE double relaxed(const sph2d__system *s, size_t i, double part)
{
    return part * s->frozen->summed[i] / sph2d__density_ratio(s->fluid.log_density[i]);
}

/** What is read from outside. */
SPH2D__INLINE void report(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__store *f = &s->fluid;
    const double c2 = s->sound_speed * s->sound_speed;
    for (size_t i = first; i < last; ++i) {
        f->density[i] = s->rest_density * sph2d__density_ratio(f->log_density[i]);
        f->pressure[i] = f->density[i] * c2 * f->log_density[i];
    }
}

SPH2D__INLINE void start_motion(sph2d__system *s, size_t i)
{
    sph2d__frozen *z = s->frozen;
    const sph2d__store *f = &s->fluid;
    SPH2D__ARRAY float *row = z->velocity + 4 * i;
    row[0] = (float)f->vx[i];
    row[1] = (float)f->vy[i];
    row[2] = (float)(z->cxx[i] * f->vx[i] + z->cyx[i] * f->vy[i] + z->wall_zx[i]);
    row[3] = (float)(z->cxy[i] * f->vx[i] + z->cyy[i] * f->vy[i] + z->wall_zy[i]);
}

SPH2D__INLINE void start_some(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    sph2d__store *f = &s->fluid;
    for (size_t i = first; i < last; ++i) {
        start_motion(s, i);
        z->diffused[i] = 0;
        z->acts[i] = 1;
        z->px[i] = f->next_x[i];
        z->py[i] = f->next_y[i];
    }
}

/** Potential energy of a particle's part of the pairs that repel each other, and of what gravity lacks beside sides, where
 *  it is now [J/kg]. */
SPH2D__INLINE double stored_energy(const sph2d__system *s, size_t i)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__frozen *z = s->frozen;
    const sph2d__period *p = &s->fluid_cells.period;
    SPH2D__ARRAY const sph2d__slice *at = &n->slices[i / n->lanes];
    const double near = SPH2D__CLOSE * s->spacing, c2 = s->sound_speed * s->sound_speed;
    size_t k = at->begin + ((size_t)at->fluid + at->walls) * n->stride + i % n->lanes;
    double sum = 0;
    for (uint32_t slot = 0; slot < z->close[i / n->lanes]; ++slot, k += n->stride) {
        const double dx = sph2d__shortest_way(z->px[i] - z->px[n->index[k]], p->length_x);
        const double dy = sph2d__shortest_way(z->py[i] - z->py[n->index[k]], p->length_y);
        const double t = fmax(1 - sqrt(dx * dx + dy * dy) / near, 0);
        sum += t * t * t;
    }
    return z->repulsion * c2 * SPH2D__CLOSE / 6 * sum + side_energy(s, z->px[i], z->py[i]);
}

/** What sums read of neighbours. */
SPH2D__INLINE void keep_state(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__store *f = &s->fluid;
    for (size_t i = first; i < last; ++i) {
        SPH2D__ARRAY float *row = s->frozen->state + 4 * i;
        row[0] = (float)f->vx[i];
        row[1] = (float)f->vy[i];
        row[2] = (float)f->log_density[i];
        row[3] = 0;
    }
}

/* The largest g c0 dt of a particle. With g = (|B| + |C|) sum |G| + |S| no row of D has a larger sum than 2 g. On a lattice
 * its norm is 0.52 sum |G|, so that a leapfrog is stable up to g c0 dt = 3.8. */
SPH2D__FIXED double MOST_RATE = 2;

/** Bounds C of particle i, and Z m c0 H, by what an acoustic step bears. */
SPH2D__INLINE void bound(const sph2d__system *s, size_t i)
{
    sph2d__frozen *z = s->frozen;
    const double trace = z->bxx[i] + z->byy[i], det = z->bxx[i] * z->byy[i] - z->bxy[i] * z->bxy[i];
    const double largest = (trace + sqrt(fmax(trace * trace - 4 * det, 0))) / 2;
    const double turned2 =
        z->cxx[i] * z->cxx[i] + z->cxy[i] * z->cxy[i] + z->cyx[i] * z->cyx[i] + z->cyy[i] * z->cyy[i];
    const double straight = largest * z->weight[i] + sqrt(z->sx[i] * z->sx[i] + z->sy[i] * z->sy[i]),
                 turned = sqrt(turned2) * z->weight[i], most = MOST_RATE / (s->sound_speed * z->dt);
    const double part = straight + turned > most && turned > 0 ? fmax(most - straight, 0) / turned : 1;
    z->cxx[i] *= part;
    z->cxy[i] *= part;
    z->cyx[i] *= part;
    z->cyy[i] *= part;
    z->wall_zx[i] *= part;
    z->wall_zy[i] *= part;
    z->walled[i] *= part;
    /* The columns of D's transpose are as large where particles are alike: stable with Z c0 H (2 g)^2 dt = 2. Here it is 1. */
    const double g = straight + part * turned, diffusivity = SPH2D__DAMPING * s->sound_speed * s->support,
                 limit = 4 * g * g * z->dt;
    z->damping[i] = s->mass * (diffusivity * limit > 1 ? 1 / limit : diffusivity);
}

SPH2D__INLINE void bound_some(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i)
        bound(s, i);
}

/** The whole way of the step. */
SPH2D__INLINE sph2d__way whole_way(const sph2d__system *s, double dt, size_t i)
{
    const sph2d__store *f = &s->fluid;
    const sph2d__frozen *z = s->frozen;
    sph2d__way way = {
        z->px[i] - f->x[i] + z->shift_x[i], z->py[i] - f->y[i] + z->shift_y[i], {f->vx[i], f->vy[i]}, 0, 0};
    (void)dt;
    if (s->fills) {
        const double stored = stored_by_shift(s, i);
        way.diffused = -s->mass * (lifted(s, i) + stored);
        f->stored[i] += stored;
    }
    return way;
}

/* ---- sums -------------------------------------------------------------------------------------------------------- */

/** Adds theta^2/2 that relaxation in a part of its way adds. */
SPH2D__INLINE void add_relaxed(const sph2d__system *s, size_t i, const double *part, sph2d__slab_sum *sum)
{
    const double change = relaxed(s, i, *part);
    sum->first += change * (s->fluid.log_density[i] + change / 2);
}

/** The same, and relaxes. */
SPH2D__INLINE void relax_one(sph2d__system *s, size_t i, const double *part, sph2d__slab_sum *sum)
{
    add_relaxed(s, i, part, sum);
    s->fluid.log_density[i] += relaxed(s, i, *part);
}

SPH2D__INLINE void add_lifted(const sph2d__system *s, size_t i, sph2d__slab_sum *sum)
{
    sum->first += lifted(s, i) + stored_by_shift(s, i);
}

SPH2D__INLINE void shorten_one(sph2d__system *s, size_t i, const double *part)
{
    s->frozen->shift_x[i] *= *part;
    s->frozen->shift_y[i] *= *part;
}

/** Keeps the energy stored, and adds by how much it is other than before [J/kg]: in a step, or since the last one, when
 *  particles are new or gravity is another. */
SPH2D__INLINE void store_one(sph2d__system *s, size_t i, sph2d__slab_sum *sum)
{
    const double energy = stored_energy(s, i);
    sum->first += energy - s->fluid.stored[i];
    s->fluid.stored[i] = energy;
}

/** For how long rates act before diffusion, and after it [s]. */
typedef struct sweep_times {
    double before, after;
    bool rest; /* e is found, too */
} sweep_times;

#endif
