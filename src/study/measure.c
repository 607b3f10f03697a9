/* SPDX-License-Identifier: MIT */
/** @file measure.c
 *  From records to values and errors. */
#include "study/parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study/curve.h"

/* ---- what a record must hold ------------------------------------------------------------------------------------- */

static bool is_profile(const sph2d_study_results *results, size_t measure, const sph2d_study_series *series)
{
    const sph2d_study_profile *profile = &results->study->measures[measure].profile;
    const sph2d_study_curve *reference = &results->references[measure];
    bool same = series->probe[0] == '\0' && series->count == reference->count && series->quantity == profile->value &&
                memcmp(series->ends, profile->line.items, sizeof series->ends) == 0;
    for (size_t k = 0; same && k < series->count; ++k)
        same = series->rows[2 * k] == reference->x[k];
    return same;
}

/** The series and column of a measure; NULL when the record does not have it. */
static const sph2d_study_series *find_series(const sph2d_study_results *results, size_t measure,
                                             const sph2d_study_record *record, size_t *column)
{
    const sph2d_study_measure *m = &results->study->measures[measure];
    *column = 0;
    for (size_t i = 0; i < record->series_count; ++i) {
        const sph2d_study_series *s = &record->series[i];
        bool found = m->source == SPH2D_MEASURE_PROFILE
                         ? is_profile(results, measure, s)
                         : m->source == SPH2D_MEASURE_PROBE && strcmp(s->probe, m->probe) == 0 &&
                               sph2d__column_find(sph2d_probe_columns(s->kind), m->column, column);
        if (found)
            return s;
    }
    return NULL;
}

bool sph2d__record_serves(const sph2d_study_results *results, const sph2d_study_record *record)
{
    size_t column;
    for (size_t i = 0; i < results->study->measure_count; ++i)
        if (results->study->measures[i].source != SPH2D_MEASURE_SUMMARY && !find_series(results, i, record, &column))
            return false;
    return true;
}

/* ---- profiles ---------------------------------------------------------------------------------------------------- */

/** The error of a profile against its reference at the same positions, or against the finest run's at positions where
 *  both have liquid. `finest` is NULL for a reference. False when memory is short. */
static bool compare_profiles(const sph2d_study_measure *m, const sph2d_study_series *mine,
                             const sph2d_study_series *finest, const sph2d_study_curve *reference, double *error)
{
    double largest = 0, *differences = malloc((mine->count + 1) * sizeof *differences);
    size_t count = 0;
    if (!differences)
        return false;
    for (size_t i = 0; i < mine->count; ++i) {
        double here = mine->rows[2 * i + 1], there = finest ? finest->rows[2 * i + 1] : reference->y[i];
        if (finest && (!isfinite(here) || !isfinite(there)))
            continue;
        differences[count++] = finest ? here - there : here / m->scale - there;
        largest = fmax(largest, fabs(there));
    }
    double unit = !finest ? 1 : m->relative ? largest : m->scale;
    *error = sph2d__norm(m->norm, differences, count) / unit;
    free(differences);
    return true;
}

static bool measure_profile(const sph2d_study_results *results, size_t measure, sph2d_study_row *row,
                            const sph2d_study_row *finest)
{
    size_t column;
    const sph2d_study_measure *m = &results->study->measures[measure];
    const sph2d_study_series *mine = find_series(results, measure, &row->record, &column), *best = NULL;
    bool of_finest = m->expectation == SPH2D_EXPECT_FINEST;
    if (of_finest)
        best = find_series(results, measure, &finest->record, &column);
    if (!mine || (of_finest && (row == finest || !best)))
        return true;
    return compare_profiles(m, mine, best, &results->references[measure], &row->values[measure].error);
}

/* ---- series and summaries ---------------------------------------------------------------------------------------- */

/** The part of a series that a measure uses; empty if there is none. False when memory is short. The caller frees
 *  *room, which holds it. */
