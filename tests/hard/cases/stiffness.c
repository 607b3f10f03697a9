/* SPDX-License-Identifier: MIT */
/** @file stiffness.c E: steps, stiffness and viscosity at their limits. */
#include <math.h>
#include <string.h>

#include <sph2d/state.h>

#include "cases.h"

/** A column of 0.5 m by 0.8 m that collapses in a box of 1 m; by fitted operators a channel that gravity drives. */
static bool open_column(stage *s, outcome *o, const char *options, const char *more)
{
    if (o->method == FITTED)
        return stage_read(s, o, options,
                          "domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.05\ngravity: [1, 0]\nwall_slip: none\n"
                          "boundary: {left: periodic, right: periodic, top: wall}\n%s"
                          "blocks:\n  - box: {min: [0, 0], max: [1, 1]}\n",
                          more);
    return stage_read(s, o, options,
                      "domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.05\nboundary: {top: wall}\n%s"
                      "blocks:\n  - box: {min: [0, 0], max: [0.5, 0.8]}\n",
                      more);
}

static double rise_of(const sph2d_sim *sim)
{
    const sph2d_summary s = sph2d_sim_summary(sim);
    return s.energy_rise / s.energy_scale;
}

// ---- E1, E2 ---------------------------------------------------------------------------------------------------------

/** A fixed step of so many parts of the limit of stability, c0 dt/H = 0.88; by solvers, of their own step. */
static void sweep(outcome *o)
{
    static const double parts[] = {0.1, 0.25, 0.5, 1, 2};
    double first_stopped = INFINITY;
    for (size_t k = 0; k < sizeof parts / sizeof *parts; ++k) {
        stage s;
        char which[40];
        snprintf(which, sizeof which, "%g of the limit", parts[k]);
        const char *options = o->method == FITTED ? "sound_speed: 20" : "";
        if (!open_column(&s, o, options, "") || !stage_start(&s, o))
            return;
        const sph2d_plan plan = *sph2d_sim_plan(s.sim);
        const bool solves = o->method == PCISPH || o->method == CONSTRAINT;
        const double limit = solves ? plan.time_step : 0.88 * plan.support_radius / plan.sound_speed;
        sph2d_sim_destroy(s.sim);
        s.scene.method.time_step = parts[k] * limit;
        if (stage_start(&s, o)) {
            const bool finished = stage_run(&s, 1);
            if (!finished && parts[k] < first_stopped)
                first_stopped = parts[k];
            if (parts[k] <= 0.5) {
                tell_of(o, "stopped by a guard", which, !finished, 0);
                tell_of(o, "energy from nothing", which, rise_of(s.sim), 0.01);
            } else
                tell_of(o, "not finite without a guard", which, finished && !all_finite(s.sim), 0);
            stage_close(&s);
        }
    }
    if (isfinite(first_stopped))
        tell_only(o, "stopped by a guard from this part of the limit on", first_stopped);
}

static void stiff(outcome *o)
{
    stage s;
    if (!open_column(&s, o, "sound_speed: 400", "") || !stage_start(&s, o))
        return;
    stage_finish(&s, o, 0.4);
    const sph2d_plan *plan = sph2d_sim_plan(s.sim);
    tell(o, "energy from nothing", rise_of(s.sim), 0.01);
    if (o->method != PCISPH && o->method != CONSTRAINT) // wcsph: five acoustic steps of cfl 0.2
        tell(o, "c0 dt / H at most", sph2d_sim_summary(s.sim).time_step_max * 400 / plan->support_radius,
             o->method == WCSPH ? 1.001 : 0.88);
    stage_close(&s);
}

// ---- E3, E4 ---------------------------------------------------------------------------------------------------------

static void honey(outcome *o)
{
    stage s;
    const double nu = 0.02;
    if (!STAGE_OPEN(&s, o, "",
                    "domain: {min: [0, 0], max: [0.6, 1]}\nspacing: 0.01\n"
                    "fluid: {density: 1000, dynamic_viscosity: %g}\n"
                    "sources: [{at: [0.3, 0.6], width: 0.05, speed: 0.5}]\n",
                    1000 * nu))
        return;
    stage_finish(&s, o, 1);
    const double h = sph2d_sim_plan(s.sim)->support_radius;
    const sph2d_summary end = sph2d_sim_summary(s.sim);
    tell(o, "nu dt / H^2 at most", nu * end.time_step_max / (h * h), 0.07);
    tell(o, "energy from nothing", rise_of(s.sim), 0.001);
    tell(o, "particles that nobody counted", ledger(s.sim, 0), 0);
    tell(o, "speed at last / free fall", speed_of(s.sim) / sqrt(0.25 + 2 * 9.81 * 0.6), 1);
    stage_close(&s);
}

