/* SPDX-License-Identifier: MIT */
/** @file study_open.c
 *  The study to be done, and the scenes that come out of it. */
#define _XOPEN_SOURCE 700 /* realpath */
#include "study_open.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../exit.h"
#include "../message.h"
#include "study_front.h"
#include "study_scene.h"
#include "study_text.h"
#include "study_verdict.h"

/* ---- a study for a scene ----------------------------------------------------------------------------------------- */

/* A text in YAML's quotes. */
static void put_quoted(FILE *out, const char *text)
{
    putc('"', out);
    for (; *text != '\0'; ++text)
        fprintf(out, "%s%c", *text == '"' || *text == '\\' ? "\\" : "", *text);
    putc('"', out);
}

/* How much stiffer or softer: whatever the scene itself says it with. */
static void put_stiffness(FILE *out, const sph2d_method_options *method)
{
    double standard = sph2d_method_of(method)->max_compression;
    double compression = method->max_compression > 0 ? method->max_compression : standard;
    if (method->sound_speed > 0)
        fprintf(out, "  method.sound_speed: [%.4g, %.15g]\n", method->sound_speed / 2, method->sound_speed);
    else if (method->stiffness > 0)
        fprintf(out, "  method.stiffness: [%.4g, %.15g]\n", method->stiffness / 4, method->stiffness);
    else
        fprintf(out, "  method.max_compression: [%.4g, %.15g]\n", fmin(4 * compression, 0.9), compression);
}

static const sph2d_probe *find_probe(const sph2d_scene *scene, sph2d_probe_kind kind)
{
    for (size_t i = 0; i < scene->probe_count; ++i)
        if (scene->probes[i].kind == kind)
            return &scene->probes[i];
    return NULL;
}

/* By the exact solution where the scene starts with one, else by its kinetic energy over time. */
static void put_measure(FILE *out, const sph2d_probe *exact, const sph2d_probe *energy)
{
    if (exact != NULL)
        fprintf(out, "  - {name: speed L1, probe: %s, column: speed_l1, take: max, expect: 0, order: true}\n",
                exact->name);
    else
        fprintf(out,
                "  - {name: kinetic energy, probe: %s, column: kinetic, finest: true, norm: mean, relative: true, "
                "order: true}\n",
                energy != NULL ? energy->name : "energy");
}

/* What the command line changes of the scene belongs to the study, and the probe that it needs. */
static void put_run(FILE *out, const sph2d_scene *scene, const cli_options *options, bool probe)
{
    const char *before = "\nruns:\n  - name: scene\n    set: {";
    for (size_t i = 0; i < options->override_count; ++i, before = ", ") {
        fputs(before, out);
        put_quoted(out, options->overrides[i].path);
        fprintf(out, ": %s", options->overrides[i].value);
    }
    if (probe)
        fprintf(out, "%sprobes: [{name: energy, kind: energy, every: %.4g}]", before, scene->run.until / 100);
    if (probe || options->override_count > 0)
        fputs("}", out);
}

static void put_study(FILE *out, const char *path, const sph2d_scene *scene, const cli_options *options)
{
    const sph2d_probe *exact = find_probe(scene, SPH2D_PROBE_ERROR), *energy = find_probe(scene, SPH2D_PROBE_ENERGY);
    double dx = scene->spacing;
    fprintf(out, "# What the error of a scene costs: made by sph2d study, to be changed at will.\nscene: ");
    put_quoted(out, path);
    put_run(out, scene, options, exact == NULL && energy == NULL);
    fprintf(out, "\nvary:\n  spacing: [%.4g, %.4g, %.15g]\n", 2 * dx, sqrt(2) * dx, dx);
    put_stiffness(out, &scene->method);
    fprintf(out, "refine:\n  - {set: {spacing: %.4g}}\nmeasures:\n", dx / sqrt(2));
    put_measure(out, exact, energy);
    fprintf(out, "repeat: 1\n");
}

static int open_scene(cli_study *s)
{
    sph2d_scene_file *file;
    study_text text;
    sph2d_status status =
        sph2d_scene_file_read(s->path, s->options->overrides, s->options->override_count, &file, &s->report);
    if (status != SPH2D_OK)
        return study_report(s, status, NULL, NULL);
    sph2d_report_clear(&s->report);
    const sph2d_scene *scene = sph2d_scene_file_scene(file);
    char *path = realpath(s->path, NULL);
    status = SPH2D_NOMEM;
    if (path != NULL && study_text_begin(&text)) {
        put_study(text.out, path, scene, s->options);
        s->made = study_text_take(&text);
    }
    if (s->made != NULL)
        status = sph2d_study_file_parse(s->made, strlen(s->made), s->path, &s->file, &s->report);
    free(path);
    sph2d_scene_file_destroy(file);
    return study_report(s, status, NULL, NULL);
}

