/* SPDX-License-Identifier: MIT */
/** @file study_measure.c
 *  From records to the numbers of the table. */
#include "study_measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../message.h"
#include "study_front.h"
#include "study_order.h"
#include "study_scene.h"

/* Places along the line of a profile that the finest run is compared at. */
enum { PLACES = 101 };

/* ---- what a record must hold ------------------------------------------------------------------------------------- */

size_t study_measure_places(const cli_study *s, size_t measure)
{
    const study_points *points = &s->references[measure];
    return s->study->measures[measure].expectation == SPH2D_EXPECT_REFERENCE ? points->count : PLACES;
}

double study_measure_place(const cli_study *s, size_t measure, size_t place)
{
    const study_points *points = &s->references[measure];
    bool given = s->study->measures[measure].expectation == SPH2D_EXPECT_REFERENCE;
    return given ? points->x[place] : (double)place / (PLACES - 1);
}

/* The samples that a profile is measured with; NULL when the record has others. */
static const study_samples *find_samples(const cli_study *s, size_t measure, const study_record *record)
{
    const sph2d_study_profile *profile = &s->study->measures[measure].profile;
    size_t count = study_measure_places(s, measure);
    for (size_t i = 0; i < record->samples_count; ++i) {
        const study_samples *samples = &record->samples[i];
        bool same = samples->count == count && samples->quantity == profile->value &&
                    memcmp(samples->ends, profile->line.items, sizeof samples->ends) == 0;
        for (size_t k = 0; k < count && same; ++k)
            same = samples->along[k] == study_measure_place(s, measure, k);
        if (same)
            return samples;
    }
    return NULL;
}

static const study_series *find_series(const sph2d_study_measure *m, const study_record *record, size_t *column)
{
    for (size_t i = 0; i < record->series_count; ++i)
        if (strcmp(record->series[i].probe, m->probe) == 0)
            return study_column_find(record->series[i].headings, m->column, column) ? &record->series[i] : NULL;
    return NULL;
}

bool study_measure_possible(const cli_study *s, const study_record *record)
{
    size_t column;
    for (size_t i = 0; i < s->study->measure_count; ++i) {
        const sph2d_study_measure *m = &s->study->measures[i];
        bool missing = (m->source == SPH2D_MEASURE_PROFILE && find_samples(s, i, record) == NULL) ||
                       (m->source == SPH2D_MEASURE_PROBE && find_series(m, record, &column) == NULL);
        if (missing)
            return false;
    }
    return true;
}

/* ---- curves ------------------------------------------------------------------------------------------------------ */

/* A curve that owns its numbers. */
typedef struct owned_curve {
    study_curve curve;
    double *room;
} owned_curve;

/* What a measure looks at in a record: the part of the series that counts, or the samples with a value. */
static bool take_curve(const cli_study *s, size_t measure, const study_record *record, owned_curve *out)
{
    const sph2d_study_measure *m = &s->study->measures[measure];
    const double *x = NULL, *y = NULL;
    size_t column = 0, stride = 1, count = 0;
    double from = NAN, to = NAN;
    if (m->source == SPH2D_MEASURE_PROFILE) {
        const study_samples *samples = find_samples(s, measure, record);
        if (samples != NULL) {
            x = samples->along;
            y = samples->values;
            count = samples->count;
        }
    } else if (m->source == SPH2D_MEASURE_PROBE) {
        const study_series *series = find_series(m, record, &column);
        if (series != NULL && series->count > 0) {
            x = series->time;
            y = series->values + column;
            stride = series->columns;
            count = series->count;
        }
        from = m->from;
        to = m->to;
    }
    out->room = malloc((2 * count + 1) * sizeof *out->room);
    if (out->room == NULL)
        return false;
    out->curve = (study_curve){out->room, out->room, 0};
    if (count > 0)
        out->curve = study_select(x, y, stride, count, from, to, out->room, out->room + count);
    return true;
}

static double largest_size(study_curve curve)
{
    double largest = 0;
    for (size_t i = 0; i < curve.count; ++i)
        largest = fmax(largest, fabs(curve.y[i]));
    return largest;
}

/* ---- errors ------------------------------------------------------------------------------------------------------ */

