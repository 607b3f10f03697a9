/* SPDX-License-Identifier: MIT */
/** @file wcsph.h
 *  Method `wcsph`, variational operators: the rate of density is exact for velocities that are linear in place, and
 *  the force of pressure is its transpose, so that the work of pressure is the change of elastic energy and momentum goes
 *  from particle to particle (Bonet & Lok 1999, Comput. Methods Appl. Mech. Engrg. 180, 97-115).
 *
 *  State: x, v, theta = ln(rho/rho0). Elastic energy is m c0^2 theta^2/2, so that p = rho c0^2 theta: to first order
 *  c0^2 (rho - rho0), and with energies that are squares acoustic steps keep their sum to rounding (advance.c). With
 *  V0 = m/rho0, w_b the area of boundary particle b, r_ij = x_i - x_j, G_ij = V0 grad_i W(r_ij), G_ib = w_b grad_i W(r_ib),
 *  P_i = p_i m/rho_i = m c0^2 theta_i, and x taken in the middle of a step of length dt, over which all of this stands
 *  still:
 *
 *      F_i  = -sum_j G_ij r_ij^T        of liquid alone;  M_i = F_i - sum_b G_ib r_ib^T;  N_i = sum_j G_ij
 *      B_i  = M_i^-1, turned into 1 where det M is below 1/2 and where walls are near, with eigenvalues whose difference
 *             over their sum is at most that in the first row of a lattice, evened(); A_i = F_i^-1
 *      S_i  = Q_i sum_b B_i G_ib, C_i = -B_i (M_i - F_i) A_i;  Q_i = sum_b |G_ib| n_b n_b^T over its largest eigenvalue,
 *             n_b the wall's normal: walls are smooth, n n^T if flat or a slit; in inner corners its other eigenvalue is as
 *             much as balances the liquid's N_i, at most that eigenvalue of the sum over |sum_b B_i G_ib|; around edges
 *             Q_i = g g^T/g^2, g = sum_b G_ib, with as much of it across the largest eigenvalue's direction as balances N_i
 *             Where a particle's foot is beyond the end of a wall, by a part 1 - c of a spacing, that part of Q_i is
 *             sum_d beta_d d d^T, d the axes of Q_i and beta_d what of d . sum_b B_i G_ib balances N_i, and C_i has the
 *             part c + (1 - c) min beta_d: a jet that leaves a duct has N_i across it alone, and leaves no wall
 *      rate of theta
 *      D_i  = sum_j (v_i - v_j) . B_i G_ij + a_i (2 v_i . S_i - q_i) + z_i . N_i + sum_k z_k . G_ik
 *             q_i = 2 sum_b v_b . Q_i B_i G_ib;  z_i = C_i^T v_i - A_i sum_b (v_b . B_i G_ib) r_ib
 *      force
 *      f_i  = -sum_j (P_i B_i + P_j B_j) G_ij - (2 a_i P_i + l_i) S_i + C_i sum_k (P_k - P_i) G_ik + d_i + e_i + m g_i
 *
 *  The domain's sides are mirrors. What is nearer to one than H has an image in it, and in corners one in both: with T
 *  the reflection, a particle at T x with T v, T B T and theta, which j, k and the liquid's own sums above include. So
 *  rate and force are transposed as they are without sides: the liquid is half of one that is symmetric. In the other
 *  half gravity points the other way, and pressure has a bend at the side that sums over the support do not resolve;
 *  g_i is the mean over the support, too: its component across a side is (1 - 2 w_i) g, w_i the part of the kernel that
 *  is beyond it, which the distance alone determines, so that g_i has a potential. Then a lattice is at rest under
 *  hydrostatic pressure: without it, rows were off by turns by 3 % of rho g H. It takes no gradient of pressure, since
 *  liquid beside a flat wall does not accelerate towards it. Density diffuses between particles alone, because of the
 *  bend.
 *
 *  Boundary particles stand for obstacles. Their pressure is that of the liquid before them, continued by its gradient
 *  A_i sum_k (p_k - p_i) G_ik: the terms with C, whose transposes are those with z.
 *
 *  What is behind a wall counts as wall (wcsph_sight.h): pairs that are each behind the face that the other is before, as on
 *  both sides of a plate thinner than the support, or of a tip, are in no sum above. With H_i the sum of their G_ij, and E_i
 *  what else is missed beyond the face's plane where that is empty, G_ib of the face's own boundary particles are larger by
 *  (H_i + E_i) . n over sum_b G_ib . n, so that walls bear what these pairs would; M_i has -sum G_ij r_ij^T of the pairs in
 *  place of that, and around edges g has what of H_i and E_i is not along n. Seen through walls, liquid pressed along both
 *  faces of a wedge of 1 to 30, and a tank at rest with one in it lost 1 % of its volume in 3 s.
 *
 *  Walls do not hold by tension what has no C_i: films, where A_i is not F_i^-1, and what is past the end of a wall. a_i is 0
 *  there while theta_i and what walls add to D_i are below 0: while it is under tension and leaves. Else a_i is 1, and always
 *  in liquid without a surface. As it changes in the middle between two kicks, in rate and force at once, all is accounted for.
 *  In an implicit step (implicit.c) it is by both at the start.
 *
 *  Dissipation acts where velocities and pressures are not linear:
 *
 *      d_i  = V0 rho0 c0 sum_j b s G_ij,  w = v_ij . e,  s = minmod(w, w - e . (grad v_i + grad v_j)/2 . r),
 *             b = min(3 |s|/c0, 1)       the limiter of Zhang, Hu & Adams 2017, J. Comput. Phys. 335, 605-620
 *      l_i  = m c0 min(3 s/c0, 1) s: the same for the liquid's image in a wall that it approaches
 *      e_i  = -(0.1 m c0/dx) sum_j (r_i c_ij - r_j c_ji),  r_i = sum_j c_ij v_ij, which is 0 for linear velocities,
 *             c_ij = lambda_i (|G_ij|/sum_k |G_ik| + s_i . A_i G_ij),  s_i = sum_j |G_ij| r_ij/sum_k |G_ik|,
 *             lambda from 0 at surfaces and walls, where sums see one side alone and r is not 0 for potential flow,
 *             to 1 inside, less where viscosity does it: it takes (0.1 m c0/dx) |r_i|^2
 *      P_i += Z m c0 H D_i, the damping of sound (Sun, Pilloni, Antuono & Colagrossi 2023, J. Comput. Phys. 483, 112056),
 *             0 where the liquid keeps its volume; Z at most 0.1, and as much as an acoustic step bears
 *      pairs nearer than r0 = dx/2 repel each other by R (1 - r/r0)^2, R = 0.2 rho0 c0^2 dx: nothing else keeps two
 *      particles from one place. Its potential, R r0/3 (1 - r/r0)^3, is part of the elastic energy. A particle's image in an obstacle does so as well, until
 *      the particle stops: tension pulls liquid into walls
 *      dtheta_i/dt += -C c0 sum_j s |G_ij|,  s = minmod(theta_ij, theta_ij - (grad theta_i + grad theta_j)/2 . r)
 *
 *  Viscosity is mu V0 4/<r^2> sum_j w r G_ij, the central form (terms/viscosity.h). Boundary particles beyond sides act as
 *  far as there is an obstacle at their image. What is slow against sound, e, the diffusion of theta and, unless the liquid
 *  is thick, viscosity, acts once a step, with the impulse of all of it, in the acoustic step that is its middle: at the
 *  start or the end angular momentum would be kept to first order only. e takes at most 1/4 of c0/dx times the step, since
 *  no row of r has a larger sum than 2.
 *
 *  Once a step theta is moved towards what the neighbours say, as far as dissipation has paid for it (advance.c). Their
 *  kernel sum Sigma over that of a lattice is rho s, s the part of the kernel that a surface leaves. Sigma and
 *  K = |sum_j G |r|| both grow as density does: K/Sigma tells how near a surface is, whatever the density, and s is that of
 *  a plane so near. Surfaces bend, and s is known no better than that Sigma <= rho s <= Sigma/s: density
 *
 *      goes up to rho0 Sigma, and beside a surface to rho0 as far as Sigma/s lets it: there is no tension
 *      goes down to rho0 Sigma/s as far as B is M^-1: strings and single particles have no density */
