/* SPDX-License-Identifier: MIT */
/** @file muller.c
 *  Method `muller`: setup, equation of state, step limits. The pair loops are in muller_pass.c. */
#include "methods/muller/muller.h"
#include "methods/muller/muller_side.h"
#include "methods/terms/tension.h"
#include "methods/terms/viscosity.h"

#include <math.h>

#include "base/parallel.h"
#include "kernels/muller.h"
#include "methods/terms/stable_step.h"

/* Step limits as fractions of H^2/nu and sqrt(H/a). On a lattice the viscous operator is stable for nu dt/H^2 < 0.145;
 * in a compressed liquid at H/dx = 1.3, with the acoustic limit reached too, 0.06 was stable and 0.08 was not. With the
 * least viscosity, 0.1 c0 H, this is 0.4 H/c0. */
static const double VISCOUS = 0.04;
static const double FORCE = 0.25;

/** Sets the mass of each boundary particle so that the boundary alone has the rest density there, which makes it heavy
 *  where the wall is thin: m_b = rho0 / sum_b' W(r_bb') (Akinci et al. 2012, eq. 4). */
static void set_wall_masses(sph2d__system *s)
{
    const sph2d__store *walls = &s->walls;
    double support2 = s->support * s->support;
    double poly6 = sph2d__poly6_constant(s->support);
    for (size_t b = 0; b < walls->count; ++b) {
        s->walls.mass[b] = 0;
        if (s->walls.bounce[b] >= 0)
            continue;
        sph2d__ranges ranges;
        sph2d__cells_ranges(&s->wall_cells, sph2d__cells_find(&s->wall_cells, walls->x[b], walls->y[b]), &ranges);
        double sum = 0;
        SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
            double dx = walls->x[b] + ranges.x[r] - walls->x[j], dy = walls->y[b] + ranges.y[r] - walls->y[j];
            if (s->walls.bounce[j] < 0)
                sum += sph2d__poly6_shape(support2, dx * dx + dy * dy);
        }
        s->walls.mass[b] = s->rest_density / (poly6 * sum);
    }
}

/** Sets the constants of the sides (muller_side.h). In a lattice under uniform pressure p pair forces accelerate the
 *  last row by p/(rho0 dx). */
static void set_side_constants(sph2d__system *s)
{
    double beside = sph2d__poly6_beyond_sum(s->support, s->spacing), q = s->spacing / s->support;
    s->side_fill = s->rest_density * beside;
    s->corner_fill = s->rest_density * sph2d__poly6_quarter_sum(s->support, s->spacing);
    s->side_power = (1 - q * q) / (2 * q * q * beside);
}

/** Spacing of a uniformly compressed lattice whose density sum is `compressed` times rest density. */
static double compressed_spacing(const sph2d__system *s, double compressed)
{
    double low = 0, high = s->spacing;
    for (int k = 0; k < 40; ++k) {
        double middle = (low + high) / 2;
        bool more = sph2d__poly6_compressed(s->support, s->spacing, fmax(middle, 0.2 * s->spacing)) > compressed;
        low = more ? middle : low;
        high = more ? high : middle;
    }
    return high;
}

static void set_pair_gains(sph2d__system *s)
{
    for (int k = 0; k <= SPH2D__PAIR_GAINS; ++k) {
        double density = 1 + (double)k * (SPH2D__PAIR_GAIN_TOP - 1) / SPH2D__PAIR_GAINS;
        s->pair_gain[k] = sph2d__muller_pair_gain(s->support, s->spacing, compressed_spacing(s, density));
    }
}

/** G, the pressure in pairs over that of the equation of state, at a density over rest density. */
static double pair_gain(const sph2d__system *s, double density)
{
    double position = (density - 1) * SPH2D__PAIR_GAINS / (SPH2D__PAIR_GAIN_TOP - 1);
    if (!(position < SPH2D__PAIR_GAINS))
        return s->pair_gain[SPH2D__PAIR_GAINS];
    int k = position > 0 ? (int)position : 0;
    return s->pair_gain[k] + fmax(position - k, 0) * (s->pair_gain[k + 1] - s->pair_gain[k]);
}

static void prepare(sph2d__system *s)
{
    s->calibration = 1 / sph2d__poly6_lattice_sum(s->support, s->spacing);
    set_side_constants(s);
    s->moment = sph2d__spiky_lattice_stress(s->support, s->spacing);
    s->modulus = s->sound_speed * s->sound_speed / sph2d__poly6_lattice_response(s->support, s->spacing);
    s->viscosity = sph2d__viscosity_at_least(s);
    set_pair_gains(s);
    set_wall_masses(s);
}

