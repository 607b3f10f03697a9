/* SPDX-License-Identifier: MIT */
/** @file study_measure.c
 *  From series and simulation to the numbers of the table. */
#include "study_measure.h"

#include <math.h>
#include <stdlib.h>

#include "../message.h"
#include "study_scene.h"

/* ---- a number without a value ------------------------------------------------------------------------------------ */

static const char *why_no_value(const sph2d_study_measure *m)
{
    if (m->source == SPH2D_MEASURE_PROFILE)
        return "no particle is near one of its points";
    if (m->expectation == SPH2D_EXPECT_REFERENCE)
        return "no point of the reference lies inside the series";
    switch (m->take) {
    case SPH2D_TAKE_PERIOD:
        return "the series comes up to its level less than twice";
    case SPH2D_TAKE_CROSSING:
        return "the series does not come to its level";
    case SPH2D_TAKE_VALUE:
        return "the series has no sample before or after that time";
    default:
        return "the series has no sample with a value there";
    }
}

/* ---- probes ------------------------------------------------------------------------------------------------------ */

static sph2d_status measure_series(const sph2d_study_measure *m, const study_points *reference,
                                   const study_series *series, size_t column, study_value *out)
{
    double *room = malloc((2 * series->count + 1) * sizeof *room);
    if (room == NULL)
        return SPH2D_NOMEM;
    study_curve curve = {room, room, 0};
    if (series->count > 0)
        curve = study_select(series->time, series->values + column, series->columns, series->count, m->from, m->to,
                             room, room + series->count);
    if (m->expectation == SPH2D_EXPECT_REFERENCE) {
        out->error = study_compare(curve, m->scale, study_points_curve(reference), m->norm, m->reference.shift);
    } else {
        out->value = study_reduce(m->take, curve, m->level, m->at) / m->scale;
        if (m->expectation == SPH2D_EXPECT_NUMBER)
            out->error = study_error(out->value, m->expect, m->relative != 0);
    }
    free(room);
    return SPH2D_OK;
}

/* ---- profiles ---------------------------------------------------------------------------------------------------- */

static double quantity(const sph2d_sample *sample, sph2d_quantity what)
{
    switch (what) {
    case SPH2D_QUANTITY_VX:
        return sample->velocity[0];
    case SPH2D_QUANTITY_VY:
        return sample->velocity[1];
    case SPH2D_QUANTITY_SPEED:
        return hypot(sample->velocity[0], sample->velocity[1]);
    case SPH2D_QUANTITY_PRESSURE:
        return sample->pressure;
    case SPH2D_QUANTITY_DENSITY:
        return sample->density;
    }
    return NAN;
}

static sph2d_status measure_profile(const sph2d_study_measure *m, const study_points *reference, const sph2d_sim *sim,
                                    study_value *out)
{
    double *differences = malloc((reference->count + 1) * sizeof *differences);
    if (differences == NULL)
        return SPH2D_NOMEM;
    sph2d_vec2 a = m->profile.line.items[0], b = m->profile.line.items[1];
    for (size_t i = 0; i < reference->count; ++i) {
        double part = reference->x[i];
        sph2d_vec2 at = {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
        sph2d_sample sample;
        bool near = sph2d_sim_sample(sim, at, &sample);
        differences[i] = near ? quantity(&sample, m->profile.value) / m->scale - reference->y[i] : NAN;
    }
    out->error = study_norm(m->norm, differences, reference->count);
    free(differences);
    return SPH2D_OK;
}

/* ---- a row ------------------------------------------------------------------------------------------------------- */

sph2d_status study_measure(cli_study *s, study_row *row, const sph2d_sim *sim, const study_series *series)
{
    for (size_t i = 0; i < s->study->measure_count; ++i) {
        const sph2d_study_measure *m = &s->study->measures[i];
        study_value *out = &row->values[i];
        study_column found;
        sph2d_status status = SPH2D_OK;
        if (m->source == SPH2D_MEASURE_PROFILE)
            status = measure_profile(m, &s->references[i], sim, out);
        else if (study_column_find(sph2d_sim_scene(sim), m, &found))
            status = measure_series(m, &s->references[i], &series[found.probe], found.column, out);
        if (status != SPH2D_OK)
            return status;
        if (!isfinite(m->expectation == SPH2D_EXPECT_REFERENCE ? out->error : out->value))
            message_warning(SPH2D_CODE_GENERAL, "row '%s': no value of '%s': %s", row->run->name, m->name,
                            why_no_value(m));
    }
    return SPH2D_OK;
}

void study_measure_orders(cli_study *s)
{
    const study_row *fine = &s->rows[s->row_count - 1];
    size_t before = s->row_count - 1;
    while (before > 0 && !(s->rows[before - 1].end == STUDY_FINISHED && s->rows[before - 1].spacing > fine->spacing))
        --before;
    if (before == 0 || fine->end != STUDY_FINISHED)
        return;
    const study_row *coarse = &s->rows[before - 1];
    for (size_t i = 0; i < s->study->measure_count; ++i)
        if (s->study->measures[i].order)
            fine->values[i].order =
                study_order(coarse->values[i].error, fine->values[i].error, coarse->spacing, fine->spacing);
}

static bool misses(const sph2d_study_measure *m, const study_value *v)
{
    return !isnan(m->bound) && !(v->error <= m->bound);
}

size_t study_measure_misses(const cli_study *s)
{
    size_t count = 0;
    for (size_t r = 0; r < s->row_count; ++r) {
        const study_row *row = &s->rows[r];
        for (size_t i = 0; row->end == STUDY_FINISHED && i < s->study->measure_count; ++i) {
            const sph2d_study_measure *m = &s->study->measures[i];
            const study_value *v = &row->values[i];
            if (!misses(m, v))
                continue;
            ++count;
            if (isnan(v->error))
                message_error(SPH2D_CODE_GENERAL, NULL, "row '%s': '%s' has no value, where its error may be %g",
                              row->run->name, m->name, m->bound);
            else if (m->expectation == SPH2D_EXPECT_NUMBER)
                message_error(SPH2D_CODE_GENERAL, NULL, "row '%s': '%s' is %g, so its %serror %g exceeds the bound %g",
                              row->run->name, m->name, v->value, m->relative ? "relative " : "", v->error, m->bound);
            else
                message_error(SPH2D_CODE_GENERAL, NULL, "row '%s': the error %g of '%s' exceeds the bound %g",
                              row->run->name, v->error, m->name, m->bound);
        }
    }
    return count;
}
