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

/** On which side of an outline liquid is, for a walk from its first corner to the last: the values of the field
 *  LiquidSides. Outlines of closed walls that are no solids end with their first corner. */
typedef enum sph2d_outline_liquid {
    /** On both: a line without thickness. */
    SPH2D_OUTLINE_LIQUID_BOTH = 0,

    /** On the left; the wall is on the right. */
    SPH2D_OUTLINE_LIQUID_LEFT = 1,

    /** Outside of a closed outline, whose last corner is joined to the first: a solid or body. */
    SPH2D_OUTLINE_LIQUID_OUTSIDE = 2
} sph2d_outline_liquid;

/** The number of fields in a group: of SPH2D_GROUP_FLUID, SPH2D_GROUP_WALL and SPH2D_GROUP_OUTLINE; the same for every
 *  simulation. */
SPH2D_API size_t sph2d_field_count(sph2d_group group);

/** Field `index` of a group with the data of `sim`, valid until its next change; with `sim` NULL only the description,
 *  count 0 and data NULL. `index` must be below sph2d_field_count(group), else an array without name is returned. */
SPH2D_API sph2d_array sph2d_field(const sph2d_sim *sim, sph2d_group group, size_t index);

/** The colour of each particle of liquid, 65536 red + 256 green + blue, in the order of the fields, valid until the next
 *  change; NULL for NULL, and where the scene gives no colour (sph2d_fluid), so that all have one. */
SPH2D_API const uint64_t *sph2d_sim_colors(const sph2d_sim *sim);

/** The vorticity dv_y/dx - dv_x/dy at each of `count` particles of liquid [1/s]: that of the linear functions that fit the
 *  velocities of the particles within three spacings best, by weighted least squares, so that it is exact for linear
 *  velocities, also at surfaces and walls. NaN where this does not exist: at a particle that has no others around it or
 *  only some on a line, or whose position or velocity is not finite, which others leave out.
 *
 *  `x`, `y` [m], `vx`, `vy` [m/s] and `out` have `count` items each, `spacing` is that of the particles [m], > 0. Errors:
 *  SPH2D_INVALID, SPH2D_NOMEM. */
SPH2D_API sph2d_status sph2d_vorticity(size_t count, const double *x, const double *y, const double *vx,
                                       const double *vy, double spacing, double *out, sph2d_report *report);

#ifdef __cplusplus
}
#endif
#endif
