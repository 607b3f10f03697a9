/* SPDX-License-Identifier: MIT */
/** @file dictionary.c
 *  The words, from the tables that the readers use. */
#include "dictionary.h"

#include <sph2d/key.h>
#include <sph2d/study.h>

enum { MAX_WORDS = 2048, MAX_DEPTH = 8 };

static const char *const numbers[] = {
    "0",
    "-0.0",
    "1",
    "-1",
    "2",
    "3",
    "0.5",
    "0.3333333333333333",
    "10",
    "100",
    "1000",
    "10000",
    "110946",
    "0.01",
    "0.001",
    "1e-6",
    "1e-12",
    "1e-300",
    "5e-324",
    "1e6",
    "1e9",
    "1e16",
    "1e300",
    "-1e300",
    "1.7976931348623157e308",
    "1e999",
    "-1e999",
    "1e-999",
    "nan",
    ".nan",
    "inf",
    ".inf",
    "-.inf",
    "2147483647",
    "2147483648",
    "4294967296",
    "9007199254740993",
    "18446744073709551615",
    "18446744073709551616",
    "99999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999999",
    "0.00000000000000000000000000000000000000000000000000000000000000000000000000000000000000000000001",
    "0x1p-1074",
    "0x10",
    "010",
    "1_000",
    "1e",
    "+1",
    ".",
};
enum { NUMBERS = sizeof numbers / sizeof *numbers };

static const char *const signs[] = {
    "\n",
    "\r",
    "\t",
    "  ",
    ": ",
    "- ",
    "?",
    "[",
    "]",
    "{",
    "}",
    ",",
    "#",
    "'",
    "\"",
    "|\n",
    ">\n",
    "---\n",
    "...\n",
    "%YAML 1.2\n",
    "&a ",
    "*a",
    "!!str ",
    "!x ",
    "<<: ",
    "[]",
    "{}",
    "~",
    "null",
    "true",
    "\\x",
    "\xff",
    "\xc0\x80",
    "\xe2\x80\xa8",
    "\xef\xbb\xbf",
    "[0]",
    "[0, 0]",
    "[[0, 0], [1, 1]]",
    "{min: [0, 0], max: [1, 1]}",
};
enum { SIGNS = sizeof signs / sizeof *signs };

static const char *words[MAX_WORDS];
static size_t word_count;

static void add(const char *word)
{
    if (word_count < MAX_WORDS)
        words[word_count++] = word;
}

static void add_keys(const sph2d_keys *keys, unsigned depth)
{
    for (size_t i = 0; i < keys->count && depth < MAX_DEPTH; ++i) {
        const sph2d_key *key = &keys->items[i];
        add(key->name);
        for (size_t k = 0; key->words && key->words[k]; ++k)
            add(key->words[k]);
        if (key->keys)
            add_keys(key->keys, depth + 1);
    }
}

void dictionary_make(void)
{
    for (size_t i = 0; i < SIGNS; ++i)
        add(signs[i]);
    add_keys(sph2d_scene_keys(), 0);
    add_keys(sph2d_study_keys(), 0);
}

const char *dictionary_number(size_t index)
{
    return numbers[index % NUMBERS];
}

const char *dictionary_word(size_t index)
{
    return words[index % word_count];
}
