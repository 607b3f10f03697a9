/* SPDX-License-Identifier: MIT */
/** @file round_number.h
 *  Round numbers for scales: 1, 2 or 5 times a power of ten. */
#ifndef SPH2D_RENDER_ROUND_NUMBER_H
#define SPH2D_RENDER_ROUND_NUMBER_H

#include <stddef.h>

/** factor * 10^exponent. */
typedef struct sph2d__round_number {
    int factor, exponent;
} sph2d__round_number;

/** The one nearest to a positive number. */
sph2d__round_number sph2d__round_nearest(double number);

/** Writes digits and a power of ten as "-0.25", "1500" or "1.5e7". */
void sph2d__write_number(char *text, size_t size, long long digits, int exponent);

#endif
