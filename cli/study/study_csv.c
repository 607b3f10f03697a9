/* SPDX-License-Identifier: MIT */
/** @file study_csv.c
 *  What a study writes with -o. The command never calls setlocale, so numbers have points. */
#include "study_csv.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../exit.h"
#include "study_cells.h"
#include "study_text.h"

/* NaN has no sign, whatever its bits say. */
static void put_number(FILE *out, double value)
{
    if (isnan(value))
        fputs(",nan", out);
    else
        fprintf(out, ",%.17g", value);
}

/* A text in quotes where it needs them; `more` stands behind it. */
static void put_text(FILE *out, const char *text, const char *more)
{
    if (strpbrk(text, ",\"\n\r") == NULL) {
        fprintf(out, "%s%s", text, more);
        return;
    }
    putc('"', out);
    for (; *text != '\0'; ++text) {
        if (*text == '"')
            putc('"', out);
        putc(*text, out);
    }
    fprintf(out, "%s\"", more);
}

/* ---- rows -------------------------------------------------------------------------------------------------------- */

static void put_headings(FILE *out, const sph2d_study *study)
{
    fputs("row,name,end,reason,front,spacing [m],particles,left,simulated [s],steps,particle-steps,repeats,cpu "
          "[s],wall [s],"
          "start [s],probes [s],particle-steps/s",
          out);
    for (size_t i = 0; i < study->measure_count; ++i) {
        const sph2d_study_measure *m = &study->measures[i];
        const struct {
            bool is_there;
            const char *more;
        } columns[] = {{study_has_value(m), ""}, {study_has_error(m), " error"}, {m->order != 0, " order"}};
        for (size_t k = 0; k < sizeof columns / sizeof *columns; ++k) {
            if (!columns[k].is_there)
                continue;
            putc(',', out);
            put_text(out, m->name, columns[k].more);
        }
    }
    putc('\n', out);
}

static void put_row(FILE *out, const sph2d_study *study, const study_row *row)
{
    const study_record *record = &row->record;
    fprintf(out, "%zu,", row->number);
    put_text(out, row->run.name, "");
    fprintf(out, ",%s,", study_end_name(record->end));
    put_text(out, record->reason, "");
    fprintf(out, ",%d", row->on_front);
    put_number(out, record->spacing);
    fprintf(out, ",%" PRIu64 ",%" PRIu64, record->particles, record->left);
    put_number(out, record->time);
    fprintf(out, ",%" PRIu64 ",%" PRIu64 ",%" PRIu64, record->steps, record->particle_steps, record->repeats);
    put_number(out, record->cpu);
    put_number(out, record->wall);
    put_number(out, record->start);
    put_number(out, record->probes);
    put_number(out, study_rate(row));
    for (size_t i = 0; i < study->measure_count; ++i) {
        const sph2d_study_measure *m = &study->measures[i];
        if (study_has_value(m))
            put_number(out, row->values[i].value);
        if (study_has_error(m))
            put_number(out, row->values[i].error);
        if (m->order)
            put_number(out, row->values[i].order);
    }
    putc('\n', out);
}

static int write_rows(cli_study *s)
{
    study_text page;
    if (!study_text_begin(&page))
        return study_report(s, SPH2D_NOMEM, NULL, NULL);
    put_headings(page.out, s->study);
    for (size_t r = 0; r < s->row_count; ++r)
        if (s->rows[r].there)
            put_row(page.out, s->study, &s->rows[r]);
    const char *path = folder_file(&s->folder, "study.csv");
    return study_report(s, study_text_write(&page, path, &s->report), NULL, NULL);
}

/* ---- series ------------------------------------------------------------------------------------------------------ */

static int write_series(cli_study *s, const study_row *row, const study_series *series)
{
    study_text page;
    if (!study_text_begin(&page))
        return study_report(s, SPH2D_NOMEM, NULL, NULL);
    fprintf(page.out, "time [s],%s\n", series->headings);
    for (size_t i = 0; i < series->count; ++i) {
        fprintf(page.out, "%.17g", series->time[i]);
        for (size_t k = 0; k < series->columns; ++k)
            put_number(page.out, series->values[i * series->columns + k]);
        putc('\n', page.out);
    }
    const char *path = folder_file(&s->folder, "series_%zu_%s.csv", row->number, series->probe);
    return study_report(s, study_text_write(&page, path, &s->report), NULL, NULL);
}

int study_csv_write(cli_study *s)
{
    if (s->options->output == NULL)
        return CLI_EXIT_SUCCESS;
    int code = write_rows(s);
    for (size_t r = 0; r < s->row_count; ++r)
        for (size_t i = 0; i < s->rows[r].record.series_count && code == CLI_EXIT_SUCCESS; ++i)
            code = write_series(s, &s->rows[r], &s->rows[r].record.series[i]);
    return code;
}
