/* SPDX-License-Identifier: MIT */
/** @file variational.h
 *  Method `wcsph` with variational operators: the rate of density is exact for velocities that are linear in place, and
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
 *      B_i  = M_i^-1, turned into 1 where det M is below 1/2 and where walls are near;  A_i = F_i^-1
 *      S_i  = sum_b n_b n_b^T B_i G_ib, n_b the wall's normal: walls are smooth;  C_i = -B_i (M_i - F_i) A_i
 *      rate of theta
 *      D_i  = sum_j (v_i - v_j) . B_i G_ij + 2 v_i . S_i - q_i + z_i . N_i + sum_k z_k . G_ik
 *             q_i = 2 sum_b v_b . n_b n_b^T B_i G_ib;  z_i = C_i^T v_i - A_i sum_b (v_b . B_i G_ib) r_ib
 *      force
 *      f_i  = -sum_j (P_i B_i + P_j B_j) G_ij - (2 P_i + l_i) S_i + C_i sum_k (P_k - P_i) G_ik + d_i + e_i + m g
 *
 *  The walls' pressure is that of the liquid before them, continued by its gradient A_i sum_k (p_k - p_i) G_ik: the terms
 *  with C, whose transposes are those with z. Dissipation acts where velocities and pressures are not linear:
 *
 *      d_i  = V0 rho0 c0 sum_j b s G_ij,  w = v_ij . e,  s = minmod(w, w - e . (grad v_i + grad v_j)/2 . r),
 *             b = min(3 |s|/c0, 1)       the limiter of Zhang, Hu & Adams 2017, J. Comput. Phys. 335, 605-620
 *      l_i  = m c0 min(3 s/c0, 1) s: the same for the liquid's image in a wall that it approaches
 *      e_i  = -(0.1 m c0/dx) sum_j (r_i c_ij - r_j c_ji),  r_i = sum_j c_ij v_ij, which is 0 for linear velocities,
 *             c_ij = lambda_i (|G_ij|/sum_k |G_ik| + s_i . A_i G_ij),  s_i = sum_j |G_ij| r_ij/sum_k |G_ik|,
 *             lambda from 0 at surfaces and walls to 1 inside: it takes (0.1 m c0/dx) |r_i|^2
 *      P_i += Z m c0 H D_i, the damping of sound (Sun, Pilloni, Antuono & Colagrossi 2023, J. Comput. Phys. 483, 112056),
 *             0 where the liquid keeps its volume; Z at most 0.1, and as much as an acoustic step bears
 *      pairs nearer than r0 = dx/2 repel each other by R (1 - r/r0)^2, R = 0.2 rho0 c0^2 dx: nothing else keeps two
 *      particles from one place
 *      dtheta_i/dt += -C c0 sum_j s |G_ij|,  s = minmod(theta_ij, theta_ij - (grad theta_i + grad theta_j)/2 . r)
 *
 *  Viscosity is mu 16/sum_lattice |G| r^2 V0 sum_j w G_ij: forces along the lines between particles. Once a step theta is
 *  moved towards what the sum over the neighbours says, as far as dissipation has paid for it. Boundary particles act as
 *  far as there is liquid at their image in the liquid, so that walls hold none beside a surface. */
#ifndef SPH2D_METHODS_VARIATIONAL_VARIATIONAL_H
#define SPH2D_METHODS_VARIATIONAL_VARIATIONAL_H

#include "methods/common/method.h"
#include "methods/common/slabs.h"
#include "simd/isa.h"

/** rho/rho0 of its logarithm: by its series, which has the same bits everywhere. */
static inline double sph2d__density_ratio(double theta)
{
    const double x = theta / 4;
    double sum = 1;
    for (int k = 14; k > 0; --k)
        sum = 1 + x / k * sum;
    return sum * sum * (sum * sum);
}

