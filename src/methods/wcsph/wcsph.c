/* SPDX-License-Identifier: MIT */
/** @file wcsph.c
 *  Method `wcsph` with symmetric operators: setup, order of the passes, step limits. The pair loops are in *_pass.c. */
#include "methods/wcsph/wcsph.h"

#include <math.h>

#include "kernels/kernel.h"
#include "methods/common/packed.h"
#include "methods/common/state_equation.h"
#include "methods/terms/friction.h"
#include "methods/terms/rheology.h"
#include "methods/terms/stable_step.h"
#include "methods/terms/stick.h"
#include "methods/terms/tension.h"
#include "methods/terms/viscosity.h"

/* Step limit as a fraction of sqrt(H/a). */
static const double FORCE = 0.25;

/** Runs a pass in the system's precision and kernel over the particles of a store. */
static void run(sph2d__system *s, const sph2d__store *store, const sph2d__wcsph_pass *in_doubles,
                const sph2d__wcsph_pass *mixed)
{
    const sph2d__wcsph_pass *pass = s->method.precision == SPH2D_PRECISION_MIXED ? mixed : in_doubles;
    sph2d__over_particles(s, store->count, pass->by_kernel[s->method.kernel]);
}
#define RUN(pass, s, store)                                                                                            \
    run(s, store, sph2d__wcsph_##pass##_find((s)->isa), sph2d__wcsph_##pass##_find_mixed((s)->isa))

/* Lattice sites on either side of a particle within the widest support. */
enum { REACH = 8 };

/** Sum of f, weighted with mass, over the boundary particles in front of the surface of b. */
static double sum_in_front(const sph2d__system *s, size_t b)
{
    const sph2d__store *w = &s->walls;
    uint32_t cell = sph2d__cells_find(&s->wall_cells, w->x[b], w->y[b]);
    double sum = 0;
    if (cell == UINT32_MAX)
        return 0;
    sph2d__ranges ranges;
    sph2d__cells_ranges(&s->wall_cells, cell, &ranges);
    for (int r = 0; r < ranges.count; ++r)
        for (size_t j = ranges.begin[r]; j < ranges.end[r]; ++j) {
            double dx = w->x[j] - w->x[b] - ranges.x[r], dy = w->y[j] - w->y[b] - ranges.y[r];
            if (dx * w->normal_x[b] + dy * w->normal_y[b] > w->depth[b])
                sum += sph2d__kernel_value_at(s->method.kernel, hypot(dx, dy) / s->support) * w->mass[j] / s->mass;
        }
    return sum;
}

static void set_some_fronts(sph2d__system *s, size_t first, size_t last)
{
    for (size_t b = first; b < last; ++b)
        s->walls.front[b] = fmax(1 - sum_in_front(s, b) / sph2d__kernel_value_at(s->method.kernel, 0), 0);
}

static void walls_placed(sph2d__system *s)
{
    sph2d__over_particles(s, s->walls.count, set_some_fronts);
}

/* The largest rate at which liquid that sticks to walls pair by pair is damped, a quarter of a spacing from them, is up
 * to 4 times that inside (stick.h); where viscosity is within 8 times of limiting the step, images are those of the mean
 * (wall_pair.h). Layers that matter are wider than H there, and those that do not, after a sudden start, are braked too
 * much pair by pair: between a shaft and a drum (examples/annulus, 10 across) errors are 3 % with 4, 0.6 % with 8. */
static const double STICKING_RATE = 8;

/** Whether liquid sticks to rough walls pair by pair. */
static bool sticks(const sph2d__system *s)
{
    if (!s->walls_rough || s->viscosities || s->method.viscosity_form != SPH2D_VISCOSITY_MORRIS)
        return false;
    double step = fmax(s->method.cfl * s->support / s->sound_speed, s->method.time_step);
    double viscous = sph2d__viscosity_step(s->method.kernel) * s->support * s->support;
    return STICKING_RATE * step * sph2d__viscosity_limiting(s) < viscous;
}

static void prepare(sph2d__system *s)
{
    double q = s->spacing / s->support, unit = sph2d__kernel_value_at(s->method.kernel, q);
    s->lattice_values = s->lattice_slopes = 0;
    for (int i = -REACH; i <= REACH; ++i)
        for (int j = -REACH; j <= REACH; ++j) {
            double r = hypot(i, j) * q;
            s->lattice_values += sph2d__kernel_value_at(s->method.kernel, r) / unit;
            if (i != 0 || j != 0)
                s->lattice_slopes += sph2d__kernel_slope_at(s->method.kernel, r);
        }
    walls_placed(s);
    s->central_weight = sph2d__central_weight(s->method.kernel, s->support);
    bool varies = s->liquid->model != SPH2D_RHEOLOGY_NEWTONIAN && s->method.viscosity_form == SPH2D_VISCOSITY_MONAGHAN;
    s->viscosity_limits = varies || sph2d__viscosity_limits(s);
    s->walls_stick = sticks(s);
}

/** Whether density diffusion has Fourtakas' form, of the excess over hydrostatic density. */
static bool diffuses_excess(const sph2d_method_options *m)
{
    return m->density_diffusion > 0 && m->diffusion_form == SPH2D_DIFFUSION_FOURTAKAS;
}

/** Work of gravity, the central force and the centrifugal force of a tank from the domain's corner to (x, y) [m^2/s^2]: times rho0/c0^2 it is the
 *  hydrostatic density there, up to a constant. None in periodic directions. */
static double work_from(const sph2d__system *s, double x, double y)
{
    const sph2d__period *p = &s->fluid_cells.period;
    const sph2d__body *b = &s->body;
    double gx = p->length_x > 0 ? 0 : b->gravity_x + b->frame.uniform.x;
    double gy = p->length_y > 0 ? 0 : b->gravity_y + b->frame.uniform.y;
    double rx = x - b->center_x, ry = y - b->center_y, sx = x - b->frame.center.x, sy = y - b->frame.center.y;
    return gx * (x - p->low_x) + gy * (y - p->low_y) - b->central_rate2 / 2 * (rx * rx + ry * ry) +
           b->frame.omega * b->frame.omega / 2 * (sx * sx + sy * sy);
}

/** Sets volumes, in the precision in which pair loops read them. */
static void set_some_volumes(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    float *floats = sph2d__packed_volume(f);
    if (floats)
        for (size_t i = first; i < last; ++i)
            floats[i] = (float)(s->mass / f->density[i]);
    else
        for (size_t i = first; i < last; ++i)
            f->volume[i] = s->mass / f->density[i];
}

/** The excess over hydrostatic density, which diffuses in Fourtakas' form. */
static double excess_of(const sph2d__system *s, size_t i)
{
    const sph2d__store *f = &s->fluid;
    double c2 = s->sound_speed * s->sound_speed;
    return f->density[i] - s->rest_density * (1 + work_from(s, f->x[i], f->y[i]) / c2);
}

/** Sets volumes and excess densities. */
static void set_some_excesses(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    float *floats = sph2d__packed_excess(f);
    set_some_volumes(s, first, last);
    if (!diffuses_excess(&s->method))
        return;
    if (floats)
        for (size_t i = first; i < last; ++i)
            floats[i] = (float)excess_of(s, i);
    else
        for (size_t i = first; i < last; ++i)
            f->excess[i] = excess_of(s, i);
}

/** Sets volumes and pressures. */
static void set_some_pressures(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid;
    float *floats = sph2d__packed_pressure(f);
    set_some_volumes(s, first, last);
    for (size_t i = first; i < last; ++i)
        f->pressure[i] = sph2d__pressure_of(s, f->density[i]);
    if (floats)
        for (size_t i = first; i < last; ++i)
            floats[i] = (float)f->pressure[i];
}

static void density_rate(sph2d__system *s)
{
    sph2d_phase before = sph2d__profile_enter(&s->profile, s->walls_press ? SPH2D_PHASE_WALLS : SPH2D_PHASE_DENSITY);
    sph2d__over_particles(s, s->fluid.count, set_some_excesses);
    sph2d__pack_fluid_rates(s);
    if (s->walls_press) {
        RUN(wall_rate, s, &s->walls);
        sph2d__pack_wall_rates(s);
    }
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_DENSITY);
    RUN(rate, s, &s->fluid);
    sph2d__profile_enter(&s->profile, before);
}

