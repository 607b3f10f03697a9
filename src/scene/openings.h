/* SPDX-License-Identifier: MIT */
/** @file openings.h
 *  Openings of a scene: where they are, and the reservoirs behind them, outside the domain. The box of a world is larger
 *  than the domain by the reservoirs; what of this addition lies beside openings is solid. */
#ifndef SPH2D_SCENE_OPENINGS_H
#define SPH2D_SCENE_OPENINGS_H

#include "scene/world.h"

/** The line of an opening: a point of it is start + t along, 0 <= t <= width; `inward` points into the domain. */
typedef struct sph2d__mouth {
    sph2d_vec2 start, along, inward;
    double width; /**< [m] */
} sph2d__mouth;

/** Whether a side, by its number, has openings. */
bool sph2d__side_has_opening(const sph2d_scene *scene, int side);

/** The opening of a name; NULL if there is none. */
const sph2d_opening *sph2d__opening_named(const sph2d_scene *scene, const char *name);

sph2d__mouth sph2d__opening_mouth(const sph2d_scene *scene, const sph2d_opening *opening);

/** Number of places at each time of valid points: those that have the time of the first. */
size_t sph2d__profile_places(const sph2d_path *profile);

/** Velocity into the domain at a place along the side [m] and a time, of points that are valid and not none [m/s]; beyond
 *  the places and times that of the nearest. */
double sph2d__profile_velocity(const sph2d_path *profile, double place, double time);

/** Its mean from one place to another. */
double sph2d__profile_mean(const sph2d_path *profile, double from, double to, double time);

/** The largest size of a point [m/s]. */
double sph2d__profile_largest(const sph2d_path *profile);

/** The named profiles: velocity over its mean; z from 0 to 1 across the opening. */
double sph2d__profile_shape(sph2d_opening_profile profile, double z);

/** The largest value of such a profile. */
double sph2d__profile_peak(sph2d_opening_profile profile);

/** What an opening prescribes. */
typedef enum sph2d__opening_kind {
    SPH2D__OPENING_VELOCITY,
    SPH2D__OPENING_FLOW_RATE,
    SPH2D__OPENING_PRESSURE,
    SPH2D__OPENING_LEVEL,
} sph2d__opening_kind;

/** The first one that is given, by a number or over time. */
sph2d__opening_kind sph2d__opening_kind_of(const sph2d_opening *opening);

/** Whether it prescribes a velocity or a flow rate. */
bool sph2d__opening_has_velocity(const sph2d_opening *opening);

/** Whether liquid need not fill it: a level is given, or it has a free surface. */
bool sph2d__opening_has_surface(const sph2d_opening *opening);

/** The history of a kind. */
const sph2d_history *sph2d__opening_history(const sph2d_opening *opening, sph2d__opening_kind kind);

/** What it prescribes at a time: velocity [m/s] (in the mean over its width) and flow rate [m^2/s] after their ramp,
 *  pressure [Pa] or level [m]. */
double sph2d__opening_value(const sph2d_scene *scene, const sph2d_opening *opening, double time);

/** The velocity at a place from its start along it, of an opening whose mean velocity is `mean` now [m/s]. */
double sph2d__opening_velocity_at(const sph2d__mouth *mouth, const sph2d_opening *opening, double mean, double along,
                                  double time);

/** The largest size of that at any time; of a level the highest one. */
double sph2d__opening_largest(const sph2d_opening *opening);

/** The velocity in the mean over the width at a time, of one that liquid fills [m/s]. */
double sph2d__opening_velocity(const sph2d_scene *scene, const sph2d_opening *opening, double time);

/** The largest speed that an opening prescribes; 0 where it prescribes a pressure or level [m/s]. */
double sph2d__opening_speed(const sph2d_scene *scene, const sph2d_opening *opening);

/** The least depth of liquid in an opening with a free surface at a time: critical, and half the width at most [m].
 *  Faster streams have no depth that follows from the liquid before them. */
double sph2d__opening_critical_depth(const sph2d_scene *scene, const sph2d_opening *opening, double time);

/** The height from which liquid that comes in through an opening with a surface may fall, above its lower end [m]. */
double sph2d__opening_highest(const sph2d_scene *scene, const sph2d_opening *opening);

/** Length of the duct between the side and the reservoir of an opening with a pressure [spacings]. Liquid that leaves a
 *  tank is still gathering speed before the side; where its velocity was measured there, a tank was drained at a third
 *  of the speed that Torricelli's law gives. With a duct as long as the measurement it is 0.97, 0.92, 0.67 of that, down to
 *  the duct's end, where 8, 16, 32 particles lie across: on the finest the stream comes off the edges, as water does. */
enum { SPH2D__DUCT = 3 };

/** Rows of particles in a reservoir when it is full. */
size_t sph2d__reservoir_rows(const sph2d_scene *scene);

/** The length of a reservoir with the room beyond its last particle [m]. There they have a free surface, whose total
 *  force does not change when a particle comes or goes; the wall at the end is out of their reach: near it the power that
 *  holds them jumped with each particle, and 11 % of the energy of a stream past a cylinder was unaccounted for. */
double sph2d__reservoir_length(const sph2d_scene *scene);

/** Adds the reservoirs to the box of a world, and solids beside openings to its walls, before its bodies. */
void sph2d__add_reservoirs(sph2d__world *world);

#endif
