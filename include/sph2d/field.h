/* SPDX-License-Identifier: MIT */
/** @file field.h
 *  The table of fields: the data of each particle, with name, type, unit and meaning. Snapshots, `sph2d info` and
 *  colours of images read it, so that a new field is one new row.
 *
 *      for (size_t k = 0; k < sph2d_field_count(SPH2D_GROUP_FLUID); ++k)
 *          puts(sph2d_field(NULL, SPH2D_GROUP_FLUID, k).description); */
#ifndef SPH2D_FIELD_H
#define SPH2D_FIELD_H

#include "sph2d/array.h"
#include "sph2d/sim.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number of fields in a group (SPH2D_GROUP_FLUID or SPH2D_GROUP_WALL); the same for every simulation. */
SPH2D_API size_t sph2d_field_count(sph2d_group group);

/** Field `index` of a group with the data of `sim`, valid until its next change; with `sim` NULL only the description,
 *  count 0 and data NULL. `index` must be below sph2d_field_count(group), else an array without name is returned. */
SPH2D_API sph2d_array sph2d_field(const sph2d_sim *sim, sph2d_group group, size_t index);

#ifdef __cplusplus
}
#endif
#endif
