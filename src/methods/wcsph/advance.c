/* SPDX-License-Identifier: MIT */
/** @file advance.c
 *  One step of method `wcsph`: acoustic steps over pairs that stand still in the middle of it,
 *
 *      theta <- theta + dt/2 D(v),  x <- x + dt/2 v
 *      v     <- v + dt f(theta)/m
 *      theta <- theta + dt/2 D(v),  x <- x + dt/2 v,  theta <- theta + dt diffusion
 *
 *  With a fixed pair of transposed operators it keeps K + U - m (c0 dt D)^2/8 (Hairer, Lubich & Wanner 2006, sec. IX.8), so
 *  that K + U falls by what D^2 rises when neighbours are found anew. That is booked as dissipated. */
#include <math.h>
#include <string.h>

#include "base/parallel.h"
#include "methods/common/on_device.h"
#include "methods/wcsph/wcsph.h"
#include "methods/wcsph/wcsph_spans.h"
#include "sim/stages.h"

/** The whole way of the step. */
static void go(sph2d_sim *sim, double dt, sph2d__batch *w)
{
    const double quantum = sph2d__sim_energy_quantum(sim);
    for (size_t k = 0; k < w->count; ++k) {
        const sph2d__way way = whole_way(&sim->system, dt, w->first + k);
        w->dx[k] = way.dx;
        w->dy[k] = way.dy;
        w->vx[k] = way.v.x;
        w->vy[k] = way.v.y;
        w->diffused += sph2d__quanta_of(quantum, way.diffused);
    }
}

/* ---- relaxation of density --------------------------------------------------------------------------------------- */

/* In how many H/c0 density goes to its sum over the neighbours. */
static const double RELAXATION_TIME = 100;

SPH2D__SLAB_WORK(sum_relaxed, add_relaxed(s, i, with, sum))

SPH2D__SLAB_WORK(relax_slab, relax_one(s, i, with, sum))

/** Energy dissipated so far [J/m]. */
static double dissipated(const sph2d_sim *sim)
{
    return sim->record.energy_pressed + sim->record.energy_diffused + sim->record.energy_viscous;
}

/** Moves densities towards their sums, as far as what the step has dissipated, `paid`, pays for it: energy never rises by
 *  it. */
static void relax(sph2d_sim *sim, double dt, double paid)
{
    sph2d__system *s = &sim->system;
    sph2d__record *r = &sim->record;
    double part = fmin(dt * s->sound_speed / (RELAXATION_TIME * s->support), 1);
    const double stiffness = s->mass * s->sound_speed * s->sound_speed;
    const double asked = stiffness * sph2d__over_fluid(s, sum_relaxed, &part, "sum_relaxed_pass", sizeof part).first;
    if (asked > 0)
        part *= fmin(fmax(paid, 0) / asked, 1);
    r->energy_diffused -= stiffness * sph2d__over_fluid(s, relax_slab, &part, "relax_pass", sizeof part).first;
}

/* ---- shifting ---------------------------------------------------------------------------------------------------- */

SPH2D__SLAB_WORK(sum_lifted, add_lifted(s, i, sum))

SPH2D__SLAB_WORK(shorten_slab, shorten_one(s, i, with))

/** Shifts as far as what is left of the step's dissipation, `paid`, lifts the particles: in a full tank they would rise
 *  for ever, and sink by pressures that this makes. */
static void pay_for_shift(sph2d__system *s, double paid)
{
    if (!s->fills)
        return;
    const double work = s->mass * sph2d__over_fluid(s, sum_lifted, NULL, "sum_lifted_pass", 0).first;
    const double part = fmax(paid, 0) / work;
    if (work > 0 && part < 1)
        sph2d__each_of_fluid(s, shorten_slab, &part, "shorten_pass", sizeof part);
}

/* ---- the step ---------------------------------------------------------------------------------------------------- */

static void rate_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const sweep_times *t = with;
    sph2d__wcsph_find(s->isa)->rate(s, slab->first, slab->last, t->before, t->after, t->rest, sum);
}

static void force_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const double *once = with;
    sph2d__wcsph_find(s->isa)->force(s, slab->first, slab->last, *once, sum);
}

static void swap(SPH2D__ARRAY float **a, SPH2D__ARRAY float **b)
{
    SPH2D__ARRAY float *c = *a;
    *a = *b;
    *b = c;
}

/** As many as the liquid needs, with the viscosity that it has now, and bodies. */
static size_t acoustic_steps(sph2d__system *s, double dt)
{
    const double liquid = fmax((double)sph2d__acoustic_steps(s, dt), round(dt / s->frozen->dt));
    return (size_t)fmax(liquid, s->rigid_count > 0 ? ceil(dt * sph2d__frozen_bodies_rate(s)) : 0);
}

/** Power of what is withheld from particles in reservoirs [W/m]: the half of an acoustic step after a kick has their next
 *  velocities. */
