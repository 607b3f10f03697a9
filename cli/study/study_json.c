/* SPDX-License-Identifier: MIT */
/** @file study_json.c
 *  The rows of a study as one JSON object. */
#include <math.h>

#include "../json.h"
#include "study_table.h"

static void add_measure(cli_json *line, const sph2d_study_measure *m, const study_value *v)
{
    json_open_object(line, NULL);
    json_text(line, "name", m->name);
    if (study_has_value(m))
        json_number(line, "value", v->value);
    if (m->expectation == SPH2D_EXPECT_NUMBER)
        json_number(line, "expect", m->expect);
    if (study_has_error(m)) {
        json_flag(line, "relative", m->relative != 0);
        json_number(line, "error", v->error);
    }
    if (!isnan(m->bound))
        json_number(line, "bound", m->bound);
    if (m->order)
        json_number(line, "order", v->order);
    json_close_object(line);
}

static void add_overrides(cli_json *line, const sph2d_study_run *run)
{
    json_open_object(line, "set");
    for (size_t i = 0; i < run->override_count; ++i)
        json_text(line, run->overrides[i].path, run->overrides[i].value);
    json_close_object(line);
}

static void add_row(cli_json *line, const cli_study *s, const study_row *row)
{
    json_open_object(line, NULL);
    json_count(line, "row", row->number);
    json_text(line, "name", row->run->name);
    add_overrides(line, row->run);
    json_text(line, "end", study_end_name(row->end));
    if (row->end != STUDY_FINISHED)
        json_text(line, "reason", row->reason);
    json_number(line, "spacing", row->spacing);
    json_count(line, "particles", row->particles);
    json_number(line, "time", row->time);
    json_count(line, "steps", row->steps);
    json_count(line, "particle_steps", row->particle_steps);
    json_number(line, "step_cpu_seconds", row->cpu);
    json_number(line, "step_seconds", row->wall);
    json_number(line, "particle_steps_per_second", study_rate(row));
    json_open_array(line, "measures");
    for (size_t i = 0; i < s->study->measure_count; ++i)
        add_measure(line, &s->study->measures[i], &row->values[i]);
    json_close_array(line);
    json_close_object(line);
}

void study_json_print(const cli_study *s, const char *end, bool passed)
{
    cli_json line = json_begin(stdout);
    json_text(&line, "study", s->path);
    json_text(&line, "scene", s->study->scene);
    json_text(&line, "end", end);
    json_flag(&line, "passed", passed);
    json_count(&line, "threads", (uint64_t)s->threads.count);
    json_text(&line, "threads_from", s->threads.source);
    json_text(&line, "isa", s->isa);
    json_open_array(&line, "rows");
    for (size_t r = 0; r < s->row_count; ++r)
        add_row(&line, s, &s->rows[r]);
    json_close_array(&line);
    json_end(&line);
}
