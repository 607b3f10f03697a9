/* SPDX-License-Identifier: MIT */
/** @file snapshot.c
 *  Accessors of a snapshot in memory. */
#include "files/snapshot.h"

#include "base/null.h"
#include "files/overrides.h"
#include "files/scene_file.h"

#include <stdlib.h>
#include <string.h>

void sph2d_snapshot_destroy(sph2d_snapshot *snapshot)
{
    if (!snapshot)
        return;
    sph2d__pool_free(&snapshot->pool);
    free(snapshot);
}

sph2d_snapshot_info sph2d_snapshot_get_info(const sph2d_snapshot *snapshot)
{
    if (!snapshot)
        return (sph2d_snapshot_info){0};
    return snapshot->info;
}

sph2d_state sph2d_snapshot_state(const sph2d_snapshot *snapshot)
{
    if (!snapshot)
        return (sph2d_state){0};
    return (sph2d_state){snapshot->state_version, snapshot->arrays, snapshot->array_count};
}

const sph2d_array *sph2d_snapshot_array(const sph2d_snapshot *snapshot, sph2d_group group, const char *name)
{
    if (!snapshot || !name)
        return NULL;
    for (size_t i = 0; i < snapshot->array_count; ++i)
        if (snapshot->arrays[i].group == group && strcmp(snapshot->arrays[i].name, name) == 0)
            return &snapshot->arrays[i];
    return NULL;
}

sph2d_status sph2d_snapshot_scene(const sph2d_snapshot *snapshot, const sph2d_override *more, size_t more_count,
                                  sph2d_scene_file **file, sph2d_report *report)
{
    if (!file)
        return sph2d__null(report, __func__, "file");
    *file = NULL;
    if (!snapshot)
        return sph2d__null(report, __func__, "snapshot");
    if (!sph2d__overrides_given(more, more_count))
        return sph2d__null(report, __func__, "more");
    const char *text = snapshot->info.scene_text;
    if (!text) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_FIELD, NULL,
                         "'%s' is missing: the run was created by a program, not from a scene file",
                         snapshot->scene_source);
        return SPH2D_FORMAT;
    }
    size_t before = snapshot->override_count;
    /* A run that is made longer again and again keeps one run.until, as if it had been given at the start. */
    if (before > 0 && more_count > 0 && strcmp(snapshot->overrides[before - 1].path, more[0].path) == 0)
        --before;
    sph2d_override *all = calloc(before + more_count + 1, sizeof *all);
    if (!all)
        return SPH2D_NOMEM;
    for (size_t i = 0; i < before; ++i)
        all[i] = snapshot->overrides[i];
    for (size_t i = 0; i < more_count; ++i)
        all[before + i] = more[i];
    const sph2d__scene_source source = {.text = text,
                                        .length = strlen(text),
                                        .name = snapshot->scene_source,
                                        .kept = snapshot->paths,
                                        .kept_count = snapshot->path_count};
    sph2d_status status = sph2d__scene_file_parse(&source, all, before + more_count, __func__, file, report);
    free(all);
    return status;
}
