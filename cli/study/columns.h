/* SPDX-License-Identifier: MIT */
/** @file columns.h
 *  The columns of a study: one table that study.csv, the JSON object, the printed table and the page come from. */
#ifndef SPH2D_CLI_STUDY_COLUMNS_H
#define SPH2D_CLI_STUDY_COLUMNS_H

#include "state.h"

enum { STUDY_CELL_SIZE = 256 };

/** What a column holds, and how people read it. */
typedef enum study_form {
    STUDY_NAME,  /**< const char * */
    STUDY_TEXT,  /**< char[] */
    STUDY_END,   /**< sph2d_study_end */
    STUDY_FLAG,  /**< bool */
    STUDY_COUNT, /**< uint64_t */
    STUDY_NUMBER /**< from here on double: any */,
    STUDY_SECONDS,
    STUDY_RATE,  /**< things a second */
    STUDY_VALUE, /**< from here on in the values of a measure */
    STUDY_ERROR,
    STUDY_ORDER
} study_form;

typedef struct study_column {
    study_form form;
    size_t offset;       /**< in the row, or in a value */
    const char *csv;     /**< heading in study.csv, of a measure what follows its name; NULL: not there */
    const char *json;    /**< key; NULL: not there, or among the measures */
    const char *heading; /**< in the table; NULL: not there */
    int place;           /**< in the table */
    size_t measure;
} study_column;

/** The columns that every row has, in the order of files; study_column_count of them. */
extern const study_column study_columns[];
extern const size_t study_column_count;

/** The columns of a measure, one to three. Returns how many. */
size_t study_columns_of(const cli_study *s, size_t measure, study_column out[3]);

/** The columns of the table that say something, errors and CPU time before the rest. The caller frees *out, which is
 *  NULL when memory is short. Returns how many there are. */
size_t study_columns_shown(const cli_study *s, study_column **out);

/** What a row has in a column: the field, a number of it. */
const void *study_field(const sph2d_study_row *row, const study_column *c);
double study_number(const sph2d_study_row *row, const study_column *c);

/** The heading of a column in the table, and what it says of a row that is there. */
void study_heading(const cli_study *s, const study_column *c, char out[STUDY_CELL_SIZE]);
void study_cell(const sph2d_study_row *row, const study_column *c, char out[STUDY_CELL_SIZE]);

/** Words stand left, numbers right. */
bool study_stands_left(const study_column *c);

/** A word for how a row ended. */
const char *study_end_name(sph2d_study_end end);

/** Seconds as the table has them. */
void study_seconds(char out[STUDY_CELL_SIZE], double seconds);

#endif
