/* SPDX-License-Identifier: MIT */
/** @file implicit_viscosity.c
 *  The conjugate gradients of implicit_viscosity.h, with the matrix's diagonal as preconditioner. */
#include "methods/projection/implicit_viscosity.h"

#include <math.h>
#include <string.h>

#include "kernels/kernel.h"
#include "methods/common/slabs.h"
#include "methods/projection/projection.h"
#include "methods/terms/stick.h"
#include "methods/terms/viscosity.h"
#include "simd/lanes.h"

/* What may be left of the equations: of velocities in the mean over the particles, and of the scene's speed. It is no
 * error of momentum, and gone with the next step. */
static const double TOLERANCE = 1e-4, FLOOR = 1e-8;
/* 1 - dt K has condition numbers up to some 10^5: bounds of yield stress in one cell. */
enum { MOST = 1000 };

bool sph2d__viscosity_is_implicit(const sph2d__system *s)
{
    if (s->walls_rough || s->liquid->model != SPH2D_RHEOLOGY_NEWTONIAN)
        return true;
    double nu = s->viscosity / s->rest_density, dt = s->method.time_step;
    if (!(dt > 0))
        dt = s->method.cfl * s->support / sqrt(s->head);
    return nu * dt > sph2d__viscosity_step(s->method.kernel) * s->support * s->support;
}

void sph2d__implicit_viscosity_prepare(sph2d__system *s)
{
    s->implicit.on = sph2d__viscosity_is_implicit(s);
    s->implicit.brake = sph2d__central_weight(s->method.kernel, s->support) / (s->rest_density * s->calibration);
}

/* ---- memory ------------------------------------------------------------------------------------------------------ */

/** Sets the arrays, all in one block. */
static void divide(sph2d__implicit *m)
{
    double **arrays[] = {&m->vx,        &m->vy,        &m->ax,        &m->ay,       &m->rest_x, &m->rest_y,
                         &m->xx,        &m->xy,        &m->yy,        &m->wall_x,   &m->wall_y, &m->inverse_x,
                         &m->inverse_y, &m->product_x, &m->product_y, &m->direction};
    _Static_assert(sizeof arrays / sizeof *arrays == SPH2D__IMPLICIT_ARRAYS, "one block for all of them");
    for (size_t k = 0; k < SPH2D__IMPLICIT_ARRAYS; ++k)
        *arrays[k] = m->block + k * m->capacity;
}

static bool reserve(sph2d__system *s)
{
    sph2d__implicit *m = &s->implicit;
    const sph2d__neighbours *n = &s->neighbours;
    size_t wanted = s->fluid.capacity + SPH2D__PADDING, pairs = sph2d__slabs(n->particles) * SPH2D__SLAB * n->each;
    void *blocks[2] = {m->block, m->dyads};
    bool ok = true;
    if (m->capacity < wanted) {
        ok = sph2d__resize(s->memory, &blocks[0], m->capacity * SPH2D__IMPLICIT_ARRAYS, wanted * SPH2D__IMPLICIT_ARRAYS,
                           sizeof(double));
        m->capacity = ok ? wanted : m->capacity;
    }
    if (ok && m->pairs < pairs) {
        ok = sph2d__resize(s->memory, &blocks[1], m->pairs, pairs, sizeof(double));
        m->pairs = ok ? pairs : m->pairs;
    }
    m->block = blocks[0];
    m->dyads = blocks[1];
    if (m->block)
        divide(m);
    return ok;
}

void sph2d__implicit_viscosity_free(sph2d__system *s)
{
    sph2d__implicit *m = &s->implicit;
    void *blocks[2] = {m->block, m->dyads};
    sph2d__release(s->memory, &blocks[0], m->capacity * SPH2D__IMPLICIT_ARRAYS, sizeof(double));
    sph2d__release(s->memory, &blocks[1], m->pairs, sizeof(double));
}

