/* SPDX-License-Identifier: MIT */
/** @file mutate.c
 *  The changes: of bits and bytes, of ranges, and in text of numbers, words and lines. */
#include "mutate.h"

#include <ctype.h>
#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "dictionary.h"

typedef struct work {
    const mutate_bytes *files;
    size_t file_count;
    uint64_t random;
    mutate_bytes *out;
} work;

/** A number below `below`, which is above 0 (splitmix64, Steele et al. 2014). */
static size_t draw(work *w, size_t below)
{
    uint64_t z = w->random += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ z >> 30) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ z >> 27) * UINT64_C(0x94d049bb133111eb);
    return (size_t)((z ^ z >> 31) % below);
}

/** A place in the input, its end included. */
static size_t place(work *w)
{
    return draw(w, w->out->size + 1);
}

/** Puts `size` bytes, of another buffer, in the place of `gone` at `at`, as far as there is room. */
static void put(work *w, size_t at, size_t gone, const void *bytes, size_t size)
{
    mutate_bytes *o = w->out;
    gone = gone < o->size - at ? gone : o->size - at;
    if (o->size - gone + size > MUTATE_MAX)
        return;
    memmove(o->bytes + at + size, o->bytes + at + gone, o->size - at - gone);
    memcpy(o->bytes + at, bytes, size);
    o->size = o->size - gone + size;
}

/* ---- any bytes --------------------------------------------------------------------------------------------------- */

static void flip_bit(work *w)
{
    w->out->bytes[draw(w, w->out->size)] ^= (unsigned char)(1u << draw(w, 8));
}

static void set_byte(work *w)
{
    static const unsigned char odd[] = {0, 1, 0x7f, 0x80, 0xff, '\n'};
    w->out->bytes[draw(w, w->out->size)] = draw(w, 2) ? odd[draw(w, sizeof odd)] : (unsigned char)draw(w, 256);
}

static void remove_range(work *w)
{
    size_t most = draw(w, 4) ? 16 : w->out->size;
    put(w, place(w), 1 + draw(w, most), "", 0);
}

/** A piece of the input or of another file, over or between what is there. */
static void copy_range(work *w)
{
    static unsigned char piece[MUTATE_MAX];
    const mutate_bytes *from = draw(w, 2) ? w->out : &w->files[draw(w, w->file_count)];
    if (from->size == 0)
        return;
    size_t start = draw(w, from->size), size = 1 + draw(w, from->size - start);
    size = draw(w, 4) ? 1 + size % 64 : size;
    size = size < from->size - start ? size : from->size - start;
    memcpy(piece, from->bytes + start, size);
    put(w, place(w), draw(w, 2) ? size : 0, piece, size);
}

/** Many copies of a short piece: what grows faster than its input shows. */
static void repeat_range(work *w)
{
    unsigned char piece[64];
    size_t at = place(w), size = 1 + draw(w, sizeof piece);
    size = size < w->out->size - at ? size : w->out->size - at;
    memcpy(piece, w->out->bytes + at, size);
    for (size_t i = draw(w, 8) ? draw(w, 8) : draw(w, 4000); i > 0 && size > 0; --i)
        put(w, at, 0, piece, size);
}

/* ---- text -------------------------------------------------------------------------------------------------------- */

static bool is_number(unsigned char c)
{
    return isdigit(c) || c == '.';
}

static bool is_word(unsigned char c)
{
    return isalnum(c) || c == '_';
}

/** Replaces what `belongs`, next to a place, by a word. */
static void replace(work *w, bool (*belongs)(unsigned char c), const char *word)
{
    const mutate_bytes *o = w->out;
    size_t start = place(w);
    while (start < o->size && !belongs(o->bytes[start]))
        ++start;
    while (start > 0 && belongs(o->bytes[start - 1]))
        --start;
    size_t end = start;
    while (end < o->size && belongs(o->bytes[end]))
        ++end;
    put(w, start, end - start, word, strlen(word));
}

