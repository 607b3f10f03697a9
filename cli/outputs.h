/* SPDX-License-Identifier: MIT */
/** @file outputs.h
 *  What a run writes: snapshots, frames, probes and, when it stops between snapshots, a checkpoint. Which of them is
 *  due is the simulation's own knowledge and part of its state, so that a resumed run goes on with the next number. */
#ifndef SPH2D_CLI_OUTPUTS_H
#define SPH2D_CLI_OUTPUTS_H

#include <sph2d/io.h>

#include "folder.h"
#include "painter.h"

/** The file that a moment of the run was saved in. */
typedef enum saved_in { SAVED_NOWHERE, SAVED_IN_SNAPSHOT, SAVED_IN_CHECKPOINT } saved_in;

typedef struct cli_outputs {
    cli_folder *folder;
    sph2d_sim *sim;
    const sph2d_scene_file *file;
    cli_painter *painter; /**< NULL: frames count as taken, but none is drawn */
    cli_look look;
    painter_times frames;  /**< what drawing took */
    sph2d_series **series; /**< one a probe */
    size_t series_count;
    uint64_t saved_step; /**< the last step that was saved ... */
    saved_in saved;      /**< ... and where */
} cli_outputs;

/** Whether a scene asks for frames. */
bool outputs_want_frames(const sph2d_scene *scene);

/** Opens the probes' files, each cut to the rows that the simulation knows of. All pointers are borrowed. `saved` tells
 *  what the simulation was restored from. Errors: as sph2d_series_open, SPH2D_NOMEM. */
sph2d_status outputs_open(cli_outputs *o, cli_folder *folder, sph2d_sim *sim, const sph2d_scene_file *file,
                          cli_painter *painter, saved_in saved, sph2d_report *report);

/** Writes whatever is due at this step. */
sph2d_status outputs_write_due(cli_outputs *o, sph2d_report *report);

/** Writes the moment in which a guard fired. */
sph2d_status outputs_write_guard(cli_outputs *o, sph2d_report *report);

/** Leaves the folder as it has to be at the end: a checkpoint where it is needed, no obsolete one. `stopped` tells that
 *  the run did not come to its end. */
sph2d_status outputs_finish(cli_outputs *o, bool stopped, sph2d_report *report);

/** Closes the probes' files and frees everything. */
sph2d_status outputs_close(cli_outputs *o, sph2d_report *report);

#endif