/** The arrays of the fluid that stand still over a step, or are written by one sweep and read by the next. */
#define SPH2D__FROZEN_ARRAYS(X)                                                                                        \
    X(bxx)                                                                                                             \
    X(bxy)                                                                                                             \
    X(byy) /* B */                                                                                                     \
    X(axx)                                                                                                             \
    X(axy)                                                                                                             \
    X(ayy) /* A */                                                                                                     \
    X(cxx)                                                                                                             \
    X(cxy)                                                                                                             \
    X(cyx) X(cyy)                          /* C */                                                                     \
        X(nx) X(ny)                        /* N */                                                                     \
        X(sx) X(sy)                        /* S */                                                                     \
        X(wall_rate)                       /* q [1/s] */                                                               \
        X(wall_linear)                     /* what is linear of w in l [m/s] */                                        \
        X(wall_zx) X(wall_zy)              /* the part of z by moving walls */                                         \
        X(smooth)                          /* lambda */                                                                \
        X(weight)                          /* sum |G| [1/m] */                                                         \
        X(kx) X(ky)                        /* A s */                                                                   \
        X(rest) X(rest_x) X(rest_y)        /* two floats: lambda r over sum |G|; lambda rx k; lambda ry k */           \
        X(summed)                          /* density by summation, less density, over rest density */                 \
        X(surface)                         /* 1 at the surface, else 0 */                                              \
        X(walled)                          /* 1 where C is not 0, else 0 */                                            \
        X(slope_v) X(slope_w) X(slope_p)   /* two floats: stretch and half of shear; dvy/dy and nothing; grad p */     \
        X(velocity) X(next_velocity)       /* two floats [m/s] */                                                      \
        X(press) X(press_more)             /* two floats: P B by xx, xy; by yy, and theta */                           \
        X(work)                            /* P [J/m] */                                                               \
        X(zx) X(zy) X(next_zx) X(next_zy)  /* z [m/s] */                                                               \
        X(diffused)                        /* change of theta by diffusion over an acoustic step */                    \
        X(damping)                         /* Z m c0 H [J s/m] */                                                      \
        X(rate)                            /* D [1/s] */                                                               \
        X(px) X(py)                        /* where particles are now [m] */                                           \
        X(mean_work) X(mean_ex) X(mean_ey) /* over the step: 2 P + l, and A sum (P_k - P_i) G_ik */

/** What stands still over a step. */
typedef struct sph2d__frozen {
#define SPH2D__FROZEN_MEMBER(name) double *name;
    SPH2D__FROZEN_ARRAYS(SPH2D__FROZEN_MEMBER)
#undef SPH2D__FROZEN_MEMBER
    double *wet, *room;   /**< of boundary particles: their part that acts; what walls leave free at their images */
    size_t walls;         /**< boundary particles */
    size_t capacity;      /**< particles */
    double *linear;       /**< of each pair: what is linear of w [m/s] and of theta_ij, two floats */
    float *inverse;       /**< of each pair: 1/|G| [m] */
    unsigned char *flags; /**< of each slice: SPH2D__FROZEN_WALLED, _BESIDE */
    uint32_t *close;      /**< of each slice: slots of pairs that may come close, behind those with walls */
    size_t pairs, slices;
    double dt;    /**< of an acoustic step [s] */
    double apart; /**< how far two particles of a close pair may be in the middle of the step [m] */
    double share; /**< of an acoustic step in means over the step */
} sph2d__frozen;

/* r0 over dx: nearer pairs repel each other. */
static const double SPH2D__CLOSE = 0.5;

/** Of a slice: one of its particles has walls' pressures by a gradient, or a neighbour that has. */
enum { SPH2D__FROZEN_WALLED = 1, SPH2D__FROZEN_BESIDE = 2 };

/** What stands still, compiled once for each instruction set. */
typedef struct sph2d__variational_gather_pass {
    size_t lanes;
    /** Lists the neighbours of the fluid's slab k and sums over them; false when there was not room enough. */
    bool (*gather[SPH2D_KERNEL_COUNT])(sph2d__system *system, size_t k);
    /** What is linear in each pair of a span, once all sums are known. */
    sph2d__span_work *compare;
} sph2d__variational_gather_pass;

/** The sweeps of an acoustic step. */
typedef struct sph2d__variational_pass {
    /** A kick by the forces; sums up the work of dissipation [J/m]. */
    void (*force)(sph2d__system *system, size_t first, size_t last, sph2d__slab_sum *sum);
    /** Rates of density, which act over `before` and, once density has diffused, over `after` [s], as velocities do; then
     *  pressures. Sums up the elastic energy that diffused [J/m] and D^2 [1/s^2]. */
    void (*rate)(sph2d__system *system, size_t first, size_t last, double before, double after, sph2d__slab_sum *sum);
} sph2d__variational_pass;

SPH2D__COPIES(sph2d__variational_gather_pass, sph2d__variational_gather, )
SPH2D__COPIES(sph2d__variational_pass, sph2d__variational, )

/** Makes room for the fluid's particles and their neighbours, lists them and sets what stands still. The cells are up to
 *  date. False when memory is short. */
bool sph2d__frozen_gather(sph2d__system *system);
void sph2d__frozen_free(sph2d__system *system);

/** The time scheme (advance.c): method.h. */
sph2d_status sph2d__variational_step(sph2d_sim *sim, double dt);

/** The acoustic steps in a step of length dt. */
size_t sph2d__acoustic_steps(const sph2d__system *system, double dt);

#endif
