/* SPDX-License-Identifier: MIT */
/** @file parse.c
 *  Parses values of options. The command never calls setlocale, so strtod expects decimal points. */
#include "parse.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Parses a number at the start of `text`, up to *end. strtod alone would accept spaces, "nan" and "0x10". */
static bool leading_number(const char *text, double *value, const char **end)
{
    const char *digits = text + (*text == '-' || *text == '+');
    if (!isdigit((unsigned char)digits[0]) && digits[0] != '.')
        return false;
    if (digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X'))
        return false;
    char *after;
    *value = strtod(text, &after);
    *end = after;
    return after != text && isfinite(*value);
}

bool parse_number(const char *text, double *value)
{
    const char *end;
    return leading_number(text, value, &end) && *end == '\0';
}

bool parse_fraction(const char *text, double *value)
{
    const char *end;
    if (!leading_number(text, value, &end) || *value <= 0)
        return false;
    if (strcmp(end, "%") == 0)
        *value /= 100;
    return *end == '\0' || strcmp(end, "%") == 0;
}

bool parse_count(const char *text, long min, long max, long *value)
{
    if (!isdigit((unsigned char)text[0]))
        return false;
    char *end;
    errno = 0;
    *value = strtol(text, &end, 10);
    return errno == 0 && *end == '\0' && *value >= min && *value <= max;
}

bool parse_part(const char *text, int *part, int *parts)
{
    enum { MOST = 1000000 };
    char first[8];
    size_t length = strcspn(text, "/");
    long number, of;
    if (length >= sizeof first || text[length] != '/' || !parse_count(text + length + 1, 1, MOST, &of))
        return false;
    memcpy(first, text, length);
    first[length] = '\0';
    if (!parse_count(first, 1, of, &number))
        return false;
    *part = (int)number;
    *parts = (int)of;
    return true;
}

/* Seconds in a unit, 0 for an unknown one. */
static double unit_seconds(char unit)
{
    switch (unit) {
    case 'd':
        return 86400;
    case 'h':
        return 3600;
    case 'm':
        return 60;
    case 's':
        return 1;
    default:
        return 0;
    }
}

bool parse_duration(const char *text, double *seconds)
{
    *seconds = 0;
    do {
        double value;
        if (!leading_number(text, &value, &text) || value < 0)
            return false;
        if (*text == '\0') { /* without a unit: seconds, and the last part */
            *seconds += value;
            break;
        }
        double unit = unit_seconds(*text);
        if (unit == 0)
            return false;
        *seconds += value * unit;
        ++text;
    } while (*text != '\0');
    return *seconds > 0 && isfinite(*seconds);
}

bool parse_size(const char *text, unsigned *width, unsigned *height)
{
    char first[8];
    size_t length = strcspn(text, "x");
    if (length == 0 || length >= sizeof first || text[length] != 'x')
        return false;
    memcpy(first, text, length);
    first[length] = '\0';
    long across, down;
    /* The limits are those of sph2d_render_options. */
    if (!parse_count(first, 16, 16384, &across) || !parse_count(text + length + 1, 16, 16384, &down))
        return false;
    *width = (unsigned)across;
    *height = (unsigned)down;
    return true;
}

bool parse_box(const char *text, double corners[4])
{
    for (int k = 0; k < 3; ++k) {
        const char *comma;
        if (!leading_number(text, &corners[k], &comma) || *comma != ',')
            return false;
        text = comma + 1;
    }
    return parse_number(text, &corners[3]) && corners[0] < corners[2] && corners[1] < corners[3];
}

bool parse_range(const char *text, double *min, double *max)
{
    char first[64];
    const char *dots = strstr(text, ".."), *comma = strchr(text, ','), *end = dots ? dots : comma;
    const size_t length = end ? (size_t)(end - text) : 0;
    if (length == 0 || length >= sizeof first)
        return false;
    memcpy(first, text, length);
    first[length] = '\0';
    return parse_number(first, min) && parse_number(end + (dots ? 2 : 1), max) && *min < *max;
}
