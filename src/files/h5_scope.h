/* SPDX-License-Identifier: MIT */
/** @file h5_scope.h
 *  HDF5 kept quiet: its own error printing is off while we are in this library, and its error stack becomes a sentence.
 */
#ifndef SPH2D_FILES_H5_SCOPE_H
#define SPH2D_FILES_H5_SCOPE_H

#include <hdf5.h>

/** What the program had set before. */
typedef struct sph2d__h5_scope {
    H5E_auto2_t print;
    void *data;
} sph2d__h5_scope;

void sph2d__h5_scope_begin(sph2d__h5_scope *scope);
void sph2d__h5_scope_end(const sph2d__h5_scope *scope);

/** The cause of the failure of the HDF5 call just made, in HDF5's words. */
void sph2d__h5_cause(char *out, size_t size);

#endif
