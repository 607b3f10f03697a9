/* SPDX-License-Identifier: MIT */
/** @file table.c
 *  The rows of a study as a table for people, and the lines below it. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../build.h"
#include "../message.h"
#include "../text.h"
#include "columns.h"
#include "parts.h"

/* ---- the table --------------------------------------------------------------------------------------------------- */

/* Characters, not bytes. */
static int width_of(const char *text)
{
    int width = 0;
    for (; *text != '\0'; ++text)
        width += ((unsigned char)*text & 0xC0) != 0x80;
    return width;
}

/* The text of a cell, or the heading where `row` is NULL. */
static void write_cell(const cli_study *s, const sph2d_study_row *row, const study_column *c, char out[STUDY_CELL_SIZE])
{
    if (row)
        study_cell(row, c, out);
    else
        study_heading(s, c, out);
    study_clean(out, "|", '/'); /* a bar would end the cell */
}

static void print_line(const cli_study *s, const sph2d_study_row *row, const study_column *columns, const int *widths,
                       size_t count)
{
    char cell[STUDY_CELL_SIZE];
    for (size_t k = 0; k < count; ++k) {
        write_cell(s, row, &columns[k], cell);
        int blanks = widths[k] - width_of(cell);
        if (study_aligns_left(&columns[k]))
            printf("| %s%*s ", cell, blanks, "");
        else
            printf("| %*s%s ", blanks, "", cell);
    }
    puts("|");
}

static void print_rows(const cli_study *s, const study_column *columns, int *widths, size_t count)
{
    char cell[STUDY_CELL_SIZE];
    for (size_t k = 0; k < count; ++k) {
        write_cell(s, NULL, &columns[k], cell);
        widths[k] = width_of(cell);
        STUDY_FOR_ROWS (s, row) {
            write_cell(s, row, &columns[k], cell);
            widths[k] = width_of(cell) > widths[k] ? width_of(cell) : widths[k];
        }
    }
    print_line(s, NULL, columns, widths, count);
    for (size_t k = 0; k < count; ++k) {
        putchar('|');
        for (int i = 0; i < widths[k] + 1; ++i)
            putchar('-');
        putchar(study_aligns_left(&columns[k]) ? '-' : ':');
    }
    puts("|");
    STUDY_FOR_ROWS (s, row)
        print_line(s, row, columns, widths, count);
}

/* ---- the lines below --------------------------------------------------------------------------------------------- */

char *study_conditions(const cli_study *s, char *out, size_t size)
{
    const char *isa = NULL;
    size_t rows = 0, beside = 0;
    char in_use[TEXT_SIZE];
    STUDY_FOR_ROWS (s, row)
        if (row->record.isa[0] != '\0') {
            isa = row->record.isa;
            beside += isnan(row->record.wall) ? 1 : 0;
            ++rows;
        }
    out[0] = '\0';
    if (!isa)
        return out;
    bool shards = s->by_shards == rows;
    snprintf(out, size, "%s, %s",
             shards ? "each shard's own threads" : threads_describe(in_use, s->threads.count, &s->threads), isa);
    char device[TEXT_DEVICE_SIZE];
    if (s->device.number > 0)
        text_append(out, size, ", by %s", device_describe(device, &s->device));
    size_t used = strlen(out);
    if (s->repeat > 1)
        snprintf(out + used, size - used, ", least of %" PRIu64 " runs where one takes less than %d s", s->repeat,
                 SPH2D_STUDY_REPEATED);
    used = strlen(out);
    if (s->by_shards > 0)
        snprintf(out + used, size - used, ", %zu row%s by shards, perhaps on other processors: CPU seconds alone",
                 s->by_shards, s->by_shards == 1 ? "" : "s");
    else if (s->jobs > 1)
        snprintf(out + used, size - used, ", %zu rows at a time: CPU seconds alone", s->jobs);
    else if (beside > 0)
        snprintf(out + used, size - used, ", %zu rows were run beside others: CPU seconds alone", beside);
    return out;
}

/* As people read it: per cent where it is a part of something, else in units of the measure. */
static void write_error(const cli_study *s, char out[TEXT_SIZE], double error)
{
    snprintf(out, TEXT_SIZE, s->percent ? "%.3g %%" : "%.3g", s->percent ? 100 * error : error);
}

char *study_verdict(const cli_study *s, char *out, size_t size)
{
    const sph2d_study_row *cheapest = sph2d_study_cheapest(s->results, s->target);
    const sph2d_study_row *row = cheapest ? cheapest : sph2d_study_best(s->results);
    char wanted[TEXT_SIZE], got[TEXT_SIZE], time[STUDY_CELL_SIZE], judged[101], name[201];
    out[0] = '\0';
    if (!row)
        return out;
    const sph2d_study_measure *judge = &s->study->measures[s->results->judge];
    const char *against = judge->expectation == SPH2D_EXPECT_FINEST ? ", against the finest row" : "";
    write_error(s, wanted, s->target);
    write_error(s, got, sph2d_study_row_error(s->results, row));
    study_seconds(time, row->record.cpu);
    snprintf(judged, sizeof judged, "%s", judge->name);
    snprintf(name, sizeof name, "%s", row->run.name);
    text_whole(judged);
    text_whole(name);
    if (cheapest)
        snprintf(out, size, "For an error of %s (%s%s) the cheapest is '%s': %s in %s CPU s.", wanted, judged, against,
                 name, got, time);
    else
        snprintf(out, size, "No row has an error of %s or less (%s%s): the smallest is %s, by '%s' in %s CPU s.",
                 wanted, judged, against, got, name, time);
    return out;
}

void study_table_print(const cli_study *s)
{
    study_column *columns;
    size_t count = study_columns_shown(s, &columns);
    int *widths = calloc(count + 1, sizeof *widths);
    char line[1024], build[1024];
    if (columns && widths)
        print_rows(s, columns, widths, count);
    else
        message_error(SPH2D_CODE_GENERAL, NULL, "out of memory");
    if (study_conditions(s, line, sizeof line)[0] != '\0')
        printf("\n%s\n%s\n", line, build_describe(build, sizeof build));
    if (study_verdict(s, line, sizeof line)[0] != '\0')
        puts(line);
    free(columns);
    free(widths);
}
