/* SPDX-License-Identifier: MIT */
/** @file simulation.h
 *  What is inside an sph2d_sim. */
#ifndef SPH2D_SIM_SIMULATION_H
#define SPH2D_SIM_SIMULATION_H

#include "boundary/barrier.h"
#include "methods/common/method.h"
#include "sim/record.h"
#include "sph2d/state.h"

/** An obstacle that moves: its boundary particles first_id to end_id - 1, and a backstop where the scene puts it. */
typedef struct sph2d__moving {
    const sph2d_motion *motion;
    uint64_t first_id, end_id;
    sph2d__barrier barrier;
    sph2d_vec2 from, to; /**< displacements at the start and end of the drift that is being made [m] */
    sph2d_vec2 velocity; /**< mean over that drift [m/s] */
} sph2d__moving;

struct sph2d_sim {
    sph2d_scene scene; /**< a deep copy, in `arena` */
    sph2d__arena arena;
    sph2d__memory memory;
    sph2d_plan plan;

    sph2d__system system;
    const sph2d__method *method;
    sph2d__barrier barrier;
    sph2d__moving *moving; /**< room for every obstacle */
    size_t moving_count;
    uint64_t *wall_ends;        /**< of each obstacle: one above the id of its last boundary particle */
    sph2d__point_force *points; /**< room for every interaction and the pointer */
    uint64_t *source_rows;      /**< rows that each source has fed */
    uint64_t *output_counts;    /**< outputs taken: snapshots, frames, then each probe */
    double *gauges;             /**< of each probe: the pressure on its face, and what it shows [Pa] */
    bool gauges_lag;            /**< whether one of them takes time */
    unsigned char *doomed;      /**< flags of particles to remove */
    size_t doomed_capacity;

    double weights[3]; /**< of the rates in the step that is being made: adams_bashforth.c */
    double split;      /**< theta of the step that is being made: projected.c */

    sph2d__record record;
    sph2d_status stopped; /**< why no step can follow: SPH2D_GUARD, SPH2D_NOMEM; SPH2D_OK otherwise */
    sph2d_array *state_arrays;
    size_t state_capacity;
};

/** Puts the interactions and the pointer that act at `time` where the method looks for them, and moves obstacles to
 *  where they are then. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__sim_aim(sph2d_sim *sim, double time);
/** Tells moving obstacles over which time the next drift goes. */
void sph2d__sim_window(sph2d_sim *sim, double from, double to);

/** Looks at every particle after its velocity and acceleration are new: finite values, largest speed, acceleration and
 *  compression; from them the length of the next step. False when a guard fires. */
bool sph2d__sim_measure(sph2d_sim *sim, sph2d_report *report);
/** Fastest block at the start [m/s], without known flows, which start as they would go on. */
double sph2d__sim_start_speed(const sph2d_sim *sim);
/** The next step over the one that speed and sound allow: less than 1 for the first step of liquid whose density is
 *  integrated and that starts in motion against a wall or other liquid. */
double sph2d__sim_step_part(const sph2d_sim *sim);

/** What a known flow needs to know of the scene. */
sph2d_flow_context sph2d__sim_flow_context(const sph2d_sim *sim);

/** Energy of a column as high as the scene's liquid can fall, over which a rise of energy is told [J/m]. */
double sph2d__sim_energy_scale(const sph2d_sim *sim);

/** Books work and dissipation from time to time, and how far energy rises above an earlier moment (energy.c). Errors:
 *  SPH2D_NOMEM. */
sph2d_status sph2d__sim_watch_energy(sph2d_sim *sim);
/** Energy that a particle would have lost on its way, in parts of which whole ones are counted: their sum is the same
 *  for any number of threads [J/m]. */
double sph2d__sim_energy_part(const sph2d_sim *sim);

/** Where a place is, for people: "0.4 spacings from obstacles[1], nearest to blocks[0]" (where.c). */
enum { SPH2D__WHERE_SIZE = 160 };
const char *sph2d__sim_where(const sph2d_sim *sim, sph2d_vec2 place, char text[SPH2D__WHERE_SIZE]);

/** How far an obstacle of the scene has moved, at the end of the last step [m]. */
sph2d_vec2 sph2d__sim_way_of(const sph2d_sim *sim, const sph2d_obstacle *obstacle);

/** Densities that liquid may have by the method [kg/m^3], and the part of the scene's energy scale by which energy may
 *  rise. */
typedef struct sph2d__bounds {
    double thinnest, densest, rise;
} sph2d__bounds;
sph2d__bounds sph2d__sim_bounds(const sph2d_sim *sim);

/** False, reported, when energy came from nothing. */
bool sph2d__sim_guard_energy(const sph2d_sim *sim, sph2d_report *report);

/** Whether work and dissipation are looked at when so many steps are done. */
bool sph2d__sim_looks(const sph2d_sim *sim, uint64_t steps);
/** Whether the error of energy, and its rise from nothing, can be known: see work.c on fitted operators. */
bool sph2d__sim_error_is_known(const sph2d_sim *sim);
bool sph2d__sim_rise_is_known(const sph2d_sim *sim);
/** Books the work done since the last look (work.c), which is then now. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__sim_book(sph2d_sim *sim);
/** Books the work of walls that move and of forces, in every few steps. */
void sph2d__sim_book_drives(sph2d_sim *sim);
/** Parts of the work that schemes have to book: in the middle of a step of `dt`, once rates of density are known, or
 *  accelerations without pressure; behind a pressure solver, returning what walls bring; and in place of a fitted
 *  method's evaluation. False when memory is short. */
