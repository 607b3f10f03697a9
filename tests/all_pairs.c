/* SPDX-License-Identifier: MIT */
/** @file all_pairs.c
 *  The cloud and the sums of all_pairs.h. */
#include "all_pairs.h"

#include <math.h>

static const double FINE = 1e-10;

/** t to the power n, 0 where t is negative. */
static double power(double t, int n)
{
    return t > 0 ? pow(t, n) : 0;
}

double weight(sph2d_kernel kernel, double support, double r)
{
    double q = r / support, s = 3 * q, area = TEST_PI * support * support;
    switch (kernel) {
    case SPH2D_KERNEL_WENDLAND_C2:
        return 7 / area * power(1 - q, 4) * (1 + 4 * q);
    case SPH2D_KERNEL_WENDLAND_C4:
        return 9 / area * power(1 - q, 6) * (1 + 6 * q + 35.0 / 3 * q * q);
    case SPH2D_KERNEL_WENDLAND_C6:
        return 78 / (7 * area) * power(1 - q, 8) * (1 + 8 * q + 25 * q * q + 32 * q * q * q);
    case SPH2D_KERNEL_CUBIC:
        return 40 / (7 * area) * (power(2 - 2 * q, 3) / 4 - power(1 - 2 * q, 3));
    case SPH2D_KERNEL_QUINTIC:
        return 63 / (478 * area) * (power(3 - s, 5) - 6 * power(2 - s, 5) + 15 * power(1 - s, 5));
    }
    return NAN;
}

/** grad W = slope r_ij; the splines' slope has no value at 0, where it is not asked for. */
static double slope(sph2d_kernel kernel, double support, double r)
{
    double q = r / support, s = 3 * q, h4 = TEST_PI * pow(support, 4);
    switch (kernel) {
    case SPH2D_KERNEL_WENDLAND_C2:
        return -7 / h4 * 20 * power(1 - q, 3);
    case SPH2D_KERNEL_WENDLAND_C4:
        return -9 / h4 * 56.0 / 3 * power(1 - q, 5) * (1 + 5 * q);
    case SPH2D_KERNEL_WENDLAND_C6:
        return -78 / (7 * h4) * 22 * power(1 - q, 7) * (1 + 7 * q + 16 * q * q);
    case SPH2D_KERNEL_CUBIC:
        return r > 0 ? -40 / (7 * h4) * (1.5 * power(2 - 2 * q, 2) - 6 * power(1 - 2 * q, 2)) / q : 0;
    case SPH2D_KERNEL_QUINTIC:
        return r > 0 ? -63 / (478 * h4) * 15 * (power(3 - s, 4) - 6 * power(2 - s, 4) + 15 * power(1 - s, 4)) / q : 0;
    }
    return NAN;
}

sph2d_scene scene;
sph2d_block block;
static sph2d_sim *sim;

void start(void)
{
    scene = test_open_scene(DX, -1, -1, 1, 1);
    block = test_block(0, 0, SIDE * DX, SIDE * DX);
    block.perturb.amplitude = 0.3;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.method.sound_speed = C0;
    scene.method.density_diffusion = 0;
    scene.method.shifting = 0;
    scene.method.tensile_control = SPH2D_SWITCH_OFF;
    scene.method.turbulence = SPH2D_TURBULENCE_NONE;
}

void finish(void)
{
    sph2d_sim_destroy(sim);
    sim = NULL;
}

sph2d__system *make(sph2d_isa isa)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    options.isa = isa;
    sim = test_create(&scene, &options);
    sph2d__store *f = &sim->system.fluid;
    uint64_t seed = 3;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = test_random(&seed, -1, 1);
        f->vy[i] = test_random(&seed, -1, 1);
        f->density[i] = RHO0 * test_random(&seed, 0.97, 1.03);
        f->volume[i] = sim->system.mass / f->density[i];
        if (f->stretch) {
            f->stretch[i] = test_random(&seed, -5, 5);
            f->shear[i] = test_random(&seed, -5, 5);
        }
    }
    return &sim->system;
}

other other_of(const sph2d__system *s, size_t i, const sph2d__store *from, size_t j)
{
    const sph2d__store *f = &s->fluid;
    bool liquid = from == f;
    const sph2d__period *period = &s->fluid_cells.period;
    other o = {.dx = sph2d__period_nearest(f->x[i] - from->x[j], period->length_x),
               .dy = sph2d__period_nearest(f->y[i] - from->y[j], period->length_y)};
    o.r = hypot(o.dx, o.dy);
    o.vx = f->vx[i] - (liquid ? from->vx[j] : from->image_vx[j]);
    o.vy = f->vy[i] - (liquid ? from->vy[j] : from->image_vy[j]);
    o.mass = liquid ? s->mass : from->mass[j];
    o.density = from->density[j];
    o.pressure = from->pressure[j];
    o.slope = slope(s->method.kernel, s->support, o.r);
    o.weight = weight(s->method.kernel, s->support, o.r);
    return o;
}

void close_to(double value, double expect, double size, const char *what, size_t i)
{
    ck_assert_msg(fabs(value - expect) <= FINE * size, "%s of particle %zu: %.15g, not %.15g", what, i, value, expect);
}

