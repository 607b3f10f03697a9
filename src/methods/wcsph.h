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
 *      monaghan  = 8 mu/rho_i sum V_j (v_ij . r_ij)/r^2 grad W,  8 = 2 (2 + d)         (Monaghan & Gingold 1983)
 *
 *  Boundary particles b of walls in layers take part in all sums but the diffusion's, with (Adami, Hu & Adams 2012,
 *  eq. 27; a_b the wall's acceleration, g the body force, j over the liquid around b)
 *
 *      p_b   = [sum p_j W + (g - a_b) . sum rho_j r_bj W] / sum W,   rho_b from the equation of state
 *      v_b   = sum v_j W / sum W, reflected in the frame of the wall: its part across a smooth one, all at a rough one
 *
 *  which holds a resting liquid exactly. A smooth wall has no viscosity.
 *
 *  grad rho_i is corrected: exact for linear density, so that psi vanishes there pair by pair and a resting liquid
 *  keeps its surface. Artificial viscosity alpha is the monaghan form with mu = rho0 alpha h c0/8 in approach and
 *  recession alike. The pair (rate, pressure) conserves energy when nothing dissipates or shifts.
 *
 *  The second psi vanishes at rest in gravity g and a central force, where d rho = rho0/c0^2 of the work they do; not
 *  along periodic directions, in which no liquid rests on another.
 *
 *  Particles are shifted by w (shift.h) to where neighbours are few. They carry their fields along as the fields around
 *  say, (w . grad) v and w . grad rho (Sun et al. 2019), so that shifting moves no liquid. The smaller eigenvalue of
 *  sum V_j r_ji grad W, 1 in full surroundings and half at a flat surface, tells the free surface (Marrone 2010):
 *  within H of it a shift has no part across the surface, and in spray there is none (Sun et al. 2017).
 *
 *  Pair loops are compiled for doubles and, for precision `mixed`, for floats (packed.h).
 *
 *  Where pressure is negative and the surface farther than H, |p_i| stands for p_i in the force (Sun et al. 2018):
 *  liquid under tension neither pairs nor tears. Momentum is then kept to the order of the scheme alone.
 */
#ifndef SPH2D_METHODS_WCSPH_H
#define SPH2D_METHODS_WCSPH_H

#include "methods/method.h"
#include "methods/slabs.h"

extern const sph2d__method sph2d__wcsph;

/** How much is learnt of a particle's neighbourhood; each includes the one before. */
typedef enum sph2d__layout {
    SPH2D__LAYOUT_BARE,   /**< nothing */
    SPH2D__LAYOUT_SLOPED, /**< the slope of density, for its diffusion */
    SPH2D__LAYOUT_FULL,   /**< how far it is filled, for tensile control */
    SPH2D__LAYOUT_CROWDED /**< where it is crowded, for shifting */
} sph2d__layout;

/** What the options of a scene ask for. */
static inline sph2d__layout sph2d__wcsph_layout(const sph2d_method_options *m)
{
#ifdef SPH2D__BARE /* a build without the others, to count what they cost a scene that does not name them */
    return SPH2D__LAYOUT_BARE;
#endif
    if (m->shifting > 0)
        return SPH2D__LAYOUT_CROWDED;
    if (m->tensile_control == SPH2D_SWITCH_ON)
        return SPH2D__LAYOUT_FULL;
    bool sloped = m->density_diffusion > 0 && m->diffusion_form == SPH2D_DIFFUSION_ANTUONO;
    return sloped ? SPH2D__LAYOUT_SLOPED : SPH2D__LAYOUT_BARE;
}

/* Pair loops over some particles; there is one for every kernel and instruction set.
 * rate: density_rate of the fluid, from places, velocities, densities, volumes and slopes; distance to the surface.
 * image: image velocity of the boundary particles, from the fluid.
 * wall: their pressure, density and volume, and the image velocity where they are rough.
 * force: acceleration of the fluid, slope of density, fullness and crowding, from densities, pressures and volumes. */
#define SPH2D__WCSPH_PASSES(isa)                                                                                       \
    extern sph2d__span_work *const sph2d__wcsph_rate_##isa[5],                                                         \
        *const sph2d__wcsph_image_##isa[5], *const sph2d__wcsph_wall_##isa[5], *const sph2d__wcsph_force_##isa[5];
SPH2D__WCSPH_PASSES(baseline)
SPH2D__WCSPH_PASSES(baseline_mixed)
#ifdef SPH2D__ISA_X86
SPH2D__WCSPH_PASSES(avx2)
SPH2D__WCSPH_PASSES(avx2_mixed)
SPH2D__WCSPH_PASSES(avx512)
SPH2D__WCSPH_PASSES(avx512_mixed)
#endif

#endif
