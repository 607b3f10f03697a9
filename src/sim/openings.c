/* SPDX-License-Identifier: MIT */
/** @file openings.c
 *  Reservoirs: made, measured before their lines, held to what is prescribed, fed. */
#include "sim/openings.h"

#include <math.h>
#include <string.h>

#include "methods/common/state_equation.h"
#include "sim/simulation.h"

/* How far before the line velocity and pressure are measured, and the slope of pressure; and how far along it [spacings].
 * Weights fall linearly to 0 there. */
static const double VALUES = 2.5, SLOPES = 4, BESIDE = 1;

/* T in 2 L/c0. For openings with a pressure it acts like the inertia of liquid c0 T long, which slows down what starts from
 * rest; for those with a velocity like the compression of as much. A stream that is set in motion within a second has
 * pressures of 0.6, 0.02, 0.007 rho U^2 in the next three; with 1/4 and 1/16 of 0.68, 0.32, 0.1, with 4 and 1/16 of
 * 0.22, 0.1, 0.025. */
static const double PERIODS = 1, PERIODS_OF_PRESSURE = 1.0 / 16;

/* ---- making ------------------------------------------------------------------------------------------------------ */

/** Sets the line at a distance beyond the side. */
static void set_line(const sph2d_sim *sim, sph2d__opening *o, double beyond)
{
    sph2d__mouth m = sph2d__opening_mouth(&sim->given, o->given);
    o->middle = (sph2d_vec2){m.start.x + m.width / 2 * m.along.x, m.start.y + m.width / 2 * m.along.y};
    m.start = (sph2d_vec2){m.start.x - beyond * m.inward.x, m.start.y - beyond * m.inward.y};
    o->mouth = m;
}

static bool make_lanes(sph2d_sim *sim, sph2d__opening *o)
{
    double dx = sim->scene.spacing;
    o->velocity = sph2d__opening_velocity(&sim->given, o->given);
    o->duct = isnan(o->velocity) ? SPH2D__DUCT * dx : 0;
    set_line(sim, o, o->duct);
    o->lane_count = (size_t)fmax(floor(o->mouth.width / dx + 0.5), 1);
    o->lane_width = o->mouth.width / (double)o->lane_count;
    o->stride = dx * dx / o->lane_width;
    o->depth = (double)sph2d__reservoir_rows(&sim->given) * dx;
    o->lanes = sph2d__arena_alloc(&sim->arena, &sim->memory, o->lane_count, sizeof *o->lanes);
    o->outermost = sph2d__arena_alloc(&sim->arena, &sim->memory, o->lane_count, sizeof *o->outermost);
    return o->lanes && o->outermost;
}

sph2d_status sph2d__openings_create(sph2d_sim *sim)
{
    sph2d__openings *all = &sim->openings;
    size_t count = sim->given.opening_count;
    if (count == 0)
        return SPH2D_OK;
    all->items = sph2d__arena_alloc(&sim->arena, &sim->memory, count, sizeof *all->items);
    if (!all->items)
        return SPH2D_NOMEM;
    all->means = sph2d__arena_alloc(&sim->arena, &sim->memory, count, sizeof *all->means);
    if (!all->means)
        return SPH2D_NOMEM;
    for (size_t k = 0; k < count; ++k) {
        all->items[k].given = &sim->given.openings[k];
        all->items[k].means = &all->means[k];
        if (!make_lanes(sim, &all->items[k]))
            return SPH2D_NOMEM;
    }
    all->count = count;
    return SPH2D_OK;
}

/* ---- places ------------------------------------------------------------------------------------------------------ */

/** A place seen from an opening: how far along the line, and beyond it. */
typedef struct spot {
    double along, beyond;
} spot;

static spot spot_of(const sph2d__opening *o, double x, double y)
{
    double rx = x - o->mouth.start.x, ry = y - o->mouth.start.y;
    return (spot){rx * o->mouth.along.x + ry * o->mouth.along.y, -(rx * o->mouth.inward.x + ry * o->mouth.inward.y)};
}

