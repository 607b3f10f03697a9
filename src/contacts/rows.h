/* SPDX-License-Identifier: MIT */
/** @file rows.h
 *  Impulses by iteration: the sweeps over contacts (rows.c) of which relax.c makes a step. */
#ifndef SPH2D_CONTACTS_ROWS_H
#define SPH2D_CONTACTS_ROWS_H

#include <stddef.h>
#include <stdint.h>

/** A body, with what is 0 for one that does not move. */
typedef struct sph2d__mover {
    double vx, vy, w;    /**< velocity [m/s, rad/s] */
    double imx, imy, ii; /**< inverse masses and inertia */
} sph2d__mover;

/** A contact as the iteration sees it, along its normal (n) and the tangent to the left of that (t). */
typedef struct sph2d__row {
    uint32_t a, b;         /**< movers; the last one is all walls */
    double nx, ny;         /**< the normal, from a to b */
    double an, at, bn, bt; /**< arms: of a and b, about their centres [m] */
    double wall_n, wall_t; /**< velocity of a wall [m/s] */
    double kn, kt;         /**< speed by impulse [1/kg] */
    double mn, mt;         /**< impulse by speed, 0 where there is no speed [kg] */
    double least;          /**< the least speed of separation [m/s] */
    double friction;       /**< coefficient */
    double jn, jt;         /**< impulses so far, on b [kg m/s] */
    double pn, pt;         /**< the same after the sweep before */
} sph2d__row;

/** Speed at which the two separate, and speed of b along the tangent seen from a [m/s]. */
double sph2d__row_separation(const sph2d__row *row, const sph2d__mover *movers);
double sph2d__row_slip(const sph2d__row *row, const sph2d__mover *movers);

/** Sets kn, kt, mn, mt from normal and arms. */
void sph2d__row_weigh(sph2d__row *row, const sph2d__mover *movers);

/** Finds impulses and changes the velocities of movers by them, such that bodies separate at `least` or faster, are not
 *  pulled, and friction opposes slip. */
void sph2d__rows_solve(sph2d__row *rows, size_t count, sph2d__mover *movers);

#endif
