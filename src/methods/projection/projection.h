/* SPDX-License-Identifier: MIT */
/** @file projection.h
 *  What methods with a pressure that follows from density have in common. Density is a sum over liquid and boundary
 *  particles, with the mass of a particle such that a filled lattice has the rest density (factor c):
 *
 *      rho_i = c sum_j m W(r_ij) + c sum_b m_b W(r_ib)
 *      G_ij  = (c m/rho0) grad W(r_ij),  G_ib = (c m_b/rho0) grad W(r_ib)   the gradients that neighbours.h keeps
 *      D u   = sum_j G_ij . (u_i - u_j) + sum_b G_ib . (u_i - u_b)         rate of rho_i/rho0 for velocities u
 *      D' y  = sum_j (y_i + y_j) G_ij + sum_b (y_i + y_b) G_ib             its transpose
 *
 *  For multipliers y = dt^2 l/rho0 the acceleration is -(1/rho0) D' l = -D' y/dt^2: with the transpose the forces
 *  between two particles of the liquid are opposite, so that momentum is kept, and D D' is symmetric and has no
 *  negative eigenvalue.
 *
 *  D' l is k grad l on a filled lattice, with k its moment -sum x_ij . G_ij/2 (0.947 for Wendland's C2 at H = 2.4 dx),
 *  so that the pressure is p = k l.
 *
 *  D D' hardly sees fields that change sign from neighbour to neighbour: three quarters of the scatter of p at rest lie
 *  in them, push nobody, and no tolerance removes them. So the reported pressure is the value at each particle of a
 *  linear fit to the pressures of the liquid around it and of the first layer of wet walls (moving least squares, Lancaster & Salkauskas
 *  1981), with weights 1 - q: linear fields stay as they are, at surfaces too, and of a lattice's alternating ones 0 to
 *  7 % are left (a kernel's weights leave up to a quarter of those that alternate by rows). p itself acts, and the
 *  solver goes on from it.
 *
 *  Boundary particles have rows of their own, with what liquid adds there instead of a density:
 *
 *      (D u)_b  = sum_j G_jb . (u_j - u_b)                                 rate of g_b
 *      g_b      = (m_b/m) (c sum_j m W(r_bj)/rho0 - filled_b)
 *
 *  where filled_b is that sum for a lattice that fills the room in front of the wall. Their pressure is what
 *  holds liquid off the wall (pressure boundaries, Band et al. 2018); without it the first row of liquid has twice the
 *  pressure of the second. In corners, where no surface is straight, they have none: there liquid particles see their
 *  own pressure in them (Akinci et al. 2012, eq. 7). */
#ifndef SPH2D_METHODS_PROJECTION_PROJECTION_H
#define SPH2D_METHODS_PROJECTION_PROJECTION_H

#include "methods/common/method.h"
#include "methods/common/slabs.h"
#include "simd/isa.h"

/** The time scheme (projected.c): method.h. */
sph2d_status sph2d__projected(sph2d_sim *sim, double dt);

/** Finds the neighbours, and with them the density and the acceleration by viscosity, body force and surface tension of
 *  every fluid particle; of boundary particles the diagonal of D D', and in place of a density what they
 *  would have if the wall alone had the rest density. The cells are up to date. False when memory is short. */
bool sph2d__projection_gather(sph2d__system *system);

/** next = x + dt v + dt^2 a - D' direction: where particles will be. Directions are a float twice (lanes.h): as good as the
 *  gradients. */
void sph2d__projection_next_positions(sph2d__system *system);

/** residual = rho+/rho0 - 1, and g_b, for the rows of a slab, with the fluid at `next`, boundary particles moved on by
 *  their velocities over the step, and the neighbours as they are. */
void sph2d__projection_predict(sph2d__system *system, const sph2d__slab *slab);

/** Multipliers y = dt^2 p/(k rho0) from the pressures, which are those of the step before, times `part`, and the same
 *  as directions; and back: from multipliers pressures, and their part of the acceleration. */
void sph2d__projection_begin(sph2d__system *system, double part);
void sph2d__projection_end(sph2d__system *system);

/** Keeps the accelerations without pressure in free_ax and free_ay. */
void sph2d__projection_keep(sph2d__system *system);

/** Adds the acceleration by the pressures of the step before. */
void sph2d__projection_press(sph2d__system *system);

