/* SPDX-License-Identifier: MIT */
/** @file csv.c
 *  The numbers of a study in full. The command never calls setlocale, so they have points. */
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "../exit.h"
#include "columns.h"
#include "parts.h"

/* NaN has no sign, whatever its bits say. */
static void put_number(FILE *out, double value)
{
    if (isnan(value))
        fputs("nan", out);
    else
        fprintf(out, "%.17g", value);
}

/* A text in quotes where it needs them; `more` stands behind it. */
static void put_text(FILE *out, const char *text, const char *more)
{
    const char *quote = strpbrk(text, ",\"\n\r") ? "\"" : "";
    fputs(quote, out);
    for (; *text != '\0'; ++text)
        fprintf(out, "%s%c", *text == '"' ? "\"" : "", *text);
    fprintf(out, "%s%s", more, quote);
}

static void put_field(FILE *out, const sph2d_study_row *row, const study_column *c)
{
    const void *field = study_field(row, c);
    if (c->form == STUDY_NAME)
        put_text(out, *(const char *const *)field, "");
    else if (c->form == STUDY_TEXT)
        put_text(out, field, "");
    else if (c->form == STUDY_END)
        fputs(study_end_name(row->record.end), out);
    else if (c->form == STUDY_FLAG)
        fputs(*(const bool *)field ? "1" : "0", out);
    else if (c->form == STUDY_COUNT)
        fprintf(out, "%" PRIu64, *(const uint64_t *)field);
    else
        put_number(out, study_number(row, c));
}

/* The headings where `row` is NULL. */
static void put_line(FILE *out, const cli_study *s, const sph2d_study_row *row)
{
    const char *before = "";
    for (size_t i = 0; i < study_column_count; ++i) {
        if (!study_columns[i].csv)
            continue;
        fputs(before, out);
        before = ",";
        if (row)
            put_field(out, row, &study_columns[i]);
        else
            fputs(study_columns[i].csv, out);
    }
    for (size_t i = 0; i < s->study->measure_count; ++i) {
        study_column columns[3];
        size_t count = study_columns_of(s, i, columns);
        for (size_t k = 0; k < count; ++k) {
            putc(',', out);
            if (row)
                put_field(out, row, &columns[k]);
            else
                put_text(out, s->study->measures[i].name, columns[k].csv);
        }
    }
    putc('\n', out);
}

static void put_rows(const void *study, FILE *out)
{
    put_line(out, study, NULL);
    STUDY_FOR_ROWS ((const cli_study *)study, row)
        put_line(out, study, row);
}

static void put_series(const void *what, FILE *out)
{
    const sph2d_study_series *series = what;
    fprintf(out, "time [s],%s\n", sph2d_probe_columns(series->kind));
    for (size_t i = 0; i < series->count; ++i)
        for (size_t k = 0; k <= series->columns; ++k) {
            put_number(out, series->rows[i * (series->columns + 1) + k]);
            putc(k < series->columns ? ',' : '\n', out);
        }
}

int study_csv_write(cli_study *s)
{
    int code = study_write(s, "study.csv", put_rows, s);
    STUDY_FOR_ROWS (s, row)
        for (size_t i = 0; i < row->record.series_count && code == CLI_EXIT_SUCCESS; ++i) {
            const sph2d_study_series *series = &row->record.series[i];
            char name[sizeof series->probe + 48];
            snprintf(name, sizeof name, "series_%" PRIu64 "_%s.csv", row->number, series->probe);
            if (series->probe[0] != '\0')
                code = study_write(s, name, put_series, series);
        }
    return code;
}
