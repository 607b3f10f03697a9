/* SPDX-License-Identifier: MIT */
/** @file bodies_forces.c
 *  Forces on bodies: of the liquid, gravity, springs; and their energy. */
#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "base/pi.h"
#include "methods/terms/tension.h"
#include "scene/bodies.h"
#include "sim/bodies.h"
#include "sim/simulation.h"

/* ---- the liquid -------------------------------------------------------------------------------------------------- */

/** Adds a force on a body at an arm from its centre of mass. */
static void add_force(sph2d__twist *to, sph2d_vec2 arm, double x, double y)
{
    to->x += x;
    to->y += y;
    to->turn += arm.x * y - arm.y * x;
}

/** From a point of a body to one of its boundary particles, by the shortest way across periodic sides. */
static sph2d_vec2 arm_to(const sph2d_sim *sim, sph2d_vec2 point, double x, double y)
{
    const sph2d__period *p = &sim->system.wall_cells.period;
    return (sph2d_vec2){sph2d__period_nearest(x - point.x, p->length_x),
                        sph2d__period_nearest(y - point.y, p->length_y)};
}

/** Sums over the boundary particles of a body, in the order of their ids. */
static void press_body(const sph2d_sim *sim, sph2d__rigid *r)
{
    const sph2d__bodies *all = &sim->bodies;
    const sph2d__store *w = &sim->system.walls;
    sph2d__twist rest = {0, 0, 0};
    r->state->pressed = r->rubbed = rest;
    sph2d_vec2 center = sph2d__rigid_center(r, r->now);
    for (uint64_t id = r->first_id; id < r->end_id; ++id) {
        size_t k = (size_t)(id - all->first), b = sim->system.rigid_index[k];
        sph2d_vec2 arm = arm_to(sim, center, w->x[b], w->y[b]);
        add_force(&r->state->pressed, arm, -all->forces[k].pressure.x, -all->forces[k].pressure.y);
        add_force(&r->rubbed, arm, -all->forces[k].friction.x, -all->forces[k].friction.y);
        if (all->tensions)
            add_force(&rest, arm, -all->tensions[b].x, -all->tensions[b].y);
    }
    rest = sph2d__twist_add(rest, 1, r->rubbed);
    r->state->pushed = sph2d__twist_add(r->state->pressed, 1, sph2d__twist_add(rest, 1, r->state->gap));
}

void sph2d__bodies_press(sph2d_sim *sim)
{
    sph2d__bodies *all = &sim->bodies;
    if (all->count == 0)
        return;
    size_t count = (size_t)(all->end - all->first);
#pragma omp taskloop num_tasks(sph2d__tasks(count, SPH2D__LOOK_GRAIN)) if (count > SPH2D__LOOK_GRAIN)
    for (size_t k = 0; k < count; ++k)
        all->forces[k] = sph2d__sim_force_of_wall(sim, sim->system.rigid_index[k]);
    if (all->tensions) {
        memset(all->tensions, 0, sim->system.walls.count * sizeof *all->tensions);
        sph2d__tension_of_walls(&sim->system, all->tensions);
    }
    sph2d__gaps_press(sim);
    for (size_t k = 0; k < all->count; ++k)
        press_body(sim, &all->items[k]);
}

void sph2d__bodies_add_work(const sph2d_sim *sim, double dt, sph2d__slab_sum *sum)
{
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        const sph2d__rigid *r = &sim->bodies.items[k];
        sph2d__twist rest = sph2d__twist_add(r->state->pushed, -1, r->state->pressed);
        sph2d__twist other = sph2d__bodies_other_force(sim, r, sim->record.time + dt / 2);
        sph2d__twist free = sph2d__rigid_accelerate(r, sph2d__twist_add(rest, 1, other));
        sph2d__twist all = sph2d__twist_add(free, 1, sph2d__rigid_accelerate(r, r->state->pressed));
        sph2d__twist impulse = sph2d__twist_add((sph2d__twist){0, 0, 0}, dt / sim->system.mass, r->state->pressed);
        sum->first += sph2d__twist_dot(impulse, sph2d__twist_add(r->state->velocity, dt / 2, all));
        sum->second += sph2d__twist_dot(impulse, sph2d__twist_add(r->state->velocity, dt, all));
        sum->third += dt / 2 * sph2d__twist_dot(impulse, free);
    }
}

