/* SPDX-License-Identifier: MIT */
/** @file scene_file.c
 *  Scene files: text to tree, overrides into it, tree to structs, structs to the checker, its faults back to places. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/c_locale.h"
#include "files/convert.h"
#include "files/overrides.h"
#include "files/particles_file.h"
#include "files/text.h"
#include "files/yaml.h"
#include "sph2d/io.h"

enum { MOST_BYTES = 64 << 20 };

struct sph2d_scene_file {
    sph2d__pool pool;
    sph2d__source source;
    sph2d_override *overrides;
    size_t override_count;
    sph2d__node *root;
    sph2d_scene scene;
};

/* ---- faults of the checker --------------------------------------------------------------------------------------- */

void sph2d_scene_file_locate(const sph2d_scene_file *file, sph2d_diagnostic *diagnostic)
{
    if (file && diagnostic)
        sph2d__node_locate(file->root, diagnostic);
}

/** Whether a fault only follows from values that could not be read and were reported. */
static bool is_consequence(const sph2d_diagnostic *diagnostic, const sph2d__faults *faults)
{
    static const struct {
        sph2d_code code;
        const char *depends_on;
    } causes[] = {
        {SPH2D_CODE_OUTSIDE, "domain"},       {SPH2D_CODE_OUTSIDE, "spacing"},  {SPH2D_CODE_NO_PARTICLES, "blocks"},
        {SPH2D_CODE_NO_PARTICLES, "sources"}, {SPH2D_CODE_TOO_MANY, "spacing"}, {SPH2D_CODE_TOO_MANY, "domain"},
        {SPH2D_CODE_UNSUPPORTED, "method"},   {SPH2D_CODE_OVERLAP, "spacing"},
    };
    if (sph2d__faults_touch(faults, diagnostic->path))
        return true;
    for (size_t i = 0; i < sizeof causes / sizeof causes[0]; ++i)
        if (causes[i].code == diagnostic->code && sph2d__faults_touch(faults, causes[i].depends_on))
            return true;
    return false;
}

/** Passes on what the checker found, unless it is a consequence, with its place. */
static void pass_on(sph2d_scene_file *file, const sph2d_diagnostic *found, sph2d__faults *faults)
{
    if (found->severity == SPH2D_ERROR && is_consequence(found, faults))
        return;
    faults->errors += found->severity == SPH2D_ERROR;
    sph2d_diagnostic *copy = sph2d_report_add(faults->report, found->severity, found->code, NULL, "%s", found->message);
    if (copy) {
        *copy = *found;
        sph2d_scene_file_locate(file, copy);
    }
}

static void check(sph2d_scene_file *file, sph2d__faults *faults)
{
    sph2d_report found = {0};
    sph2d_scene_check(&file->scene, &found);
    size_t without_room = found.errors;
    bool sound = faults->errors + found.errors == 0; /* warnings about a scene that has faults may be wrong */
    for (size_t i = 0; i < found.count; ++i) {
        bool is_error = found.items[i].severity == SPH2D_ERROR;
        without_room -= is_error;
        if (is_error || sound)
            pass_on(file, &found.items[i], faults);
    }
    faults->errors += without_room;
    if (faults->report) {
        faults->report->dropped += found.dropped;
        faults->report->errors += without_room;
    }
}

/* ---- reading ----------------------------------------------------------------------------------------------------- */

static sph2d_status copy_overrides(sph2d_scene_file *file, const sph2d_override *overrides, size_t count)
{
    file->overrides = sph2d__pool_alloc(&file->pool, count, sizeof *file->overrides);
    if (!file->overrides)
        return SPH2D_NOMEM;
    for (size_t i = 0; i < count; ++i) {
        sph2d_override *copy = &file->overrides[i];
        copy->path = sph2d__pool_text(&file->pool, overrides[i].path, strlen(overrides[i].path));
        copy->value = sph2d__pool_text(&file->pool, overrides[i].value, strlen(overrides[i].value));
        if (!copy->path || !copy->value)
            return SPH2D_NOMEM;
    }
    file->override_count = count;
    return SPH2D_OK;
}

/** Whether the text holds a mapping; a fault otherwise. */
static bool has_keys(const sph2d_scene_file *file, sph2d__faults *faults)
{
    const sph2d__node *root = file->root;
    if (root && root->kind == SPH2D__NODE_MAPPING)
        return true;
    if (faults->errors > 0) /* anchors and the like say enough */
        return false;
    sph2d_diagnostic *d;
    if (!root || sph2d__node_is_null(root)) {
        d = sph2d__fault(faults, SPH2D_CODE_SYNTAX, (sph2d__place){&file->source, SPH2D__NOWHERE}, NULL,
                         "there is no scene in this file: it is empty");
    } else {
        char got[80];
        d = sph2d__fault(faults, SPH2D_CODE_SYNTAX, root->place, NULL, "expected the keys of a scene, got %s",
                         sph2d__node_words(root, got, sizeof got));
    }
    sph2d_diagnostic_hint(d, "a scene is a list of `key: value` lines; domain, spacing and blocks are a start");
    return false;
}

