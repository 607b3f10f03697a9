/* SPDX-License-Identifier: MIT */
/** @file projection.c
 *  The pair loops of projection.h for the instruction set in use, and what comes before them. */
#include "methods/projection/projection.h"

#include "methods/projection/body_rows.h"

#include <math.h>
#include <string.h>

#include "kernels/kernel.h"
#include "methods/projection/limited_viscosity.h"
#include "methods/terms/stable_step.h"
#include "methods/terms/tension.h"
#include "methods/terms/viscosity.h"
#include "simd/lanes.h"

/** Pairs of a particle in a filled lattice, half as many again for disorder, and walls. */
static size_t usual_pairs(const sph2d__system *s)
{
    double ratio = s->support / s->spacing;
    return (size_t)(1.5 * SPH2D__PI * ratio * ratio) + 8;
}

/** Puts the particle that shorter lists end with where no kernel reaches: behind the last one of a store. So are the
 *  other lanes of its slice: what a store left there can be anything, and a value that is not finite would spread by
 *  sums over rows. */
static void put_far(const sph2d__store *store, double *x, double *y)
{
    size_t end = store->count + SPH2D__WIDEST - store->count % SPH2D__WIDEST;
    for (size_t i = store->count; i < end && store->capacity > 0; ++i)
        x[i] = y[i] = 1e30;
}

/** That particle stands still: a gradient of zero times what is no number is none. */
static void stand_still(const sph2d__store *f)
{
    if (f->capacity > 0)
        f->vx[f->count] = f->vy[f->count] = 0;
}

/** Gathers for the slab; its largest is 1 when there was not room enough. */
static void gather_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const sph2d__projection_gather_pass *pass = sph2d__projection_gather_find(s->isa);
    (void)with;
    sum->most = !(slab->walls ? pass->walls : pass->fluid)[s->method.kernel](s, slab->first / SPH2D__SLAB);
}

bool sph2d__projection_gather(sph2d__system *s)
{
    sph2d_phase before = sph2d__profile_enter(&s->profile, SPH2D_PHASE_SEARCH);
    size_t each = usual_pairs(s);
    put_far(&s->fluid, s->fluid.x, s->fluid.y);
    put_far(&s->walls, s->walls.x, s->walls.y);
    stand_still(&s->fluid);
    for (;; each = 2 * s->neighbours.each) {
        if (!sph2d__neighbours_reserve(&s->neighbours, s->memory, s->fluid.count, each, true) ||
            (s->walls_press && !sph2d__neighbours_reserve(&s->wall_neighbours, s->memory, s->walls.count, each, true)))
            return false;
        s->neighbours.lanes = s->wall_neighbours.lanes = sph2d__projection_gather_find(s->isa)->lanes;
        if (sph2d__over_rows(s, gather_slab, NULL).most == 0)
            break;
    }
    sph2d__tension_add(s);
    bool done = sph2d__body_rows_gather(s);
    sph2d__profile_enter(&s->profile, before);
    return done;
}

/* ---- sums over neighbours ---------------------------------------------------------------------------------------- */

static void move_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    (void)sum;
    sph2d__projection_passes_find(s->isa)->move(s, slab->first, slab->last);
}

static void press_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const double *share = with;
    (void)sum;
    sph2d__projection_passes_find(s->isa)->press(s, *share, slab->first, slab->last);
}

void sph2d__projection_next_positions(sph2d__system *s)
{
    sph2d__over_fluid(s, move_slab, NULL, NULL, 0);
    sph2d__body_rows_predict(s);
    put_far(&s->fluid, s->fluid.next_x, s->fluid.next_y);
}

void sph2d__projection_predict(sph2d__system *s, const sph2d__slab *slab)
{
    const sph2d__projection_passes *pass = sph2d__projection_passes_find(s->isa);
    (slab->walls ? pass->predict_walls : pass->predict_fluid)[s->method.kernel](s, slab->first, slab->last);
}

/* ---- pressures and multipliers ----------------------------------------------------------------------------------- */

static void begin_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const double *part = with;
    double factor = *part * s->step * s->step / (s->rest_density * s->moment);
    sph2d__store *t = slab->rows;
    (void)sum;
    for (size_t i = slab->first; i < slab->last; ++i)
        t->direction[i] =
            sph2d__splat(t->multiplier[i] = t->acting_pressure[i] > 0 ? factor * t->acting_pressure[i] : 0);
}

void sph2d__projection_begin(sph2d__system *s, double part)
{
    sph2d__over_rows(s, begin_slab, &part);
}

static void end_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    double factor = s->moment * s->rest_density / (s->step * s->step);
    sph2d__store *t = slab->rows;
    (void)with;
    (void)sum;
    for (size_t i = slab->first; i < slab->last; ++i) {
        t->multiplier[i] = t->multiplier[i] > 0 ? t->multiplier[i] : 0;
        t->acting_pressure[i] = t->pressure[i] = factor * t->multiplier[i];
    }
}

static void average_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    (void)sum;
    sph2d__projection_passes_find(s->isa)->average(s, slab->first, slab->last);
}

void sph2d__projection_end(sph2d__system *s)
{
    const double share = 1 / (s->step * s->step);
    sph2d__over_rows(s, end_slab, NULL);
    sph2d__over_fluid(s, press_slab, &share, NULL, 0);
    sph2d__body_rows_end(s);
}

/** Keeps the acceleration without pressure beside. */
static void keep_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    sph2d__store *f = slab->rows;
    size_t bytes = (slab->last - slab->first) * sizeof(double);
    (void)s;
    (void)with;
    (void)sum;
    memcpy(f->free_ax + slab->first, f->ax + slab->first, bytes);
    memcpy(f->free_ay + slab->first, f->ay + slab->first, bytes);
}