static double withheld_power(const sph2d__system *s)
{
    const sph2d__frozen *z = s->frozen;
    double sum = 0;
    for (size_t i = 0; i < s->fluid.count; ++i)
        sum += z->withheld_x[i] * s->fluid.vx[i] + z->withheld_y[i] * s->fluid.vy[i];
    return s->mass * sum;
}

/** Sets particles in reservoirs to what openings prescribe by the liquid before them now. Once a step would be too late: a
 *  row of particles before a reservoir answers in 1/(N B c0), a third of a step, and swings ever more. */
static double impose(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    sph2d__frozen *z = s->frozen;
    if (!z->holds)
        return 0;
    const double before = withheld_power(s);
    for (size_t i = 0; i < s->fluid.count; ++i)
        s->fluid.density[i] = s->rest_density * sph2d__density_ratio(s->fluid.log_density[i]);
    sph2d__openings_impose(sim);
    for (size_t i = 0; i < s->fluid.count; ++i)
        if (z->held[i] > 0)
            sph2d__frozen_start_motion(s, i);
    return z->dt / 2 * (withheld_power(s) - before);
}

/** What is summed up in an acoustic step, and is booked once it is known. */
typedef struct sound_sums {
    sph2d__slab_sum work, rates;     /* of both sweeps */
    double stopped, rubbed, imposed; /* by bodies, and openings */
} sound_sums;

static void book_sound(sph2d_sim *sim, const sound_sums *of)
{
    sph2d__system *s = &sim->system;
    sph2d__record *r = &sim->record;
    const double share = s->frozen->share;
    r->energy_pressed -= of->work.first;
    r->energy_viscous -= of->work.second;
    r->energy_fed -= of->work.third;
    r->energy_forces += of->work.fourth;
    s->external = (sph2d_vec2){s->external.x + share * of->work.x, s->external.y + share * of->work.y};
    r->energy_pressed -= of->stopped;
    r->energy_viscous -= of->rubbed;
    r->energy_fed -= of->imposed;
    r->energy_diffused -= of->rates.second;
    r->energy_pressed += of->rates.first;
    r->energy_fed -= of->rates.fourth;
}

/** One of the acoustic steps, number k of `steps`, of which `middle` has what acts once. */
static void sound_step(sph2d_sim *sim, size_t k, size_t steps, size_t middle, sound_sums *sums)
{
    sph2d__system *s = &sim->system;
    sph2d__frozen *z = s->frozen;
    const double once = k == middle ? (double)steps : 0, half = z->dt / 2;
    *sums = (sound_sums){.stopped = 0};
    sph2d__over_fluid_later(s, force_slab, &once, "force_pass", sizeof once, &sums->work);
    if (s->rigid_count > 0)
        sums->stopped = sph2d__frozen_bodies_kick(s, z->share * (double)k, &sums->rubbed);
    swap(&z->velocity, &z->next_velocity);
    if (k < steps)
        sums->imposed = impose(sim);
    sph2d__images_of_velocity(s);
    const sweep_times times = {half, k < steps ? half : 0, k + 1 == middle};
    sph2d__over_fluid_later(s, rate_slab, &times, "rate_pass", sizeof times, &sums->rates);
    sph2d__images_of_pressure(s);
    if (k + 1 == middle)
        sph2d__images_of_rest(s);
}

/* Acoustic steps whose sums are booked together. */
enum { SOUND_QUEUE = 16 };

/** The acoustic steps. */
static void sound(sph2d_sim *sim, double dt)
{
    sph2d__system *s = &sim->system;
    sph2d__frozen *z = s->frozen;
    const size_t steps = acoustic_steps(s, dt), middle = (steps + 1) / 2; /* when what acts once does */
    sph2d__slab_sum first, stored, kept = {0}, last = {0};
    sound_sums sums[SOUND_QUEUE];
    z->dt = dt / (double)steps;
    z->thick = !sph2d__viscous_at_once(s, dt);
    z->share = 1 / (double)steps;
    z->past = 1;
    sph2d__frozen_begin(s);
    sph2d__frozen_start_external(s);
    sph2d__images_of_velocity(s);
    sph2d__frozen_store_later(s, &stored);
    const sweep_times times = {0, z->dt / 2, middle == 1};
    sph2d__over_fluid_later(s, rate_slab, &times, "rate_pass", sizeof times, &first);
    sph2d__images_of_pressure(s);
    if (middle == 1)
        sph2d__images_of_rest(s);
    for (size_t k = 1, queued = 0; k <= steps; ++k) {
        sound_step(sim, k, steps, middle, &sums[queued++]);
        if (queued < SOUND_QUEUE && k < steps)
            continue;
        if (k == steps)
            sph2d__frozen_store_later(s, &kept);
        sph2d__sums_settle(s);
        if (k <= SOUND_QUEUE) {
            sim->record.energy_fed += s->mass * stored.first;
            sim->record.energy_pressed += first.first;
            sim->record.energy_fed -= first.fourth;
        }
        for (size_t n = 0; n < queued; ++n)
            book_sound(sim, &sums[n]);
        last = sums[queued - 1].rates;
        queued = 0;
    }
    sim->record.energy_pressed +=
        s->mass * s->sound_speed * s->sound_speed * z->dt * z->dt / 8 * (first.third - last.third);
    sim->record.energy_pressed -= s->mass * kept.first; /* is not dissipated */
}

