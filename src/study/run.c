/* SPDX-License-Identifier: MIT */
/** @file run.c
 *  Runs one row of a study and collects what is measured. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/null.h"
#include "base/system.h"
#include "sph2d/contacts.h"
#include "study/parts.h"

typedef struct runner {
    const sph2d_study_results *results;
    const sph2d_study_run *run;
    const sph2d_study_run_options *options;
    sph2d_study_record *record;
    const sph2d_scene_file *file;
    sph2d_sim *sim;
    sph2d_report said;          /* by the simulation, to be passed on ... */
    sph2d_report *report;       /* ... to here */
    bool again;                 /* a repeat, which gives the same warnings again */
    bool stepping;              /* a step was begun ... */
    double step_wall, step_cpu; /* ... at these times [s] */
    sph2d_status taken;         /* how measuring between the steps went */
} runner;

/* ---- what is collected ------------------------------------------------------------------------------------------- */

/** A series for each probe of the scene. */
static sph2d_status begin_series(runner *r)
{
    const sph2d_scene *scene = sph2d_sim_scene(r->sim);
    for (size_t i = 0; i < scene->probe_count; ++i) {
        const sph2d_probe *probe = &scene->probes[i];
        size_t columns = 1;
        for (const char *c = sph2d_probe_columns(probe->kind); *c; ++c)
            columns += *c == ',';
        sph2d_study_series *series = sph2d__record_add(r->record, columns, 0);
        if (!series)
            return SPH2D_NOMEM;
        snprintf(series->probe, sizeof series->probe, "%s", probe->name);
        series->kind = probe->kind;
    }
    return SPH2D_OK;
}

/** Evaluates every probe that is due now. */
static sph2d_status take_due(runner *r)
{
    double begun = sph2d__cpu_clock();
    for (size_t i = 0; i < r->record->series_count; ++i) {
        if (!sph2d_sim_output_due(r->sim, SPH2D_OUTPUT_PROBE + i))
            continue;
        double values[SPH2D_PROBE_MAX_COLUMNS] = {0};
        if (sph2d_sim_probe(r->sim, i, values) == 0)
            return SPH2D_NOMEM;
        sph2d_sim_output_done(r->sim, SPH2D_OUTPUT_PROBE + i);
        if (!sph2d__series_add(&r->record->series[i], sph2d_sim_time(r->sim), values))
            return SPH2D_NOMEM;
    }
    r->record->probes += sph2d__cpu_clock() - begun;
    return SPH2D_OK;
}

static double quantity(const sph2d_sample *sample, sph2d_quantity what)
{
    const double *v = sample->velocity;
    const double values[] = {v[0], v[1], hypot(v[0], v[1]), sample->pressure, sample->density}; /* as in the enum */
    return values[what];
}

/** The liquid along the line of each profile that is measured. */
static sph2d_status take_profiles(runner *r)
{
    for (size_t i = 0; i < r->results->study->measure_count; ++i) {
        const sph2d_study_measure *m = &r->results->study->measures[i];
        const sph2d_study_curve *places = &r->results->references[i];
        if (m->source != SPH2D_MEASURE_PROFILE)
            continue;
        sph2d_study_series *series = sph2d__record_add(r->record, 1, places->count);
        if (!series)
            return SPH2D_NOMEM;
        series->quantity = m->profile.value;
        const sph2d_vec2 *ends = memcpy(series->ends, m->profile.line.items, sizeof series->ends);
        for (size_t k = 0; k < places->count; ++k) {
            double part = places->x[k];
            sph2d_vec2 at = {ends[0].x + part * (ends[1].x - ends[0].x), ends[0].y + part * (ends[1].y - ends[0].y)};
            sph2d_sample sample;
            double value = sph2d_sim_sample(r->sim, at, &sample) ? quantity(&sample, series->quantity) : NAN;
            if (!sph2d__series_add(series, part, &value))
                return SPH2D_NOMEM;
        }
    }
    return SPH2D_OK;
}

/** An energy over the scene's energy scale; NaN if that is 0. */
static double of_scale(double energy, const sph2d_summary *summary)
{
    return summary->energy_scale > 0 ? energy / summary->energy_scale : NAN;
}

