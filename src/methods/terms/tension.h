/* SPDX-License-Identifier: MIT */
/** @file tension.h
 *  Surface tension of a liquid with a free surface, for methods `muller`, `wcsph`, `pcisph` and `constraint`:
 *  a band along the surface has an energy.
 *
 *  With d the distance of a point to the nearest particle, in spacings, the energy is that of the empty space around,
 *
 *      E = e integral w(d) dA,   w = (d^2 - a1^2)(a2^2 - d^2) for a1 < d < a2, and 0 elsewhere,
 *
 *  an average over radii of the perimeter of the union of discs around the particles: flowing liquid has no such points
 *  inside. E and its gradient are continuous when surface particles change neighbours, and liquid that separates or
 *  merges gains or loses the energy of its surface. The integral over a particle's Voronoi cell is evaluated exactly,
 *  by triangles and sectors.
 *
 *  When a particle moves, w moves with it, and so do the edges of its cell, on which its neighbours have the same w. By
 *  Gauss's theorem the force is thus the sum over its neighbours of e times the integral of w along their common edge:
 *  opposite pairs of central forces, which conserve momentum and angular momentum to round-off. No normal and no
 *  curvature is computed; a film of one row has two surfaces. In methods that know the distance to the surface,
 *  particles farther inside than H have none.
 *
 *  The force along a straight row of particles is 4 % more than its energy per length, since its particles stay the
 *  same and those of a flowing surface do not; e is such that the mean of both is sigma.
 *
 *  Boundary particles that exert pressure have cells, too, without energy: dry and wet walls have the same energy, so
 *  that the contact angle is 90 degrees. An edge between w and nothing moves with the particle, by (p . u)/r if the
 *  particle moves by u, p is the point on the edge from it and r the distance of the two particles; w is lost there.
 *  Walls that only reflect and spring walls are not wetted. */
#ifndef SPH2D_METHODS_TERMS_TENSION_H
#define SPH2D_METHODS_TERMS_TENSION_H

#include "methods/common/system.h"

/** Energy of the surface [J/m]: sigma times its length, and 2 pi sigma a for each drop, a between a1 and a2, since the
 *  band lies outside the particles' centres. */
double sph2d__tension_energy(const sph2d__system *system);

/** The part of it of particles within a rectangle [J/m]: a change somewhere affects particles within two outer radii.
 *  The cells are up to date. */
double sph2d__tension_energy_within(const sph2d__system *system, sph2d_box box);

/** Adds the acceleration by surface tension to every fluid particle's; nothing without surface tension. The cells and
 *  the distances to the surface are up to date. */
void sph2d__tension_add(sph2d__system *system);

/** Adds the forces by which boundary particles, by their index, pull on the liquid [N/m]. */
void sph2d__tension_of_walls(const sph2d__system *system, sph2d_vec2 *forces);

/** The longest step that is stable for capillary waves [s]: 0.5 sqrt(rho dx^3/sigma), half the limit of a chain of
 *  masses rho dx^2 under the tension sigma (w = 2 sqrt(sigma/(rho dx^3)), w dt < 2); infinite without tension. */
double sph2d__tension_step(const sph2d__system *system);

#endif
