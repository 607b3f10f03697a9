/* SPDX-License-Identifier: MIT */
/** @file export.h
 *  The forms that a snapshot is exported in. Files appear whole or not at all. */
#ifndef SPH2D_CLI_EXPORT_H
#define SPH2D_CLI_EXPORT_H

#include <stdio.h>

#include <sph2d/io.h>

#include "options.h"

/** The rows of the particles of a group in the order of their numbers, since the order in memory changes from snapshot to
 *  snapshot; to be freed. NULL when memory is short. */
size_t *export_order(const sph2d_snapshot *snapshot, sph2d_group group, size_t *count);

/** The liquid as CSV into a file; with `path` NULL to stdout. Sets the number of rows. */
sph2d_status export_csv(const sph2d_snapshot *snapshot, const char *path, size_t *rows, sph2d_report *report);

/** Liquid, boundary particles and outlines as poly data for VTK, a file of XML. Sets the number of points. */
sph2d_status export_vtp(const sph2d_snapshot *snapshot, const char *path, size_t *points, sph2d_report *report);

/** The snapshots that the operands stand for as poly data, NAME_000000.vtp and so on, and NAME.pvd with their times. Returns
 *  an exit code; prints errors. */
int export_series(const cli_options *options);

/** Prints a text as the value of an attribute of XML. */
void export_xml_text(const char *text, FILE *out);

#endif
