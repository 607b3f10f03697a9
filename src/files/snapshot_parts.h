/* SPDX-License-Identifier: MIT */
/** @file snapshot_parts.h
 *  Writers of the parts of a snapshot. */
#ifndef SPH2D_FILES_SNAPSHOT_PARTS_H
#define SPH2D_FILES_SNAPSHOT_PARTS_H

#include "files/h5_write.h"
#include "files/layout.h"
#include "sph2d/io.h"

/** /Header, /Units, /Code: the metadata. */
void sph2d__snapshot_put_metadata(sph2d__h5_writer *w, const sph2d_sim *sim);

/** /Parameters: the values of a scene. */
void sph2d__snapshot_put_parameters(sph2d__h5_writer *w, const sph2d_scene *scene);

/** /PartType0, /PartType1, /State. */
void sph2d__snapshot_put_arrays(sph2d__h5_writer *w, const sph2d_sim *sim, const sph2d_state *state);

/** /VTKHDF, after the groups of particles and outlines. */
void sph2d__snapshot_put_vtk(sph2d__h5_writer *w, const sph2d_sim *sim);

/** The group of an array: "/PartType0", "/PartType1" or "/State". */
const char *sph2d__snapshot_group(sph2d_group group);

#endif
