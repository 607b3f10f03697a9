/* SPDX-License-Identifier: MIT */
/** @file absorb.c
 *  Absorbing ends: the velocity of liquid near a side decays at a rate sigma(s), exactly over a step,
 *
 *      v := v exp(-sigma dt),   sigma = rate s^2,   s from 0 at the inner end to 1 at the side and beyond it,
 *
 *  as in the sponge layers of Israeli & Orszag (J. Comput. Phys. 41, 1981). A wave has half of its energy in velocities
 *  and so decays at sigma/2; on its way to the side and back its height becomes exp(-rate length/(3 cg)) of what it was,
 *  cg its group velocity. A layer that is short for the wave, or a large rate, reflects by itself.
 *
 *  What a side with an opening lets through goes on: only velocities along it decay, as far as its line, and a wave at
 *  half the speed. So the default rate is twice as large there: 16 % of a wave came back from 1.3 wavelengths, now 5 %. */
#include <math.h>

#include "base/elementary.h"
#include "methods/common/on_device.h"
#include "run/run.h"
#include "scene/openings.h"

/* Rate at the side over sqrt(g/length), where both components decay. */
static const double DEFAULT_RATE = 3;

typedef struct layer {
    bool across;           /**< at the left or right side */
    bool both;             /**< damps both components, and particles beyond the side */
    double from, to, rate; /**< the inner end, the side [m]; 1/s */
} layer;

static layer layer_of(const sph2d__world *world, const sph2d_absorber *a)
{
    const sph2d_scene *scene = &world->scene;
    bool low = a->side == SPH2D_SIDE_NAME_LEFT || a->side == SPH2D_SIDE_NAME_BOTTOM;
    layer l = {.across = sph2d__side_is_vertical((int)a->side), .both = !sph2d__side_has_opening(scene, (int)a->side)};
    sph2d_vec2 end = low ? scene->domain.min : scene->domain.max;
    l.to = l.across ? end.x : end.y;
    l.from = low ? l.to + a->length : l.to - a->length;
    l.rate = a->rate > 0 ? a->rate : (l.both ? 1 : 2) * DEFAULT_RATE * sqrt(world->gravity.size / a->length);
    return l;
}

/** Damps the particles of one layer; returns the kinetic energy taken, over the mass of a particle. */
static double damp(const layer *l, sph2d__store *f, double dt)
{
    double taken = 0, width = l->to - l->from;
    const double *place = l->across ? f->x : f->y;
    for (size_t i = 0; i < f->count; ++i) {
        double s = (place[i] - l->from) / width;
        if (!(s > 0) || (s > 1 && !l->both))
            continue;
        s = fmin(s, 1);
        double keep = sph2d__exp(-l->rate * s * s * dt), v2 = f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i];
        if (l->both || !l->across)
            f->vx[i] *= keep;
        if (l->both || l->across)
            f->vy[i] *= keep;
        taken += (v2 - f->vx[i] * f->vx[i] - f->vy[i] * f->vy[i]) / 2;
    }
    return taken;
}

void sph2d__sim_absorb(sph2d_sim *sim, double dt)
{
    const sph2d_scene *scene = &sim->world.scene;
    const sph2d__set damped = SPH2D__BIT(vx) | SPH2D__BIT(vy);
    if (scene->absorber_count > 0)
        sph2d__host_reads(&sim->system, damped | SPH2D__BIT(x) | SPH2D__BIT(y));
    for (size_t k = 0; k < scene->absorber_count; ++k) {
        const layer l = layer_of(&sim->world, &scene->absorbers[k]);
        sim->record.energy_forces -= sim->system.mass * damp(&l, &sim->system.fluid, dt);
    }
    if (scene->absorber_count > 0)
        sph2d__host_changed(&sim->system, damped);
}
