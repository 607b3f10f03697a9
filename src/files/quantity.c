/* SPDX-License-Identifier: MIT */
/** @file quantity.c
 *  Reads decimal commas, groups of thousands, and units of the SI with prefixes. */
#include "files/quantity.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/number.h"

enum { BASES = 4, DIGITS = 40 };

#define DEGREE 0.017453292519943295 /* pi/180 */

/** A unit: its factor to metre, kilogram, second and radian, and their exponents. */
typedef struct unit {
    double factor;
    int exponents[BASES];
} unit;

/* ---- units ------------------------------------------------------------------------------------------------------- */

static const struct symbol {
    const char *text;
    unit unit;
    bool takes_prefix;
} symbols[] = {
    {"m", {1, {1}}, true},
    {"g", {1e-3, {0, 1}}, true},
    {"s", {1, {0, 0, 1}}, true},
    {"N", {1, {1, 1, -2}}, true},
    {"Pa", {1, {-1, 1, -2}}, true},
    {"J", {1, {2, 1, -2}}, true},
    {"W", {1, {2, 1, -3}}, true},
    {"Hz", {1, {0, 0, -1}}, true},
    {"l", {1e-3, {3}}, true},
    {"L", {1e-3, {3}}, true},
    {"P", {0.1, {-1, 1, -1}}, true},  /* poise */
    {"St", {1e-4, {2, 0, -1}}, true}, /* stokes */
    {"bar", {1e5, {-1, 1, -2}}, true},
    {"rad", {1, {0, 0, 0, 1}}, true},
    {"deg", {DEGREE, {0, 0, 0, 1}}, false},
    {"\xc2\xb0", {DEGREE, {0, 0, 0, 1}}, false},
    {"t", {1e3, {0, 1}}, false},
    {"min", {60, {0, 0, 1}}, false},
    {"h", {3600, {0, 0, 1}}, false},
    {"in", {0.0254, {1}}, false},
    {"ft", {0.3048, {1}}, false},
    {"%", {0.01, {0}}, false},
};

static const struct prefix {
    const char *text;
    double factor;
} prefixes[] = {
    {"G", 1e9},  {"M", 1e6},  {"k", 1e3},         {"h", 1e2},         {"d", 1e-1}, {"c", 1e-2},
    {"m", 1e-3}, {"u", 1e-6}, {"\xc2\xb5", 1e-6}, {"\xce\xbc", 1e-6}, {"n", 1e-9},
};

static bool is_text(const char *word, size_t length, const char *text)
{
    return strlen(text) == length && memcmp(word, text, length) == 0;
}

/** Finds a symbol, as it is before one with a prefix: `min` is no milli-inch. */
static bool find_symbol(const char *word, size_t length, unit *out)
{
    for (size_t i = 0; i < sizeof symbols / sizeof *symbols; ++i)
        if (is_text(word, length, symbols[i].text)) {
            *out = symbols[i].unit;
            return true;
        }
    for (size_t p = 0; p < sizeof prefixes / sizeof *prefixes; ++p) {
        const size_t before = strlen(prefixes[p].text);
        for (size_t i = 0; before < length && i < sizeof symbols / sizeof *symbols; ++i)
            if (symbols[i].takes_prefix && memcmp(word, prefixes[p].text, before) == 0 &&
                is_text(word + before, length - before, symbols[i].text)) {
                *out = symbols[i].unit;
                out->factor *= prefixes[p].factor;
                return true;
            }
    }
    return false;
}

/** Skips `sign` at the text, if it is there. */
static bool skip(const char **text, const char *sign)
{
    const bool there = strncmp(*text, sign, strlen(sign)) == 0;
    *text += there ? strlen(sign) : 0;
    return there;
}

/** Reads the exponent of a factor, "^3", "3", "-1", "\xc2\xb2": 1 for none, 0 for one that no unit has. */
static int read_exponent(const char **text)
{
    if (skip(text, "\xc2\xb2"))
        return 2;
    if (skip(text, "\xc2\xb3"))
        return 3;
    const bool marked = skip(text, "^"), negative = skip(text, "-");
    if (**text < '1' || **text > '9')
        return marked || negative ? 0 : 1;
    const int digit = *(*text)++ - '0';
    return **text >= '0' && **text <= '9' ? 0 : negative ? -digit : digit;
}

/** The number of bytes of a symbol at the text: letters and what is not ASCII, up to an exponent or a sign. */
static size_t symbol_length(const char *text)
{
    size_t length = 0;
    while (((text[length] | 0x20) >= 'a' && (text[length] | 0x20) <= 'z') ||
           ((unsigned char)text[length] >= 0x80 && strncmp(text + length, "\xc2\xb2", 2) != 0 &&
            strncmp(text + length, "\xc2\xb3", 2) != 0 && strncmp(text + length, "\xc2\xb7", 2) != 0))
        ++length;
    return length > 0 ? length : *text == '%';
}

