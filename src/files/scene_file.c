/* SPDX-License-Identifier: MIT */
/** @file scene_file.c
 *  Scene files: parse to a tree, apply overrides, convert to structs, check, locate the errors in the text. */
#include "files/scene_file.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/null.h"
#include "files/convert.h"
#include "files/document.h"

struct sph2d_scene_file {
    sph2d__document document;
    sph2d_override *overrides; /**< borrowed until they are copied */
    size_t override_count;
    const sph2d__scene_source *source; /**< while it is parsed */
    sph2d_scene scene;
};

/* ---- errors of the checker --------------------------------------------------------------------------------------- */

/** Names the key that a file has: a shape is a polygon or polyline once it is read from a drawing. */
static void name_drawing(const sph2d__node *root, sph2d_diagnostic *diagnostic)
{
    char *dot = strrchr(diagnostic->path, '.');
    if (!dot || (strcmp(dot, ".polygon") != 0 && strcmp(dot, ".polyline") != 0))
        return;
    *dot = '\0';
    const bool drawn = sph2d__node_find(sph2d__node_at(root, diagnostic->path), "svg", 3);
    *dot = '.';
    if (drawn)
        memcpy(dot, ".svg", sizeof ".svg");
}

void sph2d_scene_file_locate(const sph2d_scene_file *file, sph2d_diagnostic *diagnostic)
{
    if (!file || !diagnostic)
        return;
    name_drawing(file->document.root, diagnostic);
    sph2d__node_locate(file->document.root, diagnostic);
}

/** Whether an error only follows from values that could not be read and were reported. */
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
    if (sph2d__faults_affect(faults, diagnostic->path))
        return true;
    for (size_t i = 0; i < sizeof causes / sizeof causes[0]; ++i)
        if (causes[i].code == diagnostic->code && sph2d__faults_affect(faults, causes[i].depends_on))
            return true;
    return false;
}

/* ---- reading ----------------------------------------------------------------------------------------------------- */

static bool copy_overrides(sph2d_scene_file *file)
{
    sph2d__pool *pool = &file->document.pool;
    const sph2d_override *given = file->overrides;
    file->overrides = sph2d__pool_alloc(pool, file->override_count, sizeof *file->overrides);
    for (size_t i = 0; file->overrides && i < file->override_count; ++i) {
        sph2d_override *copy = &file->overrides[i];
        copy->path = sph2d__pool_text(pool, given[i].path, strlen(given[i].path));
        copy->value = sph2d__pool_text(pool, given[i].value, strlen(given[i].value));
        if (!copy->path || !copy->value)
            return false;
    }
    return file->overrides;
}

/** Files that cannot be opened are faults of the line that names them. */
static void locate_files(const sph2d_scene_file *file, size_t first, sph2d_report *report)
{
    for (size_t k = first; report && k < report->count; ++k)
        if (report->items[k].file[0] == '\0')
            sph2d_scene_file_locate(file, &report->items[k]);
}

/** Reads the files that the scene names, or takes what was kept of them. */
static sph2d_status read_files(sph2d_scene_file *file, sph2d__faults *faults)
{
    sph2d_scene *scene = &file->scene;
    const char *from = file->document.source.name;
    sph2d__pool *pool = &file->document.pool;
    if (faults->errors > 0) {
        sph2d__tables_skip(scene, faults);
        return SPH2D_OK;
    }
    if (!file->source->with_files) {
        const sph2d_scene *kept = file->source->kept;
        if (kept)
            sph2d__starts_keep(scene, kept);
        return kept ? sph2d__tables_keep(scene, kept, pool) : SPH2D_OK;
    }
    size_t first = faults->report ? faults->report->count : 0;
    sph2d_status status = sph2d__tables_read(scene, from, pool, faults->report);
    if (status == SPH2D_OK)
        status = sph2d__starts_read(scene, from, pool, faults->report);
    locate_files(file, first, faults->report);
    faults->errors += status != SPH2D_OK;
    return status;
}

static sph2d_status read_scene(void *owner, sph2d__faults *faults)
{
    sph2d_scene_file *file = owner;
    sph2d__node *root = file->document.root;
    const sph2d_keys *keys = sph2d_scene_keys();
    if (!copy_overrides(file))
        return SPH2D_NOMEM;
    sph2d__convert_words(root, keys, faults);
    sph2d_status status = sph2d__overrides_apply(file->overrides, file->override_count, root, faults);
    if (status != SPH2D_OK)
        return status;
    keys->set_default(&file->scene);
    sph2d__converter converter = {&file->document.pool, faults, sph2d_scene_keys()};
    sph2d__convert_mapping(&converter, keys, root, "", &file->scene);
    if (faults->short_of_memory)
        return SPH2D_NOMEM;
    status = read_files(file, faults);
    if (status != SPH2D_OK)
        return status;
    sph2d_report found = {0};
    sph2d_scene_check(&file->scene, &found);
    for (size_t i = 0; i < found.count; ++i)
        name_drawing(root, &found.items[i]);
    sph2d__document_pass(&file->document, &found, faults, is_consequence);
    return faults->errors > 0 ? SPH2D_SCENE : SPH2D_OK;
}

