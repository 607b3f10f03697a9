/* SPDX-License-Identifier: MIT */
/** @file guards.c
 *  Extremes over all particles after a step, and the guards. */
#include <math.h>
#include <stdio.h>

#include "base/parallel.h"
#include "run/run.h"
#include "scene/method_table.h"
#include "scene/world.h"
#include "sim/device_steps.h"
#include "sim/extremes.h"

/* A step below this fraction of the stable step at rest is near collapse; so many in a row are a collapse. */
static const double COLLAPSE = 1e-5;
enum { COLLAPSED_STEPS = 100 };

/** The domain, unbounded at sides that are not walls. */
static sph2d_box walled_box(const sph2d__world *world)
{
    sph2d_boundary b = world->scene.boundary;
    sph2d_box d = world->box;
    return (sph2d_box){
        {b.left == SPH2D_SIDE_WALL ? d.min.x : -INFINITY, b.bottom == SPH2D_SIDE_WALL ? d.min.y : -INFINITY},
        {b.right == SPH2D_SIDE_WALL ? d.max.x : INFINITY, b.top == SPH2D_SIDE_WALL ? d.max.y : INFINITY}};
}

static sph2d__limits limits_of(const sph2d_sim *sim)
{
    const sph2d__bounds bounds = sph2d__sim_bounds(sim);
    sph2d__limits limits = {.domain = sim->world.box,
                            .walled = walled_box(&sim->world),
                            .min_density = bounds.min_density,
                            .max_density = bounds.max_density};
    for (int side = 0; side < SPH2D__WALL_OBSTACLE; ++side)
        limits.open[side] = sph2d__side_of(&sim->world.scene, side) == SPH2D_SIDE_OPEN;
    return limits;
}

static sph2d__extremes find_extremes(const sph2d_sim *sim)
{
    const sph2d__store *f = &sim->system.fluid;
    const sph2d__limits within = limits_of(sim);
    size_t count = f->count;
    sph2d__extremes all = sph2d__no_extremes();
    if (sph2d__is_on_device(&sim->system))
        return sph2d__device_extremes(&sim->system, &within);
#pragma omp taskloop num_tasks(sph2d__tasks(count, SPH2D__GRAIN)) if (count > SPH2D__GRAIN) shared(all, within)
    for (size_t first = 0; first < count; first += SPH2D__GRAIN) {
        sph2d__extremes part = sph2d__no_extremes();
        for (size_t i = first; i < count && i < first + SPH2D__GRAIN; ++i)
            sph2d__see_particle(f, &within, i, &part);
#pragma omp critical(sph2d_extremes)
        all = sph2d__join_extremes(all, part);
    }
    return all;
}

static sph2d_diagnostic *report_particle(const sph2d_sim *sim, sph2d_report *report, sph2d_code code, size_t i,
                                         const char *what)
{
    const sph2d__store *f = &sim->system.fluid;
    return sph2d_report_add(report, SPH2D_ERROR, code, NULL,
                            "%s: particle %llu at (%g, %g) with velocity (%g, %g), step %llu, time %g s", what,
                            (unsigned long long)f->id[i], f->x[i], f->y[i], f->vx[i], f->vy[i],
                            (unsigned long long)sim->record.steps, sim->record.time);
}

static bool guard_values(sph2d_sim *sim, const sph2d__extremes *e, sph2d_report *report)
{
    const sph2d__store *f = &sim->system.fluid;
    if (e->not_finite != SIZE_MAX) {
        sph2d_diagnostic *d =
            report_particle(sim, report, SPH2D_CODE_NOT_FINITE, e->not_finite, "a value is not finite");
        sph2d_diagnostic_hint(d, "lower method.time_step or method.cfl");
        return false;
    }
    if (e->implausible != SIZE_MAX) {
        sph2d_vec2 at = {f->x[e->implausible], f->y[e->implausible]};
        char where[SPH2D__WHERE_SIZE];
        sph2d_diagnostic *d = sph2d_report_add(
            report, SPH2D_ERROR, SPH2D_CODE_DENSITY, NULL,
            "no liquid has such a density: %g kg/m^3, particle %llu at (%g, %g), %s, step %llu, time %g s",
            f->density[e->implausible], (unsigned long long)f->id[e->implausible], at.x, at.y,
            sph2d__sim_where(sim, at, where), (unsigned long long)sim->record.steps, sim->record.time);
        sph2d_diagnostic_hint(d, "look for blocks or sources that lie too close there%s",
                              sph2d__method_row_of(&sim->world.scene.method)->summed_density ? "; lower method.cfl"
                                                                                             : "");
        return false;
    }
    if (e->escaped != SIZE_MAX) {
        sph2d_diagnostic *d =
            report_particle(sim, report, SPH2D_CODE_ESCAPED, e->escaped, "a particle is beyond a wall of the domain");
        sph2d__sim_hint_escape(sim, (sph2d_vec2){f->x[e->escaped], f->y[e->escaped]}, d);
        return false;
    }
    return true;
}

