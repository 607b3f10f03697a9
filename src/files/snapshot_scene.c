/* SPDX-License-Identifier: MIT */
/** @file snapshot_scene.c
 *  Reads the scene of a snapshot again. Apart from the snapshot's other functions, since a scene may begin with one. */
#include <stdlib.h>
#include <string.h>

#include "base/null.h"
#include "files/document.h"
#include "files/scene_file.h"
#include "files/snapshot.h"

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
    const sph2d__scene_source source = {
        .text = text, .length = strlen(text), .name = snapshot->scene_source, .kept = &snapshot->scene};
    sph2d_status status = sph2d__scene_file_parse(&source, all, before + more_count, __func__, file, report);
    free(all);
    return status;
}
