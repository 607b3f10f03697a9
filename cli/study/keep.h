/* SPDX-License-Identifier: MIT */
/** @file keep.h
 *  Rows that were run are kept in DIR/rows, so that an interrupted study goes on. A row is found again only when
 *  everything that it depends on is the same: source, compiler and flags of the program, the processor, threads and
 *  instruction set, and its scene with all values. Without -o nothing is kept and nothing found. */
#ifndef SPH2D_CLI_STUDY_KEEP_H
#define SPH2D_CLI_STUDY_KEEP_H

#include "state.h"

/** Takes the folder: a new one, or one that an earlier session of the study left. Tells what is wrong and returns an
 *  exit code. */
int study_open_folder(cli_study *s);

/** Looks for a row that was kept, unless all are to run anew, and fills its record. Tells what is wrong with its scene
 *  and returns an exit code. */
int study_find(cli_study *s, sph2d_study_row *row);

/** Keeps a row. Tells what goes wrong and returns an exit code. */
int study_keep(cli_study *s, const sph2d_study_row *row);

#endif