/** The pressure of a lattice, P k (rho - rho0), if positive. */
static double pressure_of(const sph2d__system *s, double density)
{
    double p = s->modulus * (density - s->rest_density);
    return p > 0 ? p : 0;
}

/** Sets pressures and volumes. */
static void set_pressures(sph2d__system *s)
{
    const sph2d__store *fluid = &s->fluid;
#pragma omp taskloop num_tasks(sph2d__tasks(fluid->count, SPH2D__GRAIN)) if (fluid->count > SPH2D__GRAIN)
    for (size_t i = 0; i < fluid->count; ++i) {
        fluid->pressure[i] = pressure_of(s, fluid->density[i]);
        fluid->acting_pressure[i] = pair_gain(s, fluid->density[i] / s->rest_density) * fluid->pressure[i];
        fluid->volume[i] = s->mass / fluid->density[i];
    }
}

static bool evaluate(sph2d__system *s)
{
    const sph2d__muller_passes *pass = sph2d__muller_passes_find(s->isa);
    sph2d__store *fluid = &s->fluid, *walls = &s->walls;
    sph2d_phase before = sph2d__profile_enter(&s->profile, SPH2D_PHASE_DENSITY);
    sph2d__over_particles(s, fluid->count, pass->density);
    set_pressures(s);
    if (s->walls_press) {
        sph2d__profile_enter(&s->profile, SPH2D_PHASE_WALLS);
        sph2d__over_particles(s, walls->count, pass->wall_density);
        for (size_t b = 0; b < walls->count; ++b) {
            walls->pressure[b] = pressure_of(s, walls->density[b]);
            walls->volume[b] = s->walls.mass[b] / walls->density[b];
        }
    }
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_FORCES);
    sph2d__over_particles(s, fluid->count, pass->force);
    sph2d__tension_add(s);
    sph2d__profile_enter(&s->profile, before);
    return true;
}

static void side_push(const sph2d__system *s, size_t i, double push[4])
{
    const sph2d__store *f = &s->fluid;
    const sph2d__springs *w = &s->forces.springs;
    const double distances[4] = {f->x[i] - w->left, w->right - f->x[i], f->y[i] - w->bottom, w->top - f->y[i]};
    sph2d__side_part parts[2];
    sph2d__sides_at(s, f->x[i], f->y[i], parts);
    for (int side = 0; side < 4; ++side) {
        sph2d__side_part part = {0, 0};
        if (distances[side] < s->support)
            sph2d__side_add(s, distances[side], &part);
        push[side] = f->pressure[i] / (f->density[i] * f->density[i]) *
                     (s->side_fill + s->corner_fill * parts[1 - side / 2].value) * part.slope;
    }
}

static sph2d__wall_force wall_force(const sph2d__system *s, size_t i, size_t b, double dx, double dy)
{
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    double h2 = s->support * s->support, d = h2 - dx * dx - dy * dy, density = f->density[i],
           volume = s->mass / density;
    double press = volume * 6 * sph2d__poly6_constant(s->support) * f->pressure[i] / density * d * d * w->mass[b];
    double drag =
        s->viscosity * sph2d__viscosity_constant(s->support) * volume * (s->support - sqrt(h2 - d)) * w->volume[b];
    return (sph2d__wall_force){.pressure = {press * dx, press * dy},
                               .friction = {drag * (w->vx[b] - f->vx[i]), drag * (w->vy[b] - f->vy[i])}};
}

static double stable_step(const sph2d__system *s, double speed, double acceleration, sph2d__limit *limit)
{
    return sph2d__shortest_step(s, s->sound_speed, speed, acceleration, s->viscosity / s->rest_density, VISCOUS, FORCE,
                                limit);
}

const sph2d__method sph2d__muller = {
    .name = "muller",
    .step = sph2d__leapfrog,
    .fluid = SPH2D__STORE_BASIC | SPH2D__BIT(ax) | SPH2D__BIT(ay) | SPH2D__BIT(old_ax) | SPH2D__BIT(old_ay) |
             SPH2D__BIT(density) | SPH2D__BIT(pressure) | SPH2D__BIT(acting_pressure) | SPH2D__BIT(volume),
    .carried = SPH2D__STORE_BASIC | SPH2D__BIT(ax) | SPH2D__BIT(ay),
    .walls = SPH2D__STORE_BASIC | SPH2D__BIT(ax) | SPH2D__BIT(ay) | SPH2D__BIT(start_x) | SPH2D__BIT(start_y) |
             SPH2D__BIT(mass) | SPH2D__BIT(bounce) | SPH2D__BIT(density) | SPH2D__BIT(pressure) | SPH2D__BIT(volume),
    .prepare = prepare,
    .evaluate = evaluate,
    .wall_force = wall_force,
    .side_push = side_push,
    .stable_step = stable_step,
};
