/* SPDX-License-Identifier: MIT */
/** @file loads.c */
#include "sim/loads.h"

#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "methods/terms/tension.h"
#include "scene/world.h"
#include "sim/balance.h"
#include "sim/device_steps.h"
#include "sim/simulation.h"
#include "sim/wall_loads.h"

/* ---- which wall -------------------------------------------------------------------------------------------------- */

static bool is_wanted(const sph2d_probe *probe)
{
    return probe->kind == SPH2D_PROBE_FORCE || probe->kind == SPH2D_PROBE_WORK;
}

static bool matches(int wanted, int wall)
{
    return wanted == SPH2D__WALL_ALL || wanted == wall;
}

/** Sets the walls of a boundary particle of the domain's sides: by which side it lies outside, and in corners one for
 *  each direction. */
static void set_sides(const sph2d__world *world, double x, double y, int walls[2])
{
    int beyond[2] = {SPH2D__WALL_ALL, SPH2D__WALL_ALL};
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side)
        if (sph2d__side_distance(&world->box, side, (sph2d_vec2){x, y}) < 0 &&
            sph2d__side_of(&world->scene, side) == SPH2D_SIDE_WALL)
            beyond[side / 2] = side;
    walls[0] = beyond[0] != SPH2D__WALL_ALL ? beyond[0] : beyond[1];
    walls[1] = beyond[1] != SPH2D__WALL_ALL ? beyond[1] : beyond[0];
}

static void set_walls(sph2d_sim *sim)
{
    const sph2d__store *w = &sim->system.walls;
    int(*walls)[2] = sim->loads.walls;
    for (size_t b = 0; b < w->count; ++b)
        set_sides(&sim->world, w->start_x[b], w->start_y[b], walls[w->id[b]]);
    for (size_t k = SPH2D__WALL_OBSTACLE; k < sim->world.wall_count; ++k)
        for (uint64_t id = sim->wall_ids[k].first; id < sim->wall_ids[k].end; ++id)
            walls[id][0] = walls[id][1] = (int)k;
}

static const sph2d__moving *moving_of(const sph2d_sim *sim, int wall)
{
    for (size_t k = 0; k < sim->moving_count; ++k)
        if (sim->moving[k].number == wall)
            return &sim->moving[k];
    return NULL;
}

sph2d_status sph2d__loads_create(sph2d_sim *sim)
{
    const sph2d_scene *scene = &sim->world.scene;
    sph2d__loads *l = &sim->loads;
    size_t count = 0, walls = sim->system.walls.count;
    for (size_t i = 0; i < scene->probe_count; ++i)
        count += is_wanted(&scene->probes[i]);
    l->items = sph2d__arena_alloc(&sim->arena, &sim->memory, count + 1, sizeof *l->items);
    l->states = sph2d__arena_alloc(&sim->arena, &sim->memory, count + 1, sizeof *l->states);
    l->of_probe = sph2d__arena_alloc(&sim->arena, &sim->memory, scene->probe_count + 1, sizeof *l->of_probe);
    l->walls = sph2d__arena_alloc(&sim->arena, &sim->memory, walls + 1, sizeof *l->walls);
    l->forces = sph2d__arena_alloc(&sim->arena, &sim->memory, walls + 1, sizeof *l->forces);
    if (sim->system.surface_tension > 0)
        l->tensions = sph2d__arena_alloc(&sim->arena, &sim->memory, walls + 1, sizeof *l->tensions);
    if ((sim->system.surface_tension > 0 && !l->tensions) || !l->items || !l->states || !l->of_probe || !l->walls ||
        !l->forces)
        return SPH2D_NOMEM;
    set_walls(sim);
    for (size_t i = 0; i < scene->probe_count; ++i) {
        const sph2d_probe *probe = &scene->probes[i];
        if (!is_wanted(probe))
            continue;
        int wall = probe->on ? sph2d__wall_named(&sim->world, probe->on) : SPH2D__WALL_ALL;
        l->of_probe[i] = l->count;
        l->items[l->count++] = (sph2d__load){.wall = wall, .about = probe->at, .moving = moving_of(sim, wall)};
    }
    l->items[l->count] = (sph2d__load){.wall = SPH2D__WALL_ALL};
    return SPH2D_OK;
}

