/* SPDX-License-Identifier: MIT */
/** @file pool.h
 *  Rows run in processes of their own, one or several at a time: one that crashes or eats all memory is a row that says
 *  so, and the others go on. */
#ifndef SPH2D_CLI_STUDY_POOL_H
#define SPH2D_CLI_STUDY_POOL_H

#include "state.h"

/** Runs the wanted rows from number `first` (counted from 0) on that are not there, those kept by an earlier session
 *  apart, and fills their records. Returns the first exit code that is none of success. Sets s->stopped after a signal.
 */
int study_pool_run(cli_study *s, size_t first);

#endif