/* So many consecutive steps without convergence are an error. */
enum { UNCONVERGED_STEPS = 100 };

static bool guard_solver(const sph2d_sim *sim, sph2d_report *report)
{
    const sph2d__system *s = &sim->system;
    const sph2d__record *r = &sim->record;
    if (r->unconverged_row < UNCONVERGED_STEPS)
        return true;
    sph2d_diagnostic *d =
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_NOT_CONVERGED, "method.max_iterations",
                         "the pressure solver did not converge in %d consecutive steps: its compression error is %.3g, "
                         "the tolerance is %.3g (step %llu, time %g s)",
                         UNCONVERGED_STEPS, s->residual, s->wanted_residual, (unsigned long long)r->steps, r->time);
    sph2d_diagnostic_hint(d, "raise method.max_iterations, or %s",
                          sph2d__method_row_of(&sim->world.scene.method)->convergence_hint);
    return false;
}

/** Integrated densities follow motions that are slower than sound. Of 100 random scenes one had a particle as fast as
 *  half of it. */
static bool guard_speed(const sph2d_sim *sim, double speed, sph2d_report *report)
{
    const sph2d__system *s = &sim->system;
    const sph2d__store *f = &s->fluid;
    const sph2d__method_row *row = sph2d__method_row_of(&sim->world.scene.method);
    if (row->summed_density || !(speed > s->sound_speed))
        return true;
    size_t i = 0;
    sph2d__host_reads(s, SPH2D__EVERYTHING);
    while (i + 1 < f->count && hypot(f->vx[i], f->vy[i]) < speed * (1 - 1e-12))
        ++i;
    char where[SPH2D__WHERE_SIZE];
    sph2d_diagnostic *d = sph2d_report_add(
        report, SPH2D_ERROR, SPH2D_CODE_SUPERSONIC, NULL,
        "particle %llu is faster than sound in this liquid: %g of %g m/s, at (%g, %g), %s, step %llu, time %g s",
        (unsigned long long)f->id[i], speed, s->sound_speed, f->x[i], f->y[i],
        sph2d__sim_where(sim, (sph2d_vec2){f->x[i], f->y[i]}, where), (unsigned long long)sim->record.steps,
        sim->record.time);
    bool given = sim->world.scene.method.sound_speed > 0 || sim->world.scene.method.stiffness > 0;
    if (sim->world.scene.method.time_step > 0)
        sph2d_diagnostic_hint(d, "leave method.time_step out for an adaptive step, or lower it");
    else if (given)
        sph2d_diagnostic_hint(d, "leave method.sound_speed and method.stiffness out, or raise the sound speed to ten "
                                 "times the largest speed of the flow");
    else
        sph2d_diagnostic_hint(d, "lower method.cfl, or look at what accelerates the liquid there");
    return false;
}

static bool guard_step(sph2d_sim *sim, const sph2d__extremes *e, sph2d_report *report)
{
    const sph2d__system *s = &sim->system;
    sph2d__record *r = &sim->record;
    double speed = sqrt(e->speed2);
    /* Where walls hold, a drop may be faster than the liquid. */
    const double fall = sim->method->walls_hold ? sqrt(2 * s->head) : 0, fastest = fall > 0 ? fall : speed;
    if (sim->world.scene.method.time_step > 0 && fastest * r->next_step > s->support) {
        sph2d_diagnostic *d =
            sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_STEP_TOO_LARGE, "method.time_step",
                             "%s moves %g m in one step, more than the support radius %g m (step %llu, time %g s)",
                             fall > 0 ? "what falls as deep as it can" : "a particle", fastest * r->next_step,
                             s->support, (unsigned long long)r->steps, r->time);
        sph2d_diagnostic_hint(d, "leave method.time_step out for an adaptive step, or lower it to %.2g",
                              s->method.cfl * s->support / (fall > 0 ? fall : s->sound_speed + speed));
        return false;
    }
    if (!guard_speed(sim, speed, report))
        return false;
    sph2d__limit limit;
    double at_rest = sim->method->stable_step(s, 0, 0, &limit);
    bool adaptive = !(sim->world.scene.method.time_step > 0); /* a short step set by the scene is no collapse */
    r->short_steps = adaptive && !(r->next_step > COLLAPSE * at_rest) ? r->short_steps + 1 : 0;
    if (r->short_steps >= COLLAPSED_STEPS) {
        sph2d_diagnostic *d =
            sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_STEP_COLLAPSE, NULL,
                             "the time step collapsed to %g s at step %llu, time %g s "
                             "(fastest particle %g m/s, largest acceleration %g m/s^2)",
                             r->next_step, (unsigned long long)r->steps, r->time, speed, sqrt(e->acceleration2));
        sph2d_diagnostic_hint(d, "look for overlapping particles, or a source that emits into liquid or a wall");
        return false;
    }
    return true;
}