static sph2d_status take_summary(runner *r)
{
    sph2d_study_record *record = r->record;
    sph2d_summary s = sph2d_sim_summary(r->sim);
    sph2d_densities inside = sph2d_sim_densities(r->sim);
    record->spacing = sph2d_sim_scene(r->sim)->spacing;
    record->particles = s.particles;
    record->steps = s.steps;
    record->particle_steps = s.particle_steps;
    record->time = s.time;
    for (int side = 0; side < 4; ++side)
        record->left += s.left_open[side];
    double start = fabs(s.energy_start), steps = (double)s.steps;
    double change = s.kinetic + s.potential + s.elastic + s.bodies - s.energy_start - s.energy_fed;
    double *values = record->summary;
    values[SPH2D_SUMMARY_COMPRESSION] = s.compression_p99;
    values[SPH2D_SUMMARY_COMPRESSION_MEAN] = s.compression_mean;
    values[SPH2D_SUMMARY_COMPRESSION_MAX] = s.compression_max;
    values[SPH2D_SUMMARY_ENERGY_CHANGE] = change / (start > 0 ? start : 1);
    values[SPH2D_SUMMARY_ENERGY_RISE] = of_scale(s.energy_rise, &s);
    values[SPH2D_SUMMARY_ENERGY_ERROR] = of_scale(s.energy_error, &s);
    values[SPH2D_SUMMARY_DENSITY_APART] = fmax(s.density_apart, fabs(inside.reported - inside.counted));
    values[SPH2D_SUMMARY_LEFT] = (double)record->left;
    values[SPH2D_SUMMARY_ITERATIONS] = steps > 0 ? (double)s.iterations / steps : 0;
    snprintf(record->isa, sizeof record->isa, "%s", sph2d_isa_name(sph2d_sim_isa(r->sim)));
    return inside.status;
}

/* ---- one run ----------------------------------------------------------------------------------------------------- */

/** Times the step that has been begun, if one has. */
static void end_step(runner *r)
{
    if (!r->stepping)
        return;
    r->record->wall += sph2d__wall_clock() - r->step_wall;
    r->record->cpu += sph2d__cpu_clock() - r->step_cpu;
    r->stepping = false;
}

/** Whether to go on: not at the end of the scene, after an error of what is measured, or when the caller asks to stop. */
static bool go_on(void *runner_, sph2d_sim *sim)
{
    runner *r = runner_;
    end_step(r);
    r->taken = take_due(r);
    /* The time is a sum of steps: a rounding error before the end must not cause one more step. */
    if (r->taken != SPH2D_OK || sph2d_sim_time(sim) * (1 + 1e-12) >= sph2d_sim_scene(sim)->run.until)
        return false;
    if (r->options->go_on && !r->options->go_on(r->options->user, r->run, sim)) {
        r->record->end = SPH2D_STUDY_STOPPED;
        return false;
    }
    r->stepping = true;
    r->step_wall = sph2d__wall_clock();
    r->step_cpu = sph2d__cpu_clock();
    return true;
}

/** Steps to the end of the scene, to a guard or until the caller asks to stop. */
static sph2d_status advance(runner *r)
{
    sph2d_status status = sph2d_sim_run(r->sim, go_on, r, &r->said);
    end_step(r);
    if (status == SPH2D_OK)
        status = r->taken;
    return status == SPH2D_OK && r->record->end != SPH2D_STUDY_STOPPED ? take_profiles(r) : status;
}

/** Forwards the simulation's messages with the name of the row, since rows may share a terminal. The first error is the
 *  reason. */
static void pass_on(runner *r)
{
    sph2d__row_locate(r->results, r->run, r->file, &r->said, 0);
    for (size_t i = 0; i < r->said.count; ++i) {
        const sph2d_diagnostic *d = &r->said.items[i];
        if (d->severity == SPH2D_ERROR && r->record->reason[0] == '\0')
            memcpy(r->record->reason, d->message, sizeof d->message);
        if (r->again && d->severity == SPH2D_WARNING)
            continue;
        sph2d_diagnostic named = *d;
        snprintf(named.message, sizeof named.message, "row '%.60s': %.250s", r->run->name, d->message);
        sph2d_diagnostic *copy = sph2d_report_add(r->report, d->severity, d->code, NULL, "%s", named.message);
        if (copy)
            *copy = named;
    }
    if (r->report)
        r->report->dropped += r->said.dropped;
    sph2d_report_clear(&r->said);
}

