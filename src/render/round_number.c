/* SPDX-License-Identifier: MIT */
/** @file round_number.c
 *  Round numbers and their texts. */
#include "render/round_number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DIGITS_SIZE = 24 };

sph2d__round_number sph2d__round_nearest(double number)
{
    sph2d__round_number round = {.exponent = (int)floor(log10(number))};
    const double lead = number / pow(10.0, round.exponent);
    round.factor = lead < 1.5 ? 1 : lead < 3.5 ? 2 : 5;
    if (lead >= 7.5) {
        round.factor = 1;
        ++round.exponent;
    }
    return round;
}

/* Not by printf, whose point depends on the locale. */
void sph2d__write_number(char *text, size_t size, long long digits, int exponent)
{
    char all[DIGITS_SIZE];
    const char *sign = digits < 0 ? "-" : "";
    if (digits == 0)
        exponent = 0;
    snprintf(all, sizeof all, "%lld", llabs(digits));
    const int length = (int)strlen(all);
    if (exponent >= 0 && length + exponent <= 6) {
        snprintf(text, size, "%s%s%.*s", sign, all, exponent, "000000");
    } else if (exponent < 0 && exponent >= -5) {
        const int whole = length + exponent; /* digits before the point */
        if (whole > 0)
            snprintf(text, size, "%s%.*s.%s", sign, whole, all, all + whole);
        else
            snprintf(text, size, "%s0.%.*s%s", sign, -whole, "00000", all);
    } else {
        int kept = length;
        while (kept > 1 && all[kept - 1] == '0')
            --kept;
        snprintf(text, size, "%s%c%s%.*se%d", sign, all[0], kept > 1 ? "." : "", kept - 1, all + 1,
                 exponent + length - 1);
    }
}
