/* SPDX-License-Identifier: MIT */
/** @file study_csv.h
 *  What a study writes with -o: its rows, and the series behind them. Files appear whole or not at all. */
#ifndef SPH2D_CLI_STUDY_CSV_H
#define SPH2D_CLI_STUDY_CSV_H

#include "study_run.h"

/** Writes study.csv with the rows that there are, every digit of them, and series_ROW_PROBE.csv, as `run` would write
 *  PROBE.csv, for each probe of each row. Does nothing without -o. Tells what goes wrong and returns an exit code. */
int study_csv_write(cli_study *s);

#endif
