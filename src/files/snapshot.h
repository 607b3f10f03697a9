/* SPDX-License-Identifier: MIT */
/** @file snapshot.h
 *  A snapshot in memory, and functions of its reader. */
#ifndef SPH2D_FILES_SNAPSHOT_H
#define SPH2D_FILES_SNAPSHOT_H

#include "files/h5_read.h"
#include "files/layout.h"
#include "sph2d/io.h"

struct sph2d_snapshot {
    sph2d__pool pool;
    const char *scene_source; /**< name of the scene's text in messages */
    sph2d_snapshot_info info;
    sph2d_scene scene; /**< what is read of /Parameters: not all */
    sph2d_override *overrides;
    size_t override_count;
    uint64_t state_version;
    sph2d_array *arrays; /**< those of the state in order, then the other fields */
    size_t array_count;
};

/** Reads /Parameters, except lists, into a default scene. */
void sph2d__snapshot_get_parameters(sph2d__h5_reader *r, sph2d_scene *scene);

/** Adds what files gave, for a scene whose text names them: lists over time, and the largest speeds of blocks. Of the
 *  items of lists nothing else is read. */
void sph2d__snapshot_get_given(sph2d__h5_reader *r, sph2d_scene *scene);

/** Reads all arrays. */
void sph2d__snapshot_get_arrays(sph2d__h5_reader *r, sph2d_snapshot *snapshot);

#endif