/* ---- conjugate gradients ----------------------------------------------------------------------------------------- */

/** What the slabs of a loop get. */
typedef struct numbers {
    double dt, share;
} numbers;

static void build_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const numbers *w = with;
    (void)sum;
    sph2d__implicit_viscosity_pass_find(s->isa)->build(s, w->dt, slab->first, slab->last);
}

static void accelerate_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    (void)sum;
    sph2d__implicit_viscosity_pass_find(s->isa)->accelerate(s, slab->first, slab->last);
}

static void multiply_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const numbers *w = with;
    sum->first = sph2d__implicit_viscosity_pass_find(s->isa)->multiply(s, w->dt, slab->first, slab->last);
}

/** Begins at the velocities before the step. */
static void start_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    (void)sum;
    memcpy(s->implicit.vx + slab->first, s->fluid.vx + slab->first, (slab->last - slab->first) * sizeof(double));
    memcpy(s->implicit.vy + slab->first, s->fluid.vy + slab->first, (slab->last - slab->first) * sizeof(double));
}

/** Two floats in the space of a double. */
static double pair_of(double x, double y)
{
    const float both[2] = {(float)x, (float)y};
    double kept;
    memcpy(&kept, both, sizeof kept);
    return kept;
}

static void values_of(double kept, double *x, double *y)
{
    float both[2];
    memcpy(both, &kept, sizeof both);
    *x = both[0];
    *y = both[1];
}

/** What is left of the equations, and the first direction. Sums: left . M left, |left|^2, |v|^2. */
static void residual_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const numbers *w = with;
    const sph2d__store *f = &s->fluid;
    sph2d__implicit *m = &s->implicit;
    for (size_t i = slab->first; i < slab->last; ++i) {
        double x = f->vx[i] + w->dt * (f->ax[i] + m->ax[i]) - m->vx[i];
        double y = f->vy[i] + w->dt * (f->ay[i] + m->ay[i]) - m->vy[i];
        double zx = m->inverse_x[i] * x, zy = m->inverse_y[i] * y;
        m->rest_x[i] = x;
        m->rest_y[i] = y;
        m->direction[i] = pair_of(zx, zy);
        sum->first += x * zx + y * zy;
        sum->second += x * x + y * y;
        sum->third += m->vx[i] * m->vx[i] + m->vy[i] * m->vy[i];
    }
}

/** Goes `share` of the direction. */
static void advance_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const numbers *w = with;
    sph2d__implicit *m = &s->implicit;
    for (size_t i = slab->first; i < slab->last; ++i) {
        double px, py;
        values_of(m->direction[i], &px, &py);
        m->vx[i] += w->share * px;
        m->vy[i] += w->share * py;
        double x = m->rest_x[i] -= w->share * m->product_x[i], y = m->rest_y[i] -= w->share * m->product_y[i];
        sum->first += m->inverse_x[i] * x * x + m->inverse_y[i] * y * y;
        sum->second += x * x + y * y;
        sum->third += m->vx[i] * m->vx[i] + m->vy[i] * m->vy[i];
    }
}

/** The next direction: what is left, and `share` of the last one. */
static void turn_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const numbers *w = with;
    sph2d__implicit *m = &s->implicit;
    (void)sum;
    for (size_t i = slab->first; i < slab->last; ++i) {
        double px, py;
        values_of(m->direction[i], &px, &py);
        m->direction[i] =
            pair_of(m->inverse_x[i] * m->rest_x[i] + w->share * px, m->inverse_y[i] * m->rest_y[i] + w->share * py);
    }
}

