/* SPDX-License-Identifier: MIT */
/** @file openings_prescribe.c
 *  What an opening prescribes to the particles of its reservoir, and the stages of a step that hold them to it. */
#include <math.h>

#include "base/pi.h"
#include "methods/common/state_equation.h"
#include "sim/openings_parts.h"
#include "sim/simulation.h"

/** Sound in liquid with a surface has none of its pressure there: as in the slowest wave of a layer on a floor. */
static double sound_part(const sph2d__opening *o, size_t k)
{
    if (!o->has_surface)
        return 1;
    double depth = fmax(o->now.depth, o->now.fed), height = ((double)k + 0.5) * o->lane_width;
    return depth > height ? sin(SPH2D__PI / 2 * (1 - height / depth)) : 0;
}

/** The velocity of a lane with a pressure: that before it. One that is dry beside a level goes as the others, in or out:
 *  liquid that a wave has brought above the level would stay in the reservoir for ever, and dam up what follows. Where all
 *  are dry, as much liquid comes as when a dam breaks, 8/27 sqrt(g d) d (Ritter 1892). */
static double lane_velocity(const sph2d_sim *sim, const sph2d__opening *o, size_t k)
{
    if (o->lanes[k].wet || o->kind != SPH2D__OPENING_LEVEL)
        return o->lanes[k].inward;
    if (o->wet)
        return o->now.velocity;
    return 8.0 / 27 * sqrt(hypot(sim->record.gravity_x, sim->record.gravity_y) * o->now.fed);
}

/** With fitted operators a reservoir does not press on what is before it pair by pair: its velocity is that by which
 *  p' - rho0 c0 u, which leaves, meets the pressure given. Without this 5 % of rho U^2 stayed before the end of a channel
 *  40 spacings across, and more of the energy was unaccounted for: 1.1 instead of 0.2 % of its scale. */
static double leaving_velocity(const sph2d_sim *sim, const sph2d__opening *o, size_t k, double pressure)
{
    const sph2d__lane *lane = &o->lanes[k];
    double at_line = pressure - o->means->slope * o->duct;
    bool fitted = sim->system.method.operators == SPH2D_OPERATORS_FITTED;
    return fitted && lane->wet ? (at_line - lane->pressure) / (sim->system.rest_density * sim->system.sound_speed) : 0;
}

/** What a lane prescribes at its line: velocity inwards and sidewards, pressure p', and its slope. */
static void lane_values(const sph2d_sim *sim, const sph2d__opening *o, size_t k, double part, double values[4])
{
    const sph2d__lane *lane = &o->lanes[k];
    double impedance = sim->system.rest_density * sim->system.sound_speed;
    /* Over steps that do not resolve sound there is none: what answers to it a step later makes more of it. */
    bool known = o->means->age > 0 && sim->world.scene.method.name != SPH2D_METHOD_CONSTRAINT;
    if (!o->has_velocity) {
        double sound = known ? -impedance * (o->now.velocity - o->means->velocity) : 0;
        double pressure = o->value + sound_part(o, k) * sound;
        values[0] += part * (lane_velocity(sim, o, k) + leaving_velocity(sim, o, k, pressure));
        values[1] += part * (lane->inward < 0 ? lane->sideward : 0);
        values[2] += part * pressure;
    } else {
        values[0] += part * (known ? -(o->now.pressure - o->means->pressure) / impedance : 0);
        values[2] += part * lane->pressure;
    }
    if (o->kind != SPH2D__OPENING_LEVEL) /* of a surface the slope before the line is that of waves: outside is none */
        values[3] += part * o->means->slope;
}

