/* SPDX-License-Identifier: MIT */
/** @file work.c
 *  Work that is done on the liquid, and what dissipates: the other side of the energy that the particles have.
 *
 *  The power of each is looked at every so many steps, and summed by the trapezium in time,
 *
 *      walls      sum_b v_b . F_b            F_b what boundary particle b does to the liquid by pressure and friction
 *      forces     sum_i m v_i . f_i          f_i interactions, the pointer, gravity along a period
 *      viscosity  sum_i m v_i . (a_i(v) - a_i(-v))/2
 *      diffusion  sum_i m p_i/rho_i^2 (drho_i/dt less the same without diffusion)
 *
 *  Viscous forces are odd in velocity, all others even, so that two evaluations of the method's own forces, with the
 *  velocities and with all of them turned round, tell the power of friction: what is measured is what acts. What
 *  became heat is that with the other sign and what moving walls brought by friction, which the first line has.
 *  Springs of walls have a potential (sph2d__sim_energy_of) and a damping, which is summed by itself: it has a limit
 *  and is not odd.
 *
 *  Fitted operators have no forces between particles and walls. There the friction of sides that slide is part of what
 *  viscosity does, and the pressure of obstacles that move is not known. */
#include <math.h>

#include "methods/common/state_equation.h"
#include "sim/simulation.h"

/* Steps from look to look; those whose number is a power of two are looked at, too, since what starts at once begins
 * with much friction. Friction and diffusion take a step's sums once more in so many. Walls that move are few, what
 * they press changes with the sound, and liquid passes an interaction in some steps. */
enum { LOOK_STEPS = 40, LOOK_STEPS_FITTED = 60, DRIVE_STEPS = 4 };

static bool is_fitted(const sph2d_sim *sim)
{
    return sim->system.method.operators == SPH2D_OPERATORS_FITTED;
}

bool sph2d__sim_looks(const sph2d_sim *sim, uint64_t steps)
{
    uint64_t every = is_fitted(sim) ? LOOK_STEPS_FITTED : LOOK_STEPS;
    return steps % every == 0 || (steps & (steps - 1)) == 0;
}

bool sph2d__sim_error_is_known(const sph2d_sim *sim)
{
    return sim->moving_count == 0 || sim->method->wall_force;
}

bool sph2d__sim_rise_is_known(const sph2d_sim *sim)
{
    const sph2d_side_speeds *v = &sim->scene.wall_speeds;
    bool slide = v->left != 0 || v->right != 0 || v->bottom != 0 || v->top != 0;
    return sim->method->wall_force || (sim->moving_count == 0 && !slide);
}

/* ---- walls ------------------------------------------------------------------------------------------------------- */

/** Powers of walls [W/m]. */
typedef struct wall_powers {
    double all, friction;
} wall_powers;

/** Adds the powers of one boundary particle on the liquid around it. */
static void add_wall(const sph2d_sim *sim, size_t b, wall_powers *power)
{
    const sph2d__system *s = &sim->system;
    const sph2d__store *w = &s->walls, *f = &s->fluid;
    uint32_t cell = sph2d__cells_find(&s->fluid_cells, w->x[b], w->y[b]);
    if (w->bounce[b] >= 0 || cell == UINT32_MAX)
        return;
    sph2d_vec2 pressure = {0, 0}, friction = {0, 0};
    sph2d__ranges ranges;
    sph2d__cells_ranges(&s->fluid_cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, i) {
        double dx = f->x[i] - (w->x[b] + ranges.x[r]), dy = f->y[i] - (w->y[b] + ranges.y[r]);
        if (!(dx * dx + dy * dy < s->support * s->support))
            continue;
        sph2d__wall_force force = sim->method->wall_force(s, i, b, dx, dy);
        pressure = (sph2d_vec2){pressure.x + force.pressure.x, pressure.y + force.pressure.y};
        friction = (sph2d_vec2){friction.x + force.friction.x, friction.y + force.friction.y};
    }
    double rubbed = w->vx[b] * friction.x + w->vy[b] * friction.y;
    power->friction += rubbed;
    power->all += w->vx[b] * pressure.x + w->vy[b] * pressure.y + rubbed;
}

static wall_powers powers_of_walls(const sph2d_sim *sim)
{
    const sph2d__store *w = &sim->system.walls;
    wall_powers power = {0, 0};
    for (size_t b = 0; sim->method->wall_force && b < w->count; ++b)
        if (w->vx[b] != 0 || w->vy[b] != 0)
            add_wall(sim, b, &power);
    return power;
}

