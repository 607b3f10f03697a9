/* SPDX-License-Identifier: MIT */
/** @file open.h
 *  The study to be done: what a study file says, or one that is made for a scene. */
#ifndef SPH2D_CLI_STUDY_OPEN_H
#define SPH2D_CLI_STUDY_OPEN_H

#include "state.h"

/** Reads s->path into s->file and s->study. Where it is a scene, the study is made for it. Tells what is wrong and
 *  returns an exit code. */
int study_open(cli_study *s);

/** Writes into the folder what the study leaves for people to go on with: study.yaml where it was made here, and
 *  cheapest.yaml, the scene of the row that is the cheapest for the wanted error, when there is one. Tells what goes
 *  wrong and returns an exit code. */
int study_open_write(cli_study *s);

#endif
