/* SPDX-License-Identifier: MIT */
/** @file study_reference.c
 *  Two columns of a CSV file. */
#include "study_reference.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../parse.h"

/* A line is read up to its length, so that no file, whatever it is, fills the memory. */
enum { LINE_SIZE = 64 * 1024, MOST_POINTS = 10 * 1000 * 1000, CELL_SIZE = 48 };

typedef struct reader {
    const sph2d_study_reference *reference;
    FILE *in;
    char *line; /* without its end; LINE_SIZE */
    int number; /* of that line, from 1 */
    sph2d_report *report;
} reader;

/* A cell of a line, without the blanks around it. */
typedef struct cell {
    const char *text;
    size_t length;
} cell;

/* ---- faults ------------------------------------------------------------------------------------------------------ */

/* Reports a fault at a place in the line; NULL for the file as a whole. */
static sph2d_diagnostic *fault(const reader *r, sph2d_code code, const char *at, const char *message)
{
    sph2d_diagnostic *d = sph2d_report_add(r->report, SPH2D_ERROR, code, NULL, "%s", message);
    if (d == NULL)
        return NULL;
    snprintf(d->file, sizeof d->file, "%s", r->reference->file);
    if (at == NULL)
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
    sph2d_report_add(r->report, SPH2D_ERROR, SPH2D_CODE_FILE_OPEN, NULL, "cannot %s '%s': %s", what, r->reference->file,
                     strerror(errno));
    return SPH2D_NOINPUT;
}

/* ---- lines and cells --------------------------------------------------------------------------------------------- */

/* Reads the next line that counts. False at the end, and after a fault in *status. */
static bool next_line(reader *r, sph2d_status *status)
{
    while (fgets(r->line, LINE_SIZE, r->in) != NULL) {
        ++r->number;
        size_t length = strlen(r->line);
        if (!feof(r->in) && (length == 0 || r->line[length - 1] != '\n')) {
            fault(r, SPH2D_CODE_FILE_KIND, r->line, "this is no text, or a line longer than any of a table");
            *status = SPH2D_FORMAT;
            return false;
        }
        r->line[strcspn(r->line, "\r\n")] = '\0';
        if (r->number == 1 && strncmp(r->line, "\xEF\xBB\xBF", 3) == 0)
            memmove(r->line, r->line + 3, strlen(r->line + 3) + 1);
        if (r->line[0] != '#' && r->line[strspn(r->line, " \t")] != '\0')
            return true;
    }
    if (ferror(r->in))
        *status = fault_of_file(r, "read");
    return false;
}

/* Cell `index` of the line; a text of NULL when it has fewer. */
static cell find_cell(const reader *r, size_t index)
{
    const char *text = r->line;
    for (; index > 0 && text != NULL; --index) {
        text = strchr(text, ',');
        text = text != NULL ? text + 1 : NULL;
    }
    if (text == NULL)
        return (cell){NULL, 0};
    text += strspn(text, " \t");
    size_t length = strcspn(text, ",");
    while (length > 0 && (text[length - 1] == ' ' || text[length - 1] == '\t'))
        --length;
    return (cell){text, length};
}

/* Whether a heading is `name`, with or without its unit: "a" for "a [m]". */
static bool is_named(cell heading, const char *name)
{
    size_t length = strlen(name);
    if (heading.length < length || memcmp(heading.text, name, length) != 0)
        return false;
    return heading.length == length || strncmp(heading.text + length, " [", 2) == 0;
}

static bool find_column(const reader *r, const char *name, size_t *index)
{
    char list[160] = "";
    cell heading;
    for (*index = 0; (heading = find_cell(r, *index)).text != NULL; ++*index) {
        if (is_named(heading, name))
            return true;
        size_t used = strlen(list);
        snprintf(list + used, sizeof list - used, "%s%.*s", used > 0 ? ", " : "", (int)heading.length, heading.text);
    }
    char message[120];
    snprintf(message, sizeof message, "there is no column '%.60s'", name);
    sph2d_diagnostic_hint(fault(r, SPH2D_CODE_FILE_FIELD, r->line, message), "columns here: %s", list);
    return false;
}

/* ---- points ------------------------------------------------------------------------------------------------------ */

