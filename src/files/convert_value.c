/* SPDX-License-Identifier: MIT */
/** @file convert_value.c
 *  Conversion of single values to their C types. Ranges are checked by the scene checker, except those of the types. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/number.h"
#include "base/suggest.h"
#include "files/convert.h"
#include "files/quantity.h"

/** What is being converted, for messages. */
typedef struct value {
    sph2d__converter *converter;
    const sph2d_key *key;
    const char *path;
    size_t column; /**< in a tuple */
} value;

static void hint_key(sph2d_diagnostic *diagnostic, const sph2d_key *key)
{
    sph2d_diagnostic_hint(diagnostic, "%s: %s%s%s", key->name, key->text, key->unit[0] ? ", in " : "", key->unit);
}

sph2d_diagnostic *sph2d__convert_wrong_type(sph2d__converter *converter, const sph2d_key *key, const sph2d__node *node,
                                            const char *path, const char *expected)
{
    sph2d__faults_mark_invalid(converter->faults, path);
    if (node->kind == SPH2D__NODE_FAULTY)
        return NULL;
    char got[80];
    sph2d_diagnostic *d = sph2d__fault(converter->faults, SPH2D_CODE_WRONG_TYPE, sph2d__node_place(node), path,
                                       "expected %s, got %s", expected, sph2d__node_describe(node, got, sizeof got));
    hint_key(d, key);
    return d;
}

/** The unit of a column: the units of a tuple stand between commas, unless all have one. */
static const char *unit_of(const sph2d_key *key, size_t column, char out[32])
{
    const char *unit = key->unit;
    for (; column > 0 && strchr(unit, ','); --column)
        unit = strchr(unit, ',') + 2;
    snprintf(out, 32, "%.*s", (int)strcspn(unit, ","), unit);
    return out;
}

static void wrong_number(const value *v, const sph2d__node *node, const char *expected)
{
    sph2d_diagnostic *d = sph2d__convert_wrong_type(v->converter, v->key, node, v->path, expected);
    char unit[32], advice[160];
    double number;
    if (!d || node->kind != SPH2D__NODE_SCALAR)
        return;
    if (node->quoted && sph2d__number_real(node->text, &number) == SPH2D__NUMBER_OK)
        sph2d_diagnostic_hint(d, "write it without quotes: %.40s", node->text);
    else if (v->key->kind != SPH2D_KEY_COUNT && v->key->kind != SPH2D_KEY_COUNTS2 &&
             sph2d__quantity_advice(node->text, unit_of(v->key, v->column, unit), advice, sizeof advice))
        sph2d_diagnostic_hint(d, "%s", advice);
}

/** Reports a value that is not a number, or one that cannot be stored. */
static bool check_number(const value *v, const sph2d__node *node, sph2d__number state, const char *expected)
{
    if (state == SPH2D__NUMBER_OK)
        return true;
    if (state == SPH2D__NUMBER_NONE) {
        wrong_number(v, node, expected);
        return false;
    }
    char got[80], reason[80];
    sph2d__node_describe(node, got, sizeof got);
    if (state == SPH2D__NUMBER_NOT_FINITE)
        snprintf(reason, sizeof reason, "is not a finite number");
    else if (v->key->kind == SPH2D_KEY_COUNT || v->key->kind == SPH2D_KEY_COUNTS2)
        snprintf(reason, sizeof reason, "is out of range: must be at least %g and at most %g", v->key->min,
                 fmin(v->key->max, (double)UINT64_MAX));
    else
        snprintf(reason, sizeof reason, "exceeds the range of a double");
    sph2d__faults *faults = v->converter->faults;
    sph2d_diagnostic *d =
        sph2d__fault(faults, SPH2D_CODE_OUT_OF_RANGE, sph2d__node_place(node), v->path, "%s %s", got, reason);
    hint_key(d, v->key);
    sph2d__faults_mark_invalid(faults, v->path);
    return false;
}

static bool is_plain(const sph2d__node *node)
{
    return node->kind == SPH2D__NODE_SCALAR && !node->quoted;
}

static void read_real(const value *v, const sph2d__node *node, double *out)
{
    double result = 0;
    sph2d__number state = is_plain(node) ? sph2d__number_real(node->text, &result) : SPH2D__NUMBER_NONE;
    if (check_number(v, node, state, "a number"))
        *out = result;
}

