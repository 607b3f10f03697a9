/* SPDX-License-Identifier: MIT */
/** @file method_table.h
 *  The table of methods: a row with the public information and what the library alone uses. */
#ifndef SPH2D_SCENE_METHOD_TABLE_H
#define SPH2D_SCENE_METHOD_TABLE_H

#include "scene/apart.h"
#include "sph2d/method.h"

/** Side of a square of the grid of method hybrid [spacings]: with 3 the 99th percentile of the density is 2.8 % too high
 *  instead of 1.7, at the same cost; fewer than 1.5 leave holes in squares. */
static const double SPH2D__SQUARE = 1.9;

typedef struct sph2d__method_row {
    sph2d_method_info info;

    /* defaults besides those in info */
    double (*support_of_kernel)(sph2d_kernel kernel); /**< H/dx, where it depends on the kernel; else NULL */
    double cfl;                                       /**< dt <= cfl H / (c0 + v_max) ... */
    double most_cfl;                                  /**< beyond which steps are unstable; 0: the key's own bound */
    bool cfl_by_spacing;                              /**< ... or cfl dx */
    double artificial_viscosity;
    sph2d_wall_form side_form, obstacle_form; /**< of walls whose form is `default` */

    bool has_sound;           /**< pressure propagates with c0, which limits the step */
    bool summed_density;      /**< density by summation, so that liquid may start compressed; else integrated */
    bool free_compression;    /**< compression below max_compression has no pressure, and stores no energy */
    bool keeps_volume;        /**< pressure stores no energy, so that liquid starts at rest density */
    double sound_compression; /**< factor on max_compression in the derivation of c0 */
    double (*stiffness_part)(double support, double spacing); /**< c0^2 over method.stiffness; NULL: 1 */

    double min_density, max_density; /**< bounds of the density guard, over the rest density */
    double energy_rise;              /**< default of run.max_energy_rise */
    const char *damping_hint;        /**< a means to dissipate energy, for hints */
    const char
        *convergence_hint; /**< a key that helps the pressure solver to converge, for hints; NULL without a solver */
} sph2d__method_row;

/** The row of a scene's method; the first one for an invalid method, which the checker reports. */
const sph2d__method_row *sph2d__method_row_of(const sph2d_method_options *options);

#endif
