/* SPDX-License-Identifier: MIT */
/** @file row_check.c
 *  Whether the measures of a study fit the scene of a row. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/suggest.h"
#include "study/parts.h"

enum { MOST_PROBES = 64 };

/** The names of a probe's columns, without units. */
typedef struct column_names {
    char room[SPH2D_PROBE_MAX_COLUMNS][48];
    const char *list[SPH2D_PROBE_MAX_COLUMNS + 1]; /**< ended by NULL */
} column_names;

static void list_columns(const char *headings, column_names *out)
{
    size_t count = 0;
    for (const char *at = headings; at && count < SPH2D_PROBE_MAX_COLUMNS; ++count) {
        size_t length = strcspn(at, ",");
        snprintf(out->room[count], sizeof out->room[count], "%.*s", (int)length, at);
        char *unit = strstr(out->room[count], " [");
        if (unit)
            *unit = '\0';
        out->list[count] = out->room[count];
        at = at[length] ? at + length + 1 : NULL;
    }
    out->list[count] = NULL;
}

bool sph2d__column_find(const char *headings, const char *name, size_t *column)
{
    column_names names;
    list_columns(headings, &names);
    for (*column = 0; names.list[*column]; ++*column)
        if (strcmp(names.list[*column], name) == 0)
            return true;
    return false;
}

/** Reports a fault of key `key` of measure `index`, at its place in the study. */
static sph2d_diagnostic *fault(const sph2d_study_results *results, sph2d_report *report, size_t index, const char *key,
                               sph2d_code code, const char *format, ...)
{
    char path[64], message[160];
    va_list values;
    va_start(values, format);
    vsnprintf(message, sizeof message, format, values);
    va_end(values);
    snprintf(path, sizeof path, "measures[%zu].%s", index, key);
    sph2d_diagnostic *d = sph2d_report_add(report, SPH2D_ERROR, code, path, "%s", message);
    sph2d_study_file_locate(results->file, d);
    return d;
}

static size_t check_probe(const sph2d_study_results *results, size_t index, const sph2d_scene *scene,
                          sph2d_report *report)
{
    const sph2d_study_measure *m = &results->study->measures[index];
    const char *names[MOST_PROBES + 1] = {NULL};
    size_t probe = 0, column, faults = 0;
    for (size_t i = 0; i < scene->probe_count && i < MOST_PROBES; ++i)
        names[i] = scene->probes[i].name;
    while (probe < scene->probe_count && strcmp(scene->probes[probe].name, m->probe) != 0)
        ++probe;
    if (probe == scene->probe_count) {
        sph2d_diagnostic *d =
            fault(results, report, index, "probe", SPH2D_CODE_WRONG_TYPE, "the scene has no probe '%.60s'", m->probe);
        sph2d__suggest_word(d, m->probe, names, "probes of the scene");
        return 1;
    }
    const char *headings = sph2d_probe_columns(scene->probes[probe].kind);
    if (!sph2d__column_find(headings, m->column, &column)) {
        column_names columns;
        list_columns(headings, &columns);
        sph2d_diagnostic *d = fault(results, report, index, "column", SPH2D_CODE_WRONG_TYPE,
                                    "the probe '%.60s' has no column '%.60s'", m->probe, m->column);
        sph2d__suggest_word(d, m->column, columns.list, "its columns");
        ++faults;
    }
    if (m->take == SPH2D_TAKE_VALUE && m->at > scene->run.until * (1 + 1e-12)) {
        fault(results, report, index, "at", SPH2D_CODE_OUT_OF_RANGE, "%g s is after the end of the run at %g s", m->at,
              scene->run.until);
        ++faults;
    }
    return faults;
}

static size_t check_profile(const sph2d_study_results *results, size_t index, const sph2d_scene *scene,
                            sph2d_report *report)
{
    const sph2d_points *line = &results->study->measures[index].profile.line;
    const sph2d_box *domain = &scene->domain;
    size_t faults = 0;
    for (size_t i = 0; i < line->count; ++i) {
        sph2d_vec2 end = line->items[i];
        if (end.x >= domain->min.x && end.x <= domain->max.x && end.y >= domain->min.y && end.y <= domain->max.y)
            continue;
        fault(results, report, index, "profile.line", SPH2D_CODE_OUTSIDE, "the end (%g, %g) lies outside the domain",
              end.x, end.y);
        ++faults;
    }
    return faults;
}

/** Errors that are found when particles are placed. Warnings are reported when the row runs. */
static sph2d_status place_particles(const sph2d_scene *scene, sph2d_report *report)
{
    sph2d_sim *sim;
    size_t first = report ? report->count : 0;
    sph2d_status status = sph2d_sim_create(scene, NULL, &sim, report);
    sph2d_sim_destroy(sim);
    if (status == SPH2D_OK && report)
        report->count = first;
    return status;
}

sph2d_status sph2d__row_check(const sph2d_study_results *results, const sph2d_study_run *run, bool place,
                              sph2d_report *report)
{
    sph2d_scene_file *file;
    size_t first = report ? report->count : 0, faults = 0;
    sph2d_status status = sph2d_study_run_scene(results, run, &file, report);
    if (status != SPH2D_OK)
        return status;
    const sph2d_scene *scene = sph2d_scene_file_scene(file);
    for (size_t i = 0; i < results->study->measure_count; ++i) {
        if (results->study->measures[i].source == SPH2D_MEASURE_PROBE)
            faults += check_probe(results, i, scene, report);
        else
            faults += check_profile(results, i, scene, report); /* of a summary the line has no ends */
    }
    status = faults > 0 ? SPH2D_SCENE : place ? place_particles(scene, report) : SPH2D_OK;
    sph2d__row_locate(results, run, file, report, first);
    sph2d_scene_file_destroy(file);
    return status;
}