static void read_count(const value *v, const sph2d__node *node, uint64_t *out)
{
    uint64_t result = 0;
    sph2d__number state = is_plain(node) ? sph2d__number_count(node->text, &result) : SPH2D__NUMBER_NONE;
    if (check_number(v, node, state, "a whole number"))
        *out = result;
}

/** Whether each of the items is a text of digits and a sign. */
static bool are_whole(const sph2d__node *list)
{
    for (const sph2d__node *child = list->first; child; child = child->next)
        if (child->kind != SPH2D__NODE_SCALAR || child->quoted || !child->text[0] ||
            child->text[strspn(child->text, "+-0123456789")] != '\0')
            return false;
    return true;
}

/** What to write for `1280x720`, `[0,5, 1,5]` and `[0 1]`, where there should be `count` numbers. */
static void hint_tuple(sph2d_diagnostic *d, const sph2d__node *node, size_t count)
{
    static const char digits[] = "0123456789";
    const sph2d__node *first = node->kind == SPH2D__NODE_SEQUENCE ? node->first : NULL;
    const size_t width = strspn(node->text, digits);
    const char *times = node->text + width;
    if (!d || count != 2)
        return;
    if (width > 0 && *times == 'x' && times[1] && times[1 + strspn(times + 1, digits)] == '\0')
        sph2d_diagnostic_hint(d, "write [%.*s, %.20s]", (int)(width < 20 ? width : 20), node->text, times + 1);
    else if (first && node->count == 4 && are_whole(node))
        sph2d_diagnostic_hint(d, "a comma stands between numbers, a point within them: [%.20s.%.20s, %.20s.%.20s]?",
                              first->text, first->next->text, first->next->next->text, node->last->text);
    else if (first && node->count == 1 && first->kind == SPH2D__NODE_SCALAR && strpbrk(first->text, " ;"))
        sph2d_diagnostic_hint(d, "write a comma between the numbers");
}

/** Whether a node is a list of exactly `count` items; reports an error otherwise. */
static bool is_tuple(const value *v, const sph2d__node *node, size_t count, const char *expected)
{
    if (node->kind == SPH2D__NODE_SEQUENCE && node->count == count)
        return true;
    hint_tuple(sph2d__convert_wrong_type(v->converter, v->key, node, v->path, expected), node, count);
    return false;
}

static void read_reals(const value *v, const sph2d__node *node, size_t count, const char *expected, double *out)
{
    if (!is_tuple(v, node, count, expected))
        return;
    value each = *v;
    each.column = 0;
    for (const sph2d__node *child = node->first; child; child = child->next, ++each.column)
        read_real(&each, child, &out[each.column]);
}

/** Reads a list of tuples of `width` doubles; a width of 1 is a list of numbers. The item types of points and paths are
 *  structs of doubles without padding. */
static void read_tuples(const value *v, const sph2d__node *node, size_t width, const char *expected, void *out)
{
    _Static_assert(sizeof(sph2d_vec2) == 2 * sizeof(double), "points are read as doubles");
    _Static_assert(sizeof(sph2d_path_point) == 3 * sizeof(double), "path points are read as doubles");
    if (node->kind != SPH2D__NODE_SEQUENCE) {
        char list[64];
        snprintf(list, sizeof list, "a list of %ss", expected);
        sph2d__convert_wrong_type(v->converter, v->key, node, v->path, list);
        return;
    }
    double *items = sph2d__pool_alloc(v->converter->pool, node->count, width * sizeof *items);
    if (!items) {
        v->converter->faults->short_of_memory = true;
        return;
    }
    char one[64];
    snprintf(one, sizeof one, "a %s", expected);
    size_t i = 0;
    for (const sph2d__node *child = node->first; child; child = child->next, ++i) {
        if (width == 1)
            read_real(v, child, &items[i]);
        else
            read_reals(v, child, width, one, items + i * width);
    }
    memcpy((char *)out + v->key->offset, &items, sizeof items);
    memcpy((char *)out + v->key->count_offset, &node->count, sizeof node->count);
}

