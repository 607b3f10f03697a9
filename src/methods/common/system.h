/* SPDX-License-Identifier: MIT */
/** @file system.h
 *  The system that a method advances: fluid and boundary particles with their cells, and the liquid's
 *  parameters; and the clocks of the phases of its step. A phase lasts until another one is entered; with the clocks off,
 *  entering costs one comparison. */
#ifndef SPH2D_METHODS_COMMON_SYSTEM_H
#define SPH2D_METHODS_COMMON_SYSTEM_H

#include "base/memory.h"
#include "forces/forces.h"
#include "particles/cells.h"
#include "particles/neighbours.h"
#include "sph2d/machine.h"
#include "sph2d/scene.h"

/* ---- clocks ------------------------------------------------------------------------------------------------------ */

typedef struct sph2d__profile {
    bool on;
    sph2d_phase phase; /**< SPH2D_PHASE_COUNT between steps */
    double wall, cpu;  /**< clock readings when it was entered [s] */
    sph2d_profile sums;
} sph2d__profile;

void sph2d__profile_switch(sph2d__profile *profile, sph2d_phase phase);

/** Enters a phase; returns the previous one, so that it can be entered again. SPH2D_PHASE_COUNT stops the clocks. */
static inline sph2d_phase sph2d__profile_enter(sph2d__profile *profile, sph2d_phase phase)
{
    sph2d_phase left = profile->phase;
    if (profile->on && phase != left)
        sph2d__profile_switch(profile, phase);
    return left;
}

/* ---- the system -------------------------------------------------------------------------------------------------- */

/** Tables, which threads of a device read where they are. */
enum { SPH2D__PAIR_GAINS = 96, SPH2D__PAIR_GAIN_TOP = 4 };
typedef struct sph2d__tables {
    /** muller: G, pressure in pairs over reported pressure, at densities from 1 to SPH2D__PAIR_GAIN_TOP times rest
     *  density */
    double pair_gain[SPH2D__PAIR_GAINS + 1];
} sph2d__tables;

struct sph2d__rigid;
struct sph2d__grid;
struct sph2d__frozen;
struct sph2d__device;

/** A pair of a fluid particle with a boundary particle of a body, and the gradient of its kernel (projection.h). */
typedef struct sph2d__body_pair {
    uint32_t fluid, wall;
    float gx, gy;
} sph2d__body_pair;

typedef struct sph2d__body_pairs {
    SPH2D__ARRAY sph2d__body_pair *items;
    size_t capacity;
    SPH2D__ARRAY size_t *first; /**< of each body, and the end of the last */
    size_t bodies;              /**< room in `first`, less 1 */
} sph2d__body_pairs;

/** A block that kernels of a device reach by arguments. */
typedef struct sph2d__kernel_block {
    const void *block;
    size_t bytes;
} sph2d__kernel_block;

