/* SPDX-License-Identifier: MIT */
/** @file settings.c
 *  The overrides of rows, names such as "kernel=quintic, spacing=0.02", and which rows belong together. */
#include "study/settings.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/c_locale.h"
#include "base/number.h"

const char *sph2d__key_name(const char *path)
{
    const char *point = strrchr(path, '.');
    return point && point[1] ? point + 1 : path;
}

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
    if (sph2d__number_real(value, &number) != SPH2D__NUMBER_FINE)
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
    const char *along = results->study->along, *value = sph2d__setting(&row->run, along);
    if (strcmp(along, "spacing") == 0)
        return row->record.spacing;
    return value ? number_of(value) : NAN;
}

bool sph2d_study_rows_belong(const sph2d_study_results *results, const sph2d_study_row *a, const sph2d_study_row *b)
{
    return sph2d__same_settings(&a->run, &b->run, results->study->along, false);
}

/* ---- names ------------------------------------------------------------------------------------------------------- */

/** What stands between two settings of a name. */
static const char between[] = ", ";

const char *sph2d__setting_in(const char *name, const char *path, const char *value, size_t *length)
{
    const char *key = sph2d__key_name(path);
    size_t head = strlen(key), tail = strlen(value);
    *length = head + 1 + tail;
    for (const char *at = name; (at = strstr(at, key)) != NULL; ++at) {
        bool begins = at == name || at[-1] == ' ';
        if (!begins || at[head] != '=' || strncmp(at + head + 1, value, tail) != 0)
            continue;
        if (at[*length] == '\0' || at[*length] == ',')
            return at;
    }
    return NULL;
}

/** Writes the name of a row without what it says of a key: "kernel=quintic". False when the name does not list the key
 *  with the row's value, or nothing else. */
static bool write_name_without(const sph2d_study_run *run, const char *path, char *out, size_t size)
{
    const char *value = sph2d__setting(run, path);
    size_t length = 0;
    const char *at = value ? sph2d__setting_in(run->name, path, value, &length) : NULL;
    if (!at || strlen(run->name) == length)
        return false;
    size_t before = (size_t)(at - run->name);
    const char *behind = at + length;
    if (*behind)
        behind += strspn(behind, between);
    else if (before >= strlen(between))
        before -= strlen(between);
    snprintf(out, size, "%.*s%s", (int)before, run->name, behind);
    return true;
}

/** Whether a later override of the same key hides this one. */
static bool is_hidden(const sph2d_study_run *run, size_t override)
{
    for (size_t i = override + 1; i < run->override_count; ++i)
        if (strcmp(run->overrides[i].path, run->overrides[override].path) == 0)
            return true;
    return false;
}

char *sph2d_study_row_label(const sph2d_study_results *results, const sph2d_study_row *row, char *out, size_t size)
{
    const sph2d_study *study = results->study;
    const sph2d_study_run *run = &row->run;
    if (study->vary_count > 0 && write_name_without(run, study->along, out, size))
        return out;
    size_t used = 0;
    for (size_t i = 0; i < run->override_count && used < size; ++i)
        if (strcmp(run->overrides[i].path, study->along) != 0 && !is_hidden(run, i))
            used += (size_t)snprintf(out + used, size - used, "%s%s=%s", used > 0 ? between : "",
                                     sph2d__key_name(run->overrides[i].path), run->overrides[i].value);
    if (used == 0)
        snprintf(out, size, "the scene");
    return out;
}