static void without_viscosity(outcome *o)
{
    stage s;
    if (!STAGE_OPEN(&s, o, "sound_speed: 10",
                    "domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.04\ngravity: [0, 0]\n"
                    "boundary: {left: periodic, right: periodic, bottom: periodic, top: periodic}\n"
                    "fluid: {density: 1000, dynamic_viscosity: 0}\n"
                    "blocks:\n  - box: {min: [0, 0], max: [1, 1]}\n"
                    "    start: {flow: taylor_green, speed: 1, length: 1, center: [0.25, 0.25]}\n"))
        return;
    const double start = sph2d_sim_summary(s.sim).kinetic;
    double least = start, rise = 0;
    while (sph2d_sim_time(s.sim) < 2 && stage_steps(&s, 1)) {
        const double now = sph2d_sim_summary(s.sim).kinetic;
        least = fmin(least, now);
        rise = fmax(rise, now - least);
    }
    tell(o, "stopped by a guard", s.status != SPH2D_OK, 0);
    tell(o, "rise of kinetic energy / E0", rise / start, 1e-3);
    tell_only(o, "kinetic energy at t = 2 / E0", sph2d_sim_summary(s.sim).kinetic / start);
    stage_close(&s);
}

// ---- E6 -------------------------------------------------------------------------------------------------------------

/** The column, or channel, in other units: lengths, accelerations and densities are multiplied. Lengths as of 1 m. */
static cloud scaled(outcome *o, double length, double gravity, double density, double disturbed)
{
    stage s;
    cloud c = {.count = 0};
    const bool fitted = o->method == FITTED;
    char options[80] = "";
    if (fitted)
        snprintf(options, sizeof options, "sound_speed: %.17g", 20 * sqrt(length * gravity));
    if (!STAGE_OPEN(&s, o, options,
                    "domain: {min: [0, 0], max: [%.17g, %.17g]}\nspacing: %.17g\ngravity: [%.17g, %.17g]\n%s"
                    "fluid: {density: %.17g, dynamic_viscosity: %.17g}\n"
                    "blocks:\n  - box: {min: [0, 0], max: [%.17g, %.17g]}\n    perturb: {amplitude: %.17g}\n",
                    length, length, length / 16, fitted ? gravity : 0, fitted ? 0 : -9.81 * gravity,
                    fitted ? "boundary: {left: periodic, right: periodic, top: wall}\nwall_slip: none\n" : "",
                    1000 * density, density * pow(length, 1.5) * sqrt(gravity), length * (fitted ? 1 : 0.5),
                    length * (fitted ? 1 : 0.75), disturbed))
        return c;
    if (!stage_steps(&s, o->method == PCISPH || o->method == CONSTRAINT ? 30 : 200)) // longer steps
        tell(o, "stopped by a guard", 1, 0);
    c = cloud_of(s.sim);
    c.time *= sqrt(gravity / length);
    for (size_t i = 0; i < c.count; ++i) {
        c.x[i] /= length;
        c.y[i] /= length;
    }
    stage_close(&s);
    return c;
}

static void units(outcome *o)
{
    static const struct {
        const char *name;
        double length, gravity, density;
    } all[] = {{"1 um", 1e-6, 1, 1},
               {"1 km", 1e3, 1, 1},
               {"gravity 1e-9", 1, 1e-9, 1},
               {"gravity 1e3", 1, 1e3, 1},
               {"mm, g, ms", 1e3, 1e-3, 1e-6}};
    cloud one = scaled(o, 1, 1, 1, 0), near = scaled(o, 1, 1, 1, 1.6e-14);
    // Solvers end where they meet their tolerance, which round-off can delay by an iteration.
    const bool solves = o->method == PCISPH || o->method == CONSTRAINT;
    const double bound = fmax(solves ? 1e-3 : 1e-9, 10 * cloud_apart(&one, &near));
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k) {
        cloud other = scaled(o, all[k].length, all[k].gravity, all[k].density, 0);
        tell_of(o, "apart / L", all[k].name, cloud_apart(&one, &other), bound);
        tell_of(o, "t / t* - 1", all[k].name, fabs(other.time / one.time - 1), bound);
        cloud_free(&other);
    }
    cloud_free(&one);
    cloud_free(&near);
}

