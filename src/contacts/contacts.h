/* SPDX-License-Identifier: MIT */
/** @file contacts.h
 *  Internal interfaces of the library: one call of the solver.
 *
 *  Everything is placed as it is at the start of the step (place.c), pairs that are near each other are found by boxes
 *  (pairs.c), Chipmunk finds where their convex pieces (convex.h, pieces.c) are near (touch.c), bodies that hang together
 *  are grouped (groups.c), and impulses are found for each group (relax.c, rows.h).
 *
 *  Chipmunk's space is not used: docs/notes/contacts.md has what it would do. */
#ifndef SPH2D_CONTACTS_CONTACTS_H
#define SPH2D_CONTACTS_CONTACTS_H

#include <stdbool.h>
#include <stdint.h>

#include "base/memory.h"
#include "sph2d/sim.h"

struct cpBody;
struct cpShape;

/** The walls of wall_work (sph2d_contact_solver): sides, then obstacle i as SPH2D__SIDES + i. */
enum { SPH2D__SIDE_LEFT, SPH2D__SIDE_RIGHT, SPH2D__SIDE_BOTTOM, SPH2D__SIDE_TOP, SPH2D__SIDES };

/** A body or an obstacle where it is now, or a periodic image of a body. */
typedef struct sph2d__placed {
    const sph2d_shape *shape;
    sph2d_vec2 from, to;       /**< its centre in the scene, and now [m] */
    double cosine, sine;       /**< of the angle by which it has turned */
    sph2d_vec2 velocity;       /**< of an obstacle's centre [m/s] */
    double rate;               /**< of an obstacle [rad/s] */
    uint32_t number;           /**< of the body; the number of bodies for obstacles */
    uint32_t wall;             /**< of an obstacle or side: its place in wall_work */
    bool image;                /**< whether it is a periodic image */
    bool hollow;               /**< whether an obstacle has the liquid inside */
    const sph2d_vec2 *corners; /**< where they are now, with those of arcs; none of a circle */
    size_t corner_count;
    sph2d_vec2 center;       /**< of a circle, where it is now */
    sph2d_box box;           /**< around all of it, grown by the margin */
    struct cpShape **pieces; /**< convex pieces, once they are needed */
    size_t piece_count;      /**< 0: along its outline instead (sph2d__edge) */
    bool cut;                /**< whether these two are set */
} sph2d__placed;

/** Two that are near each other; the first is a body. */
typedef struct sph2d__pair {
    uint32_t a, b; /**< indices of placed */
} sph2d__pair;

/** A point where a body meets another one, or a wall. */
typedef struct sph2d__contact {
    uint32_t a, b;        /**< bodies; b is the number of bodies for a wall */
    sph2d_vec2 normal;    /**< from a to b */
    sph2d_vec2 arm_a;     /**< from the centre of mass of a to the middle of the gap [m] */
    sph2d_vec2 arm_b;     /**< the same of b */
    double gap;           /**< distance, negative where they overlap [m] */
    sph2d_vec2 wall;      /**< velocity of the wall there [m/s] */
    uint32_t wall_number; /**< its place in wall_work */
    double friction;      /**< coefficient */
    double restitution;   /**< normal speed after over before */
    double size;          /**< of the smaller of the two bodies [m] */
} sph2d__contact;

/** What one call works with. */
typedef struct sph2d__contacts {
    const sph2d_scene *scene;
    const sph2d_body_state *obstacles; /**< of each obstacle of the scene */
    double dt;                         /**< length of the step [s] */
    sph2d_contact_body *bodies;
    uint32_t body_count;
    double *wall_work; /**< of each wall, on bodies (sph2d_contact_solver) [J/m] */
    double clearance;  /**< that bodies keep [m] */
    double margin;     /**< by which everything is grown in the search for what it may meet in the step [m] */
    sph2d__memory memory;
    sph2d__arena arena;
    sph2d__placed *placed; /**< bodies, then images, then obstacles */
    size_t placed_count, placed_room;
    sph2d__pair *pairs;
    size_t pair_count, pair_room;
    sph2d__contact *contacts;
    size_t contact_count, contact_room;
    struct cpBody *ground; /**< to which Chipmunk's shapes belong; NULL before there is one */
} sph2d__contacts;

/** Solves the contacts of a step: the library without a simulation. `obstacles` has a state for each obstacle of the
 *  scene; the work of walls is added to `wall_work` (sph2d_contact_solver). Errors: SPH2D_NOMEM, and SPH2D_INVALID for
 *  a place or velocity that is not finite; the bodies are then as they were. */
sph2d_status sph2d__contacts_solve(const sph2d_scene *scene, const sph2d_body_state *obstacles, double dt,
                                   sph2d_contact_body *bodies, size_t count, double *wall_work);

/* ---- place.c ----------------------------------------------------------------------------------------------------- */

/** Sets the corners of what is placed, or a circle's centre. False when memory is short. */
bool sph2d__place_corners(sph2d__contacts *c, sph2d__placed *placed);
/** Velocity of the point of an obstacle that is at a position now [m/s]. */
sph2d_vec2 sph2d__wall_velocity(const sph2d__placed *placed, sph2d_vec2 at);
/** Sets margin, bodies and obstacles where they are now. */
sph2d_status sph2d__place_all(sph2d__contacts *c);

/* ---- pairs.c ----------------------------------------------------------------------------------------------------- */

/** Finds periodic images, then all pairs of which the first is a body, and whose boxes overlap. */
sph2d_status sph2d__find_pairs(sph2d__contacts *c);

/* ---- pieces.c ---------------------------------------------------------------------------------------------------- */

/** The largest number of corners of a concave body that is cut into convex pieces, in each step, in a time that grows
 *  as their square. */
enum { SPH2D__MOST_CUT_CORNERS = 128 };

/** Cuts an outline into convex pieces, unless it is one that is met along its line. */
sph2d_status sph2d__cut(sph2d__contacts *c, sph2d__placed *placed);
/** Number of edges of an outline that is met along its line. */
size_t sph2d__edge_count(const sph2d__placed *placed);
/** A new segment for an edge, which belongs to the caller; NULL for edges outside `box`. Parts that are hidden by the
 *  edges before and after meet nothing. */
struct cpShape *sph2d__edge(const sph2d__contacts *c, const sph2d__placed *placed, size_t index, const sph2d_box *box);
/** Frees all pieces. */
void sph2d__free_pieces(sph2d__contacts *c);

/* ---- touch.c ----------------------------------------------------------------------------------------------------- */

/** Finds where pairs, and bodies and sides of the domain, are near each other. */
sph2d_status sph2d__find_contacts(sph2d__contacts *c);

/* ---- groups.c ---------------------------------------------------------------------------------------------------- */

/** A body or a contact, and its group: the smallest number of a body in it. */
typedef struct sph2d__member {
    uint32_t group, index;
} sph2d__member;

/** Bodies that move and have contacts, and all contacts, by groups, which share no body that can move. */
typedef struct sph2d__groups {
    sph2d__member *bodies, *contacts;
    size_t body_count;
} sph2d__groups;

/** Whether a body can move; walls, which are the number of bodies, do not. */
bool sph2d__moves(const sph2d__contacts *c, uint32_t body);
/** Finds the groups; their memory is that of the arena. */
sph2d_status sph2d__find_groups(sph2d__contacts *c, sph2d__groups *groups);

/* ---- relax.c ----------------------------------------------------------------------------------------------------- */

/** Changes the velocities of the bodies by the impulses of all contacts, and adds the work of walls by these. */
sph2d_status sph2d__relax(sph2d__contacts *c, const sph2d__groups *groups);

#endif