bool study_measure_is_curve(const sph2d_study_measure *m)
{
    bool series =
        m->source == SPH2D_MEASURE_PROFILE || (m->source == SPH2D_MEASURE_PROBE && m->take == SPH2D_TAKE_DEFAULT);
    return m->expectation == SPH2D_EXPECT_REFERENCE || (m->expectation == SPH2D_EXPECT_FINEST && series);
}

/* Differences at the points of the reference; a profile has a sample at each, or has no error. */
static double compare_profile(const cli_study *s, size_t measure, const study_record *record)
{
    const sph2d_study_measure *m = &s->study->measures[measure];
    const study_samples *samples = find_samples(s, measure, record);
    const study_points *reference = &s->references[measure];
    double *differences = samples != NULL ? malloc((samples->count + 1) * sizeof *differences) : NULL;
    if (differences == NULL)
        return NAN;
    for (size_t i = 0; i < samples->count; ++i)
        differences[i] = samples->values[i] / m->scale - reference->y[i];
    double error = study_norm(m->norm, differences, samples->count);
    free(differences);
    return error;
}

/* The number that a measure makes of a record. */
static double number(const sph2d_study_measure *m, const study_record *record, study_curve curve)
{
    if (m->source == SPH2D_MEASURE_PROFILE)
        return NAN;
    double value = m->source == SPH2D_MEASURE_SUMMARY ? record->summary[m->summary]
                                                      : study_reduce(m->take, curve, m->level, m->at);
    return value / m->scale;
}

/* The error from the finest run's profile, taken at the same places: those where both have liquid count. */
static double compare_samples(const sph2d_study_measure *m, const study_samples *mine, const study_samples *finest)
{
    size_t count = 0;
    double largest = 0,
           *differences = mine != NULL && finest != NULL ? malloc((mine->count + 1) * sizeof *differences) : NULL;
    if (differences == NULL)
        return NAN;
    for (size_t i = 0; i < mine->count; ++i) {
        if (!isfinite(mine->values[i]) || !isfinite(finest->values[i]))
            continue;
        differences[count++] = mine->values[i] - finest->values[i];
        largest = fmax(largest, fabs(finest->values[i]));
    }
    double error = study_norm(m->norm, differences, count) / (m->relative ? largest : m->scale);
    free(differences);
    return error;
}

/* The error where the finest run's series is expected. */
static double compare_curves(const sph2d_study_measure *m, study_curve curve, study_curve finest)
{
    /* Both curves are divided by the scale, or by what the errors shall be relative to. */
    double unit = m->relative ? largest_size(finest) : m->scale;
    return study_compare(curve, 1, finest, m->norm, 0) / unit;
}

static bool measure_one(cli_study *s, size_t measure, study_row *row, const study_row *finest)
{
    const sph2d_study_measure *m = &s->study->measures[measure];
    study_value *out = &row->values[measure];
    owned_curve mine = {{NULL, NULL, 0}, NULL}, best = {{NULL, NULL, 0}, NULL};
    bool fine = take_curve(s, measure, &row->record, &mine);
    out->value = fine ? number(m, &row->record, mine.curve) : NAN;
    if (m->expectation == SPH2D_EXPECT_NUMBER)
        out->error = study_error(out->value, m->expect, m->relative != 0);
    if (fine && m->expectation == SPH2D_EXPECT_REFERENCE)
        out->error = m->source == SPH2D_MEASURE_PROFILE
                         ? compare_profile(s, measure, &row->record)
                         : study_compare(mine.curve, m->scale, study_points_curve(&s->references[measure]), m->norm,
                                         m->reference.shift);
    bool of_finest = m->expectation == SPH2D_EXPECT_FINEST && finest != NULL && finest != row;
    if (fine && of_finest && m->source == SPH2D_MEASURE_PROFILE) {
        out->error =
            compare_samples(m, find_samples(s, measure, &row->record), find_samples(s, measure, &finest->record));
    } else if (fine && of_finest) {
        fine = take_curve(s, measure, &finest->record, &best);
        if (fine && study_measure_is_curve(m))
            out->error = compare_curves(m, mine.curve, best.curve);
        else if (fine)
            out->error = study_error(out->value, number(m, &finest->record, best.curve), m->relative != 0);
    }
    free(mine.room);
    free(best.room);
    return fine;
}