/** Solves (1 - dt K) v* = v + dt a; then m->ax is a_v. */
static void solve(sph2d__system *s, double dt)
{
    sph2d__implicit *m = &s->implicit;
    double floor = FLOOR * FLOOR * s->head * (double)s->fluid.count;
    numbers w = {.dt = dt};
    sph2d__over_fluid(s, build_slab, &w);
    sph2d__over_fluid(s, start_slab, NULL);
    m->vx[s->fluid.count] = m->vy[s->fluid.count] = 0; /* of the particle that shorter lists end with */
    sph2d__over_fluid(s, accelerate_slab, NULL);
    sph2d__slab_sum now = sph2d__over_fluid(s, residual_slab, &w);
    for (int k = 0; k < MOST && now.second > TOLERANCE * TOLERANCE * now.third + floor; ++k) {
        m->direction[s->fluid.count] = 0;
        double along = sph2d__over_fluid(s, multiply_slab, &w).first;
        if (!(along > 0)) /* what is left is too small for floats */
            break;
        w.share = now.first / along;
        sph2d__slab_sum next = sph2d__over_fluid(s, advance_slab, &w);
        w.share = next.first / now.first;
        sph2d__over_fluid(s, turn_slab, &w);
        now = next;
        ++m->iterations;
    }
    m->vx[s->fluid.count] = m->vy[s->fluid.count] = 0;
    sph2d__over_fluid(s, accelerate_slab, NULL);
}

/* ---- a step ------------------------------------------------------------------------------------------------------ */

/** Adds a_v to the accelerations without pressure, which are kept beside. */
static void add_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    sph2d__store *f = slab->rows;
    (void)with;
    (void)sum;
    for (size_t i = slab->first; i < slab->last; ++i) {
        f->ax[i] = f->old_ax[i] + s->implicit.ax[i];
        f->ay[i] = f->old_ay[i] + s->implicit.ay[i];
    }
}

bool sph2d__implicit_viscosity_add(sph2d__system *s, double dt)
{
    if (!s->implicit.on || s->fluid.count == 0)
        return true;
    if (!reserve(s))
        return false;
    sph2d__projection_keep(s);
    sph2d__projection_press(s);
    solve(s, dt);
    sph2d__over_fluid(s, add_slab, NULL);
    return true;
}

/** -dt a_v . (v + v+)/2, over mass. */
static void taken_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const numbers *w = with;
    const sph2d__store *f = slab->rows;
    const sph2d__implicit *m = &s->implicit;
    double taken = 0;
    for (size_t i = slab->first; i < slab->last; ++i) {
        double ax = f->ax[i] - w->share * (f->ax[i] - f->old_ax[i]),
               ay = f->ay[i] - w->share * (f->ay[i] - f->old_ay[i]);
        taken -= m->ax[i] * (f->vx[i] + w->dt / 2 * ax) + m->ay[i] * (f->vy[i] + w->dt / 2 * ay);
    }
    sum->first = w->dt * taken;
}

double sph2d__implicit_viscosity_taken(sph2d__system *s, double dt, double split)
{
    if (!s->implicit.on || s->fluid.count == 0)
        return 0;
    return s->mass * sph2d__over_fluid(s, taken_slab, &(numbers){dt, split}).first;
}

sph2d_vec2 sph2d__implicit_friction(const sph2d__system *s, size_t i, size_t b, double dx, double dy)
{
    const sph2d__implicit *m = &s->implicit;
    double r2 = dx * dx + dy * dy, stick = m->on && m->block && r2 > 0 ? sph2d__stick(s, b, dx, dy) : 0;
    if (stick == 0)
        return (sph2d_vec2){0, 0};
    double h2 = s->support * s->support, viscosity = s->viscosities ? s->viscosities[i] : s->viscosity;
    double slope = s->calibration * s->walls.mass[b] / s->rest_density * sph2d__kernel_constant(s->method.kernel) /
                   (h2 * h2) * sph2d__kernel_slope_at(s->method.kernel, sqrt(r2) / s->support);
    double along = (m->vx[i] - s->walls.vx[b]) * dx + (m->vy[i] - s->walls.vy[b]) * dy;
    double force = s->mass * m->brake * viscosity * stick * slope * along;
    return (sph2d_vec2){force * dx, force * dy};
}