/** Finds the particles in reservoirs of openings. What is prescribed is all that is known of them: no sum adds to it. */
static void hold(sph2d_sim *sim)
{
    sph2d__frozen *z = sim->system.frozen;
    const sph2d__store *f = &sim->system.fluid;
    z->holds = sim->openings.count > 0;
    for (size_t i = 0; z->holds && i < f->count; ++i) {
        const sph2d__opening *o = sph2d__opening_at(sim, f->x[i], f->y[i]);
        z->held[i] = o != NULL;
        z->held_log_density[i] = f->log_density[i];
        if (o)
            z->summed[i] = z->shift_x[i] = z->shift_y[i] = 0;
        if (sim->system.method.name == SPH2D_METHOD_CONSTRAINT)
            z->known[i] = o && !o->has_velocity;
    }
}

/** Bodies by what acoustic steps did to them. */
static sph2d_status push_bodies(sph2d_sim *sim, double dt)
{
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        const sph2d__frozen_body *b = &sim->system.frozen->bodies[k];
        sim->bodies.items[k].state->pressed = sph2d__twist_add(b->mean, 1, b->rubbed);
        sim->bodies.items[k].way = b->way;
    }
    return sph2d__bodies_carry(sim, dt);
}

/** The sides of the domain that are walls, and mirrors: not where liquid sticks. */
static sph2d__sides mirrors_of(const sph2d_sim *sim)
{
    const sph2d_box *d = &sim->world.box;
    sph2d_boundary open = {SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN, SPH2D_SIDE_OPEN};
    const bool thick = sim->system.viscosity > 0 || sim->world.scene.fluid.model != SPH2D_RHEOLOGY_NEWTONIAN;
    const bool none = sim->system.walls_rough && thick;
    const sph2d_boundary *b = none ? &open : &sim->world.scene.boundary;
    return (sph2d__sides){.low_x = b->left == SPH2D_SIDE_WALL ? d->min.x : -INFINITY,
                          .high_x = b->right == SPH2D_SIDE_WALL ? d->max.x : INFINITY,
                          .low_y = b->bottom == SPH2D_SIDE_WALL ? d->min.y : -INFINITY,
                          .high_y = b->top == SPH2D_SIDE_WALL ? d->max.y : INFINITY,
                          .first = none ? UINT64_MAX : sim->wall_ids[sim->world.wall_count - 1].end};
}

bool sph2d__wcsph_set_sides(sph2d_sim *sim)
{
    const sph2d__sides sides = mirrors_of(sim);
    return sph2d__frozen_start(&sim->system, &sides);
}

sph2d_status sph2d__wcsph_step(sph2d_sim *sim, double dt)
{
    sph2d__system *s = &sim->system;
    const double start = sim->record.time, middle = start + dt / 2, end = start + dt;
    sph2d__bodies_drift(sim, dt);
    sph2d__over_particles(s, s->fluid.count, go_to_middle, "go_to_middle_pass");
    sph2d_status status = sph2d__sort_fluid(sim);
    if (status == SPH2D_OK)
        status = sph2d__sim_update_forcing(sim, middle);
    if (status != SPH2D_OK)
        return status;
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_SEARCH);
    if (!sph2d__frozen_gather(s))
        return SPH2D_NOMEM;
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_FORCES);
    hold(sim);
    s->frozen->past = 0;
    if (!sph2d__frozen_rub(s) || !sph2d__frozen_bodies_gather(s))
        return SPH2D_NOMEM;
    sph2d__bodies_press(sim); /* by what stays as it is */
    sph2d__bodies_expect(sim, middle);
    const double before = dissipated(sim);
    if (s->method.name == SPH2D_METHOD_CONSTRAINT) {
        sph2d__implicit_sound(sim, dt);
    } else {
        sound(sim, dt);
        relax(sim, dt, dissipated(sim) - before);
    }
    pay_for_shift(s, dissipated(sim) - before);
    sph2d__over_particles(s, s->fluid.count, report, "report_pass");
    sph2d__sim_set_drift_interval(sim, start, middle); /* torques about what boundary particles were placed about */
    sph2d__loads_find(sim, 1);
    status = push_bodies(sim, dt);
    if (status != SPH2D_OK)
        return status;
    sph2d__sim_book_wall_work(sim, dt);
    sph2d__profile_enter(&s->profile, SPH2D_PHASE_MOVE);
    sph2d__over_particles(s, s->fluid.count, go_back, "go_back_pass");
    sph2d__sim_set_drift_interval(sim, start, end);
    status = sph2d__advect(sim, dt, go, NULL);
    if (status == SPH2D_OK)
        status = sph2d__sort_fluid(sim);
    if (status == SPH2D_OK)
        status = sph2d__sim_update_forcing(sim, end);
    if (status == SPH2D_OK)
        sph2d__openings_impose(sim);
    return status;
}
