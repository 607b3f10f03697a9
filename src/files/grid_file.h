/* SPDX-License-Identifier: MIT */
/** @file grid_file.h
 *  Velocity and pressure over a rectangular grid, from a CSV file. */
#ifndef SPH2D_FILES_GRID_FILE_H
#define SPH2D_FILES_GRID_FILE_H

#include "files/pool.h"
#include "sph2d/scene.h"

/** Reads a table with columns x, y and any of vx, vy, pressure into the pool; its rows may be in any order. Coordinates
 *  that differ by less than 1e-9 of the table's width, or height, are the same. Errors, each with file and line: those of
 *  sph2d_table_read(), SPH2D_FORMAT for rows that make no grid, SPH2D_NOMEM. */
sph2d_status sph2d__grid_read(sph2d_grid *grid, const char *path, sph2d__pool *pool, sph2d_report *report);

#endif
