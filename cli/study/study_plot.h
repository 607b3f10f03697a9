/* SPDX-License-Identifier: MIT */
/** @file study_plot.h
 *  Error against time with the front, and error against the spacing, or another key, with the orders; by gnuplot. */
#ifndef SPH2D_CLI_STUDY_PLOT_H
#define SPH2D_CLI_STUDY_PLOT_H

#include "study.h"

/** Writes plots.gp, and where gnuplot is installed error_time and error_along as .svg and .png. Does nothing without
 *  -o, and when no row has an error. Tells what goes wrong and returns an exit code; that gnuplot is missing is no
 *  failure. */
int study_plot(cli_study *s);

#endif
