/* SPDX-License-Identifier: MIT */
/** @file bodies.c
 *  Bodies over a step. */
#include "sim/bodies.h"

#include <math.h>
#include <string.h>

#include "base/pi.h"
#include "scene/bodies.h"
#include "scene/shape.h"
#include "sim/simulation.h"

/* ---- creation ---------------------------------------------------------------------------------------------------- */

static double free_of(sph2d_switch held)
{
    return held == SPH2D_SWITCH_ON ? 0 : 1;
}

static void start_body(sph2d_sim *sim, size_t k, sph2d__rigid *r)
{
    const sph2d_body *body = &sim->world.scene.bodies[k];
    const size_t wall = sim->world.first_body + k;
    sph2d__mass_data m = sph2d__body_mass(body);
    *r = (sph2d__rigid){.body = body,
                        .wall = (int)wall,
                        .first_id = sim->wall_ids[wall].first,
                        .end_id = sim->wall_ids[wall].end,
                        .mass = m.mass,
                        .inertia = m.inertia,
                        .center = m.center,
                        .radius = sph2d__shape_distance(&body->shape, m.center),
                        .free = {free_of(body->hold.x), free_of(body->hold.y), free_of(body->hold.angle)},
                        .state = &sim->bodies.states[k]};
    r->state->velocity = (sph2d__twist){body->velocity.x, body->velocity.y, body->rate};
}

/** Ties the moving outlines of bodies to them. */
static void tie_outlines(sph2d_sim *sim)
{
    for (size_t k = 0; k < sim->moving_count; ++k)
        for (size_t b = 0; b < sim->bodies.count; ++b)
            if (sim->moving[k].number == sim->bodies.items[b].wall) {
                sim->moving[k].rigid = &sim->bodies.items[b];
                sim->moving[k].course.center = sim->bodies.items[b].center;
            }
}

sph2d_status sph2d__bodies_create(sph2d_sim *sim)
{
    sph2d__bodies *all = &sim->bodies;
    size_t count = sim->world.scene.body_count, walls = sim->system.walls.count;
    if (count == 0)
        return SPH2D_OK;
    const size_t first = sim->world.first_body;
    all->first = sim->wall_ids[first].first;
    all->end = sim->wall_ids[first + count - 1].end;
    size_t own = (size_t)(all->end - all->first) + 1;
    sph2d__arena *arena = &sim->arena;
    all->items = sph2d__arena_alloc(arena, &sim->memory, count, sizeof *all->items);
    all->states = sph2d__arena_alloc(arena, &sim->memory, count, sizeof *all->states);
    all->strikes = sph2d__arena_alloc(arena, &sim->memory, count, sizeof *all->strikes);
    all->contacts = sph2d__arena_alloc(arena, &sim->memory, count, sizeof *all->contacts);
    all->wall_count = first;
    all->wall_work = sph2d__arena_alloc(arena, &sim->memory, all->wall_count, sizeof *all->wall_work);
    all->forces = sph2d__arena_alloc(arena, &sim->memory, own, sizeof *all->forces);
    uint32_t *index = sph2d__arena_alloc(arena, &sim->memory, own, sizeof *index);
    bool tension = sim->system.surface_tension > 0;
    if (tension)
        all->tensions = sph2d__arena_alloc(arena, &sim->memory, walls + 1, sizeof *all->tensions);
    if (!all->items || !all->states || !all->strikes || !all->contacts || !all->wall_work || !all->forces || !index ||
        (tension && !all->tensions))
        return SPH2D_NOMEM;
    all->count = count;
    for (size_t k = 0; k < count; ++k)
        start_body(sim, k, &all->items[k]);
    sim->system.rigids = all->items;
    sim->system.rigid_count = count;
    sim->system.rigid_index = index;
    if (sph2d__gaps_create(sim))
        return SPH2D_NOMEM;
    tie_outlines(sim);
    sph2d__bodies_stand(sim, 0);
    sph2d__bodies_index(sim, 0);
    return SPH2D_OK;
}