static void replace_number(work *w)
{
    replace(w, is_number, dictionary_number(draw(w, SIZE_MAX)));
}

static void replace_word(work *w)
{
    replace(w, is_word, dictionary_word(draw(w, SIZE_MAX)));
}

static void insert_word(work *w)
{
    const char *word = draw(w, 3) ? dictionary_word(draw(w, SIZE_MAX)) : dictionary_number(draw(w, SIZE_MAX));
    put(w, place(w), 0, word, strlen(word));
}

/** The line around a place, with its end. */
static size_t find_line(const mutate_bytes *text, size_t at, size_t *size)
{
    size_t start = at, end = at;
    while (start > 0 && text->bytes[start - 1] != '\n')
        --start;
    while (end < text->size && text->bytes[end] != '\n')
        ++end;
    *size = end - start + (end < text->size);
    return start;
}

/** A line of this or another file, in the place of a line or before it. */
static void copy_line(work *w)
{
    static unsigned char line[MUTATE_MAX];
    const mutate_bytes *from = draw(w, 2) ? w->out : &w->files[draw(w, w->file_count)];
    size_t size, gone;
    size_t start = find_line(from, draw(w, from->size + 1), &size);
    memcpy(line, from->bytes + start, size);
    size_t at = find_line(w->out, place(w), &gone);
    put(w, at, draw(w, 3) ? 0 : gone, line, size);
}

static void remove_line(work *w)
{
    size_t size, at = find_line(w->out, place(w), &size);
    put(w, at, size, "", 0);
}

/* ---- binary files ------------------------------------------------------------------------------------------------ */

/** A number of eight bytes, often in the place of one. */
static void set_value(work *w)
{
    static const double reals[] = {0, -1, 1e-300, 1e300, INFINITY, NAN, 0.5};
    static const uint64_t counts[] = {0, 1, 255, 65535, UINT32_MAX, INT64_MAX, UINT64_MAX, UINT64_MAX - 7, 1 << 20};
    unsigned char value[8];
    if (draw(w, 2))
        memcpy(value, &reals[draw(w, sizeof reals / sizeof *reals)], sizeof value);
    else
        memcpy(value, &counts[draw(w, sizeof counts / sizeof *counts)], sizeof value);
    size_t size = (size_t)1 << draw(w, 4), at = place(w);
    put(w, draw(w, 2) ? at : at / size * size, size, value, size);
}

/* ---- inputs ------------------------------------------------------------------------------------------------------ */

static bool is_text(const mutate_bytes *file)
{
    return !memchr(file->bytes, 0, file->size);
}

void mutate(const mutate_bytes *files, size_t file_count, uint64_t number, mutate_bytes *out)
{
    static void (*const of_text[])(work *) = {
        replace_number, replace_number, replace_number, replace_word, replace_word, insert_word, copy_line,
        copy_line,      remove_line,    flip_bit,       set_byte,     remove_range, copy_range,  repeat_range};
    static void (*const of_bytes[])(work *) = {flip_bit,  flip_bit,  set_byte,  set_value,
                                               set_value, set_value, copy_range};
    work w = {.files = files, .file_count = file_count, .random = number * UINT64_C(0x2545f4914f6cdd1d), .out = out};
    const mutate_bytes *file = &files[draw(&w, file_count)];
    memcpy(out->bytes, file->bytes, file->size);
    out->size = file->size;
    bool text = is_text(file);
    for (size_t changes = 1 + draw(&w, draw(&w, 2) ? 8 : 2); changes > 0 && out->size > 0; --changes)
        if (text)
            of_text[draw(&w, sizeof of_text / sizeof *of_text)](&w);
        else if (draw(&w, 50) == 0)
            remove_range(&w);
        else
            of_bytes[draw(&w, sizeof of_bytes / sizeof *of_bytes)](&w);
}
