/* SPDX-License-Identifier: MIT */
/** @file simulation.h
 *  The contents of an sph2d_sim, and the functions that methods, start, probes and run share. */
#ifndef SPH2D_SIM_SIMULATION_H
#define SPH2D_SIM_SIMULATION_H

#include "boundary/moving.h"
#include "methods/common/method.h"
#include "methods/common/on_device.h"
#include "scene/colors.h"
#include "scene/motion.h"
#include "scene/solids.h"
#include "scene/world.h"
#include "sim/bodies.h"
#include "sim/device_data.h"
#include "sim/loads.h"
#include "sim/openings.h"
#include "sim/outlines.h"
#include "sim/record.h"
#include "sph2d/state.h"

/** The ids of a wall's boundary particles: `first` to `end` - 1. */
typedef struct sph2d__ids {
    uint64_t first, end;
} sph2d__ids;

/** Particles that probes of kind tracer follow (probes/tracer.c). */
typedef struct sph2d__tracers {
    uint64_t *particles; /**< of each probe: the id of its particle plus 1; 0: none yet. NULL without tracers */
    double *places;      /**< x and y, where outputs found them [m] ... */
    uint64_t *probes;    /**< ... and of which probe each is */
    size_t count, room;  /**< of these */
} sph2d__tracers;

/** Forces that a program sets while a run goes on. */
typedef struct sph2d__steering {
    double gravity_x, gravity_y;                                       /**< [m/s^2] */
    double pointer_x, pointer_y, pointer_radius, pointer_acceleration; /**< [m], [m/s^2]; acceleration 0: no pointer */
} sph2d__steering;
/** Number of doubles in it. */
enum { SPH2D__STEERING_VALUES = sizeof(sph2d__steering) / sizeof(double) };

struct sph2d_sim {
    sph2d__world world; /**< its lists are in `arena` */
    sph2d__arena arena;
    sph2d__memory memory;
    sph2d_plan plan;

    sph2d__system system;
    sph2d__tables tables;
    const sph2d__method *method;
    int threads; /**< wanted; 0: those of OpenMP, or fewer */
    sph2d__barrier barrier;
    sph2d__course tank;    /**< of the domain: scene/frame.h */
    sph2d__moving *moving; /**< capacity: every wall */
    size_t moving_count;
    sph2d__ids *wall_ids;                     /**< of each wall but sides, for which it is 0 to 0 */
    sph2d__loads loads;                       /**< forces on walls that probes measure */
    sph2d_vec2 momentum_before, force_before; /**< at the start of the step ... */
    uint64_t momentum_kept;     /**< of which step they are known from the end of the one before; 0: of none */
    bool momentum_watched;      /**< ... whose momentum is balanced ... */
    bool momentum_changed;      /**< ... and before which particles came or went */
    bool momentum_cut;          /**< ... and liquid was taken away by a program */
    sph2d__bodies bodies;       /**< that the liquid moves */
    sph2d__openings openings;   /**< through which liquid flows in and out */
    sph2d__outlines outlines;   /**< of walls and bodies, as they are now */
    sph2d__solids solids;       /**< the walls as they are when the liquid is placed */
    sph2d__point_force *points; /**< capacity: every interaction and the pointer */
    uint64_t *source_rows;      /**< rows that each source has emitted */
    uint64_t *output_counts;    /**< outputs written: snapshots, frames, then each probe */
    double *gauges;             /**< of each probe: the pressure on its face, and its reading [Pa] */
    bool gauges_lag;            /**< whether a gauge has a rise time */
    sph2d__tracers tracers;
    sph2d__drift *drifts;     /**< on a device: of obstacles that move, as kernels get them */
    sph2d__contact *contacts; /**< on a device: what walls did to particles in a step, for loads ... */
    uint32_t *contact_count;  /**< ... and how many they are ... */
    uint32_t contact_room;    /**< ... for which there is room */
    bool none_left;           /**< the last step is known to have left no particle beyond an open side */
    unsigned char *to_remove; /**< flags of particles to remove */
    size_t to_remove_capacity;

    double weights[3]; /**< of the rates in the present step: adams_bashforth.c */
    double split;      /**< theta of the present step: projected.c */

    sph2d__record record;
    sph2d__steering acting; /**< that of the last evaluation, which a restored simulation repeats; state */
    sph2d_status stopped;   /**< why the run cannot go on: SPH2D_GUARD, SPH2D_NOMEM; SPH2D_OK otherwise */
    sph2d_array *state_arrays;
    size_t state_capacity;
};

/** Sets the forces on the liquid as they are now, and have not acted yet: those of the record. */
void sph2d__sim_steer(sph2d_sim *sim);
/** Lets the forces of the record act from now on: the next evaluation is with them. */
void sph2d__sim_act(sph2d_sim *sim);
/** Whether gravity or the pointer were set since the last evaluation. */
bool sph2d__sim_is_steered(const sph2d_sim *sim);
/** Sets the forces that act (gravity, interactions, pointer, frame) and moves the obstacles to their positions at
 *  `time`. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__sim_repeat_forcing(sph2d_sim *sim, double time);
/** The same, with the forces of the record. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__sim_update_forcing(sph2d_sim *sim, double time);
/** Sets the time interval of the next drift, for moving obstacles [s]. */
void sph2d__sim_set_drift_interval(sph2d_sim *sim, double from, double to);

