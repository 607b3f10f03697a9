/* SPDX-License-Identifier: MIT */
/** @file refine.c
 *  Rows that go on from rows. */
#include "study/refine.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study/front.h"
#include "study/settings.h"

/** Puts "KEY=NEW" in the place of "KEY=OLD" among the settings that a name lists; false when it lists no such thing. */
static bool rename_setting(char *name, size_t size, const char *path, const char *old, const char *value)
{
    size_t length;
    const char *at = sph2d__setting_in(name, path, old, &length);
    char *rest = at ? strdup(at + length) : NULL;
    if (rest)
        snprintf(name + (at - name), size - (size_t)(at - name), "%s=%s%s", sph2d__key_name(path), value, rest);
    free(rest);
    return at != NULL;
}

/** The name of a row that goes on from `base`: its settings with those of `step`, and what `step` adds to them. */
static void name_row(char *name, size_t size, const sph2d_study_run *base, const sph2d_study_run *step)
{
    bool all = true;
    snprintf(name, size, "%s", base->name);
    for (size_t i = 0; i < step->override_count; ++i) {
        const sph2d_override *new = &step->overrides[i];
        bool found = false;
        for (size_t k = 0; k < base->override_count && !found; ++k)
            found = strcmp(base->overrides[k].path, new->path) == 0 &&
                    rename_setting(name, size, new->path, base->overrides[k].value, new->value);
        all = all && found;
    }
    size_t used = strlen(name);
    if (!all)
        snprintf(name + used, size - used, ", %s", step->name);
}

bool sph2d__refine_row(sph2d_study_row *row, const sph2d_study_run *base, const sph2d_study_run *step, size_t measures)
{
    size_t own = base->override_count, count = own + step->override_count;
    size_t size = strlen(base->name) + 2 * strlen(step->name) + 64;
    sph2d_override *overrides = malloc((count + 1) * sizeof *overrides);
    const char **places = malloc((count + 1) * sizeof *places);
    char *name = malloc(size);
    *row = (sph2d_study_row){.run = {name, overrides, count, places, 0},
                             .owned = true,
                             .wanted = true,
                             .values = malloc((measures + 1) * sizeof *row->values)};
    if (!overrides || !places || !name || !row->values)
        return false;
    name_row(name, size, base, step);
    for (size_t i = 0; i < count; ++i) {
        overrides[i] = i < own ? base->overrides[i] : step->overrides[i - own];
        places[i] = i < own ? base->places[i] : step->places[i - own];
    }
    return true;
}

sph2d_status sph2d_study_results_refine(sph2d_study_results *results, size_t step)
{
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
