/* SPDX-License-Identifier: MIT */
/** @file rigid.h
 *  A rigid body of the scene (sph2d_body): its mass, what is known of it between steps, and its way through a step. All
 *  vectors of three are (x, y, turn): of a motion (velocity, acceleration) or of a force with its torque about the centre
 *  of mass. */
#ifndef SPH2D_BOUNDARY_RIGID_H
#define SPH2D_BOUNDARY_RIGID_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "scene/pose.h"

/** A motion [m, rad; over s or s^2], or a force [N/m] with its torque [N]; or an impulse of both. */
typedef struct sph2d__twist {
    double x, y, turn;
} sph2d__twist;

/** What is known of a body between steps, and stored: doubles alone. */
typedef struct sph2d__rigid_state {
    sph2d__twist place;        /**< displacement of the centre of mass [m], and angle [rad] */
    sph2d__twist velocity;     /**< [m/s], [rad/s] */
    sph2d__twist acceleration; /**< by all forces but contacts [m/s^2], [rad/s^2] */
    sph2d__twist held_up;      /**< acceleration by contacts and motor, in the mean over some steps */
    sph2d__twist pushed;       /**< force of the liquid by the last evaluation, or projection */
    sph2d__twist pressed;      /**< the part of that by pressure */
    sph2d__twist felt;         /**< acceleration that its boundary particles had in the last evaluation ... */
    sph2d__twist felt_way;     /**< ... and velocity, with its centripetal part, and Coriolis' in a tank that turns */
    sph2d__twist liquid;       /**< the same in the mean over the last step, with particles that were stopped */
    sph2d__twist gap;          /**< the part of `pushed` by thin gaps between it and other walls (sim/gaps.h) */
    double gap_pressure;       /**< at the middle of these gaps [Pa] */
} sph2d__rigid_state;

/** Number of doubles in it. */
enum { SPH2D__RIGID_VALUES = sizeof(sph2d__rigid_state) / sizeof(double) };

typedef struct sph2d__rigid {
    const sph2d_body *body;
    int wall;                  /**< its number (scene/world.h) */
    uint64_t first_id, end_id; /**< its boundary particles: first_id to end_id - 1 */
    double mass, inertia;      /**< [kg/m], [kg m] */
    double radius;             /**< farthest point of the outline from the centre of mass [m] */
    sph2d__twist free;         /**< 0 where a motion is held, else 1 */
    sph2d_vec2 center;         /**< of mass, where the scene draws it [m] */
    sph2d__rigid_state *state;

    double start;        /**< time from which the present way counts [s] */
    double meeting;      /**< time to which the velocity along it belongs: accelerations change it around that [s] */
    bool knows_felt;     /**< `felt` is that of the last evaluation, not to be found anew */
    double now;          /**< time for which its boundary particles were placed last [s] */
    sph2d__twist from;   /**< place at its start */
    sph2d__twist way;    /**< the velocity along it */
    sph2d__twist meant;  /**< the same without motors and contacts */
    sph2d__twist before; /**< force of the liquid at the start of the step ... */
    sph2d__twist gap_before; /**< ... and that of gaps */
    sph2d__twist other;      /**< all forces but pressure and contacts, as they are known before it */
    sph2d__twist rubbed;     /**< the part of `pushed` by friction */
    sph2d__twist done;       /**< change of velocity by forces whose work over the step is known before contacts are */
} sph2d__rigid;

/** Acceleration by a force, where the body is free. */
static inline sph2d__twist sph2d__rigid_accelerate(const sph2d__rigid *r, sph2d__twist force)
{
    return (sph2d__twist){r->free.x * force.x / r->mass, r->free.y * force.y / r->mass,
                          r->free.turn * force.turn / r->inertia};
}

/** a + t b. */
static inline sph2d__twist sph2d__twist_add(sph2d__twist a, double t, sph2d__twist b)
{
    return (sph2d__twist){a.x + t * b.x, a.y + t * b.y, a.turn + t * b.turn};
}

/** The power of a force at a velocity [W/m], or half of what doubles a kinetic energy. */
static inline double sph2d__twist_dot(sph2d__twist a, sph2d__twist b)
{
    return a.x * b.x + a.y * b.y + a.turn * b.turn;
}

/** Kinetic energy at a velocity [J/m]. */
static inline double sph2d__rigid_kinetic(const sph2d__rigid *r, sph2d__twist v)
{
    return (r->mass * (v.x * v.x + v.y * v.y) + r->inertia * v.turn * v.turn) / 2;
}

/** The pose at a time of the present way. */
static inline sph2d__pose sph2d__rigid_at(const sph2d__rigid *r, double time)
{
    const sph2d__rigid_state *s = r->state;
    sph2d__twist place = sph2d__twist_add(r->from, time - r->start, r->way);
    sph2d__twist v = sph2d__twist_add(r->way, time - r->meeting, s->acceleration);
    sph2d__twist a = sph2d__twist_add(s->acceleration, 1, s->held_up);
    return (sph2d__pose){.center = r->center,
                         .displacement = {place.x, place.y},
                         .angle = place.turn,
                         .cosine = cos(place.turn),
                         .sine = sin(place.turn),
                         .velocity = {v.x, v.y},
                         .omega = v.turn,
                         .acceleration = {a.x, a.y},
                         .alpha = a.turn};
}

/** From the centre of mass to a position, by the pose at the end of the way. */
static inline sph2d_vec2 sph2d__rigid_center(const sph2d__rigid *r, double time)
{
    sph2d__twist place = sph2d__twist_add(r->from, time - r->start, r->way);
    return (sph2d_vec2){r->center.x + place.x, r->center.y + place.y};
}

#endif
