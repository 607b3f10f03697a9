/* SPDX-License-Identifier: MIT */
/** @file loop.h
 *  The main loop of `run` and `resume`: steps until the end of a run, with outputs between steps. */
#ifndef SPH2D_CLI_LOOP_H
#define SPH2D_CLI_LOOP_H

#include "message.h"
#include "outputs.h"

/** How a session ended. */
typedef enum loop_end {
    LOOP_FINISHED, /**< run.until is reached */
    LOOP_SIGNAL,   /**< stopped by a signal */
    LOOP_MAX_WALL, /**< stopped by --max-wall */
    LOOP_GUARD,    /**< stopped by a guard of the simulation */
    LOOP_FAILED    /**< stopped by an error of writing, or out of memory */
} loop_end;

/** The work and the cost of a session. */
typedef struct loop_result {
    loop_end end;
    int signal;          /**< its number, for LOOP_SIGNAL */
    sph2d_status status; /**< SPH2D_OK unless LOOP_GUARD or LOOP_FAILED */
    double step_wall;    /**< stepping alone [s] */
    double step_cpu;     /**< of all threads, stepping alone [s] */
    double output_wall;  /**< writing and drawing, as far as the steps wait for it [s] */
    double output_cpu;   /**< of all threads, also beside the steps [s] */
    frame_times frames;  /**< the part of it for frames */
    uint64_t steps, particle_steps;
    double simulated; /**< [s] */
} loop_result;

/** Whether a time is the end of a run, or later. */
bool loop_reached(double time, double until);

/** Whether a simulation has reached run.until. */
bool loop_done(const sph2d_sim *sim);

/** Runs `sim` to run.until, or until `deadline` on the wall clock (0: none), writing to `o`. Errors are in the result
 *  and the report. A run that was stopped can be resumed from the folder. */
loop_result loop_run(sph2d_sim *sim, cli_outputs *o, cli_progress *p, double deadline, sph2d_report *report);

#endif
