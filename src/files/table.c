/* SPDX-License-Identifier: MIT */
/** @file table.c
 *  Reads columns of numbers from any CSV file. */
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/null.h"
#include "base/number.h"
#include "sph2d/io.h"

/* Limits of lines and rows, so that no file fills the memory. */
enum { LINE_SIZE = 64 * 1024, MAX_ROWS = 10 * 1000 * 1000, CELL_SIZE = 48 };

struct sph2d_table {
    char *path;
    size_t columns, rows, capacity;
    bool *known;    /**< whether the file has the column */
    double *values; /**< row by row */
    int *lines;     /**< of the rows in the file */
};

typedef struct reader {
    sph2d_table *table;
    const sph2d_table_column *columns;
    size_t *places; /**< of the columns in a line */
    FILE *in;
    char *line; /**< without its end; LINE_SIZE */
    int number; /**< of that line, from 1 */
    sph2d_report *report;
} reader;

/** A cell of a line, without the blanks around it. */
typedef struct cell {
    const char *text;
    size_t length;
} cell;

/* ---- errors ------------------------------------------------------------------------------------------------------ */

/** Reports an error at a position in the line; NULL for the file as a whole. */
static sph2d_diagnostic *fault(const reader *r, sph2d_code code, const char *at, const char *message)
{
    sph2d_diagnostic *d = sph2d_report_add(r->report, SPH2D_ERROR, code, NULL, "%s", message);
    if (!d)
        return NULL;
    snprintf(d->file, sizeof d->file, "%s", r->table->path);
    if (!at)
        return d;
    d->line = r->number;
    d->column = 1;
    for (const char *c = r->line; c < at; ++c)
        d->column += ((unsigned char)*c & 0xC0) != 0x80;
    snprintf(d->excerpt, sizeof d->excerpt, "%.*s", (int)sizeof d->excerpt - 1, r->line);
    for (char *c = d->excerpt; *c != '\0'; ++c)
        *c = (unsigned char)*c < 0x20 ? ' ' : *c;
    return d;
}

static sph2d_status fault_of_file(const reader *r, const char *what)
{
    sph2d_report_add(r->report, SPH2D_ERROR, SPH2D_CODE_FILE_OPEN, NULL, "cannot %s '%s': %s", what, r->table->path,
                     strerror(errno));
    return SPH2D_NOINPUT;
}

/* ---- lines and cells --------------------------------------------------------------------------------------------- */

/** Removes \n or \r\n from the end. False if another carriage return remains. */
static bool cut_line_end(char *line)
{
    size_t length = strlen(line);
    length -= length > 0 && line[length - 1] == '\n';
    length -= length > 0 && line[length - 1] == '\r';
    line[length] = '\0';
    return !strchr(line, '\r');
}

/** Reads the next line that is not empty or a comment. False at the end, and after an error, with *status. */
static bool next_line(reader *r, sph2d_status *status)
{
    while (fgets(r->line, LINE_SIZE, r->in)) {
        ++r->number;
        size_t length = strlen(r->line);
        if (!feof(r->in) && (length == 0 || r->line[length - 1] != '\n')) {
            fault(r, SPH2D_CODE_FILE_KIND, r->line, "this is not text, or the line is too long for a table");
            *status = SPH2D_FORMAT;
            return false;
        }
        if (!cut_line_end(r->line)) {
            fault(r, SPH2D_CODE_FILE_KIND, r->line,
                  "lines must end with a line feed, not with a carriage return alone");
            *status = SPH2D_FORMAT;
            return false;
        }
        if (r->number == 1 && strncmp(r->line, "\xEF\xBB\xBF", 3) == 0)
            memmove(r->line, r->line + 3, strlen(r->line + 3) + 1);
        if (r->line[0] != '#' && r->line[strspn(r->line, " \t")] != '\0')
            return true;
    }
    if (ferror(r->in))
        *status = fault_of_file(r, "read");
    return false;
}

/** The cell at `*at`, which becomes the start of the next one, NULL after the last. */
static cell take_cell(const char **at)
{
    const char *text = *at + strspn(*at, " \t");
    size_t length = strcspn(text, ",");
    *at = text[length] == ',' ? text + length + 1 : NULL;
    while (length > 0 && (text[length - 1] == ' ' || text[length - 1] == '\t'))
        --length;
    return (cell){text, length};
}