/** Reads a list of [t, x, y] or [t, x, y, angle]; an angle that is not given is 0. */
static void read_poses(const value *v, const sph2d__node *node, void *out)
{
    const char *expected = "point [t, x, y] or [t, x, y, angle]";
    if (node->kind != SPH2D__NODE_SEQUENCE) {
        char list[64];
        snprintf(list, sizeof list, "a list of %s", expected);
        sph2d__convert_wrong_type(v->converter, v->key, node, v->path, list);
        return;
    }
    sph2d_pose_point *items = sph2d__pool_alloc(v->converter->pool, node->count, sizeof *items);
    if (!items) {
        v->converter->faults->short_of_memory = true;
        return;
    }
    char one[64];
    snprintf(one, sizeof one, "a %s", expected);
    size_t i = 0;
    for (const sph2d__node *child = node->first; child; child = child->next, ++i) {
        bool turned = child->kind == SPH2D__NODE_SEQUENCE && child->count == 4;
        items[i] = (sph2d_pose_point){0};
        read_reals(v, child, turned ? 4 : 3, one, &items[i].t);
    }
    memcpy((char *)out + v->key->offset, &items, sizeof items);
    memcpy((char *)out + v->key->count_offset, &node->count, sizeof node->count);
}

static void read_text(const value *v, const sph2d__node *node, void *slot)
{
    if (node->kind != SPH2D__NODE_SCALAR || sph2d__node_is_null(node))
        sph2d_diagnostic_hint(sph2d__convert_wrong_type(v->converter, v->key, node, v->path, "a text"),
                              "write a text; one that begins with #, which begins a comment, in quotation marks");
    else
        memcpy(slot, &node->text, sizeof node->text);
}

static void read_word(const value *v, const sph2d__node *node, void *slot)
{
    const char *const *words = v->key->words;
    int index = 0;
    if (node->kind == SPH2D__NODE_SCALAR) {
        while (words[index] && strcmp(words[index], node->text) != 0)
            ++index;
        if (words[index]) {
            memcpy(slot, &index, sizeof index);
            return;
        }
    }
    if (node->kind != SPH2D__NODE_SCALAR || sph2d__node_is_null(node)) {
        sph2d__convert_wrong_type(v->converter, v->key, node, v->path, "a word");
        return;
    }
    char got[80];
    sph2d__faults *faults = v->converter->faults;
    sph2d_diagnostic *d = sph2d__fault(faults, SPH2D_CODE_WRONG_TYPE, sph2d__node_place(node), v->path,
                                       "unknown value %s", sph2d__node_describe(node, got, sizeof got));
    sph2d__suggest_word(d, node->text, words, "one of");
    sph2d__faults_mark_invalid(faults, v->path);
}

void sph2d__convert_value(sph2d__converter *converter, const sph2d_key *key, const sph2d__node *node, const char *path,
                          void *out)
{
    value v = {converter, key, path, 0};
    void *slot = (char *)out + key->offset;
    switch (key->kind) {
    case SPH2D_KEY_NUMBER:
        read_real(&v, node, slot);
        break;
    case SPH2D_KEY_COUNT:
        read_count(&v, node, slot);
        break;
    case SPH2D_KEY_COUNTS2:
        if (is_tuple(&v, node, 2, "two whole numbers [a, b]")) {
            read_count(&v, node->first, slot);
            read_count(&v, node->last, (uint64_t *)slot + 1);
        }
        break;
    case SPH2D_KEY_TEXT:
        read_text(&v, node, slot);
        break;
    case SPH2D_KEY_WORD:
        read_word(&v, node, slot);
        break;
    case SPH2D_KEY_POINT:
        read_reals(&v, node, 2, "two numbers [x, y]", slot);
        break;
    case SPH2D_KEY_POINTS:
        read_tuples(&v, node, 2, "point [x, y]", out);
        break;
    case SPH2D_KEY_PATH:
        read_tuples(&v, node, 3, "point [t, x, y]", out);
        break;
    case SPH2D_KEY_POSES:
        read_poses(&v, node, out);
        break;
    case SPH2D_KEY_NUMBERS:
        read_tuples(&v, node, 1, "number", out);
        break;
    case SPH2D_KEY_GROUP:
    case SPH2D_KEY_LIST:
        break;
    }
}
