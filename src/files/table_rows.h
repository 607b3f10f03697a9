/* SPDX-License-Identifier: MIT */
/** @file table_rows.h
 *  Rows over time from a table: of a motion, gravity, or what an opening prescribes. */
#ifndef SPH2D_FILES_TABLE_ROWS_H
#define SPH2D_FILES_TABLE_ROWS_H

#include "files/pool.h"
#include "sph2d/io.h"

/** Reports an error of a row of a table, or of the whole, row 0. Returns SPH2D_FORMAT. */
sph2d_status sph2d__table_fault(const sph2d_table *table, size_t row, const char *message, sph2d_report *report);

/** Copies columns, time first, of all rows of a table into the pool; of one that is not there its number in `otherwise`.
 *  Errors: SPH2D_FORMAT where there is no row, a number is missing, or times do not increase; SPH2D_NOMEM. */
sph2d_status sph2d__table_rows(const sph2d_table *table, const sph2d_table_column *columns, const size_t *which,
                               size_t width, const double *otherwise, sph2d__pool *pool, double **rows,
                               sph2d_report *report);

#endif
