/* SPDX-License-Identifier: MIT */
/** @file fields.h
 *  The table of all particle data: public fields (sph2d/field.h), and values that time schemes carry from step to step.
 *  A row gives the location of the data and whether it is part of the state; snapshots and state.c use it. */
#ifndef SPH2D_RUN_FIELDS_H
#define SPH2D_RUN_FIELDS_H

#include "sim/simulation.h"
#include "sph2d/field.h"

/** An array of a simulation in its public, read-only form, and its writable data. */
typedef struct sph2d__lent {
    sph2d_array array;
    void *data[2]; /**< array.data, writable */
} sph2d__lent;

/** Maximum number of arrays from sph2d__fields_of_state. */
enum { SPH2D__FIELDS_OF_STATE = 24 };

/** Lists the arrays of fluid and walls that are part of the state: those that do not follow from the scene. Returns
 *  their number. */
size_t sph2d__fields_of_state(sph2d_sim *sim, sph2d__lent out[SPH2D__FIELDS_OF_STATE]);

#endif
