/* SPDX-License-Identifier: MIT */
/** @file study_settings.c
 *  The overrides of rows, and names such as "kernel=quintic, spacing=0.02". */
#include "study_settings.h"

#include <stdio.h>
#include <string.h>

#include "../parse.h"

const char *study_key(const char *path)
{
    const char *point = strrchr(path, '.');
    return point != NULL && point[1] != '\0' ? point + 1 : path;
}

const char *study_setting(const sph2d_study_run *run, const char *path)
{
    const char *value = NULL;
    for (size_t i = 0; i < run->override_count; ++i)
        if (strcmp(run->overrides[i].path, path) == 0)
            value = run->overrides[i].value;
    return value;
}

/* "0.02" and "0.020" are one setting. */
static bool same_value(const char *a, const char *b)
{
    double x, y;
    return strcmp(a, b) == 0 || (parse_number(a, &x) && parse_number(b, &y) && x == y);
}

static bool settings_within(const sph2d_study_run *a, const sph2d_study_run *b, const char *but)
{
    for (size_t i = 0; i < a->override_count; ++i) {
        const char *path = a->overrides[i].path, *other = study_setting(b, path);
        if (strcmp(path, but) != 0 && (other == NULL || !same_value(study_setting(a, path), other)))
            return false;
    }
    return true;
}

bool study_same_but(const char *key, const sph2d_study_run *a, const sph2d_study_run *b)
{
    return settings_within(a, b, key) && settings_within(b, a, key);
}

/* What stands between two settings of a name. */
static const char between[] = ", ";

const char *study_setting_in(const char *name, const char *path, const char *value, size_t *length)
{
    const char *key = study_key(path);
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

char *study_name_without(const sph2d_study_run *run, const char *path, char *out, size_t size)
{
    const char *value = study_setting(run, path);
    size_t length = 0;
    const char *at = value != NULL ? study_setting_in(run->name, path, value, &length) : NULL;
    if (at == NULL || strlen(run->name) == length)
        return NULL;
    size_t before = (size_t)(at - run->name);
    const char *behind = at + length;
    if (*behind != '\0')
        behind += strspn(behind, between);
    else if (before >= strlen(between))
        before -= strlen(between);
    snprintf(out, size, "%.*s%s", (int)before, run->name, behind);
    return out;
}
