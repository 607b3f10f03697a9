/* SPDX-License-Identifier: MIT */
/** @file work.c
 *  External work on the liquid, and dissipation: with the energy of the particles they make the energy balance.
 *
 *  Powers are sampled every so many steps, and integrated over time by the trapezoidal rule,
 *
 *      walls      sum_b v_b . F_b            F_b force of boundary particle b on the liquid by pressure and friction
 *      forces     sum_i m v_i . f_i          f_i what has no potential: forces/forces.h
 *      viscosity  sum_i m v_i . (a_i(v) - a_i(-v))/2
 *      diffusion  sum_i m p_i/rho_i^2 drho_i/dt, likewise: fitted operators
 *
 *  Viscous forces are odd in velocity, pressures even. Two evaluations of the method's own forces, with the velocities
 *  and with all of them reversed, therefore give the exact power of friction, less what the forces of forces/forces.h
 *  that are odd do, too, whose table books each by itself. The dissipated heat is minus this power plus the work of
 *  moving walls by friction, which is part of the first line.
 *
 *  The work of walls on bodies by contact is booked with each step, as the solver for contacts tells it (bodies.c).
 *
 *  Fitted operators have no forces between particles and walls. With them the friction of sliding sides is part of the
 *  viscous power, and the pressure on moving obstacles is not known. */
#include <math.h>

#include "methods/common/slabs.h"
#include "methods/common/state_equation.h"
#include "sim/balance.h"
#include "sim/device_steps.h"
#include "sim/simulation.h"

/* Most and fewest steps between samples of friction and diffusion, each of which costs the sums of another step. Between
 * the two the span follows the change of power, so that the trapezoidal rule leaves about this part of the energy scale:
 * with 40 steps throughout, thick liquid that rows of a source enter had 5 % too little friction. Steps whose number is
 * a power of two are sampled, too, since an impulsive start has much friction. External work is sampled more often:
 * moving walls are few, their pressure oscillates with sound, and liquid passes an interaction in some steps. */
static const double SAMPLE_ERROR = 1e-4;
enum { SAMPLE_STEPS = 40, SAMPLE_STEPS_FITTED = 60, SAMPLE_STEPS_LEAST = 8, EXTERNAL_STEPS = 4 };

static bool is_fitted(const sph2d_sim *sim)
{
    return sim->system.method.operators == SPH2D_OPERATORS_FITTED;
}

bool sph2d__sim_samples_energy(const sph2d_sim *sim, uint64_t steps)
{
    uint64_t every = is_fitted(sim) ? SAMPLE_STEPS_FITTED : SAMPLE_STEPS;
    return steps % every == 0 || (steps & (steps - 1)) == 0 || steps == sim->record.sample_step;
}

/* The work of moving obstacles is booked by the forces of boundary particles, or by the method, but for that of friction. */
bool sph2d__sim_error_is_known(const sph2d_sim *sim)
{
    bool sticks = false;
    for (size_t k = 0; k < sim->moving_count && !sticks; ++k)
        sticks = sim->moving[k].wall->slip != SPH2D_SLIP_FREE;
    return sim->moving_count == 0 || sim->method->wall_force || (sim->method->books_walls && !sticks);
}

bool sph2d__sim_rise_is_known(const sph2d_sim *sim)
{
    const sph2d_side_speeds *v = &sim->world.scene.wall_speeds;
    bool slide = v->left != 0 || v->right != 0 || v->bottom != 0 || v->top != 0;
    return sim->method->wall_force || (sph2d__sim_error_is_known(sim) && !slide);
}

/* ---- walls ------------------------------------------------------------------------------------------------------- */

/** Power of moving walls: in total, and by friction [W/m]. */
typedef struct wall_powers {
    double all, friction;
} wall_powers;

/** Adds the powers of one boundary particle on the liquid around it. */
static void add_wall(const sph2d_sim *sim, size_t b, sph2d__wall_force force, wall_powers *power)
{
    const sph2d__store *w = &sim->system.walls;
    double friction_power = w->vx[b] * force.friction.x + w->vy[b] * force.friction.y;
    const bool free = w->id[b] >= sim->bodies.first && w->id[b] < sim->bodies.end;
    power->friction += free && sim->method->books_all ? 0 : friction_power;
    if (free)
        return; /* the energy of bodies is part of the balance */
    power->all += w->vx[b] * force.pressure.x + w->vy[b] * force.pressure.y + friction_power;
}

static wall_powers powers_of_walls(const sph2d_sim *sim)
{
    const sph2d__store *w = &sim->system.walls;
    wall_powers power = {0, 0};
    bool found = false;
    for (size_t b = 0; sim->method->wall_force && b < w->count; ++b) {
        if (w->vx[b] == 0 && w->vy[b] == 0)
            continue;
        if (sph2d__is_on_device(&sim->system) && !found)
            sph2d__device_wall_forces(&sim->system, sim->loads.forces);
        found = true;
        add_wall(sim, b, sph2d__is_on_device(&sim->system) ? sim->loads.forces[b] : sph2d__sim_force_of_wall(sim, b),
                 &power);
    }
    return power;
}

