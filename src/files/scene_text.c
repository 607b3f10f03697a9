/* SPDX-License-Identifier: MIT */
/** @file scene_text.c
 *  Writes a scene as YAML by the table of keys; no key has code of its own. */
#include <ctype.h>
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/number.h"
#include "sph2d/io.h"
#include "sph2d/key.h"

/** Maximum bytes of a group with a preset. */
enum { MAX_PRESET = 256 };

/** An output buffer that keeps counting when it is full, like snprintf. */
typedef struct output {
    char *out;
    size_t size, used;
    bool failed; /**< memory was short */
} output;

/** Indentation of lines. In a list item `lead` precedes each key: "- " the first, then "  ". */
typedef struct margin {
    int indent;
    const char *lead;
} margin;

static void put(output *p, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void put(output *p, const char *format, ...)
{
    bool has_space = p->used < p->size;
    va_list values;
    va_start(values, format);
    int length = vsnprintf(has_space ? p->out + p->used : NULL, has_space ? p->size - p->used : 0, format, values);
    va_end(values);
    p->used += length > 0 ? (size_t)length : 0;
}

/* ---- values ------------------------------------------------------------------------------------------------------ */

/** Writes the shortest digits that read back as the same double. */
static void put_number(output *p, double value)
{
    char digits[40];
    for (int precision = 15; precision <= 17; ++precision) {
        snprintf(digits, sizeof digits, "%.*g", precision, value);
        if (strtod(digits, NULL) == value)
            break;
    }
    put(p, "%s", digits);
}

/** Whether YAML reads the unquoted text as this text. */
static bool is_plain(const char *text)
{
    static const char *const others[] = {"true", "false", "null", "yes", "no", "on", "off", "y", "n", "nan", "inf"};
    char lower[8] = "";
    size_t length = strlen(text);
    for (size_t i = 0; i < length; ++i)
        if (!isalnum((unsigned char)text[i]) && text[i] != '_')
            return false;
    for (size_t i = 0; i < length && i + 1 < sizeof lower; ++i)
        lower[i] = (char)tolower((unsigned char)text[i]);
    for (size_t i = 0; i < sizeof others / sizeof *others; ++i)
        if (strcmp(lower, others[i]) == 0)
            return false;
    return isalpha((unsigned char)text[0]) != 0;
}

static void put_text(output *p, const char *text)
{
    if (is_plain(text)) {
        put(p, "%s", text);
        return;
    }
    put(p, "\"");
    for (; *text; ++text) {
        unsigned char c = (unsigned char)*text;
        if (c < 0x20 || c == 0x7f)
            put(p, "\\x%02X", c);
        else
            put(p, "%s%c", c == '"' || c == '\\' ? "\\" : "", c);
    }
    put(p, "\"");
}

/** [1, 2], or of tuples [[1, 2], [3, 4]]. */
static void put_tuple(output *p, const double *values, size_t count)
{
    put(p, "[");
    for (size_t i = 0; i < count; ++i) {
        put(p, "%s", i > 0 ? ", " : "");
        put_number(p, values[i]);
    }
    put(p, "]");
}

static void put_tuples(output *p, const double *values, size_t count, size_t width)
{
    put(p, "[");
    for (size_t i = 0; i < count; ++i) {
        put(p, "%s", i > 0 ? ", " : "");
        put_tuple(p, values + i * width, width);
    }
    put(p, "]");
}

/** [[t, x, y], ...], or with angles [[t, x, y, angle], ...]. */
static void put_poses(output *p, const sph2d_pose_point *points, size_t count)
{
    bool turns = false;
    for (size_t i = 0; i < count; ++i)
        turns = turns || points[i].angle != 0;
    put(p, "[");
    for (size_t i = 0; i < count; ++i) {
        put(p, "%s", i > 0 ? ", " : "");
        put_tuple(p, &points[i].t, turns ? 4 : 3);
    }
    put(p, "]");
}

/** The items and the count of a list key. */
static const void *pointed(const sph2d_key *key, const char *owner, size_t *count)
{
    const void *items;
    memcpy(&items, owner + key->offset, sizeof items);
    memcpy(count, owner + key->count_offset, sizeof *count);
    return items;
}

/** Writes the value of one key on one line. */
static void put_value(output *p, const sph2d_key *key, const char *owner)
{
    const void *slot = owner + key->offset;
    double numbers[2];
    uint64_t counts[2];
    const char *text;
    int word;
    size_t count;
    switch (key->kind) {
    case SPH2D_KEY_NUMBER:
        memcpy(numbers, slot, sizeof *numbers);
        put_number(p, numbers[0]);
        break;
    case SPH2D_KEY_COUNT:
        memcpy(counts, slot, sizeof *counts);
        put(p, "%" PRIu64, counts[0]);
        break;
    case SPH2D_KEY_COUNTS2:
        memcpy(counts, slot, sizeof counts);
        put(p, "[%" PRIu64 ", %" PRIu64 "]", counts[0], counts[1]);
        break;
    case SPH2D_KEY_WORD:
        memcpy(&word, slot, sizeof word);
        put(p, "%s", key->words[word]);
        break;
    case SPH2D_KEY_TEXT:
        memcpy(&text, slot, sizeof text);
        put_text(p, text ? text : "");
        break;
    case SPH2D_KEY_POINT:
        memcpy(numbers, slot, sizeof numbers);
        put_tuple(p, numbers, 2);
        break;
    case SPH2D_KEY_NUMBERS: {
        const double *values = pointed(key, owner, &count);
        put_tuple(p, values, count);
        break;
    }
    case SPH2D_KEY_POINTS:
    case SPH2D_KEY_PATH: {
        const double *values = pointed(key, owner, &count);
        put_tuples(p, values, count, key->kind == SPH2D_KEY_PATH ? 3 : 2);
        break;
    }
    case SPH2D_KEY_POSES: {
        const sph2d_pose_point *points = pointed(key, owner, &count);
        put_poses(p, points, count);
        break;
    }
    case SPH2D_KEY_GROUP:
    case SPH2D_KEY_LIST:
        break;
    }
}

/* ---- keys that differ from their defaults ------------------------------------------------------------------------ */

static size_t size_of(sph2d_key_kind kind)
{
    switch (kind) {
    case SPH2D_KEY_NUMBER:
        return sizeof(double);
    case SPH2D_KEY_COUNT:
        return sizeof(uint64_t);
    case SPH2D_KEY_COUNTS2:
        return 2 * sizeof(uint64_t);
    case SPH2D_KEY_WORD:
        return sizeof(int);
    case SPH2D_KEY_POINT:
        return sizeof(sph2d_vec2);
    default:
        return 0;
    }
}

/** The defaults of a group after the preset by one of its words, in the buffer `out` of `size` bytes; NULL without such
 *  a preset. */
static const char *preset_of(const sph2d_keys *keys, const char *owner, const char *defaults, char *out, size_t size)
{
    for (size_t i = 0; i < keys->count && keys->size <= size; ++i) {
        const sph2d_key *key = &keys->items[i];
        if (!key->preset || memcmp(owner + key->offset, defaults + key->offset, sizeof(int)) == 0)
            continue;
        memcpy(out, defaults, keys->size);
        memcpy(out + key->offset, owner + key->offset, sizeof(int));
        key->preset(out);
        return out;
    }
    return NULL;
}

static bool differs(const sph2d_key *key, const char *owner, const char *defaults);

static bool group_differs(const sph2d_key *group, const char *owner, const char *defaults)
{
    for (size_t i = 0; i < group->keys->count; ++i)
        if (differs(&group->keys->items[i], owner + group->offset, defaults + group->offset))
            return true;
    return false;
}

static bool text_differs(const sph2d_key *key, const char *owner, const char *defaults)
{
    const char *text, *default_text;
    memcpy(&text, owner + key->offset, sizeof text);
    memcpy(&default_text, defaults + key->offset, sizeof default_text);
    return text && (!default_text || strcmp(text, default_text) != 0);
}

/** Whether a key belongs to a choice, but is not the chosen one. */
static bool is_not_chosen(const sph2d_key *key, const char *owner)
{
    int choice = 0;
    if (key->choice)
        memcpy(&choice, owner + key->choice_offset, sizeof choice);
    return choice != key->choice;
}

/** Whether a value differs from that of `defaults`. A chosen key always counts as different. */
static bool differs(const sph2d_key *key, const char *owner, const char *defaults)
{
    size_t count = 0;
    if (is_not_chosen(key, owner))
        return false;
    if (key->choice)
        return true;
    switch (key->kind) {
    case SPH2D_KEY_GROUP:
        return group_differs(key, owner, defaults);
    case SPH2D_KEY_TEXT:
        return text_differs(key, owner, defaults);
    case SPH2D_KEY_POINTS:
    case SPH2D_KEY_PATH:
    case SPH2D_KEY_POSES:
    case SPH2D_KEY_NUMBERS:
    case SPH2D_KEY_LIST:
        return pointed(key, owner, &count) && count > 0;
    default:
        return memcmp(owner + key->offset, defaults + key->offset, size_of(key->kind)) != 0;
    }
}

/* ---- lines ------------------------------------------------------------------------------------------------------- */

static void put_struct(output *p, const sph2d_keys *keys, const char *owner, const char *defaults, margin m);

static void put_items(output *p, const sph2d_key *key, const char *owner, int indent)
{
    size_t count;
    const char *items = pointed(key, owner, &count);
    char *defaults = calloc(1, key->keys->size);
    p->failed |= !defaults;
    if (!defaults)
        return;
    if (key->keys->set_default)
        key->keys->set_default(defaults);
    for (size_t i = 0; i < count; ++i)
        put_struct(p, key->keys, items + i * key->keys->size, defaults, (margin){indent, "- "});
    free(defaults);
}

static void put_struct(output *p, const sph2d_keys *keys, const char *owner, const char *defaults, margin m)
{
    _Alignas(max_align_t) char buffer[MAX_PRESET];
    const char *preset = preset_of(keys, owner, defaults, buffer, sizeof buffer);
    for (size_t i = 0; i < keys->count; ++i) {
        const sph2d_key *key = &keys->items[i];
        bool needed = (key->required && !is_not_chosen(key, owner)) || (preset && key->preset);
        if (!needed && !differs(key, owner, preset ? preset : defaults))
            continue;
        int inside = m.indent + (int)strlen(m.lead) + 2;
        put(p, "%*s%s%s:", m.indent, "", m.lead, key->name);
        if (m.lead[0])
            m.lead = "  ";
        if (key->kind == SPH2D_KEY_GROUP) {
            put(p, "\n");
            put_struct(p, key->keys, owner + key->offset, defaults + key->offset, (margin){inside, ""});
        } else if (key->kind == SPH2D_KEY_LIST) {
            put(p, "\n");
            put_items(p, key, owner, inside);
        } else {
            put(p, " ");
            put_value(p, key, owner);
            put(p, "\n");
        }
    }
}

size_t sph2d_scene_text(const sph2d_scene *scene, char *out, size_t size)
{
    output p = {out, out ? size : 0, 0, false};
    sph2d_scene defaults = sph2d_scene_default();
    sph2d__c_locale locale;
    if (!scene || !sph2d__c_locale_begin(&locale))
        return 0;
    if (p.size > 0)
        out[0] = '\0';
    put_struct(&p, sph2d_scene_keys(), (const char *)scene, (const char *)&defaults, (margin){0, ""});
    sph2d__c_locale_end(&locale);
    return p.failed ? 0 : p.used;
}