/** Cell `index` of the line; its text is NULL if there is none. */
static cell find_cell(const reader *r, size_t index)
{
    const char *text = r->line;
    for (; index > 0 && text; --index) {
        text = strchr(text, ',');
        text = text ? text + 1 : NULL;
    }
    return text ? take_cell(&text) : (cell){NULL, 0};
}

/** Whether a heading is `name`, with or without its unit: "a" for "a [m]". */
static bool is_named(cell heading, const char *name)
{
    size_t length = strlen(name);
    if (heading.length < length || memcmp(heading.text, name, length) != 0)
        return false;
    return heading.length == length || strncmp(heading.text + length, " [", 2) == 0;
}

/** Whether a heading has no unit or the expected one; reports an error otherwise. */
static bool has_unit(const reader *r, cell heading, const sph2d_table_column *column)
{
    size_t name = strlen(column->name), unit = column->unit ? strlen(column->unit) : 0;
    const char *given = heading.text + name + 2;
    if (!column->unit || heading.length == name || (strncmp(given, column->unit, unit) == 0 && given[unit] == ']'))
        return true;
    char message[120];
    snprintf(message, sizeof message, "'%.40s' must be in %.20s", column->name, column->unit);
    fault(r, SPH2D_CODE_FILE_FIELD, heading.text, message);
    return false;
}

/** Finds the index of a column. False after an error; a missing optional column is none. */
static bool find_column(reader *r, size_t column)
{
    char list[160] = "";
    const char *name = r->columns[column].name, *at = r->line;
    for (size_t index = 0; at; ++index) {
        cell heading = take_cell(&at);
        if (is_named(heading, name)) {
            r->places[column] = index;
            r->table->known[column] = true;
            return has_unit(r, heading, &r->columns[column]);
        }
        size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%.*s", used > 0 ? ", " : "", (int)heading.length, heading.text);
    }
    if (r->columns[column].optional)
        return true;
    char message[120];
    snprintf(message, sizeof message, "there is no column '%.60s'", name);
    sph2d_diagnostic_hint(fault(r, SPH2D_CODE_FILE_FIELD, r->line, message), "columns here: %s", list);
    return false;
}

/* ---- rows -------------------------------------------------------------------------------------------------------- */

/** Reads a number; NaN if the cell is empty or nan. False after an error. */
static bool read_number(const reader *r, size_t column, double *value)
{
    cell c = find_cell(r, r->places[column]);
    char text[CELL_SIZE], message[160];
    snprintf(text, sizeof text, "%.*s", c.length < CELL_SIZE ? (int)c.length : CELL_SIZE - 1, c.text ? c.text : "");
    if (!c.text) {
        snprintf(message, sizeof message, "the row ends before its column '%.60s'", r->columns[column].name);
        fault(r, SPH2D_CODE_FILE_FIELD, r->line + strlen(r->line), message);
        return false;
    }
    *value = NAN;
    if (text[0] == '\0' || strcmp(text, "nan") == 0 || strcmp(text, "NaN") == 0)
        return true;
    if (c.length < CELL_SIZE && sph2d__number_real(text, value) == SPH2D__NUMBER_OK)
        return true;
    snprintf(message, sizeof message, "expected a number, got '%s'", text);
    fault(r, SPH2D_CODE_FILE_FIELD, c.text, message);
    return false;
}

static bool grow(sph2d_table *t)
{
    if (t->rows < t->capacity)
        return true;
    size_t capacity = t->capacity > 0 ? 2 * t->capacity : 64;
    double *values = realloc(t->values, capacity * t->columns * sizeof *values);
    if (values)
        t->values = values;
    int *lines = realloc(t->lines, capacity * sizeof *lines);
    if (lines)
        t->lines = lines;
    if (values && lines)
        t->capacity = capacity;
    return values && lines;
}

