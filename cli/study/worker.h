/* SPDX-License-Identifier: MIT */
/** @file worker.h
 *  What happens in the process of a row, and how its record comes out of there. */
#ifndef SPH2D_CLI_STUDY_WORKER_H
#define SPH2D_CLI_STUDY_WORKER_H

#include <sys/types.h>

#include "state.h"

/** Runs a row until it ends, a signal comes or the process `parent` is gone, and sends the record to `out`. Never
 *  returns. */
_Noreturn void study_work(cli_study *s, sph2d_study_row *row, pid_t parent, int out);

/** Takes a record from the other end, waiting for all of it. False when it does not come whole, or memory is short. */
bool study_receive(int in, sph2d_study_record *record);

#endif
