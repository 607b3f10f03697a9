/* SPDX-License-Identifier: MIT */
/** @file study_scene.c
 *  The scene of a row, and whether the measures fit it. */
#include "study_scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../exit.h"
#include "../message.h"
#include "../text.h"

enum { MOST_NAMES = 64, NAME_SIZE = 48 };

/* ---- what the report says ---------------------------------------------------------------------------------------- */

/* A fault of an override is reported by the library at `--set KEY=VALUE`. When the study says so, its place is there. */
static void locate_override(const cli_study *s, const sph2d_study_run *run, sph2d_diagnostic *d)
{
    for (size_t i = 0; i < run->override_count; ++i) {
        char name[sizeof d->file], path[sizeof d->path];
        snprintf(name, sizeof name, "--set %s=%s", run->overrides[i].path, run->overrides[i].value);
        if (strcmp(name, d->file) != 0)
            continue;
        memcpy(path, d->path, sizeof path);
        snprintf(d->path, sizeof d->path, "%s", run->places[i]);
        sph2d_study_file_locate(s->file, d);
        memcpy(d->path, path, sizeof path);
        return;
    }
}

int study_report(cli_study *s, sph2d_status status, const sph2d_scene_file *scene, const sph2d_study_run *row)
{
    for (size_t i = 0; i < s->report.count; ++i) {
        sph2d_diagnostic *d = &s->report.items[i];
        if (scene != NULL && d->file[0] == '\0' && d->path[0] != '\0')
            sph2d_scene_file_locate(scene, d);
        if (row != NULL)
            locate_override(s, row, d);
    }
    message_report(status, &s->report, NULL);
    return exit_of_status(status);
}

/* ---- reading ----------------------------------------------------------------------------------------------------- */

int study_scene_open(cli_study *s, const sph2d_study_run *run, sph2d_scene_file **file)
{
    size_t count = run->override_count + s->options->override_count;
    sph2d_override *overrides = malloc((count + 1) * sizeof *overrides);
    sph2d_status status = SPH2D_NOMEM;
    *file = NULL;
    if (overrides != NULL) {
        /* What the command line says comes last, but for a study that was made of the scene as it is with that. */
        size_t more = s->options->override_count, at = s->made != NULL ? 0 : run->override_count;
        for (size_t i = 0; i < more; ++i)
            overrides[at + i] = s->options->overrides[i];
        for (size_t i = 0; i < run->override_count; ++i)
            overrides[s->made != NULL ? more + i : i] = run->overrides[i];
        status = sph2d_scene_file_read(s->study->scene, overrides, count, file, &s->report);
    }
    free(overrides);
    if (status == SPH2D_OK) /* making the simulation finds the warnings again */
        sph2d_report_clear(&s->report);
    return study_report(s, status, NULL, run);
}

/* ---- columns ----------------------------------------------------------------------------------------------------- */

/* Copies the name, without unit, of the column that starts at `text`; returns where the next one starts, or NULL. */
static const char *take_name(const char *text, char name[NAME_SIZE])
{
    size_t length = strcspn(text, ",");
    snprintf(name, NAME_SIZE, "%.*s", (int)length, text);
    char *unit = strstr(name, " [");
    if (unit != NULL)
        *unit = '\0';
    return text[length] == ',' ? text + length + 1 : NULL;
}

size_t study_column_count(const char *headings)
{
    size_t count = 1;
    for (const char *c = headings; *c != '\0'; ++c)
        count += *c == ',';
    return count;
}

static size_t find_probe(const sph2d_scene *scene, const char *name)
{
    size_t i = 0;
    while (i < scene->probe_count && strcmp(scene->probes[i].name, name) != 0)
        ++i;
    return i;
}

/* The names of the columns; `names` points into `room`. */
static size_t list_columns(const char *headings, char room[MOST_NAMES][NAME_SIZE], const char *names[MOST_NAMES])
{
    size_t count = 0;
    for (const char *rest = headings; rest != NULL && count < MOST_NAMES; ++count) {
        rest = take_name(rest, room[count]);
        names[count] = room[count];
    }
    return count;
}

bool study_column_find(const char *headings, const char *name, size_t *column)
{
    char room[MOST_NAMES][NAME_SIZE];
    const char *names[MOST_NAMES];
    size_t count = list_columns(headings, room, names);
    for (*column = 0; *column < count; ++*column)
        if (strcmp(names[*column], name) == 0)
            return true;
    return false;
}

/* ---- whether the measures fit ------------------------------------------------------------------------------------ */