/** Adds power times the time since the last look to a sum, by the trapezium. */
static double sum_up(double *last, double power, double span)
{
    double work = span * (*last + power) / 2;
    *last = power;
    return work;
}

double sph2d__sim_book_projection(sph2d_sim *sim, double dt)
{
    double work = dt * powers_of_walls(sim).all;
    sim->record.energy_walls += work;
    return work;
}

/* ---- forces ------------------------------------------------------------------------------------------------------ */

/** Power of interactions and of gravity along periods. */
static double power_of_forces(const sph2d_sim *sim)
{
    const sph2d__system *s = &sim->system;
    const sph2d__body *b = &s->body;
    const sph2d__store *f = &s->fluid;
    const sph2d__period *p = &s->fluid_cells.period;
    double gx = p->length_x > 0 ? b->gravity_x : 0, gy = p->length_y > 0 ? b->gravity_y : 0, power = 0;
    if (b->point_count == 0 && gx == 0 && gy == 0)
        return 0;
    for (size_t i = 0; i < f->count; ++i) {
        double ax = gx, ay = gy;
        for (size_t k = 0; k < b->point_count; ++k)
            sph2d__point_force_add(&b->points[k], f->x[i], f->y[i], &ax, &ay);
        power += f->vx[i] * ax + f->vy[i] * ay;
    }
    return s->mass * power;
}

void sph2d__sim_book_drives(sph2d_sim *sim)
{
    sph2d__record *r = &sim->record;
    if (r->steps % DRIVE_STEPS != 0 && !sph2d__sim_looks(sim, r->steps))
        return;
    double span = r->time - r->drives_time;
    r->energy_forces += sum_up(&r->power_forces, power_of_forces(sim), span);
    r->drives_time = r->time;
    if (sim->method->project)
        return;
    wall_powers power = powers_of_walls(sim);
    r->energy_walls += sum_up(&r->power_walls, power.all, span);
    r->energy_viscous += sum_up(&r->power_friction, power.friction, span);
}

/* ---- viscosity --------------------------------------------------------------------------------------------------- */

static void turn(sph2d__store *t)
{
    for (size_t i = 0; i < t->count; ++i) {
        t->vx[i] = -t->vx[i];
        t->vy[i] = -t->vy[i];
    }
}

/** Velocities of all, and what the last step found of their gradients. */
static void turn_all(sph2d__system *s)
{
    sph2d__store *f = &s->fluid;
    for (size_t i = 0; i < f->count && f->stretch; ++i) {
        f->stretch[i] = -f->stretch[i];
        f->shear[i] = -f->shear[i];
    }
    turn(f);
    turn(&s->walls);
}

/** Evaluates with all velocities turned round; accelerations go where the store has room for them. */
static bool evaluate_turned(sph2d_sim *sim)
{
    sph2d__profile *profile = &sim->system.profile;
    bool on = profile->on;
    profile->on = false; /* all of this is watching */
    turn_all(&sim->system);
    bool ok = sim->method->evaluate(&sim->system);
    turn_all(&sim->system);
    profile->on = on;
    return ok;
}

static double dot_accelerations(const sph2d__store *f)
{
    double sum = 0;
    for (size_t i = 0; i < f->count; ++i)
        sum += f->vx[i] * f->ax[i] + f->vy[i] * f->ay[i];
    return sum;
}

/** What the springs of walls do by their damping, less the odd part of all that they do. */
static double power_of_dampers(const sph2d__system *s)
{
    const sph2d__store *f = &s->fluid;
    double power = 0;
    for (size_t i = 0; i < f->count && s->body.springs.stiffness > 0; ++i) {
        double there[2] = {0, 0}, back[2] = {0, 0}, still[2] = {0, 0};
        sph2d__spring_walls_add(&s->body.springs, f->x[i], f->y[i], f->vx[i], f->vy[i], &there[0], &there[1]);
        sph2d__spring_walls_add(&s->body.springs, f->x[i], f->y[i], -f->vx[i], -f->vy[i], &back[0], &back[1]);
        sph2d__spring_walls_add(&s->body.springs, f->x[i], f->y[i], 0, 0, &still[0], &still[1]);
        power += f->vx[i] * ((there[0] + back[0]) / 2 - still[0]) + f->vy[i] * ((there[1] + back[1]) / 2 - still[1]);
    }
    return s->mass * power;
}

static void swap(double **a, double **b)
{
    double *array = *a;
    *a = *b;
    *b = array;
}

