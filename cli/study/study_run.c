/* SPDX-License-Identifier: MIT */
/** @file study_run.c
 *  Runs one row of a study and collects what is measured. */
#include "study_run.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../clock.h"
#include "../exit.h"
#include "../loop.h"
#include "../message.h"
#include "../progress.h"
#include "../signals.h"
#include "../summary.h"
#include "study_measure.h"
#include "study_scene.h"

typedef struct runner {
    cli_study *study;
    const sph2d_study_run *run;
    study_record *record;
    sph2d_scene_file *file;
    sph2d_sim *sim;
    bool alone;
    bool again; /* a repeat, whose warnings were printed before */
    cli_progress progress;
} runner;

/* ---- what is collected ------------------------------------------------------------------------------------------- */

/* A series for each probe of the scene. */
static bool begin_series(runner *r)
{
    const sph2d_scene *scene = sph2d_sim_scene(r->sim);
    study_record *record = r->record;
    record->series = calloc(scene->probe_count + 1, sizeof *record->series);
    for (size_t i = 0; record->series != NULL && i < scene->probe_count; ++i) {
        const sph2d_probe *probe = &scene->probes[i];
        study_series *series = &record->series[record->series_count++];
        series->probe = strdup(probe->name);
        series->headings = strdup(sph2d_probe_columns(probe->kind));
        series->columns = study_column_count(series->headings);
        if (series->probe == NULL || series->headings == NULL)
            return false;
    }
    return record->series != NULL;
}

/* Takes every probe that is due now, as `run` would write it. */
static sph2d_status take_due(runner *r)
{
    double begun = clock_cpu();
    for (size_t i = 0; i < r->record->series_count; ++i) {
        if (!sph2d_sim_output_due(r->sim, SPH2D_OUTPUT_PROBE + i))
            continue;
        double values[SPH2D_PROBE_MAX_COLUMNS] = {0};
        sph2d_sim_probe(r->sim, i, values);
        sph2d_sim_output_done(r->sim, SPH2D_OUTPUT_PROBE + i);
        if (!study_series_add(&r->record->series[i], sph2d_sim_time(r->sim), values))
            return SPH2D_NOMEM;
    }
    r->record->probes += clock_cpu() - begun;
    return SPH2D_OK;
}

static double quantity(const sph2d_sample *sample, sph2d_quantity what)
{
    switch (what) {
    case SPH2D_QUANTITY_VX:
        return sample->velocity[0];
    case SPH2D_QUANTITY_VY:
        return sample->velocity[1];
    case SPH2D_QUANTITY_SPEED:
        return hypot(sample->velocity[0], sample->velocity[1]);
    case SPH2D_QUANTITY_PRESSURE:
        return sample->pressure;
    case SPH2D_QUANTITY_DENSITY:
        return sample->density;
    }
    return NAN;
}

/* The liquid along the line of each profile that is measured. */
static sph2d_status take_samples(runner *r)
{
    for (size_t i = 0; i < r->study->study->measure_count; ++i) {
        const sph2d_study_measure *m = &r->study->study->measures[i];
        if (m->source != SPH2D_MEASURE_PROFILE)
            continue;
        study_samples *samples = study_record_add_samples(r->record, study_measure_places(r->study, i));
        if (samples == NULL)
            return SPH2D_NOMEM;
        memcpy(samples->ends, m->profile.line.items, sizeof samples->ends);
        samples->quantity = m->profile.value;
        const sph2d_vec2 *ends = samples->ends;
        for (size_t k = 0; k < samples->count; ++k) {
            double part = samples->along[k] = study_measure_place(r->study, i, k);
            sph2d_vec2 at = {ends[0].x + part * (ends[1].x - ends[0].x), ends[0].y + part * (ends[1].y - ends[0].y)};
            sph2d_sample sample;
            bool near = sph2d_sim_sample(r->sim, at, &sample);
            samples->values[k] = near ? quantity(&sample, samples->quantity) : NAN;
        }
    }
    return SPH2D_OK;
}

/* ---- steps ------------------------------------------------------------------------------------------------------- */

static sph2d_status step(runner *r)
{
    double wall = clock_wall(), cpu = clock_cpu();
    sph2d_status status = sph2d_sim_step(r->sim, &r->study->report);
    r->record->wall += clock_wall() - wall;
    r->record->cpu += clock_cpu() - cpu;
    return status;
}

/* Steps to the end of the scene, to a guard or to a signal. */
static sph2d_status advance(runner *r)
{
    const double until = sph2d_sim_scene(r->sim)->run.until;
    sph2d_status status = take_due(r);
    while (status == SPH2D_OK && !loop_done(r->sim)) {
        /* Nobody waits for a row whose study was killed. */
        if (signals_caught() != 0 || getppid() != r->study->process) {
            r->record->end = STUDY_STOPPED;
            break;
        }
        status = step(r);
        if (status == SPH2D_OK)
            status = take_due(r);
        double time = sph2d_sim_time(r->sim);
        if (r->alone)
            progress_update(&r->progress, time, "t %.4g of %.4g s  step %" PRIu64 "  %s", time, until,
                            sph2d_sim_steps(r->sim), r->run->name);
    }
    return status;
}

/* ---- one run ----------------------------------------------------------------------------------------------------- */

/* Faults of the run itself get the name of the row, since all rows share the terminal. */
static void name_row(runner *r)
{
    sph2d_report *report = &r->study->report;
    for (size_t i = 0; i < report->count; ++i) {
        sph2d_diagnostic *d = &report->items[i];
        char message[sizeof d->message];
        memcpy(message, d->message, sizeof message);
        if (d->severity == SPH2D_ERROR && r->record->reason[0] == '\0')
            memcpy(r->record->reason, message, sizeof message);
        snprintf(d->message, sizeof d->message, "row '%.60s': %.250s", r->run->name, message);
    }
}

