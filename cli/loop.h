/* SPDX-License-Identifier: MIT */
/** @file loop.h
 *  Step after step until the end of a run, with outputs at step boundaries: the one loop of `run` and `resume`. */
#ifndef SPH2D_CLI_LOOP_H
#define SPH2D_CLI_LOOP_H

#include "outputs.h"
#include "progress.h"

/** How a session ended. */
typedef enum loop_end {
    LOOP_FINISHED, /**< run.until is reached */
    LOOP_SIGNAL,   /**< a signal asked to stop */
    LOOP_MAX_WALL, /**< the wall clock did */
    LOOP_GUARD,    /**< a guard of the simulation did */
    LOOP_FAILED    /**< something could not be written, or memory is gone */
} loop_end;

/** What a session did, and what it cost. */
typedef struct loop_result {
    loop_end end;
    int signal;           /**< which one, for LOOP_SIGNAL */
    sph2d_status status;  /**< SPH2D_OK unless LOOP_GUARD or LOOP_FAILED */
    double step_wall;     /**< stepping alone [s] */
    double step_cpu;      /**< of all threads, stepping alone [s] */
    double output_wall;   /**< writing and drawing [s] */
    double output_cpu;    /**< of all threads; the rest is waiting, mostly for the disk [s] */
    painter_times frames; /**< the part of that which frames took */
    uint64_t steps, particle_steps;
    double simulated; /**< [s] */
} loop_result;

/** Whether a simulation has come to the end of its scene. */
bool loop_done(const sph2d_sim *sim);

/** Runs `sim` to the end of its scene, or until `deadline` on the wall clock (0: none), writing to `o`. What went wrong
 *  is in the result and the report. Leaves the folder so that the run can be resumed. */
loop_result loop_run(sph2d_sim *sim, cli_outputs *o, cli_progress *p, double deadline, sph2d_report *report);

#endif