void sph2d__bodies_index(sph2d_sim *sim, double time)
{
    const sph2d__store *w = &sim->system.walls;
    const sph2d__bodies *all = &sim->bodies;
    for (size_t b = 0; all->count > 0 && b < w->count; ++b)
        if (w->id[b] >= all->first && w->id[b] < all->end)
            sim->system.rigid_index[w->id[b] - all->first] = (uint32_t)b;
    for (size_t k = 0; k < all->count; ++k) {
        sph2d__rigid *r = &all->items[k];
        sph2d__pose pose = sph2d__rigid_at(r, time);
        r->now = time;
        if (r->knows_felt)
            continue;
        r->state->felt = (sph2d__twist){pose.acceleration.x, pose.acceleration.y, pose.alpha};
        r->state->felt_way = (sph2d__twist){pose.velocity.x, pose.velocity.y, pose.omega};
    }
}

void sph2d__bodies_stand(sph2d_sim *sim, double time)
{
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d__rigid *r = &sim->bodies.items[k];
        r->start = r->meeting = time;
        r->from = r->state->place;
        r->way = r->state->velocity;
    }
}

/* ---- motors and contacts ----------------------------------------------------------------------------------------- */

/* Part of a step's acceleration by contacts and motors that counts at once as lasting: that of a body that lies on a floor
 * is known after some ten steps, and an impact is forgotten as soon. */
static const double LASTING = 0.1;

/** Turns a body towards its motor's rate by no more than the motor's torque can over the step. */
static void drive(const sph2d__rigid *r, double dt, sph2d__twist *v)
{
    double most = r->free.turn * r->body->motor.torque * dt / r->inertia;
    double wanted = r->body->motor.rate - v->turn;
    v->turn += fmax(-most, fmin(most, wanted));
}

/** Calls the solver for contacts for bodies at the start of their ways. */
static sph2d_status solve_contacts(sph2d_sim *sim, double dt)
{
    sph2d__bodies *all = &sim->bodies;
    if (!all->solver)
        return SPH2D_OK;
    for (size_t k = 0; k < all->count; ++k) {
        const sph2d__rigid *r = &all->items[k];
        all->contacts[k] = (sph2d_contact_body){.inverse_mass_x = r->free.x / r->mass,
                                                .inverse_mass_y = r->free.y / r->mass,
                                                .inverse_inertia = r->free.turn / r->inertia,
                                                .center = sph2d__rigid_center(r, r->start),
                                                .angle = r->from.turn,
                                                .velocity = {r->way.x, r->way.y},
                                                .rate = r->way.turn};
    }
    for (size_t i = 0; i < all->wall_count; ++i)
        all->wall_work[i] = 0;
    sph2d_status status = all->solver(all->user, sim, dt, all->contacts, all->count, all->wall_work);
    for (size_t k = 0; status == SPH2D_OK && k < all->count; ++k) {
        const sph2d_contact_body *c = &all->contacts[k];
        sph2d__rigid *r = &all->items[k];
        r->way = (sph2d__twist){r->free.x * c->velocity.x, r->free.y * c->velocity.y, r->free.turn * c->rate};
    }
    return status;
}

/** Books what walls did on bodies by contact. Returns their work. */
static double book_walls(sph2d_sim *sim)
{
    const sph2d__bodies *all = &sim->bodies;
    double sum = 0;
    for (size_t i = 0; all->solver && i < all->wall_count; ++i) {
        sum += all->wall_work[i];
        sph2d__loads_carry(sim, (int)i, all->wall_work[i]);
    }
    sim->record.energy_walls += sum;
    return sum;
}

/** The velocity amid the impulses of all other forces in a step of length dt, for which motors and contacts work; forces
 *  whose work is done have acted. */
static sph2d__twist amid(const sph2d__rigid *r, double dt)
{
    return sph2d__twist_add(sph2d__twist_add(r->way, -dt / 2, r->state->acceleration), 1, r->done);
}

