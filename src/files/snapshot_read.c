/* SPDX-License-Identifier: MIT */
/** @file snapshot_read.c
 *  Reads a snapshot into memory: first format and version, then everything in it, reporting all errors. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/null.h"
#include "files/snapshot.h"

/** Whether none of the groups is elsewhere. */
static bool groups_are_here(sph2d__h5_reader *r)
{
    static const char *const groups[] = {SPH2D__GROUP_HEADER, SPH2D__GROUP_CODE,    SPH2D__GROUP_PARAMETERS,
                                         SPH2D__GROUP_SCENE,  SPH2D__GROUP_FLUID,   SPH2D__GROUP_WALLS,
                                         SPH2D__GROUP_STATE,  SPH2D__GROUP_OUTLINES};
    bool here = true;
    for (size_t i = 0; i < sizeof groups / sizeof *groups; ++i)
        here = sph2d__h5_check_group(r, groups[i]) && here;
    return here;
}

/** Whether this is a complete snapshot of a supported version. */
static bool is_readable(sph2d__h5_reader *r, sph2d_snapshot *s)
{
    if (!sph2d__h5_has(r, "/", SPH2D__AT_FORMAT)) {
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_KIND, "this is an HDF5 file, but not a snapshot of sph2d");
        return false;
    }
    const char *format = sph2d__h5_get_text(r, "/", SPH2D__AT_FORMAT);
    if (format && strcmp(format, SPH2D__FORMAT) != 0)
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_KIND, "this is not a snapshot of sph2d, but '%.60s'", format);
    uint64_t version = 0, complete = 0;
    if (!sph2d__h5_has(r, "/", SPH2D__AT_COMPLETE) || !sph2d__h5_get_counts(r, "/", SPH2D__AT_COMPLETE, &complete, 1) ||
        complete != 1)
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_INCOMPLETE, "the file was not written completely");
    else if (sph2d__h5_get_counts(r, "/", SPH2D__AT_FORMAT_VERSION, &version, 1) &&
             sph2d__h5_get_counts(r, SPH2D__GROUP_STATE, SPH2D__AT_STATE_VERSION, &s->state_version, 1) &&
             (version != SPH2D__FORMAT_VERSION || s->state_version != SPH2D_STATE_VERSION)) {
        sph2d_diagnostic *d =
            sph2d__h5_refuse(r, SPH2D_CODE_FILE_VERSION, "the file has version %llu.%llu, this program reads %u.%u",
                             (unsigned long long)version, (unsigned long long)s->state_version, SPH2D__FORMAT_VERSION,
                             SPH2D_STATE_VERSION);
        const char *code = sph2d__h5_has(r, SPH2D__GROUP_CODE, SPH2D__AT_CODE_VERSION)
                               ? sph2d__h5_get_text(r, SPH2D__GROUP_CODE, SPH2D__AT_CODE_VERSION)
                               : NULL;
        if (code)
            sph2d_diagnostic_hint(d, "it was written by sph2d %.40s, this is %s", code, sph2d_version());
    }
    return r->status == SPH2D_OK;
}

static void read_metadata(sph2d__h5_reader *r, sph2d_snapshot *s)
{
    sph2d_snapshot_info *info = &s->info;
    const sph2d_scene *scene = &s->scene;
    sph2d__snapshot_get_parameters(r, &s->scene);
    info->scene_name = scene->name;
    info->domain = scene->domain;
    info->boundary = scene->boundary;
    info->spacing = scene->spacing;
    info->frames = scene->run.frames;
    info->method = sph2d__h5_get_text(r, SPH2D__GROUP_PARAMETERS, "method.name");
    info->code_version = sph2d__h5_get_text(r, SPH2D__GROUP_CODE, SPH2D__AT_CODE_VERSION);
    info->isa = sph2d__h5_get_text(r, SPH2D__GROUP_CODE, SPH2D__AT_ISA);
    sph2d__h5_get_counts(r, SPH2D__GROUP_HEADER, SPH2D__AT_STEP, &info->steps, 1);
    sph2d__h5_get_reals(r, SPH2D__GROUP_HEADER, SPH2D__AT_TIME, &info->time, 1);
    sph2d__h5_get_reals(r, SPH2D__GROUP_HEADER, SPH2D__AT_TIME_STEP, &info->time_step, 1);
    sph2d__h5_get_reals(r, SPH2D__GROUP_HEADER, SPH2D__AT_SUPPORT, &info->support_radius, 1);
    sph2d__h5_get_reals(r, SPH2D__GROUP_HEADER, SPH2D__AT_SOUND_SPEED, &info->sound_speed, 1);
    if (!isfinite(info->time) || !isfinite(info->time_step) || !isfinite(info->support_radius) ||
        !isfinite(info->sound_speed))
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%s' has values that are not finite", SPH2D__GROUP_HEADER);
}

