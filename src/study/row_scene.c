/* SPDX-License-Identifier: MIT */
/** @file row_scene.c
 *  The scene of a row, as structs and as text. */
#define _XOPEN_SOURCE 700 /* realpath */
#include "base/null.h"
#include "study/parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** A fault of an override is reported at `--set KEY=VALUE`. When the study says so, its place is there. */
static void locate_override(const sph2d_study_results *results, const sph2d_study_run *run, sph2d_diagnostic *d)
{
    for (size_t i = 0; i < run->override_count; ++i) {
        char name[sizeof d->file], path[sizeof d->path];
        snprintf(name, sizeof name, "--set %s=%s", run->overrides[i].path, run->overrides[i].value);
        if (strcmp(name, d->file) != 0)
            continue;
        memcpy(path, d->path, sizeof path);
        snprintf(d->path, sizeof d->path, "%s", run->places[i]);
        sph2d_study_file_locate(results->file, d);
        memcpy(d->path, path, sizeof path);
        return;
    }
}

void sph2d__row_locate(const sph2d_study_results *results, const sph2d_study_run *run, const sph2d_scene_file *scene,
                       sph2d_report *report, size_t first)
{
    for (size_t i = first; report && i < report->count; ++i) {
        sph2d_diagnostic *d = &report->items[i];
        if (scene && d->file[0] == '\0' && d->path[0] != '\0')
            sph2d_scene_file_locate(scene, d);
        locate_override(results, run, d);
    }
}

sph2d_status sph2d_study_run_scene(const sph2d_study_results *results, const sph2d_study_run *run,
                                   sph2d_scene_file **file, sph2d_report *report)
{
    if (!file)
        return sph2d__null(report, __func__, "file");
    *file = NULL;
    if (!results)
        return sph2d__null(report, __func__, "results");
    if (!run)
        return sph2d__null(report, __func__, "run");
    size_t own = run->override_count, count = own + results->override_count, first = report ? report->count : 0;
    sph2d_override *overrides = malloc((count + 1) * sizeof *overrides);
    if (!overrides)
        return SPH2D_NOMEM;
    for (size_t i = 0; i < count; ++i)
        overrides[i] = i < own ? run->overrides[i] : results->overrides[i - own];
    sph2d_status status = sph2d_scene_file_read(results->study->scene, overrides, count, file, report);
    free(overrides);
    if (status == SPH2D_OK && report) /* making the simulation finds the warnings again */
        report->count = first;
    sph2d__row_locate(results, run, NULL, report, first);
    return status;
}

char *sph2d__scene_text(const sph2d_scene *scene)
{
    size_t length = sph2d_scene_text(scene, NULL, 0);
    char *text = length > 0 ? malloc(length + 1) : NULL;
    if (text)
        sph2d_scene_text(scene, text, length + 1);
    return text;
}

/** The file of particles is named from the scene's folder. */
static char *particles_path(const char *scene, const char *file)
{
    const char *slash = strrchr(scene, '/');
    size_t folder = slash && file[0] != '/' ? (size_t)(slash - scene) + 1 : 0;
    size_t size = folder + strlen(file) + 1;
    char *joined = malloc(size), *path = NULL;
    if (joined) {
        snprintf(joined, size, "%.*s%s", (int)folder, scene, file);
        path = realpath(joined, NULL);
    }
    free(joined);
    return path;
}

sph2d_status sph2d_study_run_scene_text(const sph2d_study_results *results, const sph2d_study_run *run, char **text,
                                        sph2d_report *report)
{
    if (!text)
        return sph2d__null(report, __func__, "text");
    *text = NULL;
    sph2d_scene_file *file;
    sph2d_status status = sph2d_study_run_scene(results, run, &file, report);
    if (status != SPH2D_OK)
        return status;
    sph2d_scene moved = *sph2d_scene_file_scene(file);
    char *particles = moved.particles.file ? particles_path(results->study->scene, moved.particles.file) : NULL;
    if (particles)
        moved.particles.file = particles;
    *text = sph2d__scene_text(&moved);
    free(particles);
    sph2d_scene_file_destroy(file);
    return *text ? SPH2D_OK : SPH2D_NOMEM;
}
