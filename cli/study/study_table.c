/* SPDX-License-Identifier: MIT */
/** @file study_table.c
 *  The rows of a study as a table for people. */
#include "study_table.h"
#include "study_verdict.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../build.h"
#include "../message.h"
#include "study_cells.h"

/* ---- the layout -------------------------------------------------------------------------------------------------- */

/* Characters, not bytes. */
static int width_of(const char *text)
{
    int width = 0;
    for (; *text != '\0'; ++text)
        width += ((unsigned char)*text & 0xC0) != 0x80;
    return width;
}

static void widen(int *width, const char *text)
{
    *width = width_of(text) > *width ? width_of(text) : *width;
}

/* The widths that hold all cells. */
static void measure_columns(const cli_study *s, const study_column *columns, size_t count, int *widths)
{
    char cell[STUDY_CELL_SIZE];
    for (size_t k = 0; k < count; ++k) {
        widths[k] = 0;
        study_cells_heading(s, &columns[k], cell);
        widen(&widths[k], cell);
        for (size_t r = 0; r < s->row_count; ++r) {
            if (!s->rows[r].there)
                continue;
            study_cells_text(&s->rows[r], &columns[k], cell);
            widen(&widths[k], cell);
        }
    }
}

/* A bar would end the cell. */
static void print_cell(const study_column *c, int width, char *text)
{
    for (char *bar = strchr(text, '|'); bar != NULL; bar = strchr(bar, '|'))
        *bar = '/';
    int blanks = width - width_of(text);
    if (study_cells_left(c))
        printf("| %s%*s ", text, blanks, "");
    else
        printf("| %*s%s ", blanks, "", text);
}

static void print_rule(const study_column *columns, const int *widths, size_t count)
{
    for (size_t k = 0; k < count; ++k) {
        putchar('|');
        for (int i = 0; i < widths[k] + 1; ++i)
            putchar('-');
        putchar(study_cells_left(&columns[k]) ? '-' : ':');
    }
    puts("|");
}

static void print_rows(const cli_study *s, const study_column *columns, const int *widths, size_t count)
{
    char cell[STUDY_CELL_SIZE];
    for (size_t k = 0; k < count; ++k) {
        study_cells_heading(s, &columns[k], cell);
        print_cell(&columns[k], widths[k], cell);
    }
    puts("|");
    print_rule(columns, widths, count);
    for (size_t r = 0; r < s->row_count; ++r) {
        for (size_t k = 0; k < count && s->rows[r].there; ++k) {
            study_cells_text(&s->rows[r], &columns[k], cell);
            print_cell(&columns[k], widths[k], cell);
        }
        if (s->rows[r].there)
            puts("|");
    }
}

/* ---- all of it --------------------------------------------------------------------------------------------------- */

char *study_conditions(const cli_study *s, char *out, size_t size)
{
    const char *isa = NULL;
    size_t beside = 0;
    char in_use[TEXT_SIZE];
    for (size_t r = 0; r < s->row_count; ++r)
        if (s->rows[r].there && s->rows[r].record.isa[0] != '\0') {
            isa = s->rows[r].record.isa;
            beside += isnan(s->rows[r].record.wall);
        }
    out[0] = '\0';
    if (isa == NULL)
        return out;
    snprintf(out, size, "%s, %s", threads_describe(in_use, s->threads.count, &s->threads), isa);
    size_t used = strlen(out);
    if (s->repeat > 1)
        snprintf(out + used, size - used, ", least of %" PRIu64 " runs where one takes less than %d s", s->repeat,
                 SPH2D_STUDY_REPEATED);
    used = strlen(out);
    if (s->jobs > 1)
        snprintf(out + used, size - used, ", %zu rows at a time: CPU seconds alone", s->jobs);
    else if (beside > 0)
        snprintf(out + used, size - used, ", %zu rows were run beside others: CPU seconds alone", beside);
    return out;
}

void study_table_print(const cli_study *s)
{
    size_t most = study_cells_most(s);
    study_column *columns = malloc(most * sizeof *columns);
    int *widths = malloc(most * sizeof *widths);
    char line[1024], build[1024];
    if (columns != NULL && widths != NULL) {
        size_t count = study_cells_list(s, columns);
        measure_columns(s, columns, count, widths);
        print_rows(s, columns, widths, count);
    } else {
        message_error(SPH2D_CODE_GENERAL, NULL, "out of memory");
    }
    if (study_conditions(s, line, sizeof line)[0] != '\0')
        printf("\n%s\n%s\n", line, build_describe(build, sizeof build));
    if (study_verdict(s, line, sizeof line)[0] != '\0')
        puts(line);
    free(columns);
    free(widths);
}
