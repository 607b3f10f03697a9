/* SPDX-License-Identifier: MIT */
/** @file snapshot.h
 *  A snapshot: its layout, with the names that writer and reader share, the functions of both, and what it is in memory.
 *
 *      /                 Format, FormatVersion; Complete, written last
 *      /Header           time, step, box, numbers of particles, also for tools that read SWIFT snapshots
 *      /Units, /Code     SI in terms of CGS; program, version, method, instruction set
 *      /Parameters       every resolved value of the scene by its key path, `fluid.density`
 *      /Scene            the scene file as it was written, and the overrides on top of it
 *      /PartType0, 1     fluid and boundary particles: one dataset a field
 *      /Outlines         corners of the outlines of walls and bodies
 *      /State            the rest of the state, and the list of the particle arrays that are part of it
 *      /VTKHDF           fluid, walls and outlines for ParaView, without copies
 *
 *  After the HDF5 data comes a checksum trailer (h5_file.h). */
#ifndef SPH2D_FILES_SNAPSHOT_H
#define SPH2D_FILES_SNAPSHOT_H

#include "files/h5_read.h"
#include "files/h5_write.h"
#include "sph2d/io.h"

#define SPH2D__FORMAT "sph2d snapshot"
/** Incremented when the layout changes incompatibly. */
#define SPH2D__FORMAT_VERSION 1u

#define SPH2D__AT_FORMAT "Format"
#define SPH2D__AT_FORMAT_VERSION "FormatVersion"
#define SPH2D__AT_COMPLETE "Complete"

#define SPH2D__GROUP_HEADER "/Header"
#define SPH2D__AT_TIME "Time"
#define SPH2D__AT_TIME_STEP "TimeStep"
#define SPH2D__AT_STEP "Step"
#define SPH2D__AT_SUPPORT "SupportRadius"
#define SPH2D__AT_SOUND_SPEED "SoundSpeed"

#define SPH2D__GROUP_CODE "/Code"
#define SPH2D__AT_CODE_VERSION "Code Version"
#define SPH2D__AT_ISA "InstructionSet"

#define SPH2D__GROUP_PARAMETERS "/Parameters"

#define SPH2D__GROUP_SCENE "/Scene"
#define SPH2D__SCENE_TEXT "Text"
#define SPH2D__SCENE_PATHS "OverridePaths"
#define SPH2D__SCENE_VALUES "OverrideValues"

#define SPH2D__GROUP_FLUID "/PartType0"
#define SPH2D__GROUP_WALLS "/PartType1"

#define SPH2D__GROUP_OUTLINES "/Outlines"

#define SPH2D__GROUP_STATE "/State"
#define SPH2D__AT_STATE_VERSION "StateVersion"
#define SPH2D__STATE_ARRAYS "Arrays"           /**< paths of all arrays of the state, in order ... */
#define SPH2D__STATE_UNITS "ArrayUnits"        /**< ... their exponents of metre, kilogram and second ... */
#define SPH2D__STATE_TEXTS "ArrayDescriptions" /**< ... and their descriptions */

/** Points have three components for ParaView; z is 0. */
enum { SPH2D__FILE_COMPONENTS = 3 };

/* ---- reading ----------------------------------------------------------------------------------------------------- */

struct sph2d_snapshot {
    sph2d__pool pool;
    const char *scene_source; /**< name of the scene's text in messages */
    sph2d_snapshot_info info;
    sph2d_scene scene; /**< what is read of /Parameters: not all */
    sph2d_override *overrides;
    size_t override_count;
    uint64_t state_version;
    sph2d_array *arrays; /**< those of the state in order, then the other fields */
    size_t array_count;
};

/** Reads /Parameters, except lists, into a default scene. */
void sph2d__snapshot_get_parameters(sph2d__h5_reader *r, sph2d_scene *scene);

/** Adds what files gave, for a scene whose text names them: lists over time, and the largest speeds of blocks. Of the
 *  items of lists nothing else is read. */
void sph2d__snapshot_get_given(sph2d__h5_reader *r, sph2d_scene *scene);

/* ---- writing ----------------------------------------------------------------------------------------------------- */

/** /Parameters: the values of a scene. */
void sph2d__snapshot_put_parameters(sph2d__h5_writer *w, const sph2d_scene *scene);

/** /PartType0, /PartType1, /State. */
void sph2d__snapshot_put_arrays(sph2d__h5_writer *w, const sph2d_sim *sim, const sph2d_state *state);

/** /VTKHDF, after the groups of particles and outlines. */
void sph2d__snapshot_put_vtk(sph2d__h5_writer *w, const sph2d_sim *sim);

/** The group of an array: "/PartType0", "/PartType1" or "/State". */
const char *sph2d__snapshot_group(sph2d_group group);

#endif
