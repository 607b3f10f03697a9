/* SPDX-License-Identifier: MIT */
/** @file settings.c
 *  The overrides of rows, and which rows belong together. */
#include "study/parts.h"

#include <math.h>
#include <string.h>

#include "base/number.h"

const char *sph2d__setting(const sph2d_study_run *run, const char *path)
{
    const char *value = NULL;
    for (size_t i = 0; i < run->override_count; ++i)
        if (strcmp(run->overrides[i].path, path) == 0)
            value = run->overrides[i].value;
    return value;
}

/** The number that a value is; NaN when it is none. */
static double number_of(const char *value)
{
    double number = NAN;
    sph2d__c_locale locale;
    if (!sph2d__c_locale_begin(&locale))
        return NAN;
    if (sph2d__number_real(value, &number) != SPH2D__NUMBER_OK)
        number = NAN;
    sph2d__c_locale_end(&locale);
    return number;
}

/** "0.02" and "0.020" are one setting. */
static bool same_value(const char *a, const char *b)
{
    return strcmp(a, b) == 0 || number_of(a) == number_of(b);
}

static bool within(const sph2d_study_run *a, const sph2d_study_run *b, const char *but, bool any)
{
    for (size_t i = 0; i < a->override_count; ++i) {
        const char *path = a->overrides[i].path, *other = sph2d__setting(b, path);
        if (strcmp(path, but) != 0 && (!other || !(any || same_value(sph2d__setting(a, path), other))))
            return false;
    }
    return true;
}

bool sph2d__same_settings(const sph2d_study_run *a, const sph2d_study_run *b, const char *but, bool any)
{
    return within(a, b, but, any) && within(b, a, but, any);
}

double sph2d_study_row_along(const sph2d_study_results *results, const sph2d_study_row *row)
{
    if (!results || !row)
        return NAN;
    const char *along = results->study->along, *value = sph2d__setting(&row->run, along);
    if (strcmp(along, "spacing") == 0)
        return row->record.spacing;
    return value ? number_of(value) : NAN;
}

bool sph2d_study_rows_belong(const sph2d_study_results *results, const sph2d_study_row *a, const sph2d_study_row *b)
{
    if (!results || !a || !b)
        return false;
    return sph2d__same_settings(&a->run, &b->run, results->study->along, false);
}