/* Between the middles of two lanes all changes linearly. */
sph2d__prescribed sph2d__prescribed_at(const sph2d_sim *sim, const sph2d__opening *o, sph2d__spot at, double x,
                                       double y)
{
    double lane = fmin(fmax(at.along / o->lane_width - 0.5, 0), (double)o->lane_count - 1);
    size_t k = (size_t)lane, next = k + 1 < o->lane_count ? k + 1 : k;
    double part = lane - (double)k, values[4] = {0};
    lane_values(sim, o, k, 1 - part, values);
    lane_values(sim, o, next, part, values);
    if (o->has_velocity)
        values[0] += sph2d__opening_velocity_at(&o->mouth, o->given, o->value, at.along, sim->record.time);
    double pressure = values[2] - values[3] * (at.beyond + o->duct) + sph2d__rest_pressure(sim, o, x, y);
    double aside = fmax(1 - at.beyond / sim->system.support, 0);
    const sph2d__system *s = &sim->system;
    double least = s->rest_density * s->sound_speed * s->sound_speed * s->method.max_compression; /* without a bound */
    return (sph2d__prescribed){values[0], aside * values[1], sph2d__density_of(s, fmax(pressure, -least))};
}

static double energy_of(const sph2d_sim *sim, size_t i)
{
    const sph2d__store *f = &sim->system.fluid;
    return sim->system.mass * ((f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i]) / 2 + sph2d__sim_elastic_of(sim, i));
}

void sph2d__opening_set_particle(sph2d_sim *sim, const sph2d__opening *o, size_t i)
{
    sph2d__store *f = &sim->system.fluid;
    sph2d__prescribed p = sph2d__prescribed_at(sim, o, sph2d__spot_of(o, f->x[i], f->y[i]), f->x[i], f->y[i]);
    f->vx[i] = p.inward * o->mouth.inward.x + p.sideward * o->mouth.along.x;
    f->vy[i] = p.inward * o->mouth.inward.y + p.sideward * o->mouth.along.y;
    f->density[i] = p.density;
    if (sim->method->take_density)
        sim->method->take_density(&sim->system, i);
}

void sph2d__openings_impose(sph2d_sim *sim)
{
    if (sim->openings.count == 0)
        return;
    sph2d__openings_measure(sim);
    for (size_t i = 0; i < sim->system.fluid.count; ++i) {
        const sph2d__opening *o = sph2d__opening_at(sim, sim->system.fluid.x[i], sim->system.fluid.y[i]);
        if (!o)
            continue;
        double before = energy_of(sim, i);
        sph2d__opening_set_particle(sim, o, i);
        sim->record.energy_fed += energy_of(sim, i) - before;
    }
}

/** Power of pressure at the line of an opening on the liquid before it [W/m]. */
static double power_at_line(const sph2d_sim *sim, const sph2d__opening *o)
{
    double power = 0;
    for (size_t k = 0; k < o->lane_count; ++k) {
        sph2d_vec2 at = sph2d__place_of(o, (sph2d__spot){((double)k + 0.5) * o->lane_width, 0});
        double pressure = o->lanes[k].pressure + sph2d__rest_pressure(sim, o, at.x, at.y);
        power += o->lanes[k].wet ? o->lane_width * pressure * o->lanes[k].inward : 0;
    }
    return power;
}

void sph2d__openings_hold_rates(sph2d_sim *sim, double dt)
{
    sph2d__store *f = &sim->system.fluid;
    const double *b = sim->weights;
    for (size_t i = 0; sim->openings.count > 0 && i < f->count; ++i) {
        if (!sph2d__opening_at(sim, f->x[i], f->y[i]))
            continue;
        f->shift_ax[i] = -(b[0] * f->ax[i] + b[1] * f->old_ax[i] + b[2] * f->older_ax[i]);
        f->shift_ay[i] = -(b[0] * f->ay[i] + b[1] * f->old_ay[i] + b[2] * f->older_ay[i]);
        f->shift_density_rate[i] =
            -(b[0] * f->density_rate[i] + b[1] * f->old_density_rate[i] + b[2] * f->older_density_rate[i]);
        f->shift_x[i] = f->shift_ax[i] * dt / 2;
        f->shift_y[i] = f->shift_ay[i] * dt / 2;
    }
    for (size_t k = 0; k < sim->openings.count; ++k)
        sim->record.energy_fed += dt * power_at_line(sim, &sim->openings.items[k]);
}
