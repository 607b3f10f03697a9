/* SPDX-License-Identifier: MIT */
/** @file columns.c
 *  The columns of a study, and their cells in a table for people. */
#include "columns.h"

#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../text.h"

#define ROW(field) offsetof(sph2d_study_row, field)

/* Places of the table: what people look for comes first, the errors and what they cost. */
enum { PLACE_NAME = 1, PLACE_END, PLACE_FRONT, PLACE_CPU, PLACE_MEASURES, PLACE_WALL, PLACES = 11 };

const study_column study_columns[] = {
    {STUDY_COUNT, ROW(number), "row", "row", NULL, 0, 0},
    {STUDY_NAME, ROW(run.name), "name", "name", "row", PLACE_NAME, 0},
    {STUDY_END, ROW(record.end), "end", "end", "end", PLACE_END, 0},
    {STUDY_TEXT, ROW(record.reason), "reason", "reason", NULL, 0, 0},
    {STUDY_FLAG, ROW(on_front), "front", "front", "front", PLACE_FRONT, 0},
    {STUDY_NUMBER, ROW(record.spacing), "spacing [m]", "spacing", NULL, 0, 0},
    {STUDY_COUNT, ROW(record.particles), "particles", "particles", "particles", 7, 0},
    {STUDY_COUNT, ROW(record.left), "left", "left", NULL, 0, 0},
    {STUDY_NUMBER, ROW(record.time), "simulated [s]", "time", NULL, 0, 0},
    {STUDY_COUNT, ROW(record.steps), "steps", "steps", "steps", 8, 0},
    {STUDY_COUNT, ROW(record.particle_steps), "particle-steps", "particle_steps", NULL, 0, 0},
    {STUDY_COUNT, ROW(record.repeats), "repeats", "repeats", NULL, 0, 0},
    {STUDY_SECONDS, ROW(record.cpu), "cpu [s]", "step_cpu_seconds", "CPU s", PLACE_CPU, 0},
    {STUDY_SECONDS, ROW(record.wall), "wall [s]", "step_seconds", "wall s", PLACE_WALL, 0},
    {STUDY_SECONDS, ROW(record.start), "start [s]", "start_cpu_seconds", "start s", 9, 0},
    {STUDY_SECONDS, ROW(record.probes), "probes [s]", "probes_cpu_seconds", "probes s", 10, 0},
    {STUDY_TEXT, ROW(record.isa), NULL, "isa", NULL, 0, 0},
    {STUDY_RATE, ROW(rate), "particle-steps/s", "particle_steps_per_second", "particle-steps/s", PLACES, 0},
};
const size_t study_column_count = sizeof study_columns / sizeof *study_columns;

size_t study_columns_of(const cli_study *s, size_t measure, study_column out[3])
{
    const sph2d_study_measure *m = &s->study->measures[measure];
    size_t count = 0;
    if (sph2d_study_has_value(m))
        out[count++] = (study_column){STUDY_VALUE, offsetof(sph2d_study_value, value), "", NULL, "", 0, measure};
    if (sph2d_study_has_error(m))
        out[count++] = (study_column){STUDY_ERROR, offsetof(sph2d_study_value, error), " error", NULL, "", 0, measure};
    if (m->order)
        out[count++] = (study_column){STUDY_ORDER, offsetof(sph2d_study_value, order), " order", NULL, "", 0, measure};
    return count;
}

/* Columns that say the same of every row are left out. */
static bool says_something(const cli_study *s, int place)
{
    bool front = false, wall = false, eventful = false;
    STUDY_FOR_ROWS (s, row) {
        front = front || row->on_front;
        wall = wall || !isnan(row->record.wall);
        eventful = eventful || row->record.end != SPH2D_STUDY_FINISHED || row->record.left > 0;
    }
    return place == PLACE_FRONT ? front : place == PLACE_WALL ? wall : place == PLACE_END ? eventful : true;
}