/** Bodies that are not finite, or have left the domain by more than its size: nothing brings them back. */
static bool guard_bodies(const sph2d_sim *sim, sph2d_report *report)
{
    sph2d_box d = sim->world.box;
    double wide = d.max.x - d.min.x, tall = d.max.y - d.min.y;
    const sph2d__period *period = &sim->system.fluid_cells.period;
    for (size_t k = 0; k < sim->bodies.count; ++k) {
        sph2d_body_state b = sph2d_sim_body(sim, k);
        bool finite = isfinite(b.center.x + b.center.y + b.angle + b.velocity.x + b.velocity.y + b.rate);
        bool near_x = period->length_x > 0 || (b.center.x > d.min.x - wide && b.center.x < d.max.x + wide);
        bool near_y = period->length_y > 0 || (b.center.y > d.min.y - tall && b.center.y < d.max.y + tall);
        if (finite && near_x && near_y)
            continue;
        char path[64];
        snprintf(path, sizeof path, "bodies[%zu]", k);
        sph2d_diagnostic *e =
            sph2d_report_add(report, SPH2D_ERROR, finite ? SPH2D_CODE_ESCAPED : SPH2D_CODE_NOT_FINITE, path,
                             "%s: it is at (%g, %g) with velocity (%g, %g), step %llu, time %g s",
                             finite ? "the body has left the domain" : "a value is not finite", b.center.x, b.center.y,
                             b.velocity.x, b.velocity.y, (unsigned long long)sim->record.steps, sim->record.time);
        sph2d_diagnostic_hint(e, "%s",
                              finite ? "make the side that it left through a wall, or end the run before"
                                     : "lower method.cfl, or make the body heavier");
        return false;
    }
    return true;
}

bool sph2d__sim_measure(sph2d_sim *sim, sph2d_report *report)
{
    sph2d__extremes e = find_extremes(sim);
    if (e.not_finite != SIZE_MAX || e.implausible != SIZE_MAX || e.escaped != SIZE_MAX)
        sph2d__host_reads(&sim->system, SPH2D__EVERYTHING);
    if (!guard_bodies(sim, report) || !guard_values(sim, &e, report))
        return false;
    double compression = e.density / sim->system.rest_density - 1;
    if (compression > sim->record.compression_max)
        sim->record.compression_max = compression;
    sim->record.speed = sqrt(e.speed2);
    sim->none_left = e.left == SIZE_MAX;
    sim->system.max_log_density = e.log_density;
    sim->system.max_pressure = fmax(e.pressure, sim->system.rest_density * sim->system.head);
    sph2d__sim_choose_step(sim, sqrt(e.speed2), sqrt(e.acceleration2));
    return guard_solver(sim, report) && guard_step(sim, &e, report);
}

/* Forces between particles are equal and opposite, so that rounding alone is seen; sources leave up to 0.05: particles
 * are there from the start of a step on, whose forces are those of the end of the last one. */
static const double MOMENTUM = 0.1;

bool sph2d__sim_guard_momentum(const sph2d_sim *sim, sph2d_report *report)
{
    const sph2d__record *r = &sim->record;
    const double mass = sim->system.mass * (double)sim->system.fluid.count;
    const double scale = fmax(r->momentum_moved, sqrt(2 * mass * sph2d__sim_energy_scale(sim)));
    if (!(r->momentum_worst > MOMENTUM * scale))
        return true;
    sph2d_diagnostic *d =
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_MOMENTUM, NULL,
                         "momentum came from nothing: (%.3g, %.3g) kg/s, of the %.3g kg/s that the scene can have, by "
                         "step %llu, time %g s",
                         r->momentum_error_x, r->momentum_error_y, scale, (unsigned long long)r->steps, r->time);
    sph2d_diagnostic_hint(d, "try a smaller method.cfl, or a smaller spacing");
    return false;
}
