/* SPDX-License-Identifier: MIT */
/** @file number.c
 *  Conversion of text to numbers: decimals only, unlike strtod without hexadecimals, leading blanks and NaN. */
#include "base/number.h"

#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/** Whether `text`, in any case, is `word` (given in lower case). */
static bool is_word(const char *text, const char *word)
{
    for (; *text && *word; ++text, ++word)
        if ((*text | 0x20) != *word)
            return false;
    return !*text && !*word;
}

static bool is_not_finite(const char *text)
{
    text += *text == '+' || *text == '-';
    text += *text == '.';
    return is_word(text, "nan") || is_word(text, "inf") || is_word(text, "infinity");
}

/** The number of digits at `text`. */
static size_t digits(const char *text)
{
    return strspn(text, "0123456789");
}

/** Whether `text` is -1.5e-3 or the like: [sign] digits and a point [e [sign] digits]. */
static bool is_decimal(const char *text)
{
    text += *text == '+' || *text == '-';
    size_t integer = digits(text);
    text += integer;
    size_t fraction = 0;
    if (*text == '.') {
        fraction = digits(text + 1);
        text += 1 + fraction;
    }
    if (integer + fraction == 0)
        return false;
    if (*text == 'e' || *text == 'E') {
        ++text;
        text += *text == '+' || *text == '-';
        size_t exponent = digits(text);
        if (exponent == 0)
            return false;
        text += exponent;
    }
    return *text == '\0';
}

sph2d__number sph2d__number_real(const char *text, double *value)
{
    if (is_not_finite(text))
        return SPH2D__NUMBER_NOT_FINITE;
    if (!is_decimal(text))
        return SPH2D__NUMBER_NONE;
    errno = 0;
    double result = strtod(text, NULL);
    /* ERANGE with a small non-zero result means a subnormal number, which is valid */
    if (errno == ERANGE && (result == 0 || isinf(result)))
        return SPH2D__NUMBER_RANGE;
    *value = result;
    return SPH2D__NUMBER_OK;
}

sph2d__number sph2d__number_count(const char *text, uint64_t *value)
{
    if (is_not_finite(text))
        return SPH2D__NUMBER_NOT_FINITE;
    bool negative = *text == '-';
    text += negative || *text == '+';
    size_t length = digits(text);
    if (length == 0 || text[length] != '\0')
        return SPH2D__NUMBER_NONE;
    uint64_t result = 0;
    for (size_t i = 0; i < length; ++i) {
        unsigned digit = (unsigned)(text[i] - '0');
        if (result > (UINT64_MAX - digit) / 10)
            return SPH2D__NUMBER_RANGE;
        result = 10 * result + digit;
    }
    if (negative && result > 0)
        return SPH2D__NUMBER_RANGE;
    *value = result;
    return SPH2D__NUMBER_OK;
}