sph2d_status sph2d__scene_file_parse(const sph2d__scene_source *source, const sph2d_override *overrides,
                                     size_t override_count, const char *function, sph2d_scene_file **file,
                                     sph2d_report *report)
{
    static const sph2d__document_kind kind = {
        "scene", "a scene is a list of `key: value` lines; domain, spacing and blocks are a start", read_scene};
    if (!file)
        return sph2d__null(report, function, "file");
    *file = NULL;
    if (!source->text && source->length > 0)
        return sph2d__null(report, function, "text");
    if (!source->name)
        return sph2d__null(report, function, "name");
    if (!sph2d__overrides_given(overrides, override_count))
        return sph2d__null(report, function, "overrides");
    sph2d_scene_file *f = calloc(1, sizeof *f);
    if (!f)
        return SPH2D_NOMEM;
    f->overrides = (sph2d_override *)(uintptr_t)overrides;
    f->override_count = override_count;
    f->source = source;
    sph2d_status status =
        sph2d__document_parse(&f->document, &kind, source->text, source->length, source->name, f, report);
    f->source = NULL;
    if (status == SPH2D_OK)
        *file = f;
    else
        sph2d_scene_file_destroy(f);
    return status;
}

sph2d_status sph2d_scene_file_parse(const char *text, size_t length, const char *name, const sph2d_override *overrides,
                                    size_t override_count, sph2d_scene_file **file, sph2d_report *report)
{
    const sph2d__scene_source source = {.text = text, .length = length, .name = name};
    return sph2d__scene_file_parse(&source, overrides, override_count, __func__, file, report);
}

/** Parses what was read of a file (`status`), with the files that it names, and frees the text. */
static sph2d_status parse_read(sph2d_status status, char *text, size_t length, const char *name,
                               const sph2d_override *overrides, size_t override_count, const char *function,
                               sph2d_scene_file **file, sph2d_report *report)
{
    const sph2d__scene_source source = {.text = text, .length = length, .name = name, .with_files = true};
    if (status == SPH2D_OK)
        status = sph2d__scene_file_parse(&source, overrides, override_count, function, file, report);
    free(text);
    return status;
}

sph2d_status sph2d_scene_file_read(const char *path, const sph2d_override *overrides, size_t override_count,
                                   sph2d_scene_file **file, sph2d_report *report)
{
    if (!file)
        return sph2d__null(report, __func__, "file");
    *file = NULL;
    if (!path)
        return sph2d__null(report, __func__, "path");
    char *text;
    size_t length;
    sph2d_status status = sph2d__document_text(path, &text, &length, report);
    return parse_read(status, text, length, path, overrides, override_count, __func__, file, report);
}

sph2d_status sph2d_scene_file_read_open(int descriptor, const char *name, const sph2d_override *overrides,
                                        size_t override_count, sph2d_scene_file **file, sph2d_report *report)
{
    if (!file)
        return sph2d__null(report, __func__, "file");
    *file = NULL;
    if (!name)
        return sph2d__null(report, __func__, "name");
    char *text;
    size_t length;
    sph2d_status status = sph2d__document_text_open(descriptor, name, &text, &length, report);
    return parse_read(status, text, length, name, overrides, override_count, __func__, file, report);
}

void sph2d_scene_file_destroy(sph2d_scene_file *file)
{
    if (!file)
        return;
    sph2d__pool_free(&file->document.pool);
    free(file);
}

/* ---- accessors --------------------------------------------------------------------------------------------------- */

const sph2d_scene *sph2d_scene_file_scene(const sph2d_scene_file *file)
{
    if (!file)
        return NULL;
    return &file->scene;
}

const char *sph2d_scene_file_text(const sph2d_scene_file *file)
{
    if (!file)
        return NULL;
    return file->document.source.text;
}

const sph2d_override *sph2d_scene_file_overrides(const sph2d_scene_file *file, size_t *count)
{
    if (count)
        *count = file ? file->override_count : 0;
    return file ? file->overrides : NULL;
}