/** The work over a time span by the trapezoidal rule from the last and the present power; *last becomes `power`. */
static double integrate(double *last, double power, double span)
{
    double work = span * (*last + power) / 2;
    *last = power;
    return work;
}

double sph2d__sim_book_wall_work(sph2d_sim *sim, double dt)
{
    wall_powers power = powers_of_walls(sim);
    sim->record.energy_walls += dt * power.all;
    sim->record.energy_viscous += dt * power.friction;
    return dt * (power.all - power.friction);
}

/* ---- forces ------------------------------------------------------------------------------------------------------ */

static void sum_power(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const sph2d__work_kind *kind = with;
    for (size_t i = slab->first; i < slab->last; ++i)
        sph2d__add_power(s, *kind, i, sum);
}

/** Power of the forces without a potential whose work is of a kind [W/m]. */
static double power_of(const sph2d_sim *sim, sph2d__work_kind kind)
{
    const sph2d__system *s = &sim->system;
    if (!sph2d__forces_drive_at_all(&s->forces, kind))
        return 0;
    return s->mass * (sph2d__is_on_device(s) ? sph2d__device_sum(s, "sum_power", &kind, sizeof kind)
                                             : sph2d__sum_fluid(s, sum_power, &kind))
                         .first;
}

double sph2d__sim_power_of_forces(const sph2d_sim *sim)
{
    return power_of(sim, SPH2D__WORK) + sph2d__bodies_power(sim);
}

void sph2d__sim_book_external_work(sph2d_sim *sim)
{
    sph2d__record *r = &sim->record;
    if (r->steps % EXTERNAL_STEPS != 0 && !sph2d__sim_samples_energy(sim, r->steps))
        return;
    double span = r->time - r->drives_time;
    const double power_of_forces = sim->method->books_all ? sph2d__bodies_power(sim) : sph2d__sim_power_of_forces(sim);
    r->energy_forces += integrate(&r->power_forces, power_of_forces, span);
    r->drives_time = r->time;
    if (sim->method->mean_forces)
        return;
    wall_powers power = powers_of_walls(sim);
    r->energy_walls += integrate(&r->power_walls, power.all, span);
    r->energy_viscous += integrate(&r->power_friction, power.friction, span);
}

bool sph2d__sim_external_work_is_booked(const sph2d_sim *sim)
{
    bool none = sim->method->mean_forces && sim->bodies.count == 0 &&
                (sim->method->books_all || !sph2d__forces_drive_at_all(&sim->system.forces, SPH2D__WORK));
    return none || sim->record.drives_time == sim->record.time;
}

/* ---- viscosity --------------------------------------------------------------------------------------------------- */

static void reverse(sph2d__store *t)
{
    for (size_t i = 0; i < t->count; ++i) {
        t->vx[i] = -t->vx[i];
        t->vy[i] = -t->vy[i];
    }
}

/** Reverses all velocities, and the velocity gradients of the last step. Where walls move, the tank turns the other way,
 *  too: the pressures of walls by Coriolis' force, which does no work, stay as they are. */
static void reverse_all(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    sph2d__store *f = &s->fluid;
    for (size_t i = 0; i < f->count && f->stretch; ++i) {
        f->stretch[i] = -f->stretch[i];
        f->shear[i] = -f->shear[i];
    }
    if (sph2d__is_on_device(s))
        sph2d__device_span(s, "reverse_velocities", f->count);
    else
        reverse(f);
    reverse(&s->walls);
    sph2d__host_changed_walls(s, SPH2D__BIT(vx) | SPH2D__BIT(vy));
    if (sim->moving_count > 0)
        s->forces.frame.omega = -s->forces.frame.omega;
}

/** Evaluates the forces with all velocities reversed. */
static bool evaluate_reversed(sph2d_sim *sim)
{
    sph2d__profile *profile = &sim->system.profile;
    bool on = profile->on;
    profile->on = false; /* all of this counts as bookkeeping */
    sph2d__bodies_know(sim, true);
    reverse_all(sim);
    bool ok = sim->method->evaluate(&sim->system);
    reverse_all(sim);
    sph2d__bodies_know(sim, false);
    profile->on = on;
    return ok;
}

static void sum_work(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    (void)with;
    for (size_t i = slab->first; i < slab->last; ++i)
        sph2d__add_work(s, i, sum);
}

/** Power of the accelerations, and of what of the forces is odd in velocity, which the table of forces books by itself [W/m]. */
typedef struct powers {
    double all, odd;
} powers;

