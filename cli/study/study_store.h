/* SPDX-License-Identifier: MIT */
/** @file study_store.h
 *  Rows that were run are kept in DIR/rows, so that an interrupted study goes on. A row is found again only when
 *  everything that it depends on is the same: source, compiler and flags of the program, the processor, threads and
 *  instruction set, and its scene with all values. */
#ifndef SPH2D_CLI_STUDY_STORE_H
#define SPH2D_CLI_STUDY_STORE_H

#include "study.h"

/** The text that a row is known by; NULL when its scene cannot be read or memory is short. The caller frees it. */
char *study_store_key(cli_study *s, const sph2d_study_run *run);

/** Finds the row of a key; what is damaged or lacks a measure counts as not there. The record must be empty, and stays
 *  so otherwise. */
bool study_store_find(cli_study *s, const char *key, study_record *record);

/** Keeps a row. Does nothing without -o. Tells what goes wrong and returns an exit code. */
int study_store_keep(cli_study *s, const char *key, const study_record *record);

#endif
