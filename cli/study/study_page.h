/* SPDX-License-Identifier: MIT */
/** @file study_page.h
 *  The study as one page for a browser. */
#ifndef SPH2D_CLI_STUDY_PAGE_H
#define SPH2D_CLI_STUDY_PAGE_H

#include "study.h"

/** Writes study.html: what the scene's first comment says of it, the command, the verdict, the table, the plots and
 *  what the times were taken with. Does nothing without -o. Tells what goes wrong and returns an exit code. */
int study_page_write(cli_study *s);

#endif