void sph2d__projection_keep(sph2d__system *s)
{
    sph2d__over_fluid(s, keep_slab, NULL, NULL, 0);
}

void sph2d__projection_press(sph2d__system *s)
{
    const double share = 1 / (s->step * s->step);
    sph2d__projection_begin(s, 1);
    sph2d__over_fluid(s, press_slab, &share, NULL, 0);
}

void sph2d__projection_average(sph2d__system *s)
{
    if (s->fluid.capacity > 0) /* of the particle that shorter lists end with */
        s->fluid.acting_pressure[s->fluid.count] = 0;
    sph2d__over_fluid(s, average_slab, NULL, NULL, 0);
}

/* With the gradients as rounded as those that pushed. */
sph2d__wall_force sph2d__projection_wall_force(const sph2d__system *s, size_t i, size_t b, double dx, double dy)
{
    double h2 = s->support * s->support, q = sqrt(dx * dx + dy * dy) / s->support;
    double weight = s->calibration * s->walls.mass[b] / s->rest_density;
    double g =
        weight * sph2d__kernel_constant(s->method.kernel) / (h2 * h2) * sph2d__kernel_slope_at(s->method.kernel, q);
    double press = s->mass / (s->step * s->step) * (s->fluid.multiplier[i] + s->walls.multiplier[b]);
    /* Volatile: GCC 12 with -O3 makes one vector of two conversions to float and back, and drops them. */
    volatile float gx = (float)(g * dx), gy = (float)(g * dy);
    return (sph2d__wall_force){.pressure = {-press * (double)gx, -press * (double)gy}};
}

double sph2d__projection_elastic(const sph2d__system *s, size_t i, bool pressed)
{
    double c2 = s->sound_speed * s->sound_speed, held = s->fluid.density[i] / s->rest_density - 1;
    double unknown = s->method.max_compression;
    if (pressed)
        held = fmin(held, s->fluid.acting_pressure[i] / (s->rest_density * c2));
    return isfinite(c2) && held > unknown ? c2 * (held - unknown) * (held - unknown) / 2 : 0;
}

/* Step limit as a fraction of sqrt(H/a): 0.25 sqrt(h/a) of Monaghan 1992. Viscosity is explicit, too. */
static const double FORCE = 0.18;

/* Part of viscosity.h's step: nothing keeps the particles of these methods apart, and where they stand in clumps the
 * operator's largest eigenvalue is larger. With the whole of it a column of 2 Pa s gained energy at three of five
 * resolutions, with this at none. */
static const double VISCOUS = 2.0 / 3;

double sph2d__projection_step(const sph2d__system *s, double speed, double acceleration, sph2d__limit *limit)
{
    double push = sqrt(s->max_pressure / s->rest_density);
    double nu = s->viscosity / s->rest_density + sph2d__limited_viscosity_of(s);
    return sph2d__shortest_step(s, 0, push > speed ? push : speed, acceleration, nu,
                                VISCOUS * sph2d__viscosity_step(s->method.kernel), FORCE, limit);
}

/** Sums over a filled square lattice of the system's spacing, the particle in the middle included. */
typedef struct lattice_sums {
    double value;  /* of f(q) */
    double moment; /* of -q^2 g(q) */
    double square; /* of (q g(q))^2 */
} lattice_sums;

static lattice_sums sum_lattice(const sph2d__system *s)
{
    int reach = (int)(s->support / s->spacing) + 1;
    lattice_sums sum = {0};
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j) {
            double q = hypot(i, j) * s->spacing / s->support, g = sph2d__kernel_slope_at(s->method.kernel, q);
            sum.value += sph2d__kernel_value_at(s->method.kernel, q);
            sum.moment -= q * q * g;
            sum.square += q * q * g * g;
        }
    return sum;
}

double sph2d__projection_prototype(const sph2d__system *s)
{
    double ratio = s->spacing / s->support;
    double g = s->calibration * sph2d__kernel_constant(s->method.kernel) * ratio * ratio / s->support;
    return g * g * sum_lattice(s).square;
}

/** What a lattice in front of a straight wall adds to the density at a boundary particle, over rest density. */
static double filled_at(const sph2d__system *s, double depth)
{
    int reach = (int)(s->support / s->spacing) + 1;
    double sum = 0, dx = s->spacing;
    for (int row = 0; row <= reach; ++row)
        for (int column = -reach; column <= reach; ++column)
            sum += sph2d__kernel_value_at(s->method.kernel, hypot(column * dx, depth + (row + 0.5) * dx) / s->support);
    double ratio = dx / s->support;
    return s->calibration * sph2d__kernel_constant(s->method.kernel) * ratio * ratio * sum;
}

/** Boundary particles have rows, but in corners, where the surface is not straight. Those of the domain's
 *  sides know the room around them, those of obstacles take their surface for straight. */
static void fill_layers(sph2d__system *s)
{
    sph2d__store *w = &s->walls;
    double scale = s->calibration * sph2d__kernel_constant(s->method.kernel);
    for (size_t b = 0; b < w->count; ++b) {
        bool straight = w->depth[b] > 0 && w->depth[b] < INFINITY;
        double room = w->filled[b];
        w->filled[b] = !straight ? 0 : room > 0 ? scale * room : filled_at(s, w->depth[b]);
    }
}

void sph2d__projection_prepare(sph2d__system *s)
{
    lattice_sums sums = sum_lattice(s);
    double constant = sph2d__kernel_constant(s->method.kernel), ratio = s->spacing / s->support;
    s->calibration = 1 / (ratio * ratio * constant * sums.value);
    s->moment = s->calibration * ratio * ratio * constant * sums.moment / 2;
    fill_layers(s);
}