/** The loads that count in this step. */
static size_t counting(const sph2d__loads *l)
{
    return l->count + l->watched;
}

bool sph2d__loads_wanted(const sph2d_sim *sim)
{
    return counting(&sim->loads) > 0;
}

/* ---- forces of boundary particles -------------------------------------------------------------------------------- */

SPH2D__FORCE_OF_WALL(force_around, const sph2d__method *, method, method->wall_force)

sph2d__wall_force sph2d__sim_force_of_wall(const sph2d_sim *sim, size_t b)
{
    const sph2d__system *s = &sim->system;
    if (sim->method->surface_force)
        return s->walls.skin[b] > 0 ? sim->method->surface_force(s, b) : (sph2d__wall_force){{0, 0}, {0, 0}};
    return force_around(s, sim->method, b);
}

/** Whether any load is on a wall. */
static bool any_matches(const sph2d__loads *l, const int walls[2])
{
    for (size_t k = 0; k < counting(l); ++k)
        if (matches(l->items[k].wall, walls[0]) || matches(l->items[k].wall, walls[1]))
            return true;
    return false;
}

/* ---- sums -------------------------------------------------------------------------------------------------------- */

/** Where the point of a load's torques is now. */
static sph2d_vec2 point_of(const sph2d__load *load)
{
    return load->moving ? sph2d__pose_apply(&load->moving->to, load->about) : load->about;
}

/** From the load's point to a position, by the shortest way across periodic sides. */
static sph2d_vec2 arm_to(const sph2d_sim *sim, sph2d_vec2 point, double x, double y)
{
    const sph2d__period *p = &sim->system.fluid_cells.period;
    sph2d_vec2 arm = {x - point.x, y - point.y};
    if (p->length_x > 0)
        arm.x -= p->length_x * nearbyint(arm.x / p->length_x);
    if (p->length_y > 0)
        arm.y -= p->length_y * nearbyint(arm.y / p->length_y);
    return arm;
}

/** Adds a force with its torque. */
static void add_pull(sph2d__pull *to, sph2d_vec2 arm, double x, double y)
{
    to->x += x;
    to->y += y;
    to->torque += arm.x * y - arm.y * x;
}

/** Where the friction of boundary particle b acts: on the surface before it, but for forces along the lines between
 *  particles, which keep angular momentum where they are. */
static sph2d_vec2 rubbed_at(const sph2d_sim *sim, size_t b)
{
    const sph2d__store *w = &sim->system.walls;
    const sph2d_vec2 at = {w->x[b], w->y[b]};
    if (!sim->method->surface_force || !w->depth || !w->normal_x || !(w->depth[b] > 0 && w->depth[b] < INFINITY))
        return at;
    return (sph2d_vec2){at.x + w->depth[b] * w->normal_x[b], at.y + w->depth[b] * w->normal_y[b]};
}

/** Sums over the boundary particles of a load's wall; each force along x and y counts for its own wall. */
static void sum_walls(const sph2d_sim *sim, size_t index, double kept)
{
    const sph2d__loads *l = &sim->loads;
    const sph2d__load *load = &l->items[index];
    const sph2d__store *w = &sim->system.walls;
    sph2d_vec2 point = point_of(load);
    sph2d__load_state *sum = &l->states[index];
    for (size_t b = 0; b < w->count; ++b) {
        const int *walls = l->walls[w->id[b]];
        double in_x = matches(load->wall, walls[0]), in_y = matches(load->wall, walls[1]);
        if (in_x + in_y == 0)
            continue;
        sph2d_vec2 arm = arm_to(sim, point, w->x[b], w->y[b]), rubbed = rubbed_at(sim, b);
        const sph2d__wall_force *force = &l->forces[b];
        sph2d_vec2 press = {in_x * kept * force->pressure.x, in_y * kept * force->pressure.y};
        if (l->tensions)
            press = (sph2d_vec2){press.x + in_x * l->tensions[b].x, press.y + in_y * l->tensions[b].y};
        sph2d_vec2 rub = {in_x * force->friction.x, in_y * force->friction.y};
        add_pull(&sum->pressure, arm, -press.x, -press.y);
        add_pull(&sum->friction, arm_to(sim, point, rubbed.x, rubbed.y), -rub.x, -rub.y);
        sum->power += w->vx[b] * (press.x + rub.x) + w->vy[b] * (press.y + rub.y);
    }
}