static sph2d_vec2 place_of(const sph2d__opening *o, spot s)
{
    return (sph2d_vec2){o->mouth.start.x + s.along * o->mouth.along.x - s.beyond * o->mouth.inward.x,
                        o->mouth.start.y + s.along * o->mouth.along.y - s.beyond * o->mouth.inward.y};
}

/** Particles that walls push a little beyond the ends still belong to it. */
static bool is_beyond(const sph2d__opening *o, spot s)
{
    return s.beyond > 0 && s.along > -o->lane_width && s.along < o->mouth.width + o->lane_width;
}

const sph2d__opening *sph2d__opening_at(const sph2d_sim *sim, double x, double y)
{
    for (size_t k = 0; k < sim->openings.count; ++k)
        if (is_beyond(&sim->openings.items[k], spot_of(&sim->openings.items[k], x, y)))
            return &sim->openings.items[k];
    return NULL;
}

bool sph2d__openings_spent(const sph2d_sim *sim, double x, double y)
{
    const sph2d__opening *o = sph2d__opening_at(sim, x, y);
    return o && spot_of(o, x, y).beyond > o->depth;
}

/** Pressure of liquid at rest at a place, 0 in the middle of the line. */
static double rest_pressure(const sph2d_sim *sim, const sph2d__opening *o, double x, double y)
{
    const sph2d__body *b = &sim->system.body;
    double gx = sim->record.gravity_x + b->frame.uniform.x, gy = sim->record.gravity_y + b->frame.uniform.y;
    sph2d_vec2 middle = o->middle;
    return sim->system.rest_density * (gx * (x - middle.x) + gy * (y - middle.y));
}

/* ---- what is before the line ------------------------------------------------------------------------------------- */

/** Weighted sums over the particles before a lane: of the distance s from the line, the distance t from its middle in
 *  lanes, and values with and without t. */
typedef struct lane_sums {
    double weight, s, t, tt, value[3], tvalue[3]; /* near it: p', u, w */
    double wide, wide_s, ss, p, sp;               /* for the slope */
} lane_sums;

/** Lanes whose sums are found at once, so that these need no memory. */
enum { LANES_AT_ONCE = 256 };

static double hat(double x)
{
    return fmax(1 - fabs(x), 0);
}

static void add_particle(const sph2d_sim *sim, const sph2d__opening *o, size_t i, spot at, size_t first, size_t count,
                         lane_sums *sums)
{
    const sph2d__store *f = &sim->system.fluid;
    double dx = sim->scene.spacing, s = -at.beyond, near = hat(s / (VALUES * dx)), wide = hat(s / (SLOPES * dx));
    double p = sph2d__pressure_of(&sim->system, f->density[i]) - rest_pressure(sim, o, f->x[i], f->y[i]);
    double values[3] = {p, f->vx[i] * o->mouth.inward.x + f->vy[i] * o->mouth.inward.y,
                        f->vx[i] * o->mouth.along.x + f->vy[i] * o->mouth.along.y};
    double lane = at.along / o->lane_width - 0.5; /* lane k is at k */
    for (long k = (long)ceil(lane - BESIDE); k <= (long)floor(lane + BESIDE); ++k) {
        if (k < (long)first || k >= (long)(first + count))
            continue;
        lane_sums *sum = &sums[k - (long)first];
        double t = lane - (double)k, beside = hat(t / BESIDE), a = beside * near, b = beside * wide;
        sum->weight += a;
        sum->s += a * s;
        sum->t += a * t;
        sum->tt += a * t * t;
        for (int n = 0; n < 3; ++n) {
            sum->value[n] += a * values[n];
            sum->tvalue[n] += a * t * values[n];
        }
        sum->wide += b;
        sum->wide_s += b * s;
        sum->ss += b * s * s;
        sum->p += b * values[0];
        sum->sp += b * s * values[0];
    }
}

