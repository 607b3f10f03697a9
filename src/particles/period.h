/* SPDX-License-Identifier: MIT */
/** @file period.h
 *  Periodic directions: particles that leave through one side enter through the other. */
#ifndef SPH2D_PARTICLES_PERIOD_H
#define SPH2D_PARTICLES_PERIOD_H

#include <math.h>
#include <stdbool.h>

/** Lower end and length of the period in each direction [m]; length 0: not periodic. */
typedef struct sph2d__period {
    double low_x, low_y;
    double length_x, length_y;
} sph2d__period;

/** A coordinate brought into [low, low + length); NaN if it is not finite, which must not become a place. */
static inline double sph2d__period_wrap(double x, double low, double length)
{
    if (!(length > 0) || (x >= low && x < low + length))
        return x;
    double wrapped = x - length * floor((x - low) / length);
    return wrapped < low || wrapped >= low + length ? low : wrapped; /* by rounding it may be an end or beyond */
}

/** Whether a position is within the period, in each periodic direction. */
static inline bool sph2d__period_holds(const sph2d__period *p, double x, double y)
{
    return (!(p->length_x > 0) || (x >= p->low_x && x < p->low_x + p->length_x)) &&
           (!(p->length_y > 0) || (y >= p->low_y && y < p->low_y + p->length_y));
}

/** The minimum image of a distance. */
static inline double sph2d__period_nearest(double distance, double length)
{
    return length > 0 ? distance - length * floor(distance / length + 0.5) : distance;
}

#endif
