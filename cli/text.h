/* SPDX-License-Identifier: MIT */
/** @file text.h
 *  Texts: sizes, durations, units and table rows for people to read, suggestions for misspelt words; values of options that
 *  are read from texts; texts in memory that are printed to. */
#ifndef SPH2D_CLI_TEXT_H
#define SPH2D_CLI_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* ---- for people to read ------------------------------------------------------------------------------------------ */

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

/* ---- values of options: false unless the whole text is valid ----------------------------------------------------- */

/** A finite number. */
bool parse_number(const char *text, double *value);
/** A number above 0, or per cent of one: "0.01", "1%". */
bool parse_fraction(const char *text, double *value);
/** An integer from `min` to `max`. */
bool parse_count(const char *text, long min, long max, long *value);
/** A part of several, counted from 1: "3/8", of at most 1,000,000. */
bool parse_part(const char *text, int *part, int *parts);
/** A duration in seconds: "90", "90s", "1.5h", "1h30m"; units d, h, m, s. Above 0. */
bool parse_duration(const char *text, double *seconds);
/** A size in pixels: "1280x720". */
bool parse_size(const char *text, unsigned *width, unsigned *height);
/** Four numbers with commas between them, the corners of a box: the first pair below the second. */
bool parse_box(const char *text, double corners[4]);
/** Two numbers with .. or a comma between them, the first below the second. */
bool parse_range(const char *text, double *min, double *max);

/* ---- printed to memory ------------------------------------------------------------------------------------------- */

/** The text that `put` prints, which may be called again with more room; its length goes to `length`. The caller frees
 *  it. NULL when memory is short. */
char *compose(void (*put)(const void *what, FILE *out), const void *what, size_t *length);

#endif
