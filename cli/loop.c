/* SPDX-License-Identifier: MIT */
/** @file loop.c
 *  The main loop of a run. */
#include "loop.h"

#include <inttypes.h>

#include <sph2d/device.h>

#include "clock.h"
#include "exit.h"

/* The CPU time of all but the outputs that are written beside the steps. */
static double cpu_here(const cli_outputs *o)
{
    return clock_cpu() - outputs_cpu_beside(o);
}

/* Outputs are timed separately, as the speed of a run is that of its steps. */
static sph2d_status write_due(cli_outputs *o, loop_result *result, sph2d_report *report)
{
    double wall = clock_wall(), cpu = cpu_here(o);
    sph2d_status status = outputs_write_due(o, report);
    result->output_wall += clock_wall() - wall;
    result->output_cpu += cpu_here(o) - cpu;
    return status;
}

static void fail(loop_result *result, sph2d_status status)
{
    result->end = status == SPH2D_GUARD ? LOOP_GUARD : LOOP_FAILED;
    result->status = status;
}

bool loop_reached(double time, double until)
{
    /* The tolerance for rounding of the clock, a sum of many steps; the same as for outputs that are due. */
    return time * (1 + 1e-12) >= until;
}

bool loop_done(const sph2d_sim *sim)
{
    return loop_reached(sph2d_sim_time(sim), sph2d_sim_scene(sim)->run.until);
}

/* What is done between steps. */
typedef struct between {
    cli_outputs *outputs;
    cli_progress *progress;
    double deadline;
    loop_result *result;
    sph2d_report *report;
    bool stepping;    /* a step was begun ... */
    double wall, cpu; /* ... at these times */
} between;

/* Steps are timed separately, too. */
static void end_step(between *b)
{
    if (!b->stepping)
        return;
    b->result->step_wall += clock_wall() - b->wall;
    b->result->step_cpu += cpu_here(b->outputs) - b->cpu;
    b->stepping = false;
}

static void begin_step(between *b)
{
    b->stepping = true;
    b->wall = clock_wall();
    b->cpu = cpu_here(b->outputs);
}

/* Writes what is due after a step; false if the run shall end. */
static bool follow_step(between *b, const sph2d_sim *sim)
{
    const double time = sph2d_sim_time(sim), until = sph2d_sim_scene(sim)->run.until;
    const sph2d_status status = write_due(b->outputs, b->result, b->report);
    const size_t particles = sph2d_sim_count(sim);
    const progress_fact facts[] = {{"time", time, NULL},
                                   {"until", until, NULL},
                                   {"steps", (double)sph2d_sim_steps(sim), NULL},
                                   {"particles", (double)particles, NULL},
                                   {NULL, 0, NULL}};
    progress_update(b->progress, time, facts, "t %.4g of %.4g s  step %" PRIu64 "  %zu particles", time, until,
                    sph2d_sim_steps(sim), particles);
    if (status != SPH2D_OK)
        fail(b->result, status);
    else if (b->deadline > 0 && !loop_done(sim) && clock_wall() >= b->deadline)
        b->result->end = LOOP_MAX_WALL;
    return b->result->end == LOOP_FINISHED;
}

/* Whether there is no reason to stop. The deadline is checked after the first step, so that every session makes
 * progress. */
static bool go_on(void *between_, sph2d_sim *sim)
{
    between *b = between_;
    const bool first = !b->stepping;
    end_step(b);
    if ((!first && !follow_step(b, sim)) || loop_done(sim))
        return false;
    if ((b->result->signal = signals_caught()) != 0) {
        b->result->end = LOOP_SIGNAL;
        return false;
    }
    begin_step(b);
    return true;
}

static void advance(sph2d_sim *sim, cli_outputs *o, cli_progress *p, double deadline, loop_result *result,
                    sph2d_report *report)
{
    between b = {o, p, deadline, result, report, false, 0, 0};
    /* The outputs of the state that a run was resumed from exist already; those more frequent than steps would seem due
     * again. */
    sph2d_status status = o->saved == SAVED_NOWHERE ? write_due(o, result, report) : SPH2D_OK;
    if (status == SPH2D_OK)
        status = sph2d_sim_run(sim, go_on, &b, report);
    end_step(&b);
    if (status != SPH2D_OK)
        fail(result, status);
}

loop_result loop_run(sph2d_sim *sim, cli_outputs *o, cli_progress *p, double deadline, sph2d_report *report)
{
    loop_result result = {.end = LOOP_FINISHED, .status = SPH2D_OK};
    sph2d_summary before = sph2d_sim_summary(sim);
    advance(sim, o, p, deadline, &result, report);
    progress_end(p);
    double wall = clock_wall(), cpu = cpu_here(o);
    if (result.end == LOOP_GUARD) {
        /* The guard's error is reported even if its state cannot be written. */
        outputs_write_guard(o, report);
    } else if (result.end != LOOP_FAILED) {
        sph2d_status status = outputs_finish(o, result.end != LOOP_FINISHED, report);
        if (status == SPH2D_OK)
            status = sph2d_sim_device_status(sim, report); /* the last probes may have had old particles */
        if (status != SPH2D_OK)
            fail(&result, status);
    } else {
        outputs_settle(o, NULL); /* what is before the error still gets its name */
    }
    result.output_wall += clock_wall() - wall;
    result.output_cpu += cpu_here(o) - cpu + outputs_cpu_beside(o);
    result.frames = o->queue ? output_queue_times(o->queue) : o->frames;
    sph2d_summary after = sph2d_sim_summary(sim);
    result.steps = after.steps - before.steps;
    result.particle_steps = after.particle_steps - before.particle_steps;
    result.simulated = after.time - before.time;
    return result;
}
