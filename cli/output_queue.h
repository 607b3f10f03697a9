/* SPDX-License-Identifier: MIT */
/** @file output_queue.h
 *  What a run need not wait for: a thread draws frames and gives snapshots their names, one after the other in the order
 *  in which they came. So whatever a snapshot says has been written is on the disk before the snapshot is. */
#ifndef SPH2D_CLI_OUTPUT_QUEUE_H
#define SPH2D_CLI_OUTPUT_QUEUE_H

#include <sph2d/io.h>

#include "frame_writer.h"

typedef struct output_queue output_queue;

/** Starts the thread, which uses the writer from now on. It holds the particles of two frames; who brings a third waits. NULL
 *  where memory is short or no thread can be started. */
output_queue *output_queue_start(frame_writer *writer);

/** Copies particles, to be drawn to a PNG file. Once something fails nothing more is written, and the next call returns
 *  the error of it; its message is told once. Errors: as frame_writer_write. */
sph2d_status output_queue_frame(output_queue *queue, const particle_source *source, const frame_style *style,
                                const char *path, sph2d_report *report);

/** Takes a snapshot that gets its name when everything before it is written. Errors: of what was written before. */
sph2d_status output_queue_snapshot(output_queue *queue, sph2d_snapshot_draft *draft, sph2d_report *report);

/** Waits until everything is written. Errors: of what was written. */
sph2d_status output_queue_wait(output_queue *queue, sph2d_report *report);

/** The CPU time of the thread [s]. */
double output_queue_cpu(const output_queue *queue);

/** The times of all frames, after output_queue_wait(). */
frame_times output_queue_times(const output_queue *queue);

/** Waits until everything is written, and ends the thread; NULL is fine. */
void output_queue_end(output_queue *queue);

#endif
