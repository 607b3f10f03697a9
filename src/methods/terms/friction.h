/* SPDX-License-Identifier: MIT */
/** @file friction.h
 *  Friction of walls in layers, between free slip and no slip, of method `wcsph`:
 *  `wall_slip: smooth`.
 *
 *  In most scenes the boundary layer of water along a wall is thinner than the spacing, so that particles do not
 *  resolve its friction. It follows from a law of the wall. With u the speed of the liquid along the wall at a distance
 *  y, nu = mu/rho0 and c = sqrt(tau/rho0), the stress tau is that for which
 *
 *      u/c = c L/nu + f(c y/nu),   f(s) = s below s = 11.3,   ln(9 s)/0.41 from there on
 *
 *  (von Karman 1930; 9 and 0.41 for a smooth wall and the two layers by Launder & Spalding 1974, Comput. Methods Appl.
 *  Mech. Eng. 3, 269-289). L is the slip length (Navier 1823): the depth behind the surface at which the extrapolated
 *  velocity is that of the wall. In laminar flow tau = mu u/(y + L); liquid without viscosity has no friction.
 *
 *  Boundary particles b of the row next to the surface represent pieces of it of length A_b. u and y are averages over
 *  the liquid in front, i within the support radius and before the plane of the row, with the kernel's weights, by
 *  which it also takes the force:
 *
 *      u_b   = t . (sum v_i W_ib / sum W_ib - v_b),      y_b = sum y_i W_ib / sum W_ib, a quarter of dx at least
 *      F_bi  = -A_b e_b tau(|u_b|, y_b) sign(u_b) t W_ib / sum_k W_kb
 *
 *  e_b is the wetted part of the piece: sum W_ib over that of a full row of particles next to the surface, at most 1.
 *  So a row of liquid wets as much wall as it is long. The power is -A_b e_b tau |u_b| for a wall at rest, never above
 *  0, and the forces on liquid and wall are opposite pair by pair. */
#ifndef SPH2D_METHODS_TERMS_FRICTION_H
#define SPH2D_METHODS_TERMS_FRICTION_H

#include "methods/common/system.h"

/** Whether there is wall friction: walls are smooth, and the liquid has a viscosity. */
bool sph2d__has_friction(const sph2d__system *system);

/** The stress tau [Pa] of liquid with `speed` >= 0 [m/s] along a wall at a distance > 0 [m], by the law above. */
double sph2d__friction_stress(double speed, double distance, double slip_length, double density, double viscosity);

/** Sets the friction of every boundary particle, from the positions and velocities of the liquid. */
void sph2d__friction_set(sph2d__system *system);

/** Adds the acceleration by friction to every fluid particle's. */
void sph2d__friction_add(sph2d__system *system);

/** The force of boundary particle b on particle i of the fluid at (dx, dy) from it, as last set [N/m]. */
sph2d_vec2 sph2d__friction_of(const sph2d__system *system, size_t b, double dx, double dy);

#endif
