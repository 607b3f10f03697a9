/* SPDX-License-Identifier: MIT */
/** @file study_json.c
 *  The rows of a study as one JSON object. */
#include <math.h>

#include "../build.h"
#include "../json.h"
#include "study_cells.h"
#include "study_front.h"
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
    const study_record *record = &row->record;
    json_text(line, "name", row->run.name);
    add_overrides(line, &row->run);
    json_text(line, "end", study_end_name(record->end));
    if (record->end != STUDY_FINISHED)
        json_text(line, "reason", record->reason);
    json_flag(line, "front", row->on_front);
    json_number(line, "spacing", record->spacing);
    json_count(line, "particles", record->particles);
    json_count(line, "left", record->left);
    json_number(line, "time", record->time);
    json_count(line, "steps", record->steps);
    json_count(line, "particle_steps", record->particle_steps);
    json_count(line, "repeats", record->repeats);
    json_number(line, "step_cpu_seconds", record->cpu);
    json_number(line, "step_seconds", record->wall);
    json_number(line, "start_cpu_seconds", record->start);
    json_number(line, "probes_cpu_seconds", record->probes);
    json_text(line, "isa", record->isa);
    json_number(line, "particle_steps_per_second", study_rate(row));
    json_open_array(line, "measures");
    for (size_t i = 0; i < s->study->measure_count; ++i)
        add_measure(line, &s->study->measures[i], &row->values[i]);
    json_close_array(line);
    json_close_object(line);
}

/* The cheapest row for the wanted error, null when none is good enough. */
static void add_verdict(cli_json *line, const cli_study *s)
{
    const study_row *row = study_front_cheapest(s, s->target);
    bool judged = s->judge < s->study->measure_count;
    json_text(line, "judge", judged ? s->study->measures[s->judge].name : NULL);
    json_number(line, "target", s->target);
    json_text(line, "cheapest", row != NULL ? row->run.name : NULL);
}

void study_json_print(const cli_study *s, const char *end, bool passed)
{
    char processor[256];
    cli_json line = json_begin(stdout);
    json_text(&line, "study", s->path);
    json_text(&line, "scene", s->study->scene);
    json_text(&line, "end", end);
    json_flag(&line, "passed", passed);
    json_count(&line, "threads", (uint64_t)s->threads.count);
    json_text(&line, "threads_from", s->threads.source);
    json_count(&line, "jobs", s->jobs);
    json_text(&line, "processor", build_processor(processor, sizeof processor));
    json_text(&line, "compiler", build_compiler);
    json_text(&line, "flags", build_flags);
    json_text(&line, "commit", build_commit);
    json_open_array(&line, "rows");
    for (size_t r = 0; r < s->row_count; ++r)
        if (s->rows[r].there)
            add_row(&line, s, &s->rows[r]);
    json_close_array(&line);
    add_verdict(&line, s);
    json_end(&line);
}
