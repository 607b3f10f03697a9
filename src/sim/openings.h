/* SPDX-License-Identifier: MIT */
/** @file openings.h
 *  Openings at run time: reservoirs outside the domain whose particles move as prescribed.
 *
 *  A particle beyond the line of an opening belongs to its reservoir; nothing else tells it from others, so that the
 *  liquid crosses the line without a change. A reservoir consists of *lanes* across which the particles of a full one
 *  stand a spacing apart. In each lane, from the particles before the line, with n the direction into the domain,
 *
 *      p'      pressure at the line, less that of liquid at rest, in the mean over some spacings before the line
 *      dp'/dn  its slope
 *      u, w    velocity along n, and along the line
 *
 *  and <.> their means over a time T, a part of 2 L/c0 with L the diagonal of the domain. Where a velocity U is given,
 *  particles have
 *
 *      v = n (U f(t) - (p' - <p'>)/(rho0 c0)),   p = p' + <dp'/dn> x.n + rho0 g.x
 *
 *  with x from the line and f the profile (or U f(t) the velocity given over place and time); where a pressure P is given
 *
 *      v = n u + t w,   p = P - rho0 c0 (u - <u>) + <dp'/dn> x.n + rho0 g.x
 *
 *  with w = 0 where liquid flows in, u and p' under <.> in the mean over all lanes, and the line a little beyond the
 *  side (SPH2D__DUCT). What is slow against T feels U or P. A plane wave of sound that comes from the domain has
 *  p' = -rho0 c0 u, which both equations agree with, so that it leaves: of p' + rho0 c0 u, which enters, nothing changes
 *  (Lastiwka, Basa & Quinlan 2009, eq. 14 to 16). A wave of frequency omega is reflected by
 *  1/sqrt(1 + (2 omega T)^2).
 *
 *  Outside, liquid is at rest: where it flows in, rho0 <u>^2/2 is taken from P (Bernoulli), without which it would
 *  gain speed without end. A level L is the pressure rho0 g (L - y), without a slope dp'/dn, as the surface outside is
 *  level, where u - <u> counts less towards the surface, whose pressure is that of air. In an opening with a surface
 *  some lanes are *fed*, from the bottom up: those below L, or those of a stream that meets the liquid inside
 *  (openings_measure.c), in the mean over T; a flow rate is divided by their width, in the same mean.
 *
 *  With fitted operators v also has n (p(0) - p'(0))/(rho0 c0) where a pressure is given, so that p' - rho0 c0 u, which
 *  leaves, is that of the domain.
 *
 *  The particles take part in all sums, but their velocity and density are overwritten; what that does to the liquid is
 *  booked as energy fed. */
#ifndef SPH2D_SIM_OPENINGS_H
#define SPH2D_SIM_OPENINGS_H

#include "base/memory.h"
#include "scene/openings.h"
#include "sph2d/sim.h"

/** What an opening keeps from step to step: <u>, <p'>, <dp'/dn>, the depth with which a stream enters and the width
 *  of lanes that are fed, and the time that these means cover, 0 where it was dry; and how many particles came and left at
 *  the end of its reservoir, and were in it at the start. */
typedef struct sph2d__opening_means {
    double velocity, pressure, slope, depth, fed, age;
    double came, left, first;
} sph2d__opening_means;

/** Their number. */
enum { SPH2D__OPENING_VALUES = sizeof(sph2d__opening_means) / sizeof(double) };

/** A lane: what was measured last. */
typedef struct sph2d__lane {
    bool wet;                /**< liquid is before it */
    double pressure, slope;  /**< p' [Pa], dp'/dn [Pa/m] */
    double inward, sideward; /**< u, w [m/s] */
} sph2d__lane;

/** An opening. */
typedef struct sph2d__opening {
    const sph2d_opening *given;
    sph2d__mouth mouth;
    sph2d_vec2 middle; /**< of the opening in the side [m] */
    double duct;       /**< from there to the line [m] */
    sph2d__opening_kind kind;
    bool has_velocity, has_surface;
    double value; /**< U [m/s] or P [Pa] at present */
    sph2d__lane *lanes;
    size_t lane_count;
    double lane_width;           /**< [m] */
    double stride;               /**< between particles of a lane, so that each has its area [m] */
    double depth;                /**< of the reservoir [m] */
    double entering;             /**< depth with which a stream enters now [m] */
    bool wet;                    /**< some lanes are */
    size_t wet_lanes;            /**< their number */
    size_t fed_lanes;            /**< number of those that get particles where liquid flows in, from the first on */
    sph2d__opening_means now;    /**< over the lanes that are wet, as measured last; `age` unused */
    sph2d__opening_means *means; /**< over time: part of the state */
    double *outermost;           /**< of each lane, while it is fed: depth of its last particle [m] */
} sph2d__opening;

typedef struct sph2d__openings {
    sph2d__opening *items;
    size_t count;
    sph2d__opening_means *means; /**< of each */
} sph2d__openings;

/** Makes the openings of a simulation whose walls and system are set. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__openings_create(sph2d_sim *sim);

/** Fills the reservoirs of a new simulation whose blocks are placed: those with a velocity, and others where liquid is
 *  before them. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__openings_fill(sph2d_sim *sim);

/** Between steps: the means go on by the last step, and lanes that move inwards get new particles. Errors:
 *  SPH2D_NOMEM. */
sph2d_status sph2d__openings_feed(sph2d_sim *sim);

/** Whether a particle at a position has left a reservoir by its end. */
bool sph2d__openings_spent(const sph2d_sim *sim, double x, double y);

/** Velocity and density of particles in reservoirs become those prescribed, at the present positions. Nothing without
 *  openings. */
void sph2d__openings_impose(sph2d_sim *sim);

/** Before a step of `dt` by a scheme that sums rates of several steps: particles in reservoirs move as prescribed, and
 *  keep their rates for the steps in which they enter the domain. Fits do not conserve energy pair by pair, so that its
 *  flow is that of pressure at the lines. Nothing without openings. */
void sph2d__openings_hold_rates(sph2d_sim *sim, double dt);

/** Notes that a particle at a position leaves its reservoir. */
void sph2d__openings_count_out(sph2d_sim *sim, double x, double y);

/** What a probe tells of opening `index`: velocity into the domain in the mean over its width where it is wet [m/s],
 *  that times the width [m^2/s], area of the particles that crossed its line, less those that crossed it outwards [m^2],
 *  mean pressure at the side, less that of liquid at rest [Pa], width that is wet [m]. */
enum { SPH2D__OPENING_READINGS = 5 };
void sph2d__opening_read(const sph2d_sim *sim, size_t index, double values[SPH2D__OPENING_READINGS]);

/** The opening in whose reservoir a position lies; NULL for none. */
const sph2d__opening *sph2d__opening_at(const sph2d_sim *sim, double x, double y);

#endif
