/* SPDX-License-Identifier: MIT */
/** @file energy.c
 *  Kinetic, potential and elastic energy of the liquid. */
#include <math.h>

#include "base/pi.h"
#include "methods/common/on_device.h"
#include "methods/common/slabs.h"
#include "methods/common/state_equation.h"
#include "methods/terms/tension.h"
#include "scene/method_table.h"
#include "sim/balance.h"
#include "sim/simulation.h"

static void sum_motion(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    for (size_t i = slab->first; i < slab->last; ++i)
        sph2d__add_energy(s, i, 0, sum);
}

double sph2d__sim_energy_of_all(const sph2d_sim *sim)
{
    const sph2d__system *s = &sim->system;
    return s->mass * (sph2d__is_on_device(s) ? sph2d__device_sum(s, "sum_energy", NULL, 0)
                                             : sph2d__sum_fluid(s, sum_motion, NULL))
                         .second;
}

double sph2d__sim_energy_of(const sph2d_sim *sim, double x, double y, double vx, double vy)
{
    return sim->system.mass * sph2d__energy_at(&sim->system, x, y, vx, vy);
}

double sph2d__sim_elastic_of(const sph2d_sim *sim, size_t i)
{
    const sph2d__system *s = &sim->system;
    return sim->method->elastic ? sim->method->elastic(s, i, sim->record.steps > 0)
                                : sph2d__elastic_of(s, s->fluid.density[i]);
}

bool sph2d__sim_elastic_falls(const sph2d_sim *sim)
{
    return sph2d__method_row_of(&sim->system.method)->free_compression;
}

static void sum_energy(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const sph2d_sim *sim = with;
    for (size_t i = slab->first; i < slab->last; ++i)
        sph2d__add_energy(s, i, sph2d__sim_elastic_of(sim, i), sum);
}

void sph2d__sim_sum_energy(const sph2d_sim *sim, sph2d_summary *out)
{
    const sph2d__slab_sum sum = sph2d__is_on_device(&sim->system)
                                    ? sph2d__device_sum(&sim->system, "sum_energy", NULL, 0)
                                    : sph2d__sum_fluid(&sim->system, sum_energy, sim);
    const double m = sim->system.mass;
    out->kinetic = m * sum.first;
    out->potential = m * sum.second - m * sum.first;
    if (sim->system.surface_tension > 0)
        out->potential += sph2d__sim_is_broken(sim) ? NAN : sph2d__tension_energy(&sim->system);
    out->bodies = sph2d__bodies_energy(sim);
    out->elastic = sph2d__sim_elastic_falls(sim) ? fmin(m * sum.third, sim->record.energy_elastic) : m * sum.third;
    out->momentum[0] = m * sum.x;
    out->momentum[1] = m * sum.y;
    out->speed_max = sqrt(sum.most);
}

double sph2d__sim_fall_energy(const sph2d_sim *sim)
{
    const sph2d__system *s = &sim->system;
    const sph2d__record *r = &sim->record;
    uint64_t all =
        s->fluid.count + r->let_out + r->drained + r->left_left + r->left_right + r->left_bottom + r->left_top;
    double n = (double)all, area = n * s->spacing * s->spacing;
    double bodies = 0;
    for (size_t k = 0; k < sim->bodies.count; ++k)
        bodies += sim->bodies.items[k].mass;
    double head = s->head - s->spring_head;
    return (s->mass * n + bodies) * head / 2 + s->spring_energy + s->surface_tension * 2 * sqrt(SPH2D__PI * area);
}

double sph2d__sim_energy_scale(const sph2d_sim *sim)
{
    return sph2d__sim_fall_energy(sim) + sim->record.energy_held;
}

/* Quanta in a particle's share of the energy scale. */
static const double QUANTA = 4e9;

double sph2d__sim_energy_quantum(const sph2d_sim *sim)
{
    const sph2d__system *s = &sim->system;
    return s->mass * (s->head > 0 ? s->head : 1) / QUANTA;
}