#ifndef SPH2D_METHODS_WCSPH_WCSPH_H
#define SPH2D_METHODS_WCSPH_WCSPH_H

#include <math.h>

#include "boundary/rigid.h"
#include "methods/common/method.h"
#include "methods/common/slabs.h"
#include "methods/wcsph/wcsph_frozen.h"
#include "simd/isa.h"

/** A body during a step: its motion, and the liquid's force on it in the mean over the step, so far. */
struct sph2d__frozen_body {
    sph2d__twist velocity, change;      /**< now, and by the last acoustic step [m/s, rad/s] */
    sph2d__twist way;                   /**< the mean of the step, so far [m/s, rad/s] */
    sph2d__twist mean, before;          /**< by pressure, with the last acoustic step and without it [N/m, N] */
    sph2d__twist rubbed, rubbed_before; /**< the same by the friction of liquid that sticks */
    sph2d__twist trial;                 /**< a change of velocity that a product takes [m/s, rad/s] */
    double rate2;                       /**< of its part of D over its mass [1/s^2] */
    double brake;                       /**< the most that l slows it down by [1/s] */
};

/** What stands still, compiled once for each instruction set. */
typedef struct sph2d__wcsph_gather_pass {
    size_t lanes;
    /** Lists the neighbours of the fluid's slab k and sums over them; false when there was not room enough. */
    void (*see)(sph2d__system *system, size_t k);
    bool (*gather[SPH2D_KERNEL_COUNT])(sph2d__system *system, size_t k);
    /** What is linear in each pair of a span, once all sums are known. */
    sph2d__span_work *compare;
} sph2d__wcsph_gather_pass;