/** The value in the middle of a lane, by a line through values at both of its sides: at a wall they are all at one. */
static double middle_value(const lane_sums *sum, int n)
{
    double t = sum->t / sum->weight, spread = sum->tt / sum->weight - t * t, value = sum->value[n] / sum->weight;
    double slope = spread > 0.05 ? (sum->tvalue[n] / sum->weight - t * value) / spread : 0;
    return value - slope * t;
}

/** Weight of particles before a lane from which on it is wet: some two of them. */
static const double WET = 0.5;

static void set_lane(const sph2d_sim *sim, const sph2d__opening *o, size_t k, const lane_sums *sum)
{
    sph2d__lane *lane = &o->lanes[k];
    double dx = sim->scene.spacing, means[] = {sum->wide_s / sum->wide, sum->p / sum->wide};
    double spread = sum->ss / sum->wide - means[0] * means[0];
    lane->wet = sum->weight > WET;
    if (!lane->wet) {
        sph2d_vec2 at = place_of(o, (spot){((double)k + 0.5) * o->lane_width, 0});
        *lane = (sph2d__lane){.pressure = -rest_pressure(sim, o, at.x, at.y)};
        return;
    }
    lane->slope = spread > 0.1 * dx * dx ? (sum->sp / sum->wide - means[0] * means[1]) / spread : 0;
    lane->pressure = middle_value(sum, 0) - o->means->slope * sum->s / sum->weight;
    lane->inward = middle_value(sum, 1);
    lane->sideward = middle_value(sum, 2);
}

/** Measures some lanes of an opening, in the order of the particles. */
static void measure_lanes(const sph2d_sim *sim, const sph2d__opening *o, size_t first, size_t count)
{
    const sph2d__store *f = &sim->system.fluid;
    lane_sums sums[LANES_AT_ONCE];
    memset(sums, 0, count * sizeof *sums);
    double reach = SLOPES * sim->scene.spacing;
    for (size_t i = 0; i < f->count; ++i) {
        spot at = spot_of(o, f->x[i], f->y[i]);
        if (at.beyond <= 0 && at.beyond > -reach)
            add_particle(sim, o, i, at, first, count, sums);
    }
    for (size_t k = 0; k < count; ++k)
        set_lane(sim, o, first + k, &sums[k]);
}

/** Sets the mean over the lanes that are wet. */
static void average_lanes(sph2d__opening *o)
{
    o->now = (sph2d__opening_means){0};
    o->wet_lanes = 0;
    for (size_t i = 0; i < o->lane_count; ++i) {
        if (!o->lanes[i].wet)
            continue;
        o->now.velocity += o->lanes[i].inward;
        o->now.pressure += o->lanes[i].pressure;
        o->now.slope += o->lanes[i].slope;
        ++o->wet_lanes;
    }
    double count = (double)o->wet_lanes;
    o->wet = count > 0;
    if (!o->wet)
        return;
    o->now.velocity /= count;
    o->now.pressure /= count;
    o->now.slope /= count;
}

static void measure(const sph2d_sim *sim)
{
    for (size_t k = 0; k < sim->openings.count; ++k) {
        sph2d__opening *o = &sim->openings.items[k];
        for (size_t first = 0; first < o->lane_count; first += LANES_AT_ONCE) {
            size_t left = o->lane_count - first;
            measure_lanes(sim, o, first, left < LANES_AT_ONCE ? left : LANES_AT_ONCE);
        }
        average_lanes(o);
    }
}

/** Part of a new value in a mean over `most`, so far over `age`. */
static double new_part(double dt, double age, double most)
{
    return age > 0 ? fmin(dt / fmin(age + dt, most), 1) : 1;
}

