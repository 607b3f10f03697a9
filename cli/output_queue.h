/* SPDX-License-Identifier: MIT */
/** @file output_queue.h
 *  What a run need not wait for: a thread encodes frames and gives snapshots their names, one after the other in the order
 *  in which they came. So whatever a snapshot says has been written is on the disk before the snapshot is. */
#ifndef SPH2D_CLI_OUTPUT_QUEUE_H
#define SPH2D_CLI_OUTPUT_QUEUE_H

#include <sph2d/io.h>

typedef struct output_queue output_queue;

/** Starts the thread, for frames of this size and background. It holds two of them, 4 bytes per pixel; who brings a third waits. NULL
 *  where memory is short or no thread can be started. */
output_queue *output_queue_start(unsigned width, unsigned height, sph2d_background background);

/** Copies pixels (4 bytes each, top row first), for a PNG file. Once something fails nothing more is written, and the
 *  next call returns the error of it; its message is told once. Errors: as sph2d_png_write, SPH2D_NOMEM. */
sph2d_status output_queue_frame(output_queue *queue, const unsigned char *pixels, const char *path,
                                sph2d_report *report);

/** Takes a snapshot that gets its name when everything before it is written. Errors: of what was written before. */
sph2d_status output_queue_snapshot(output_queue *queue, sph2d_snapshot_draft *draft, sph2d_report *report);

/** Waits until everything is written. Errors: of what was written. */
sph2d_status output_queue_wait(output_queue *queue, sph2d_report *report);

/** The CPU time of the thread [s]. */
double output_queue_cpu(const output_queue *queue);

/** The wall time of encoding all frames [s], after output_queue_wait(). */
double output_queue_encoding(const output_queue *queue);

/** Waits until everything is written, and ends the thread; NULL is fine. */
void output_queue_end(output_queue *queue);

#endif
