/* SPDX-License-Identifier: MIT */
/** @file front.c
 *  The Pareto front of error and time. */
#include "study/parts.h"

#include <math.h>
#include <string.h>

size_t sph2d__judge(const sph2d_study *study)
{
    size_t i = 0;
    while (i < study->measure_count && (!sph2d_study_has_error(&study->measures[i]) ||
                                        (study->judge && strcmp(study->measures[i].name, study->judge) != 0)))
        ++i;
    return i;
}

double sph2d_study_row_error(const sph2d_study_results *results, const sph2d_study_row *row)
{
    if (!results || !row)
        return NAN;
    bool has_error = sph2d__row_counts(row) && results->judge < results->study->measure_count;
    return has_error ? row->values[results->judge].error : NAN;
}

/** Whether `a` dominates `b`; of two equal rows the first does. */
static bool beats(const sph2d_study_results *results, const sph2d_study_row *a, const sph2d_study_row *b)
{
    double error = sph2d_study_row_error(results, a), other = sph2d_study_row_error(results, b);
    if (!isfinite(error) || !(error <= other && a->record.cpu <= b->record.cpu))
        return false;
    return error < other || a->record.cpu < b->record.cpu || a < b;
}

bool sph2d__front_holds(const sph2d_study_results *results, const sph2d_study_row *row, double from, double to)
{
    if (!isfinite(sph2d_study_row_error(results, row)) || row->record.spacing < from || row->record.spacing > to)
        return false;
    for (size_t r = 0; r < results->row_count; ++r) {
        const sph2d_study_row *other = &results->rows[r];
        if (other->record.spacing >= from && other->record.spacing <= to && beats(results, other, row))
            return false;
    }
    return true;
}

void sph2d__front_mark(sph2d_study_results *results)
{
    for (size_t r = 0; r < results->row_count; ++r)
        results->rows[r].on_front = sph2d__front_holds(results, &results->rows[r], 0, INFINITY);
}

const sph2d_study_row *sph2d_study_cheapest(const sph2d_study_results *results, double target)
{
    if (!results)
        return NULL;
    const sph2d_study_row *cheapest = NULL;
    for (const sph2d_study_row *row = results->rows; row < results->rows + results->row_count; ++row)
        if (sph2d_study_row_error(results, row) <= target && (!cheapest || row->record.cpu < cheapest->record.cpu))
            cheapest = row;
    return cheapest;
}

const sph2d_study_row *sph2d_study_best(const sph2d_study_results *results)
{
    if (!results)
        return NULL;
    const sph2d_study_row *best = NULL;
    for (const sph2d_study_row *row = results->rows; row < results->rows + results->row_count; ++row) {
        double error = sph2d_study_row_error(results, row);
        if (isfinite(error) && (!best || error < sph2d_study_row_error(results, best)))
            best = row;
    }
    return best;
}

const sph2d_study_row *sph2d__finest(const sph2d_study_results *results)
{
    const sph2d_study_row *finest = NULL;
    for (const sph2d_study_row *row = results->rows; row < results->rows + results->row_count; ++row)
        if (sph2d__row_counts(row) && (!finest || row->record.spacing <= finest->record.spacing))
            finest = row;
    return finest;
}