static bool evaluate(sph2d__system *s)
{
    sph2d_phase before = sph2d__profile_enter(&s->profile, s->walls_press ? SPH2D_PHASE_WALLS : SPH2D_PHASE_FORCES);
    sph2d__over_particles(s, s->fluid.count, set_some_pressures);
    s->walls_stick = sticks(s); /* viscosity may have been changed */
    if (!sph2d__rheology_set(s))
        return false;
    sph2d__pack_fluid(s);
    if (s->walls_press) {
        RUN(wall, s, &s->walls);
        if (s->rigid_count > 0) {
            if (!sph2d__wcsph_move_bodies(s))
                return false;
            RUN(wall, s, &s->walls);
        }
        sph2d__pack_walls(s);
        sph2d__friction_set(s);
    }
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_FORCES);
    s->viscous_rate = 0;
    RUN(force, s, &s->fluid);
    sph2d__friction_add(s);
    sph2d__tension_add(s);
    sph2d__profile_enter(&s->profile, before);
    return true;
}

/** Where the wall slips, the part of the force along (along_x, along_y) is exerted by liquid, not by the wall. */
static sph2d__wall_force wall_force(const sph2d__system *s, size_t i, size_t b, double dx, double dy)
{
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    double h2 = s->support * s->support, r2 = dx * dx + dy * dy;
    double g = sph2d__kernel_constant(s->method.kernel) / (h2 * h2) *
               sph2d__kernel_slope_at(s->method.kernel, sqrt(r2) / s->support);
    double vi = s->mass / f->density[i], vb = w->mass[b] / w->density[b], mass = w->mass[b];
    double own = f->pressure[i] + s->background, theirs = w->pressure[b] + s->background;
    if (s->rigid_count == 0 &&
        f->acting_pressure) /* with bodies walls feel the pressure itself, and before the liquid does */
        own = f->acting_pressure[i];
    double press = mass > 0 ? own * vi * vi * mass / s->mass + theirs * vb * vb * s->mass / mass : 0;
    double push = -g * press, slip = push * (dx * w->along_x[b] + dy * w->along_y[b]);
    sph2d__wall_force force = {.pressure = {push * dx - slip * w->along_x[b], push * dy - slip * w->along_y[b]}};
    force.friction = sph2d__friction_of(s, b, dx, dy);
    if (sph2d__slip_of(s, b) != SPH2D_SLIP_NONE)
        return force;
    sph2d_vec2 jump = {f->vx[i] - w->image_vx[b], f->vy[i] - w->image_vy[b]};
    double bent = 0;
    if (s->walls_stick) {
        jump = sph2d__stick_jump(s, b, sph2d__stick(s, b, dx, dy), dx, dy, jump.x, jump.y);
        bent = -s->mass * vb * g * sph2d__bend(s, b, dx, dy);
    }
    force.friction = sph2d__viscosity_force(sph2d__viscosity_at(s, i), vi * vb * g, dx, dy, jump.x, jump.y);
    if (s->walls_stick) {
        force.friction.x += bent * f->image_vx[i];
        force.friction.y += bent * f->image_vy[i];
    }
    return force;
}

