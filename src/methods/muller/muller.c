/* SPDX-License-Identifier: MIT */
/** @file muller.c
 *  Method `muller`: setup, equation of state, step limits. The pair loops are in muller_pass.c. */
#include "methods/muller/muller.h"
#include "methods/muller/muller_walls.h"
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
        s->tables->pair_gain[k] = sph2d__muller_pair_gain(s->support, s->spacing, compressed_spacing(s, density));
    }
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

static bool evaluate(sph2d__system *s)
{
    const sph2d__muller_passes *pass = sph2d__muller_passes_find(s->isa);
    sph2d__store *fluid = &s->fluid, *walls = &s->walls;
    sph2d_phase before = sph2d__profile_enter(&s->profile, SPH2D_PHASE_DENSITY);
    sph2d__over_particles(s, fluid->count, pass->density, "density_pass");
    sph2d__over_particles(s, fluid->count, pass->pressures, "pressures_pass");
    if (s->walls_press) {
        sph2d__profile_enter(&s->profile, SPH2D_PHASE_WALLS);
        sph2d__over_particles(s, walls->count, pass->wall_density, "wall_density_pass");
        sph2d__over_particles(s, walls->count, pass->wall_pressures, "wall_pressures_pass");
    }
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_FORCES);
    sph2d__over_particles(s, fluid->count, pass->force, "force_pass");
    sph2d__tension_add(s);
    sph2d__profile_enter(&s->profile, before);
    return true;
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