/** Adds what was measured to the means, as of the last `dt`. */
static void update_means(const sph2d_sim *sim, double dt)
{
    sph2d_box d = sim->given.domain;
    double period = 2 * hypot(d.max.x - d.min.x, d.max.y - d.min.y) / sim->system.sound_speed;
    for (size_t k = 0; k < sim->openings.count; ++k) {
        const sph2d__opening *o = &sim->openings.items[k];
        sph2d__opening_means *m = o->means;
        double part = new_part(dt, m->age, PERIODS * period);
        m->velocity += new_part(dt, m->age, PERIODS_OF_PRESSURE * period) * (o->now.velocity - m->velocity);
        m->pressure += part * (o->now.pressure - m->pressure);
        m->slope += part * (o->now.slope - m->slope);
        m->age = o->wet ? fmin(m->age + dt, PERIODS * period) : 0;
    }
}

/* ---- what is prescribed ------------------------------------------------------------------------------------------ */

/** The profile f, 1 in the mean over the lanes' width; z from 0 to 1. */
static double profile_at(sph2d_opening_profile profile, double z)
{
    z = fmin(fmax(z, 0), 1);
    return profile == SPH2D_OPENING_PROFILE_PARABOLA ? 6 * z * (1 - z) : 1;
}

/** Grows from 0 to 1 over a ramp, with a continuous acceleration. */
static double ramp_at(double ramp, double time)
{
    double z = ramp > 0 ? fmin(time / ramp, 1) : 1;
    return z * z * z * (10 - 15 * z + 6 * z * z);
}

/** Velocity, into the domain and along the line, and density at a place in a reservoir. */
typedef struct prescribed {
    double inward, sideward, density;
} prescribed;

/** What a lane prescribes at its line: velocity inwards and sidewards, pressure p', and its slope. */
static void lane_values(const sph2d_sim *sim, const sph2d__opening *o, size_t k, double part, double values[4])
{
    const sph2d__lane *lane = &o->lanes[k];
    double impedance = sim->system.rest_density * sim->system.sound_speed;
    bool known = o->means->age > 0;
    if (isnan(o->velocity)) {
        double sound = known ? -impedance * (o->now.velocity - o->means->velocity) : 0;
        values[0] += part * lane->inward;
        values[1] += part * (lane->inward < 0 ? lane->sideward : 0);
        values[2] += part * (o->given->pressure + sound);
    } else {
        values[0] += part * (known ? -(o->now.pressure - o->means->pressure) / impedance : 0);
        values[2] += part * lane->pressure;
    }
    values[3] += part * o->means->slope;
}

/** Between the middles of two lanes all changes linearly. */
static prescribed prescribed_at(const sph2d_sim *sim, const sph2d__opening *o, spot at, double x, double y)
{
    double lane = fmin(fmax(at.along / o->lane_width - 0.5, 0), (double)o->lane_count - 1);
    size_t k = (size_t)lane, next = k + 1 < o->lane_count ? k + 1 : k;
    double part = lane - (double)k, values[4] = {0};
    lane_values(sim, o, k, 1 - part, values);
    lane_values(sim, o, next, part, values);
    if (!isnan(o->velocity))
        values[0] += o->velocity * profile_at(o->given->profile, at.along / o->mouth.width) *
                     ramp_at(o->given->ramp, sim->record.time);
    double pressure = values[2] - values[3] * (at.beyond + o->duct) + rest_pressure(sim, o, x, y);
    double aside = fmax(1 - at.beyond / sim->system.support, 0);
    return (prescribed){values[0], aside * values[1], sph2d__density_of(&sim->system, fmax(pressure, -sim->system.tension))};
}

static double energy_of(const sph2d_sim *sim, size_t i)
{
    const sph2d__store *f = &sim->system.fluid;
    return sim->system.mass * ((f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i]) / 2 + sph2d__sim_elastic_of(sim, i));
}

static void set_particle(sph2d_sim *sim, const sph2d__opening *o, size_t i)
{
    sph2d__store *f = &sim->system.fluid;
    prescribed p = prescribed_at(sim, o, spot_of(o, f->x[i], f->y[i]), f->x[i], f->y[i]);
    f->vx[i] = p.inward * o->mouth.inward.x + p.sideward * o->mouth.along.x;
    f->vy[i] = p.inward * o->mouth.inward.y + p.sideward * o->mouth.along.y;
    f->density[i] = p.density;
}

