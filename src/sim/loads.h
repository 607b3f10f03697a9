/* SPDX-License-Identifier: MIT */
/** @file loads.h
 *  Forces of the liquid on walls, and the work of walls on it and on bodies, as probes of kinds force and work measure
 *  them; and, in steps that momentum.c watches, on all walls together. In other steps of scenes without such probes all
 *  of these functions return at once.
 *
 *  The force on a wall is minus the sum of what it exerts on the particles, so that momentum is balanced: the pair
 *  forces of its boundary particles as in the method's last evaluation, less what a background pressure adds on
 *  walls that liquid wets on one side, as no reported pressure has it, the springs of sides, and per step what
 *  particles lose where they are stopped or reflected. Over a step of the time scheme, impulses are
 *
 *      dt/2 (F(n) + F(n+1))    kick-drift-kick, whose kicks have the force of the step's start and end
 *      dt F(n+1/2)             methods that solve for pressure in the middle of the step
 *
 *  Sums are in the order of the boundary particles, and contacts are counted by integers: the same bits for any number
 *  of threads. */
#ifndef SPH2D_SIM_LOADS_H
#define SPH2D_SIM_LOADS_H

#include "base/memory.h"
#include "boundary/moving.h"
#include "methods/common/method.h"

/** A force on a wall, or an impulse. */
typedef struct sph2d__pull {
    double x, y;   /**< [N/m], or [kg/s] */
    double torque; /**< about the load's point, anticlockwise [N], or [kg m/s] */
} sph2d__pull;

/** What is known of a load after a step, and stored: doubles alone. */
typedef struct sph2d__load_state {
    sph2d__pull pressure, friction; /**< of the last evaluation; pressure: and surface tension */
    sph2d__pull springs, contact;   /**< contact: of the last step, over its length */
    sph2d__pull impulse;            /**< since the probe's last sample */
    double power, work;             /**< of the wall on the liquid [W/m]; and on bodies, since the start [J/m] */
} sph2d__load_state;

/** Number of doubles in it. */
enum { SPH2D__LOAD_VALUES = sizeof(sph2d__load_state) / sizeof(double) };

/** A wall whose load is wanted. */
typedef struct sph2d__load {
    int wall;                              /**< scene/world.h */
    sph2d_vec2 about;                      /**< the point of torques, where the wall starts [m] */
    const sph2d__moving *moving;           /**< NULL: at rest */
    sph2d__load_state before;              /**< at the start of the present step */
    int64_t hit_x, hit_y, hit_turn, given; /**< of contacts in this step, in quanta */
} sph2d__load;

typedef struct sph2d__loads {
    sph2d__load *items;        /**< one for each probe of the scene ... */
    size_t *of_probe;          /**< ... of kind force or work: its load by the index of the probe */
    sph2d__load_state *states; /**< of each load */
    size_t count;              /**< of these; behind them that on all walls ... */
    bool watched;              /**< ... which counts in this step, or from its end on */
    int (*walls)[2];           /**< by id of a boundary particle: the wall of its forces along x, and y */
    sph2d__wall_force *forces; /**< by index of a boundary particle: on the liquid, by pressure and friction ... */
    sph2d_vec2 *tensions;      /**< ... and by surface tension; NULL: none */
} sph2d__loads;

/** Makes the loads of the scene's probes; the walls are placed. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__loads_create(sph2d_sim *sim);

/** Whether any count in this step. */
bool sph2d__loads_wanted(const sph2d_sim *sim);

/** Finds the forces right after the method's evaluation, or projection, of which velocities keep the fraction `kept`.
 */
void sph2d__loads_find(sph2d_sim *sim, double kept);

/** Counts what a wall did to a particle at a position, by any thread: the change of its velocity [m/s], and the work by
 *  a wall that moves [J/m]. */
void sph2d__loads_contact(sph2d_sim *sim, int wall, sph2d_vec2 at, sph2d_vec2 change, double work);
/** The same of boundary particle b. */
void sph2d__loads_reflect(sph2d_sim *sim, size_t b, sph2d_vec2 at, sph2d_vec2 change);

/** Counts the work of a wall on bodies that touch it [J/m]. */
void sph2d__loads_carry(sph2d_sim *sim, int wall, double work);

/** Impulses of particles that a body has stopped, in quanta. */
typedef struct sph2d__strikes {
    int64_t x, y, turn;
} sph2d__strikes;

/** Counts the impulse of a particle at a position, whose velocity a body has changed, about a point, by the shortest way
 *  across periodic sides. */
void sph2d__loads_strike(const sph2d_sim *sim, sph2d__strikes *to, sph2d_vec2 point, sph2d_vec2 at, sph2d_vec2 change);
/** The impulse that was counted [kg/s, kg m/s]. */
sph2d__twist sph2d__loads_impulse(const sph2d_sim *sim, const sph2d__strikes *of);

/** Adds up impulses and work at the end of a step. */
void sph2d__loads_close(sph2d_sim *sim, double dt);

/** The sample of a probe is taken: its impulse begins anew. */
void sph2d__loads_sampled(sph2d_sim *sim, size_t probe);

/** Sum of the forces of boundary particle b on the liquid around it. */
sph2d__wall_force sph2d__sim_force_of_wall(const sph2d_sim *sim, size_t b);

#endif