/** The pressures that are reported, from those of the solver and the neighbours as they are. */
void sph2d__projection_average(sph2d__system *system);

/** The force of a boundary particle by the pressures that the solver left: method.h. */
sph2d__wall_force sph2d__projection_wall_force(const sph2d__system *system, size_t i, size_t b, double dx, double dy);

/** Elastic energy of particle i [J/kg]: c0^2 e^2/2 at the compression e that a pressure holds: the smaller of
 *  g = rho/rho0 - 1 and p/(rho0 c0^2). More is an error, which is put right without giving energy back. Before the first step (not
 *  `pressed`) nobody has a pressure, and density tells it. Method pcisph does not know of what it stops at,
 *  max_compression:
 *  there e is what is beyond. 0 without a speed of sound. */
double sph2d__projection_elastic(const sph2d__system *system, size_t i, bool pressed);

/** The shortest of the limits of method.h, without sound: no particle goes farther than cfl H, and none would under
 *  the largest pressure, for which the gradients of a step must hold. */
double sph2d__projection_step(const sph2d__system *system, double speed, double acceleration, sph2d__limit *limit);

/** sum |G|^2 of a particle in a filled square lattice of the system's spacing [1/m^2]. */
double sph2d__projection_prototype(const sph2d__system *system);

/** Sets the calibration c, and what fills the room in front of boundary particles. */
void sph2d__projection_prepare(sph2d__system *system);

/** The arrays that this needs, besides those of the method. */
#define SPH2D__PROJECTION_ROWS                                                                                         \
    (SPH2D__BIT(density) | SPH2D__BIT(pressure) | SPH2D__BIT(acting_pressure) | SPH2D__BIT(multiplier) |               \
     SPH2D__BIT(residual) | SPH2D__BIT(direction))
#define SPH2D__PROJECTION_FLUID                                                                                        \
    (SPH2D__STORE_BASIC | SPH2D__PROJECTION_ROWS | SPH2D__BIT(ax) | SPH2D__BIT(ay) | SPH2D__BIT(free_ax) |             \
     SPH2D__BIT(free_ay) | SPH2D__BIT(stretch) | SPH2D__BIT(shear) | SPH2D__BIT(density_rate))
#define SPH2D__PROJECTION_CARRIED                                                                                      \
    (SPH2D__STORE_BASIC | SPH2D__BIT(density) | SPH2D__BIT(pressure) | SPH2D__BIT(acting_pressure) | SPH2D__BIT(ax) |  \
     SPH2D__BIT(ay))
#define SPH2D__PROJECTION_WALLS                                                                                        \
    (SPH2D__STORE_BASIC | SPH2D__PROJECTION_ROWS | SPH2D__BIT(normal_x) | SPH2D__BIT(normal_y) | SPH2D__BIT(depth) |   \
     SPH2D__BIT(ax) | SPH2D__BIT(ay) | SPH2D__BIT(start_x) | SPH2D__BIT(start_y) | SPH2D__BIT(mass) |                  \
     SPH2D__BIT(bounce) | SPH2D__BIT(filled) | SPH2D__BIT(diagonal))

/** Gathering for the particles of one slab, compiled once for each instruction set and kernel; false when it is full.
 */
typedef struct sph2d__projection_gather_pass {
    size_t lanes; /**< that it is compiled with */
    bool (*fluid[SPH2D_KERNEL_COUNT])(sph2d__system *system, size_t slab);
    bool (*walls[SPH2D_KERNEL_COUNT])(sph2d__system *system, size_t slab);
} sph2d__projection_gather_pass;

/** The other pair loops, for particles `first`, which begins a slab, to `last` - 1. Prediction is compiled once for
 *  each kernel, too. */
typedef struct sph2d__projection_passes {
    void (*move)(sph2d__system *system, size_t first, size_t last);
    void (*press)(sph2d__system *system, double share, size_t first, size_t last);
    void (*average)(sph2d__system *system, size_t first, size_t last);
    void (*predict_fluid[SPH2D_KERNEL_COUNT])(sph2d__system *system, size_t first, size_t last);
    void (*predict_walls[SPH2D_KERNEL_COUNT])(sph2d__system *system, size_t first, size_t last);
} sph2d__projection_passes;

SPH2D__COPIES(sph2d__projection_gather_pass, sph2d__projection_gather)
SPH2D__COPIES(sph2d__projection_passes, sph2d__projection_passes)

#endif
