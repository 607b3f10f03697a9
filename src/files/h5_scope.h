/* SPDX-License-Identifier: MIT */
/** @file h5_scope.h
 *  Disables HDF5's error printing while in this library, and converts its error stack to a message. */
#ifndef SPH2D_FILES_H5_SCOPE_H
#define SPH2D_FILES_H5_SCOPE_H

#include <hdf5.h>
#include <stdbool.h>

/** The calling program's settings. */
typedef struct sph2d__h5_scope {
    H5E_auto2_t print;
    void *data;
} sph2d__h5_scope;

/** False, with nothing to end, when HDF5 cannot be started: memory is short. */
bool sph2d__h5_scope_begin(sph2d__h5_scope *scope);
void sph2d__h5_scope_end(const sph2d__h5_scope *scope);

/** HDF5's message about the failure of the last HDF5 call. */
void sph2d__h5_cause(char *out, size_t size);

#endif
