/* SPDX-License-Identifier: MIT */
/** @file openings_measure.c
 *  Velocity and pressure of the liquid before the lines of openings, and their means over time. */
#include <math.h>
#include <string.h>

#include "methods/common/state_equation.h"
#include "sim/openings_parts.h"
#include "sim/simulation.h"

/* How far before the line velocity and pressure are measured, and the slope of pressure; and how far along it [spacings].
 * Weights fall linearly to 0 there. */
static const double VALUES = 2.5, SLOPES = 4, BESIDE = 1;

/* T in 2 L/c0. For openings with a pressure it acts like the inertia of liquid c0 T long, which slows down what starts
 * from rest; for those with a velocity like the compression of as much. A stream that is set in motion within a second has
 * pressures of 0.6, 0.02, 0.007 rho U^2 in the next three; with 1/4 and 1/16 of 0.68, 0.32, 0.1, with 4 and 1/16 of
 * 0.22, 0.1, 0.025. */
static const double PERIODS = 1, PERIODS_OF_PRESSURE = 1.0 / 16;

/* ---- what is before the line ------------------------------------------------------------------------------------- */

double sph2d__rest_pressure(const sph2d_sim *sim, const sph2d__opening *o, double x, double y)
{
    const sph2d__forces *b = &sim->system.forces;
    double gx = sim->record.gravity_x + b->frame.uniform.x, gy = sim->record.gravity_y + b->frame.uniform.y;
    sph2d_vec2 middle = o->middle;
    return sim->system.rest_density * (gx * (x - middle.x) + gy * (y - middle.y));
}

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

static void add_particle(const sph2d_sim *sim, const sph2d__opening *o, size_t i, sph2d__spot at, size_t first,
                         size_t count, lane_sums *sums)
{
    const sph2d__store *f = &sim->system.fluid;
    double dx = sim->world.scene.spacing, s = -at.beyond, near = hat(s / (VALUES * dx)), wide = hat(s / (SLOPES * dx));
    double p = sph2d__pressure_of(&sim->system, f->density[i]) - sph2d__rest_pressure(sim, o, f->x[i], f->y[i]);
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
    double dx = sim->world.scene.spacing, means[] = {sum->wide_s / sum->wide, sum->p / sum->wide};
    double spread = sum->ss / sum->wide - means[0] * means[0];
    lane->wet = sum->weight > WET;
    if (!lane->wet) {
        sph2d_vec2 at = sph2d__place_of(o, (sph2d__spot){((double)k + 0.5) * o->lane_width, 0});
        *lane = (sph2d__lane){.pressure = -sph2d__rest_pressure(sim, o, at.x, at.y)};
        return;
    }
    lane->slope = spread > 0.1 * dx * dx ? (sum->sp / sum->wide - means[0] * means[1]) / spread : 0;
    lane->pressure = middle_value(sum, 0) - o->means->slope * sum->s / sum->weight;
    lane->inward = middle_value(sum, 1);
    lane->sideward = middle_value(sum, 2);
}