/* ---- other forces ------------------------------------------------------------------------------------------------ */

/** A spring of a body as it is now. */
typedef struct stretch {
    sph2d_vec2 arm, along; /**< from the centre of mass to its end; unit vector to the fixed point */
    double by, rate;       /**< beyond its length [m], and the rate of that [m/s]; 0 where it is slack */
} stretch;

static stretch stretch_of(const sph2d__rigid *r, const sph2d_spring *spring, const sph2d__pose *pose)
{
    sph2d_vec2 start = sph2d__spring_start(spring, r->center), at = sph2d__pose_apply(pose, start);
    sph2d_vec2 v = sph2d__pose_velocity(pose, at), to = {spring->to.x - at.x, spring->to.y - at.y};
    double distance = hypot(to.x, to.y);
    stretch s = {.arm = sph2d__pose_arm(pose, at), .by = distance - sph2d__spring_length(spring, start)};
    if (distance > 0)
        s.along = (sph2d_vec2){to.x / distance, to.y / distance};
    s.rate = -(s.along.x * v.x + s.along.y * v.y);
    if (spring->slack == SPH2D_SWITCH_ON && s.by <= 0)
        s.by = s.rate = 0;
    return s;
}

/** The pull of a spring; one that only pulls is not pushed by its damper either. */
static double pull_of(const sph2d_spring *spring, const stretch *s)
{
    double pull = spring->stiffness * s->by + spring->damping * s->rate;
    return spring->slack == SPH2D_SWITCH_ON ? fmax(pull, 0) : pull;
}

/** The forces on bodies: all but springs of sides, which hold off particles. */
static sph2d__forces forces_on_bodies(const sph2d_sim *sim)
{
    sph2d__forces forces = sim->system.forces;
    forces.springs.stiffness = 0;
    return forces;
}

/** Where the centre of mass is. */
static sph2d__place place_of(const sph2d__pose *pose, sph2d__twist velocity)
{
    return (sph2d__place){pose->center.x + pose->displacement.x, pose->center.y + pose->displacement.y, velocity.x,
                          velocity.y};
}

/** Acceleration by forces, as of the liquid at the centre of mass. */
static sph2d__twist body_acceleration(const sph2d_sim *sim, const sph2d__pose *pose)
{
    const sph2d__forces forces = forces_on_bodies(sim);
    const sph2d__twist velocity = {pose->velocity.x, pose->velocity.y, 0};
    double ax = 0, ay = 0;
    sph2d__forces_add(&forces, place_of(pose, velocity), &ax, &ay);
    return (sph2d__twist){ax, ay, -forces.frame.alpha};
}

sph2d__twist sph2d__bodies_other_force(const sph2d_sim *sim, const sph2d__rigid *r, double time)
{
    sph2d__pose pose = sph2d__rigid_at(r, time);
    sph2d__twist a = body_acceleration(sim, &pose);
    sph2d__twist force = {r->mass * a.x, r->mass * a.y, r->inertia * a.turn};
    for (size_t k = 0; k < r->body->spring_count; ++k) {
        const sph2d_spring *spring = &r->body->springs[k];
        stretch s = stretch_of(r, spring, &pose);
        double pull = pull_of(spring, &s);
        add_force(&force, s.arm, pull * s.along.x, pull * s.along.y);
    }
    return force;
}

void sph2d__bodies_expect(sph2d_sim *sim, double time)
{
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d__rigid *r = &sim->bodies.items[k];
        sph2d__twist rubbed = sph2d__twist_add(r->state->pushed, -1, r->state->pressed);
        r->other = sph2d__twist_add(rubbed, 1, sph2d__bodies_other_force(sim, r, time));
    }
}

/* ---- energy ------------------------------------------------------------------------------------------------------ */

double sph2d__body_energy(const sph2d_sim *sim, const sph2d__rigid *r)
{
    sph2d__pose pose = sph2d__rigid_at(r, r->start);
    double energy = sph2d__rigid_kinetic(r, r->state->velocity);
    const sph2d__forces forces = forces_on_bodies(sim);
    const sph2d__place at = place_of(&pose, r->state->velocity);
    energy += r->mass * sph2d__forces_potential(&forces, at.x, at.y);
    for (size_t k = 0; k < r->body->spring_count; ++k) {
        stretch s = stretch_of(r, &r->body->springs[k], &pose);
        energy += r->body->springs[k].stiffness * s.by * s.by / 2;
    }
    return energy;
}