/** What the forces of sides are summed up for. */
typedef struct side_load {
    const sph2d_sim *sim;
    sph2d__side_load on;
} side_load;

static void sum_side_forces(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const side_load *load = with;
    for (size_t i = slab->first; i < slab->last; ++i) {
        double fill[4] = {0, 0, 0, 0};
        if (load->sim->method->side_push)
            load->sim->method->side_push(s, i, fill);
        sph2d__add_sides(s, &load->on, i, fill, sum);
    }
}

/** Sums over the particles near spring walls, and sides by what is imagined behind them. */
static void sum_sides(const sph2d_sim *sim, size_t index)
{
    const sph2d__system *s = &sim->system;
    const sph2d__load *load = &sim->loads.items[index];
    sph2d__load_state *state = &sim->loads.states[index];
    if (!(s->forces.springs.stiffness > 0 || sim->method->side_push) || load->wall >= SPH2D__WALL_OBSTACLE)
        return;
    const side_load with = {sim, {load->wall, load->about}};
    const sph2d__slab_sum sum = sph2d__is_on_device(s) ? sph2d__device_sum(s, "sum_sides", &with.on, sizeof with.on)
                                                       : sph2d__sum_fluid(s, sum_side_forces, &with);
    state->springs = (sph2d__pull){s->mass * sum.first, s->mass * sum.second, s->mass * sum.third};
    state->pressure.x += s->mass * sum.x;
    state->pressure.y += s->mass * sum.y;
    state->pressure.torque += s->mass * sum.fourth;
}

void sph2d__loads_find(sph2d_sim *sim, double kept)
{
    sph2d__loads *l = &sim->loads;
    if (!sph2d__loads_wanted(sim))
        return;
    const sph2d__pull none = {0, 0, 0};
    size_t walls = sim->system.walls.count;
    if (sph2d__is_on_device(&sim->system))
        sph2d__device_wall_forces(&sim->system, l->forces);
#pragma omp taskloop num_tasks(sph2d__tasks(walls, SPH2D__LOOK_GRAIN)) if (walls > SPH2D__LOOK_GRAIN)
    for (size_t b = 0; b < walls; ++b)
        if (!sph2d__is_on_device(&sim->system) && any_matches(l, l->walls[sim->system.walls.id[b]]))
            l->forces[b] = sph2d__sim_force_of_wall(sim, b);
    if (l->tensions) {
        memset(l->tensions, 0, walls * sizeof *l->tensions);
        sph2d__tension_of_walls(&sim->system, l->tensions);
    }
    for (size_t k = 0; k < counting(l); ++k) {
        l->items[k].before = l->states[k];
        l->states[k].pressure = l->states[k].friction = l->states[k].springs = none;
        l->states[k].power = 0;
        sum_walls(sim, k, kept);
        sum_sides(sim, k);
        if (sim->method->mean_forces) /* this force acts all through the step */
            l->items[k].before = l->states[k];
    }
}

/* ---- contacts ---------------------------------------------------------------------------------------------------- */

/* Quanta in the momentum of a particle as fast as liquid can fall; the largest count of one contact. */
static const double QUANTA = 4e10, MAX_QUANTA = 1e15;

/** The quanta of impulses [kg/s], their moments [kg m/s], and work [J/m]. */
static sph2d__pull quanta(const sph2d_sim *sim, double *work)
{
    sph2d_box d = sim->world.box;
    double speed = sim->system.head > 0 ? sqrt(2 * sim->system.head) : 1, momentum = sim->system.mass * speed / QUANTA;
    *work = momentum * speed;
    return (sph2d__pull){momentum, momentum, momentum * hypot(d.max.x - d.min.x, d.max.y - d.min.y)};
}

static int64_t count_of(double value, double quantum)
{
    double count = value / quantum;
    return fabs(count) < MAX_QUANTA ? (int64_t)nearbyint(count) : 0;
}

