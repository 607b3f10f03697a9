/* SPDX-License-Identifier: MIT */
/** @file simulation.h
 *  What is inside an sph2d_sim, and what its methods, its start, its probes and its run share. */
#ifndef SPH2D_SIM_SIMULATION_H
#define SPH2D_SIM_SIMULATION_H

#include "boundary/moving.h"
#include "methods/common/method.h"
#include "sim/record.h"
#include "sph2d/state.h"

/** Boundary particles of one obstacle: those with ids from `first` to `end` - 1. */
typedef struct sph2d__ids {
    uint64_t first, end;
} sph2d__ids;

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
    sph2d__ids *obstacle_ids;   /**< of each obstacle: its boundary particles */
    sph2d__point_force *points; /**< room for every interaction and the pointer */
    uint64_t *source_rows;      /**< rows that each source has fed */
    uint64_t *output_counts;    /**< outputs taken: snapshots, frames, then each probe */
    double *gauges;             /**< of each probe: the pressure on its face, and what it shows [Pa] */
    bool gauges_lag;            /**< whether one of them takes time */
    unsigned char *to_remove;   /**< flags of particles to remove */
    size_t to_remove_capacity;

    double weights[3]; /**< of the rates in the step that is being made: adams_bashforth.c */
    double split;      /**< theta of the step that is being made: projected.c */

    sph2d__record record;
    sph2d_status stopped; /**< why no step can follow: SPH2D_GUARD, SPH2D_NOMEM; SPH2D_OK otherwise */
    sph2d_array *state_arrays;
    size_t state_capacity;
};

/** Puts the interactions and the pointer that act at `time` where the method looks for them, and moves obstacles to
 *  where they are then. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__sim_update_forcing(sph2d_sim *sim, double time);
/** Sets over which time the next drift of moving obstacles goes [s]. */
void sph2d__sim_set_drift_interval(sph2d_sim *sim, double from, double to);

/** What a known flow needs to know of the scene. */
sph2d_flow_context sph2d__sim_flow_context(const sph2d_sim *sim);

/** Energy of a column as high as the scene's liquid can fall, over which a rise of energy is reported [J/m]. */
double sph2d__sim_energy_scale(const sph2d_sim *sim);

/** Energy that a particle would have lost on its way, in parts of which whole ones are counted: their sum is the same
 *  for any number of threads [J/m]. */
double sph2d__sim_energy_part(const sph2d_sim *sim);

/** Where a place is, for people: "0.4 spacings from obstacles[1], nearest to blocks[0]" (where.c). */
enum { SPH2D__WHERE_SIZE = 160 };
const char *sph2d__sim_where(const sph2d_sim *sim, sph2d_vec2 place, char text[SPH2D__WHERE_SIZE]);

/** The pose of an obstacle of the scene at the end of the last step. */
sph2d__pose sph2d__sim_pose_of(const sph2d_sim *sim, const sph2d_obstacle *obstacle);
/** Whether the straight way between two places crosses a wall where it is then. */
bool sph2d__sim_crosses_wall(const sph2d_sim *sim, sph2d_vec2 from, sph2d_vec2 to);

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

#endif