static double kinetic_amid(const sph2d_sim *sim, double dt)
{
    double sum = 0;
    for (size_t k = 0; k < sim->bodies.count; ++k)
        sum += sph2d__rigid_kinetic(&sim->bodies.items[k], amid(&sim->bodies.items[k], dt));
    return sum;
}

/** What motors and contacts do to the velocities of the ways. */
static sph2d_status meet(sph2d_sim *sim, double dt)
{
    sph2d__record *record = &sim->record;
    double free = kinetic_amid(sim, dt);
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d__rigid *r = &sim->bodies.items[k];
        r->meant = r->way;
        drive(r, dt, &r->way);
    }
    double driven = kinetic_amid(sim, dt);
    sph2d_status status = solve_contacts(sim, dt);
    record->energy_forces += driven - free;
    record->energy_contacts += driven - kinetic_amid(sim, dt) + book_walls(sim);
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d__rigid *r = &sim->bodies.items[k];
        sph2d__twist change = sph2d__twist_add(r->way, -1, r->meant), *held = &r->state->held_up;
        *held = sph2d__twist_add(*held, LASTING / dt, sph2d__twist_add(change, -dt, *held));
    }
    return status;
}

/* ---- kick-drift-kick --------------------------------------------------------------------------------------------- */

sph2d_status sph2d__bodies_kick(sph2d_sim *sim, double dt)
{
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d__rigid *r = &sim->bodies.items[k];
        r->start = sim->record.time;
        r->meeting = r->start + dt / 2;
        r->from = r->state->place;
        r->way = sph2d__twist_add(r->state->velocity, dt / 2, r->state->acceleration);
        r->before = r->state->pushed;
        r->gap_before = r->state->gap;
    }
    return sim->bodies.count > 0 ? meet(sim, dt) : SPH2D_OK;
}

/** The acceleration by the present forces. */
static void accelerate(const sph2d_sim *sim, sph2d__rigid *r, double time)
{
    sph2d__twist force = sph2d__twist_add(r->state->pushed, 1, sph2d__bodies_other_force(sim, r, time));
    r->state->acceleration = sph2d__rigid_accelerate(r, force);
}

void sph2d__bodies_start(sph2d_sim *sim)
{
    if (sim->method->wall_force) /* else the first step's solution tells what the liquid does */
        sph2d__bodies_press(sim);
    for (size_t k = 0; k < sim->bodies.count; ++k)
        accelerate(sim, &sim->bodies.items[k], 0);
}

void sph2d__bodies_second_kick(sph2d_sim *sim, double dt)
{
    sph2d__bodies_press(sim);
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d__rigid *r = &sim->bodies.items[k];
        accelerate(sim, r, sim->record.time + dt);
        r->state->velocity = sph2d__twist_add(r->way, dt / 2, r->state->acceleration);
        sim->record.energy_forces +=
            dt / 2 * sph2d__twist_dot(sph2d__twist_add(r->gap_before, 1, r->state->gap), r->way);
        r->state->liquid = sph2d__twist_add(r->before, 1, r->state->pushed);
        r->state->liquid = sph2d__twist_add((sph2d__twist){0, 0, 0}, 0.5, r->state->liquid);
    }
}

/* ---- methods that solve for pressure ----------------------------------------------------------------------------- */

void sph2d__bodies_drift(sph2d_sim *sim, double dt)
{
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d__rigid *r = &sim->bodies.items[k];
        r->start = sim->record.time;
        r->meeting = r->start + dt / 2;
        r->from = r->state->place;
        r->way = r->state->velocity;
    }
}

