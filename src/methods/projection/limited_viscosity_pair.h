/* SPDX-License-Identifier: MIT */
/** @file limited_viscosity_pair.h
 *  What a pair of particles adds to the sums of limited_viscosity.h. No loops; every lane is a particle with a neighbour
 *  of its own. */
#ifndef SPH2D_METHODS_PROJECTION_LIMITED_VISCOSITY_PAIR_H
#define SPH2D_METHODS_PROJECTION_LIMITED_VISCOSITY_PAIR_H

#include "methods/projection/limited_viscosity.h"
#include "simd/lanes.h"

/* ---- gradients of velocity --------------------------------------------------------------------------------------- */

/** Sums over pairs of the liquid: -G (x) r and -v_ij (x) G. */
typedef struct gradient_sums {
    sph2d__lanes xx, xy, yy;
    sph2d__lanes vxx, vxy, vyx, vyy;
} gradient_sums;

/** Adds neighbours with gradients (gx, gy), from which the particles are (dx, dy) apart and move by (ux, uy). */
SPH2D__INLINE void gradient_pair(gradient_sums *sum, sph2d__lanes gx, sph2d__lanes gy, sph2d__lanes dx, sph2d__lanes dy,
                                 sph2d__lanes ux, sph2d__lanes uy)
{
    sum->xx -= gx * dx;
    sum->xy -= gx * dy;
    sum->yy -= gy * dy;
    sum->vxx -= ux * gx;
    sum->vxy -= ux * gy;
    sum->vyx -= uy * gx;
    sum->vyy -= uy * gy;
}

/** Sets the velocity gradients of the particles `first` on of a slice. Those whose inverse of B has an eigenvalue below
 *  0.3, 1 inside the liquid and 0.5 at a flat surface, have none. */
SPH2D__INLINE void finish_gradient(sph2d__store *f, size_t first, const gradient_sums *sum, double density)
{
    const sph2d__lanes none = {0}, least = none + 0.3;
    sph2d__lanes half = (sum->xx + sum->yy) / 2, det = sum->xx * sum->yy - sum->xy * sum->xy;
    sph2d__lanes inverse = 1 / det; /* not used where it is infinite */
    sph2d__lanes eigenvalue = half - sph2d__lanes_sqrt(sph2d__lanes_max(half * half - det, none));
    sph2d__lanes bxx = inverse * sum->yy, bxy = -inverse * sum->xy, byy = inverse * sum->xx;
    sph2d__lanes xx = sum->vxx * bxx + sum->vxy * bxy, yy = sum->vyx * bxy + sum->vyy * byy;
    sph2d__lanes xy = sum->vxx * bxy + sum->vxy * byy, yx = sum->vyx * bxx + sum->vyy * bxy;
    sph2d__lanes_store(f->stretch + first, sph2d__lanes_where(eigenvalue, least, (xx - yy) / 2));
    sph2d__lanes_store(f->shear + first, sph2d__lanes_where(eigenvalue, least, (xy + yx) / 2));
    sph2d__lanes_store(f->density_rate + first, sph2d__lanes_where(eigenvalue, least, -density * (xx + yy)));
}

/* ---- the force --------------------------------------------------------------------------------------------------- */

/** Velocity and the symmetric part of its gradient. */
typedef struct motion {
    sph2d__lanes vx, vy, xx, xy, yy;
} motion;

SPH2D__INLINE motion motion_of(sph2d__lanes vx, sph2d__lanes vy, sph2d__lanes stretch, sph2d__lanes shear,
                               sph2d__lanes half_divergence)
{
    return (motion){vx, vy, half_divergence + stretch, shear, half_divergence - stretch};
}

/** The smaller of two numbers of one sign, 0 if they have two. */
SPH2D__INLINE sph2d__lanes minmod(sph2d__lanes a, sph2d__lanes b)
{
    const sph2d__lanes none = {0};
    sph2d__lanes above = -sph2d__lanes_max(-sph2d__lanes_max(a, none), -sph2d__lanes_max(b, none));
    sph2d__lanes below = -sph2d__lanes_max(-sph2d__lanes_max(-a, none), -sph2d__lanes_max(-b, none));
    return above - below;
}

/** w/r^2 of particles that are (dx, dy) from their neighbours. */
SPH2D__INLINE sph2d__lanes limited_pair(const motion *own, const motion *other, sph2d__lanes dx, sph2d__lanes dy)
{
    sph2d__lanes along = (own->vx - other->vx) * dx + (own->vy - other->vy) * dy;
    sph2d__lanes linear =
        (own->xx + other->xx) * dx * dx + 2 * (own->xy + other->xy) * dx * dy + (own->yy + other->yy) * dy * dy;
    sph2d__lanes square = sph2d__lanes_max(dx * dx + dy * dy, (sph2d__lanes){0} + 1e-300); /* one place: no line */
    return minmod(along, along - 0.5 * linear) / square;
}

#endif