// ---- E7 -------------------------------------------------------------------------------------------------------------

static double gain_over_work(const sph2d_summary *s)
{
    const double work = s->energy_walls + s->energy_forces + s->energy_fed;
    return (s->kinetic + s->potential + s->elastic - s->energy_start - work) / fmax(fabs(work), s->energy_scale);
}

static void thrown_about(outcome *o)
{
    stage s;
    if (!open_column(&s, o, o->method == FITTED ? "sound_speed: 20" : "", "") || !stage_start(&s, o))
        return;
    size_t start = sph2d_sim_fluid(s.sim).count;
    double most = 0;
    for (int k = 1; k <= 100 && stage_run(&s, 0.01 * k); ++k) {
        const sph2d_summary now = sph2d_sim_summary(s.sim);
        most = fmax(most, gain_over_work(&now));
        if (k == 30)
            sph2d_sim_set_gravity(s.sim, o->method == FITTED ? (sph2d_vec2){-1, 0} : (sph2d_vec2){0, 9.81});
    }
    tell_of(o, "stopped by a guard", "gravity reversed", s.status != SPH2D_OK, 0);
    tell_of(o, "energy less work", "gravity reversed", most, 0.01);
    tell_of(o, "lost", "gravity reversed", ledger(s.sim, start), 0);
    stage_close(&s);
    if (o->method == FITTED)
        return; // a box that moves is in a domain that it does not fill
    if (!STAGE_OPEN(&s, o, "sound_speed: 630",
                    "domain: {min: [-1.5, -0.5], max: [2.5, 1.5]}\nspacing: 0.05\n"
                    "boundary: {left: open, right: open, bottom: open, top: open}\n"
                    "obstacles:\n  - polyline: [[0, 1], [0, 0], [1, 0], [1, 1], [0, 1]]\n"
                    "    motion: {amplitude: [1, 0], frequency: 10, phase: -1.570796326794897}\n"
                    "blocks:\n  - box: {min: [0, 0], max: [1, 0.5]}\n"))
        return;
    start = sph2d_sim_fluid(s.sim).count;
    most = 0;
    for (int k = 1; k <= 30 && stage_run(&s, 0.01 * k); ++k) {
        const sph2d_summary now = sph2d_sim_summary(s.sim);
        most = fmax(most, gain_over_work(&now));
    }
    const sph2d_view f = sph2d_sim_fluid(s.sim);
    const double left = 1 - cos(2 * CASE_PI * 10 * sph2d_sim_time(s.sim));
    double outside = (double)start - (double)f.count;
    for (size_t i = 0; i < f.count; ++i)
        outside += f.x[i] < left - 1e-3 || f.x[i] > left + 1.001 || f.y[i] < -1e-3 || f.y[i] > 1.001;
    tell_of(o, "stopped by a guard", "shaken", s.status != SPH2D_OK, 0);
    tell_of(o, "energy less work", "shaken", most, 0.01);
    tell_of(o, "outside", "shaken", outside, 0);
    stage_close(&s);
}

// ---- E8 to E10 ------------------------------------------------------------------------------------------------------

/** Whether a run of 200 steps ends, or a guard stops it, with finite numbers. */
static void survive(outcome *o, const char *options, bool asks_too_much)
{
    stage s;
    if (!open_column(&s, o, options, "") || !stage_start(&s, o))
        return;
    stage_steps(&s, 200);
    const sph2d_summary end = sph2d_sim_summary(s.sim);
    tell_of(o, "not finite", options, !all_finite(s.sim), 0);
    tell_of(o, "stopped, but not by a guard", options, s.status != SPH2D_OK && s.status != SPH2D_GUARD, 0);
    if (asks_too_much)
        tell_of(o, "no word of steps that did not converge", options,
                end.unconverged == 0 && !stage_reports(&s, SPH2D_CODE_NOT_CONVERGED), 0);
    tell_of(o, "unconverged of 200 steps", options, (double)end.unconverged, NAN);
    stage_close(&s);
}

