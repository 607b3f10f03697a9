/* SPDX-License-Identifier: MIT */
/** @file muller_loops.h
 *  The loops of method `muller` over particles `first` to `last` - 1, in C and in OpenCL C; the pair terms are in muller_pair.h. */
#ifndef SPH2D_METHODS_MULLER_MULLER_LOOPS_H
#define SPH2D_METHODS_MULLER_MULLER_LOOPS_H

#include "methods/muller/muller_pair.h"

/** The density sum, without constants, around a group of particles `of`; `mass` NULL: unit masses. */
SPH2D__INLINE sph2d__lanes density_sum(double support2, const sph2d__store *of, const sph2d__group *g,
                                       const sph2d__ranges *ranges, const sph2d__store *from,
                                       SPH2D__ARRAY const double *mass)
{
    sph2d__lanes sum = {0};
    for (int r = 0; r < ranges->count; ++r) {
        sph2d__lanes x = sph2d__group_lanes(of->x + g->first, ranges->x[r]);
        sph2d__lanes y = sph2d__group_lanes(of->y + g->first, ranges->y[r]);
        for (size_t j = ranges->begin[r]; j < ranges->end[r]; ++j) {
            sph2d__lanes shape = shape_of(support2, x, y, from->x[j], from->y[j]);
            sum += mass ? shape * mass[j] : shape;
        }
    }
    return sum;
}

static void density(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *fluid = &s->fluid;
    double support2 = s->support * s->support;
    double poly6 = sph2d__poly6_constant(s->support);
    double own = poly6 * s->calibration * s->mass;
    const sph2d__grouping by = sph2d__grouping_of(fluid, &s->fluid_cells, s->walls_press ? &s->wall_cells : NULL);
    SPH2D__FOR_GROUPS (&by, g, first, last) {
        sph2d__ranges ranges;
        sph2d__patch_ranges(by.cells, &g.patch, &ranges);
        sph2d__lanes rho = own * density_sum(support2, fluid, &g, &ranges, fluid, NULL);
        if (sph2d__group_others(&by, &g, &ranges))
            rho += poly6 * density_sum(support2, fluid, &g, &ranges, &s->walls, s->walls.mass);
        for (int l = 0; l < g.count; ++l) {
            size_t i = g.first + (size_t)l;
            fluid->density[i] = SPH2D__LANE(rho, l) + side_density(s, fluid->x[i], fluid->y[i]);
        }
    }
}

static void wall_density(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *walls = &s->walls;
    double support2 = s->support * s->support;
    double own = sph2d__poly6_constant(s->support) * s->calibration * s->mass;
    const sph2d__grouping by = sph2d__grouping_of(walls, &s->wall_cells, &s->fluid_cells);
    SPH2D__FOR_GROUPS (&by, g, first, last) {
        sph2d__ranges ranges;
        sph2d__lanes sum = {0};
        if (sph2d__group_others(&by, &g, &ranges))
            sum = density_sum(support2, walls, &g, &ranges, &s->fluid, NULL);
        for (int l = 0; l < g.count; ++l) {
            size_t b = g.first + (size_t)l;
            walls->density[b] = s->rest_density + (walls->mass[b] > 0 ? own * SPH2D__LANE(sum, l) : 0);
        }
    }
}

/** Sums the forces of the particles in `ranges` on a group whose bounding box is set. */
SPH2D__INLINE force_sums sum_forces(const sph2d__system *s, const sph2d__group *g, const sph2d__ranges *ranges,
                                    const sph2d__store *from)
{
    const sph2d__store *fluid = &s->fluid;
    force_sums sums = {{0}, {0}, {{0}, {0}}};
    group_state own = {.vx = sph2d__lanes_load(fluid->vx + g->first),
                       .vy = sph2d__lanes_load(fluid->vy + g->first),
                       .pressure = sph2d__lanes_load(fluid->acting_pressure + g->first)};
    sph2d__sieve sieve;
    sph2d__sieve_start(&sieve, ranges, s->support);
    while (sph2d__sift(&sieve, g, ranges, from->x, from->y)) {
        own.x = sph2d__group_lanes(fluid->x + g->first, sieve.offset_x);
        own.y = sph2d__group_lanes(fluid->y + g->first, sieve.offset_y);
        SPH2D__FOR_FOUND (sieve, j)
            if (from == &s->walls)
                add_wall_force(&sums, s->support, &own, from, j);
            else
                add_force(&sums, s->support, &own, from, j);
    }
    return sums;
}