/** The sweeps of an acoustic step. */
typedef struct sph2d__wcsph_pass {
    /** A kick by the forces, with `once` times those that act once a step; sums up the work of dissipation, of friction, of forces on particles that are held, and of
     *  driving forces [J/m], and the external force [N/m]. */
    void (*force)(sph2d__system *system, size_t first, size_t last, double once, sph2d__slab_sum *sum);
    /** Rates of density, which act over `before` and, once density has diffused, over `after` [s], as velocities do; then
     *  pressures; with `rest` r of e, too. Sums up what damping takes and the elastic energy that diffused [J/m], D^2 [1/s^2], and
     *  the elastic energy that particles that are held would get [J/m]. */
    void (*rate)(sph2d__system *system, size_t first, size_t last, double before, double after, bool rest,
                 sph2d__slab_sum *sum);
} sph2d__wcsph_pass;

/** The sweeps of an implicit step (implicit.c). */
typedef struct sph2d__implicit_pass {
    /** r of e, and a. */
    sph2d__span_work *rest;
    /** Velocities by what is dissipated, and the accelerations that act with pressure. Sums up the work of dissipation,
     *  of friction and of forces on particles that are held [J/m], and the elastic energy that diffused [J/m]. */
    void (*loosen)(sph2d__system *system, size_t first, size_t last, sph2d__slab_sum *sum);
    /** D^T of the pressures in `press`, and its negative as a motion; the sums of pressures that act on walls. */
    sph2d__span_work *transpose;
    /** D of the motion, into `product`. */
    sph2d__span_work *diverge;
    /** The product of the matrix with the direction; the first sum is their own product. */
    void (*multiply)(sph2d__system *system, size_t first, size_t last, sph2d__slab_sum *sum);
    /** The end of the step by the pressures in `press`. Sums up what acts without a potential, damping, and forces on
     *  particles that are held [J/m], in the order of `force`; the external force [N/m]. */
    void (*finish)(sph2d__system *system, size_t first, size_t last, sph2d__slab_sum *sum);
} sph2d__implicit_pass;

/** The sweeps of the implicit solve for viscosity (thick.c). */
typedef struct sph2d__thick_pass {
    /** What is left of the equations by velocities to start from, which are in `velocity`, and the matrix's diagonal. Sums up the square of the
     *  former over the latter, and of the right side. */
    void (*load)(sph2d__system *system, size_t first, size_t last, sph2d__slab_sum *sum);
    /** The product of the matrix with what is in `velocity`, the direction; the first sum is their own product. */
    void (*multiply)(sph2d__system *system, size_t first, size_t last, sph2d__slab_sum *sum);
    /** Accelerations by the velocities that were found, which are in `velocity`. */
    sph2d__span_work *finish;
    /** Adds what images do to the mean force of sides. */
    sph2d__span_work *push_sides;
} sph2d__thick_pass;

SPH2D__COPIES(sph2d__wcsph_gather_pass, sph2d__wcsph_gather)
SPH2D__COPIES(sph2d__implicit_pass, sph2d__implicit_pass)
SPH2D__COPIES(sph2d__thick_pass, sph2d__thick_pass)
SPH2D__COPIES(sph2d__wcsph_pass, sph2d__wcsph)

/** Makes what stands still, with nothing in it yet. False when memory is short. */
bool sph2d__frozen_start(sph2d__system *system, const sph2d__sides *sides);
/** Makes room for the fluid's particles and their neighbours, lists them and sets what stands still. The cells are up to
 *  date. False when memory is short. */
bool sph2d__frozen_gather(sph2d__system *system);
/** Sets how much of each boundary particle acts (wcsph_images.c), when walls have moved. */
void sph2d__wall_parts_find(sph2d__system *system);
/** Lists the images in sides, and in corners those in both, and makes room for them behind the particles in all arrays:
 *  sweeps then read them as particles. In the particles' order, so that sums always have the same one. False when memory
 *  is short. */
bool sph2d__images_place(sph2d__system *system);
/** Puts them there, as they are before neighbours are searched. */
void sph2d__images_start(sph2d__system *system);
/** The particle that image k is of. */
size_t sph2d__image_of(const sph2d__frozen *frozen, size_t k);
/** Images become what particles are: before a sweep reads them. */
void sph2d__images_of_sight(sph2d__system *system);
void sph2d__images_of_slopes(sph2d__system *system);
void sph2d__images_of_velocity(sph2d__system *system);
void sph2d__images_of_pressure(sph2d__system *system);
void sph2d__images_of_rest(sph2d__system *system);
void sph2d__frozen_free(sph2d__system *system);

