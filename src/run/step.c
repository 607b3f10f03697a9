/* SPDX-License-Identifier: MIT */
/** @file step.c
 *  One step: sources and drains, the method's scheme, the clock, the guards. */
#include "base/null.h"
#include "base/parallel.h"
#include "probes/coverage.h"
#include "probes/probes.h"
#include "run/run.h"
#include "sim/device_steps.h"
#include "sim/stages.h"

static sph2d_status halt(sph2d_sim *sim, sph2d_status status, sph2d_report *report)
{
    sim->stopped = status;
    sph2d__profile_enter(&sim->system.profile, SPH2D_PHASE_COUNT);
    if (status == SPH2D_NOMEM)
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL, "out of memory in step %llu",
                         (unsigned long long)sim->record.steps);
    if (status != SPH2D_NOMEM && status != SPH2D_GUARD && status != SPH2D_DEVICE)
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL,
                         "the solver for contacts of bodies ended step %llu: %s", (unsigned long long)sim->record.steps,
                         sph2d_status_text(status));
    return status;
}

static void count_limit(sph2d__record *r, uint64_t limit)
{
    uint64_t *counters[SPH2D__LIMIT_COUNT] = {&r->limited_acoustic, &r->limited_force, &r->limited_viscous,
                                              &r->limited_fixed};
    ++*counters[limit];
}

static void advance_clock(sph2d_sim *sim, double dt)
{
    sph2d__record *r = &sim->record;
    count_limit(r, r->next_limit);
    r->time += dt;
    r->last_step = dt;
    r->step_min = r->steps == 0 || dt < r->step_min ? dt : r->step_min;
    r->step_max = dt > r->step_max ? dt : r->step_max;
    ++r->steps;
    r->particle_steps += sim->system.fluid.count;
}

/** Adds and removes particles. */
static sph2d_status apply_sources_and_drains(sph2d_sim *sim)
{
    sph2d_status status = sph2d__sim_emit(sim);
    return status == SPH2D_OK ? sph2d__sim_drain(sim) : status;
}

static sph2d_status take_step(sph2d_sim *sim, sph2d_report *report)
{
    sph2d__profile *profile = &sim->system.profile;
    sph2d__profile_enter(profile, SPH2D_PHASE_BOOKKEEPING);
    sph2d_status status = apply_sources_and_drains(sim);
    if (status != SPH2D_OK)
        return halt(sim, status, report);
    double dt = sim->record.next_step;
    sim->system.step = dt;
    sim->system.speed = sim->record.speed;
    sph2d__profile_enter(profile, SPH2D_PHASE_MOVE);
    sph2d__momentum_begin(sim);
    status = sim->method->step(sim, dt);
    sph2d__profile_enter(profile, SPH2D_PHASE_BOOKKEEPING);
    if (sph2d__device_check(sim, report) != SPH2D_OK)
        return halt(sim, SPH2D_DEVICE, report);
    if (status == SPH2D_GUARD)
        sph2d__sim_measure(sim, report); /* reports the particle */
    if (status != SPH2D_OK)
        return halt(sim, status, report);
    sph2d__bodies_close(sim, dt);
    sph2d__loads_close(sim, dt);
    sph2d__momentum_end(sim, dt);
    sph2d__sim_absorb(sim, dt);
    sph2d__outlines_move(sim);
    advance_clock(sim, dt);
    const bool good = sph2d__sim_measure(sim, report);
    if (sph2d__device_check(sim, report) != SPH2D_OK)
        return halt(sim, SPH2D_DEVICE, report);
    if (!good)
        return halt(sim, SPH2D_GUARD, report);
    sph2d__sim_sample(sim);
    sph2d__sim_read_gauges(sim, dt);
    sph2d__tracers_choose(sim);
    status = sph2d__sim_watch_density(sim);
    if (status == SPH2D_OK)
        status = sph2d__sim_update_energy_balance(sim);
    if (sph2d__device_check(sim, report) != SPH2D_OK)
        status = SPH2D_DEVICE;
    if (status != SPH2D_OK)
        return halt(sim, status, report);
    if (!sph2d__sim_guard_energy(sim, report) || !sph2d__sim_guard_momentum(sim, report))
        return halt(sim, SPH2D_GUARD, report);
    sph2d__profile_enter(profile, SPH2D_PHASE_COUNT);
    return SPH2D_OK;
}

/** The number of threads, of at most `most`. Unless it is the caller's, each has two slabs: with fewer, threads take
 *  longer to meet than they save. */
static int threads_of(const sph2d_sim *sim, int most)
{
    size_t worth = sph2d__slabs(sim->system.fluid.count) / 2;
    return sim->threads > 0 || worth >= (size_t)most ? most : worth < 1 ? 1 : (int)worth;
}

int sph2d__sim_threads(const sph2d_sim *sim)
{
    return threads_of(sim, sph2d__max_threads(sim->threads));
}

/** Steps in one parallel region, or another where the number of particles changes that of the threads. */
static sph2d_status run(sph2d_sim *sim, sph2d_go_on *go_on, void *user, sph2d_report *report)
{
    sph2d_status status = sim->stopped;
    const int most = sph2d__max_threads(sim->threads); /* of the caller: inside it is that of regions in the region */
    if (status != SPH2D_OK)
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL,
                         "the simulation has stopped and takes no more steps: %s", sph2d_status_text(status));
    for (bool more = status == SPH2D_OK; more;) {
        const int threads = threads_of(sim, most);
#pragma omp parallel num_threads(threads)
#pragma omp master
        while (more && threads_of(sim, most) == threads) {
            more = go_on(user, sim);
            if (more)
                status = take_step(sim, report);
            more = more && status == SPH2D_OK;
        }
    }
    return status;
}

sph2d_status sph2d_sim_run(sph2d_sim *sim, sph2d_go_on *go_on, void *user, sph2d_report *report)
{
    if (!sim)
        return sph2d__null(report, __func__, "sim");
    return go_on ? run(sim, go_on, user, report) : sph2d__null(report, __func__, "go_on");
}

static bool is_first(void *asked, sph2d_sim *sim)
{
    (void)sim;
    bool first = !*(bool *)asked;
    *(bool *)asked = true;
    return first;
}

sph2d_status sph2d_sim_step(sph2d_sim *sim, sph2d_report *report)
{
    bool asked = false;
    return sim ? run(sim, is_first, &asked, report) : sph2d__null(report, __func__, "sim");
}
