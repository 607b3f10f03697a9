/* SPDX-License-Identifier: MIT */
/** @file muller_side.h
 *  Spring walls in method `muller`: as if filled with liquid behind. At distance d a side adds
 *
 *      rho_side(d) = rho0 F w(d),   w(d) = (1 - n^2/H^2)^m / (1 - dx^2/H^2)^m,   n = d + dx/2 >= 0,
 *
 *  to the density, and at the distances d and e from two sides of a corner rho0 (F w(d) + F w(e) + Q w(d) w(e)). F and
 *  Q are the fractions of density due to the rows on one side and to the particles in one quarter of a full lattice: a
 *  lattice that starts half a spacing off the sides has rest density everywhere. Without these terms the first row
 *  would have to be compressed before it exerts a pressure. The work against a side is recovered: the energy per mass
 *  e(rho), the integral of p/rho^2, gives
 *
 *      a_n = -(p/rho^2) d rho_side/dd.
 *
 *  m is such that this force balances the pair forces of a lattice half a spacing off the side under uniform pressure.
 */
#ifndef SPH2D_METHODS_MULLER_MULLER_SIDE_H
#define SPH2D_METHODS_MULLER_MULLER_SIDE_H

#include <math.h>

#include "base/elementary.h"
#include "methods/common/system.h"

/** w at distance d and minus its slope [1/m]. */
typedef struct sph2d__side_part {
    double value, slope;
} sph2d__side_part;

static inline void sph2d__side_add(const sph2d__system *s, double d, sph2d__side_part *to)
{
    double n = fmax(d + s->spacing / 2, 0), h2 = s->support * s->support, u = 1 - n * n / h2;
    if (!(u > 0))
        return;
    double value = sph2d__power(u / (1 - s->spacing * s->spacing / h2), s->side_power);
    to->value += value;
    to->slope += 2 * s->side_power * n / (h2 * u) * value;
}

/** Both, for the left and right side in parts[0], for bottom and top in parts[1]. */
static inline void sph2d__sides_at(const sph2d__system *s, double x, double y, sph2d__side_part parts[2])
{
    const sph2d__springs *w = &s->forces.springs;
    const double distances[4] = {x - w->left, w->right - x, y - w->bottom, w->top - y};
    parts[0] = parts[1] = (sph2d__side_part){0, 0};
    for (int k = 0; k < 4; ++k)
        if (distances[k] < s->support) {
            sph2d__side_part part = {0, 0};
            sph2d__side_add(s, distances[k], &part);
            parts[k / 2].value += part.value;
            parts[k / 2].slope += k & 1 ? -part.slope : part.slope;
        }
}

#endif
