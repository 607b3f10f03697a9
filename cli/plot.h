/* SPDX-License-Identifier: MIT */
/** @file plot.h
 *  The series of a run's probes, and the picture of them. */
#ifndef SPH2D_CLI_PLOT_H
#define SPH2D_CLI_PLOT_H

#include <stdbool.h>
#include <stddef.h>

#include <sph2d/io.h>

#include "folder.h"

/** A column of a series. */
typedef struct plot_column {
    char *label;      /**< "vx [m/s]" */
    char *name;       /**< "vx" */
    const char *unit; /**< "[m/s]", in `label`; "" for none */
    int panel;        /**< of the series, from 0: columns of one unit share one; -1: it has no number to be drawn */
} plot_column;

/** What a probe has written. */
typedef struct plot_series {
    char *name; /**< of the probe */
    plot_column *columns;
    size_t column_count;
    sph2d_table *table; /**< the time, then the columns */
    int panels;
} plot_series;

typedef struct plot_data {
    plot_series *series; /**< by name, or in the order asked for */
    size_t count;
    size_t panels;
} plot_data;

/** Reads the series of a folder: those of `names`, or all. Returns an exit code, after an error that is printed. */
int plot_read(plot_data *data, cli_folder *folder, char *const *names, size_t name_count);
void plot_free(plot_data *data);

/** Draws them by gnuplot, as PNG or SVG, into a file that is there whole or not at all. Returns an exit code. */
int plot_draw(const plot_data *data, bool png, const char *path);

#endif
