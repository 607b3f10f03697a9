/* SPDX-License-Identifier: MIT */
/** @file perimeters.h
 *  The energy of surface tension found in another way than the library's: by the perimeters of the discs around all
 *  particles, for many radii from 1 to 2 spacings. */
#ifndef SPH2D_TESTS_PERIMETERS_H
#define SPH2D_TESTS_PERIMETERS_H

#include "common.h"

/** The spacing [m] and the tension [N/m]; there are fewer particles than MOST. */
static const double DX = 0.02, SIGMA = 0.7;
enum { MOST = 256 };

/** What a film of one row is pulled with, over 2 sigma. */
double film(void);

/** Energy of the surface [J/m]. */
double energy_by_perimeters(const double *x, const double *y, size_t count, int radii);

#endif