static int report_status(runner *r, sph2d_status status)
{
    if (r->again && status == SPH2D_OK)
        sph2d_report_clear(&r->study->report);
    name_row(r);
    if (status != SPH2D_OK && r->record->reason[0] == '\0')
        snprintf(r->record->reason, sizeof r->record->reason, "%s", sph2d_status_text(status));
    if (status != SPH2D_OK)
        r->record->end = status == SPH2D_GUARD ? STUDY_GUARD : STUDY_FAILED;
    return study_report(r->study, status, r->file, r->run);
}

static int create(runner *r)
{
    double begun = clock_cpu();
    int code = study_scene_open(r->study, r->run, &r->file);
    if (code != CLI_EXIT_SUCCESS) {
        r->record->end = STUDY_FAILED;
        snprintf(r->record->reason, sizeof r->record->reason, "the scene was rejected");
        return code;
    }
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = r->study->threads.count;
    options.isa = r->study->options->isa;
    code = report_status(r, sph2d_sim_create(sph2d_scene_file_scene(r->file), &options, &r->sim, &r->study->report));
    r->record->start = clock_cpu() - begun;
    return code == CLI_EXIT_SUCCESS && !begin_series(r) ? report_status(r, SPH2D_NOMEM) : code;
}

/* A part of the scene's energy; NaN where there is none. */
static double of_scale(double energy, const sph2d_summary *summary)
{
    return summary->energy_scale > 0 ? energy / summary->energy_scale : NAN;
}

static void fill_record(const runner *r)
{
    study_record *record = r->record;
    sph2d_summary summary = sph2d_sim_summary(r->sim);
    record->spacing = sph2d_sim_scene(r->sim)->spacing;
    record->particles = summary.particles;
    record->steps = summary.steps;
    record->particle_steps = summary.particle_steps;
    record->time = summary.time;
    for (int side = 0; side < 4; ++side)
        record->left += summary.left_open[side];
    record->summary[SPH2D_SUMMARY_COMPRESSION] = summary.compression_p99;
    record->summary[SPH2D_SUMMARY_COMPRESSION_MEAN] = summary.compression_mean;
    record->summary[SPH2D_SUMMARY_COMPRESSION_MAX] = summary.compression_max;
    double start = fabs(summary.energy_start), scale = start > 0 ? start : 1, steps = (double)summary.steps;
    record->summary[SPH2D_SUMMARY_ENERGY_CHANGE] = summary_energy_change(&summary) / scale;
    sph2d_densities inside = sph2d_sim_densities(r->sim);
    record->summary[SPH2D_SUMMARY_ENERGY_RISE] = of_scale(summary.energy_rise, &summary);
    record->summary[SPH2D_SUMMARY_ENERGY_ERROR] = of_scale(summary.energy_error, &summary);
    record->summary[SPH2D_SUMMARY_DENSITY_APART] = fmax(summary.density_apart, fabs(inside.reported - inside.counted));
    record->summary[SPH2D_SUMMARY_LEFT] = (double)record->left;
    record->summary[SPH2D_SUMMARY_ITERATIONS] = steps > 0 ? (double)summary.iterations / steps : 0;
    snprintf(record->isa, sizeof record->isa, "%s", sph2d_isa_name(sph2d_sim_isa(r->sim)));
}

static void go(runner *r)
{
    study_record *record = r->record;
    record->code = create(r);
    if (record->code != CLI_EXIT_SUCCESS)
        return;
    double until = sph2d_sim_scene(r->sim)->run.until;
    r->progress = progress_begin(r->study->options, 0, until);
    r->progress.printed_tenth = 10; /* rows are printed anyway: lines come only where one takes long */
    sph2d_status status = advance(r);
    progress_end(&r->progress);
    if (status == SPH2D_OK && record->end == STUDY_FINISHED)
        status = take_samples(r);
    record->code = report_status(r, status);
    fill_record(r);
}

static void run_once(cli_study *s, const sph2d_study_run *run, bool alone, bool again, study_record *record)
{
    runner r = {.study = s, .run = run, .record = record, .alone = alone, .again = again};
    record->end = STUDY_FINISHED;
    record->repeats = 1;
    go(&r);
    if (!alone)
        record->wall = NAN;
    sph2d_sim_destroy(r.sim);
    sph2d_scene_file_destroy(r.file);
}

/* ---- repeats ----------------------------------------------------------------------------------------------------- */

/* Keeps the least times of both. What a second run says otherwise is the same bit for bit. */
static void merge(study_record *kept, const study_record *more)
{
    kept->cpu = fmin(kept->cpu, more->cpu);
    kept->wall = fmin(kept->wall, more->wall);
    kept->start = fmin(kept->start, more->start);
    kept->probes = fmin(kept->probes, more->probes);
    ++kept->repeats;
}

void study_run(cli_study *s, const sph2d_study_run *run, bool alone, study_record *record)
{
    run_once(s, run, alone, false, record);
    bool brief = record->cpu < SPH2D_STUDY_REPEATED * (double)s->threads.count;
    for (uint64_t i = 1; i < s->repeat && brief && record->end == STUDY_FINISHED; ++i) {
        study_record more = {0};
        run_once(s, run, alone, true, &more);
        if (more.end == STUDY_FINISHED)
            merge(record, &more);
        else {
            record->end = more.end;
            record->code = more.code;
            memcpy(record->reason, more.reason, sizeof record->reason);
        }
        study_record_free(&more);
    }
}
