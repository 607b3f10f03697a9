/* SPDX-License-Identifier: MIT */
/** @file text.c
 *  Texts for people to read, values read from texts, and texts in memory. The command never calls setlocale, so strtod expects
 *  decimal points. */
#include "text.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Longer words get no suggestions. */
#define WORD_MAX 48

static size_t smallest(size_t a, size_t b, size_t c)
{
    size_t least = a < b ? a : b;
    return least < c ? least : c;
}

/* Edit distance from a to b: insertions, deletions, changes and transpositions. Only three rows of the table over all
 * prefixes are kept: the present one and the two before. */
static size_t edit_distance(const char *a, const char *b)
{
    size_t length_b = strlen(b);
    size_t rows[3][WORD_MAX + 1];
    for (size_t j = 0; j <= length_b; ++j)
        rows[0][j] = j;
    for (size_t i = 1; a[i - 1] != '\0'; ++i) {
        size_t *row = rows[i % 3];
        const size_t *last = rows[(i + 2) % 3], *last_but_one = rows[(i + 1) % 3];
        row[0] = i;
        for (size_t j = 1; j <= length_b; ++j) {
            row[j] = smallest(last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1]));
            bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped && last_but_one[j - 2] + 1 < row[j])
                row[j] = last_but_one[j - 2] + 1;
        }
    }
    return rows[strlen(a) % 3][length_b];
}

const char *text_nearest(const char *word, const char *const *words, size_t count)
{
    size_t length = strlen(word);
    if (length == 0 || length > WORD_MAX)
        return NULL;
    /* At most a third of the letters may differ, at least one. */
    size_t best = length < 4 ? 1 : length / 3;
    const char *nearest = NULL;
    for (size_t i = 0; i < count; ++i) {
        if (strlen(words[i]) > WORD_MAX)
            continue;
        size_t distance = edit_distance(word, words[i]);
        if (distance < best || (distance == best && !nearest)) {
            best = distance;
            nearest = words[i];
        }
    }
    return nearest;
}

/* Overlong forms, surrogates and stray bytes are invalid. */
size_t text_utf8_length(const char *text)
{
    static const struct {
        unsigned char first_min, first_max, second_min, second_max;
        size_t length;
    } forms[] = {{0xC2, 0xDF, 0x80, 0xBF, 2}, {0xE0, 0xE0, 0xA0, 0xBF, 3}, {0xE1, 0xEC, 0x80, 0xBF, 3},
                 {0xED, 0xED, 0x80, 0x9F, 3}, {0xEE, 0xEF, 0x80, 0xBF, 3}, {0xF0, 0xF0, 0x90, 0xBF, 4},
                 {0xF1, 0xF3, 0x80, 0xBF, 4}, {0xF4, 0xF4, 0x80, 0x8F, 4}};
    const unsigned char *s = (const unsigned char *)text;
    for (size_t i = 0; i < sizeof forms / sizeof *forms; ++i) {
        if (s[0] < forms[i].first_min || s[0] > forms[i].first_max)
            continue;
        if (s[1] < forms[i].second_min || s[1] > forms[i].second_max)
            return 0;
        for (size_t k = 2; k < forms[i].length; ++k)
            if (s[k] < 0x80 || s[k] > 0xBF)
                return 0;
        return forms[i].length;
    }
    return 0;
}

char *text_whole(char *text)
{
    size_t length = strlen(text), start = length;
    while (start > 0 && length - start < 4 && ((unsigned char)text[start - 1] & 0xC0) == 0x80)
        --start;
    if (start > 0 && (unsigned char)text[start - 1] >= 0xC0 && text_utf8_length(text + start - 1) == 0)
        text[start - 1] = '\0';
    return text;
}

char *text_bytes(char out[TEXT_SIZE], double bytes)
{
    static const char *const units[] = {"B", "KiB", "MiB", "GiB", "TiB", "PiB"};
    size_t unit = 0;
    while (bytes >= 1024 && unit + 1 < sizeof units / sizeof *units) {
        bytes /= 1024;
        ++unit;
    }
    snprintf(out, TEXT_SIZE, unit == 0 ? "%.0f %s" : "%.1f %s", bytes, units[unit]);
    return out;
}

