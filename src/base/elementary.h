/* SPDX-License-Identifier: MIT */
/** @file elementary.h
 *  Logarithm, exponential and power by + - * / alone, whose results are the same bits on every system and device: those of
 *  C libraries differ in the last one. Series as in Muller, Elementary Functions (2016), sec. 11.2 and 11.3: errors are
 *  below 2 units in the last place, of the power below 2.5 (1 + |b log a|). */
#ifndef SPH2D_BASE_ELEMENTARY_H
#define SPH2D_BASE_ELEMENTARY_H

#include "base/bits.h"

/* The logarithm of 2 as a sum, the first number of which has 32 bits, so that its products with exponents are exact. */
#define SPH2D__LN2_HIGH 0x1.62e42fefp-1
#define SPH2D__LN2_LOW 0x1.473de6af278edp-34

/** The natural logarithm of a normal number above 0. */
static inline double sph2d__log(double a)
{
    const uint64_t bits = sph2d__bits_of(a), rest = bits & 0xfffffffffffff;
    int exponent = (int)(bits >> 52) - 1023;
    double m = sph2d__of_bits(rest | (uint64_t)1023 << 52); /* from 1 to 2, then from 0.71 to 1.41 */
    if (m > 1.4142135623730951) {
        m = m / 2;
        exponent = exponent + 1;
    }
    /* log m = 2 artanh s = 2 s + s (s^2 2/3 + s^4 2/5 + ...), s^2 < 0.0295 */
    const double s = (m - 1) / (m + 1), s2 = s * s;
    double sum = 0;
    for (int k = 10; k > 0; --k)
        sum = s2 * (2.0 / (2 * k + 1) + sum);
    const double e = exponent;
    return e * SPH2D__LN2_HIGH + (2 * s + (s * sum + e * SPH2D__LN2_LOW));
}

/** The exponential function; 0 below -700, and that of 700 above. */
static inline double sph2d__exp(double a)
{
    if (a < -700)
        return 0;
    a = a < 700 ? a : 700;
    const double parts = a * 1.4426950408889634;
    const int k = (int)(parts < 0 ? parts - 0.5 : parts + 0.5);
    const double r = (a - k * SPH2D__LN2_HIGH) - k * SPH2D__LN2_LOW; /* at most 0.35 */
    double sum = 1;
    for (int n = 14; n > 0; --n)
        sum = 1 + r * (1.0 / n) * sum;
    return sum * sph2d__of_bits((uint64_t)(k + 1023) << 52);
}

/** a to the power of b, a a normal number above 0. */
static inline double sph2d__power(double a, double b)
{
    return sph2d__exp(b * sph2d__log(a));
}

#endif
