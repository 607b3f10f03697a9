/* SPDX-License-Identifier: MIT */
/** @file results.c
 *  Prepares a study from its file: references, checks, rows. */
#include <stdlib.h>

#include "base/null.h"
#include "study/curve.h"
#include "study/parts.h"

/** Reads all references, so that all errors are reported at once. */
static sph2d_status make_references(sph2d_study_results *results, sph2d_report *report)
{
    const sph2d_study *study = results->study;
    sph2d_status status = SPH2D_OK;
    results->references = calloc(study->measure_count + 1, sizeof *results->references);
    if (!results->references)
        return SPH2D_NOMEM;
    for (size_t i = 0; i < study->measure_count; ++i) {
        sph2d_status read = sph2d__reference_make(&results->references[i], &study->measures[i], report);
        status = status == SPH2D_OK ? read : status;
    }
    return status;
}

static bool is_wanted(const sph2d_study_run *run, bool all)
{
    return !run->skip || all;
}

/** Checks the scene of each row, and that of each refinement of the first. */
static sph2d_status check_rows(const sph2d_study_results *results, bool all, sph2d_report *report)
{
    const sph2d_study *study = results->study;
    sph2d_status status = SPH2D_OK;
    for (size_t i = 0; i < study->run_count && status == SPH2D_OK; ++i)
        status = sph2d__row_check(results, &study->runs[i], is_wanted(&study->runs[i], all), report);
    for (size_t i = 0; i < study->refinement_count && status == SPH2D_OK; ++i) {
        sph2d_study_row row;
        status = SPH2D_NOMEM;
        if (sph2d__refine_row(&row, &study->runs[0], &study->refinements[i], 0))
            status = sph2d__row_check(results, &row.run, false, report);
        sph2d__row_free(&row);
    }
    return status;
}

/** Makes a row for each run, with space for its values, so that a long study does not fail at its end. */
static sph2d_status make_rows(sph2d_study_results *results, bool all)
{
    const sph2d_study *study = results->study;
    results->rows = calloc(study->run_count, sizeof *results->rows);
    for (size_t i = 0; results->rows && i < study->run_count; ++i) {
        sph2d_study_row *row = &results->rows[results->row_count++];
        row->number = i + 1;
        row->run = study->runs[i];
        row->wanted = is_wanted(&row->run, all);
        row->values = malloc((study->measure_count + 1) * sizeof *row->values);
        if (!row->values)
            return SPH2D_NOMEM;
    }
    return results->rows ? SPH2D_OK : SPH2D_NOMEM;
}

sph2d_status sph2d_study_results_create(const sph2d_study_file *file, const sph2d_override *overrides,
                                        size_t override_count, bool all, sph2d_study_results **results,
                                        sph2d_report *report)
{
    if (!results)
        return sph2d__null(report, __func__, "results");
    *results = NULL;
    if (!file)
        return sph2d__null(report, __func__, "file");
    if (!overrides && override_count > 0)
        return sph2d__null(report, __func__, "overrides");
    sph2d_study_results *made = calloc(1, sizeof *made);
    if (!made)
        return SPH2D_NOMEM;
    made->file = file;
    made->study = sph2d_study_file_study(file);
    made->overrides = overrides;
    made->override_count = override_count;
    made->judge = sph2d__judge(made->study);
    sph2d_status status = make_references(made, report);
    if (status == SPH2D_OK)
        status = check_rows(made, all, report);
    if (status == SPH2D_OK)
        status = make_rows(made, all);
    if (status == SPH2D_OK)
        *results = made;
    else
        sph2d_study_results_destroy(made);
    return status;
}

void sph2d__row_free(sph2d_study_row *row)
{
    if (row->owned) {
        free((void *)(uintptr_t)row->run.name);
        free((void *)(uintptr_t)row->run.overrides);
        free((void *)(uintptr_t)row->run.places);
    }
    sph2d_study_record_free(&row->record);
    free(row->values);
    free(row->key);
}

void sph2d_study_results_destroy(sph2d_study_results *results)
{
    if (!results)
        return;
    for (size_t i = 0; i < results->row_count; ++i)
        sph2d__row_free(&results->rows[i]);
    for (size_t i = 0; results->references && i < results->study->measure_count; ++i)
        sph2d__reference_free(&results->references[i]);
    free(results->rows);
    free(results->references);
    free(results);
}