char *text_seconds(char out[TEXT_SIZE], double seconds)
{
    if (!(seconds >= 0) || seconds > 1e15) {
        snprintf(out, TEXT_SIZE, "unknown");
    } else if (seconds < 60) {
        snprintf(out, TEXT_SIZE, seconds < 10 ? "%.2g s" : "%.0f s", seconds);
    } else if (seconds < 3600) {
        snprintf(out, TEXT_SIZE, "%d min %02d s", (int)(seconds / 60), (int)fmod(seconds, 60));
    } else if (seconds < 48 * 3600.0) {
        snprintf(out, TEXT_SIZE, "%d h %02d min", (int)(seconds / 3600), (int)(fmod(seconds, 3600) / 60));
    } else {
        snprintf(out, TEXT_SIZE, "%.3g days", seconds / 86400);
    }
    return out;
}

char *text_short(char out[TEXT_SIZE], double number)
{
    snprintf(out, TEXT_SIZE, fabs(number) < 9.95 ? "%.2g" : "%.0f", number);
    return out;
}

char *text_count(char out[TEXT_SIZE], double count)
{
    static const char *const units[] = {"", " k", " M", " G", " T"};
    size_t unit = 0;
    while (count >= 999.5 && unit + 1 < sizeof units / sizeof *units) {
        count /= 1000;
        ++unit;
    }
    snprintf(out, TEXT_SIZE, "%.3g%s", count, units[unit]);
    return out;
}

/* Appends the base units whose exponent has a sign; returns their number. */
static int append_units(char out[TEXT_SIZE], const signed char unit[3], int sign)
{
    static const char *const names[] = {"m", "kg", "s"};
    /* in the usual order kg, m, s */
    static const int order[] = {1, 0, 2};
    int written = 0;
    for (int i = 0; i < 3; ++i) {
        int exponent = unit[order[i]] * sign;
        if (exponent <= 0)
            continue;
        size_t used = strlen(out);
        snprintf(out + used, TEXT_SIZE - used, "%s%s", written > 0 ? " " : "", names[order[i]]);
        if (exponent > 1) {
            used = strlen(out);
            snprintf(out + used, TEXT_SIZE - used, "^%d", exponent);
        }
        ++written;
    }
    return written;
}

char *text_unit(char out[TEXT_SIZE], const signed char unit[3])
{
    out[0] = '\0';
    if (unit[0] == -1 && unit[1] == 1 && unit[2] == -2) {
        snprintf(out, TEXT_SIZE, "Pa");
        return out;
    }
    char denominator[TEXT_SIZE] = "";
    int numerator_count = append_units(out, unit, 1);
    int denominator_count = append_units(denominator, unit, -1);
    if (denominator_count > 0) {
        size_t used = strlen(out);
        const char *format = denominator_count > 1 ? "%s/(%.40s)" : "%s/%.40s";
        snprintf(out + used, TEXT_SIZE - used, format, numerator_count > 0 ? "" : "1", denominator);
    }
    return out;
}

void text_row(const char *name, const char *format, ...)
{
    printf("%-22s ", name);
    va_list values;
    va_start(values, format);
    vprintf(format, values);
    va_end(values);
    putchar('\n');
}

void text_append(char *out, size_t size, const char *format, ...)
{
    size_t used = strlen(out);
    va_list values;
    va_start(values, format);
    vsnprintf(out + used, size - used, format, values);
    va_end(values);
}

char *text_word(char out[TEXT_WORD_SIZE], const char *path)
{
    static const char plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./-+:@%,=";
    const char *quote = path[strspn(path, plain)] == '\0' ? "" : strpbrk(path, "\"\\$`!") ? "'" : "\"";
    size_t n = (size_t)sprintf(out, "%s%s", path[0] == '-' ? "./" : "", quote); /* a name is no option */
    for (; *path && n + 6 < TEXT_WORD_SIZE; ++path) {
        const bool ends = *path == '\'' && *quote == '\'';
        n += (size_t)(ends ? sprintf(out + n, "'\\''") : sprintf(out + n, "%c", *path));
    }
    memcpy(out + n, quote, strlen(quote) + 1);
    return out;
}

/* ---- values of options ------------------------------------------------------------------------------------------- */

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

/* ---- printed to memory ------------------------------------------------------------------------------------------- */

static const size_t FIRST = (size_t)1 << 16, LARGEST = (size_t)1 << 30;

char *compose(void (*put)(const void *what, FILE *out), const void *what, size_t *length)
{
    for (size_t room = FIRST; room <= LARGEST; room *= 4) {
        char *text = malloc(room);
        FILE *out = text ? fmemopen(text, room, "w") : NULL;
        if (!out) {
            free(text);
            return NULL;
        }
        put(what, out);
        const bool fits = fflush(out) == 0 && !ferror(out);
        const long end = ftell(out);
        if (fclose(out) == 0 && fits && end >= 0 && (size_t)end < room) {
            *length = (size_t)end;
            return text;
        }
        free(text);
    }
    return NULL;
}
