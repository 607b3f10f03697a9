/* SPDX-License-Identifier: MIT */
/** @file wcsph.h
 *  Method `wcsph` with symmetric operators: delta-SPH, for free surfaces and impacts.
 *
 *  With V = m/rho, r_ij = x_i - x_j, v_ij = v_i - v_j, the smoothing length h = H/2 and grad W the gradient at i:
 *
 *      drho_i/dt = sum m_j v_ij . grad W + delta h c0 sum V_j psi_ij . grad W                  (Monaghan 1994, eq. 2.3)
 *      psi_ij    = 2 [(rho_i - rho_j) - (grad rho_i + grad rho_j) . r_ij / 2] r_ij/r^2         (Antuono et al. 2010)
 *      or          2 [(rho_i - rho_j) - (rho_i - rho_j of a liquid at rest)] r_ij/r^2        (Fourtakas et al. 2019)
 *      dv_i/dt   = -sum m_j (p_i/rho_i^2 + p_j/rho_j^2) grad W + viscosity + body force        (Monaghan 1994, eq. 2.2)
 *      morris    = 2 mu/rho_i sum V_j (r_ij . grad W)/r^2 v_ij                       (Morris et al. 1997, eq. 22)
 *      monaghan  = 8 mu/rho_i sum V_j (v_ij . r_ij)/(2 <r^2>) grad W,  8 = 2 (2 + d)   (Monaghan & Gingold 1983, whose
 *                  1/r^2 is 1/(2 <r^2>) here: terms/viscosity.h)
 *
 *  The stress of Morris' form is mu grad v; the missing part, mu (grad v)^T, has no divergence inside the liquid and
 *  matters only at a free surface: waves decay at half their rate, and rotation is slowed down. Monaghan's form has no
 *  stress at a free surface in the mean (Colagrossi et al. 2011, Phys. Rev. E 84, 026705, where the factor 2 (2 + d) is
 *  derived). Along the rows of a lattice its viscosity is 0.996 of mu in shear and 1.04 in stretching (Wendland C2,
 *  H/dx = 3; with 1/r^2 0.89 and 1.11). It is the default of scenes with a free surface.
 *
 *  Boundary particles b of walls in layers enter all sums except the diffusion, with (Adami, Hu & Adams 2012, eq. 27;
 *  a_b the wall's acceleration, g the body force, j over the liquid around b)
 *
 *      p_b       = [sum p_j W + (g - a_b) . sum c_j rho_j r_bj W] / sum W,   rho_b from the equation of state
 *      drho_i/dt = ... + sum m_b (v_i - v_b) . grad W + sum m_b W_bi (rho_i/rho_b)^2 D_b
 *      D_b       = sum (v_j - v_b) . grad W_jb / sum W
 *
 *  which is exact for a liquid at rest. The last sum returns the energy that p_b takes: it is the transpose of the
 *  first part of p_b, so that the power of p_b on the liquid, -sum m_j v_j . m_b p_b/rho_b^2 grad W_jb, is that of the
 *  liquid's own density. A wall at rest then neither adds nor removes energy, whatever its shape and however few
 *  particles are near it, except by the hydrostatic part of p_b. That part has no potential, and an isolated particle
 *  would climb a wall by it; so it counts connected liquid, c_j = 1, not isolated particles, c_j = 0 (by `filling`).
 *
 *  Where the free surface meets a smooth wall, and in films along it, these sums do work on liquid that slides: p_b and
 *  D_b vary along the wall near the end of the liquid. There the wall slips with the liquid by a factor s_b: 1 where
 *  the liquid around b has little filling, 0 where it is inside (wall_pair.h). With t along the wall, v_b gets
 *  s_b t t . (sum v_j W / sum W - v_b) more, the parts along t of D_b and of the force of p_b are reduced to 1 - s_b,
 *  and in return the liquid has
 *
 *      dv_i/dt   = ... + sum m_b s_b W_bi/(sum W) t_b t_b . sum_k p_k/rho_k^2 grad_k W_kb
 *
 *  which again is the transpose, so that energy is conserved. Oscillations below 0.002 c0 do not count as sliding: the
 *  last sum is not hydrostatically balanced, and with it a surface at rest stands 0.25 dx too high beside a wall of 45
 *  degrees (0.3 with weight given back pair by pair), 0.07 too low without. There is no slip under a cover of liquid,
 *  nor where another wall is in front, as in corners: where a wall ends the liquid the last sum would push it. A side
 *  that slides along itself has v_b = 0 here: it drags liquid by friction alone. A rough wall has viscosity with
 *  v_b = v_wall - d_b/d (sum v_j W / sum W - v_wall), d_b and d the distances of b and, in the mean by W, of the liquid
 *  from the surface, a smooth one the friction of friction.h. Of a wall that turns at omega the velocity relative to the
 *  wall at the place of each j is mirrored, so that liquid that turns along feels nothing: v_b gets
 *  omega z x sum (x_j - x_b) W / sum W more. Walls may differ in their slip, a boundary particle from another.
 *  In Morris' form, where viscosity is far from limiting the step, v_b differs by pair in place of that, and walls go on
 *  with the curvature of the profile, too (terms/stick.h). The zone behind a step (examples/step) is then 0.161, 0.107
 *  and 0.056 of the step's height too short with 8, 12 and 16 spacings to the step, without 0.081, 0.075 and 0.061.
 *
 *  Isolated particles have the rest density, and no pressure of their own: a density kept from the liquid that they
 *  left would make them stick to walls.
 *
 *  grad rho_i is renormalised: exact for linear density, so that psi vanishes there pair by pair and a liquid at rest
 *  keeps its surface. Artificial viscosity alpha is the monaghan form with mu = rho0 alpha h c0/8, in approach and
 *  recession alike. Rate of density and pressure force conserve energy without dissipation and shifting.
 *
 *  After splashes particles move in a disordered way, with eddies that the kernel does not resolve. The liquid is then
 *  less dense than it should be and comes to rest slowly. Smagorinsky's subgrid viscosity (1963) with the whole width
 *  of the kernel as the filter (SPH as a filter: Di Mascio et al. 2017, Phys. Fluids 29, 035102) damps in monaghan form,
 *  of weight W'/r, with
 *
 *      mu_ij = rho0 (2 C H)^2 (|S_i| + |S_j|)/2,   |S| = sqrt(2 S:S) without the rate of volume,   C = 0.15
 *
 *  acting on unresolved differences only: v_ij . r_ij is limited to four times its nonlinear part, v_ij . r_ij minus
 *  r_ij . (S_i + S_j)/2 . r_ij, S without its trace. Smooth strain is not damped, as with artificial viscosities after
 *  a limited linear reconstruction (Frontiere, Raskin & Owen 2017, J. Comput. Phys. 332, 160). In a dam break 40
 *  spacings high the level at t sqrt(g/H) = 20 is 5 % too high without subgrid viscosity, 0.5 % too high with it, and
 *  0.9 % with C = 0.12. A stretching drop, R/dx = 25, is 0.14 % too short, 0.27 % without the limiter and C = 0.12. A
 *  wave at Re = 2000 and 50 spacings of depth decays at 0.050 1/s without, 0.053 with it and 0.161 with alpha = 0.02,
 *  which does as much for the dam break; in theory at 0.042.
 *
 *  The rate of density does not account for surfaces that merge or separate: the density would drift by per cents from
 *  the number of particles per area in a dam break, and the final level would be wrong by as much. Inside the liquid,
 *  farther than H from its surface, density therefore also relaxes to its sum over neighbours, in the time 100 H/c0:
 *
 *      drho_i/dt = ... + c0/(100 H) (rho0 sum (m_j/m) W / sum over a lattice W - rho_i)
 *
 *  The second psi vanishes at rest under gravity and a central force, where d rho is rho0/c0^2 times the work they do;
 *  not in periodic directions, in which there is no hydrostatic pressure.
 *
 *  Particles are shifted with velocity w (shift.h) against the concentration gradient. Their density changes by
 *  w . grad rho (Sun et al. 2019); their velocity does not, so that shifting changes no kinetic energy. The smaller
 *  eigenvalue of sum V_j r_ji grad W, 1 in full neighbourhoods and half at a flat surface, detects the free surface
 *  (Marrone 2010): within H of it shifts have no normal component, and in spray there are none (Sun et al. 2017).
 *
 *  Pair loops are compiled for doubles and, for precision `mixed`, for floats (packed.h).
 *
 *  With tensile control the tension is at most max_compression rho0 c0^2, twice the pressure of the scene's head: flow
 *  in rotation or round bodies has at most half of that, the sound of impacts ten times that, and without the bound the
 *  control below did a fifth of a dam break's energy in work. Where pressure is negative and the surface farther than
 *  H, |p_i| replaces p_i in the force (Sun et al. 2018), which prevents pairing and tearing under tension. Where the
 *  strain rate exceeds 0.01 c0/H it does so only while that removes energy, that is while the particle's velocity
 *  relative to its neighbours, by sum V_j v_ij W'/r, is against the added force: if it acted both ways everywhere, a
 *  block thrown on a floor would gain 11 % of its energy, and one way everywhere, a rotating disc would lose 1.1 % of
 *  its own, not 0.3 %. Momentum is then conserved only to the order of the scheme. In scenes with
 *  bodies the control acts only farther than H from all walls, as it would push bodies: a block that slides away from
 *  water, pushing another body before it, brought 3.6 % of energy, and 0.0004 % without.
 *
 *  Where liquid parts from a body a gap opens, which counts as surface only from H on; until then shifts would fill it,
 *  and the liquid, still under tension, would follow the body round. So none is shifted that has a body within H. A
 *  circle that falls into water (examples/falling_circle, 22 spacings across) is 1.0 % too deep after 0.05 s and 7 % at
 *  the end, not 4 and 21 % as with them; 11 across -2.4 and 2.2 %: the depth at the end grows with resolution. Without
 *  tension in scenes with bodies it was 3.5 % too high and 2.3 % too deep, but of 300 random scenes in several more the
 *  liquid kept voids. */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_H
