/* SPDX-License-Identifier: MIT */
/** @file study_table.h
 *  The rows of a study on stdout: error beside speed. */
#ifndef SPH2D_CLI_STUDY_TABLE_H
#define SPH2D_CLI_STUDY_TABLE_H

#include "study.h"

/** What the times were taken with: threads, instruction set, repeats; "" without a row. Returns `out`, cut at `size`.
 */
char *study_conditions(const cli_study *s, char *out, size_t size);

/** Prints the rows as a table, whose bars make it Markdown too, and the verdict. */
void study_table_print(const cli_study *s);

/** Prints the rows as one JSON object. `end` is a word for how the study ended, `passed` whether nothing failed. */
void study_json_print(const cli_study *s, const char *end, bool passed);

#endif
