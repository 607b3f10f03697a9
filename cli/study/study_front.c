/* SPDX-License-Identifier: MIT */
/** @file study_front.c
 *  Error against time. */
#include "study_front.h"

#include <math.h>
#include <string.h>

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

bool study_front_holds(const cli_study *s, const study_row *row, double from, double to)
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
        s->rows[r].on_front = study_front_holds(s, &s->rows[r], 0, INFINITY);
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

size_t study_finest(const cli_study *s)
{
    size_t finest = s->row_count;
    for (size_t r = 0; r < s->row_count; ++r)
        if (study_row_counts(&s->rows[r]) &&
            (finest == s->row_count || s->rows[r].record.spacing <= s->rows[finest].record.spacing))
            finest = r;
    return finest;
}