static sph2d_status read_row(reader *r)
{
    sph2d_table *t = r->table;
    if (t->rows == MAX_ROWS) {
        fault(r, SPH2D_CODE_FILE_KIND, r->line, "more than ten million rows");
        return SPH2D_FORMAT;
    }
    if (!grow(t))
        return SPH2D_NOMEM;
    double *row = t->values + t->rows * t->columns;
    for (size_t k = 0; k < t->columns; ++k) {
        row[k] = NAN;
        if (t->known[k] && !read_number(r, k, &row[k]))
            return SPH2D_FORMAT;
    }
    t->lines[t->rows++] = r->number;
    return SPH2D_OK;
}

static sph2d_status read_rows(reader *r)
{
    sph2d_status status = SPH2D_OK;
    if (!next_line(r, &status)) {
        if (status == SPH2D_OK)
            fault(r, SPH2D_CODE_FILE_KIND, NULL, "there is no table in this file: it is empty");
        return status == SPH2D_OK ? SPH2D_FORMAT : status;
    }
    bool found = true;
    for (size_t k = 0; k < r->table->columns; ++k)
        found = find_column(r, k) && found;
    if (!found)
        return SPH2D_FORMAT;
    while (status == SPH2D_OK && next_line(r, &status))
        status = read_row(r);
    return status;
}

/* ---- the interface ----------------------------------------------------------------------------------------------- */

/** A pipe that nobody writes is empty, instead of waiting for ever: a scene or a study may name any file. */
static FILE *open_file(const char *path)
{
    int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0)
        return NULL;
    FILE *in = fcntl(fd, F_SETFL, 0) == 0 ? fdopen(fd, "r") : NULL;
    if (!in)
        close(fd);
    return in;
}

static sph2d_status read_file(reader *r)
{
    r->in = open_file(r->table->path);
    if (!r->in)
        return fault_of_file(r, "open");
    sph2d__c_locale locale;
    sph2d_status status = SPH2D_NOMEM;
    if (r->line && r->places && sph2d__c_locale_begin(&locale)) {
        status = read_rows(r);
        sph2d__c_locale_end(&locale);
    }
    fclose(r->in);
    return status;
}

sph2d_status sph2d_table_read(const char *path, const sph2d_table_column *columns, size_t column_count,
                              sph2d_table **table, sph2d_report *report)
{
    if (!table)
        return sph2d__null(report, __func__, "table");
    *table = NULL;
    if (!path)
        return sph2d__null(report, __func__, "path");
    if (!columns || column_count == 0)
        return sph2d__null(report, __func__, "columns");
    for (size_t k = 0; k < column_count; ++k)
        if (!columns[k].name)
            return sph2d__null(report, __func__, "columns");
    sph2d_table *t = calloc(1, sizeof *t);
    if (!t)
        return SPH2D_NOMEM;
    t->columns = column_count;
    t->path = strdup(path);
    t->known = calloc(column_count, sizeof *t->known);
    reader r = {.table = t, .columns = columns, .report = report};
    r.line = malloc(LINE_SIZE);
    r.places = calloc(column_count, sizeof *r.places);
    sph2d_status status = t->path && t->known ? read_file(&r) : SPH2D_NOMEM;
    free(r.line);
    free(r.places);
    if (status == SPH2D_OK)
        *table = t;
    else
        sph2d_table_destroy(t);
    return status;
}

size_t sph2d_table_rows(const sph2d_table *table)
{
    if (!table)
        return 0;
    return table->rows;
}

bool sph2d_table_has(const sph2d_table *table, size_t column)
{
    if (!table)
        return false;
    return table->known[column];
}

double sph2d_table_value(const sph2d_table *table, size_t row, size_t column)
{
    if (!table)
        return NAN;
    return table->values[row * table->columns + column];
}

void sph2d_table_locate(const sph2d_table *table, size_t row, sph2d_diagnostic *diagnostic)
{
    if (!table || !diagnostic)
        return;
    snprintf(diagnostic->file, sizeof diagnostic->file, "%s", table->path);
    diagnostic->line = row < table->rows ? table->lines[row] : 0;
    diagnostic->column = diagnostic->line > 0;
    diagnostic->excerpt[0] = '\0';
}

void sph2d_table_destroy(sph2d_table *table)
{
    if (!table)
        return;
    free(table->path);
    free(table->known);
    free(table->values);
    free(table->lines);
    free(table);
}
