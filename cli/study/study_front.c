/* SPDX-License-Identifier: MIT */
/** @file study_front.c
 *  Error against time. */
#include "study_front.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../parse.h"
#include "../text.h"
#include "study_cells.h"
#include "study_measure.h"

size_t study_front_judge(const sph2d_study *study)
{
    for (size_t i = 0; i < study->measure_count; ++i) {
        const sph2d_study_measure *m = &study->measures[i];
        bool meant = study->judge != NULL ? strcmp(m->name, study->judge) == 0 : true;
        if (meant && m->expectation != SPH2D_EXPECT_NOTHING)
            return i;
    }
    return study->measure_count;
}

double study_front_error(const cli_study *s, const study_row *row)
{
    bool has_error = study_row_counts(row) && s->judge < s->study->measure_count;
    return has_error ? row->values[s->judge].error : NAN;
}

/* ---- the front --------------------------------------------------------------------------------------------------- */

/* Whether `a` makes `b` needless; of two that are equal the first does. */
static bool beats(const cli_study *s, const study_row *a, const study_row *b)
{
    double error = study_front_error(s, a), other = study_front_error(s, b);
    if (!isfinite(error) || !(error <= other && a->record.cpu <= b->record.cpu))
        return false;
    return error < other || a->record.cpu < b->record.cpu || a < b;
}

/* Whether a row is on the front of those with at least the spacing `from` and at most `to`. */
static bool is_on_front(const cli_study *s, const study_row *row, double from, double to)
{
    if (!isfinite(study_front_error(s, row)) || row->record.spacing < from || row->record.spacing > to)
        return false;
    for (size_t r = 0; r < s->row_count; ++r) {
        const study_row *other = &s->rows[r];
        if (other->record.spacing >= from && other->record.spacing <= to && beats(s, other, row))
            return false;
    }
    return true;
}

void study_front_mark(cli_study *s)
{
    for (size_t r = 0; r < s->row_count; ++r)
        s->rows[r].on_front = is_on_front(s, &s->rows[r], 0, INFINITY);
}

const study_row *study_front_cheapest(const cli_study *s, double target)
{
    const study_row *cheapest = NULL;
    for (size_t r = 0; r < s->row_count; ++r) {
        const study_row *row = &s->rows[r];
        bool good = study_front_error(s, row) <= target;
        if (good && (cheapest == NULL || row->record.cpu < cheapest->record.cpu))
            cheapest = row;
    }
    return cheapest;
}

const study_row *study_front_best(const cli_study *s)
{
    const study_row *best = NULL;
    for (size_t r = 0; r < s->row_count; ++r) {
        double error = study_front_error(s, &s->rows[r]);
        if (isfinite(error) && (best == NULL || error < study_front_error(s, best)))
            best = &s->rows[r];
    }
    return best;
}

/* ---- refinements ------------------------------------------------------------------------------------------------- */

/* The last step of a key path: "sound_speed" of "method.sound_speed". */
static const char *last_step(const char *path)
{
    const char *point = strrchr(path, '.');
    return point != NULL && point[1] != '\0' ? point + 1 : path;
}

/* Puts "KEY=NEW" in the place of "KEY=OLD" among the settings that a name lists; false when it lists no such thing. */
static bool rename_setting(char *name, size_t size, const char *path, const char *old, const char *value)
{
    char setting[160], *at = name;
    int length = snprintf(setting, sizeof setting, "%s=%s", last_step(path), old);
    while (length < (int)sizeof setting && (at = strstr(at, setting)) != NULL) {
        char *behind = at + length;
        bool whole = (at == name || at[-1] == ' ') && (*behind == '\0' || *behind == ',');
        if (whole) {
            char rest[512];
            snprintf(rest, sizeof rest, "%s", behind);
            snprintf(at, size - (size_t)(at - name), "%s=%s%s", last_step(path), value, rest);
            return true;
        }
        at = behind;
    }
    return false;
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

/* A row that goes on from `base` with the overrides of `step` on top. The row owns its lists and its name. */
static bool make_row(study_row *row, const sph2d_study_run *base, const sph2d_study_run *step, size_t measures)
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

sph2d_status study_front_refine(cli_study *s, size_t step)
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
        if (!is_reference && !is_on_front(s, &s->rows[r], spacing, spacing))
            continue;
        study_row *row = &s->rows[s->row_count];
        fine = make_row(row, &s->rows[r].run, &s->study->refinements[step], s->study->measure_count);
        row->number = ++s->row_count;
    }
    return fine ? SPH2D_OK : SPH2D_NOMEM;
}

/* ---- orders ------------------------------------------------------------------------------------------------------ */

double study_along(const cli_study *s, const study_row *row)
{
    if (strcmp(s->study->along, "spacing") == 0)
        return row->record.spacing;
    const char *value = study_setting(&row->run, s->study->along);
    double number;
    return value != NULL && parse_number(value, &number) ? number : NAN;
}

bool study_belong(const cli_study *s, const study_row *a, const study_row *b)
{
    return study_same_but(s->study->along, &a->run, &b->run);
}

double study_front_order(const cli_study *s, const study_row *row, size_t *count)
{
    double x = 0, y = 0, xx = 0, xy = 0;
    *count = 0;
    for (size_t r = 0; r < s->row_count; ++r) {
        double error = study_front_error(s, &s->rows[r]);
        double along = study_along(s, &s->rows[r]);
        if (!(error > 0) || !(along > 0) || !study_belong(s, &s->rows[r], row))
            continue;
        double a = log(along), b = log(error);
        x += a;
        y += b;
        xx += a * a;
        xy += a * b;
        ++*count;
    }
    double n = (double)*count, spread = n * xx - x * x;
    return *count > 1 && spread > 1e-12 * n * xx ? (n * xy - x * y) / spread : NAN;
}

/* ---- the verdict ------------------------------------------------------------------------------------------------- */

/* As people read it: per cent where it is a part of something, else in units of the measure. */
static void write_error(const cli_study *s, char out[TEXT_SIZE], double error)
{
    if (s->percent)
        snprintf(out, TEXT_SIZE, "%.3g %%", 100 * error);
    else
        snprintf(out, TEXT_SIZE, "%.3g", error);
}

char *study_verdict(const cli_study *s, char *out, size_t size)
{
    const study_row *cheapest = study_front_cheapest(s, s->target), *best = study_front_best(s);
    char wanted[TEXT_SIZE], got[TEXT_SIZE], time[STUDY_CELL_SIZE], judged[101], name[201];
    out[0] = '\0';
    if (best == NULL)
        return out;
    const sph2d_study_measure *judge = &s->study->measures[s->judge];
    const char *against = judge->expectation == SPH2D_EXPECT_FINEST ? ", against the finest row" : "";
    const study_row *row = cheapest != NULL ? cheapest : best;
    write_error(s, wanted, s->target);
    write_error(s, got, study_front_error(s, row));
    study_cells_seconds(time, row->record.cpu);
    snprintf(judged, sizeof judged, "%s", judge->name);
    snprintf(name, sizeof name, "%s", row->run.name);
    text_whole(judged);
    text_whole(name);
    if (cheapest != NULL)
        snprintf(out, size, "For an error of %s (%s%s) the cheapest is '%s': %s in %s CPU s.", wanted, judged, against,
                 name, got, time);
    else
        snprintf(out, size, "No row has an error of %s or less (%s%s): the smallest is %s, by '%s' in %s CPU s.",
                 wanted, judged, against, got, name, time);
    return out;
}