void sph2d__sim_book_diffusion(sph2d_sim *sim, double dt);
bool sph2d__sim_book_middle(sph2d_sim *sim, double dt);
double sph2d__sim_book_projection(sph2d_sim *sim, double dt);
bool sph2d__sim_book_fitted(sph2d_sim *sim, double dt);

/** Kinetic and potential energy of one particle [J/m]. */
double sph2d__sim_energy_of(const sph2d_sim *sim, double x, double y, double vx, double vy);

/** Elastic energy of a kilogram of particle i (state_equation.h, projection.h) [J/kg]. */
double sph2d__sim_elastic_of(const sph2d_sim *sim, size_t i);
/** Whether all of it is what a compressed start held, and only falls: pressures of method pcisph, which end where a
 *  compression is small enough, store nothing. */
bool sph2d__sim_elastic_falls(const sph2d_sim *sim);

/** Sums energy and momentum over the fluid, and finds the largest speed, into those members of a summary. */
void sph2d__sim_sum_energy(const sph2d_sim *sim, sph2d_summary *out);

/** Samples the compression when the step count says so. */
void sph2d__sim_sample(sph2d_sim *sim);

/** The ranges of liquid around a place, which is brought into the period; false where no particle is within reach. */
bool sph2d__sim_around(const sph2d_sim *sim, sph2d_vec2 *place, sph2d__ranges *ranges);

/** Lets gauges that take time show the pressure at the start, and follow it over a step of length dt (gauge.c). */
void sph2d__sim_start_gauges(sph2d_sim *sim);
void sph2d__sim_read_gauges(sph2d_sim *sim, double dt);

/** Fills the plan from a simulation that is ready to step. */
void sph2d__sim_make_plan(sph2d_sim *sim);

/** Feeds and drains at the present moment, before a step. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__sim_feed(sph2d_sim *sim);
sph2d_status sph2d__sim_drain(sph2d_sim *sim);

/** Whether so many particles are more than this machine's memory holds or a 32-bit index can name; then it is reported
 *  at `path`. */
bool sph2d__sim_too_many(const sph2d_sim *sim, double count, const char *path, sph2d_report *report);

/** Places the boundary particles of obstacles and sides. Errors: SPH2D_SCENE, SPH2D_NOMEM. */
sph2d_status sph2d__sim_place_walls(sph2d_sim *sim, sph2d_report *report);
/** Places the layers of a generalised wall: along an obstacle, whose back goes into its barrier, and around the sides
 *  of the domain that are walls. The same errors. */
sph2d_status sph2d__sim_place_layers(sph2d_sim *sim, const sph2d_obstacle *obstacle, sph2d__barrier *barrier,
                                     sph2d_report *report);
sph2d_status sph2d__sim_place_rings(sph2d_sim *sim, sph2d_report *report);
/** Places the particles of one block, and of all with the single ones. Errors: SPH2D_SCENE, SPH2D_NOMEM. */
sph2d_status sph2d__sim_place_block(sph2d_sim *sim, size_t index, sph2d_report *report);
sph2d_status sph2d__sim_place_fluid(sph2d_sim *sim, sph2d_report *report);

/** What an obstacle does to a place: leaves it free, encloses it, has it within the distance that it keeps free behind
 *  its own layers, or without layers. */
typedef enum sph2d__taken { SPH2D__FREE, SPH2D__ENCLOSED, SPH2D__BESIDE_LAYERS, SPH2D__BESIDE_LINE } sph2d__taken;

/** What the obstacles do to a place, or to one of its images beyond periodic sides: the last of the above that one of
 *  them does. They keep `part` of their distance free. */
sph2d__taken sph2d__sim_taken(const sph2d_sim *sim, sph2d_vec2 p, double part);

/** Faults of placed particles. Block `index`, whose particles start at `first`, against those before it; particles in
 *  one place, ids from `first` on being those of single ones; liquid in the layers of an obstacle, both once the cells
 *  are built; that single particle k cannot be where it is. Errors: SPH2D_SCENE. */
sph2d_status sph2d__sim_check_overlap(const sph2d_sim *sim, size_t index, size_t first, sph2d_report *report);
sph2d_status sph2d__sim_check_distances(const sph2d_sim *sim, uint64_t first, sph2d_report *report);
sph2d_status sph2d__sim_check_layers(const sph2d_sim *sim, sph2d_report *report);
sph2d_status sph2d__sim_refuse_particle(size_t k, const char *what, sph2d_vec2 p, sph2d_report *report);

/** Gives the particles of a block, from `first` on, the velocity and pressure of the flow that it starts with. Errors:
 *  SPH2D_SCENE. */
sph2d_status sph2d__sim_start_block(sph2d_sim *sim, size_t index, size_t first, sph2d_report *report);

/** Copies a state into a simulation whose walls are placed and whose fluid is empty. Errors: SPH2D_FORMAT, SPH2D_NOMEM.
 */
sph2d_status sph2d__sim_load(sph2d_sim *sim, const sph2d_state *state, sph2d_report *report);

#endif