static void iterations(outcome *o)
{
    survive(o, "max_iterations: 1", true);
    survive(o, o->method == PCISPH ? "max_compression: 1e-6" : "tolerance: 1e-10", false);
}

static void stiffest(outcome *o)
{
    survive(o, "sound_speed: 1e9", false);
    survive(o, "sound_speed: 1e-3", false);
}

/** Continues in a simulation of another step. */
static bool change_step(stage *s, double dt)
{
    sph2d_sim *next = NULL;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    const sph2d_state state = sph2d_sim_state(s->sim);
    s->scene.method.time_step = dt;
    s->status = sph2d_sim_restore(&s->scene, &options, &state, &next, &s->report);
    if (s->status != SPH2D_OK)
        return false;
    sph2d_sim_destroy(s->sim);
    s->sim = next;
    return true;
}

static void jumps(outcome *o)
{
    stage s;
    const char *options = "sound_speed: 20, time_step: 1e-3";
    if (!stage_read(&s, o, options,
                    "domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.05\ngravity: [0, 0]\n"
                    "boundary: {left: periodic, right: periodic, bottom: periodic, top: periodic}\n"
                    "fluid: {density: 1000, dynamic_viscosity: 0}\n"
                    "blocks:\n  - box: {min: [0, 0], max: [1, 1]}\n"
                    "    start: {flow: taylor_green, speed: 0.5, length: 1, center: [0.25, 0.25]}\n") ||
        !stage_start(&s, o))
        return;
    const sph2d_summary start = sph2d_sim_summary(s.sim);
    double most = 0;
    for (int k = 0; k < 1000 && stage_steps(&s, 1) && change_step(&s, k % 2 ? 1e-3 : 1e-4); ++k) {
        const sph2d_summary now = sph2d_sim_summary(s.sim);
        most = fmax(most, (now.kinetic + now.elastic) / (start.kinetic + start.elastic) - 1);
    }
    const sph2d_summary end = sph2d_sim_summary(s.sim);
    if (s.status != SPH2D_OK)
        fprintf(stderr, "hard_cases: %s\n", stage_error(&s));
    tell(o, "stopped", s.status != SPH2D_OK, 0);
    tell(o, "energy / E0 - 1 at most", most, 0.01);
    tell_only(o, "energy / E0 at last", (end.kinetic + end.elastic) / (start.kinetic + start.elastic));
    stage_close(&s);
}

static const hard_case items[] = {
    {"E1", "fixed steps of 0.1 to 2 times the limit, c0 dt/H 0.88; by solvers, of their own",
     "up to half of it to the end, energy to 1 %; above that stopped, or finite", BY_ALL, 2, sweep},
    {"E2", "a sound speed of ten times as much", "steps adapt, energy to 1 %", BY_ALL, 2, stiff},
    {"E3", "honey that is poured", "nu dt/H^2 0.07 at most, energy to 0.1 %, no faster than in free fall", BY_FREE, 5,
     honey},
    {"E4", "vortices without viscosity", "kinetic energy does not rise by 0.1 %", BY_WCSPH | BY_FITTED, 2,
     without_viscosity},
    {"E6", "1 um, 1 km, 1e-9 g, 1e3 g; mm, g, ms",
     "the same to 1e-9 after 200 steps, by solvers 1e-3 after 30, or as a disturbance of 1e-15 L", BY_ALL, 0.9, units},
    {"E7", "gravity reversed; a tank shaken by 1 m at 10 Hz", "nothing lost, energy by the work to 1 %", BY_ALL, 3,
     thrown_about},
    {"E8", "one iteration; a tolerance of 1e-10", "finite, and what did not converge is told", BY_SOLVERS, 0.9,
     iterations},
    {"E9", "compliance of none and much", "finite", BY_CONSTRAINT, 2, stiffest},
    {"E10", "steps that jump by ten up and down", "energy does not rise by 1 % in 1e3 steps", BY_ALL, 0.9, jumps},
};
const case_list stiffness_cases = {items, sizeof items / sizeof *items};
