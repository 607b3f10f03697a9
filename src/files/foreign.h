/* SPDX-License-Identifier: MIT */
/** @file foreign.h
 *  What other programs call the keys of a scene. */
#ifndef SPH2D_FILES_FOREIGN_H
#define SPH2D_FILES_FOREIGN_H

#include "sph2d/key.h"

/** A key of scenes, and its names elsewhere, in lower case without _ and -, with commas between. */
typedef struct sph2d__foreign {
    const char *path; /**< "run.until"; items of lists by 0 */
    const char *names;
} sph2d__foreign;

/** Row `i` of the table; NULL beyond its end. */
const sph2d__foreign *sph2d__foreign_row(size_t i);

/** The key at a path of a scene; NULL if there is none. */
const sph2d_key *sph2d__foreign_key(const char *path);

/** The path of the key that is called `name` elsewhere, from `here` if it is one of these keys, else from the top of the
 *  scene; and the key. NULL for other names. */
const char *sph2d__foreign_path(const char *name, const sph2d_keys *here, const sph2d_key **key);

#endif