static double stable_step(const sph2d__system *s, double speed, double acceleration, sph2d__limit *limit)
{
    double sound_speed = sqrt(sph2d__sound_speed2_at(s, s->max_density));
    double nu = sph2d__viscosity_limiting(s), viscous = sph2d__viscosity_step(s->method.kernel);
    double dt = sph2d__shortest_step(s, sound_speed, speed, acceleration, nu, viscous, FORCE, limit);
    if (dt * s->viscous_rate > 1) {
        dt = 1 / s->viscous_rate;
        *limit = SPH2D__LIMIT_VISCOUS;
    }
    return dt;
}

/** The arrays of the strain rate. */
#define STRAINS (SPH2D__BIT(stretch) | SPH2D__BIT(shear))

static sph2d__set unused(const sph2d_method_options *m)
{
    sph2d__detail detail = sph2d__wcsph_detail(m);
    sph2d__set gradients = SPH2D__BIT(density_grad_x) | SPH2D__BIT(density_grad_y), excess = SPH2D__BIT(excess);
    sph2d__set surface =
        SPH2D__BIT(min_eigenvalue) | SPH2D__BIT(surface_distance) | SPH2D__BIT(packing) | SPH2D__BIT(acting_pressure);
    sph2d__set shifts = SPH2D__BIT(shift_x) | SPH2D__BIT(shift_y);
    sph2d__set concentration = SPH2D__BIT(grad_c_x) | SPH2D__BIT(grad_c_y) | shifts | STRAINS;
    sph2d__set drags = SPH2D__BIT(image_vx) | SPH2D__BIT(image_vy);
    bool floats = m->precision == SPH2D_PRECISION_MIXED;
    return (detail < SPH2D__DETAIL_GRADIENT ? gradients : 0) | (detail < SPH2D__DETAIL_EIGENVALUE ? surface : 0) |
           (detail < SPH2D__DETAIL_SHIFT ? concentration : 0) | (floats || !diffuses_excess(m) ? excess : 0) |
           (floats ? SPH2D__BIT(volume) : 0) | (m->viscosity_form != SPH2D_VISCOSITY_MORRIS ? drags : 0);
}