void sph2d__openings_impose(sph2d_sim *sim)
{
    if (sim->openings.count == 0)
        return;
    measure(sim);
    for (size_t i = 0; i < sim->system.fluid.count; ++i) {
        const sph2d__opening *o = sph2d__opening_at(sim, sim->system.fluid.x[i], sim->system.fluid.y[i]);
        if (!o)
            continue;
        double before = energy_of(sim, i);
        set_particle(sim, o, i);
        sim->record.energy_fed += energy_of(sim, i) - before;
    }
}

/* What pressure does to particles in reservoirs, it does to their neighbours, too: the energy is booked, and the
 * particles keep what is prescribed. */
void sph2d__openings_hold_density(sph2d_sim *sim, double dt)
{
    sph2d__store *f = &sim->system.fluid;
    for (size_t i = 0; sim->openings.count > 0 && i < f->count; ++i) {
        if (!sph2d__opening_at(sim, f->x[i], f->y[i]))
            continue;
        double pressure = sph2d__pressure_of(&sim->system, f->density[i]) + sim->system.background;
        sim->record.energy_fed -= dt * sim->system.mass * pressure / (f->density[i] * f->density[i]) * f->density_rate[i];
        f->density_rate[i] = 0;
        if (f->shift_x)
            f->shift_x[i] = f->shift_y[i] = 0;
    }
}

void sph2d__openings_hold_velocity(sph2d_sim *sim, double dt)
{
    sph2d__store *f = &sim->system.fluid;
    double power = 0;
    if (sim->openings.count == 0)
        return;
    for (size_t i = 0; i < f->count; ++i) {
        if (!sph2d__opening_at(sim, f->x[i], f->y[i]))
            continue;
        power -= sim->system.mass * (f->ax[i] * f->vx[i] + f->ay[i] * f->vy[i]);
        f->ax[i] = f->ay[i] = f->old_ax[i] = f->old_ay[i] = 0;
    }
    sim->record.energy_fed += dt * (power + sim->record.power_openings) / 2;
    sim->record.power_openings = power;
}

/* ---- particles come ---------------------------------------------------------------------------------------------- */

/** Adds a particle. False when memory is short. */
static bool add_at(sph2d_sim *sim, const sph2d__opening *o, spot at)
{
    sph2d__store *f = &sim->system.fluid;
    if (!sph2d__store_reserve(f, &sim->memory, f->count + 1))
        return false;
    sph2d_vec2 p = place_of(o, at);
    size_t i = sph2d__store_add(f, sim->record.next_id++, p.x, p.y);
    if (f->filling)
        f->filling[i] = 1;
    set_particle(sim, o, i);
    return true;
}

/** The lane of a place. */
static size_t lane_at(const sph2d__opening *o, double along)
{
    double k = floor(along / o->lane_width);
    return (size_t)fmin(fmax(k, 0), (double)o->lane_count - 1);
}

/** The number of particles in a reservoir. */
static double count_particles(const sph2d_sim *sim, const sph2d__opening *o)
{
    double count = 0;
    for (size_t i = 0; i < sim->system.fluid.count; ++i)
        count += sph2d__opening_at(sim, sim->system.fluid.x[i], sim->system.fluid.y[i]) == o;
    return count;
}

/** Fills duct and reservoir of an opening whose line is in the side. False when memory is short. */
static bool fill(sph2d_sim *sim, const sph2d__opening *o)
{
    bool all = !isnan(o->velocity);
    for (size_t k = 0; k < o->lane_count; ++k)
        for (double beyond = o->stride / 2; beyond <= o->depth + o->duct; beyond += o->stride)
            if ((o->lanes[k].wet || all) && !add_at(sim, o, (spot){((double)k + 0.5) * o->lane_width, beyond}))
                return false;
    return true;
}