#define SPH2D_METHODS_WCSPH_WCSPH_H

#include "methods/common/method.h"
#include "methods/common/slabs.h"
#include "simd/isa.h"

/** The time scheme (midpoint.c): method.h. */
sph2d_status sph2d__midpoint(sph2d_sim *sim, double dt);

/** What is computed about a particle's neighbourhood; each level includes the one before. */
typedef enum sph2d__detail {
    SPH2D__DETAIL_NONE,       /**< nothing */
    SPH2D__DETAIL_GRADIENT,   /**< the gradient of density, for its diffusion */
    SPH2D__DETAIL_EIGENVALUE, /**< the eigenvalue that detects the surface, for tensile control */
    SPH2D__DETAIL_SHIFT       /**< concentration gradient and strain rate, for shifting and subgrid viscosity */
} sph2d__detail;

/** C of Smagorinsky's model, with the whole width 2 H of the kernel as the filter. */
#define SPH2D__SMAGORINSKY 0.15
/** Limit of the velocity difference that subgrid viscosity damps, over the nonlinear part of v_ij . r_ij. */
#define SPH2D__SUBGRID_LIMIT 4

/** Whether there is subgrid viscosity. */
static inline bool sph2d__has_eddies(const sph2d_method_options *m)
{
#ifdef SPH2D__BARE
    return false;
#endif
    return m->turbulence == SPH2D_TURBULENCE_SMAGORINSKY;
}