static sph2d_status go(runner *r, double begun)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    if (r->options->threads > 0)
        options.threads = r->options->threads;
    options.isa = r->options->isa;
    options.device = r->options->device;
    options.same_bits = r->options->same_bits;
    sph2d_status status = sph2d_sim_create(sph2d_scene_file_scene(r->file), &options, &r->sim, &r->said);
    sph2d_contacts_attach(r->sim);
    r->record->start = sph2d__cpu_clock() - begun;
    pass_on(r);
    if (status == SPH2D_OK)
        status = begin_series(r);
    if (status != SPH2D_OK)
        return status;
    status = advance(r);
    pass_on(r);
    sph2d_status taken = take_summary(r);
    return status == SPH2D_OK ? taken : status;
}

/** Runs a row once. Returns the largest number of threads that shared a step. */
static int run_once(const sph2d_study_results *results, const sph2d_study_run *run,
                    const sph2d_study_run_options *options, bool again, sph2d_study_record *record,
                    sph2d_report *report)
{
    runner r = {.results = results, .run = run, .options = options, .record = record, .report = report, .again = again};
    double begun = sph2d__cpu_clock();
    sph2d_scene_file *file;
    sph2d_status status = sph2d_study_run_scene(results, run, &file, report);
    record->repeats = 1;
    if (status != SPH2D_OK) {
        snprintf(record->reason, sizeof record->reason, "%s",
                 status == SPH2D_SCENE ? "the scene was rejected" : sph2d_status_text(status));
    } else {
        r.file = file;
        status = go(&r, begun);
    }
    record->status = status;
    if (status != SPH2D_OK)
        record->end = status == SPH2D_GUARD ? SPH2D_STUDY_GUARD : SPH2D_STUDY_FAILED;
    if (status != SPH2D_OK && record->reason[0] == '\0')
        snprintf(record->reason, sizeof record->reason, "%s", sph2d_status_text(status));
    if (options->beside_others)
        record->wall = NAN;
    int threads = r.sim ? sph2d_sim_threads(r.sim) : 1;
    sph2d_sim_destroy(r.sim);
    sph2d_scene_file_destroy(file);
    return threads;
}

/* ---- repeats ----------------------------------------------------------------------------------------------------- */

/** Keeps the smaller times of both. The other results of a second run are the same bit for bit, unless it did not
 *  finish. */
static void merge(sph2d_study_record *kept, const sph2d_study_record *more)
{
    if (more->end != SPH2D_STUDY_FINISHED) {
        kept->end = more->end;
        kept->status = more->status;
        memcpy(kept->reason, more->reason, sizeof kept->reason);
        return;
    }
    kept->cpu = fmin(kept->cpu, more->cpu);
    kept->wall = fmin(kept->wall, more->wall);
    kept->start = fmin(kept->start, more->start);
    kept->probes = fmin(kept->probes, more->probes);
    ++kept->repeats;
}

sph2d_status sph2d_study_row_run(const sph2d_study_results *results, sph2d_study_row *row,
                                 const sph2d_study_run_options *options, sph2d_report *report)
{
    if (!results)
        return sph2d__null(report, __func__, "results");
    if (!row)
        return sph2d__null(report, __func__, "row");
    static const sph2d_study_run_options plain = {0};
    options = options ? options : &plain;
    sph2d_study_record *record = &row->record;
    uint64_t repeat = options->repeat > 0 ? options->repeat : results->study->repeat;
    int threads = run_once(results, &row->run, options, false, record, report);
    bool brief = record->cpu < SPH2D_STUDY_REPEATED * (double)threads;
    for (uint64_t i = 1; i < repeat && brief && record->end == SPH2D_STUDY_FINISHED; ++i) {
        sph2d_study_record more = {0};
        run_once(results, &row->run, options, true, &more, report);
        merge(record, &more);
        sph2d_study_record_free(&more);
    }
    row->there = true;
    return record->status;
}
