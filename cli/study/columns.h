/* SPDX-License-Identifier: MIT */
/** @file columns.h
 *  The columns of a study: one table for study.csv, the JSON object, the printed table and the page. */
#ifndef SPH2D_CLI_STUDY_COLUMNS_H
#define SPH2D_CLI_STUDY_COLUMNS_H

#include "state.h"

enum { STUDY_CELL_SIZE = 256 };

/** Type and format of a column. */
typedef enum study_form {
    STUDY_NAME,  /**< const char * */
    STUDY_TEXT,  /**< char[] */
    STUDY_END,   /**< sph2d_study_end */
    STUDY_FLAG,  /**< bool */
    STUDY_COUNT, /**< uint64_t */
    STUDY_NUMBER /**< from here on double: any */,
    STUDY_SECONDS,
    STUDY_RATE,  /**< per second */
    STUDY_VALUE, /**< from here on of a measure */
    STUDY_ERROR,
    STUDY_ORDER
} study_form;

typedef struct study_column {
    study_form form;
    size_t offset;       /**< in the row, or in a value */
    const char *csv;     /**< heading in study.csv, for a measure after its name; NULL: not in the file */
    const char *json;    /**< key; NULL: not in the object, or among the measures */
    const char *heading; /**< in the table; NULL: not in it */
    int place;           /**< position in the table */
    size_t measure;
} study_column;

/** The columns that every row has, in the order of files; study_column_count of them. */
extern const study_column study_columns[];
extern const size_t study_column_count;

/** The columns of a measure, one to three. Returns how many. */
size_t study_columns_of(const cli_study *s, size_t measure, study_column out[3]);

/** The columns of the table that are not the same in every row, errors and CPU time before the rest. The caller frees
 *  *out, which is NULL when memory is short. Returns their number. */
size_t study_columns_shown(const cli_study *s, study_column **out);

/** The value of a row in a column: a pointer to the field, and as a number. */
const void *study_field(const sph2d_study_row *row, const study_column *c);
double study_number(const sph2d_study_row *row, const study_column *c);

/** The heading of a column in the table, and the cell of a row with a record. */
void study_heading(const cli_study *s, const study_column *c, char out[STUDY_CELL_SIZE]);
void study_cell(const sph2d_study_row *row, const study_column *c, char out[STUDY_CELL_SIZE]);

/** Whether a column is aligned left, as words are, or right, as numbers. */
bool study_aligns_left(const study_column *c);

/** A word for the end of a row. */
const char *study_end_name(sph2d_study_end end);

/** Seconds in the format of the table. */
void study_seconds(char out[STUDY_CELL_SIZE], double seconds);

#endif