size_t study_columns_shown(const cli_study *s, study_column **out)
{
    size_t count = 0;
    *out = malloc((study_column_count + 3 * s->study->measure_count) * sizeof **out);
    for (int place = 1; *out && place <= PLACES; ++place) {
        for (size_t i = 0; place == PLACE_MEASURES && i < s->study->measure_count; ++i)
            count += study_columns_of(s, i, *out + count);
        for (size_t i = 0; i < study_column_count; ++i)
            if (study_columns[i].place == place && says_something(s, place))
                (*out)[count++] = study_columns[i];
    }
    return count;
}

/* ---- cells ------------------------------------------------------------------------------------------------------- */

const char *study_end_name(sph2d_study_end end)
{
    static const char *const names[] = {"finished", "guard", "failed", "stopped", "died"};
    return names[end];
}

const void *study_field(const sph2d_study_row *row, const study_column *c)
{
    return (c->form >= STUDY_VALUE ? (const char *)&row->values[c->measure] : (const char *)row) + c->offset;
}

double study_number(const sph2d_study_row *row, const study_column *c)
{
    return *(const double *)study_field(row, c);
}

bool study_aligns_left(const study_column *c)
{
    return c->form < STUDY_COUNT;
}

void study_heading(const cli_study *s, const study_column *c, char out[STUDY_CELL_SIZE])
{
    static const char *const norms[] = {"max", "rms", "mean"};
    if (c->form < STUDY_VALUE) {
        snprintf(out, STUDY_CELL_SIZE, "%s", c->heading);
        return;
    }
    const sph2d_study_measure *m = &s->study->measures[c->measure];
    char name[201];
    snprintf(name, sizeof name, "%s", m->name);
    text_whole(name);
    if (c->form == STUDY_VALUE)
        snprintf(out, STUDY_CELL_SIZE, "%s", name);
    else if (c->form == STUDY_ORDER)
        snprintf(out, STUDY_CELL_SIZE, "order");
    else if (sph2d_study_has_value(m))
        snprintf(out, STUDY_CELL_SIZE, "%serror", m->relative ? "relative " : "");
    else
        snprintf(out, STUDY_CELL_SIZE, "%s: %s error", name, norms[m->norm]);
}

static void write_number(char out[STUDY_CELL_SIZE], const char *format, double value)
{
    snprintf(out, STUDY_CELL_SIZE, isfinite(value) ? format : "-", value);
}

void study_seconds(char out[STUDY_CELL_SIZE], double seconds)
{
    write_number(out, seconds < 99.95 ? "%.2f" : "%.0f", seconds);
}

/* How it ended, and whether particles went through open sides on the way. */
static void write_end(const sph2d_study_record *record, char out[STUDY_CELL_SIZE])
{
    snprintf(out, STUDY_CELL_SIZE, "%s", study_end_name(record->end));
    size_t used = strlen(out);
    if (record->left > 0)
        snprintf(out + used, STUDY_CELL_SIZE - used, ", %" PRIu64 " left", record->left);
}

void study_cell(const sph2d_study_row *row, const study_column *c, char out[STUDY_CELL_SIZE])
{
    static const char *const formats[] = {
        [STUDY_NUMBER] = "%.5g", [STUDY_VALUE] = "%.5g", [STUDY_ERROR] = "%.3g", [STUDY_ORDER] = "%.2f"};
    const void *field = study_field(row, c);
    char rate[TEXT_SIZE];
    if (c->form == STUDY_NAME || c->form == STUDY_TEXT)
        snprintf(out, STUDY_CELL_SIZE, "%.200s",
                 c->form == STUDY_NAME ? *(const char *const *)field : (const char *)field);
    else if (c->form == STUDY_END)
        write_end(&row->record, out);
    else if (c->form == STUDY_FLAG)
        snprintf(out, STUDY_CELL_SIZE, "%s", *(const bool *)field ? "*" : "");
    else if (c->form == STUDY_COUNT)
        snprintf(out, STUDY_CELL_SIZE, "%" PRIu64, *(const uint64_t *)field);
    else if (c->form == STUDY_SECONDS)
        study_seconds(out, study_number(row, c));
    else if (c->form == STUDY_RATE)
        snprintf(out, STUDY_CELL_SIZE, "%s", isnan(row->rate) ? "-" : text_count(rate, row->rate));
    else
        write_number(out, formats[c->form], study_number(row, c));
    text_whole(out);
}
