/* SPDX-License-Identifier: MIT */
/** @file muller.h
 *  The three kernels of Mueller, Charypar & Gross 2003, normalised for two dimensions.
 *
 *  H is the support radius [m]: each kernel is zero from H on. A kernel is a constant times a shape; pair loops sum the
 *  shapes and multiply once. The constants normalise the integral over the plane (poly6, spiky) and the second moment
 *  of the Laplacian (viscosity); the three-dimensional ones, 315/(64 pi H^9), 45/(pi H^6), are wrong here by factors
 *  that depend on the unit of length. */
#ifndef SPH2D_KERNELS_MULLER_H
#define SPH2D_KERNELS_MULLER_H

#include <math.h>

#include "base/pi.h"

/** poly6: W(r) = poly6_constant * (H^2 - r^2)^3 [1/m^2], for density. */
static inline double sph2d__poly6_shape(double support2, double r2)
{
    double d = support2 - r2;
    d = d > 0 ? d : 0;
    return d * d * d;
}

static inline double sph2d__poly6_constant(double support)
{
    double h2 = support * support;
    return 4 / (SPH2D__PI * h2 * h2 * h2 * h2);
}

/** spiky: W = 10/(pi H^5) (H - r)^3, so that -dW/dr = spiky_constant * (H - r)^2 [1/m^3], for pressure. */
static inline double sph2d__spiky_constant(double support)
{
    double h2 = support * support;
    return 30 / (SPH2D__PI * h2 * h2 * support);
}

/** viscosity: lap W = viscosity_constant * (H - r) [1/m^4], positive everywhere. */
static inline double sph2d__viscosity_constant(double support)
{
    double h2 = support * support;
    return 40 / (SPH2D__PI * h2 * h2 * support);
}

/** dx^2 times the sum of poly6 over a full square lattice, including the particle itself: its summation density over
 *  the rest density. */
static inline double sph2d__poly6_lattice_sum(double support, double spacing)
{
    int reach = (int)(support / spacing) + 1;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j) {
            double x = i * spacing, y = j * spacing;
            sum += sph2d__poly6_shape(support * support, x * x + y * y);
        }
    return sum * sph2d__poly6_constant(support) * spacing * spacing;
}

/** The stress of the pair forces in a lattice over the p of its particles. That of pair forces m/rho_i m/rho_j p
 *  |W'_spiky| is, by the virial,
 *
 *      P = 1/4 sum_j (dx^2 p |W'_spiky(r_ij)|) r_ij,
 *
 *  p/2 for a dense lattice, since the integral of r |W'| over the plane is 2: (p_i + p_j)/2 makes half a gradient. */
static inline double sph2d__spiky_lattice_stress(double support, double spacing)
{
    int reach = (int)(support / spacing) + 1;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j) {
            double r = hypot((double)i, (double)j) * spacing, w = fmax(support - r, 0);
            sum += r * w * w;
        }
    return sum * sph2d__spiky_constant(support) * spacing * spacing / 4;
}

/** Relative increase of summation density over that of number density, for a full lattice: 1 in the limit H/dx to
 *  infinity. */
static inline double sph2d__poly6_lattice_response(double support, double spacing)
{
    int reach = (int)(support / spacing) + 1;
    double slopes = 0, values = 0;
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j) {
            double r2 = (i * i + j * j) * spacing * spacing, d = fmax(support * support - r2, 0);
            values += d * d * d;
            slopes += 3 * r2 * d * d;
        }
    return slopes / values;
}

/** Summation density over rest density of a full lattice of `spacing` that is compressed uniformly to spacing s. */
static inline double sph2d__poly6_compressed(double support, double spacing, double s)
{
    double part = sph2d__poly6_lattice_sum(support, s) / sph2d__poly6_lattice_sum(support, spacing);
    return part * spacing * spacing / (s * s);
}

/** G, the factor on the pressure p in pair forces of that lattice with which their work is that of p: their stress is
 *  proportional to S(s) = sum r |W'_spiky|/4 while the area of a particle changes by dA = d(s^2) and 1/rho by d(1/rho).
 *  The work P dA = p m d(1/rho) of the pair stress P = p V^2 S/A, V = m/rho, A = s^2, requires
 *
 *      p_pairs/p = (d ln rho/d ln n) rho/S, over its value in the lattice at rest, n = 1/s^2.
 *
 *  0.93 at H/dx = 2 for 1.2 times rest density: with p itself pair forces returned 8 % more work than was reported. */
static inline double sph2d__muller_pair_gain(double support, double spacing, double s)
{
    double stress = sph2d__spiky_lattice_stress(support, spacing) / sph2d__spiky_lattice_stress(support, s);
    double response = sph2d__poly6_lattice_response(support, s) / sph2d__poly6_lattice_response(support, spacing);
    return stress * response * sph2d__poly6_lattice_sum(support, s) / sph2d__poly6_lattice_sum(support, spacing);
}

/** The fraction of a lattice's poly6 sum due to particles from row `rows` and column `columns` on. */
static inline double sph2d__poly6_part(double support, double spacing, int columns, int rows)
{
    int reach = (int)(support / spacing) + 1;
    double sum = 0;
    for (int i = columns; i <= reach; ++i)
        for (int j = rows; j <= reach; ++j)
            sum += sph2d__poly6_shape(support * support, (i * i + j * j) * spacing * spacing);
    return sum * sph2d__poly6_constant(support) * spacing * spacing / sph2d__poly6_lattice_sum(support, spacing);
}

/** That of the rows on one side of the particle, and that of a quarter without its row and column. */
static inline double sph2d__poly6_beyond_sum(double support, double spacing)
{
    return sph2d__poly6_part(support, spacing, -(int)(support / spacing) - 1, 1);
}

static inline double sph2d__poly6_quarter_sum(double support, double spacing)
{
    return sph2d__poly6_part(support, spacing, 1, 1);
}

/** The squared speed of sound over k in p = k (rho - rho0) for a full lattice: 0.443 at H/dx = 2. */
static inline double sph2d__muller_stiffness(double support, double spacing)
{
    return sph2d__spiky_lattice_stress(support, spacing) * sph2d__poly6_lattice_response(support, spacing);
}

#endif
