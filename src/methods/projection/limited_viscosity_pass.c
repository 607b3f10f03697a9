/* SPDX-License-Identifier: MIT */
/** @file limited_viscosity_pass.c
 *  The loop of limited_viscosity.h over the neighbours that were gathered. Compiled once for each instruction set, named
 *  by SPH2D__ISA. Every lane is a particle. */
#include "methods/common/shortest.h"
#include "methods/projection/limited_viscosity_pair.h"

/** Of the particles `first` on. */
SPH2D__INLINE motion motion_at(const sph2d__store *f, size_t first, double rate)
{
    return motion_of(sph2d__lanes_load(f->vx + first), sph2d__lanes_load(f->vy + first),
                     sph2d__lanes_load(f->stretch + first), sph2d__lanes_load(f->shear + first),
                     rate * sph2d__lanes_load(f->density_rate + first));
}

/** Of the neighbours at `j`. */
SPH2D__INLINE motion motion_of_neighbours(const sph2d__store *f, const uint32_t *j, double rate)
{
    return motion_of(sph2d__lanes_gather(f->vx, j), sph2d__lanes_gather(f->vy, j), sph2d__lanes_gather(f->stretch, j),
                     sph2d__lanes_gather(f->shear, j), rate * sph2d__lanes_gather(f->density_rate, j));
}

SPH2D__INLINE void accelerate_slice(sph2d__system *s, double share, size_t first)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__period *period = &s->fluid_cells.period;
    const sph2d__slice *at = &n->slices[first / SPH2D__LANES];
    const double rate = -0.5 / s->rest_density; /* half the divergence */
    sph2d__store *f = &s->fluid;
    sph2d__lanes x = sph2d__lanes_load(f->x + first), y = sph2d__lanes_load(f->y + first);
    sph2d__lanes ax = {0}, ay = {0};
    motion own = motion_at(f, first, rate);
    size_t k = at->begin, end = k + (size_t)at->fluid * SPH2D__LANES;
    for (; k < end; k += SPH2D__LANES) {
        const uint32_t *j = n->index + k;
        sph2d__lanes dx = sph2d__shortest(x - sph2d__lanes_gather(f->x, j), period->length_x);
        sph2d__lanes dy = sph2d__shortest(y - sph2d__lanes_gather(f->y, j), period->length_y);
        sph2d__float2 g = sph2d__float2_load(n->gradient + k);
        motion other = motion_of_neighbours(f, j, rate);
        sph2d__lanes w = share * limited_pair(&own, &other, dx, dy);
        ax += w * sph2d__float2_x(g);
        ay += w * sph2d__float2_y(g);
    }
    sph2d__lanes_store(f->next_x + first, ax);
    sph2d__lanes_store(f->next_y + first, ay);
}

static void accelerate(sph2d__system *s, double nu, size_t first, size_t last)
{
    for (size_t i = first; i < last; i += SPH2D__LANES)
        accelerate_slice(s, 8 * nu, i);
}

const sph2d__limited_viscosity_pass SPH2D__OF_ISA(sph2d__limited_viscosity_pass) = {.accelerate = accelerate};