sph2d_status sph2d__bodies_project(sph2d_sim *sim, double dt, double split)
{
    double middle = sim->record.time + dt / 2;
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d__rigid *r = &sim->bodies.items[k];
        sph2d__twist press = sph2d__rigid_accelerate(r, r->state->pressed);
        sph2d__twist rest = sph2d__twist_add(r->state->pushed, -1, r->state->pressed);
        sph2d__twist force = sph2d__twist_add(rest, 1, sph2d__bodies_other_force(sim, r, middle));
        r->from = sph2d__twist_add(r->from, middle - r->start, r->way);
        r->start = middle;
        r->meeting = sim->record.time + dt;
        r->state->acceleration = sph2d__twist_add(sph2d__rigid_accelerate(r, force), 1 - split, press);
        r->way = sph2d__twist_add(r->state->velocity, dt, r->state->acceleration);
        sph2d__twist way = sph2d__twist_add(r->state->velocity, dt / 2, r->state->acceleration);
        sim->record.energy_forces += dt * sph2d__twist_dot(r->state->gap, way);
        r->state->liquid = sph2d__twist_add(rest, 1 - split, r->state->pressed);
    }
    sph2d_status status = sim->bodies.count > 0 ? meet(sim, dt) : SPH2D_OK;
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d__rigid *r = &sim->bodies.items[k];
        r->state->velocity = r->way;
        r->way = sph2d__twist_add(r->way, 2 * dt * split, sph2d__rigid_accelerate(r, r->state->pressed));
    }
    return status;
}

/* ---- methods with a grid ----------------------------------------------------------------------------------------- */

void sph2d__bodies_fall(sph2d_sim *sim, double dt)
{
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d__rigid *r = &sim->bodies.items[k];
        r->start = sim->record.time;
        r->meeting = r->start + dt;
        r->from = r->state->place;
        r->other = sph2d__bodies_other_force(sim, r, r->start);
        r->state->acceleration = sph2d__rigid_accelerate(r, r->other);
        r->way = sph2d__twist_add(r->state->velocity, dt, r->state->acceleration);
    }
}

sph2d_status sph2d__bodies_push(sph2d_sim *sim, double dt, const sph2d__twist *impulses, double *work)
{
    *work = 0;
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d__rigid *r = &sim->bodies.items[k];
        const sph2d__twist force = sph2d__twist_add((sph2d__twist){0, 0, 0}, 1 / dt, impulses[k]);
        r->state->pressed = r->state->pushed = r->state->liquid = force;
        r->state->acceleration = sph2d__rigid_accelerate(r, sph2d__twist_add(r->other, 1, force));
        r->way = sph2d__twist_add(r->state->velocity, dt, r->state->acceleration);
        *work += sph2d__twist_dot(impulses[k], sph2d__twist_add(r->way, 1, r->state->velocity)) / 2;
    }
    const sph2d_status status = sim->bodies.count > 0 ? meet(sim, dt) : SPH2D_OK;
    for (size_t k = 0; k < sim->bodies.count; ++k)
        sim->bodies.items[k].state->velocity = sim->bodies.items[k].way;
    return status;
}

/* ---- methods whose liquid and bodies move each other all through a step ------------------------------------------ */

sph2d_status sph2d__bodies_carry(sph2d_sim *sim, double dt)
{
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d__rigid *r = &sim->bodies.items[k];
        r->state->pushed = sph2d__twist_add(r->state->pushed, 1, r->state->pressed);
        r->state->liquid = r->state->pushed;
        r->state->acceleration = sph2d__rigid_accelerate(r, sph2d__twist_add(r->other, 1, r->state->pressed));
        /* v(n) + dt/2 A - way is what the mean of the acoustic steps is not. */
        r->done = sph2d__twist_add(r->state->velocity, dt, sph2d__rigid_accelerate(r, r->state->pushed));
        r->done = sph2d__twist_add(r->done, -1, sph2d__twist_add(r->way, -dt / 2, r->state->acceleration));
        sim->record.energy_forces += dt * sph2d__twist_dot(r->state->gap, r->way);
        sim->record.energy_viscous -= dt * sph2d__twist_dot(r->rubbed, r->way);
    }
    const sph2d_status status = sim->bodies.count > 0 ? meet(sim, dt) : SPH2D_OK;
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d__rigid *r = &sim->bodies.items[k];
        const sph2d__twist met = sph2d__twist_add(r->way, -1, r->meant);
        r->state->velocity = sph2d__twist_add(sph2d__twist_add(r->state->velocity, dt, r->state->acceleration), 1, met);
    }
    return status;
}

