/* SPDX-License-Identifier: MIT */
/** @file overrides.h
 *  Overrides of single keys of a scene file. */
#ifndef SPH2D_FILES_OVERRIDES_H
#define SPH2D_FILES_OVERRIDES_H

#include "files/tree.h"
#include "sph2d/io.h"

/** Whether a list of overrides has all its pointers. */
bool sph2d__overrides_given(const sph2d_override *overrides, size_t count);

/** Parses the value of each override and puts it into the tree under `root`, replacing any old value. Missing mappings
 *  of its path are created, missing list items are errors, which are counted in `faults`. Errors: SPH2D_NOMEM. */
sph2d_status sph2d__overrides_apply(const sph2d_override *overrides, size_t count, sph2d__node *root,
                                    sph2d__faults *faults);

#endif
