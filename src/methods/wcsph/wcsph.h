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
 *  Morris' form has mu grad v for the stress, whose part that is missing, mu (grad v)^T, has no divergence inside
 *  liquid and shows at a free surface alone: waves decay at half their rate, and what turns is slowed down. Monaghan's
 *  has no stress at a free surface in the mean (Colagrossi et al. 2011, Phys. Rev. E 84, 026705, where the factor
 *  2 (2 + d) is derived), but along the rows of a lattice it finds 0.89 of the viscosity in shear, 1.11 in stretching
 *  (Wendland C2, H/dx = 3; 0.94 and 1.06 for C4, H/dx = 4). A scene without a form gets it where there is a free
 *  surface.
 *
 *  Boundary particles b of walls in layers take part in all sums but the diffusion's, with (Adami, Hu & Adams 2012,
 *  eq. 27; a_b the wall's acceleration, g the body force, j over the liquid around b)
 *
 *      p_b       = [sum p_j W + (g - a_b) . sum c_j rho_j r_bj W] / sum W,   rho_b from the equation of state
 *      drho_i/dt = ... + sum m_b (v_i - v_b) . grad W + sum m_b W_bi (rho_i/rho_b)^2 D_b
 *      D_b       = sum (v_j - v_b) . grad W_jb / sum W
 *
 *  which holds a resting liquid exactly. The last sum gives back what p_b takes: it is the transpose of the first part
 *  of p_b, so that the power of p_b on the liquid, -sum m_j v_j . m_b p_b/rho_b^2 grad W_jb, is what the liquid's own
 *  density gives. A wall at rest then neither makes nor takes energy, whatever its shape and however few particles are
 *  near it, but for the hydrostatic part of p_b. That part has no potential; a particle by itself would ride up a wall
 *  on it, so that it counts only liquid, c_j = 1, not what flies by itself, c_j = 0 (by the filling with others).
 *
 *  Where the surface of the liquid meets a smooth wall, and in films along it, these sums ask liquid that slides for
 *  work: p_b and D_b change along the wall with the liquid's end. There the wall is continued by what slides with it,
 *  by a part s_b: 1 where the liquid around b has little filling, 0 where it is inside (wall_pass.c). With t
 *  along the wall, v_b has s_b t t . (sum v_j W / sum W - v_b) more, D_b only 1 - s_b of its part along t, so has the
 *  force of p_b, and in turn liquid feels
 *
 *      dv_i/dt   = ... + sum m_b s_b W_bi/(sum W) t_b t_b . sum_k p_k/rho_k^2 grad_k W_kb
 *
 *  which again is the transpose, so that nothing makes energy. Liquid that only rings, by less than 0.002 c0, does not
 *  slide: the last sum is no hydrostatic balance, and with it a surface at rest stands 0.25 dx too high beside a wall
 *  of 45 degrees (0.3 with weight given back pair by pair), 0.07 too low without. Nothing slides under a cover of
 *  liquid, nor where another wall is in front, as in corners: where a wall ends the liquid the last sum would push. A
 *  side that slides along itself has v_b = 0 here: it takes no liquid along but by friction. A rough wall has viscosity
 *  with v_b = 2 v_wall - sum v_j W / sum W, a smooth one what friction.h says.
 *
 *  What flies by itself has the rest density, and no pressure but that of others: what it remembered of the liquid that
 *  it left would glue it to walls.
 *
 *  grad rho_i is corrected: exact for linear density, so that psi vanishes there pair by pair and a resting liquid
 *  keeps its surface. Artificial viscosity alpha is the monaghan form with mu = rho0 alpha h c0/8 in approach and
 *  recession alike. The pair (rate, pressure) conserves energy when nothing dissipates or shifts.
 *
 *  What splashes leave is liquid whose particles go to and fro by themselves, with eddies that no kernel resolves. It
 *  is looser than it should be and comes to rest slowly. Smagorinsky's eddies (1963) with the whole width of the kernel
 *  for a filter (SPH as a filter: Di Mascio et al. 2017, Phys. Fluids 29, 035102) damp by monaghan with
 *
 *      mu_ij = rho0 (2 C H)^2 (|S_i| + |S_j|)/2,   |S| = sqrt(2 S:S) without the rate of volume,   C = 0.15
 *
 *  but only what is rough: of v_ij . r_ij no more than four times the part that is not linear, v_ij . r_ij less
 *  r_ij . (S_i + S_j)/2 . r_ij, S without its trace. Smooth strain is left alone, as by artificial viscosities behind a
 *  linear reconstruction with a limiter (Frontiere, Raskin & Owen 2017, J. Comput. Phys. 332, 160). Of a dam break 40
 *  spacings high the level at t sqrt(g/H) = 20 is 5 % too high without eddies, 0.5 % with them, and 0.9 % with C =
 *  0.12. A drop that is drawn out, R/dx = 25, is 0.14 % too short, 0.27 % without the limiter and C = 0.12. A wave at
 *  Re = 2000 and 50 spacings of depth dies by 0.050 1/s without eddies, 0.053 with them and 0.161 with alpha = 0.02,
 *  which does as much for the dam break; by theory 0.042.
 *
 *  The rate of density knows nothing of surfaces that meet or part: without more, the number of particles on an area
 *  and their density part by per cents in a dam break, and the level at its end is wrong by as much. Inside the liquid,
 *  farther than H from its surface, density therefore also comes to what places say, in 100 H/c0:
 *
 *      drho_i/dt = ... + c0/(100 H) (rho0 sum (m_j/m) W / sum over a lattice W - rho_i)
 *
 *  The second psi vanishes at rest in gravity g and a central force, where d rho = rho0/c0^2 of the work they do; not
 *  along periodic directions, in which no liquid rests on another.
 *
 *  Particles are shifted by w (shift.h) to where neighbours are few. Their density changes along as that around says,
 *  w . grad rho (Sun et al. 2019); their velocity stays, so that shifting has no kinetic energy. The smaller eigenvalue
 *  of sum V_j r_ji grad W, 1 in full surroundings and half at a flat surface, tells the free surface (Marrone 2010):
 *  within H of it a shift has no part across the surface, and in spray there is none (Sun et al. 2017).
 *
 *  Pair loops are compiled for doubles and, for precision `mixed`, for floats (packed.h).
 *
 *  With tensile control liquid is drawn apart by no more than max_compression rho0 c0^2, which is twice the pressure of
 *  the scene's head: liquid that turns or flows round something draws with half of that at most, the sound of impacts
 *  with ten times that, and what follows here then did a fifth of a dam break's energy in work. Where pressure is
 *  negative and the surface farther than H, |p_i| stands for p_i in the force (Sun et al. 2018): liquid under tension
 *  neither pairs nor tears. Where it is strained faster than 0.01 c0/H only while that takes energy, as long as the
 *  particle goes against this push, of what it does among its neighbours, sum V_j v_ij W'/r: with the push both ways
 *  everywhere a block that was thrown on a floor gained 11 % of its energy, with one way everywhere a disc that turns
 *  lost 1.1 % of its own, not 0.3 %. Momentum is then kept to the order of the scheme alone. */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_H
