/* SPDX-License-Identifier: MIT */
/** @file tension.h
 *  Surface tension of a liquid with a free surface, for methods `muller` and `wcsph`: strings along the
 *  surface.
 *
 *  Around every particle stands a disc of radius a, wide enough that the discs leave no hole in the liquid. Two
 *  particles are neighbours on the surface when their circles meet at a point that no other disc covers: the edge of an
 *  alpha shape (Edelsbrunner, Kirkpatrick & Seidel 1983). For each such point the two attract each other by sigma.
 *
 *  The forces are the gradient of sigma times the length of the edges. They are central and come in opposite pairs:
 *  momentum and angular momentum are kept to round-off. No normal and no curvature is computed; a film of one row has
 *  two surfaces, a particle by itself none. Where a method knows how far the surface is, particles farther inside
 *  than H have no edges.
 *
 *  Boundary particles that press cover as liquid does. Where a fluid particle shares a point with one of a layered
 *  wall, the surface ends on the wall, and sigma pulls the particle straight at it: the contact angle is a right one.
 *  Other walls do not pull: they are not wetted. */
#ifndef SPH2D_METHODS_TENSION_H
#define SPH2D_METHODS_TENSION_H

#include "methods/system.h"

/** Energy of the surface: sigma times the length of the edges between fluid particles [J/m]. */
double sph2d__tension_energy(const sph2d__system *system);

/** Adds the acceleration by surface tension to every fluid particle's; nothing where the liquid has none. The cells and
 *  the distances to the surface are up to date. */
void sph2d__tension_add(sph2d__system *system);

/** The longest step that the fastest ripples of the surface's particles stand [s]: 0.5 sqrt(rho dx^3/sigma), half of
 *  what a chain of masses rho dx^2 under the tension sigma allows (w = 2 sqrt(sigma/(rho dx^3)), w dt < 2);
 *  infinite without tension. */
double sph2d__tension_step(const sph2d__system *system);

#endif
