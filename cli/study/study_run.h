/* SPDX-License-Identifier: MIT */
/** @file study_run.h
 *  Runs one row of a study. */
#ifndef SPH2D_CLI_STUDY_RUN_H
#define SPH2D_CLI_STUDY_RUN_H

#include "study.h"

/** Runs a row as often as the study asks for, and fills an empty record. What goes wrong is reported, and in the record.
 *  `alone` says that no other row runs beside it, so that it shows how far it is, and wall time means something. */
void study_run(cli_study *s, const sph2d_study_run *run, bool alone, study_record *record);

#endif