const sph2d__method sph2d__wcsph = {
    .name = "wcsph",
    .step = sph2d__midpoint,
    .fluid = SPH2D__STORE_BASIC | SPH2D__BIT(ax) | SPH2D__BIT(ay) | SPH2D__BIT(old_ax) | SPH2D__BIT(old_ay) |
             SPH2D__BIT(density) | SPH2D__BIT(pressure) | SPH2D__BIT(volume) | SPH2D__BIT(density_rate) |
             SPH2D__BIT(density_grad_x) | SPH2D__BIT(density_grad_y) | SPH2D__BIT(grad_c_x) | SPH2D__BIT(grad_c_y) |
             SPH2D__BIT(shift_x) | SPH2D__BIT(shift_y) | SPH2D__BIT(min_eigenvalue) | SPH2D__BIT(surface_distance) |
             SPH2D__BIT(excess) | SPH2D__BIT(filling) | SPH2D__BIT(packing) | SPH2D__BIT(acting_pressure) | STRAINS |
             SPH2D__BIT(image_vx) | SPH2D__BIT(image_vy),
    .unused = unused,
    .carried = SPH2D__STORE_BASIC | SPH2D__BIT(ax) | SPH2D__BIT(ay) | SPH2D__BIT(density) | SPH2D__BIT(density_grad_x) |
               SPH2D__BIT(density_grad_y) | SPH2D__BIT(grad_c_x) | SPH2D__BIT(grad_c_y) | SPH2D__BIT(min_eigenvalue) |
               SPH2D__BIT(surface_distance) | SPH2D__BIT(filling) | SPH2D__BIT(packing) | STRAINS,
    .walls = SPH2D__STORE_BASIC | SPH2D__BIT(normal_x) | SPH2D__BIT(normal_y) | SPH2D__BIT(ax) | SPH2D__BIT(ay) |
             SPH2D__BIT(start_x) | SPH2D__BIT(start_y) | SPH2D__BIT(mass) | SPH2D__BIT(bounce) | SPH2D__BIT(density) |
             SPH2D__BIT(pressure) | SPH2D__BIT(volume) | SPH2D__BIT(image_vx) | SPH2D__BIT(image_vy) |
             SPH2D__BIT(wall_rate) | SPH2D__BIT(depth) | SPH2D__BIT(front) | SPH2D__BIT(along_x) | SPH2D__BIT(along_y) |
             SPH2D__BIT(slide) | SPH2D__BIT(skin) | SPH2D__BIT(drag),
    .prepare = prepare,
    .walls_placed = walls_placed,
    .evaluate = evaluate,
    .density_rate = density_rate,
    .wall_force = wall_force,
    .couples_bodies = true,
    .stable_step = stable_step,
};
