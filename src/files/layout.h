/* SPDX-License-Identifier: MIT */
/** @file layout.h
 *  The layout of a snapshot: the names that writer and reader share.
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
 *  After the HDF5 data comes a checksum trailer (trailer.h). */
#ifndef SPH2D_FILES_LAYOUT_H
#define SPH2D_FILES_LAYOUT_H

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

#endif
