/* SPDX-License-Identifier: MIT */
/** @file openings_parts.h
 *  What the files of openings share: places seen from an opening, what is before its line, what it prescribes. */
#ifndef SPH2D_SIM_OPENINGS_PARTS_H
#define SPH2D_SIM_OPENINGS_PARTS_H

#include "sim/openings.h"

/** A place seen from an opening: how far along the line, and beyond it [m]. */
typedef struct sph2d__spot {
    double along, beyond;
} sph2d__spot;

static inline sph2d__spot sph2d__spot_of(const sph2d__opening *o, double x, double y)
{
    double rx = x - o->mouth.start.x, ry = y - o->mouth.start.y;
    return (sph2d__spot){rx * o->mouth.along.x + ry * o->mouth.along.y,
                         -(rx * o->mouth.inward.x + ry * o->mouth.inward.y)};
}

static inline sph2d_vec2 sph2d__place_of(const sph2d__opening *o, sph2d__spot s)
{
    return (sph2d_vec2){o->mouth.start.x + s.along * o->mouth.along.x - s.beyond * o->mouth.inward.x,
                        o->mouth.start.y + s.along * o->mouth.along.y - s.beyond * o->mouth.inward.y};
}

/** Sets the line at a distance beyond the side [m]. */
void sph2d__opening_set_line(const sph2d_sim *sim, sph2d__opening *o, double beyond);

/** Pressure of liquid at rest at a place, 0 in the middle of the opening [Pa]. */
double sph2d__rest_pressure(const sph2d_sim *sim, const sph2d__opening *o, double x, double y);

/** The number of particles in a reservoir. */
double sph2d__opening_particles(const sph2d_sim *sim, const sph2d__opening *o);

/** Measures the lanes of all openings, in the order of the particles. */
void sph2d__openings_measure(const sph2d_sim *sim);

/** Adds what was measured to the means, as of the last `dt`. */
void sph2d__openings_average(const sph2d_sim *sim, double dt);

/** Velocity, into the domain and along the line [m/s], and density [kg/m^3] at a place in a reservoir. */
typedef struct sph2d__prescribed {
    double inward, sideward, density;
} sph2d__prescribed;

sph2d__prescribed sph2d__prescribed_at(const sph2d_sim *sim, const sph2d__opening *o, sph2d__spot at, double x,
                                       double y);

/** Gives particle i of a reservoir what is prescribed where it is. */
void sph2d__opening_set_particle(sph2d_sim *sim, const sph2d__opening *o, size_t i);

#endif
