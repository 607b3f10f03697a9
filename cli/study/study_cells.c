/* SPDX-License-Identifier: MIT */
/** @file study_cells.c
 *  The columns and cells of a study's table. */
#include "study_cells.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include "../text.h"
#include "study_measure.h"

bool study_has_value(const sph2d_study_measure *measure)
{
    return !study_measure_is_curve(measure);
}

bool study_has_error(const sph2d_study_measure *measure)
{
    return measure->expectation != SPH2D_EXPECT_NOTHING;
}

const char *study_end_name(study_end end)
{
    static const char *const names[] = {"finished", "guard", "failed", "stopped", "died"};
    return names[end];
}

double study_rate(const study_row *row)
{
    const study_record *record = &row->record;
    double time = isnan(record->wall) ? record->cpu : record->wall;
    return time > 0 && record->steps > 0 ? (double)record->particle_steps / time : NAN;
}

/* ---- cells ------------------------------------------------------------------------------------------------------- */

void study_cells_heading(const cli_study *s, const study_column *c, char out[STUDY_CELL_SIZE])
{
    static const char *const headings[] = {
        [STUDY_COLUMN_NAME] = "row",        [STUDY_COLUMN_END] = "end",
        [STUDY_COLUMN_FRONT] = "front",     [STUDY_COLUMN_PARTICLES] = "particles",
        [STUDY_COLUMN_STEPS] = "steps",     [STUDY_COLUMN_CPU] = "CPU s",
        [STUDY_COLUMN_WALL] = "wall s",     [STUDY_COLUMN_START] = "start s",
        [STUDY_COLUMN_PROBES] = "probes s", [STUDY_COLUMN_RATE] = "particle-steps/s"};
    static const char *const norms[] = {"max", "rms", "mean"};
    if (c->kind < STUDY_COLUMN_VALUE) {
        snprintf(out, STUDY_CELL_SIZE, "%s", headings[c->kind]);
        return;
    }
    const sph2d_study_measure *m = &s->study->measures[c->measure];
    char name[201];
    snprintf(name, sizeof name, "%s", m->name);
    text_whole(name);
    if (c->kind == STUDY_COLUMN_VALUE)
        snprintf(out, STUDY_CELL_SIZE, "%s", name);
    else if (c->kind == STUDY_COLUMN_ORDER)
        snprintf(out, STUDY_CELL_SIZE, "order");
    else if (study_has_value(m))
        snprintf(out, STUDY_CELL_SIZE, "%serror", m->relative ? "relative " : "");
    else
        snprintf(out, STUDY_CELL_SIZE, "%s: %s error", name, norms[m->norm]);
}

static void write_number(char out[STUDY_CELL_SIZE], const char *format, double value)
{
    snprintf(out, STUDY_CELL_SIZE, isfinite(value) ? format : "-", value);
}

void study_cells_seconds(char out[STUDY_CELL_SIZE], double seconds)
{
    write_number(out, seconds < 99.95 ? "%.2f" : "%.0f", seconds);
}

/* How it ended, and whether particles went through open sides on the way. */
static void write_end(const study_record *record, char out[STUDY_CELL_SIZE])
{
    const char *end = study_end_name(record->end);
    if (record->left > 0)
        snprintf(out, STUDY_CELL_SIZE, "%s, %" PRIu64 " left", end, record->left);
    else
        snprintf(out, STUDY_CELL_SIZE, "%s", end);
}

void study_cells_text(const study_row *row, const study_column *c, char out[STUDY_CELL_SIZE])
{
    const study_value *v = &row->values[c->measure];
    const study_record *record = &row->record;
    char rate[TEXT_SIZE];
    switch (c->kind) {
    case STUDY_COLUMN_NAME:
        snprintf(out, STUDY_CELL_SIZE, "%.200s", row->run.name);
        text_whole(out);
        break;
    case STUDY_COLUMN_END:
        write_end(record, out);
        break;
    case STUDY_COLUMN_FRONT:
        snprintf(out, STUDY_CELL_SIZE, "%s", row->on_front ? "*" : "");
        break;
    case STUDY_COLUMN_PARTICLES:
        snprintf(out, STUDY_CELL_SIZE, "%" PRIu64, record->particles);
        break;
    case STUDY_COLUMN_STEPS:
        snprintf(out, STUDY_CELL_SIZE, "%" PRIu64, record->steps);
        break;
    case STUDY_COLUMN_CPU:
        study_cells_seconds(out, record->cpu);
        break;
    case STUDY_COLUMN_WALL:
        study_cells_seconds(out, record->wall);
        break;
    case STUDY_COLUMN_START:
        study_cells_seconds(out, record->start);
        break;
    case STUDY_COLUMN_PROBES:
        study_cells_seconds(out, record->probes);
        break;
    case STUDY_COLUMN_RATE:
        snprintf(out, STUDY_CELL_SIZE, "%s", isnan(study_rate(row)) ? "-" : text_count(rate, study_rate(row)));
        break;
    case STUDY_COLUMN_VALUE:
        write_number(out, "%.5g", v->value);
        break;
    case STUDY_COLUMN_ERROR:
        write_number(out, "%.3g", v->error);
        break;
    case STUDY_COLUMN_ORDER:
        write_number(out, "%.2f", v->order);
        break;
    }
}

/* ---- which columns ----------------------------------------------------------------------------------------------- */

/* Columns that say the same of every row are left out. */
static bool is_shown(const cli_study *s, study_column_kind kind)
{
    bool front = false, wall = false, eventful = false;
    for (size_t r = 0; r < s->row_count; ++r) {
        const study_row *row = &s->rows[r];
        front = front || row->on_front;
        wall = wall || (row->there && !isnan(row->record.wall));
        eventful = eventful || (row->there && (row->record.end != STUDY_FINISHED || row->record.left > 0));
    }
    return kind == STUDY_COLUMN_FRONT  ? front
           : kind == STUDY_COLUMN_WALL ? wall
           : kind == STUDY_COLUMN_END  ? eventful
                                       : true;
}

/* The columns of one kind after the other, those that say something. */
static size_t list_kinds(const cli_study *s, study_column *out, study_column_kind from, study_column_kind to)
{
    size_t count = 0;
    for (study_column_kind kind = from; kind <= to; ++kind)
        if (is_shown(s, kind))
            out[count++] = (study_column){kind, 0};
    return count;
}

static size_t list_measures(const cli_study *s, study_column *out)
{
    size_t count = 0;
    for (size_t i = 0; i < s->study->measure_count; ++i) {
        const sph2d_study_measure *m = &s->study->measures[i];
        if (study_has_value(m))
            out[count++] = (study_column){STUDY_COLUMN_VALUE, i};
        if (study_has_error(m))
            out[count++] = (study_column){STUDY_COLUMN_ERROR, i};
        if (m->order)
            out[count++] = (study_column){STUDY_COLUMN_ORDER, i};
    }
    return count;
}

/* What people look for comes first: the errors and what they cost. */
size_t study_cells_list(const cli_study *s, study_column *out)
{
    size_t count = list_kinds(s, out, STUDY_COLUMN_NAME, STUDY_COLUMN_CPU);
    count += list_measures(s, out + count);
    return count + list_kinds(s, out + count, STUDY_COLUMN_WALL, STUDY_COLUMN_RATE);
}

/* Words stand left, numbers right. */
bool study_cells_left(const study_column *c)
{
    return c->kind == STUDY_COLUMN_NAME || c->kind == STUDY_COLUMN_END || c->kind == STUDY_COLUMN_FRONT;
}
