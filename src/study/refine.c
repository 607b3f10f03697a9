/* SPDX-License-Identifier: MIT */
/** @file refine.c
 *  Refinements: rows derived from other rows. */
#include "study/parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** The name of a row derived from `base`, to whose name the step may add; NULL when memory is short. */
static char *make_name(const sph2d_study_run *run, const sph2d_study_run *base, const sph2d_study_run *step)
{
    bool given = step->given && step->given[0];
    size_t size = given ? strlen(base->name) + strlen(step->name) + 3 : sph2d_study_run_name(run, NULL, NULL, 0) + 1;
    char *name = malloc(size);
    if (name && given)
        snprintf(name, size, "%s, %s", base->name, step->name);
    else if (name)
        sph2d_study_run_name(run, NULL, name, size);
    return name;
}

bool sph2d__refine_row(sph2d_study_row *row, const sph2d_study_run *base, const sph2d_study_run *step, size_t measures)
{
    size_t own = base->override_count, count = own + step->override_count;
    sph2d_override *overrides = malloc((count + 1) * sizeof *overrides);
    const char **places = malloc((count + 1) * sizeof *places);
    *row = (sph2d_study_row){
        .run = *base, .owned = true, .wanted = true, .values = malloc((measures + 1) * sizeof *row->values)};
    row->run.name = NULL;
    row->run.overrides = overrides;
    row->run.places = places;
    row->run.override_count = count;
    if (!overrides || !places || !row->values)
        return false;
    for (size_t i = 0; i < count; ++i) {
        overrides[i] = i < own ? base->overrides[i] : step->overrides[i - own];
        places[i] = i < own ? base->places[i] : step->places[i - own];
    }
    row->run.name = make_name(&row->run, base, step);
    return row->run.name;
}

sph2d_status sph2d_study_results_refine(sph2d_study_results *results, size_t step)
{
    if (!results)
        return SPH2D_INVALID;
    const sph2d_study *study = results->study;
    size_t before = results->row_count;
    sph2d_study_row *grown = realloc(results->rows, (2 * before + 1) * sizeof *grown);
    if (!grown)
        return SPH2D_NOMEM;
    results->rows = grown;
    const sph2d_study_row *finest = sph2d__finest(results);
    double spacing = finest ? finest->record.spacing : NAN;
    /* What the others are compared with has no error of its own, but may be what is wanted. */
    bool compared =
        results->judge < study->measure_count && study->measures[results->judge].expectation == SPH2D_EXPECT_FINEST;
    for (size_t r = 0; r < before; ++r) {
        if (!(compared && &grown[r] == finest) && !sph2d__front_holds(results, &grown[r], spacing, spacing))
            continue;
        sph2d_study_row *row = &grown[results->row_count];
        bool fine = sph2d__refine_row(row, &grown[r].run, &study->refinements[step], study->measure_count);
        row->number = ++results->row_count;
        if (!fine)
            return SPH2D_NOMEM;
    }
    return SPH2D_OK;
}
