/* SPDX-License-Identifier: MIT */
/** @file shift.h
 *  The shift velocity of the symmetric operators,
 *
 *      w = -gain U H grad C,   |w| <= U/2,   grad C = sum V (1 + 0.2 (W/W(dx))^4) grad W    (Sun et al. 2017, eqs. 7,
 * 8)
 *
 *  with the largest speed U. Particles carry H grad C alone, which follows from their places; U and the gain are those
 * of the step. */
#ifndef SPH2D_METHODS_SHIFT_H
#define SPH2D_METHODS_SHIFT_H

#include <math.h>

#include "methods/system.h"

/** The shift velocity of fluid particle i [m/s]. */
static inline sph2d_vec2 sph2d__shift_velocity(const sph2d__system *s, size_t i)
{
    double cx = s->fluid.crowd_x[i], cy = s->fluid.crowd_y[i], crowd = sqrt(cx * cx + cy * cy);
    double factor = -s->speed * (s->shift_gain * crowd > 0.5 ? 0.5 / crowd : s->shift_gain);
    return (sph2d_vec2){factor * cx, factor * cy};
}

#endif
