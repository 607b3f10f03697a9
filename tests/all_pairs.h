/* SPDX-License-Identifier: MIT */
/** @file all_pairs.h
 *  A cloud of particles for method `wcsph` with symmetric operators, with random velocities and densities, and forces
 *  as sums over all pairs, written here from the papers (wcsph.h has the list):
 *
 *      a_i        = -sum m_j (p_i/rho_i^2 + p_j/rho_j^2) grad W + viscosity                       h = H/2
 *      morris     = sum m_j (mu + mu)/(rho_i rho_j) (r_ij . grad W)/r^2 v_ij                   Morris 1997, eq. 22
 *      monaghan   = sum V_j 8 mu/rho_i (v_ij . r_ij)/(2 <r^2>) grad W                  weights of terms/viscosity.h
 *      artificial = the same with mu = alpha rho0 c0 h/8 and 1/r^2 in place of 1/(2 <r^2>),    <r^2> the integral of W r^2 over the plane
 */
#ifndef SPH2D_TESTS_ALL_PAIRS_H
#define SPH2D_TESTS_ALL_PAIRS_H

#include "common.h"
#include "sim/simulation.h"

/** Particles along a side of the cloud; their spacing [m], speed of sound [m/s] and rest density [kg/m^3]. */
enum { SIDE = 14 };
static const double DX = 0.02, C0 = 20, RHO0 = 1000;

/** For a test to change before it makes the simulation. */
extern sph2d_scene scene;
extern sph2d_block block;

/** Fixture of every test: lays out the scene; ends the simulation. */
void start(void);
void finish(void);

/** Makes it, and gives every particle a velocity of up to 1 m/s and a density within 3 % of the rest density. */
sph2d__system *make(sph2d_isa isa);

/** W by the literature's polynomials. */
double weight(sph2d_kernel kernel, double support, double r);

/** What the sums need of a neighbour: the fluid's and the walls' particles alike. */
typedef struct other {
    double dx, dy, r, vx, vy, mass, density, pressure; /* dx = x_i - x_j; v = v_i - v_j */
    double slope, weight;                              /* grad W = slope r_ij */
} other;

/** How far liquid slides along the wall of boundary particle b, from 0 to 1, and the unit vector along it. */
double slides(const sph2d__system *s, size_t b, sph2d_vec2 *along);

other other_of(const sph2d__system *s, size_t i, const sph2d__store *from, size_t j);

/** That a value of particle i is as expected, to round-off of sums of this size. */
void close_to(double value, double expect, double size, const char *what, size_t i);

/** That the accelerations of all particles are those of all pairs. */
void check_forces(sph2d__system *s);

#endif
