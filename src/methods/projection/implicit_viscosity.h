/* SPDX-License-Identifier: MIT */
/** @file implicit_viscosity.h
 *  Viscosity that a step solves for, in methods with a pressure that follows from density: steps as long as those of
 *  water, however thick the liquid is, walls to which it sticks, and viscosities that depend on the shear rate.
 *
 *      v*  = v + dt (f + a_p + a_v)          f by body forces, a_p by the pressures of the step before
 *      a_v = K v* = -sum_j b mu_ij |g_ij| (v*_ij . r_ij) r_ij/H^2 - walls
 *      b   = 16 H^2/(rho0 I)     I the integral of c |W'| r^3 over the support
 *
 *  with g_ij = (c m/rho0) W'/r of projection.h, and mu_ij the harmonic mean of two viscosities (terms/rheology.h). Forces along the line between two
 *  particles keep both momenta, and leave free surfaces without stress. They have the
 *  weights W' r of terms/viscosity.h: with those of Monaghan 2005, W'/r, a square lattice of H/dx = 2.4 that slides
 *  along its rows has 0.8 of the viscosity, with these 0.97, a lattice of hexagons, too, and liquid that has been sheared
 *  for a while 0.99 to 1.
 *
 *  Implicit as by Weiler, Koschier, Brand & Bender 2018 (Computer Graphics Forum 37), who solve for v* by conjugate
 *  gradients, too. They leave out a_p: then liquid that pressure holds seems to fall for a step, and a steady flow
 *  depends on the step's length. With it v* is that flow, at any length.
 *
 *  The matrix 1 - dt K is symmetric and has no eigenvalue below 1. Each pair is a dyad of two floats, c_ij c_ij' with
 *  c = sqrt(b mu |g|) r/H, so that a product loads as much as one with D (projection.h). The acceleration a_v is summed
 *  over pairs in doubles from the solution: opposite in both particles of a pair, whatever the tolerance.
 *
 *  Boundary particles of a wall without slip have the velocities of terms/stick.h, without the bound of 1 + d_b/d_i =
 *  1.5 that Morris, Fox & Zhu 1997 need for explicit steps; so they have in the shear rate on which a viscosity depends.
 *  By liquid alone that of a wall was that of half a spacing and more before it, and a lid did not set in motion what
 *  has no viscosity at rest. Bodies slip freely. */
#ifndef SPH2D_METHODS_PROJECTION_IMPLICIT_VISCOSITY_H
#define SPH2D_METHODS_PROJECTION_IMPLICIT_VISCOSITY_H

#include "methods/common/method.h"
#include "simd/isa.h"

/** Sets whether viscosity is solved for, and b. The calibration and the system's head are known. */
void sph2d__implicit_viscosity_prepare(sph2d__system *system);

/** Whether a scene's viscosity is solved for: where walls do not slip, where it depends on the shear rate, and where
 *  else it would be the limit of the longest step that all else permits. The system's head is known. */
bool sph2d__viscosity_is_implicit(const sph2d__system *system);

/** Adds a_v for a step of `dt` [s] to the accelerations, which are those without pressure; the neighbours are gathered,
 *  pressures are those of the step before. False when memory is short. */
bool sph2d__implicit_viscosity_add(sph2d__system *system, double dt);

/** The energy that a_v takes in the step [J/m], with accelerations that now contain pressure but for `split` of it
 *  (projected.c); without what walls that move bring. */
double sph2d__implicit_viscosity_taken(sph2d__system *system, double dt, double split);

/** The force of boundary particle b on fluid particle i at (dx, dy) from it, by the velocities v* [N/m]. */
sph2d_vec2 sph2d__implicit_friction(const sph2d__system *system, size_t i, size_t b, double dx, double dy);

void sph2d__implicit_viscosity_free(sph2d__system *system);

/** Loops over the particles `first`, which begins a slab, to `last` - 1, compiled once for each instruction set. */
typedef struct sph2d__implicit_viscosity_pass {
    /** Dyads of all pairs, blocks of the walls and the matrix's diagonal for a step of `dt`. */
    void (*build)(sph2d__system *system, double dt, size_t first, size_t last);
    /** out = K v, less what walls that move add, of the solution, in doubles. */
    void (*accelerate)(sph2d__system *system, size_t first, size_t last);
    /** product = (1 - dt K) direction, in floats; returns direction . product. */
    double (*multiply)(sph2d__system *system, double dt, size_t first, size_t last);
} sph2d__implicit_viscosity_pass;

SPH2D__COPIES(sph2d__implicit_viscosity_pass, sph2d__implicit_viscosity_pass)

#endif
