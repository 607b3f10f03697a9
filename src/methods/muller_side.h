/* SPDX-License-Identifier: MIT */
/** @file muller_side.h
 *  Sides with springs as method `muller` sees them: full of liquid behind.
 *
 *  Rows of liquid lie one spacing apart behind a side, the first half a spacing deep; each is smeared out along the
 *  side, so that it adds the integral of poly6 along a line at distance n,
 *
 *      rho_side(d) = rho0 F sum_k (1 - n_k^2/H^2)^(7/2),   n_k = d + (k + 1/2) dx,
 *
 *  to the density at distance d. F is such that a lattice that starts half a spacing from the side has rest density
 *  there. Without it the first row would have to be pressed together before it can carry anything. What it takes to
 *  press a particle of pressure p against the side comes back: the energy per mass e(rho) gives
 *
 *      a_n = -(p/rho^2) d rho_side/dd. */
#ifndef SPH2D_METHODS_MULLER_SIDE_H
#define SPH2D_METHODS_MULLER_SIDE_H

#include "methods/system.h"

/** What one side adds at distance d over s->side_fill, and minus its slope [1/m]. */
typedef struct sph2d__side_part {
    double value, slope;
} sph2d__side_part;

static inline void sph2d__side_add(const sph2d__system *s, double d, sph2d__side_part *to)
{
    for (double n = fmax(d, -s->spacing / 2) + s->spacing / 2; n < s->support; n += s->spacing) {
        double q = n / s->support, u = 1 - q * q, root = sqrt(u);
        to->value += u * u * u * root;
        to->slope += 7 * q / s->support * u * u * root;
    }
}

#endif
