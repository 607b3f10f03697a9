/* SPDX-License-Identifier: MIT */
/** @file trailer.h
 *  A checksum trailer at the end of a file: eight letters, then XXH64 (Collet) with seed 0, little-endian, of all bytes
 *  before the letters, so that other programs can verify it, too.
 *
 *  HDF5 ignores bytes after its data, truncates them when it changes a file, and is not robust against damaged files.
 *  The trailer detects damage before HDF5 reads the file; a file without one was cut short or changed. */
#ifndef SPH2D_FILES_TRAILER_H
#define SPH2D_FILES_TRAILER_H

#include <stdbool.h>

/** Appends a trailer to a file. False with errno if it cannot be read or written. */
bool sph2d__trailer_append(int fd);

typedef enum sph2d__trailer {
    SPH2D__TRAILER_NONE,
    SPH2D__TRAILER_VALID,
    SPH2D__TRAILER_INVALID,
    SPH2D__TRAILER_UNREADABLE
} sph2d__trailer;

/** Verifies the trailer of a file; sets errno if the file cannot be read. */
sph2d__trailer sph2d__trailer_check(int fd);

#endif