/* ---- a number without a value ------------------------------------------------------------------------------------ */

static const char *why_no_value(const sph2d_study_measure *m)
{
    if (m->source == SPH2D_MEASURE_PROFILE)
        return "no particle is near one of its points";
    if (m->source == SPH2D_MEASURE_SUMMARY)
        return "not known for this run";
    if (m->expectation == SPH2D_EXPECT_REFERENCE)
        return "no point of the reference lies inside the series";
    switch (m->take) {
    case SPH2D_TAKE_PERIOD:
        return "the series comes up to its level less than twice";
    case SPH2D_TAKE_DECAY:
        return "the series swings to the sides of its level less than twice";
    case SPH2D_TAKE_CROSSING:
        return "the series does not come to its level";
    case SPH2D_TAKE_VALUE:
        return "the series has no sample before or after that time";
    default:
        return "the series has no sample with a value there";
    }
}

static void measure_row(cli_study *s, study_row *row, const study_row *finest, bool tell, bool *fine)
{
    for (size_t i = 0; i < s->study->measure_count; ++i) {
        const sph2d_study_measure *m = &s->study->measures[i];
        study_value *out = &row->values[i];
        *fine = measure_one(s, i, row, finest) && *fine;
        bool of_series = m->expectation == SPH2D_EXPECT_REFERENCE ||
                         (m->expectation == SPH2D_EXPECT_FINEST && study_measure_is_curve(m));
        bool needless = of_series && row == finest && m->expectation == SPH2D_EXPECT_FINEST;
        if (tell && !needless && !isfinite(of_series ? out->error : out->value))
            message_warning(SPH2D_CODE_GENERAL, "row '%s': no value of '%s': %s", row->run.name, m->name,
                            why_no_value(m));
    }
}

/* ---- all rows ---------------------------------------------------------------------------------------------------- */

sph2d_status study_measure_all(cli_study *s, bool tell)
{
    bool fine = true;
    size_t finest = study_finest(s);
    for (size_t r = 0; r < s->row_count; ++r) {
        for (size_t i = 0; i < s->study->measure_count; ++i)
            s->rows[r].values[i] = (study_value){NAN, NAN, NAN};
        if (study_row_counts(&s->rows[r]))
            measure_row(s, &s->rows[r], finest < s->row_count ? &s->rows[finest] : NULL, tell, &fine);
    }
    study_order_all(s);
    return fine ? SPH2D_OK : SPH2D_NOMEM;
}

static bool misses(const sph2d_study_measure *m, const study_value *v)
{
    return !isnan(m->bound) && !(v->error <= m->bound);
}

/* What is expected of the finest run is what it gives. */
static bool is_own_reference(const cli_study *s, const sph2d_study_measure *m, size_t row)
{
    return m->expectation == SPH2D_EXPECT_FINEST && row == study_finest(s);
}

size_t study_measure_misses(const cli_study *s)
{
    size_t count = 0;
    for (size_t r = 0; r < s->row_count; ++r) {
        const study_row *row = &s->rows[r];
        for (size_t i = 0; study_row_counts(row) && i < s->study->measure_count; ++i) {
            const sph2d_study_measure *m = &s->study->measures[i];
            const study_value *v = &row->values[i];
            if (!misses(m, v) || is_own_reference(s, m, r))
                continue;
            ++count;
            if (isnan(v->error))
                message_error(SPH2D_CODE_GENERAL, NULL, "row '%s': '%s' has no value, where its error may be %g",
                              row->run.name, m->name, m->bound);
            else if (m->expectation == SPH2D_EXPECT_NUMBER)
                message_error(SPH2D_CODE_GENERAL, NULL, "row '%s': '%s' is %g, so its %serror %g exceeds the bound %g",
                              row->run.name, m->name, v->value, m->relative ? "relative " : "", v->error, m->bound);
            else
                message_error(SPH2D_CODE_GENERAL, NULL, "row '%s': the error %g of '%s' exceeds the bound %g",
                              row->run.name, v->error, m->name, m->bound);
        }
    }
    return count;
}
