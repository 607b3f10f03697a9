/* SPDX-License-Identifier: MIT */
/** @file parts.h
 *  The parts of a study that belong to the command. Functions that return an int report errors and return an exit code.
 */
#ifndef SPH2D_CLI_STUDY_PARTS_H
#define SPH2D_CLI_STUDY_PARTS_H

#include <sys/types.h>

#include "state.h"

/* ---- the study to be done (open.c) ------------------------------------------------------------------------------- */

/** Reads s->path into s->file and s->study. For a scene a study is generated. */
int study_open(cli_study *s);

/** Writes study.yaml, if it was generated, and cheapest.yaml, the scene of the cheapest row for the target error, if
 *  there is one. */
int study_open_write(cli_study *s);

/* ---- rows in worker processes (pool.c, worker.c) ----------------------------------------------------------------- */

/** Runs the wanted rows from number `first` (counted from 0) on that have no record, except those stored by an earlier
 *  session, and fills their records. A row that crashes or runs out of memory is reported as such, and the others
 *  continue. Returns the first exit code other than success. Sets s->stopped after a signal. */
int study_pool_run(cli_study *s, size_t first);

/** Runs a row until it ends, a signal comes or the process `parent` is gone, and sends the record to `out`. Never
 *  returns. */
_Noreturn void study_work(cli_study *s, sph2d_study_row *row, pid_t parent, int out);

/** Receives a record, waiting for all of it. False when it is incomplete, or memory is short. */
bool study_receive(int in, sph2d_study_record *record);

/* ---- a part of the rows, beside other processes with the other parts (shard.c) ----------------------------------- */

/** Whether a row is to be run here: by a shard every Nth, else all. */
bool study_owns(const cli_study *s, const sph2d_study_row *row);

/** Of a shard: looks for the rows of the others from number `first` (counted from 0) on, and sets s->missing. */
int study_gather(cli_study *s, size_t first);

/** Says which rows are missing, and of which shards; with --json as one JSON object, as the end of the study. */
void study_missing_tell(const cli_study *s);
void study_missing_json(const cli_study *s, const char *end, bool passed);

/* ---- rows stored in DIR/rows (keep.c) ---------------------------------------------------------------------------- */

/** Opens the folder: a new one, or that of an earlier session of the study. */
int study_open_folder(cli_study *s);

/** Looks for a stored row, unless it is to run again, and fills its record. It is found only if everything that it
 *  depends on is the same: source, compiler and flags of the program, the processor, threads and instruction set, and
 *  its scene with all values; if a shard ran it, with any processor and threads, which change its times alone. Without
 *  -o nothing is stored or found. */
int study_find(cli_study *s, sph2d_study_row *row);

/** Stores a row. Of a shard: if another process did meanwhile, the record becomes that one, which others may have
 *  read. */
int study_keep(cli_study *s, sph2d_study_row *row);

/* ---- output (table.c, json.c, csv.c, plot.c, page.c, outputs.c) -------------------------------------------------- */

/** Prints the rows as a table, whose bars make it Markdown too, and the verdict. */
void study_table_print(const cli_study *s);

/** Prints the rows as one JSON object. `end` is a word for the end of the study, `passed` whether nothing failed. */
void study_json_print(const cli_study *s, const char *end, bool passed);

/** The final line: the cheapest row for the target error, or the one with the smallest error; "" when no row has one.
 *  The conditions of the times: threads, instruction set, repeats; "" without a row. Both return `out`, cut at `size`.
 */
char *study_verdict(const cli_study *s, char *out, size_t size);
char *study_conditions(const cli_study *s, char *out, size_t size);

/** study.csv, and a file for each series of each row. */
int study_csv_write(cli_study *s);

/** plots.gp, plots.dat and, if gnuplot is installed, error_time and error_along as .svg and .png; nothing when no row
 *  has an error. A missing gnuplot is not an error. */
int study_plot(cli_study *s);

/** study.html: the first comments of scene and study, the command, the verdict, the table, the plots and the conditions
 *  of the times. */
int study_page_write(cli_study *s);

/** The files page.html and plots.gp beside this one, which are a part of the program. */
extern const char study_page_html[], study_plots_gp[];

/** All files of the results, and removes those of earlier ones that these do not have. Several processes may do so at
 *  the same time with the same rows. */
int study_outputs_write(cli_study *s);

#endif