/* ---- the end of a step ------------------------------------------------------------------------------------------- */

/** Velocities and accelerations of a body's boundary particles, as it is now. */
static void set_walls(sph2d_sim *sim, const sph2d__rigid *r)
{
    sph2d__store *w = &sim->system.walls;
    sph2d__pose pose = sph2d__rigid_at(r, r->start);
    for (uint64_t id = r->first_id; id < r->end_id; ++id) {
        size_t b = sim->system.rigid_index[id - sim->bodies.first];
        sph2d_vec2 p = sph2d__pose_apply(&pose, (sph2d_vec2){w->start_x[b], w->start_y[b]});
        sph2d_vec2 v = sph2d__pose_velocity(&pose, p);
        w->vx[b] = v.x;
        w->vy[b] = v.y;
    }
}

void sph2d__bodies_close(sph2d_sim *sim, double dt)
{
    double end = sim->record.time + dt;
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d__rigid *r = &sim->bodies.items[k];
        sph2d__rigid_state *now = r->state;
        sph2d__twist struck = sph2d__loads_impulse(sim, &sim->bodies.strikes[k]);
        double before = sph2d__rigid_kinetic(r, now->velocity);
        now->place = sph2d__twist_add(r->from, end - r->start, r->way);
        now->velocity = sph2d__twist_add(now->velocity, 1, sph2d__rigid_accelerate(r, struck));
        now->liquid = sph2d__twist_add(now->liquid, 1 / dt, struck);
        sim->record.energy_stopped -= sph2d__rigid_kinetic(r, now->velocity) - before;
        sim->bodies.strikes[k] = (sph2d__strikes){0, 0, 0};
    }
    sph2d__bodies_stand(sim, end);
    for (size_t k = 0; k < sim->bodies.count; ++k)
        set_walls(sim, &sim->bodies.items[k]);
}

void sph2d__bodies_know(sph2d_sim *sim, bool felt)
{
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d__rigid *r = &sim->bodies.items[k];
        r->knows_felt = felt;
        r->way = felt ? r->state->felt_way : r->state->velocity;
        set_walls(sim, r);
    }
}

double sph2d__bodies_share(const sph2d_sim *sim, const sph2d__moving *moving, sph2d_vec2 at, sph2d_vec2 change)
{
    const sph2d__rigid *r = moving->rigid;
    const sph2d__pose *pose = &moving->to;
    double square = change.x * change.x + change.y * change.y;
    double x = at.x - pose->center.x - pose->displacement.x, y = at.y - pose->center.y - pose->displacement.y;
    double turn = x * change.y - y * change.x;
    if (!(square > 0))
        return 1;
    /* By n particles of mass m, each of which keeps 1 - s of its speed towards a body of mass M there, kinetic energy
     * changes by n s (s/2 + s n m/(2 M) - 1) m u^2: it falls for s = 1/(1 + n m/M). No more than these are in front. */
    double gives = (r->free.x * change.x * change.x + r->free.y * change.y * change.y) / (r->mass * square) +
                   r->free.turn * turn * turn / (r->inertia * square);
    double front = fmax(1, SPH2D__PI * r->radius / sim->system.spacing);
    return 1 / (1 + front * sim->system.mass * gives);
}

void sph2d__bodies_strike(sph2d_sim *sim, const sph2d__moving *moving, sph2d_vec2 at, sph2d_vec2 change)
{
    size_t k = (size_t)(moving->rigid - sim->bodies.items);
    const sph2d__pose *pose = &moving->to;
    sph2d_vec2 center = {pose->center.x + pose->displacement.x, pose->center.y + pose->displacement.y};
#pragma omp critical(sph2d_strikes)
    sph2d__loads_strike(sim, &sim->bodies.strikes[k], center, at, change);
}
