/* SPDX-License-Identifier: MIT */
/** @file film.h
 *  A film of frames, by ffmpeg: a process of its own, which takes pixels from a pipe and writes a temporary file. That gets
 *  the film's name when it is whole. */
#ifndef SPH2D_CLI_FILM_H
#define SPH2D_CLI_FILM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <sys/types.h>

#include <sph2d/status.h>

typedef struct film {
    const char *path; /**< borrowed; NULL: not open */
    char *unfinished; /**< the temporary file */
    FILE *said;       /**< what ffmpeg says, a file without a name */
    int pixels;       /**< the pipe, -1 when it is closed */
    pid_t pid;
    size_t frame_bytes;
} film;

/** What a film must be. */
typedef struct film_form {
    unsigned width, height; /**< [pixels] */
    double rate;            /**< frames that come, for each second of the film; more than it can show are left out */
    int threads;            /**< of the encoder; 0: its own choice */
} film_form;

/** Whether a film can have this name, by its end: .mp4, .gif, .png or .apng. */
bool film_can_be(const char *path);

/** Whether films with this name are animated images, which are for pages and not to be large. */
bool film_is_image(const char *path);

/** The largest rate that a film with this name shows [1/s]. */
double film_rate_max(const char *path);

/** Starts ffmpeg. Errors: SPH2D_RENDER when it is not installed, SPH2D_CANTCREAT, SPH2D_IO, SPH2D_NOMEM. */
sph2d_status film_open(film *f, const char *path, const film_form *form, sph2d_report *report);

/** Adds a frame, 4 bytes per pixel, top row first. Errors: SPH2D_IO, with the last line of what ffmpeg said. */
sph2d_status film_add(film *f, const unsigned char *pixels, sph2d_report *report);

/** Ends the film: waits for ffmpeg, syncs the file, and renames it. Errors: as film_add. */
sph2d_status film_close(film *f, sph2d_report *report);

/** Ends ffmpeg and removes the temporary file; nothing for a film that is not open. */
void film_abort(film *f);

#endif