/* ---- reading ----------------------------------------------------------------------------------------------------- */

static bool has_fault(const sph2d_report *report, sph2d_code code, const char *path)
{
    for (size_t i = 0; i < report->count; ++i)
        if (report->items[i].code == code && strcmp(report->items[i].path, path) == 0)
            return true;
    return false;
}

/* A scene has what no study has, and lacks what every study has. */
static bool is_scene(const sph2d_report *report)
{
    return has_fault(report, SPH2D_CODE_MISSING_KEY, "scene") && (has_fault(report, SPH2D_CODE_UNKNOWN_KEY, "domain") ||
                                                                  has_fault(report, SPH2D_CODE_UNKNOWN_KEY, "spacing"));
}

int study_open(cli_study *s)
{
    int code;
    sph2d_status status = sph2d_study_file_read(s->path, &s->file, &s->report);
    if (status == SPH2D_SCENE && is_scene(&s->report)) {
        sph2d_report_clear(&s->report);
        code = open_scene(s);
    } else {
        code = study_report(s, status, NULL, NULL);
    }
    if (code == CLI_EXIT_SUCCESS)
        s->study = sph2d_study_file_study(s->file);
    return code;
}

/* ---- what is left for people ------------------------------------------------------------------------------------- */

/* The scene of a row, with what it is in its first lines. */
static void put_scene(const cli_study *s, const study_row *row, const char *text, FILE *out)
{
    char verdict[512];
    study_verdict(s, verdict, sizeof verdict);
    char *line = strdup(s->study->scene); /* a comment is one line */
    for (char *c = line; c != NULL && *c != '\0'; ++c)
        *c = (unsigned char)*c < 0x20 ? ' ' : *c;
    fprintf(out, "# %s with %s.\n# %s\n%s", line != NULL ? line : "", row->run.name, verdict, text);
    free(line);
}

/* The file of particles is named from the scene's folder; a scene that moves must name it from anywhere. */
static char *particles_path(const cli_study *s, const char *file)
{
    const char *slash = strrchr(s->study->scene, '/');
    size_t folder = slash != NULL && file[0] != '/' ? (size_t)(slash - s->study->scene) + 1 : 0;
    size_t size = folder + strlen(file) + 1;
    char *joined = malloc(size), *path = NULL;
    if (joined != NULL) {
        snprintf(joined, size, "%.*s%s", (int)folder, s->study->scene, file);
        path = realpath(joined, NULL);
    }
    free(joined);
    return path;
}

static sph2d_status write_scene(cli_study *s, const study_row *row, const sph2d_scene *scene)
{
    sph2d_scene moved = *scene;
    char *particles = scene->particles.file != NULL ? particles_path(s, scene->particles.file) : NULL;
    if (particles != NULL)
        moved.particles.file = particles;
    size_t length = sph2d_scene_text(&moved, NULL, 0);
    char *text = malloc(length + 1);
    study_text page;
    sph2d_status status = SPH2D_NOMEM;
    if (text != NULL && length > 0 && study_text_begin(&page)) {
        sph2d_scene_text(&moved, text, length + 1);
        put_scene(s, row, text, page.out);
        status = study_text_write(&page, folder_file(&s->folder, "cheapest.yaml"), &s->report);
    }
    free(text);
    free(particles);
    return status;
}

static int write_cheapest(cli_study *s)
{
    const study_row *row = study_front_cheapest(s, s->target);
    sph2d_scene_file *file;
    if (row == NULL)
        return CLI_EXIT_SUCCESS;
    int code = study_scene_open(s, &row->run, &file);
    if (code != CLI_EXIT_SUCCESS)
        return code;
    code = study_report(s, write_scene(s, row, sph2d_scene_file_scene(file)), NULL, NULL);
    sph2d_scene_file_destroy(file);
    return code;
}

int study_open_write(cli_study *s)
{
    if (s->options->output == NULL)
        return CLI_EXIT_SUCCESS;
    int code = CLI_EXIT_SUCCESS;
    const char *path = s->made != NULL ? folder_file(&s->folder, "study.yaml") : NULL;
    if (path != NULL && folder_holds(s->folder.path, "study.yaml"))
        message_detail("'%s' is there already and stays as it is", path);
    else if (path != NULL)
        code = study_report(s, sph2d_text_write(path, s->made, strlen(s->made), &s->report), NULL, NULL);
    int written = write_cheapest(s);
    return code != CLI_EXIT_SUCCESS ? code : written;
}