static bool take_curve(const sph2d_study_results *results, size_t measure, const sph2d_study_record *record,
                       sph2d_study_curve *curve, double **room)
{
    const sph2d_study_measure *m = &results->study->measures[measure];
    size_t column;
    const sph2d_study_series *s = find_series(results, measure, record, &column);
    size_t count = s ? s->count : 0;
    *room = malloc((2 * count + 1) * sizeof **room);
    *curve = (sph2d_study_curve){*room, *room, 0};
    if (*room && count > 0)
        *curve = sph2d__curve_select(s->rows, s->columns + 1, column + 1, count, m->from, m->to, *room);
    return *room;
}

/** The value of a measure in a record. */
static double number(const sph2d_study_measure *m, const sph2d_study_record *record, sph2d_study_curve curve)
{
    double value = m->source == SPH2D_MEASURE_SUMMARY ? record->summary[m->summary]
                                                      : sph2d__curve_reduce(m->take, curve, m->level, m->at);
    return value / m->scale;
}

static double largest_size(sph2d_study_curve curve)
{
    double largest = 0;
    for (size_t i = 0; i < curve.count; ++i)
        largest = fmax(largest, fabs(curve.y[i]));
    return largest;
}

static bool measure_series(const sph2d_study_results *results, size_t measure, sph2d_study_row *row,
                           const sph2d_study_row *finest)
{
    const sph2d_study_measure *m = &results->study->measures[measure];
    sph2d_study_value *out = &row->values[measure];
    sph2d_study_curve mine, best;
    double *room, *best_room = NULL;
    bool fine = take_curve(results, measure, &row->record, &mine, &room);
    if (fine && sph2d_study_has_value(m))
        out->value = number(m, &row->record, mine);
    if (m->expectation == SPH2D_EXPECT_NUMBER)
        out->error = sph2d__error(out->value, m->expect, m->relative != 0);
    if (fine && m->expectation == SPH2D_EXPECT_REFERENCE)
        out->error = sph2d__curve_compare(mine, m->scale, results->references[measure], m->norm, m->reference.shift);
    if (fine && m->expectation == SPH2D_EXPECT_FINEST && row != finest) {
        fine = take_curve(results, measure, &finest->record, &best, &best_room);
        if (fine && sph2d_study_has_value(m))
            out->error = sph2d__error(out->value, number(m, &finest->record, best), m->relative != 0);
        else if (fine) /* both are divided by the scale, or by what the errors shall be relative to */
            out->error =
                sph2d__curve_compare(mine, 1, best, m->norm, 0) / (m->relative ? largest_size(best) : m->scale);
    }
    free(room);
    free(best_room);
    return fine;
}

/* ---- all rows ---------------------------------------------------------------------------------------------------- */

sph2d_status sph2d_study_results_measure(sph2d_study_results *results)
{
    if (!results)
        return SPH2D_INVALID;
    const sph2d_study *study = results->study;
    const sph2d_study_row *finest = sph2d__finest(results);
    bool fine = true;
    for (size_t r = 0; r < results->row_count; ++r) {
        sph2d_study_row *row = &results->rows[r];
        const sph2d_study_record *record = &row->record;
        double time = isnan(record->wall) ? record->cpu : record->wall;
        row->rate = time > 0 && record->steps > 0 ? (double)record->particle_steps / time : NAN;
        for (size_t i = 0; i < study->measure_count; ++i) {
            row->values[i] = (sph2d_study_value){NAN, NAN, NAN};
            if (!sph2d__row_counts(row))
                continue;
            bool profile = study->measures[i].source == SPH2D_MEASURE_PROFILE;
            fine = (profile ? measure_profile : measure_series)(results, i, row, finest) && fine;
        }
    }
    sph2d__order_all(results);
    sph2d__front_mark(results);
    return fine ? SPH2D_OK : SPH2D_NOMEM;
}
