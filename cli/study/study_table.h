/* SPDX-License-Identifier: MIT */
/** @file study_table.h
 *  The rows of a study on stdout: error beside speed. */
#ifndef SPH2D_CLI_STUDY_TABLE_H
#define SPH2D_CLI_STUDY_TABLE_H

#include "study.h"

/** Which columns a measure has. */
bool study_has_value(const sph2d_study_measure *measure);
bool study_has_error(const sph2d_study_measure *measure);

/** A word for how a row ended. */
const char *study_end_name(study_end end);

/** Particle-steps a second of stepping; NaN without a step. */
double study_rate(const study_row *row);

/** Prints the rows as a table, whose bars make it Markdown too. */
void study_table_print(const cli_study *s);

/** Prints the rows as one JSON object. `end` is a word for how the study ended, `passed` whether nothing failed. */
void study_json_print(const cli_study *s, const char *end, bool passed);

#endif
