/* SPDX-License-Identifier: MIT */
/** @file parse.h
 *  Parses values of options. Each function returns false unless the whole text is valid. */
#ifndef SPH2D_CLI_PARSE_H
#define SPH2D_CLI_PARSE_H

#include <stdbool.h>

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

#endif