/** The place on a path at a time; false, with `at` as it was, before its first point and after its last. A single point
 *  is there always. */
bool sph2d__path_at(const sph2d_path *path, double time, sph2d_vec2 *at);

/** Whether a step ran out of memory, or its device failed: it ended in the middle, and the cells may not be those of the
 *  particles. */
static inline bool sph2d__sim_is_broken(const sph2d_sim *sim)
{
    return sim->stopped == SPH2D_NOMEM || sim->stopped == SPH2D_DEVICE ||
           (sph2d__is_on_device(&sim->system) && sph2d__device_is_lost(&sim->system));
}

/** The scene's parameters that known flows use. */
sph2d_flow_context sph2d__sim_flow_context(const sph2d_sim *sim);

/** The energy scale of rises and errors: of a column as high as the liquid can fall, and what it starts with [J/m]. */
double sph2d__sim_energy_scale(const sph2d_sim *sim);
/** The same without the elastic energy of liquid that starts pressed together. */
double sph2d__sim_fall_energy(const sph2d_sim *sim);

/** The quantum in which energy lost at walls is counted by integers, so that the sum is the same for any number of
 *  threads [J/m]. */
double sph2d__sim_energy_quantum(const sph2d_sim *sim);

/** Describes a position: "0.4 spacings from obstacles[1], nearest to blocks[0]" (where.c). */
enum { SPH2D__WHERE_SIZE = 160 };
const char *sph2d__sim_where(const sph2d_sim *sim, sph2d_vec2 place, char text[SPH2D__WHERE_SIZE]);

/** The pose of a wall at the end of the last step. */
sph2d__pose sph2d__sim_pose_of(const sph2d_sim *sim, const sph2d__wall *wall);
/** Whether the straight line between two positions crosses a wall in its present position. */
bool sph2d__sim_crosses_wall(const sph2d_sim *sim, sph2d_vec2 from, sph2d_vec2 to);

/** Whether work and dissipation are sampled after a number of steps. */
bool sph2d__sim_samples_energy(const sph2d_sim *sim, uint64_t steps);
/** Whether the error of the energy balance, and the spurious rise of energy, are known: see work.c on fitted
 *  operators. */
bool sph2d__sim_error_is_known(const sph2d_sim *sim);
bool sph2d__sim_rise_is_known(const sph2d_sim *sim);
/** Before the method's step, and after the loads' end of it: in some steps, adds the momentum that came from nothing to
 *  the balance (momentum.c), which is known but with openings or fitted operators. */
void sph2d__momentum_begin(sph2d_sim *sim);
/** In the record's momentum_changes, so that a state has it, too: a program took liquid away since the last step. */
#define SPH2D__MOMENTUM_CUT UINT64_MAX
void sph2d__momentum_end(sph2d_sim *sim, double dt);
bool sph2d__sim_momentum_is_known(const sph2d_sim *sim);
/** Samples dissipation and adds that since the last sample to the energy balance (work.c). Errors: SPH2D_NOMEM. */
sph2d_status sph2d__sim_book_dissipation(sph2d_sim *sim);
/** Adds the work of moving walls and of forces, sampled every few steps. */
void sph2d__sim_book_external_work(sph2d_sim *sim);
/** Whether all of it up to now was added. */
bool sph2d__sim_external_work_is_booked(const sph2d_sim *sim);
/** Work that the time schemes sample in a step of `dt`: of
 *  viscosity, once the accelerations without pressure are known; of moving walls, after a pressure solver, which is
 *  returned; and of both kinds of dissipation, in place of a fitted method's evaluation. False when memory is short. */
bool sph2d__sim_book_viscosity(sph2d_sim *sim, double dt);
double sph2d__sim_book_wall_work(sph2d_sim *sim, double dt);
bool sph2d__sim_book_fitted(sph2d_sim *sim, double dt);

/** Adds a particle of liquid at a place, for which memory is reserved, with the colour `own` (scene/colors.h). Returns its
 *  index. */
static inline size_t sph2d__sim_add_liquid(sph2d_sim *sim, sph2d_vec2 at, const char *own)
{
    sph2d__store *f = &sim->system.fluid;
    size_t i = sph2d__store_add(f, sim->record.next_id++, at.x, at.y);
    if (f->colored)
        f->color[i] = sph2d__color_of(&sim->world.scene, own);
    return i;
}

/** Kinetic and potential energy of one particle [J/m]. */
double sph2d__sim_energy_of(const sph2d_sim *sim, double x, double y, double vx, double vy);

/** Kinetic and potential energy of the liquid [J/m]. */
double sph2d__sim_energy_of_all(const sph2d_sim *sim);

/** The power of forces without a potential on the liquid, and of all on bodies: work.c [W/m]. */
double sph2d__sim_power_of_forces(const sph2d_sim *sim);

/** Elastic energy of a kilogram of particle i (state_equation.h, projection.h) [J/kg]. */
double sph2d__sim_elastic_of(const sph2d_sim *sim, size_t i);
/** Whether elastic energy exists only from a compressed start, and so can only fall: the pressures of method pcisph,
 *  iterated to a small compression, store none. */
bool sph2d__sim_elastic_falls(const sph2d_sim *sim);

/** Sets the energies, momentum and largest speed of a summary. */
void sph2d__sim_sum_energy(const sph2d_sim *sim, sph2d_summary *out);

#endif