/* Reports a fault of key `key` of measure `index`, at its place in the study. */
static sph2d_diagnostic *fault(cli_study *s, size_t index, const char *key, sph2d_code code, const char *message)
{
    char path[64];
    snprintf(path, sizeof path, "measures[%zu].%s", index, key);
    sph2d_diagnostic *d = sph2d_report_add(&s->report, SPH2D_ERROR, code, path, "%s", message);
    if (d != NULL)
        sph2d_study_file_locate(s->file, d);
    return d;
}

/* "did you mean 'energy'?", or all there are. */
static void hint_names(sph2d_diagnostic *d, const char *word, const char *const *names, size_t count, const char *what)
{
    const char *nearest = text_nearest(word, names, count);
    if (d == NULL)
        return;
    if (nearest != NULL) {
        snprintf(d->hint, sizeof d->hint, "did you mean '%s'?", nearest);
        return;
    }
    snprintf(d->hint, sizeof d->hint, count > 0 ? "%s: " : "%s: none", what);
    for (size_t i = 0; i < count; ++i) {
        size_t used = strlen(d->hint);
        snprintf(d->hint + used, sizeof d->hint - used, "%s%s", i > 0 ? ", " : "", names[i]);
    }
}

static void check_probe(cli_study *s, size_t index, const sph2d_scene *scene)
{
    const sph2d_study_measure *m = &s->study->measures[index];
    char message[160], room[MOST_NAMES][NAME_SIZE];
    const char *names[MOST_NAMES];
    size_t probe = find_probe(scene, m->probe), column, count = 0;
    if (probe == scene->probe_count) {
        for (; count < scene->probe_count && count < MOST_NAMES; ++count)
            names[count] = scene->probes[count].name;
        snprintf(message, sizeof message, "the scene has no probe '%.60s'", m->probe);
        hint_names(fault(s, index, "probe", SPH2D_CODE_WRONG_TYPE, message), m->probe, names, count,
                   "probes of the scene");
        return;
    }
    const char *headings = sph2d_probe_columns(scene->probes[probe].kind);
    if (!study_column_find(headings, m->column, &column)) {
        count = list_columns(headings, room, names);
        snprintf(message, sizeof message, "the probe '%.60s' has no column '%.60s'", m->probe, m->column);
        hint_names(fault(s, index, "column", SPH2D_CODE_WRONG_TYPE, message), m->column, names, count, "its columns");
    }
    if (m->take == SPH2D_TAKE_VALUE && m->at > scene->run.until * (1 + 1e-12)) {
        snprintf(message, sizeof message, "%g s is after the end of the run at %g s", m->at, scene->run.until);
        fault(s, index, "at", SPH2D_CODE_OUT_OF_RANGE, message);
    }
}

static void check_profile(cli_study *s, size_t index, const sph2d_scene *scene)
{
    const sph2d_points *line = &s->study->measures[index].profile.line;
    for (size_t i = 0; i < line->count; ++i) {
        sph2d_vec2 end = line->items[i];
        bool inside = end.x >= scene->domain.min.x && end.x <= scene->domain.max.x && end.y >= scene->domain.min.y &&
                      end.y <= scene->domain.max.y;
        char message[160];
        snprintf(message, sizeof message, "the end (%g, %g) lies outside the domain", end.x, end.y);
        if (!inside)
            fault(s, index, "profile.line", SPH2D_CODE_OUTSIDE, message);
    }
}

/* Faults that show when particles are placed. */
static sph2d_status place_particles(const sph2d_scene *scene, sph2d_report *report)
{
    sph2d_sim *sim;
    sph2d_status status = sph2d_sim_create(scene, NULL, &sim, report);
    sph2d_sim_destroy(sim);
    return status;
}

int study_scene_check(cli_study *s, const sph2d_study_run *run, bool place)
{
    sph2d_scene_file *file;
    int code = study_scene_open(s, run, &file);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    const sph2d_scene *scene = sph2d_scene_file_scene(file);
    for (size_t i = 0; i < s->study->measure_count; ++i) {
        if (s->study->measures[i].source == SPH2D_MEASURE_PROBE)
            check_probe(s, i, scene);
        else
            check_profile(s, i, scene);
    }
    sph2d_status status = s->report.errors > 0 ? SPH2D_SCENE : SPH2D_OK;
    if (status == SPH2D_OK && place)
        status = place_particles(scene, &s->report);
    if (status == SPH2D_OK)
        sph2d_report_clear(&s->report);
    code = study_report(s, status, file, run);
    sph2d_scene_file_destroy(file);
    return code;
}
