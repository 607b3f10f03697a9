/* SPDX-License-Identifier: MIT */
/** @file shift.h
 *  The shift velocity of the symmetric operators,
 *
 *      w_i = -D (grad C_i - m_i),   grad C = sum V (1 + 0.2 (W/W(dx))^4) grad W           (Sun et al. 2017, eqs. 7, 8)
 *      D = gain H^2 |S|^2/(|S| + S0)
 *      m_i = sum_j grad C_j W'/r / sum_j W'/r inside the liquid, farther than H from its surface, else 0
 *
 *  with the strain rate |S| = sqrt(2 S:S) of the liquid around, S without its trace, in place of the largest speed over
 *  H: a lattice is disordered by neighbours that pass each other. Liquid at rest, in free flight or in rigid rotation
 *  is not shifted, and shifts are Galilean invariant. Below S0 = 0.001 c0/H strain is the noise of sound in liquid at
 *  rest, which shifts would amplify: a tank at rest kept a speed of 0.02 sqrt(gH), with S0 it falls below 0.001.
 *
 *  Without the mean m over neighbours shifts would transport volume between parts of the liquid, which its density does
 *  not follow; with it they only regularise the order of particles locally. Without m the number of particles per area
 *  and their density differed by up to 1.5 % after the fall of a block, 2.6 % in a jet on a wall, with it by 0.3 and
 *  0.3 %.
 *
 *  H grad C and the strain rate are stored; a step shifts once, at its middle. */
#ifndef SPH2D_METHODS_TERMS_SHIFT_H
#define SPH2D_METHODS_TERMS_SHIFT_H

#include <math.h>

#include "methods/common/system.h"

/* D over |S| H^2 for `shifting: 1`. With 1 the tension in a rotating patch was too low by 0.015 of rho w^2 L^2, with 2
 * and 3 by 0.004, while shifts had a mean; without it, over twelve starts, the rms was 0.0085 with 2, 0.0071 with 2.5
 * and 0.0067 with 3, 0.0082 before. */
static const double SPH2D__SHIFT_GAIN = 2.5;
/* S0 H/c0. */
static const double SPH2D__SHIFT_NOISE = 0.001;
/* Largest D dt/H^2, half of the limit of stability at H/dx = 2 to 4. */
static const double SPH2D__SHIFT_LIMIT = 0.1;
/* H |grad C| beyond which shifts no longer grow. */
static const double SPH2D__SHIFT_MAX_GRADIENT = 0.25;

/** |S| around fluid particle i [1/s]. */
static inline double sph2d__strain_rate(const sph2d__store *f, size_t i)
{
    return 2 * sqrt(f->stretch[i] * f->stretch[i] + f->shear[i] * f->shear[i]);
}

/** The shift velocity of fluid particle i in the system's step, with `mean` H m_i [m/s]. */
static inline sph2d_vec2 sph2d__shift_velocity(const sph2d__system *s, size_t i, sph2d_vec2 mean)
{
    double cx = s->fluid.grad_c_x[i] - mean.x, cy = s->fluid.grad_c_y[i] - mean.y, gradient = sqrt(cx * cx + cy * cy);
    double limit = SPH2D__SHIFT_LIMIT * s->support / s->step;
    double strain = sph2d__strain_rate(&s->fluid, i), noise = SPH2D__SHIFT_NOISE * s->sound_speed / s->support;
    double gain = s->method.shifting * SPH2D__SHIFT_GAIN;
    double speed = fmin(gain * strain * strain / (strain + noise) * s->support, limit);
    double factor = gradient > SPH2D__SHIFT_MAX_GRADIENT ? -speed * SPH2D__SHIFT_MAX_GRADIENT / gradient : -speed;
    return (sph2d_vec2){factor * cx, factor * cy};
}

#endif
