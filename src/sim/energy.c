/* SPDX-License-Identifier: MIT */
/** @file energy.c
 *  Energy that comes from nothing: what a run sums up of it, and the guard that stops one.
 *
 *  Liquid to which nobody gives energy can only lose some. What is watched is kinetic, potential and elastic energy less
 *  what particles brought and took: how far it ever rises above an earlier moment, over the energy scale of the scene,
 *
 *      m n (g h + U^2/2 + pull)/2,
 *
 *  the potential energy of a column as high as liquid can fall (sph2d__system.head), with n all particles that ever
 *  were. While something drives the liquid,
 *  a wall or obstacle that moves, an interaction, the pointer, gravity along a period, its work is not known and nothing is watched; nor is
 *  it with surface tension, whose energy jumps where the surface finds other neighbours. */
#include <math.h>

#include "sim/simulation.h"

/* The part of the scene's energy scale by which energy may rise: a hundred times what scenes do that are sound. */
static const double MOST = 0.1;

double sph2d__sim_energy_scale(const sph2d_sim *sim)
{
    const sph2d__system *s = &sim->system;
    const sph2d__record *r = &sim->record;
    uint64_t all = s->fluid.count + r->drained + r->left_left + r->left_right + r->left_bottom + r->left_top;
    return s->mass * (double)all * s->head / 2;
}

/* A particle's share of the scale has so many parts. */
static const double PARTS = 4e9;

double sph2d__sim_energy_part(const sph2d_sim *sim)
{
    const sph2d__system *s = &sim->system;
    return s->mass * (s->head > 0 ? s->head : 1) / PARTS;
}

sph2d_status sph2d__sim_watch_energy(sph2d_sim *sim)
{
    sph2d__record *r = &sim->record;
    sph2d__sim_book_walls(sim);
    if (!sph2d__sim_looks(sim, r->steps))
        return SPH2D_OK;
    if (sph2d__sim_book(sim) != SPH2D_OK)
        return SPH2D_NOMEM;
    sph2d_summary now;
    sph2d__sim_sum_energy(sim, &now);
    double energy = now.kinetic + now.potential + now.elastic - r->energy_fed - r->energy_walls - r->energy_forces;
    r->energy_low = fmin(r->energy_low, energy);
    r->energy_rise = fmax(r->energy_rise, energy - r->energy_low);
    r->energy_error = energy - r->energy_start + r->energy_viscous + r->energy_diffused + r->energy_stopped;
    r->error_low = fmin(r->error_low, r->energy_error);
    r->error_rise = fmax(r->error_rise, r->energy_error - r->error_low);
    return SPH2D_OK;
}

/** The particle that moves fastest. */
static size_t fastest_of(const sph2d__store *f)
{
    size_t fastest = 0;
    double most = -1;
    for (size_t i = 0; i < f->count; ++i) {
        double v2 = f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i];
        if (v2 > most) {
            most = v2;
            fastest = i;
        }
    }
    return fastest;
}

bool sph2d__sim_guard_energy(const sph2d_sim *sim, sph2d_report *report)
{
    const sph2d__record *r = &sim->record;
    const sph2d__store *f = &sim->system.fluid;
    double scale = sph2d__sim_energy_scale(sim);
    /* What compresses the start of the other methods is energy that no sum over their particles tells. */
    if (sim->scene.method.name != SPH2D_METHOD_WCSPH || !(scale > 0) || !(r->energy_rise > MOST * scale))
        return true;
    size_t i = fastest_of(f);
    sph2d_diagnostic *d = sph2d_report_add(
        report, SPH2D_ERROR, SPH2D_CODE_ENERGY, NULL,
        "energy came from nothing: %.3g J/m, %.3g %% of the scene's %.3g J/m, by step %llu, time %g s; the fastest "
        "particle %llu is at (%g, %g) with velocity (%g, %g)",
        r->energy_rise, 100 * r->energy_rise / scale, scale, (unsigned long long)r->steps, r->time,
        (unsigned long long)f->id[i], f->x[i], f->y[i], f->vx[i], f->vy[i]);
    sph2d_diagnostic_hint(d, "look at the walls there; method.artificial_viscosity: 0.05 or a smaller spacing calms liquid");
    return false;
}
