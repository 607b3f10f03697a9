/* SPDX-License-Identifier: MIT */
/** @file openings_feed.c
 *  Particles that come and go at the ends of reservoirs. */
#include <math.h>

#include "sim/openings_parts.h"
#include "sim/simulation.h"

/** Whether liquid that flows in through a lane comes from somewhere: with a pressure, it may have flowed out before. */
static bool is_fed(const sph2d__opening *o, size_t k)
{
    return k < o->fed_lanes && (o->kind != SPH2D__OPENING_PRESSURE || o->lanes[k].wet);
}

/** Adds a particle. False when memory is short. */
static bool add_at(sph2d_sim *sim, const sph2d__opening *o, sph2d__spot at)
{
    sph2d__store *f = &sim->system.fluid;
    if (!sph2d__store_reserve(f, &sim->memory, f->count + 1))
        return false;
    sph2d_vec2 p = sph2d__place_of(o, at);
    size_t i = sph2d__sim_add_liquid(sim, p, o->given->color);
    if (f->filling)
        f->filling[i] = 1;
    sph2d__opening_set_particle(sim, o, i);
    return true;
}

/** The lane of a place. */
static size_t lane_at(const sph2d__opening *o, double along)
{
    double k = floor(along / o->lane_width);
    return (size_t)fmin(fmax(k, 0), (double)o->lane_count - 1);
}

/** Whether a lane is full at the start: not where liquid will leave but none is before it. */
static bool is_full(const sph2d_sim *sim, const sph2d__opening *o, size_t k)
{
    double value = sph2d__opening_value(&sim->world.scene, o->given, 0);
    if (value == 0)
        value = sph2d__opening_value(&sim->world.scene, o->given, INFINITY);
    bool leaves = o->has_velocity && value < 0;
    return is_fed(o, k) && (!leaves || o->lanes[k].wet);
}

/** Fills duct and reservoir of an opening whose line is in the side. False when memory is short. */
static bool fill(sph2d_sim *sim, const sph2d__opening *o)
{
    for (size_t k = 0; k < o->lane_count; ++k)
        for (double beyond = o->stride / 2; beyond <= o->depth + o->duct; beyond += o->stride)
            if (is_full(sim, o, k) && !add_at(sim, o, (sph2d__spot){((double)k + 0.5) * o->lane_width, beyond}))
                return false;
    return true;
}

sph2d_status sph2d__openings_fill(sph2d_sim *sim)
{
    sph2d__openings *all = &sim->openings;
    for (size_t n = 0; n < all->count; ++n)
        sph2d__opening_set_line(sim, &all->items[n], 0);
    sph2d__openings_measure(sim);
    sph2d__openings_average(sim, 0);
    bool ok = true;
    for (size_t n = 0; n < all->count; ++n)
        ok = ok && fill(sim, &all->items[n]);
    for (size_t n = 0; n < all->count; ++n) {
        sph2d__opening_set_line(sim, &all->items[n], all->items[n].duct);
        all->items[n].means->first = sph2d__opening_particles(sim, &all->items[n]);
    }
    return ok ? SPH2D_OK : SPH2D_NOMEM;
}

/** Finds the outermost particle of each lane of all openings; none is -stride/2, so that the first comes at half a
 *  stride. */
static void find_outermost(sph2d_sim *sim)
{
    const sph2d__store *f = &sim->system.fluid;
    for (size_t n = 0; n < sim->openings.count; ++n)
        for (size_t k = 0; k < sim->openings.items[n].lane_count; ++k)
            sim->openings.items[n].outermost[k] = -sim->openings.items[n].stride / 2;
    for (size_t i = 0; i < f->count; ++i) {
        const sph2d__opening *o = sph2d__opening_at(sim, f->x[i], f->y[i]);
        if (!o)
            continue;
        sph2d__spot at = sph2d__spot_of(o, f->x[i], f->y[i]);
        double *outermost = &o->outermost[lane_at(o, at.along)];
        *outermost = fmax(*outermost, at.beyond);
    }
}

/** Whether a lane gets new particles: liquid flows in, and comes from somewhere. */
static bool flows_in(const sph2d_sim *sim, const sph2d__opening *o, size_t k)
{
    double along = ((double)k + 0.5) * o->lane_width;
    sph2d_vec2 p = sph2d__place_of(o, (sph2d__spot){along, 0});
    return is_fed(o, k) && sph2d__prescribed_at(sim, o, (sph2d__spot){along, 0}, p.x, p.y).inward > 0;
}

/** Counts the particle that came last, and its energy. */
static void count_in(sph2d_sim *sim, const sph2d__opening *o)
{
    const sph2d__store *f = &sim->system.fluid;
    size_t i = f->count - 1;
    sim->record.energy_fed += sph2d__sim_energy_of(sim, f->x[i], f->y[i], f->vx[i], f->vy[i]) +
                              sim->system.mass * sph2d__sim_elastic_of(sim, i);
    ++sim->record.let_in;
    ++o->means->came;
}

sph2d_status sph2d__openings_feed(sph2d_sim *sim)
{
    if (sim->openings.count == 0)
        return SPH2D_OK;
    sph2d__openings_measure(sim);
    sph2d__openings_average(sim, sim->record.last_step);
    find_outermost(sim);
    for (size_t n = 0; n < sim->openings.count; ++n) {
        const sph2d__opening *o = &sim->openings.items[n];
        for (size_t k = 0; k < o->lane_count; ++k) {
            while (flows_in(sim, o, k) && o->outermost[k] + o->stride <= o->depth) {
                o->outermost[k] += o->stride;
                if (!add_at(sim, o, (sph2d__spot){((double)k + 0.5) * o->lane_width, o->outermost[k]}))
                    return SPH2D_NOMEM;
                count_in(sim, o);
            }
        }
    }
    return SPH2D_OK;
}

/* ---- particles go ------------------------------------------------------------------------------------------------ */

bool sph2d__openings_spent(const sph2d_sim *sim, double x, double y)
{
    const sph2d__opening *o = sph2d__opening_at(sim, x, y);
    return o && sph2d__spot_of(o, x, y).beyond > o->depth;
}

void sph2d__openings_count_out(sph2d_sim *sim, double x, double y)
{
    const sph2d__opening *o = sph2d__opening_at(sim, x, y);
    if (o)
        ++o->means->left;
}