/** Reads a whole unit, "kg/m^3", "kg m-3" or "1/s"; "" is 1. */
static bool read_unit(const char *text, unit *out)
{
    bool below = false;
    *out = (unit){.factor = 1};
    for (;;) {
        while (skip(&text, " ") || skip(&text, "*") || skip(&text, "\xc2\xb7"))
            continue;
        if (*text == '\0')
            return !below;
        if (strncmp(text, "1/", 2) == 0)
            ++text;
        if (skip(&text, "/")) {
            if (below)
                return false;
            below = true;
            continue;
        }
        unit factor = {0};
        const size_t length = symbol_length(text);
        if (length == 0 || !find_symbol(text, length, &factor))
            return false;
        text += length;
        const int exponent = read_exponent(&text), sign = below ? -1 : 1;
        if (exponent == 0)
            return false;
        for (int i = 0; i < (exponent < 0 ? -exponent : exponent); ++i)
            out->factor = exponent * sign > 0 ? out->factor * factor.factor : out->factor / factor.factor;
        for (int i = 0; i < BASES; ++i)
            out->exponents[i] += sign * exponent * factor.exponents[i];
        below = false;
    }
}

/* ---- numbers ----------------------------------------------------------------------------------------------------- */

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/** Whether a sign that groups digits stands at the text: behind it are three of them and no more. */
static bool groups(const char *text)
{
    return *text != '\0' && strchr(",.'_ ", *text) && is_digit(text[1]) && is_digit(text[2]) && is_digit(text[3]) &&
           !is_digit(text[4]);
}

/** Copies a number without the signs that group its digits, `point` as its decimal point. Leaves *text behind it; false
 *  if other signs are between the digits. */
static bool copy_number(const char **text, char point, char out[DIGITS])
{
    size_t length = 0;
    const char *c = *text;
    bool fraction = false;
    if (*c == '-' || *c == '+')
        out[length++] = *c++;
    for (; length < DIGITS - 1; ++c) {
        if (is_digit(*c)) {
            out[length++] = *c;
        } else if (*c == point && !fraction && (is_digit(c[1]) || point == '.')) {
            out[length++] = '.';
            fraction = true;
        } else if (fraction || !groups(c)) {
            break;
        }
    }
    const char *exponent = *c == 'e' || *c == 'E' ? c + 1 + (c[1] == '-' || c[1] == '+') : NULL;
    if (exponent && is_digit(*exponent)) {
        out[length < DIGITS - 1 ? length++ : length] = 'e';
        for (++c; length < DIGITS - 1 && (is_digit(*c) || c < exponent); ++c)
            out[length++] = *c;
    }
    out[length] = '\0';
    *text = c;
    return length < DIGITS - 1 && !(*c == ',' || *c == '.') && !is_digit(*c);
}

/** The decimal points that the number at a text may have, "." or "," or both. */
static const char *points_of(const char *text)
{
    const size_t length = strspn(text, "+-0123456789.,'_ ");
    const char *comma = memchr(text, ',', length), *point = memchr(text, '.', length);
    if (!comma)
        return point && memchr(point + 1, '.', length - (size_t)(point + 1 - text)) ? "," : ".";
    if (point)
        return comma > point ? "," : ".";
    if (memchr(comma + 1, ',', length - (size_t)(comma + 1 - text)))
        return ".";
    const char *first = text + (*text == '-' || *text == '+');
    const bool by_thousand = groups(comma) && *first != '0' && comma > first && comma - first <= 3;
    return by_thousand ? ",." : ",";
}

/* ---- advice ------------------------------------------------------------------------------------------------------ */

bool sph2d__quantity_advice(const char *text, const char *wanted, char *advice, size_t size)
{
    double values[2] = {0, 0};
    const char *rest = text, *points = points_of(text);
    for (size_t i = 0; points[i]; ++i) {
        char digits[DIGITS];
        rest = text;
        if (!copy_number(&rest, points[i], digits) || sph2d__number_real(digits, &values[i]) != SPH2D__NUMBER_OK)
            return false;
    }
    while (*rest == ' ')
        ++rest;
    if ((*rest == 'x' && rest > text) || (*rest == '/' && rest[1] >= '0' && rest[1] <= '9'))
        return false; /* 0x10 or 1/2, not a number with a unit */
    unit given, asked;
    const bool known = read_unit(wanted, &asked), readable = read_unit(rest, &given);
    const bool same = known && readable && memcmp(given.exponents, asked.exponents, sizeof given.exponents) == 0;
    const double scale = *rest && same ? given.factor / asked.factor : 1;
    if (!isfinite(values[0] * scale))
        return false;
    char in[40] = "", other[60] = "";
    if (wanted[0])
        snprintf(in, sizeof in, " [%s]", wanted);
    if (points[1])
        snprintf(other, sizeof other, " or %.12g", values[1] * scale);
    if (!*rest || same)
        snprintf(advice, size, "%.40s: write %.12g%s%s", text, values[0] * scale, other, in);
    else
        snprintf(advice, size, "write a number %s%s: %.40s is %s", in[0] ? "in" : "without a unit", in, rest,
                 readable ? "a unit of something else" : "no unit that is known here");
    return true;
}