/** Reads the particles' file where the scene names one. */
static sph2d_status read_particles(sph2d_scene_file *file, sph2d__faults *faults)
{
    if (!file->scene.particles.file || faults->errors > 0)
        return SPH2D_OK;
    sph2d_status status = sph2d__particles_read(&file->scene, file->source.name, &file->pool, faults->report);
    faults->errors += status != SPH2D_OK;
    return status;
}

static sph2d_status read_scene(sph2d_scene_file *file, bool with_files, sph2d__faults *faults)
{
    sph2d_status status = sph2d__yaml_parse(&file->source, faults, &file->root);
    if (status != SPH2D_OK)
        return status;
    if (!has_keys(file, faults))
        return SPH2D_SCENE;
    sph2d__convert_words(file->root, sph2d_scene_keys(), faults);
    status = sph2d__overrides_apply(file->overrides, file->override_count, file->root, faults);
    if (status != SPH2D_OK)
        return status;
    const sph2d_keys *keys = sph2d_scene_keys();
    keys->set_default(&file->scene);
    sph2d__converter converter = {&file->pool, faults};
    sph2d__convert_mapping(&converter, keys, file->root, "", &file->scene);
    if (faults->short_of_memory)
        return SPH2D_NOMEM;
    if (with_files)
        status = read_particles(file, faults);
    if (status != SPH2D_OK)
        return status;
    check(file, faults);
    return faults->errors > 0 ? SPH2D_SCENE : SPH2D_OK;
}

/** As sph2d_scene_file_parse(), with or without the files that the scene names. */
static sph2d_status parse(const char *text, size_t length, const char *name, const sph2d_override *overrides,
                          size_t override_count, bool with_files, sph2d_scene_file **file, sph2d_report *report)
{
    if (!file)
        return SPH2D_INVALID;
    *file = NULL;
    if ((!text && length > 0) || !name || (!overrides && override_count > 0))
        return SPH2D_INVALID;
    sph2d_scene_file *f = calloc(1, sizeof *f);
    if (!f)
        return SPH2D_NOMEM;
    f->source = (sph2d__source){.name = sph2d__pool_text(&f->pool, name, strlen(name)),
                                .text = sph2d__pool_text(&f->pool, text, length),
                                .length = length,
                                .has_lines = true};
    sph2d__c_locale locale;
    sph2d_status status = SPH2D_NOMEM;
    if (f->source.name && f->source.text && sph2d__c_locale_begin(&locale)) {
        sph2d__faults faults = {.report = report, .pool = &f->pool};
        size_t first = report ? report->count : 0;
        status = copy_overrides(f, overrides, override_count);
        if (status == SPH2D_OK)
            status = read_scene(f, with_files, &faults);
        sph2d__faults_sort(report, first);
        sph2d__c_locale_end(&locale);
    }
    if (status == SPH2D_OK)
        *file = f;
    else
        sph2d_scene_file_destroy(f);
    return status;
}

sph2d_status sph2d_scene_file_parse(const char *text, size_t length, const char *name, const sph2d_override *overrides,
                                    size_t override_count, sph2d_scene_file **file, sph2d_report *report)
{
    return parse(text, length, name, overrides, override_count, false, file, report);
}

sph2d_status sph2d_scene_file_read(const char *path, const sph2d_override *overrides, size_t override_count,
                                   sph2d_scene_file **file, sph2d_report *report)
{
    if (!file)
        return SPH2D_INVALID;
    *file = NULL;
    if (!path)
        return SPH2D_INVALID;
    char *text;
    size_t length;
    sph2d_status status = sph2d__text_read(path, MOST_BYTES, &text, &length, report);
    if (status == SPH2D_OK)
        status = parse(text, length, path, overrides, override_count, true, file, report);
    free(text);
    return status;
}

void sph2d_scene_file_destroy(sph2d_scene_file *file)
{
    if (!file)
        return;
    sph2d__pool_free(&file->pool);
    free(file);
}

/* ---- what is in it ----------------------------------------------------------------------------------------------- */

const sph2d_scene *sph2d_scene_file_scene(const sph2d_scene_file *file)
{
    return &file->scene;
}

const char *sph2d_scene_file_text(const sph2d_scene_file *file)
{
    return file->source.text;
}

const sph2d_override *sph2d_scene_file_overrides(const sph2d_scene_file *file, size_t *count)
{
    *count = file->override_count;
    return file->overrides;
}