/** The level that the options of a scene need. */
static inline sph2d__detail sph2d__wcsph_detail(const sph2d_method_options *m)
{
#ifdef SPH2D__BARE /* a build without the others, to measure what they cost a scene that does not use them */
    return SPH2D__DETAIL_NONE;
#endif
    if (m->shifting > 0 || sph2d__has_eddies(m))
        return SPH2D__DETAIL_SHIFT;
    if (m->tensile_control == SPH2D_SWITCH_ON)
        return SPH2D__DETAIL_EIGENVALUE;
    bool has_gradient = m->density_diffusion > 0 && m->diffusion_form == SPH2D_DIFFUSION_ANTUONO;
    return has_gradient ? SPH2D__DETAIL_GRADIENT : SPH2D__DETAIL_NONE;
}

/** c: from 0 for isolated particles to 1 for those connected to liquid, smooth, by `filling`. A pair of particles has a
 *  filling of 0.07 to 0.2, a row of the lattice 0.3, a corner of liquid 0.38 to 0.46. Filling is relative to the space
 *  outside walls: otherwise the last particles in the tip of a wedge would count as isolated. */
static inline double sph2d__connection(double filling)
{
    const double isolated = 0.2, connected = 0.35;
    double t = (filling - isolated) / (connected - isolated);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return t * t * (3 - 2 * t);
}

/** Finds the accelerations of bodies, of which there are some, and gives them to their boundary particles, whose pressures
 *  must then be found anew (wall_bodies.c). False when memory is short. */
bool sph2d__wcsph_move_bodies(sph2d__system *system);

/** Keeps D_b of the boundary particles of bodies until the next step: part of the state. */
void sph2d__wcsph_keep_compression_rates(sph2d__system *system);

/** Whether boundary particles of bodies are within the support radius of particle i of the fluid. */
bool sph2d__wcsph_near_body(const sph2d__system *system, size_t i);

/** Part of the acceleration of boundary particle b, in a scene with bodies, that counts in its pressure: 1 for walls. */
double sph2d__wcsph_felt_part(const sph2d__system *system, size_t b);

/** A pair loop over a span of particles, compiled once for each instruction set, precision and kernel. */
typedef struct sph2d__wcsph_pass {
    sph2d__span_work *by_kernel[SPH2D_KERNEL_COUNT];
} sph2d__wcsph_pass;

/** Sets density_rate, filling, strain, shift and surface_distance of the fluid, from positions, velocities, densities,
 *  volumes and gradients. */
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_rate, )
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_rate, _mixed)
/** Sets wall_rate of the boundary particles, from the fluid. */
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_wall_rate, )
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_wall_rate, _mixed)
/** Sets pressure, density and volume of the boundary particles, and the image velocity of rough ones. */
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_wall, )
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_wall, _mixed)
/** Sets acceleration, gradient of density, min_eigenvalue, packing and concentration gradient of the fluid, from
 *  densities, pressures and volumes. */
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_force, )
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_force, _mixed)

#endif
