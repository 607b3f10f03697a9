/* SPDX-License-Identifier: MIT */
/** @file study_file.c
 *  Study files: text to tree, tree to structs, paths joined with the file's folder. */
#include <stdlib.h>
#include <string.h>

#include "base/null.h"
#include "files/convert.h"
#include "files/study_file.h"

struct sph2d_study_file {
    sph2d__document document;
    sph2d_study study;
};

void sph2d_study_file_locate(const sph2d_study_file *file, sph2d_diagnostic *diagnostic)
{
    if (file && diagnostic)
        sph2d__node_locate(file->document.root, diagnostic);
}

/* ---- names and paths --------------------------------------------------------------------------------------------- */

/** A copy that fits on one line of any terminal; NULL when memory is short. */
static const char *clean_name(sph2d_study_file *file, const char *name)
{
    char *copy = name ? sph2d__pool_text(&file->document.pool, name, strlen(name)) : NULL;
    if (copy)
        sph2d__text_clean(copy);
    return copy;
}

/** Completes what was read. The lists are the pool's, so that they may be written to. False when memory is short. */
static bool complete(sph2d_study_file *file)
{
    sph2d_study *study = &file->study;
    study->scene = sph2d__pool_join(&file->document.pool, file->document.source.name, study->scene);
    sph2d_study_measure *measures = sph2d__pool_alloc(&file->document.pool, study->measure_count, sizeof *measures);
    if (!measures)
        return false;
    bool fine = study->scene;
    for (size_t i = 0; i < study->measure_count; ++i) {
        measures[i] = study->measures[i];
        measures[i].name = clean_name(file, measures[i].name);
        if (measures[i].expectation == SPH2D_EXPECT_REFERENCE)
            measures[i].reference.file =
                sph2d__pool_join(&file->document.pool, file->document.source.name, measures[i].reference.file);
        fine = fine && measures[i].name &&
               (measures[i].expectation != SPH2D_EXPECT_REFERENCE || measures[i].reference.file);
    }
    study->measures = measures;
    if (study->judge) /* as the names that it is compared with */
        study->judge = clean_name(file, study->judge);
    return fine && sph2d__study_rows_make(study, file->document.root, &file->document.pool);
}

/* ---- reading ----------------------------------------------------------------------------------------------------- */

static sph2d_status read_study(void *owner, sph2d__faults *faults)
{
    sph2d_study_file *file = owner;
    sph2d__converter converter = {&file->document.pool, faults, sph2d_study_keys()};
    sph2d_study_keys()->set_default(&file->study);
    sph2d__convert_mapping(&converter, sph2d_study_keys(), file->document.root, "", &file->study);
    sph2d__study_target(&file->study);
    if (!faults->short_of_memory)
        sph2d__study_check(&file->study, &file->document, faults);
    if (faults->short_of_memory)
        return SPH2D_NOMEM;
    if (faults->errors > 0)
        return SPH2D_SCENE;
    return complete(file) ? SPH2D_OK : SPH2D_NOMEM;
}

sph2d_status sph2d_study_file_parse(const char *text, size_t length, const char *name, sph2d_study_file **file,
                                    sph2d_report *report)
{
    static const sph2d__document_kind kind = {
        "study", "a study is a list of `key: value` lines: scene, runs and measures", read_study};
    if (!file)
        return sph2d__null(report, __func__, "file");
    *file = NULL;
    if (!text && length > 0)
        return sph2d__null(report, __func__, "text");
    if (!name)
        return sph2d__null(report, __func__, "name");
    sph2d_study_file *f = calloc(1, sizeof *f);
    if (!f)
        return SPH2D_NOMEM;
    sph2d_status status = sph2d__document_parse(&f->document, &kind, text, length, name, f, report);
    if (status == SPH2D_OK)
        *file = f;
    else
        sph2d_study_file_destroy(f);
    return status;
}

sph2d_status sph2d_study_file_read(const char *path, sph2d_study_file **file, sph2d_report *report)
{
    if (!file)
        return sph2d__null(report, __func__, "file");
    *file = NULL;
    if (!path)
        return sph2d__null(report, __func__, "path");
    char *text;
    size_t length;
    sph2d_status status = sph2d__document_text(path, &text, &length, report);
    if (status == SPH2D_OK)
        status = sph2d_study_file_parse(text, length, path, file, report);
    free(text);
    return status;
}

void sph2d_study_file_destroy(sph2d_study_file *file)
{
    if (!file)
        return;
    sph2d__pool_free(&file->document.pool);
    free(file);
}

const sph2d_study *sph2d_study_file_study(const sph2d_study_file *file)
{
    if (!file)
        return NULL;
    return &file->study;
}