static void force(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    const double press = sph2d__spiky_constant(s->support) / (2 * s->moment),
                 laplacian = sph2d__viscosity_constant(s->support);
    const double wall_press = 6 * sph2d__poly6_constant(s->support);
    const double drag = s->viscosity * laplacian;
    const sph2d__grouping by = sph2d__grouping_of(f, &s->fluid_cells, s->walls_press ? &s->wall_cells : NULL);
    SPH2D__FOR_GROUPS (&by, g, first, last) {
        sph2d__ranges ranges;
        sph2d__patch_ranges(by.cells, &g.patch, &ranges);
        sph2d__group_box(f, &g);
        force_sums sums = sum_forces(s, &g, &ranges, f);
        sph2d__lanes fx = press * sums.press_x + drag * sums.drag.x, fy = press * sums.press_y + drag * sums.drag.y;
        if (sph2d__group_others(&by, &g, &ranges)) {
            sums = sum_forces(s, &g, &ranges, &s->walls);
            sph2d__lanes hard =
                wall_press * sph2d__lanes_load(f->pressure + g.first) / sph2d__lanes_load(f->density + g.first);
            fx += hard * sums.press_x + drag * sums.drag.x;
            fy += hard * sums.press_y + drag * sums.drag.y;
        }
        for (int l = 0; l < g.count; ++l) {
            size_t i = g.first + (size_t)l;
            double ax = SPH2D__LANE(fx, l) / f->density[i], ay = SPH2D__LANE(fy, l) / f->density[i];
            sph2d__forces_add(&s->forces, (sph2d__place){f->x[i], f->y[i], f->vx[i], f->vy[i]}, &ax, &ay);
            add_side_force(s, i, &ax, &ay);
            f->ax[i] = ax;
            f->ay[i] = ay;
        }
    }
}

/* ---- pressures --------------------------------------------------------------------------------------------------- */

/** G, the pressure in pairs over that of the equation of state, at a density over rest density. */
SPH2D__INLINE double pair_gain(const sph2d__system *s, double density)
{
    SPH2D__ARRAY const double *gains = s->tables->pair_gain;
    double position = (density - 1) * SPH2D__PAIR_GAINS / (SPH2D__PAIR_GAIN_TOP - 1);
    if (!(position < SPH2D__PAIR_GAINS))
        return gains[SPH2D__PAIR_GAINS];
    int k = position > 0 ? (int)position : 0;
    return gains[k] + fmax(position - k, 0) * (gains[k + 1] - gains[k]);
}

/** The pressure of a lattice, P k (rho - rho0), if positive. */
SPH2D__INLINE double pressure_of(const sph2d__system *s, double density)
{
    double p = s->modulus * (density - s->rest_density);
    return p > 0 ? p : 0;
}

/** Sets pressures and volumes. */
static void pressures(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__store *fluid = &s->fluid;
    for (size_t i = first; i < last; ++i) {
        fluid->pressure[i] = pressure_of(s, fluid->density[i]);
        fluid->acting_pressure[i] = pair_gain(s, fluid->density[i] / s->rest_density) * fluid->pressure[i];
        fluid->volume[i] = s->mass / fluid->density[i];
    }
}

/** The same of boundary particles. */
static void wall_pressures(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__store *walls = &s->walls;
    for (size_t b = first; b < last; ++b) {
        walls->pressure[b] = pressure_of(s, walls->density[b]);
        walls->volume[b] = walls->mass[b] / walls->density[b];
    }
}

#endif
