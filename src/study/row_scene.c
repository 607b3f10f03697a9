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

/** A file that the scene names from its own folder, by its whole path; NULL if there is none. The caller frees it. */
static char *whole_path(const char *scene, const char *file)
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

/** The files that a scene still names once it is read: of particles, and of the starts of blocks and the scene. */
static size_t files_of(sph2d_scene *scene, sph2d_block *blocks, const char **files[])
{
    size_t count = 0;
    files[count++] = &scene->particles.file;
    files[count++] = &scene->start.table.file;
    files[count++] = &scene->start.snapshot.file;
    for (size_t i = 0; i < scene->block_count; ++i) {
        files[count++] = &blocks[i].start.table.file;
        files[count++] = &blocks[i].start.snapshot.file;
    }
    return count;
}

/** The text of a scene that is moved to another folder: it names files by their whole paths. NULL when memory is short. */
static char *text_elsewhere(const char *from, const sph2d_scene *scene)
{
    sph2d_scene moved = *scene;
    sph2d_block *blocks = calloc(scene->block_count + 1, sizeof *blocks);
    const char ***files = calloc(2 * scene->block_count + 3, sizeof *files);
    char **paths = calloc(2 * scene->block_count + 3, sizeof *paths), *text = NULL;
    size_t count = 0;
    if (blocks && files && paths) {
        if (scene->block_count > 0)
            memcpy(blocks, scene->blocks, scene->block_count * sizeof *blocks);
        moved.blocks = blocks;
        count = files_of(&moved, blocks, files);
        for (size_t k = 0; k < count && files[k]; ++k) {
            paths[k] = *files[k] ? whole_path(from, *files[k]) : NULL;
            *files[k] = paths[k] ? paths[k] : *files[k];
        }
        text = sph2d__scene_text(&moved);
    }
    for (size_t k = 0; k < count; ++k)
        free(paths[k]);
    free(paths);
    free(files);
    free(blocks);
    return text;
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
    *text = text_elsewhere(results->study->scene, sph2d_scene_file_scene(file));
    sph2d_scene_file_destroy(file);
    return *text ? SPH2D_OK : SPH2D_NOMEM;
}
