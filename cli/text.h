/* SPDX-License-Identifier: MIT */
/** @file text.h
 *  Human-readable formatting: sizes, durations, units, table rows; and suggestions for misspelt words. */
#ifndef SPH2D_CLI_TEXT_H
#define SPH2D_CLI_TEXT_H

#include <stddef.h>

/** Long enough for all results of the text_ functions. */
#define TEXT_SIZE 64

/** The one of `words` nearest to `word`, or NULL if none is similar enough. */
const char *text_nearest(const char *word, const char *const *words, size_t count);

/** Length of the UTF-8 sequence of two bytes or more at the start of `text`; 0 if there is none. */
size_t text_utf8_length(const char *text);

/** Removes a partial UTF-8 sequence from the end of a truncated text. Returns `text`. */
char *text_whole(char *text);

/** "12.3 MiB". Returns `out`. */
char *text_bytes(char out[TEXT_SIZE], double bytes);
/** "4.2 s", "3 min 12 s", "2 h 05 min". Returns `out`. */
char *text_seconds(char out[TEXT_SIZE], double seconds);
/** "0.34", "2.4", "24", "240": a number with at least two significant digits. Returns `out`. */
char *text_short(char out[TEXT_SIZE], double number);
/** "6.91 M": a count with three significant digits. Returns `out`. */
char *text_count(char out[TEXT_SIZE], double count);
/** A unit from its exponents of metre, kilogram and second: "kg/m^3", "Pa", "" for none. Returns `out`. */
char *text_unit(char out[TEXT_SIZE], const signed char unit[3]);

/** Long enough for any path as text_word() quotes it. */
#define TEXT_WORD_SIZE 8200

/** A path as a shell takes it: in quotes where it has to be, which are single ones where it has signs that double ones do not
 *  keep. Returns `out`. */
char *text_word(char out[TEXT_WORD_SIZE], const char *path);

/** Prints a table row to stdout: the name padded to a column, then printf's text. */
void text_row(const char *name, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** Prints behind the text in `out`, cut at `size` bytes in all. */
void text_append(char *out, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));

#endif
