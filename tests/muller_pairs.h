/* SPDX-License-Identifier: MIT */
/** @file muller_pairs.h
 *  Density, pressure and acceleration of method `muller` as sums over all pairs, written from the equations of Mueller,
 *  Charypar & Gross 2003 with two-dimensional kernel constants:
 *
 *      rho_i = c sum_j m W(r_ij) + sum_b m_b W(r_ib),  W = 4/(pi H^8) (H^2 - r^2)^3
 *      p_i   = max(k (rho_i - rho0), 0), told as P p_i
 *      a_i   = 1/rho_i sum_j V_j (q_i + q_j)/2 30/(pi H^5) (H - r)^2 r_ij/r
 *              + mu/rho_i sum_k V_k (v_k - v_i) 40/(pi H^5) (H - r) - P p_i/rho_i^2 sum_b m_b grad W(r_ib)
 *
 *  with q = G(rho) p, G by which the pairs of a compressed lattice do the work that P p tells, V = m/rho, j over fluid,
 *  b over heavy boundary particles and k over both, c = 1/(dx^2 sum of W over a filled lattice), boundary masses
 *  m_b = rho0 / sum_b' W(r_bb') and boundary densities rho0 + c sum_j m W(r_bj). P is what the pairs of a filled
 *  lattice carry, dx^2/4 sum r 30/(pi H^5) (H - r)^2, and mu is 0.1 rho0 c0 H at least, where c0^2 = P k D and D is by
 *  how much c sum m W grows when a lattice is compressed. */
#ifndef SPH2D_TESTS_MULLER_PAIRS_H
#define SPH2D_TESTS_MULLER_PAIRS_H

#include "common.h"

/** Particles along a side of the usual block, and of all of it; a cloud has 4 COUNT at most. */
enum { SIDE = 20, COUNT = SIDE * SIDE, WALLS_MOST = 64 };
/** The spacing [m]. */
static const double DX = 0.01;

/** One set of particles as the reference sees it. */
typedef struct cloud {
    size_t count;
    double x[4 * COUNT], y[4 * COUNT], vx[4 * COUNT], vy[4 * COUNT], mass[4 * COUNT], rho[4 * COUNT], p[4 * COUNT];
    double gain[4 * COUNT];
} cloud;

/** H, rest density, mass of a particle, k, mu, c, P, spacing. */
typedef struct liquid {
    double support, rho0, mass, stiffness, mu, calibration, carried, dx;
} liquid;

/** What the reference sees of the liquid and of heavy boundary particles, with what it sums up. */
extern cloud fluid, walls;

/** W at a squared distance. */
double kernel(double support, double r2);
/** The numbers of a scene's liquid. */
liquid liquid_of(const sph2d_scene *scene);
/** G at a density over rest density: growth of density with the number on the area, over what pairs push, each over
 *  that of the lattice at rest. */
double pair_gain(const liquid *l, double density);
/** Masses, densities and p of both clouds, from their places. */
void sum_densities(const liquid *l);
/** Adds a cloud's part of a_i; *size sums the sizes of the terms, with k rho for p, since rounding of rho enters so. */
void add_forces(const liquid *l, size_t i, const cloud *from, double a[2], double *size);

#endif
