/* SPDX-License-Identifier: MIT */
/** @file energy.c
 *  Kinetic, potential and elastic energy of the liquid. */
#include <math.h>

#include "base/pi.h"
#include "methods/common/state_equation.h"
#include "methods/terms/tension.h"
#include "scene/method_table.h"
#include "sim/simulation.h"

/* Four sums side by side, as additions of one wait for each other. */
double sph2d__sim_energy_of_all(const sph2d_sim *sim)
{
    const sph2d__store *f = &sim->system.fluid;
    const sph2d__forces *forces = &sim->system.forces;
    enum { SIDE_BY_SIDE = 4 };
    double sums[SIDE_BY_SIDE] = {0};
    size_t i = 0;
    for (; i + SIDE_BY_SIDE <= f->count; i += SIDE_BY_SIDE)
        for (size_t k = 0; k < SIDE_BY_SIDE; ++k)
            sums[k] += (f->vx[i + k] * f->vx[i + k] + f->vy[i + k] * f->vy[i + k]) / 2 +
                       sph2d__forces_potential(forces, f->x[i + k], f->y[i + k]);
    for (; i < f->count; ++i)
        sums[0] += (f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i]) / 2 + sph2d__forces_potential(forces, f->x[i], f->y[i]);
    return sim->system.mass * ((sums[0] + sums[1]) + (sums[2] + sums[3]));
}

double sph2d__sim_energy_of(const sph2d_sim *sim, double x, double y, double vx, double vy)
{
    return sim->system.mass * ((vx * vx + vy * vy) / 2 + sph2d__forces_potential(&sim->system.forces, x, y));
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

void sph2d__sim_sum_energy(const sph2d_sim *sim, sph2d_summary *out)
{
    const sph2d__store *f = &sim->system.fluid;
    double m = sim->system.mass, kinetic = 0, total = 0, px = 0, py = 0, speed2 = 0, elastic = 0;
    for (size_t i = 0; i < f->count; ++i) {
        double v2 = f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i];
        kinetic += v2 / 2;
        total += sph2d__sim_energy_of(sim, f->x[i], f->y[i], f->vx[i], f->vy[i]);
        elastic += sph2d__sim_elastic_of(sim, i);
        px += f->vx[i];
        py += f->vy[i];
        speed2 = v2 > speed2 ? v2 : speed2;
    }
    out->kinetic = m * kinetic;
    out->potential = total - m * kinetic;
    if (sim->system.surface_tension > 0)
        out->potential += sph2d__sim_is_broken(sim) ? NAN : sph2d__tension_energy(&sim->system);
    out->bodies = sph2d__bodies_energy(sim);
    out->elastic = sph2d__sim_elastic_falls(sim) ? fmin(m * elastic, sim->record.energy_elastic) : m * elastic;
    out->momentum[0] = m * px;
    out->momentum[1] = m * py;
    out->speed_max = sqrt(speed2);
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
