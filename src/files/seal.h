/* SPDX-License-Identifier: MIT */
/** @file seal.h
 *  A checksum behind the end of a file: XXH64 (Collet) with seed 0, lowest byte first, of all bytes before the eight
 *  letters in front of it, so that other programs can compare, too.
 *
 *  HDF5 ignores what comes behind its data, cuts it off when it changes a file, and is not made for damaged files. So
 *  the seal tells damage before HDF5 sees it, and a file that somebody changed on purpose has none and is taken as it
 *  is. */
#ifndef SPH2D_FILES_SEAL_H
#define SPH2D_FILES_SEAL_H

#include <stdbool.h>

/** Appends a seal to a file. False with errno when it cannot be read or written. */
bool sph2d__seal_put(int fd);

typedef enum sph2d__seal {
    SPH2D__SEAL_NONE,
    SPH2D__SEAL_WHOLE,
    SPH2D__SEAL_BROKEN,
    SPH2D__SEAL_UNREADABLE
} sph2d__seal;

/** Looks for the seal of a file and compares; with errno where the file cannot be read. */
sph2d__seal sph2d__seal_check(int fd);

#endif