static void read_scene(sph2d__h5_reader *r, sph2d_snapshot *s)
{
    if (!sph2d__h5_has(r, SPH2D__GROUP_SCENE, SPH2D__SCENE_TEXT))
        return;
    s->info.scene_text = sph2d__h5_get_text(r, SPH2D__GROUP_SCENE, SPH2D__SCENE_TEXT);
    if (!sph2d__h5_has(r, SPH2D__GROUP_SCENE, SPH2D__SCENE_PATHS))
        return;
    size_t paths = 0, values = 0;
    const char **path = sph2d__h5_get_texts(r, SPH2D__GROUP_SCENE, SPH2D__SCENE_PATHS, &paths);
    const char **value = sph2d__h5_get_texts(r, SPH2D__GROUP_SCENE, SPH2D__SCENE_VALUES, &values);
    if (!path || !value)
        return;
    if (paths != values) {
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%s' has the wrong shape", SPH2D__SCENE_VALUES);
        return;
    }
    s->overrides = sph2d__pool_alloc(&s->pool, paths + 1, sizeof *s->overrides);
    if (!s->overrides) {
        r->status = SPH2D_NOMEM;
        return;
    }
    for (size_t i = 0; i < paths; ++i)
        s->overrides[i] = (sph2d_override){path[i], value[i]};
    s->override_count = paths;
}

static sph2d_status read_snapshot(const char *path, bool checked, sph2d_snapshot **snapshot, sph2d_report *report)
{
    if (!snapshot)
        return sph2d__null(report, __func__, "snapshot");
    *snapshot = NULL;
    if (!path)
        return sph2d__null(report, __func__, "path");
    sph2d_snapshot *s = calloc(1, sizeof *s);
    if (!s)
        return SPH2D_NOMEM;
    sph2d__h5_scope scope;
    sph2d__h5_reader r;
    if (!sph2d__h5_scope_begin(&scope)) {
        free(s);
        return SPH2D_NOMEM;
    }
    sph2d__h5_reader_open(&r, path, checked, &s->pool, report);
    if (r.status == SPH2D_OK && groups_are_here(&r) && is_readable(&r, s)) {
        read_metadata(&r, s);
        read_scene(&r, s);
        sph2d__snapshot_get_given(&r, &s->scene);
        sph2d__snapshot_get_arrays(&r, s);
    }
    sph2d__h5_reader_close(&r);
    sph2d__h5_scope_end(&scope);
    size_t size = strlen(path) + sizeof SPH2D__GROUP_SCENE "/" SPH2D__SCENE_TEXT;
    char *source = sph2d__pool_alloc(&s->pool, size, 1);
    if (!source && r.status == SPH2D_OK)
        r.status = SPH2D_NOMEM;
    if (r.status != SPH2D_OK) {
        sph2d_snapshot_destroy(s);
        return r.status;
    }
    snprintf(source, size, "%s%s/%s", path, SPH2D__GROUP_SCENE, SPH2D__SCENE_TEXT);
    s->scene_source = source;
    *snapshot = s;
    return SPH2D_OK;
}

sph2d_status sph2d_snapshot_read(const char *path, sph2d_snapshot **snapshot, sph2d_report *report)
{
    return read_snapshot(path, true, snapshot, report);
}

sph2d_status sph2d_snapshot_read_unchecked(const char *path, sph2d_snapshot **snapshot, sph2d_report *report)
{
    return read_snapshot(path, false, snapshot, report);
}