void sph2d__loads_strike(const sph2d_sim *sim, sph2d__strikes *to, sph2d_vec2 point, sph2d_vec2 at, sph2d_vec2 change)
{
    double m = sim->system.mass, unit;
    const sph2d__pull q = quanta(sim, &unit);
    sph2d__pull pull = {0, 0, 0};
    add_pull(&pull, arm_to(sim, point, at.x, at.y), -m * change.x, -m * change.y);
    to->x += count_of(pull.x, q.x);
    to->y += count_of(pull.y, q.y);
    to->turn += count_of(pull.torque, q.torque);
}

sph2d__twist sph2d__loads_impulse(const sph2d_sim *sim, const sph2d__strikes *of)
{
    double unit;
    const sph2d__pull q = quanta(sim, &unit);
    return (sph2d__twist){(double)of->x * q.x, (double)of->y * q.y, (double)of->turn * q.torque};
}

/** Counts an impulse of the liquid on the walls of the two directions. */
static void count_contact(sph2d_sim *sim, const int walls[2], sph2d_vec2 at, sph2d_vec2 change, double work)
{
    double m = sim->system.mass, unit;
    const sph2d__pull q = quanta(sim, &unit);
#pragma omp critical(sph2d_contacts)
    for (size_t k = 0; k < counting(&sim->loads); ++k) {
        sph2d__load *load = &sim->loads.items[k];
        double in_x = matches(load->wall, walls[0]), in_y = matches(load->wall, walls[1]);
        if (in_x + in_y == 0)
            continue;
        sph2d__pull pull = {0, 0, 0};
        add_pull(&pull, arm_to(sim, point_of(load), at.x, at.y), -m * in_x * change.x, -m * in_y * change.y);
        load->hit_x += count_of(pull.x, q.x);
        load->hit_y += count_of(pull.y, q.y);
        load->hit_turn += count_of(pull.torque, q.torque);
        load->given += count_of(work, unit);
    }
}

void sph2d__loads_contact(sph2d_sim *sim, int wall, sph2d_vec2 at, sph2d_vec2 change, double work)
{
    const int walls[2] = {wall, wall};
    if (sph2d__loads_wanted(sim))
        count_contact(sim, walls, at, change, work);
}

void sph2d__loads_reflect(sph2d_sim *sim, size_t b, sph2d_vec2 at, sph2d_vec2 change)
{
    if (sph2d__loads_wanted(sim))
        count_contact(sim, sim->loads.walls[sim->system.walls.id[b]], at, change, 0);
}

void sph2d__loads_carry(sph2d_sim *sim, int wall, double work)
{
    for (size_t k = 0; k < sim->loads.count; ++k)
        if (matches(sim->loads.items[k].wall, wall))
            sim->loads.states[k].work += work;
}

/* ---- steps ------------------------------------------------------------------------------------------------------- */

static void add_impulse(sph2d__pull *to, double dt, const sph2d__pull *from)
{
    to->x += dt * from->x;
    to->y += dt * from->y;
    to->torque += dt * from->torque;
}

/** Adds what acts at one end of a step, over half of it. */
static void add_half(sph2d__pull *to, double dt, const sph2d__load_state *at)
{
    add_impulse(to, dt / 2, &at->pressure);
    add_impulse(to, dt / 2, &at->friction);
    add_impulse(to, dt / 2, &at->springs);
}

void sph2d__loads_close(sph2d_sim *sim, double dt)
{
    for (size_t k = 0; k < counting(&sim->loads); ++k) {
        sph2d__load *load = &sim->loads.items[k];
        sph2d__load_state *now = &sim->loads.states[k];
        double unit;
        const sph2d__pull q = quanta(sim, &unit);
        now->contact = (sph2d__pull){(double)load->hit_x * q.x / dt, (double)load->hit_y * q.y / dt,
                                     (double)load->hit_turn * q.torque / dt};
        add_half(&now->impulse, dt, &load->before);
        add_half(&now->impulse, dt, now);
        add_impulse(&now->impulse, dt, &now->contact);
        now->work += dt / 2 * (load->before.power + now->power) + (double)load->given * unit;
        load->hit_x = load->hit_y = load->hit_turn = load->given = 0;
    }
}

void sph2d__loads_sampled(sph2d_sim *sim, size_t probe)
{
    if (sim->loads.count > 0 && is_wanted(&sim->world.scene.probes[probe]))
        sim->loads.states[sim->loads.of_probe[probe]].impulse = (sph2d__pull){0, 0, 0};
}
