/* SPDX-License-Identifier: MIT */
/** @file outputs.h
 *  What a study prints, and what it writes into its folder. */
#ifndef SPH2D_CLI_STUDY_OUTPUTS_H
#define SPH2D_CLI_STUDY_OUTPUTS_H

#include "state.h"

/** Prints the rows as a table, whose bars make it Markdown too, and the verdict. */
void study_table_print(const cli_study *s);

/** Prints the rows as one JSON object. `end` is a word for how the study ended, `passed` whether nothing failed. */
void study_json_print(const cli_study *s, const char *end, bool passed);

/** The line that a study is run for: which row is the cheapest for the wanted error, or the one with the smallest error;
 *  "" when no row has one. What the times were taken with: threads, instruction set, repeats; "" without a row. Both
 *  return `out`, cut at `size`. */
char *study_verdict(const cli_study *s, char *out, size_t size);
char *study_conditions(const cli_study *s, char *out, size_t size);

/* The rest writes into the folder, tells what goes wrong and returns an exit code. */

/** study.csv, and a file for each series of each row. */
int study_csv_write(cli_study *s);

/** plots.gp, plots.dat and where gnuplot is installed error_time and error_along as .svg and .png; nothing when no row
 *  has an error. That gnuplot is missing is no failure. */
int study_plot(cli_study *s);

/** study.html: what the first comments of scene and study say of them, the command, the verdict, the table, the plots
 *  and what the times were taken with. */
int study_page_write(cli_study *s);

#endif
