/* SPDX-License-Identifier: MIT */
/** @file study_file.c
 *  Study files: text to tree, tree to structs, paths joined with the file's folder. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/c_locale.h"
#include "files/convert.h"
#include "files/study_check.h"
#include "files/study_rows.h"
#include "files/text.h"
#include "files/yaml.h"

enum { MOST_BYTES = 64 << 20 };

struct sph2d_study_file {
    sph2d__pool pool;
    sph2d__source source;
    sph2d__node *root;
    sph2d_study study;
};

void sph2d_study_file_locate(const sph2d_study_file *file, sph2d_diagnostic *diagnostic)
{
    if (file && diagnostic)
        sph2d__node_locate(file->root, diagnostic);
}

/* ---- names and paths --------------------------------------------------------------------------------------------- */

/** A copy that fits on one line of any terminal; NULL when memory is short. */
static const char *clean_name(sph2d_study_file *file, const char *name)
{
    char *copy = name ? sph2d__pool_text(&file->pool, name, strlen(name)) : NULL;
    if (copy)
        sph2d__text_clean(copy);
    return copy;
}

/** Completes what was read. The lists are the pool's, so that they may be written to. False when memory is short. */
static bool complete(sph2d_study_file *file)
{
    sph2d_study *study = &file->study;
    study->scene = sph2d__pool_join(&file->pool, file->source.name, study->scene);
    sph2d_study_measure *measures = sph2d__pool_alloc(&file->pool, study->measure_count, sizeof *measures);
    if (!measures)
        return false;
    bool fine = study->scene != NULL;
    for (size_t i = 0; i < study->measure_count; ++i) {
        measures[i] = study->measures[i];
        measures[i].name = clean_name(file, measures[i].name);
        if (measures[i].expectation == SPH2D_EXPECT_REFERENCE)
            measures[i].reference.file = sph2d__pool_join(&file->pool, file->source.name, measures[i].reference.file);
        fine = fine && measures[i].name &&
               (measures[i].expectation != SPH2D_EXPECT_REFERENCE || measures[i].reference.file);
    }
    study->measures = measures;
    if (study->judge) /* as the names that it is compared with */
        study->judge = clean_name(file, study->judge);
    return fine && sph2d__study_rows_make(study, file->root, &file->pool);
}

/* ---- reading ----------------------------------------------------------------------------------------------------- */

/** Whether the text holds a mapping; a fault otherwise. */
static bool has_keys(const sph2d_study_file *file, sph2d__faults *faults)
{
    const sph2d__node *root = file->root;
    if (root && root->kind == SPH2D__NODE_MAPPING)
        return true;
    if (faults->errors > 0)
        return false;
    sph2d_diagnostic *d;
    if (!root || sph2d__node_is_null(root)) {
        sph2d__place whole = {&file->source, SPH2D__NOWHERE};
        d = sph2d__fault(faults, SPH2D_CODE_SYNTAX, whole, NULL, "there is no study in this file: it is empty");
    } else {
        char got[80];
        d = sph2d__fault(faults, SPH2D_CODE_SYNTAX, root->place, NULL, "expected the keys of a study, got %s",
                         sph2d__node_words(root, got, sizeof got));
    }
    sph2d_diagnostic_hint(d, "a study is a list of `key: value` lines: scene, runs and measures");
    return false;
}

static sph2d_status read_study(sph2d_study_file *file, sph2d__faults *faults)
{
    sph2d_status status = sph2d__yaml_parse(&file->source, faults, &file->root);
    if (status != SPH2D_OK)
        return status;
    if (!has_keys(file, faults))
        return SPH2D_SCENE;
    sph2d__converter converter = {&file->pool, faults};
    sph2d_study_keys()->set_default(&file->study);
    sph2d__convert_mapping(&converter, sph2d_study_keys(), file->root, "", &file->study);
    sph2d__study_target(&file->study);
    if (!faults->short_of_memory)
        sph2d__study_check(&file->study, file->root, faults);
    if (faults->short_of_memory)
        return SPH2D_NOMEM;
    if (faults->errors > 0)
        return SPH2D_SCENE;
    return complete(file) ? SPH2D_OK : SPH2D_NOMEM;
}

sph2d_status sph2d_study_file_parse(const char *text, size_t length, const char *name, sph2d_study_file **file,
                                    sph2d_report *report)
{
    if (!file)
        return SPH2D_INVALID;
    *file = NULL;
    if ((!text && length > 0) || !name)
        return SPH2D_INVALID;
    sph2d_study_file *f = calloc(1, sizeof *f);
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
        status = read_study(f, &faults);
        sph2d__faults_sort(report, first);
        sph2d__c_locale_end(&locale);
    }
    if (status == SPH2D_OK)
        *file = f;
    else
        sph2d_study_file_destroy(f);
    return status;
}

sph2d_status sph2d_study_file_read(const char *path, sph2d_study_file **file, sph2d_report *report)
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
        status = sph2d_study_file_parse(text, length, path, file, report);
    free(text);
    return status;
}

void sph2d_study_file_destroy(sph2d_study_file *file)
{
    if (!file)
        return;
    sph2d__pool_free(&file->pool);
    free(file);
}

const sph2d_study *sph2d_study_file_study(const sph2d_study_file *file)
{
    return &file->study;
}
