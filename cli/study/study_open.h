/* SPDX-License-Identifier: MIT */
/** @file study_open.h
 *  The study to be done: what a study file says, or one that is made for a scene. */
#ifndef SPH2D_CLI_STUDY_OPEN_H
#define SPH2D_CLI_STUDY_OPEN_H

#include "study.h"

/** Reads s->path into s->file and s->study. Where it is a scene, the study asks what its spacing and its stiffness cost
 *  and bring: three spacings with two sound speeds each, then the best of the finest at a smaller spacing, which all
 *  are compared with. Tells what is wrong and returns an exit code. */
int study_open(cli_study *s);

/** Writes into the folder what the study leaves for people to go on with: study.yaml where it was made here, and
 *  cheapest.yaml, the scene of the row that is the cheapest for the wanted error, when there is one. Does nothing
 *  without -o. Tells what goes wrong and returns an exit code. */
int study_open_write(cli_study *s);

#endif
