/* SPDX-License-Identifier: MIT */
/** @file study_cells.h
 *  The columns and cells of a study's table, for the terminal and for the page. */
#ifndef SPH2D_CLI_STUDY_CELLS_H
#define SPH2D_CLI_STUDY_CELLS_H

#include "study.h"

enum { STUDY_CELL_SIZE = 256 };

typedef enum study_column_kind {
    STUDY_COLUMN_NAME,
    STUDY_COLUMN_END,
    STUDY_COLUMN_FRONT,
    STUDY_COLUMN_CPU,
    STUDY_COLUMN_WALL,
    STUDY_COLUMN_PARTICLES,
    STUDY_COLUMN_STEPS,
    STUDY_COLUMN_START,
    STUDY_COLUMN_PROBES,
    STUDY_COLUMN_RATE,
    STUDY_COLUMN_VALUE, /**< from here on of a measure */
    STUDY_COLUMN_ERROR,
    STUDY_COLUMN_ORDER
} study_column_kind;

typedef struct study_column {
    study_column_kind kind;
    size_t measure;
} study_column;

/** Which columns a measure has. */
bool study_has_value(const sph2d_study_measure *measure);
bool study_has_error(const sph2d_study_measure *measure);

/** A word for how a row ended. */
const char *study_end_name(study_end end);

/** Particle-steps a second of stepping: of wall time where that is known, else of CPU time; NaN without a step. */
double study_rate(const study_row *row);

/** No table has more columns than this. */
static inline size_t study_cells_most(const cli_study *s)
{
    return STUDY_COLUMN_VALUE + 3 * s->study->measure_count;
}

/** The columns that say something, errors and CPU time before the rest; `out` has room for study_cells_most(). Returns
 *  how many there are. */
size_t study_cells_list(const cli_study *s, study_column *out);

/** The heading of a column, and what it says of a row that is there. */
void study_cells_heading(const cli_study *s, const study_column *c, char out[STUDY_CELL_SIZE]);
void study_cells_text(const study_row *row, const study_column *c, char out[STUDY_CELL_SIZE]);

/** Words stand left, numbers right. */
bool study_cells_left(const study_column *c);

/** Seconds as the table has them. */
void study_cells_seconds(char out[STUDY_CELL_SIZE], double seconds);

#endif
