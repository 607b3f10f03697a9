/* SPDX-License-Identifier: MIT */
/** @file tension.h
 *  Surface tension of a liquid with a free surface, for methods `muller`, symmetric `wcsph`, `pcisph` and `constraint`:
 *  a band along the surface has an energy.
 *
 *  With d the distance of a place to the nearest particle, in spacings, the energy is that of the empty places around,
 *
 *      E = e integral w(d) dA,   w = (d^2 - a1^2)(a2^2 - d^2) for a1 < d < a2, and 0 elsewhere,
 *
 *  a mean over radii of the perimeter of all discs around the particles: liquid that flows has no such places inside. E
 *  and its gradient have no jumps, whatever neighbours the surface finds, and liquid parts and joins by as much energy
 *  as it has surface. The integral over a particle's Voronoi cell goes by triangles and sectors, exactly.
 *
 *  Moving a particle moves w with its cell, and the cell's borders, where its neighbours have the same w. So what it
 *  feels, by Gauss's theorem, is the sum over its neighbours of e times the integral of w along their common border:
 *  opposite pairs of central forces, which keep momentum and angular momentum to round-off. No normal and no curvature
 *  is computed; a film of one row has two surfaces. Where a method knows how far the surface is, particles farther
 *  inside than H have none.
 *
 *  A straight row of particles is drawn by 4 % more than it has energy a length, since its particles stay the same and
 *  those of a surface that flows do not; e makes the mean of both sigma.
 *
 *  Boundary particles that press have cells, too, without energy: dry and wet walls cost nothing, so that the contact
 *  angle is a right one. There a border between w and nothing moves with the particle, by (p . u)/r where the particle
 *  moves by u, p is the place from it and r the distance of the two; so much of w is lost. Walls that only reflect and
 *  springs are not wetted. */
#ifndef SPH2D_METHODS_TERMS_TENSION_H
#define SPH2D_METHODS_TERMS_TENSION_H

#include "methods/common/system.h"

/** Energy of the surface: sigma times its length, and that of the particles' radii around each drop, 2 pi sigma a, a
 *  between a1 and a2 [J/m]. */
double sph2d__tension_energy(const sph2d__system *system);

/** The part of it of particles within a rectangle [J/m]: what changes somewhere changes it for those that are no
 *  farther than two outer radii from there. The cells are up to date. */
double sph2d__tension_energy_within(const sph2d__system *system, sph2d_box box);

/** Adds the acceleration by surface tension to every fluid particle's; nothing where the liquid has none. The cells and
 *  the distances to the surface are up to date. */
void sph2d__tension_add(sph2d__system *system);

/** The longest step that the fastest ripples of the surface's particles stand [s]: 0.5 sqrt(rho dx^3/sigma), half of
 *  what a chain of masses rho dx^2 under the tension sigma allows (w = 2 sqrt(sigma/(rho dx^3)), w dt < 2);
 *  infinite without tension. */
double sph2d__tension_step(const sph2d__system *system);

#endif