/** Measures some lanes of an opening, in the order of the particles. */
static void measure_lanes(const sph2d_sim *sim, sph2d__opening *o, size_t first, size_t count)
{
    const sph2d__store *f = &sim->system.fluid;
    lane_sums sums[LANES_AT_ONCE];
    memset(sums, 0, count * sizeof *sums);
    double reach = SLOPES * sim->world.scene.spacing;
    for (size_t i = 0; i < f->count; ++i) {
        sph2d__spot at = sph2d__spot_of(o, f->x[i], f->y[i]);
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

/* Distances from the line at which depth is measured, with weights that fall linearly to 0 in `half` [spacings]: whole
 * numbers, so that a lattice has the same depth wherever it is. Near it is what is fed; what comes from the domain is
 * seen farther away. */
typedef struct place {
    double at, half;
} place;
static const place NEAR = {2, 2}, INSIDE = {8, 4};

/** Depth of liquid before the line: its area, in the mean with weights; and its velocity inwards there. */
static double depth_at(const sph2d_sim *sim, const sph2d__opening *o, place where, double *velocity)
{
    const sph2d__store *f = &sim->system.fluid;
    double dx = sim->world.scene.spacing, weights = 0, flow = 0;
    for (size_t i = 0; i < f->count; ++i) {
        sph2d__spot at = sph2d__spot_of(o, f->x[i], f->y[i]);
        bool beside = at.along < -o->lane_width || at.along > o->mouth.width + o->lane_width;
        double weight = beside ? 0 : hat((-at.beyond / dx - where.at) / where.half);
        weights += weight;
        flow += weight * (f->vx[i] * o->mouth.inward.x + f->vy[i] * o->mouth.inward.y);
    }
    *velocity = weights > 0 ? flow / weights : 0;
    return fmin(weights / where.half * dx, o->mouth.width);
}

/** u - 2 sqrt(g h) of a stream of depth h that enters with the given flow rate or velocity. */
static double outgoing(const sph2d__opening *o, double value, double g, double h)
{
    return (o->kind == SPH2D__OPENING_FLOW_RATE ? value / h : value) - 2 * sqrt(g * h);
}

/** The depth with which a stream enters: that at which its u - 2 sqrt(g h) is that of the liquid inside, which waves of
 *  shallow water bring out unchanged (method of characteristics; Chaudhry 2008, Open-Channel Flow, ch. 14). By the depth
 *  before the line itself any depth that is fed would stay. Of a stream that leaves it is what comes. */
static double entering_depth(const sph2d_sim *sim, const sph2d__opening *o)
{
    double value = sph2d__opening_value(&sim->world.scene, o->given, sim->record.time), u;
    double inside = depth_at(sim, o, INSIDE, &u), g = hypot(sim->record.gravity_x, sim->record.gravity_y);
    if (!(g > 0) || !(value > 0) || inside <= 0)
        return inside;
    double wanted = u - 2 * sqrt(g * inside);
    double low = sph2d__opening_critical_depth(&sim->world.scene, o->given, sim->record.time), high = o->mouth.width;
    for (int k = 0; k < 40; ++k) { /* it falls with h */
        double h = (low + high) / 2;
        *(outgoing(o, value, g, h) > wanted ? &low : &high) = h;
    }
    return low;
}

static void measure_depth(const sph2d_sim *sim, sph2d__opening *o)
{
    double u;
    o->now.depth = depth_at(sim, o, NEAR, &u);
    o->entering = o->has_velocity ? entering_depth(sim, o) : o->now.depth;
}

/** Depth of the lanes that are fed, with a level at its height; of an opening without a surface all [m]. */
static double fed_depth(const sph2d_sim *sim, const sph2d__opening *o, double level)
{
    if (!o->has_surface)
        return o->mouth.width;
    if (o->kind == SPH2D__OPENING_LEVEL)
        return o->mouth.along.y > 0 ? fmin(fmax(level - o->mouth.start.y, 0), o->mouth.width) : o->mouth.width;
    double depth = o->means->age > 0 ? o->means->depth : o->entering;
    return fmax(depth, sph2d__opening_critical_depth(&sim->world.scene, o->given, sim->record.time));
}

/** Sets what is prescribed now, and how many lanes are fed. Outside, liquid is at rest: what flows in has lost the
 *  pressure rho0 <u>^2/2, or the height <u>^2/(2 g), by Bernoulli's law. */
static void set_value(const sph2d_sim *sim, sph2d__opening *o)
{
    double value = sph2d__opening_value(&sim->world.scene, o->given, sim->record.time);
    double inflow = o->means->age > 0 ? fmax(o->means->velocity, 0) : 0;
    double g = hypot(sim->record.gravity_x, sim->record.gravity_y);
    if (o->kind == SPH2D__OPENING_LEVEL && g > 0) /* a program may take gravity away */
        value -= inflow * inflow / (2 * g);
    else if (o->kind == SPH2D__OPENING_PRESSURE)
        value -= sim->system.rest_density * inflow * inflow / 2;
    o->fed_lanes = (size_t)fmin(floor(fed_depth(sim, o, value) / o->lane_width + 0.5), (double)o->lane_count);
    o->now.fed = (double)o->fed_lanes * o->lane_width;
    o->value = value;
    if (o->kind == SPH2D__OPENING_LEVEL) {
        o->value = -sph2d__rest_pressure(sim, o, o->middle.x, value);
    } else if (o->kind == SPH2D__OPENING_FLOW_RATE) {
        double fed = o->means->age > 0 ? o->means->fed : o->now.fed;
        o->value = fed > 0 ? value / (o->has_surface ? fed : o->mouth.width) : 0;
    }
}

void sph2d__openings_measure(const sph2d_sim *sim)
{
    for (size_t k = 0; k < sim->openings.count; ++k) {
        sph2d__opening *o = &sim->openings.items[k];
        for (size_t first = 0; first < o->lane_count; first += LANES_AT_ONCE) {
            size_t left = o->lane_count - first;
            measure_lanes(sim, o, first, left < LANES_AT_ONCE ? left : LANES_AT_ONCE);
        }
        average_lanes(o);
        if (o->has_surface)
            measure_depth(sim, o);
        set_value(sim, o);
    }
}

/** Part of a new value in a mean over `most`, so far over `age`. */
static double new_part(double dt, double age, double most)
{
    return age > 0 ? fmin(dt / fmin(age + dt, most), 1) : 1;
}

void sph2d__openings_average(const sph2d_sim *sim, double dt)
{
    sph2d_box d = sim->world.scene.domain;
    double period = 2 * hypot(d.max.x - d.min.x, d.max.y - d.min.y) / sim->system.sound_speed;
    for (size_t k = 0; k < sim->openings.count; ++k) {
        const sph2d__opening *o = &sim->openings.items[k];
        sph2d__opening_means *m = o->means;
        double part = new_part(dt, m->age, PERIODS * period);
        m->velocity += new_part(dt, m->age, PERIODS_OF_PRESSURE * period) * (o->now.velocity - m->velocity);
        m->pressure += part * (o->now.pressure - m->pressure);
        m->slope += part * (o->now.slope - m->slope);
        m->depth += part * (o->entering - m->depth);
        m->fed += part * (o->now.fed - m->fed);
        m->age = o->wet ? fmin(m->age + dt, PERIODS * period) : 0;
    }
}
