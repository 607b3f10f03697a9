/* SPDX-License-Identifier: MIT */
/** @file fitted.h
 *  Method `wcsph` with fitted operators: weakly compressible flow of second order in space.
 *
 *  Around each particle i velocity and density are fitted by a quadratic polynomial through the particle's own value,
 *  by least squares over the neighbours with weights w = (1 - q)^3, q = r/H (moving least squares, Lancaster &
 *  Salkauskas 1981). With (xi, eta) = (x_j - x_i)/H, phi = (xi, eta, xi^2, xi eta, eta^2) and df = f_j - f_i:
 *
 *      A = sum w phi phi^T     b = sum w phi df      c = A^-1 b
 *      grad f = (c_1, c_2)/H   lap f = 2 (c_3 + c_5)/H^2 + gamma R
 *      R = 4 (sum w df - c . sum w phi) / ((A_11 + A_22) H^2)
 *
 *  R, the residual of the fit as a Laplacian, is of fourth derivatives of a smooth field and large for noise at the
 *  particle scale: gamma makes the Laplacian of r^4 exact on a lattice, and R of density is the density diffusion. It
 *  replaces delta-SPH's; volume and mass do not appear.
 *
 *  Particles move with the liquid plus a small shift velocity w_s against the concentration gradient (Lind et al. 2012;
 *  Sun et al. 2017, eq. 7), and the equations are written along these trajectories (Sun et al. 2019):
 *
 *      dx/dt   = v + w_s                       w_s = -s U S,  |w_s| <= U/2,  U the largest speed
 *      dv/dt   = -c^2 grad rho / rho + nu lap v + body force + (w_s . grad) v
 *      drho/dt = -rho div v + delta h c0 R(rho) + w_s . grad rho
 *      S       = 140/pi (dx/H)^2 sum w [1 + 0.2 (W(r)/W(dx))^4] (xi, eta),   W Wendland's C2
 *
 *  Momentum is not conserved to round-off: the error is that of the fit. If the neighbours are too few or on one line
 *  the fit falls back to a linear one, then to zero gradient. */
#ifndef SPH2D_METHODS_FITTED_FITTED_H
#define SPH2D_METHODS_FITTED_FITTED_H

#include "methods/common/method.h"
#include "methods/common/slabs.h"
#include "methods/common/state_equation.h"
#include "simd/isa.h"

/** The time scheme (adams_bashforth.c): method.h. */
sph2d_status sph2d__adams_bashforth(sph2d_sim *sim, double dt);

/** The pair loops, compiled once for each instruction set. */
typedef struct sph2d__fitted_passes {
    /** Sets the fluid's acceleration and density_rate along the motion of the liquid, its shift velocity, and the rates
     *  by advection with that. */
    sph2d__span_work *rates;
} sph2d__fitted_passes;

SPH2D__COPIES(sph2d__fitted_passes, sph2d__fitted_passes)

/** Force of the surface before boundary particle b of the first layer on the liquid [N/m] (fitted_walls.c). */
sph2d__wall_force sph2d__fitted_surface_force(const sph2d__system *system, size_t b);

/** gamma for a square lattice of spacing 1 and the support radius `ratio`. */
double sph2d__fitted_residual_gain(double ratio);

/* ---- what fits near walls know of their surfaces ----------------------------------------------------------------- */

/* Largest depth [dx] of boundary particles of the first layer, which represent the surface. */
static const double FIRST_LAYER = 0.75;
/* Weight of the density gradient known at a wall relative to neighbours. Without it the gradient at a wall is an
 * extrapolation, and a cavity at Re 1000 diverged. */
static const double GRADIENT_WEIGHT = 0.1;

/** The density gradient along the normal at boundary particle b, in units of H, for a density and a body force there. */
static inline double sph2d__fitted_slope(const sph2d__system *s, size_t b, double density, sph2d_vec2 at)
{
    const sph2d__store *w = &s->walls;
    double gx = -w->ax[b], gy = -w->ay[b];
    sph2d__forces_add(&s->forces, (sph2d__place){at.x, at.y, w->vx[b], w->vy[b]}, &gx, &gy);
    double c2 = s->sound_speed * s->sound_speed;
    return density / c2 * s->support * (gx * w->normal_x[b] + gy * w->normal_y[b]);
}

#endif
