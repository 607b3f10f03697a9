/* SPDX-License-Identifier: MIT */
/** @file parts.h
 *  The parts of a study that the command does itself. Those that return an int tell what goes wrong and return an exit
 *  code. */
#ifndef SPH2D_CLI_STUDY_PARTS_H
#define SPH2D_CLI_STUDY_PARTS_H

#include <sys/types.h>

#include "state.h"

/* ---- the study to be done (open.c) ------------------------------------------------------------------------------- */

/** Reads s->path into s->file and s->study. Where it is a scene, the study is made for it. */
int study_open(cli_study *s);

/** Writes what the study leaves for people to go on with: study.yaml where it was made here, and cheapest.yaml, the
 *  scene of the row that is the cheapest for the wanted error, when there is one. */
int study_open_write(cli_study *s);

/* ---- rows in processes of their own (pool.c, worker.c) ----------------------------------------------------------- */

/** Runs the wanted rows from number `first` (counted from 0) on that are not there, those kept by an earlier session
 *  apart, and fills their records. One that crashes or eats all memory is a row that says so, and the others go on.
 *  Returns the first exit code that is none of success. Sets s->stopped after a signal. */
int study_pool_run(cli_study *s, size_t first);

/** Runs a row until it ends, a signal comes or the process `parent` is gone, and sends the record to `out`. Never
 *  returns. */
_Noreturn void study_work(cli_study *s, sph2d_study_row *row, pid_t parent, int out);

/** Takes a record from the other end, waiting for all of it. False when it does not come whole, or memory is short. */
bool study_receive(int in, sph2d_study_record *record);

/* ---- rows that are kept in DIR/rows (keep.c) --------------------------------------------------------------------- */

/** Takes the folder: a new one, or one that an earlier session of the study left. */
int study_open_folder(cli_study *s);

/** Looks for a row that was kept, unless all are to run anew, and fills its record. It is found only when everything
 *  that it depends on is the same: source, compiler and flags of the program, the processor, threads and instruction
 *  set, and its scene with all values. Without -o nothing is kept and nothing found. */
int study_find(cli_study *s, sph2d_study_row *row);

int study_keep(cli_study *s, const sph2d_study_row *row);

/* ---- what is printed and written (table.c, json.c, csv.c, plot.c, page.c) ---------------------------------------- */

/** Prints the rows as a table, whose bars make it Markdown too, and the verdict. */
void study_table_print(const cli_study *s);

/** Prints the rows as one JSON object. `end` is a word for how the study ended, `passed` whether nothing failed. */
void study_json_print(const cli_study *s, const char *end, bool passed);

/** The line that a study is run for: which row is the cheapest for the wanted error, or the one with the smallest
 *  error; "" when no row has one. What the times were taken with: threads, instruction set, repeats; "" without a row.
 *  Both return `out`, cut at `size`. */
char *study_verdict(const cli_study *s, char *out, size_t size);
char *study_conditions(const cli_study *s, char *out, size_t size);

/** study.csv, and a file for each series of each row. */
int study_csv_write(cli_study *s);

/** plots.gp, plots.dat and where gnuplot is installed error_time and error_along as .svg and .png; nothing when no row
 *  has an error. That gnuplot is missing is no failure. */
int study_plot(cli_study *s);

/** study.html: what the first comments of scene and study say of them, the command, the verdict, the table, the plots
 *  and what the times were taken with. */
int study_page_write(cli_study *s);

#endif
