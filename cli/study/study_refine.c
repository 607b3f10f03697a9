/* SPDX-License-Identifier: MIT */
/** @file study_refine.c
 *  Rows that go on from rows. */
#include "study_refine.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study_front.h"
#include "study_settings.h"

/* Puts "KEY=NEW" in the place of "KEY=OLD" among the settings that a name lists; false when it lists no such thing. */
static bool rename_setting(char *name, size_t size, const char *path, const char *old, const char *value)
{
    size_t length;
    const char *at = study_setting_in(name, path, old, &length);
    char *rest = at != NULL ? strdup(at + length) : NULL;
    if (rest != NULL)
        snprintf(name + (at - name), size - (size_t)(at - name), "%s=%s%s", study_key(path), value, rest);
    free(rest);
    return at != NULL;
}

/* The name of a row that goes on from `base`: its settings with those of `step`, and what `step` adds to them. */
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

bool study_refine_row(study_row *row, const sph2d_study_run *base, const sph2d_study_run *step, size_t measures)
{
    size_t count = base->override_count + step->override_count;
    size_t size = strlen(base->name) + 2 * strlen(step->name) + 64;
    sph2d_override *overrides = malloc((count + 1) * sizeof *overrides);
    const char **places = malloc((count + 1) * sizeof *places);
    char *name = malloc(size);
    *row = (study_row){.run = {name, overrides, count, places, 0},
                       .owned = true,
                       .wanted = true,
                       .values = malloc((measures + 1) * sizeof *row->values)};
    if (overrides == NULL || places == NULL || name == NULL || row->values == NULL)
        return false;
    name_row(name, size, base, step);
    for (size_t i = 0; i < count; ++i) {
        const sph2d_study_run *from = i < base->override_count ? base : step;
        size_t k = i < base->override_count ? i : i - base->override_count;
        overrides[i] = from->overrides[k];
        places[i] = from->places[k];
    }
    return true;
}

sph2d_status study_refine(cli_study *s, size_t step)
{
    size_t before = s->row_count, finest = study_finest(s);
    double spacing = finest < before ? s->rows[finest].record.spacing : NAN;
    study_row *grown = realloc(s->rows, (2 * before + 1) * sizeof *grown);
    if (grown == NULL)
        return SPH2D_NOMEM;
    s->rows = grown;
    bool fine = true;
    for (size_t r = 0; r < before && fine; ++r) {
        /* What the others are compared with has no error of its own, but may be what is wanted. */
        bool is_reference = r == finest && s->judge < s->study->measure_count &&
                            s->study->measures[s->judge].expectation == SPH2D_EXPECT_FINEST;
        if (!is_reference && !study_front_holds(s, &s->rows[r], spacing, spacing))
            continue;
        study_row *row = &s->rows[s->row_count];
        fine = study_refine_row(row, &s->rows[r].run, &s->study->refinements[step], s->study->measure_count);
        row->number = ++s->row_count;
    }
    return fine ? SPH2D_OK : SPH2D_NOMEM;
}
