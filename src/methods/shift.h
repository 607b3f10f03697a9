/* SPDX-License-Identifier: MIT */
/** @file shift.h
 *  The shift velocity of the symmetric operators,
 *
 *      w = -D grad C,   D = gain |S| H^2,   grad C = sum V (1 + 0.2 (W/W(dx))^4) grad W   (Sun et al. 2017, eqs. 7, 8)
 *
 *  with the rate of strain |S| = sqrt(2 S:S) of the liquid around, without that of volume, in place of the largest speed
 *  over H: what disorders a lattice is that neighbours pass each other. Liquid that rests, flies or turns as a whole is
 *  not shifted, and no moving frame changes anything. Particles carry H grad C and |S|. */
#ifndef SPH2D_METHODS_SHIFT_H
#define SPH2D_METHODS_SHIFT_H

#include <math.h>

#include "methods/system.h"

/* D over |S| H^2, for shifting: 1. With 3, a block that was thrown at a wall gained 1.9 % of its energy, with 1 less than
 * 0.2 %. */
static const double SPH2D__SHIFT_GAIN = 1;
/* D dt/H^2 that is stable, half of what it may be at H/dx = 2 to 4. */
static const double SPH2D__SHIFT_LIMIT = 0.1;
/* H |grad C| beyond which shifts grow no more. */
static const double SPH2D__SHIFT_CROWD = 0.25;

/** The shift velocity of fluid particle i in the system's step [m/s]. */
static inline sph2d_vec2 sph2d__shift_velocity(const sph2d__system *s, size_t i)
{
    double cx = s->fluid.crowd_x[i], cy = s->fluid.crowd_y[i], crowd = sqrt(cx * cx + cy * cy);
    double most = SPH2D__SHIFT_LIMIT * s->support / s->step;
    double speed = fmin(s->method.shifting * SPH2D__SHIFT_GAIN * s->fluid.strain[i] * s->support, most);
    double factor = crowd > SPH2D__SHIFT_CROWD ? -speed * SPH2D__SHIFT_CROWD / crowd : -speed;
    return (sph2d_vec2){factor * cx, factor * cy};
}

#endif