typedef struct sph2d__system {
    sph2d__store fluid, walls;
    sph2d__cells fluid_cells, wall_cells;
    sph2d__neighbours neighbours, wall_neighbours; /**< lists of fluid and boundary particles, if the method has them */
    bool walls_press;                              /**< some boundary particles exert pressure */
    SPH2D__ARRAY double
        *wall_spin;              /**< by id of a boundary particle: its angular velocity [rad/s]; NULL: no wall turns */
    bool walls_reflect;          /**< some boundary particles reflect */
    struct sph2d__rigid *rigids; /**< the bodies that the liquid moves (boundary/rigid.h) */
    size_t rigid_count;
    sph2d__body_pairs
        body_pairs; /**< of their boundary particles with the liquid, in methods that solve for pressure */
    SPH2D__ARRAY uint32_t
        *rigid_index; /**< of their boundary particles, by id from the first body's first on: where they are now */

    bool fills; /**< liquid and solids fill the domain from the start, so that there is no surface */

    double spacing;            /**< dx [m] */
    double support;            /**< support radius H [m] */
    double reach;              /**< search radius for fluid particles [m] */
    double wall_reach;         /**< search radius for boundary particles [m] */
    double mass;               /**< of a fluid particle [kg/m] */
    double rest_density;       /**< [kg/m^3] */
    double sound_speed;        /**< c0 [m/s] */
    double viscosity;          /**< dynamic; where it depends on the shear rate, the largest of a particle [Pa s] */
    const sph2d_fluid *liquid; /**< the scene's, with its regularisation */
    SPH2D__ARRAY double
        *viscosities; /**< of the fluid's particles, where they depend on the shear rate, else NULL [Pa s] */
    size_t viscosity_capacity;
    struct sph2d__grid *grid;     /**< hybrid: its grid, from the first step on (methods/hybrid/grid.h) */
    struct sph2d__frozen *frozen; /**< wcsph: what stands still over a step (methods/wcsph) */
    double surface_tension;       /**< [N/m] */
    double calibration;           /**< muller: factor on the density sum that gives a full lattice the rest density */
    double side_fill;             /**< muller: F of muller_side.h, times rest density [kg/m^3] */
    double corner_fill;           /**< muller: Q, times rest density [kg/m^3] */
    double side_power;            /**< muller: m */
    double modulus;               /**< muller: k, pressure over the excess of the density sum [m^2/s^2] */
    SPH2D__ARRAY sph2d__tables *tables; /**< what is looked up */
    double moment;                      /**< first moment of the pressure gradient on a full lattice; 1 if exact */
    double residual_gain;               /**< wcsph, fitted: gamma, factor on the fit's residual in the Laplacian */
    double shift_gain;                  /**< wcsph, fitted: shift velocity over U S (fitted.h); set for each step */
    double lattice_values;       /**< wcsph: sum of f(r/H)/f(dx/H) over a full lattice, including the particle itself */
    double lattice_slopes;       /**< wcsph: sum of g(r/H) over a full lattice, without the particle itself */
    double lattice_stiffness;    /**< wcsph: what a pressure pushes back with, over p/(rho dx^2) (wcsph.c) */
    sph2d_method_options method; /**< the scene's, with all defaults filled in */
    /** Of all walls, if they have the same; else by id of a boundary particle, and not NULL. */
    sph2d_slip wall_slip;
    SPH2D__ARRAY const unsigned char *wall_slips;
    bool walls_rough, walls_smooth; /**< some have no slip, or the friction of smooth walls */
    double slip_length;             /**< of smooth walls [m] */
    sph2d__forces forces;

    sph2d_vec2
        external; /**< force on the liquid but that of walls and bodies, in the mean over the last step, where the
                             method books all (method.h) [N/m] */
    double step;  /**< length of the present step [s] */
    double speed; /**< largest speed of a particle at the start of the step [m/s] */
    double max_pressure; /**< largest pressure of a particle at the start of the step, at least that of the head [Pa] */
    double
        max_log_density;  /**< largest size of a logarithm of density over rest density then, where particles have it */
    double spring_head;   /**< the part of `head` by what only springs of bodies make fast [m^2/s^2] */
    double spring_energy; /**< of these springs at the start [J/m] */
    double head; /**< g h + U^2/2 + work of pulls at the start, or as implied by the sound speed given [m^2/s^2] */
    double central_weight; /**< wcsph: the weight of the central form of viscosity, methods/terms/viscosity.h [1/m^2] */

    uint64_t iterations;    /**< of the pressure solver in the last step */
    bool unconverged;       /**< the solver did not reach its tolerance */
    double residual;        /**< its final compression error */
    double wanted_residual; /**< its tolerance */

    struct sph2d__device
        *device; /**< that has the particles and runs the loops (on_device.h); NULL: the processor does */

    size_t points_room; /**< bytes of the points that forces have */

    /* From here on kernels of a device read nothing. */
    sph2d__profile profile;
    sph2d__memory *memory;
    sph2d_isa isa;
    const struct sph2d__system *whole; /**< that this is a view of, with other particles as its fluid; NULL: none */
    const struct sph2d__extra *extra;  /**< what the method hands its kernels besides; NULL: nothing */
    sph2d__kernel_block *lent;         /**< what kernels read besides */
    size_t lent_count;
} sph2d__system;

/** Whether a device has the particles; never where SPH2D__NO_DEVICE leaves devices out, as in a browser. */
static inline bool sph2d__is_on_device(const sph2d__system *s)
{
#ifdef SPH2D__NO_DEVICE
    (void)s;
    return false;
#else
    return s->device != NULL;
#endif
}

/** The slip of boundary particle b. */
static inline sph2d_slip sph2d__slip_of(const sph2d__system *s, size_t b)
{
    return s->wall_slips ? (sph2d_slip)s->wall_slips[s->walls.id[b]] : s->wall_slip;
}

/** Velocity of the wall's surface in front of boundary particle b, where liquid sticks to it: the wall may turn, and the
 *  particle lies deeper. */
static inline sph2d_vec2 sph2d__surface_velocity(const sph2d__system *s, size_t b)
{
    const sph2d__store *w = &s->walls;
    double spin = s->wall_spin ? s->wall_spin[w->id[b]] : 0;
    if (spin == 0) /* in corners of the domain there is no single surface */
        return (sph2d_vec2){w->vx[b], w->vy[b]};
    return (sph2d_vec2){w->vx[b] - spin * w->depth[b] * w->normal_y[b], w->vy[b] + spin * w->depth[b] * w->normal_x[b]};
}

#endif
