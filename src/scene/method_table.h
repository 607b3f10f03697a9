/* SPDX-License-Identifier: MIT */
/** @file method_table.h
 *  A row of the table of methods with what the library alone wants to know of it. */
#ifndef SPH2D_SCENE_METHOD_TABLE_H
#define SPH2D_SCENE_METHOD_TABLE_H

#include "sph2d/method.h"

typedef struct sph2d__method_row {
    sph2d_method_info info;

    /* defaults besides those in info */
    double (*support_of_kernel)(sph2d_kernel kernel); /**< H/dx, where it is not one for all kernels; else NULL */
    double cfl;                                       /**< dt <= cfl H / (c0 + v_max) ... */
    bool cfl_by_spacing;                              /**< ... or cfl dx, whatever H is */
    double artificial_viscosity;
    sph2d_wall_form side_form, obstacle_form; /**< of walls whose form is `default` */

    bool sound;               /**< sound of speed c0 carries pressure, and limits the step */
    bool summed_density;      /**< a sum over places, so that liquid may start compressed; else integrated */
    bool free_compression;    /**< pressure ends where max_compression is kept, and stores no energy below it */
    double sound_compression; /**< of max_compression, what the speed of sound is derived from */
    double (*stiffness_part)(double support, double spacing); /**< c0^2 over method.stiffness; NULL: 1 */

    double min_density,
        max_density;       /**< densities that no sound run has, over the rest density: a guard stops others */
    double energy_rise;    /**< run.max_energy_rise by default */
    const char *calmed_by; /**< what takes energy out of the liquid, in hints */
    const char *ended_by;  /**< a key that helps the pressure solver to an end, in hints; NULL without one */
} sph2d__method_row;

/** The row of a scene's method; the first one for a number that is none, which the checker refuses. */
const sph2d__method_row *sph2d__method_row_of(const sph2d_method_options *options);

#endif