static powers powers_of_all(const sph2d__system *s)
{
    const sph2d__slab_sum sum =
        sph2d__is_on_device(s) ? sph2d__device_sum(s, "sum_work", NULL, 0) : sph2d__sum_fluid(s, sum_work, NULL);
    return (powers){s->mass * sum.first, s->mass * sum.second};
}

static void swap(double **a, double **b)
{
    double *array = *a;
    *a = *b;
    *b = array;
}

/** Exchanges the accelerations with arrays that are unused between steps. */
static void swap_accelerations(sph2d__store *f)
{
    bool leapfrog = f->old_ax;
    swap(&f->ax, leapfrog ? &f->old_ax : &f->next_x);
    swap(&f->ay, leapfrog ? &f->old_ay : &f->next_y);
}

static bool find_viscous_power(sph2d_sim *sim, double *power)
{
    sph2d__system *s = &sim->system;
    double forward = powers_of_all(s).all;
    swap_accelerations(&s->fluid);
    bool ok = true;
    if (sim->openings.count > 0) { /* a step has set the accelerations in reservoirs to 0 */
        ok = sim->method->evaluate(s);
        forward = powers_of_all(s).all;
    }
    ok = evaluate_reversed(sim) && ok;
    const powers reversed = powers_of_all(s);
    swap_accelerations(&s->fluid);
    *power = (forward - reversed.all) / 2 - reversed.odd + power_of(sim, SPH2D__LOSS);
    return ok;
}

/* ---- fitted operators -------------------------------------------------------------------------------------------- */

/** Sum of v . a and of p/rho^2 drho/dt over the particles that are in no reservoir of an opening. */
static void sum_rates(const sph2d_sim *sim, double *motion, double *compression)
{
    const sph2d__store *f = &sim->system.fluid;
    *motion = *compression = 0;
    for (size_t i = 0; i < f->count; ++i) {
        if (sph2d__opening_at(sim, f->x[i], f->y[i]))
            continue;
        *motion += f->vx[i] * f->ax[i] + f->vy[i] * f->ay[i];
        *compression +=
            sph2d__pressure_of(&sim->system, f->density[i]) / (f->density[i] * f->density[i]) * f->density_rate[i];
    }
}

bool sph2d__sim_book_fitted(sph2d_sim *sim, double dt)
{
    sph2d__system *s = &sim->system;
    sph2d__record *r = &sim->record;
    if (!sph2d__sim_samples_energy(sim, r->steps + 1))
        return sim->method->evaluate(s);
    if (!evaluate_reversed(sim))
        return false;
    double reversed, forward, there, back;
    sum_rates(sim, &reversed, &back);
    if (!sim->method->evaluate(s))
        return false;
    sum_rates(sim, &forward, &there);
    double span = r->time + dt - r->booked_time;
    r->energy_diffused -= integrate(&r->power_diffusion, (s->mass * back + s->mass * there) / 2, span);
    const double viscous = s->mass * (forward - reversed) / 2 - powers_of_all(s).odd + power_of(sim, SPH2D__LOSS);
    r->energy_viscous -= integrate(&r->power_viscous, viscous, span);
    return true;
}

/* ---- dissipation ------------------------------------------------------------------------------------------------- */

bool sph2d__sim_book_viscosity(sph2d_sim *sim, double dt)
{
    sph2d__record *r = &sim->record;
    double viscous = r->power_viscous;
    if (!sph2d__sim_samples_energy(sim, r->steps + 1))
        return true;
    if (!find_viscous_power(sim, &viscous))
        return false;
    r->energy_viscous -= integrate(&r->power_viscous, viscous, r->time + dt - r->booked_time);
    return true;
}

/** Chooses the step of the next sample, if that is to be an early one. The error of the trapezoidal rule is at most half
 *  the change of power times the span, and both shrink with the span. */
static void schedule_sample(sph2d_sim *sim, double span)
{
    sph2d__record *r = &sim->record;
    double power = r->power_viscous + r->power_diffusion, change = fabs(power - r->power_dissipated);
    double allowed = SAMPLE_ERROR * sph2d__sim_fall_energy(sim), error = change * span / 2;
    double steps = error > 0 ? span / r->last_step * sqrt(allowed / error) : SAMPLE_STEPS;
    r->sample_step = r->steps + (uint64_t)fmin(fmax(steps, SAMPLE_STEPS_LEAST), SAMPLE_STEPS);
    r->power_dissipated = power;
}

sph2d_status sph2d__sim_book_dissipation(sph2d_sim *sim)
{
    sph2d__record *r = &sim->record;
    double span = r->time - r->booked_time, viscous = r->power_viscous;
    if (!is_fitted(sim) && !sim->method->books_pressure && !sim->method->books_all) {
        if (!find_viscous_power(sim, &viscous))
            return SPH2D_NOMEM;
        r->energy_viscous -= integrate(&r->power_viscous, viscous, span);
    }
    schedule_sample(sim, span);
    r->booked_time = r->time;
    return SPH2D_OK;
}
