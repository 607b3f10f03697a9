/* SPDX-License-Identifier: MIT */
/** @file judge.c
 *  What is wrong with the numbers of a row: those that are not known, and errors above their bounds. */
#include <math.h>

#include "study/parts.h"

static const char *why_unknown(const sph2d_study_measure *m)
{
    if (m->source == SPH2D_MEASURE_PROFILE)
        return "no particle is near one of its points";
    if (m->source == SPH2D_MEASURE_SUMMARY)
        return "not known for this run";
    if (m->expectation == SPH2D_EXPECT_REFERENCE)
        return "no point of the reference lies inside the series";
    if (m->take == SPH2D_TAKE_PERIOD)
        return "the series comes up to its level less than twice";
    if (m->take == SPH2D_TAKE_DECAY)
        return "the series swings to the sides of its level less than twice";
    if (m->take == SPH2D_TAKE_CROSSING)
        return "the series does not come to its level";
    if (m->take == SPH2D_TAKE_VALUE)
        return "the series has no sample before or after that time";
    return "the series has no sample with a value there";
}

static void judge_one(const char *row, const sph2d_study_measure *m, const sph2d_study_value *v, bool own,
                      sph2d_report *report)
{
    double number = sph2d_study_has_value(m) ? v->value : v->error;
    if (!isfinite(number) && !(own && !sph2d_study_has_value(m)))
        sph2d_report_add(report, SPH2D_WARNING, SPH2D_CODE_GENERAL, NULL, "row '%s': no value of '%s': %s", row,
                         m->name, why_unknown(m));
    if (own || isnan(m->bound) || v->error <= m->bound)
        return;
    if (isnan(v->error))
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL,
                         "row '%s': '%s' has no value, where its error may be %g", row, m->name, m->bound);
    else if (m->expectation == SPH2D_EXPECT_NUMBER)
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL,
                         "row '%s': '%s' is %g, so its %serror %g exceeds the bound %g", row, m->name, v->value,
                         m->relative ? "relative " : "", v->error, m->bound);
    else
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL,
                         "row '%s': the error %g of '%s' exceeds the bound %g", row, v->error, m->name, m->bound);
}

/** Whether the finest row may be one that is still missing. */
static bool is_incomplete(const sph2d_study_results *results)
{
    for (size_t r = 0; r < results->row_count; ++r)
        if (results->rows[r].wanted && !results->rows[r].there)
            return true;
    return false;
}

void sph2d_study_row_judge(const sph2d_study_results *results, const sph2d_study_row *row, sph2d_report *report)
{
    if (!results || !row)
        return;
    const sph2d_study_row *finest = sph2d__finest(results);
    bool incomplete = is_incomplete(results);
    for (size_t i = 0; sph2d__row_counts(row) && i < results->study->measure_count; ++i) {
        const sph2d_study_measure *m = &results->study->measures[i];
        /* What is expected of the finest run is what it gives. */
        bool own = m->expectation == SPH2D_EXPECT_FINEST && row == finest;
        if (m->expectation != SPH2D_EXPECT_FINEST || !incomplete)
            judge_one(row->run.name, m, &row->values[i], own, report);
    }
}
