/* SPDX-License-Identifier: MIT */
/** @file study_run.c
 *  Runs one row of a study and collects the series that are measured. */
#include "study_run.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../clock.h"
#include "../exit.h"
#include "../loop.h"
#include "../message.h"
#include "../progress.h"
#include "../signals.h"
#include "study_csv.h"
#include "study_measure.h"
#include "study_scene.h"

typedef struct runner {
    cli_study *study;
    study_row *row;
    sph2d_scene_file *file;
    sph2d_sim *sim;
    study_series *series; /* one a probe of the scene */
    cli_progress progress;
} runner;

/* ---- series ------------------------------------------------------------------------------------------------------ */

/* Notes which probes are measured. False when memory is short. */
static bool begin_series(runner *r)
{
    const sph2d_scene *scene = sph2d_sim_scene(r->sim);
    r->series = calloc(scene->probe_count + 1, sizeof *r->series);
    for (size_t i = 0; r->series != NULL && i < r->study->study->measure_count; ++i) {
        const sph2d_study_measure *m = &r->study->study->measures[i];
        study_column found;
        if (m->source != SPH2D_MEASURE_PROBE || !study_column_find(scene, m, &found))
            continue;
        r->series[found.probe].wanted = true;
        r->series[found.probe].columns = study_column_count(&scene->probes[found.probe]);
    }
    return r->series != NULL;
}

static bool add_row(study_series *series, double time, const double *values)
{
    if (series->count == series->room) {
        size_t room = series->room > 0 ? 2 * series->room : 256;
        double *times = realloc(series->time, room * sizeof *times);
        if (times != NULL)
            series->time = times;
        double *larger = realloc(series->values, room * series->columns * sizeof *larger);
        if (larger != NULL)
            series->values = larger;
        if (times == NULL || larger == NULL)
            return false;
        series->room = room;
    }
    series->time[series->count] = time;
    memcpy(series->values + series->count * series->columns, values, series->columns * sizeof *values);
    ++series->count;
    return true;
}

/* Takes every probe that is due now, as `run` would write it. */
static sph2d_status take_due(runner *r)
{
    for (size_t i = 0; i < sph2d_sim_scene(r->sim)->probe_count; ++i) {
        if (!r->series[i].wanted || !sph2d_sim_output_due(r->sim, SPH2D_OUTPUT_PROBE + i))
            continue;
        double values[SPH2D_PROBE_MAX_COLUMNS] = {0};
        sph2d_sim_probe(r->sim, i, values);
        sph2d_sim_output_done(r->sim, SPH2D_OUTPUT_PROBE + i);
        if (!add_row(&r->series[i], sph2d_sim_time(r->sim), values))
            return SPH2D_NOMEM;
    }
    return SPH2D_OK;
}

static void free_series(runner *r)
{
    for (size_t i = 0; r->series != NULL && i < sph2d_sim_scene(r->sim)->probe_count; ++i) {
        free(r->series[i].time);
        free(r->series[i].values);
    }
    free(r->series);
}

/* ---- steps ------------------------------------------------------------------------------------------------------- */

static sph2d_status step(runner *r)
{
    double wall = clock_wall(), cpu = clock_cpu();
    sph2d_status status = sph2d_sim_step(r->sim, &r->study->report);
    r->row->wall += clock_wall() - wall;
    r->row->cpu += clock_cpu() - cpu;
    return status;
}

/* Steps to the end of the scene, to a guard or to a signal. */
static sph2d_status advance(runner *r)
{
    const double until = sph2d_sim_scene(r->sim)->run.until;
    sph2d_status status = take_due(r);
    while (status == SPH2D_OK && !loop_done(r->sim)) {
        if (signals_caught() != 0) {
            r->row->end = STUDY_STOPPED;
            break;
        }
        status = step(r);
        if (status == SPH2D_OK)
            status = take_due(r);
        double time = sph2d_sim_time(r->sim);
        progress_update(&r->progress, time, "t %.4g of %.4g s  step %" PRIu64 "  %s", time, until,
                        sph2d_sim_steps(r->sim), r->row->run->name);
    }
    return status;
}

/* ---- the row ----------------------------------------------------------------------------------------------------- */

/* Faults of the run itself get the name of the row, since all rows share the terminal. */
static void name_row(runner *r)
{
    sph2d_report *report = &r->study->report;
    for (size_t i = 0; i < report->count; ++i) {
        sph2d_diagnostic *d = &report->items[i];
        char message[sizeof d->message];
        memcpy(message, d->message, sizeof message);
        if (d->severity == SPH2D_ERROR && r->row->reason[0] == '\0')
            memcpy(r->row->reason, message, sizeof message);
        snprintf(d->message, sizeof d->message, "row '%.60s': %.250s", r->row->run->name, message);
    }
}

static int told(runner *r, sph2d_status status)
{
    name_row(r);
    if (status != SPH2D_OK && r->row->reason[0] == '\0')
        snprintf(r->row->reason, sizeof r->row->reason, "%s", sph2d_status_text(status));
    if (status != SPH2D_OK)
        r->row->end = status == SPH2D_GUARD ? STUDY_GUARD : STUDY_FAILED;
    return study_told(r->study, status, r->file, r->row->run);
}

static int create(runner *r)
{
    int code = study_scene_open(r->study, r->row->run, &r->file);
    if (code != CLI_EXIT_SUCCESS) {
        r->row->end = STUDY_FAILED;
        snprintf(r->row->reason, sizeof r->row->reason, "the scene was rejected");
        return code;
    }
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = r->study->threads.count;
    options.isa = r->study->options->isa;
    code = told(r, sph2d_sim_create(sph2d_scene_file_scene(r->file), &options, &r->sim, &r->study->report));
    return code == CLI_EXIT_SUCCESS && !begin_series(r) ? told(r, SPH2D_NOMEM) : code;
}

static void fill_row(const runner *r)
{
    study_row *row = r->row;
    sph2d_summary summary = sph2d_sim_summary(r->sim);
    row->spacing = sph2d_sim_scene(r->sim)->spacing;
    row->particles = summary.particles;
    row->steps = summary.steps;
    row->particle_steps = summary.particle_steps;
    row->time = summary.time;
    r->study->isa = sph2d_isa_name(sph2d_sim_isa(r->sim));
}

static void go(runner *r)
{
    study_row *row = r->row;
    row->code = create(r);
    if (row->code != CLI_EXIT_SUCCESS)
        return;
    r->progress = progress_begin(r->study->options, 0, sph2d_sim_scene(r->sim)->run.until);
    r->progress.told_tenth = 10; /* rows are told anyway: lines come only where one takes long */
    sph2d_status status = advance(r);
    progress_end(&r->progress);
    row->code = told(r, status);
    fill_row(r);
    if (row->end == STUDY_FINISHED)
        row->code = told(r, study_measure(r->study, row, r->sim, r->series));
    if (row->end == STUDY_FINISHED || row->end == STUDY_GUARD) {
        int written = study_csv_write_series(r->study, row, sph2d_sim_scene(r->sim), r->series);
        row->code = row->code == CLI_EXIT_SUCCESS ? written : row->code;
    }
}

void study_run(cli_study *s, study_row *row)
{
    runner r = {.study = s, .row = row};
    row->end = STUDY_FINISHED;
    for (size_t i = 0; i < s->study->measure_count; ++i)
        row->values[i] = (study_value){NAN, NAN, NAN};
    go(&r);
    if (r.sim != NULL)
        free_series(&r);
    sph2d_sim_destroy(r.sim);
    sph2d_scene_file_destroy(r.file);
}
