/* SPDX-License-Identifier: MIT */
/** @file study_table.c
 *  The rows of a study as a table for people. */
#include "study_table.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../message.h"
#include "../text.h"

enum { CELL_SIZE = 256, MOST_PER_MEASURE = 3 };

typedef enum column_kind {
    COLUMN_NAME,
    COLUMN_END,
    COLUMN_PARTICLES,
    COLUMN_STEPS,
    COLUMN_CPU,
    COLUMN_WALL,
    COLUMN_RATE,
    COLUMN_VALUE,
    COLUMN_ERROR,
    COLUMN_ORDER
} column_kind;

typedef struct column {
    column_kind kind;
    size_t measure;
    int width; /* in characters */
} column;

bool study_has_value(const sph2d_study_measure *measure)
{
    return measure->expectation != SPH2D_EXPECT_REFERENCE;
}

bool study_has_error(const sph2d_study_measure *measure)
{
    return measure->expectation != SPH2D_EXPECT_NOTHING;
}

const char *study_end_name(study_end end)
{
    static const char *const names[] = {"finished", "guard", "failed", "stopped"};
    return names[end];
}

double study_rate(const study_row *row)
{
    return row->wall > 0 && row->steps > 0 ? (double)row->particle_steps / row->wall : NAN;
}

/* ---- cells ------------------------------------------------------------------------------------------------------- */

static void write_heading(const cli_study *s, const column *c, char out[CELL_SIZE])
{
    static const char *const headings[] = {
        [COLUMN_NAME] = "row",  [COLUMN_END] = "end",     [COLUMN_PARTICLES] = "particles",  [COLUMN_STEPS] = "steps",
        [COLUMN_CPU] = "CPU s", [COLUMN_WALL] = "wall s", [COLUMN_RATE] = "particle-steps/s"};
    static const char *const norms[] = {"max", "rms", "mean"};
    if (c->kind < COLUMN_VALUE) {
        snprintf(out, CELL_SIZE, "%s", headings[c->kind]);
        return;
    }
    const sph2d_study_measure *m = &s->study->measures[c->measure];
    if (c->kind == COLUMN_VALUE)
        snprintf(out, CELL_SIZE, "%.200s", m->name);
    else if (c->kind == COLUMN_ORDER)
        snprintf(out, CELL_SIZE, "order");
    else if (study_has_value(m))
        snprintf(out, CELL_SIZE, "%serror", m->relative ? "relative " : "");
    else
        snprintf(out, CELL_SIZE, "%.200s: %s error", m->name, norms[m->norm]);
}

static void write_number(char out[CELL_SIZE], const char *format, double value)
{
    snprintf(out, CELL_SIZE, isfinite(value) ? format : "-", value);
}

static void write_seconds(char out[CELL_SIZE], double seconds)
{
    write_number(out, seconds < 99.95 ? "%.2f" : "%.0f", seconds);
}

static void write_cell(const study_row *row, const column *c, char out[CELL_SIZE])
{
    const study_value *v = &row->values[c->measure];
    char rate[TEXT_SIZE];
    switch (c->kind) {
    case COLUMN_NAME:
        snprintf(out, CELL_SIZE, "%.200s", row->run->name);
        break;
    case COLUMN_END:
        snprintf(out, CELL_SIZE, "%s", study_end_name(row->end));
        break;
    case COLUMN_PARTICLES:
        snprintf(out, CELL_SIZE, "%" PRIu64, row->particles);
        break;
    case COLUMN_STEPS:
        snprintf(out, CELL_SIZE, "%" PRIu64, row->steps);
        break;
    case COLUMN_CPU:
        write_seconds(out, row->cpu);
        break;
    case COLUMN_WALL:
        write_seconds(out, row->wall);
        break;
    case COLUMN_RATE:
        snprintf(out, CELL_SIZE, "%s", isnan(study_rate(row)) ? "-" : text_count(rate, study_rate(row)));
        break;
    case COLUMN_VALUE:
        write_number(out, "%.5g", v->value);
        break;
    case COLUMN_ERROR:
        write_number(out, "%.3g", v->error);
        break;
    case COLUMN_ORDER:
        write_number(out, "%.2f", v->order);
        break;
    }
}

/* ---- the layout -------------------------------------------------------------------------------------------------- */

/* Characters, not bytes. */
static int width_of(const char *text)
{
    int width = 0;
    for (; *text != '\0'; ++text)
        width += ((unsigned char)*text & 0xC0) != 0x80;
    return width;
}

static void widen(column *c, const char *text)
{
    int width = width_of(text);
    c->width = width > c->width ? width : c->width;
}

static size_t list_columns(const cli_study *s, column *out)
{
    bool all_finished = true;
    for (size_t r = 0; r < s->row_count; ++r)
        all_finished = all_finished && s->rows[r].end == STUDY_FINISHED;
    size_t count = 0;
    for (column_kind kind = COLUMN_NAME; kind < COLUMN_VALUE; ++kind)
        if (kind != COLUMN_END || !all_finished)
            out[count++] = (column){kind, 0, 0};
    for (size_t i = 0; i < s->study->measure_count; ++i) {
        const sph2d_study_measure *m = &s->study->measures[i];
        if (study_has_value(m))
            out[count++] = (column){COLUMN_VALUE, i, 0};
        if (study_has_error(m))
            out[count++] = (column){COLUMN_ERROR, i, 0};
        if (m->order)
            out[count++] = (column){COLUMN_ORDER, i, 0};
    }
    char cell[CELL_SIZE];
    for (size_t k = 0; k < count; ++k) {
        write_heading(s, &out[k], cell);
        widen(&out[k], cell);
        for (size_t r = 0; r < s->row_count; ++r) {
            write_cell(&s->rows[r], &out[k], cell);
            widen(&out[k], cell);
        }
    }
    return count;
}

/* Words stand left, numbers right. */
static bool stands_left(const column *c)
{
    return c->kind == COLUMN_NAME || c->kind == COLUMN_END;
}

static void print_cell(const column *c, const char *text)
{
    int blanks = c->width - width_of(text);
    if (stands_left(c))
        printf("| %s%*s ", text, blanks, "");
    else
        printf("| %*s%s ", blanks, "", text);
}

static void print_rule(const column *columns, size_t count)
{
    for (size_t k = 0; k < count; ++k) {
        putchar('|');
        for (int i = 0; i < columns[k].width + 1; ++i)
            putchar('-');
        putchar(stands_left(&columns[k]) ? '-' : ':');
    }
    puts("|");
}

void study_table_print(const cli_study *s)
{
    column *columns = malloc((COLUMN_VALUE + MOST_PER_MEASURE * s->study->measure_count) * sizeof *columns);
    if (columns == NULL) {
        message_error(SPH2D_CODE_GENERAL, NULL, "out of memory");
        return;
    }
    size_t count = list_columns(s, columns);
    char cell[CELL_SIZE], in_use[TEXT_SIZE];
    for (size_t k = 0; k < count; ++k) {
        write_heading(s, &columns[k], cell);
        print_cell(&columns[k], cell);
    }
    puts("|");
    print_rule(columns, count);
    for (size_t r = 0; r < s->row_count; ++r) {
        for (size_t k = 0; k < count; ++k) {
            write_cell(&s->rows[r], &columns[k], cell);
            print_cell(&columns[k], cell);
        }
        puts("|");
    }
    if (s->isa != NULL)
        printf("\n%s, %s\n", threads_describe(in_use, s->threads.count, &s->threads), s->isa);
    free(columns);
}
