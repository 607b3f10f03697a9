/* SPDX-License-Identifier: MIT */
/** @file frame_field.h
 *  Fields of a simulation or snapshot, for pictures. */
#ifndef SPH2D_CLI_FRAME_FIELD_H
#define SPH2D_CLI_FRAME_FIELD_H

#include <sph2d/io.h>

/** The source of particles: a simulation or a snapshot. */
typedef struct particle_source {
    const sph2d_sim *sim;
    const sph2d_snapshot *snapshot;
} particle_source;

/** A field by name; its name is NULL if there is none. */
sph2d_array frame_field(const particle_source *source, sph2d_group group, const char *name);

/** A field of two contiguous doubles per particle; its name is NULL if it has another type or layout. */
sph2d_array frame_vectors(const particle_source *source, sph2d_group group, const char *name);

/** Writes the values of a quantity of `count` particles, and its name with the unit, "speed [m/s]". Errors: SPH2D_FORMAT
 *  if it is missing, SPH2D_NOMEM. */
sph2d_status frame_values(const particle_source *source, const char *name, size_t count, double *values, char *label,
                          size_t size, sph2d_report *report);

/** Reports a missing field, and returns SPH2D_FORMAT. */
sph2d_status frame_field_missing(sph2d_report *report, const char *name);

/** Whether there is a quantity of this name to colour by. */
bool frame_color_known(const char *name);

/** Whether its values are of either sign, for colours that show that. */
bool frame_diverging(const char *name);

/** All of them, "speed, vorticity, Densities, ...". Returns `out`. */
char *frame_colors(char *out, size_t size);

#endif
