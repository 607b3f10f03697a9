/* SPDX-License-Identifier: MIT */
/** @file outputs.h
 *  The outputs of a run: snapshots, frames, probes and, if it stops between snapshots, a checkpoint. The simulation
 *  determines which are due as part of its state, so that a resumed run continues with the next number. */
#ifndef SPH2D_CLI_OUTPUTS_H
#define SPH2D_CLI_OUTPUTS_H

#include <sph2d/io.h>

#include "folder.h"
#include "frame_writer.h"
#include "output_queue.h"

/** The file in which a step was saved. */
typedef enum saved_in { SAVED_NOWHERE, SAVED_IN_SNAPSHOT, SAVED_IN_CHECKPOINT } saved_in;

typedef struct cli_outputs {
    cli_folder *folder;
    sph2d_sim *sim;
    const sph2d_scene_file *file;
    frame_writer *writer; /**< NULL: frames are counted, but not drawn */
    frame_style style;
    output_queue *queue;   /**< NULL: all is written before a call returns */
    bool old_checkpoint;   /**< there may be one from before this session */
    frame_times frames;    /**< times of frames */
    sph2d_series **series; /**< one per probe */
    size_t series_count;
    bool last_only;      /**< a snapshot of the end was written, as there was nothing else */
    uint64_t saved_step; /**< the last saved step ... */
    saved_in saved;      /**< ... and its file */
} cli_outputs;

/** Whether a scene has frames. */
bool outputs_want_frames(const sph2d_scene *scene);

/** Opens the probes' files, each truncated to the rows counted by the simulation. All pointers are borrowed. `saved` is
 *  the file that the simulation was restored from. Errors: as sph2d_series_open, SPH2D_NOMEM. */
sph2d_status outputs_open(cli_outputs *o, cli_folder *folder, sph2d_sim *sim, const sph2d_scene_file *file,
                          frame_writer *writer, saved_in saved, sph2d_report *report);

/** From now on frames are drawn, and snapshots synced, in a thread beside the steps, in their order: a snapshot gets its
 *  name after the frame before it. Where no thread can be started all is as before. */
void outputs_work_beside(cli_outputs *o);

/** The CPU time of that thread [s]. */
double outputs_cpu_beside(const cli_outputs *o);

/** Waits until everything is written. Errors: those of what was written beside the steps, each once. */
sph2d_status outputs_settle(cli_outputs *o, sph2d_report *report);

/** Writes all outputs that are due at this step. An error may be one of an earlier step, whose outputs were written beside
 *  the steps; then nothing was written after it. */
sph2d_status outputs_write_due(cli_outputs *o, sph2d_report *report);

/** Writes the state in which a guard fired, and removes a checkpoint from before it. */
sph2d_status outputs_write_guard(cli_outputs *o, sph2d_report *report);

/** Writes a checkpoint if needed, and removes an obsolete one. At the end of a run without any outputs writes a snapshot,
 *  and sets `last_only`. `stopped`: the run was stopped before its end. */
sph2d_status outputs_finish(cli_outputs *o, bool stopped, sph2d_report *report);

/** Closes the probes' files and frees everything. */
sph2d_status outputs_close(cli_outputs *o, sph2d_report *report);

#endif
