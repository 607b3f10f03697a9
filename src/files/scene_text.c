/* SPDX-License-Identifier: MIT */
/** @file scene_text.c
 *  A scene back into YAML, by the table of keys. There is no code for any single key. */
#include <ctype.h>
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/c_locale.h"
#include "sph2d/io.h"
#include "sph2d/key.h"

/** Bytes of the largest group with a preset. */
enum { MOST_PRESET = 256 };

/** Text that is written as far as there is room, and counted. */
typedef struct pen {
    char *out;
    size_t size, used;
    bool failed; /**< memory was short */
} pen;

/** Where lines go. In a list's item `lead` stands before each key: "- " before the first, then "  ". */
typedef struct margin {
    int indent;
    const char *lead;
} margin;

static void put(pen *p, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void put(pen *p, const char *format, ...)
{
    bool room = p->used < p->size;
    va_list values;
    va_start(values, format);
    int length = vsnprintf(room ? p->out + p->used : NULL, room ? p->size - p->used : 0, format, values);
    va_end(values);
    p->used += length > 0 ? (size_t)length : 0;
}

/* ---- values ------------------------------------------------------------------------------------------------------ */

/** The shortest digits that give the same double again. */
static void put_number(pen *p, double value)
{
    char digits[40];
    for (int precision = 15; precision <= 17; ++precision) {
        snprintf(digits, sizeof digits, "%.*g", precision, value);
        if (strtod(digits, NULL) == value)
            break;
    }
    put(p, "%s", digits);
}

/** Whether YAML reads it as this text and nothing else. */
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

static void put_text(pen *p, const char *text)
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
static void put_tuple(pen *p, const double *values, size_t count)
{
    put(p, "[");
    for (size_t i = 0; i < count; ++i) {
        put(p, "%s", i > 0 ? ", " : "");
        put_number(p, values[i]);
    }
    put(p, "]");
}

static void put_tuples(pen *p, const double *values, size_t count, size_t width)
{
    put(p, "[");
    for (size_t i = 0; i < count; ++i) {
        put(p, "%s", i > 0 ? ", " : "");
        put_tuple(p, values + i * width, width);
    }
    put(p, "]");
}

/** What a slot of a list kind points at. */
static const void *pointed(const sph2d_key *key, const char *owner, size_t *count)
{
    const void *items;
    memcpy(&items, owner + key->offset, sizeof items);
    memcpy(count, owner + key->count_offset, sizeof *count);
    return items;
}

/** The value of one key on one line. */
static void put_value(pen *p, const sph2d_key *key, const char *owner)
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
        put_text(p, text);
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
    case SPH2D_KEY_GROUP:
    case SPH2D_KEY_LIST:
        break;
    }
}

/* ---- which keys -------------------------------------------------------------------------------------------------- */

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

/** What a group has by default, with what a word in it presets: room for it in `out`, of `size` bytes; NULL when that
 *  is no other. */
static const char *preset_of(const sph2d_keys *keys, const char *owner, const char *standard, char *out, size_t size)
{
    for (size_t i = 0; i < keys->count && keys->size <= size; ++i) {
        const sph2d_key *key = &keys->items[i];
        if (!key->preset || memcmp(owner + key->offset, standard + key->offset, sizeof(int)) == 0)
            continue;
        memcpy(out, standard, keys->size);
        memcpy(out + key->offset, owner + key->offset, sizeof(int));
        key->preset(out);
        return out;
    }
    return NULL;
}

static bool differs(const sph2d_key *key, const char *owner, const char *standard);

static bool group_differs(const sph2d_key *group, const char *owner, const char *standard)
{
    for (size_t i = 0; i < group->keys->count; ++i)
        if (differs(&group->keys->items[i], owner + group->offset, standard + group->offset))
            return true;
    return false;
}

static bool text_differs(const sph2d_key *key, const char *owner, const char *standard)
{
    const char *text, *usual;
    memcpy(&text, owner + key->offset, sizeof text);
    memcpy(&usual, standard + key->offset, sizeof usual);
    return text && (!usual || strcmp(text, usual) != 0);
}

/** Whether a key of a choice is not the one that is taken. */
static bool is_passed_over(const sph2d_key *key, const char *owner)
{
    int choice = 0;
    if (key->choice)
        memcpy(&choice, owner + key->choice_offset, sizeof choice);
    return choice != key->choice;
}

/** Whether a value is not the one in `standard`, the owner with its defaults. What is taken of a choice always is. */
static bool differs(const sph2d_key *key, const char *owner, const char *standard)
{
    size_t count = 0;
    if (is_passed_over(key, owner))
        return false;
    if (key->choice)
        return true;
    switch (key->kind) {
    case SPH2D_KEY_GROUP:
        return group_differs(key, owner, standard);
    case SPH2D_KEY_TEXT:
        return text_differs(key, owner, standard);
    case SPH2D_KEY_POINTS:
    case SPH2D_KEY_PATH:
    case SPH2D_KEY_NUMBERS:
    case SPH2D_KEY_LIST:
        return pointed(key, owner, &count) && count > 0;
    default:
        return memcmp(owner + key->offset, standard + key->offset, size_of(key->kind)) != 0;
    }
}

/* ---- lines ------------------------------------------------------------------------------------------------------- */

static void put_struct(pen *p, const sph2d_keys *keys, const char *owner, const char *standard, margin m);

static void put_items(pen *p, const sph2d_key *key, const char *owner, int indent)
{
    size_t count;
    const char *items = pointed(key, owner, &count);
    char *standard = calloc(1, key->keys->size);
    p->failed |= !standard;
    if (!standard)
        return;
    if (key->keys->set_default)
        key->keys->set_default(standard);
    for (size_t i = 0; i < count; ++i)
        put_struct(p, key->keys, items + i * key->keys->size, standard, (margin){indent, "- "});
    free(standard);
}

static void put_struct(pen *p, const sph2d_keys *keys, const char *owner, const char *standard, margin m)
{
    _Alignas(max_align_t) char room[MOST_PRESET];
    const char *preset = preset_of(keys, owner, standard, room, sizeof room);
    for (size_t i = 0; i < keys->count; ++i) {
        const sph2d_key *key = &keys->items[i];
        bool needed = (key->required && !is_passed_over(key, owner)) || (preset && key->preset);
        if (!needed && !differs(key, owner, preset ? preset : standard))
            continue;
        int inside = m.indent + (int)strlen(m.lead) + 2;
        put(p, "%*s%s%s:", m.indent, "", m.lead, key->name);
        if (m.lead[0])
            m.lead = "  ";
        if (key->kind == SPH2D_KEY_GROUP) {
            put(p, "\n");
            put_struct(p, key->keys, owner + key->offset, standard + key->offset, (margin){inside, ""});
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
    pen p = {out, out ? size : 0, 0, false};
    sph2d_scene standard = sph2d_scene_default();
    sph2d__c_locale locale;
    if (!scene || !sph2d__c_locale_begin(&locale))
        return 0;
    if (p.size > 0)
        out[0] = '\0';
    put_struct(&p, sph2d_scene_keys(), (const char *)scene, (const char *)&standard, (margin){0, ""});
    sph2d__c_locale_end(&locale);
    return p.failed ? 0 : p.used;
}
