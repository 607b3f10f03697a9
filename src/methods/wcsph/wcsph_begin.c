/* SPDX-License-Identifier: MIT */
/** @file wcsph_begin.c
 *  What acoustic steps, and the solve in their place, begin with: motion, energy that is stored, external forces. */
#include <math.h>
#include <string.h>

#include "methods/wcsph/wcsph.h"
#include "methods/wcsph/wcsph_spans.h"

void sph2d__frozen_start_motion(sph2d__system *s, size_t i)
{
    start_motion(s, i);
}

void sph2d__frozen_begin(sph2d__system *s)
{
    sph2d__over_particles(s, s->fluid.count, start_some, "begin_pass");
}

SPH2D__SLAB_WORK(store_slab, store_one(s, i, sum))

void sph2d__frozen_store_later(sph2d__system *s, sph2d__slab_sum *to)
{
    sph2d__over_fluid_later(s, store_slab, NULL, "store_pass", 0, to);
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
