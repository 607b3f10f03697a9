/* SPDX-License-Identifier: MIT */
/** @file suggest.c
 *  Finds the nearest word by edit distance. */
#include "base/suggest.h"

#include <stdio.h>
#include <string.h>

/** Longer words are not compared; all keys are shorter. */
enum { MAX_LETTERS = 48 };

static unsigned smaller(unsigned a, unsigned b)
{
    return a < b ? a : b;
}

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c | 0x20) : c;
}

/** Edit distance from `a` to `b` with insertions, deletions, changes and transpositions, ignoring case. */
static unsigned distance(const char *a, const char *b)
{
    size_t n = strlen(a), m = strlen(b);
    if (n > MAX_LETTERS || m > MAX_LETTERS)
        return MAX_LETTERS;
    unsigned rows[3][MAX_LETTERS + 1]; /* of the table of distances of prefixes: before last, last, present */
    unsigned *before = rows[0], *last = rows[1], *now = rows[2];
    for (size_t j = 0; j <= m; ++j)
        last[j] = before[j] = (unsigned)j;
    for (size_t i = 1; i <= n; ++i) {
        now[0] = (unsigned)i;
        for (size_t j = 1; j <= m; ++j) {
            unsigned change = lower(a[i - 1]) != lower(b[j - 1]);
            now[j] = smaller(last[j - 1] + change, smaller(last[j], now[j - 1]) + 1);
            if (i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]))
                now[j] = smaller(now[j], before[j - 2] + 1);
        }
        unsigned *oldest = before;
        before = last;
        last = now;
        now = oldest;
    }
    return last[m];
}

/** Keeps the better of two candidates. */
typedef struct candidate {
    const char *text;
    unsigned distance;
} candidate;

static void update_best(candidate *best, const char *written, const char *known)
{
    unsigned changes = distance(written, known);
    /* up to a third of the letters may differ, but words of one or two letters must not match everything */
    unsigned limit = (unsigned)(strlen(known) < 3 ? 1 : (strlen(known) + 1) / 3);
    if (changes <= limit && changes < strlen(known) && (!best->text || changes < best->distance))
        *best = (candidate){known, changes};
}

/** Appends to a list of words, truncated to its size. */
static void append_word(char *list, size_t size, const char *word)
{
    size_t used = strlen(list);
    snprintf(list + used, size - used, "%s%s", used > 0 ? ", " : "", word);
}

void sph2d__suggest_key(sph2d_diagnostic *diagnostic, const char *name, const sph2d_keys *keys, const sph2d_keys *top,
                        const char *elsewhere)
{
    if (!diagnostic)
        return;
    candidate best = {NULL, 0};
    char list[sizeof diagnostic->hint - 16] = "";
    for (size_t i = 0; i < keys->count; ++i) {
        update_best(&best, name, keys->items[i].name);
        if (keys->items[i].also)
            update_best(&best, name, keys->items[i].also);
        append_word(list, sizeof list, keys->items[i].name);
    }
    if (best.text) {
        sph2d_diagnostic_hint(diagnostic, "did you mean '%s'?", best.text);
        return;
    }
    if (elsewhere[0]) {
        sph2d_diagnostic_hint(diagnostic, "%s", elsewhere);
        return;
    }
    for (size_t i = 0; i < keys->count; ++i) {
        const sph2d_keys *inner = keys->items[i].kind == SPH2D_KEY_GROUP ? keys->items[i].keys : NULL;
        for (size_t k = 0; inner && k < inner->count; ++k)
            if (strcmp(inner->items[k].name, name) == 0) {
                sph2d_diagnostic_hint(diagnostic, "did you mean '%s.%s'?", keys->items[i].name, name);
                return;
            }
    }
    for (size_t i = 0; i < top->count; ++i)
        if (strcmp(top->items[i].name, name) == 0) {
            sph2d_diagnostic_hint(diagnostic, "'%s' is no part of a group: indent it like the first key of the file",
                                  name);
            return;
        }
    sph2d_diagnostic_hint(diagnostic, "keys here: %s", list);
}

void sph2d__suggest_word(sph2d_diagnostic *diagnostic, const char *text, const char *const *words, const char *all)
{
    if (!diagnostic)
        return;
    candidate best = {NULL, 0};
    char list[sizeof diagnostic->hint - 32] = "";
    for (; *words; ++words) {
        update_best(&best, text, *words);
        append_word(list, sizeof list, *words);
    }
    if (best.text)
        sph2d_diagnostic_hint(diagnostic, "did you mean '%s'?", best.text);
    else
        sph2d_diagnostic_hint(diagnostic, "%s: %s", all, list[0] ? list : "none");
}