#define SPH2D_METHODS_WCSPH_WCSPH_H

#include "methods/common/method.h"
#include "methods/common/slabs.h"
#include "simd/isa.h"

/** Its time scheme (midpoint.c): method.h. */
sph2d_status sph2d__midpoint(sph2d_sim *sim, double dt);

/** How much is learnt of a particle's neighbourhood; each includes the one before. */
typedef enum sph2d__detail {
    SPH2D__DETAIL_NONE,       /**< nothing */
    SPH2D__DETAIL_GRADIENT,   /**< the slope of density, for its diffusion */
    SPH2D__DETAIL_EIGENVALUE, /**< how far it is filled, for tensile control */
    SPH2D__DETAIL_SHIFT       /**< where it is crowded and how it is strained, for shifting and eddies */
} sph2d__detail;

/** C of Smagorinsky's model, with the whole width 2 H of the kernel for its filter. */
#define SPH2D__SMAGORINSKY 0.15
/** What eddies damp at most, over the part of v_ij . r_ij that is not linear. */
#define SPH2D__PAST_LINEAR 4

/** Whether eddies smaller than the kernel damp. */
static inline bool sph2d__has_eddies(const sph2d_method_options *m)
{
#ifdef SPH2D__BARE
    return false;
#endif
    return m->turbulence == SPH2D_TURBULENCE_SMAGORINSKY;
}

/** What the options of a scene ask for. */
static inline sph2d__detail sph2d__wcsph_detail(const sph2d_method_options *m)
{
#ifdef SPH2D__BARE /* a build without the others, to count what they cost a scene that does not name them */
    return SPH2D__DETAIL_NONE;
#endif
    if (m->shifting > 0 || sph2d__has_eddies(m))
        return SPH2D__DETAIL_SHIFT;
    if (m->tensile_control == SPH2D_SWITCH_ON)
        return SPH2D__DETAIL_EIGENVALUE;
    bool sloped = m->density_diffusion > 0 && m->diffusion_form == SPH2D_DIFFUSION_ANTUONO;
    return sloped ? SPH2D__DETAIL_GRADIENT : SPH2D__DETAIL_NONE;
}

/** Whether a particle is in liquid, c: from 0 to 1, smooth, by its filling. A pair of particles has 0.07 to 0.2, a row
 *  of the lattice 0.3, a corner of liquid 0.38 to 0.46. It is of the room that walls leave: in the tip of a wedge the
 *  last particles would count as by themselves otherwise. */
static inline double sph2d__connection(double filling)
{
    const double alone = 0.2, joined = 0.35;
    double t = (filling - alone) / (joined - alone);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return t * t * (3 - 2 * t);
}

/** A pair loop over some particles, compiled once for each instruction set, precision and kernel. */
typedef struct sph2d__wcsph_pass {
    sph2d__span_work *by_kernel[SPH2D_KERNEL_COUNT];
} sph2d__wcsph_pass;

/** density_rate, filling, strain and shift of the fluid, from places, velocities, densities, volumes and slopes;
 *  distance to the surface. */
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_rate, )
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_rate, _mixed)
/** wall_rate of the boundary particles, from the fluid. */
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_wall_rate, )
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_wall_rate, _mixed)
/** Pressure, density and volume of the boundary particles, and the image velocity where they are rough. */
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_wall, )
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_wall, _mixed)
/** Acceleration of the fluid, slope of density, min_eigenvalue, packing and crowding, from densities, pressures and
 *  volumes. */
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_force, )
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph_force, _mixed)

#endif
