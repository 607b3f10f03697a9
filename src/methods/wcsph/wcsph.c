/* SPDX-License-Identifier: MIT */
/** @file wcsph.c
 *  Method `wcsph`, variational operators: setup, what stands still over a step, wall forces. */
#include "methods/wcsph/wcsph.h"
#include "methods/wcsph/wcsph_walls.h"

#include <math.h>
#include <string.h>

#include "kernels/kernel.h"
#include "methods/terms/friction.h"
#include "methods/terms/tension.h"
#include "methods/terms/viscosity.h"

/* Lattice sites on either side of a particle. */
enum { REACH = SPH2D__LATTICE_REACH };

/** The stiffness of a lattice under a uniform pressure p: a particle that is out of place by u cos(kappa x) along x is
 *  pushed back by up to this times p u/(rho dx^2). By the force (p_i B_i + p_j B_j) G with B of the places that are out of
 *  order, too; waves in other directions have less. */
static double lattice_stiffness(const sph2d__system *s)
{
    enum { WAVES = 24 };
    const sph2d_kernel kernel = s->method.kernel;
    const double step = s->spacing / s->support, small = 1e-3 * step;
    double most = 0;
    for (int wave = 1; wave <= WAVES; ++wave) {
        const double kappa = acos(-1) * wave / WAVES;
        double moment = 0, curved = 0, drawn = 0, changed = 0;
        for (int i = -REACH; i <= REACH; ++i)
            for (int j = -REACH; j <= REACH; ++j) {
                const double r2 = fmax(i * i + j * j, 1), q = sqrt(r2) * step,
                             slope = sph2d__kernel_slope_at(kernel, q),
                             bend = (sph2d__kernel_slope_at(kernel, q + small) -
                                     sph2d__kernel_slope_at(kernel, q - small)) /
                                    (2 * small),
                             second = slope + q * bend * i * i / r2; /* of W, twice along x */
                moment -= slope * i * i;
                curved += (1 - cos(kappa * i)) * second;
                drawn -= sin(kappa * i) * slope * i;
                changed += sin(kappa * i) * second * i;
            }
        most = fmax(most, (2 * curved + (drawn - changed) * drawn / moment) / moment);
    }
    return most;
}

/** Sets the sums over a full lattice: of f(q), and of |G| r, as lattice_slopes; and the weight of viscosity. */
static void prepare(sph2d__system *s)
{
    const double h2 = s->support * s->support, dx = s->spacing;
    const double scale = s->mass / s->rest_density * sph2d__kernel_constant(s->method.kernel) / (h2 * h2);
    double values = 0, slopes = 0;
    for (int i = -REACH; i <= REACH; ++i)
        for (int j = -REACH; j <= REACH; ++j) {
            const double r = hypot(i, j) * dx,
                         g = -scale * r * sph2d__kernel_slope_at(s->method.kernel, r / s->support);
            values += sph2d__kernel_value_at(s->method.kernel, r / s->support);
            slopes += g * r;
        }
    s->lattice_values = values;
    s->lattice_slopes = slopes;
    s->lattice_stiffness = lattice_stiffness(s);
    s->central_weight = sph2d__central_weight(s->method.kernel, s->support);
}

/** When walls have moved. */
static void walls_placed(sph2d__system *s)
{
    if (s->frozen && s->frozen->walls > 0)
        sph2d__wall_parts_find(s);
}

/* ---- the method -------------------------------------------------------------------------------------------------- */

/** The logarithm of a ratio of densities, by Newton's method. */
static double log_density(double ratio)
{
    double theta = ratio - 1;
    for (int k = 0; k < 8; ++k)
        theta += ratio / sph2d__density_ratio(theta) - 1;
    return theta;
}

static void take_density(sph2d__system *s, size_t i)
{
    const sph2d__store *f = &s->fluid;
    f->log_density[i] = log_density(f->density[i] / s->rest_density);
    f->pressure[i] = f->density[i] * s->sound_speed * s->sound_speed * f->log_density[i];
}

static void start(sph2d__system *s, size_t first, size_t last)
{
    const sph2d__store *f = &s->fluid;
    for (size_t i = first; i < last; ++i) {
        take_density(s, i);
        f->stored[i] = sph2d__side_energy(s, f->x[i], f->y[i]);
        f->ax[i] = f->ay[i] = 0;
        sph2d__forces_add(&s->forces, (sph2d__place){f->x[i], f->y[i], f->vx[i], f->vy[i]}, &f->ax[i], &f->ay[i]);
    }
}

/** At the start: forces are those of a step. */
static bool evaluate(sph2d__system *s)
{
    sph2d__over_particles(s, s->fluid.count, start, NULL);
    return true;
}

static double elastic(const sph2d__system *s, size_t i, bool stepped)
{
    (void)stepped;
    return elastic_of(s, i);
}

static sph2d__wall_force wall_force(const sph2d__system *s, size_t i, size_t b, double dx, double dy)
{
    sph2d__wall_force force = mean_wall_force(s, i, b, dx, dy);
    const sph2d_vec2 friction = sph2d__friction_of(s, b, dx, dy);
    force.friction = (sph2d_vec2){force.friction.x + friction.x, force.friction.y + friction.y};
    return force;
}

/* What both time schemes share. */
#define OPERATORS                                                                                                      \
    .fluid = SPH2D__STORE_BASIC | SPH2D__BIT(ax) | SPH2D__BIT(ay) | SPH2D__BIT(density) | SPH2D__BIT(pressure) |       \
             SPH2D__BIT(log_density) | SPH2D__BIT(stored) | SPH2D__BIT(next_x) | SPH2D__BIT(next_y) |                  \
             SPH2D__BIT(stretch) | SPH2D__BIT(shear),                                                                  \
    .carried = SPH2D__STORE_BASIC | SPH2D__BIT(ax) | SPH2D__BIT(ay) | SPH2D__BIT(density) | SPH2D__BIT(pressure) |     \
               SPH2D__BIT(log_density) | SPH2D__BIT(stored) | SPH2D__BIT(next_x) | SPH2D__BIT(next_y) |                \
               SPH2D__BIT(stretch) | SPH2D__BIT(shear), /* a resumed run knows its largest viscosity by them */        \
        .walls = SPH2D__STORE_BASIC | SPH2D__BIT(normal_x) | SPH2D__BIT(normal_y) | SPH2D__BIT(ax) | SPH2D__BIT(ay) |  \
                 SPH2D__BIT(start_x) | SPH2D__BIT(start_y) | SPH2D__BIT(mass) | SPH2D__BIT(bounce) |                   \
                 SPH2D__BIT(density) | SPH2D__BIT(pressure) | SPH2D__BIT(depth) | SPH2D__BIT(skin) | SPH2D__BIT(drag), \
    .prepare = prepare, .set_sides = sph2d__wcsph_set_sides, .evaluate = evaluate, .elastic = elastic,                 \
    .take_density = take_density, .walls_placed = walls_placed, .wall_force = wall_force, .side_push = mean_side_push, \
    .books_all = true, .mean_forces = true, .couples_bodies = true

const sph2d__method sph2d__wcsph = {
    .name = "wcsph", .step = sph2d__wcsph_step, OPERATORS, .stable_step = sph2d__wcsph_stable_step};
const sph2d__method sph2d__constraint = {.name = "constraint",
                                         .step = sph2d__wcsph_step,
                                         OPERATORS,
                                         .walls_hold = true,
                                         .stable_step = sph2d__implicit_stable_step};