double slides(const sph2d__system *s, size_t b, sph2d_vec2 *along)
{
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    double weights = 0, filling = 0, vx = 0, vy = 0;
    *along = (sph2d_vec2){0, 0};
    for (size_t j = 0; j < f->count; ++j) {
        other o = other_of(s, j, w, b);
        weights += o.weight;
        filling += o.weight * f->filling[j];
        vx += o.weight * (f->vx[j] - w->vx[b]);
        vy += o.weight * (f->vy[j] - w->vy[b]);
    }
    if (!(weights > 0) || s->wall_slip != SPH2D_SLIP_FREE || w->bounce[b] >= 0)
        return 0;
    double t = fmin(fmax((0.85 - filling / weights) / 0.25, 0), 1);
    *along = (sph2d_vec2){-w->normal_y[b], w->normal_x[b]};
    const sph2d__period *period = &s->fluid_cells.period;
    double front = weight(s->method.kernel, s->support, 0), all = front;
    for (size_t j = 0; j < w->count; ++j) {
        double dx = sph2d__period_nearest(w->x[j] - w->x[b], period->length_x);
        double dy = sph2d__period_nearest(w->y[j] - w->y[b], period->length_y);
        if (dx * w->normal_x[b] + dy * w->normal_y[b] > w->depth[b])
            front -= w->mass[j] / s->mass * weight(s->method.kernel, s->support, hypot(dx, dy));
    }
    double past = (vx * along->x + vy * along->y) / weights, ringing = 0.002 * C0;
    return fmax(front / all, 0) * t * t * (3 - 2 * t) * past * past / (past * past + ringing * ringing);
}

/** What eddies damp of v_ij . r_ij, between two particles of the liquid. */
static double rough_part(const sph2d__store *f, size_t i, size_t j, const other *o)
{
    double jump = o->vx * o->dx + o->vy * o->dy;
    double linear = (f->stretch[i] + f->stretch[j]) / 2 * (o->dx * o->dx - o->dy * o->dy) +
                    (f->shear[i] + f->shear[j]) * o->dx * o->dy;
    return copysign(fmin(fabs(jump), 4 * fabs(jump - linear)), jump);
}

/** The integral of W r^2 over the plane. */
static double mean_square(const sph2d__system *s)
{
    enum { RINGS = 2000 };
    double sum = 0, width = s->support / RINGS;
    for (int k = 0; k < RINGS; ++k) {
        double r = (k + 0.5) * width;
        sum += 2 * TEST_PI * width * r * r * r * weight(s->method.kernel, s->support, r);
    }
    return sum;
}

/** Pair by pair: pressure, the three viscosities, and the eddies'. */
static void force_of(const sph2d__system *s, size_t i, const sph2d__store *from, double a[2], double *size)
{
    const sph2d__store *f = &s->fluid;
    bool morris = s->method.viscosity_form == SPH2D_VISCOSITY_MORRIS;
    double h = s->support / 2, mu = s->viscosity, rho = f->density[i];
    double artificial = RHO0 * s->method.artificial_viscosity * C0 * h / 8, filter = 0.15 * 4 * h;
    const double spread = 2 * mean_square(s);
    bool eddies = s->method.turbulence == SPH2D_TURBULENCE_SMAGORINSKY && from == f;
    for (size_t j = 0; j < from->count; ++j) {
        other o = other_of(s, i, from, j);
        if (o.r == 0 || o.slope == 0)
            continue;
        double push = -o.mass * (f->pressure[i] / (rho * rho) + o.pressure / (o.density * o.density)) * o.slope;
        double drag = morris ? o.mass * 2 * mu / (rho * o.density) * o.slope : 0; /* r . r slope / r^2 */
        double small =
            eddies ? RHO0 * filter * filter * (hypot(f->stretch[i], f->shear[i]) + hypot(f->stretch[j], f->shear[j]))
                   : 0;
        double jump = o.vx * o.dx + o.vy * o.dy, damped = (morris ? 0 : mu) * jump / spread;
        damped += (artificial * jump + (eddies ? small * rough_part(f, i, j, &o) : 0)) / (o.r * o.r);
        double damp = 8 * damped / rho * o.mass / o.density * o.slope;
        if (from != f && s->wall_slip == SPH2D_SLIP_FREE)
            drag = damp = 0;
        a[0] += push * o.dx + drag * o.vx + damp * o.dx;
        a[1] += push * o.dy + drag * o.vy + damp * o.dy;
        *size += fabs(push) * o.r + fabs(drag) * hypot(o.vx, o.vy) + fabs(damp) * o.r;
    }
}

/** Where liquid slides, a wall's pressure has no part along it, but what pressure of the liquid pushes there. */
static void slide_of(const sph2d__system *s, size_t i, double a[2], double *size)
{
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    for (size_t b = 0; b < w->count; ++b) {
        sph2d_vec2 along = {0, 0};
        other o = other_of(s, i, w, b);
        double part = o.r < s->support ? slides(s, b, &along) : 0, weights = 0, push = 0;
        if (part == 0)
            continue;
        for (size_t j = 0; j < f->count; ++j) {
            other p = other_of(s, j, w, b);
            weights += p.weight;
            push += f->pressure[j] / (f->density[j] * f->density[j]) * p.slope * (p.dx * along.x + p.dy * along.y);
        }
        double wall = o.pressure / (o.density * o.density) * o.slope * (o.dx * along.x + o.dy * along.y);
        double sum = part * o.mass * (wall + o.weight * push / weights);
        a[0] += sum * along.x;
        a[1] += sum * along.y;
        *size += part * o.mass * (fabs(wall) + fabs(o.weight * push / weights));
    }
}

void check_forces(sph2d__system *s)
{
    for (size_t i = 0; i < s->fluid.count; ++i) {
        double a[2] = {s->body.gravity_x, s->body.gravity_y}, size = 0;
        force_of(s, i, &s->fluid, a, &size);
        force_of(s, i, &s->walls, a, &size);
        slide_of(s, i, a, &size);
        close_to(s->fluid.ax[i], a[0], size, "ax", i);
        close_to(s->fluid.ay[i], a[1], size, "ay", i);
    }
}