sph2d_status sph2d__openings_fill(sph2d_sim *sim)
{
    sph2d__openings *all = &sim->openings;
    for (size_t n = 0; n < all->count; ++n)
        set_line(sim, &all->items[n], 0);
    measure(sim);
    update_means(sim, 0);
    bool ok = true;
    for (size_t n = 0; n < all->count; ++n)
        ok = ok && fill(sim, &all->items[n]);
    for (size_t n = 0; n < all->count; ++n) {
        set_line(sim, &all->items[n], all->items[n].duct);
        all->items[n].means->first = count_particles(sim, &all->items[n]);
    }
    return ok ? SPH2D_OK : SPH2D_NOMEM;
}

/** Finds the outermost particle of each lane of all openings; none is -stride/2, so that the first comes at half a
 *  stride. */
static void find_outermost(sph2d_sim *sim)
{
    const sph2d__store *f = &sim->system.fluid;
    for (size_t n = 0; n < sim->openings.count; ++n)
        for (size_t k = 0; k < sim->openings.items[n].lane_count; ++k)
            sim->openings.items[n].outermost[k] = -sim->openings.items[n].stride / 2;
    for (size_t i = 0; i < f->count; ++i) {
        const sph2d__opening *o = sph2d__opening_at(sim, f->x[i], f->y[i]);
        if (!o)
            continue;
        spot at = spot_of(o, f->x[i], f->y[i]);
        double *outermost = &o->outermost[lane_at(o, at.along)];
        *outermost = fmax(*outermost, at.beyond);
    }
}

/** Whether a lane gets new particles: liquid flows in, and comes from somewhere. */
static bool flows_in(const sph2d_sim *sim, const sph2d__opening *o, size_t k)
{
    double along = ((double)k + 0.5) * o->lane_width;
    sph2d_vec2 p = place_of(o, (spot){along, 0});
    return prescribed_at(sim, o, (spot){along, 0}, p.x, p.y).inward > 0 && (o->lanes[k].wet || !isnan(o->velocity));
}

sph2d_status sph2d__openings_feed(sph2d_sim *sim)
{
    if (sim->openings.count == 0)
        return SPH2D_OK;
    measure(sim);
    update_means(sim, sim->record.last_step);
    find_outermost(sim);
    for (size_t n = 0; n < sim->openings.count; ++n) {
        const sph2d__opening *o = &sim->openings.items[n];
        for (size_t k = 0; k < o->lane_count; ++k) {
            while (flows_in(sim, o, k) && o->outermost[k] + o->stride <= o->depth) {
                o->outermost[k] += o->stride;
                if (!add_at(sim, o, (spot){((double)k + 0.5) * o->lane_width, o->outermost[k]}))
                    return SPH2D_NOMEM;
                size_t i = sim->system.fluid.count - 1;
                const sph2d__store *f = &sim->system.fluid;
                sim->record.energy_fed += sph2d__sim_energy_of(sim, f->x[i], f->y[i], f->vx[i], f->vy[i]) +
                                          sim->system.mass * sph2d__sim_elastic_of(sim, i);
                ++sim->record.let_in;
                ++o->means->came;
            }
        }
    }
    return SPH2D_OK;
}

void sph2d__openings_count_out(sph2d_sim *sim, double x, double y)
{
    const sph2d__opening *o = sph2d__opening_at(sim, x, y);
    if (o)
        ++o->means->left;
}

void sph2d__opening_read(const sph2d_sim *sim, size_t index, double values[SPH2D__OPENING_READINGS])
{
    const sph2d__opening *o = &sim->openings.items[index];
    double area = sim->scene.spacing * sim->scene.spacing;
    measure(sim);
    double wet = (double)o->wet_lanes * o->lane_width;
    double kept = count_particles(sim, o) - o->means->first;
    values[0] = o->wet ? o->now.velocity : NAN;
    values[1] = wet * o->now.velocity;
    values[2] = (o->means->came - o->means->left - kept) * area;
    values[3] = o->wet ? o->now.pressure + o->means->slope * o->duct : NAN;
    values[4] = wet;
}
