/* SPDX-License-Identifier: MIT */
/** @file check_ranges.c
 *  Checks the range of every number, every word and every list by the key table. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/null.h"
#include "scene/checker.h"
#include "sph2d/key.h"

enum { PATH_SIZE = SPH2D__PATH_SIZE };

typedef struct checker {
    sph2d_report *report;
    bool faulty; /**< something was reported */
    bool broken; /**< a list cannot be read */
} checker;

bool sph2d_key_accepts(const sph2d_key *key, double value, char *why, size_t size)
{
    if (!key)
        return false;
    if (!why)
        size = 0;
    if ((key->zero_is_unset && value == 0) || (key->nan_is_unset && isnan(value)))
        return true;
    if (isfinite(value) && value >= key->min && value <= key->max && !(key->min_excluded && value == key->min))
        return true;
    bool positive = key->min == SPH2D_SMALLEST && key->max == SPH2D_LARGEST, tiny = positive && value > 0;
    bool above = key->min_excluded || (positive && !tiny);
    double least = above ? 0 : key->min;
    const char *word = above ? "above" : "at least";
    if (!isfinite(value))
        snprintf(why, size, "%g is not a finite number", value);
    else if (key->max == INFINITY || (above && value <= 0))
        snprintf(why, size, "%g is out of range: must be %s %g", value, word, least);
    else if (tiny || fabs(value) > SPH2D_LARGEST)
        snprintf(why, size, "%g is out of range: must be %s %g and at most %g, as scenes are tested there", value, word,
                 least, key->max);
    else
        snprintf(why, size, "%g is out of range: must be %s %g and at most %g", value, word, least, key->max);
    return false;
}

static sph2d_diagnostic *fault(checker *c, sph2d_code code, const char *path, const char *message)
{
    c->faulty = true;
    return sph2d_report_add(c->report, SPH2D_ERROR, code, path, "%s", message);
}

static void check_number(checker *c, const sph2d_key *key, const char *path, double value)
{
    char message[160];
    if (sph2d_key_accepts(key, value, message, sizeof message))
        return;
    sph2d_diagnostic *d = fault(c, SPH2D_CODE_OUT_OF_RANGE, path, message);
    sph2d_diagnostic_hint(d, "%s: %s%s%s", key->name, key->text, key->unit[0] ? ", in " : "", key->unit);
}

static void check_numbers(checker *c, const sph2d_key *key, const char *path, const double *values, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        check_number(c, key, path, values[i]);
}

static void check_word(checker *c, const sph2d_key *key, const char *path, int value)
{
    int count = 0;
    while (key->words[count])
        ++count;
    if (value < 0 || value >= count)
        fault(c, SPH2D_CODE_OUT_OF_RANGE, path, "unknown value");
}

static void check_struct(checker *c, const sph2d_keys *keys, const char *base, const char *prefix);

static void check_key(checker *c, const sph2d_key *key, const char *base, const char *path)
{
    const char *slot = base + key->offset;
    size_t count = key->count_offset ? *(const size_t *)(const void *)(base + key->count_offset) : 0;
    const void *items = NULL;
    if (key->count_offset)
        memcpy(&items, slot, sizeof items);
    if (count > 0 && !items) {
        fault(c, SPH2D_CODE_CONFLICT, path, "a count above 0 with a NULL list");
        c->broken = true;
        return;
    }
    switch (key->kind) {
    case SPH2D_KEY_NUMBER:
        check_numbers(c, key, path, (const double *)(const void *)slot, 1);
        break;
    case SPH2D_KEY_POINT:
        check_numbers(c, key, path, (const double *)(const void *)slot, 2);
        break;
    case SPH2D_KEY_COUNT:
        check_number(c, key, path, (double)*(const uint64_t *)(const void *)slot);
        break;
    case SPH2D_KEY_COUNTS2:
        check_number(c, key, path, (double)((const uint64_t *)(const void *)slot)[0]);
        check_number(c, key, path, (double)((const uint64_t *)(const void *)slot)[1]);
        break;
    case SPH2D_KEY_WORD:
        check_word(c, key, path, *(const int *)(const void *)slot);
        break;
    case SPH2D_KEY_POINTS:
        check_numbers(c, key, path, items, 2 * count);
        break;
    case SPH2D_KEY_PATH:
        check_numbers(c, key, path, items, 3 * count);
        break;
    case SPH2D_KEY_POSES:
        check_numbers(c, key, path, items, 4 * count);
        break;
    case SPH2D_KEY_NUMBERS:
        check_numbers(c, key, path, items, count);
        break;
    case SPH2D_KEY_GROUP:
        check_struct(c, key->keys, slot, path);
        break;
    case SPH2D_KEY_LIST:
        for (size_t i = 0; i < count; ++i) {
            char item[PATH_SIZE];
            check_struct(c, key->keys, (const char *)items + i * key->keys->size, sph2d__check_path(item, path, i, ""));
        }
        break;
    case SPH2D_KEY_TEXT:
        break;
    }
}

static void check_struct(checker *c, const sph2d_keys *keys, const char *base, const char *prefix)
{
    for (size_t k = 0; k < keys->count; ++k) {
        const sph2d_key *key = &keys->items[k];
        if (key->choice && *(const int *)(const void *)(base + key->choice_offset) != key->choice)
            continue;
        char path[PATH_SIZE];
        snprintf(path, sizeof path, "%s%s%s", prefix, prefix[0] ? "." : "", key->name);
        check_key(c, key, base, path);
    }
}

sph2d_status sph2d_keys_check(const sph2d_keys *keys, const void *owner, sph2d_report *report)
{
    if (!keys)
        return sph2d__null(report, __func__, "keys");
    if (!owner)
        return sph2d__null(report, __func__, "owner");
    checker c = {report, false, false};
    check_struct(&c, keys, owner, "");
    return c.broken ? SPH2D_INVALID : c.faulty ? SPH2D_SCENE : SPH2D_OK;
}

void sph2d__check_ranges(sph2d__checker *c)
{
    sph2d_status status = sph2d_keys_check(sph2d_scene_keys(), c->scene, c->report);
    c->errors += status != SPH2D_OK;
    c->broken = status == SPH2D_INVALID;
}