/* Reads a number; *missing when the cell is empty or nan. False after a fault. */
static bool read_number(const reader *r, size_t index, const char *name, double *value, bool *missing)
{
    cell c = find_cell(r, index);
    char text[CELL_SIZE], message[160];
    snprintf(text, sizeof text, "%.*s", c.length < CELL_SIZE ? (int)c.length : CELL_SIZE - 1,
             c.text != NULL ? c.text : "");
    if (c.text == NULL) {
        snprintf(message, sizeof message, "the row ends before its column '%.60s'", name);
        fault(r, SPH2D_CODE_FILE_FIELD, r->line + strlen(r->line), message);
        return false;
    }
    *missing = *missing || text[0] == '\0' || strcmp(text, "nan") == 0 || strcmp(text, "NaN") == 0;
    if (*missing || (c.length < CELL_SIZE && parse_number(text, value)))
        return true;
    snprintf(message, sizeof message, "expected a number, got '%s'", text);
    fault(r, SPH2D_CODE_FILE_FIELD, c.text, message);
    return false;
}

static sph2d_status add_point(study_points *p, double x, double y)
{
    if (p->count == p->room) {
        size_t room = p->room > 0 ? 2 * p->room : 64;
        double *larger_x = realloc(p->x, room * sizeof *larger_x);
        if (larger_x != NULL)
            p->x = larger_x;
        double *larger_y = realloc(p->y, room * sizeof *larger_y);
        if (larger_y != NULL)
            p->y = larger_y;
        if (larger_x == NULL || larger_y == NULL)
            return SPH2D_NOMEM;
        p->room = room;
    }
    p->x[p->count] = x;
    p->y[p->count++] = y;
    return SPH2D_OK;
}

static sph2d_status read_point(const reader *r, const size_t columns[2], bool along, study_points *points)
{
    double x = 0, y = 0;
    bool missing = false;
    if (!read_number(r, columns[0], r->reference->x, &x, &missing) ||
        !read_number(r, columns[1], r->reference->y, &y, &missing))
        return SPH2D_FORMAT;
    if (missing)
        return SPH2D_OK;
    if (along && !(x >= 0 && x <= 1)) {
        char message[120];
        snprintf(message, sizeof message, "%g does not lie on the line: must be from 0, its first end, to 1", x);
        fault(r, SPH2D_CODE_OUT_OF_RANGE, find_cell(r, columns[0]).text, message);
        return SPH2D_FORMAT;
    }
    if (points->count == MOST_POINTS) {
        fault(r, SPH2D_CODE_FILE_KIND, r->line, "more than ten million points");
        return SPH2D_FORMAT;
    }
    return add_point(points, x, y);
}

static sph2d_status read_table(reader *r, bool along, study_points *points)
{
    sph2d_status status = SPH2D_OK;
    size_t columns[2];
    if (!next_line(r, &status)) {
        if (status == SPH2D_OK)
            fault(r, SPH2D_CODE_FILE_KIND, NULL, "there is no table in this file: it is empty");
        return status == SPH2D_OK ? SPH2D_FORMAT : status;
    }
    bool found_x = find_column(r, r->reference->x, &columns[0]);
    if (!find_column(r, r->reference->y, &columns[1]) || !found_x)
        return SPH2D_FORMAT;
    while (status == SPH2D_OK && next_line(r, &status))
        status = read_point(r, columns, along, points);
    if (status == SPH2D_OK && points->count == 0) {
        fault(r, SPH2D_CODE_FILE_FIELD, NULL, "there is no row with both numbers");
        status = SPH2D_FORMAT;
    }
    return status;
}

sph2d_status study_points_read(study_points *points, const sph2d_study_reference *reference, bool along,
                               sph2d_report *report)
{
    reader r = {.reference = reference, .report = report};
    r.in = fopen(reference->file, "r");
    if (r.in == NULL)
        return fault_of_file(&r, "open");
    r.line = malloc(LINE_SIZE);
    sph2d_status status = r.line != NULL ? read_table(&r, along, points) : SPH2D_NOMEM;
    free(r.line);
    fclose(r.in);
    return status;
}

study_curve study_points_curve(const study_points *points)
{
    return (study_curve){points->x, points->y, points->count};
}

void study_points_free(study_points *points)
{
    free(points->x);
    free(points->y);
    *points = (study_points){0};
}
