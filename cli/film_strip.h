/* SPDX-License-Identifier: MIT */
/** @file film_strip.h
 *  The film of `sph2d render`: its pace and size, and the order of frames that several threads draw at once. */
#ifndef SPH2D_CLI_FILM_STRIP_H
#define SPH2D_CLI_FILM_STRIP_H

#include <pthread.h>

#include "film.h"
#include "frame_writer.h"
#include "input.h"

/** Initialise with {0}. */
typedef struct film_strip {
    const cli_options *options;
    film film;
    film_form form; /**< its size is 0 before the first frame */
    double pace;    /**< of the film over that of the scene; 0: unknown */
    size_t count;
    pthread_mutex_t lock; /**< for what follows */
    pthread_cond_t changed;
    size_t next; /**< the frame whose turn it is */
    bool given_up;
} film_strip;

/** Finds the pace of a film of these snapshots, whose times it reads, and checks that the film's name is free. End it with
 *  film_strip_end() when it succeeds. Returns an exit code; otherwise prints an error. */
int film_strip_begin(film_strip *strip, const cli_options *options, const snapshot_list *inputs);

/** Gives frames the size of the film, which is that of the first one. */
void film_strip_fit(film_strip *strip, sph2d_frames *frames);

/** Opens the film, of a size that is known. Errors: as film_open. */
sph2d_status film_strip_open(film_strip *strip, sph2d_report *report);

/** Adds a frame when those before it are in the film; it waits for them. Does nothing once the film is given up. Errors:
 *  as film_add. */
sph2d_status film_strip_add(film_strip *strip, size_t index, const unsigned char *pixels, sph2d_report *report);

/** Nobody waits any more; NULL is fine. */
void film_strip_give_up(film_strip *strip);

/** Gives the film its name. Errors: as film_close. */
sph2d_status film_strip_close(film_strip *strip, sph2d_report *report);

/** Prints what the film is. */
void film_strip_tell(const film_strip *strip, const frame_times *times);

/** Frees everything; a film that was not closed leaves no file. NULL is fine. */
void film_strip_end(film_strip *strip);

#endif
