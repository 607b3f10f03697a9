/* SPDX-License-Identifier: MIT */
/** @file hybrid_spans.h
 *  What a step of method `hybrid` does to particles one by one, and their packed copies, in C and in OpenCL C. */
#ifndef SPH2D_METHODS_HYBRID_HYBRID_SPANS_H
#define SPH2D_METHODS_HYBRID_HYBRID_SPANS_H

#include "methods/common/system.h"
#include "scene/apart.h"

/** One of the two arrays of floats in the space of an array of doubles. */
static inline SPH2D__ARRAY float *sph2d__floats(const sph2d__store *store, SPH2D__ARRAY double *array, int which)
{
    SPH2D__ARRAY void *floats = array; /* it never holds anything else */
    return floats ? (SPH2D__ARRAY float *)floats + (size_t)which * store->capacity : NULL;
}

/** How far the place of a particle is moved, over its bound; `shift`: along another axis. */
static inline double sph2d__hybrid_jitter(uint64_t id, unsigned shift)
{
    const uint64_t mixed = (id + 1) * UINT64_C(0x9E3779B97F4A7C15) >> shift & 1023;
    return (double)mixed / 512 - 1;
}

static inline void pack_places(const sph2d__store *t, const sph2d__cells *cells, double apart, size_t first,
                               size_t last)
{
    SPH2D__ARRAY float *x = sph2d__floats(t, t->packed_place, 0), *y = sph2d__floats(t, t->packed_place, 1);
    for (size_t i = first; i < last; ++i) {
        const uint32_t cell = cells->cell[cells->order[i]], row = cell / cells->nx;
        x[i] = (float)(t->x[i] + apart * sph2d__hybrid_jitter(t->id[i], 20) -
                       sph2d__tile_x(cells, cell - row * cells->nx));
        y[i] = (float)(t->y[i] + apart * sph2d__hybrid_jitter(t->id[i], 40) - sph2d__tile_y(cells, row));
    }
}

static inline void pack_fluid(sph2d__system *s, size_t first, size_t last)
{
    pack_places(&s->fluid, &s->fluid_cells, SPH2D__APART * s->spacing, first, last);
}

static inline void pack_walls(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__store *w = &s->walls;
    SPH2D__ARRAY float *weight = sph2d__floats(w, w->packed_state, 0);
    pack_places(w, &s->wall_cells, 0, first, last);
    for (size_t b = first; b < last; ++b)
        weight[b] = (float)(w->mass[b] / s->mass);
}

static inline void accelerate(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    const sph2d__forces forces = s->forces; /* a copy, so that what it lacks is looked at once */
    for (size_t i = first; i < last; ++i) {
        double ax = 0, ay = 0;
        sph2d__forces_add(&forces, (sph2d__place){f->x[i], f->y[i], f->vx[i], f->vy[i]}, &ax, &ay);
        f->ax[i] = ax;
        f->ay[i] = ay;
    }
}

static inline void kick(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__store *f = &s->fluid;
    for (size_t i = first; i < last; ++i) {
        f->vx[i] += s->step * f->ax[i];
        f->vy[i] += s->step * f->ay[i];
    }
}

#endif
