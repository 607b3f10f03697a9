/* SPDX-License-Identifier: MIT */
/** @file fields.h
 *  The table of what is stored of every particle: public fields (sph2d/field.h), and what schemes remember from step to
 *  step. A row says where the data is, and whether a run needs it to go on; snapshots and state.c read it from there. */
#ifndef SPH2D_RUN_FIELDS_H
#define SPH2D_RUN_FIELDS_H

#include "sim/simulation.h"
#include "sph2d/field.h"

/** An array of a simulation as it is lent out, and where its values are for those who may write them. */
typedef struct sph2d__lent {
    sph2d_array array;
    void *data[2]; /**< those of array.data */
} sph2d__lent;

/** The most arrays that sph2d__fields_of_state gives. */
enum { SPH2D__FIELDS_OF_STATE = 18 };

/** Writes the arrays of fluid and walls that a run needs to go on, beyond what follows from the scene; returns how
 *  many. */
size_t sph2d__fields_of_state(sph2d_sim *sim, sph2d__lent out[SPH2D__FIELDS_OF_STATE]);

#endif