/** Viscosities, friction of walls and surface tension (wcsph_friction.c), once neighbours are known. False when memory
 *  is short. */
bool sph2d__frozen_rub(sph2d__system *system);

/** What boundary particle b adds to K and k over m of particle i, with the gradient and the distance of their pair. */
sph2d__frozen_stick sph2d__frozen_stick_of(const sph2d__system *system, size_t i, size_t b, double gx, double gy,
                                           double rx, double ry);

/** Bodies in acoustic steps (wcsph_bodies.c): sets their rows and velocities, once the liquid's are gathered. False
 *  when memory is short. */
bool sph2d__frozen_bodies_gather(sph2d__system *system);
/** Root of the largest eigenvalue, or more, of a body's part of acoustic oscillations, or the rate of its l [1/s]: acoustic steps are at most
 *  one over it, half the limit of a leapfrog. */
double sph2d__frozen_bodies_rate(sph2d__system *system);
/** Their velocities by an acoustic step, whose sweep of the forces has been, and what follows for the next rates of density.
 *  `done` is the part of the step that is over with it, `friction` becomes the work of friction on bodies. Returns what l
 *  does less on them than at their velocities before [J/m]. */
double sph2d__frozen_bodies_kick(sph2d__system *system, double done, double *friction);
void sph2d__frozen_bodies_free(sph2d__system *system);

/** Their change of velocity in half a step, without what the liquid's pressure does: by the forces so far and others. */
void sph2d__frozen_bodies_expect(sph2d__system *system, double half);
/** Adds `part` of their acceleration by the pressures in `press`, and what they stop, to that change. */
void sph2d__frozen_bodies_pull(sph2d__system *system, double part);
/** Sets D of that change, and adds its part of z to the motion. */
void sph2d__frozen_bodies_feed(sph2d__system *system);
/** Work of the pressures in `press` on bodies, less that at the velocities that the solve had [J/m]: by particles that were
 *  stopped after it, and where these are not those of the middle. */
double sph2d__frozen_bodies_late(sph2d__system *system);

/** By how much more energy a particle at (x, y) has than gravity's: beside sides g_i is less [J/kg]. */
double sph2d__side_energy(const sph2d__system *system, double x, double y);

/** Parts of a step (wcsph_begin.c): the start, particles where they were; what neighbours see of a particle's velocity; external
 *  forces; the energy of close pairs and beside sides, whose change since it was last called is in `first` of a sum that is
 *  there later (slabs.h), over the mass of a particle. */
void sph2d__frozen_begin(sph2d__system *system);
void sph2d__frozen_start_motion(sph2d__system *system, size_t i);
void sph2d__frozen_start_external(sph2d__system *system);
void sph2d__frozen_store_later(sph2d__system *system, sph2d__slab_sum *to);
/** In place of acoustic steps, in method `constraint` (implicit.c). */
void sph2d__implicit_sound(sph2d_sim *sim, double dt);
/** Close pairs in it (implicit_close.c): room for their rows, false when memory is short; the rows, with particles where
 *  they are expected. */
bool sph2d__close_reserve(sph2d__system *system);
void sph2d__close_find(sph2d__system *system);
void sph2d__close_free(sph2d__system *system);
/** Accelerations by viscosity and walls without slip, where the liquid is thick (thick.c), with those by all else in
 *  `rubbed`; `again`, from what was found, for the last time. */
void sph2d__thick_solve(sph2d__system *system, bool again);

/** The head that the sound speed is made for [m^2/s^2], as a run that is resumed knows (wcsph_limits.c). */
double sph2d__head_of_sound(const sph2d__system *system);

/** The longest steps (wcsph_limits.c): by sound and the way of the fastest particle; in method `constraint` as far as particles
 *  may go in one. method.h. */
double sph2d__wcsph_stable_step(const sph2d__system *system, double speed, double acceleration, sph2d__limit *limit);
double sph2d__implicit_stable_step(const sph2d__system *system, double speed, double acceleration, sph2d__limit *limit);

/** The time scheme (advance.c): method.h. */
sph2d_status sph2d__wcsph_step(sph2d_sim *sim, double dt);
bool sph2d__wcsph_set_sides(sph2d_sim *sim);

/** Whether viscosity is as stable at once over a step of length dt as it may be in an acoustic one. */
bool sph2d__viscous_at_once(const sph2d__system *system, double dt);

/** The acoustic steps in a step of length dt. */
size_t sph2d__acoustic_steps(const sph2d__system *system, double dt);

#endif
