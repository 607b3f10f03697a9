/* SPDX-License-Identifier: MIT */
/** @file bodies.h
 *  Bodies that the liquid moves: the forces on them, their motion over a step, and their energy. A scene without bodies
 *  has none, and all of these functions return at once.
 *
 *  The force of the liquid is minus the sum of what the body's boundary particles exert on it, so that momentum is kept;
 *  a body takes the time scheme of the liquid around it:
 *
 *      kick-drift-kick                                    methods that solve for pressure
 *      V(n+1/2) = V(n) + dt/2 A(n)                        X(n+1/2) = X(n) + dt/2 V(n)
 *      X(n+1)   = X(n) + dt V(n+1/2)                      V(n+1)   = V(n) + dt A(n+1/2)
 *      V(n+1)   = V(n+1/2) + dt/2 A(n+1)                  X(n+1)   = X(n+1/2) + dt/2 V(n+1)
 *
 *  A motor, and a solver for contacts if the program has one, change V(n+1/2), or V(n+1) on the right. Particles that a
 *  body stops add their impulse at the end of the step. */
#ifndef SPH2D_SIM_BODIES_H
#define SPH2D_SIM_BODIES_H

#include "boundary/moving.h"
#include "methods/common/method.h"
#include "methods/common/slabs.h"
#include "sim/gaps.h"
#include "sim/loads.h"

typedef struct sph2d__bodies {
    sph2d__rigid *items; /**< in the order of the scene */
    size_t count;
    sph2d__rigid_state *states;
    sph2d__strikes *strikes;      /**< of each, in this step */
    sph2d__wall_force *forces;    /**< of each boundary particle of a body, by id from `first` on, on the liquid */
    sph2d_vec2 *tensions;         /**< the same by surface tension, by index of all boundary particles; NULL: none */
    sph2d_contact_body *contacts; /**< what the solver sees ... */
    double *wall_work;            /**< ... and what it tells of each wall: the work on bodies in a step [J/m] */
    size_t wall_count;            /**< sides of the domain and obstacles of the scene */
    sph2d__gaps gaps;
    uint64_t first, end;          /**< ids of their boundary particles */
    sph2d_contact_solver *solver; /**< NULL: none */
    void *user;
} sph2d__bodies;

/** Makes the bodies of the scene; their outlines are placed. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__bodies_create(sph2d_sim *sim);

/** Puts all bodies where their states say, at rest along their ways. */
void sph2d__bodies_stand(sph2d_sim *sim, double time);

/** Whether boundary particles have the accelerations and velocities of the last evaluation, for another one at the same
 *  time that must leave their pressures as they are: one that finds what a state does not hold, or samples dissipation.
 *  Bodies stand (above) at that time. */
void sph2d__bodies_know(sph2d_sim *sim, bool felt);

/** Notes where their boundary particles are, once these are placed for a time and sorted. */
void sph2d__bodies_index(sph2d_sim *sim, double time);

/** The acceleration with which a run starts, by the forces right after the method's first evaluation. */
void sph2d__bodies_start(sph2d_sim *sim);

/** Kick-drift-kick: the way through a step that starts now. Errors: those of the solver for contacts. */
sph2d_status sph2d__bodies_kick(sph2d_sim *sim, double dt);
/** The second kick, by the forces right after the method's evaluation. */
void sph2d__bodies_second_kick(sph2d_sim *sim, double dt);

/** Methods that solve for pressure: the way to the middle; the forces right after the projection; what these add to W,
 *  A', C of projected.c, in that order [m^2/s^2 times the mass of a particle]; and, when velocities keep all but `split`
 *  of pressure's part, the way from the middle on. Errors: those of the solver for contacts. */
void sph2d__bodies_drift(sph2d_sim *sim, double dt);
void sph2d__bodies_press(sph2d_sim *sim);
void sph2d__bodies_add_work(const sph2d_sim *sim, double dt, sph2d__slab_sum *sum);
sph2d_status sph2d__bodies_project(sph2d_sim *sim, double dt, double split);

/** Methods with a grid, whose liquid has its impulses at the end of a step: the ways without these; then, with the impulses
 *  of pressure [N s/m], one a body, velocities and ways, and the work of these impulses. Errors: those of the solver for
 *  contacts. */
void sph2d__bodies_fall(sph2d_sim *sim, double dt);
sph2d_status sph2d__bodies_push(sph2d_sim *sim, double dt, const sph2d__twist *impulses, double *work);

/** Methods whose liquid and bodies move each other all through a step, which starts by _drift; once `pressed` of all is the
 *  mean force over it, besides what was expected before, and `way` their mean velocity by both: velocities and ways. Errors: those of the solver for contacts. */
sph2d_status sph2d__bodies_carry(sph2d_sim *sim, double dt);

/** Ends a step: impulses of contacts with particles, and the boundary particles' velocities. */
void sph2d__bodies_close(sph2d_sim *sim, double dt);

/** The part of a change of velocity that stops a particle at a body, such that energy does not grow: the body gives
 *  way, and others may strike it in the same step. */
double sph2d__bodies_share(const sph2d_sim *sim, const sph2d__moving *moving, sph2d_vec2 at, sph2d_vec2 change);

/** Counts a particle that a body has stopped, by any thread: the change of its velocity [m/s]. */
void sph2d__bodies_strike(sph2d_sim *sim, const sph2d__moving *moving, sph2d_vec2 at, sph2d_vec2 change);

/** Sets what forces but pressure are expected at a time: those of the liquid's friction as they were last. */
void sph2d__bodies_expect(sph2d_sim *sim, double time);

/** Forces but those of the liquid and of contacts, at a time of the present way [N/m]. */
sph2d__twist sph2d__bodies_other_force(const sph2d_sim *sim, const sph2d__rigid *r, double time);

/** Kinetic and potential energy, with that of springs, of one body and of all [J/m]. */
double sph2d__body_energy(const sph2d_sim *sim, const sph2d__rigid *r);
double sph2d__bodies_energy(const sph2d_sim *sim);
/** Power of forces on bodies that have no potential [W/m]: work.c. */
double sph2d__bodies_power(const sph2d_sim *sim);
/** The fastest point of a body [m/s], and the longest step that is stable with its springs and with liquid as stiff as
 *  this around it [s]. */
double sph2d__bodies_speed(const sph2d_sim *sim);
double sph2d__bodies_step(const sph2d_sim *sim);

#endif