double sph2d__bodies_energy(const sph2d_sim *sim)
{
    double energy = 0;
    for (size_t k = 0; k < sim->bodies.count; ++k)
        energy += sph2d__body_energy(sim, &sim->bodies.items[k]);
    return energy;
}

double sph2d__bodies_power(const sph2d_sim *sim)
{
    const sph2d__forces forces = forces_on_bodies(sim);
    double power = 0;
    for (size_t n = 0; n < sim->bodies.count; ++n) {
        const sph2d__rigid *r = &sim->bodies.items[n];
        sph2d__pose pose = sph2d__rigid_at(r, r->start);
        const sph2d__place at = place_of(&pose, r->state->velocity);
        double ax = 0, ay = 0;
        sph2d__forces_drive(&forces, SPH2D__WORK, at, &ax, &ay);
        sph2d__forces_drive(&forces, SPH2D__LOSS, at, &ax, &ay);
        power += r->mass * (at.vx * ax + at.vy * ay) - r->inertia * forces.frame.alpha * r->state->velocity.turn;
        for (size_t k = 0; k < r->body->spring_count; ++k) {
            const sph2d_spring *spring = &r->body->springs[k];
            stretch s = stretch_of(r, spring, &pose);
            power -= (pull_of(spring, &s) - spring->stiffness * s.by) * s.rate;
        }
    }
    return power;
}

double sph2d__bodies_speed(const sph2d_sim *sim)
{
    double speed = 0;
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        const sph2d__rigid *r = &sim->bodies.items[k];
        const sph2d__twist *v = &r->state->velocity;
        speed = fmax(speed, hypot(v->x, v->y) + fabs(v->turn) * r->radius);
    }
    return speed;
}

/* Part of a spring's period over 2 pi, and of the time in which its damper would stop a body. */
static const double SPRING = 0.3, DAMPER = 0.5;
/* The same of a light body between layers of liquid, where the method does not solve for the body's acceleration. */
static const double LAYERS = 0.5;
/* Part of the time in which friction along its outline would stop a body that is lighter than the liquid around it, and of
 * its period on surface tension. Slabs of 0.08 times the density of water, 2 spacings across, in liquid of which steps are
 * limited by viscosity: one 14 spacings long is stable with 0.3, not with 0.4. */
static const double FRICTION = 0.2, TENSION = 1;

/** The longest step that is stable with friction and surface tension along a body [s]. `mass`: the least that a point of
 *  it has. */
static double step_along(const sph2d_sim *sim, const sph2d__rigid *r, double mass)
{
    const sph2d__system *s = &sim->system;
    double perimeter = 2 * SPH2D__PI * r->radius, dt = INFINITY;
    size_t b = s->rigid_index[r->first_id - sim->bodies.first];
    if (s->viscosity > 0 && r->first_id < r->end_id && sph2d__slip_of(s, b) != SPH2D_SLIP_FREE)
        dt = FRICTION * mass * s->spacing / (s->viscosity * perimeter);
    if (s->surface_tension > 0)
        dt = fmin(dt, TENSION * s->spacing * sqrt(mass / (s->surface_tension * perimeter)));
    return dt;
}

double sph2d__bodies_step(const sph2d_sim *sim)
{
    double dt = INFINITY, c = sim->system.sound_speed, rho = sim->system.rest_density;
    for (size_t n = 0; n < sim->bodies.count; ++n) {
        const sph2d__rigid *r = &sim->bodies.items[n];
        double mass = fmin(r->mass, r->inertia / (r->radius * r->radius));
        for (size_t k = 0; k < r->body->spring_count; ++k) {
            const sph2d_spring *s = &r->body->springs[k];
            dt = fmin(dt, SPRING * sqrt(mass / fmax(s->stiffness, 1e-300)));
            dt = fmin(dt, DAMPER * mass / fmax(s->damping, 1e-300));
        }
        dt = fmin(dt, step_along(sim, r, mass));
        if (!sim->method->couples_bodies)
            dt = fmin(dt, LAYERS * sqrt(r->mass * sim->system.spacing / (rho * c * c * 2 * SPH2D__PI * r->radius)));
    }
    return dt;
}