/** Accelerations into the arrays that nobody needs between steps, and back. */
static void put_aside(sph2d__store *f)
{
    bool leapfrog = f->old_ax != NULL;
    swap(&f->ax, leapfrog ? &f->old_ax : &f->next_x);
    swap(&f->ay, leapfrog ? &f->old_ay : &f->next_y);
}

/** Whether anything in the scene resists motion. */
static bool is_viscous(const sph2d__system *s)
{
    const sph2d_method_options *m = &s->method;
    bool eddies = m->turbulence == SPH2D_TURBULENCE_SMAGORINSKY;
    return s->viscosity > 0 || m->artificial_viscosity > 0 || eddies || s->body.springs.stiffness > 0;
}

static bool find_viscous_power(sph2d_sim *sim, double *power)
{
    sph2d__system *s = &sim->system;
    if (!is_viscous(s))
        return true;
    double there = dot_accelerations(&s->fluid);
    put_aside(&s->fluid);
    bool ok = evaluate_turned(sim);
    double back = dot_accelerations(&s->fluid);
    put_aside(&s->fluid);
    *power = s->mass * (there - back) / 2 + power_of_dampers(s);
    return ok;
}

/* ---- diffusion of density ---------------------------------------------------------------------------------------- */

/** Power of rates of density: sum m p/rho^2 rate, at the density in the middle of the step. */
static double power_of_rates(const sph2d__system *s, const double *rate, double dt)
{
    const sph2d__store *f = &s->fluid;
    double sum = 0;
    for (size_t i = 0; i < f->count; ++i) {
        double density = f->density[i] + dt / 2 * f->density_rate[i];
        sum += sph2d__pressure_of(s, density) / (density * density) * rate[i];
    }
    return s->mass * sum;
}

void sph2d__sim_book_diffusion(sph2d_sim *sim, double dt)
{
    sph2d__system *s = &sim->system;
    sph2d__store *f = &s->fluid;
    double delta = s->method.density_diffusion;
    if (!sph2d__sim_looks(sim, sim->record.steps + 1) || !(delta > 0))
        return;
    double all = power_of_rates(s, f->density_rate, dt);
    swap(&f->density_rate, &f->old_ax);
    sph2d_phase before = sph2d__profile_enter(&s->profile, SPH2D_PHASE_BOOKKEEPING);
    bool on = s->profile.on;
    s->profile.on = false;
    s->method.density_diffusion = 0;
    sim->method->density_rate(s);
    s->method.density_diffusion = delta;
    s->profile.on = on;
    sph2d__profile_enter(&s->profile, before);
    swap(&f->density_rate, &f->old_ax);
    double power = all - power_of_rates(s, f->old_ax, dt), span = sim->record.time + dt - sim->record.booked_time;
    sim->record.energy_diffused -= sum_up(&sim->record.power_diffusion, power, span);
}

bool sph2d__sim_book_fitted(sph2d_sim *sim, double dt)
{
    sph2d__system *s = &sim->system;
    sph2d__record *r = &sim->record;
    if (!sph2d__sim_looks(sim, r->steps + 1))
        return sim->method->evaluate(s);
    if (!evaluate_turned(sim))
        return false;
    double back = dot_accelerations(&s->fluid), rates = power_of_rates(s, s->fluid.density_rate, 0);
    if (!sim->method->evaluate(s))
        return false;
    double there = dot_accelerations(&s->fluid), span = r->time + dt - r->booked_time;
    rates += power_of_rates(s, s->fluid.density_rate, 0);
    r->energy_diffused -= sum_up(&r->power_diffusion, rates / 2, span);
    r->energy_viscous -= sum_up(&r->power_viscous, s->mass * (there - back) / 2, span);
    return true;
}

/* ---- the books --------------------------------------------------------------------------------------------------- */

bool sph2d__sim_book_middle(sph2d_sim *sim, double dt)
{
    sph2d__record *r = &sim->record;
    double viscous = r->power_viscous;
    if (!sph2d__sim_looks(sim, r->steps + 1))
        return true;
    if (!find_viscous_power(sim, &viscous))
        return false;
    r->energy_viscous -= sum_up(&r->power_viscous, viscous, r->time + dt - r->booked_time);
    return true;
}

sph2d_status sph2d__sim_book(sph2d_sim *sim)
{
    sph2d__record *r = &sim->record;
    double span = r->time - r->booked_time, viscous = r->power_viscous;
    if (!is_fitted(sim) && !sim->method->project) {
        if (!find_viscous_power(sim, &viscous))
            return SPH2D_NOMEM;
        r->energy_viscous -= sum_up(&r->power_viscous, viscous, span);
    }
    r->booked_time = r->time;
    return SPH2D_OK;
}
