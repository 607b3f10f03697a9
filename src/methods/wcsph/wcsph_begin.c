/* SPDX-License-Identifier: MIT */
/** @file wcsph_begin.c
 *  What acoustic steps, and the solve in their place, begin with: motion, energy that is stored, external forces. */
#include <math.h>
#include <string.h>

#include "methods/wcsph/wcsph.h"

void sph2d__frozen_start_motion(sph2d__system *s, size_t i)
{
    sph2d__frozen *z = s->frozen;
    const sph2d__store *f = &s->fluid;
    const float row[4] = {(float)f->vx[i], (float)f->vy[i],
                          (float)(z->cxx[i] * f->vx[i] + z->cyx[i] * f->vy[i] + z->wall_zx[i]),
                          (float)(z->cxy[i] * f->vx[i] + z->cyy[i] * f->vy[i] + z->wall_zy[i])};
    memcpy(z->velocity + 4 * i, row, sizeof row);
}

static void start_some(sph2d__system *s, size_t first, size_t last)
{
    sph2d__frozen *z = s->frozen;
    sph2d__store *f = &s->fluid;
    for (size_t i = first; i < last; ++i) {
        sph2d__frozen_start_motion(s, i);
        z->diffused[i] = 0;
        z->acts[i] = 1;
        z->px[i] = f->next_x[i];
        z->py[i] = f->next_y[i];
    }
}

void sph2d__frozen_begin(sph2d__system *s)
{
    sph2d__over_particles(s, s->fluid.count, start_some, NULL);
}

/** Potential energy of a particle's part of the pairs that repel each other, and of what gravity lacks beside sides, where
 *  it is now [J/kg]. */
static double stored_energy(const sph2d__system *s, size_t i)
{
    const sph2d__neighbours *n = &s->neighbours;
    const sph2d__frozen *z = s->frozen;
    const sph2d__period *p = &s->fluid_cells.period;
    const sph2d__slice *at = &n->slices[i / n->lanes];
    const double near = SPH2D__CLOSE * s->spacing, c2 = s->sound_speed * s->sound_speed;
    size_t k = at->begin + ((size_t)at->fluid + at->walls) * n->lanes + i % n->lanes;
    double sum = 0;
    for (uint32_t slot = 0; slot < z->close[i / n->lanes]; ++slot, k += n->lanes) {
        const double dx = sph2d__shortest_way(z->px[i] - z->px[n->index[k]], p->length_x);
        const double dy = sph2d__shortest_way(z->py[i] - z->py[n->index[k]], p->length_y);
        const double t = fmax(1 - sqrt(dx * dx + dy * dy) / near, 0);
        sum += t * t * t;
    }
    return z->repulsion * c2 * SPH2D__CLOSE / 6 * sum + sph2d__side_energy(s, z->px[i], z->py[i]);
}

/** Keeps the energy stored, and sums up by how much it is other than before [J/kg]: in a step, or since the last one, when
 *  particles are new or gravity is another. */
static void store_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    for (size_t i = slab->first; i < slab->last; ++i) {
        const double energy = stored_energy(s, i);
        sum->first += energy - s->fluid.stored[i];
        s->fluid.stored[i] = energy;
    }
}

double sph2d__frozen_store(sph2d__system *s)
{
    return s->mass * sph2d__over_fluid(s, store_slab, NULL).first;
}

/* Before what acoustic steps add. */
void sph2d__frozen_start_external(sph2d__system *s)
{
    const sph2d__forces *forces = &s->forces;
    s->frozen->varies = sph2d__forces_vary(forces);
    s->frozen->driven = s->frozen->varies || sph2d__forces_drive_at_all(forces, SPH2D__WORK);
    const double mass = s->frozen->driven ? 0 : s->mass * (double)s->fluid.count;
    s->external = (sph2d_vec2){mass * forces->gravity.x, mass * forces->gravity.y};
}
