/* SPDX-License-Identifier: MIT */
/** @file contacts.h
 *  Contacts of bodies with each other, with obstacles at rest and moving, and with the wall sides of the domain.
 *  Library libsph2d-contacts.
 *
 *      if (sph2d_sim_create(&scene, NULL, &sim, &report) == SPH2D_OK && sph2d_contacts_attach(sim) == SPH2D_OK)
 *          while (sph2d_sim_time(sim) < end && sph2d_sim_step(sim, &report) == SPH2D_OK)
 *              ;
 *
 *  - Bodies keep a clearance of 1/5 of the scene's spacing, in which particles of the liquid that are caught have room.
 *    What is nearer is pushed out by a fifth of what lacks in each step, at most by a fiftieth of the clearance, and
 *    never with more kinetic energy than the bodies came with.
 *  - Dry friction, and restitution, but for approaches so slow that the body would rise by less than 1/800 of its size
 *    in Earth's gravity. Of two bodies the geometric mean and the larger count, against walls the body's own.
 *  - Momentum is exchanged to round-off; kinetic energy never grows but by the work of walls that move, which is told
 *    to the energy balance.
 *  - Circles are circles; polygons may be concave (as a solid up to 128 corners, beyond that as the line of their
 *    outline). Lines, polylines and hollow or concave obstacles are lines without thickness, met from both sides,
 *    whatever layers of boundary particles a method puts behind them.
 *  - What slides along lines does not feel their corners; over bodies that abut it may catch on them, since what comes
 *    near in a step is stopped by the plane between the closest points.
 *  - Sides that are walls extend beyond the corners of the domain; with their tangential speeds they are belts. Open
 *    sides stop nothing. Across periodic sides bodies meet each other and obstacles.
 *
 *  Nothing is kept from step to step, so that a resumed run continues with the same bits. Results do not depend on
 *  threads or addresses. Bodies that are near nothing cost next to nothing. */
#ifndef SPH2D_CONTACTS_H
#define SPH2D_CONTACTS_H

#include "sph2d/sim.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Makes the bodies of a simulation meet each other and walls, from its next step on. It holds no memory between steps,
 *  and sph2d_sim_set_contacts() ends it. A step ends with SPH2D_NOMEM when memory for contacts is short, and with
 *  SPH2D_INVALID when the place or velocity of a body is not finite. Errors: SPH2D_INVALID for NULL. */
SPH2D_API sph2d_status sph2d_contacts_attach(sph2d_sim *sim);

#ifdef __cplusplus
}
#endif
#endif
