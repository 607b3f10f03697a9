/* SPDX-License-Identifier: MIT */
/** @file json.c
 *  The rows of a study as one JSON object. */
#include "../json.h"

#include <math.h>

#include "../build.h"
#include "columns.h"
#include "parts.h"

static void add_measure(cli_json *line, const sph2d_study_measure *m, const sph2d_study_value *v)
{
    json_open_object(line, NULL);
    json_text(line, "name", m->name);
    if (sph2d_study_has_value(m))
        json_number(line, "value", v->value);
    if (m->expectation == SPH2D_EXPECT_NUMBER)
        json_number(line, "expect", m->expect);
    if (sph2d_study_has_error(m)) {
        json_flag(line, "relative", m->relative != 0);
        json_number(line, "error", v->error);
    }
    if (!isnan(m->bound))
        json_number(line, "bound", m->bound);
    if (m->order)
        json_number(line, "order", v->order);
    json_close_object(line);
}

static void add_field(cli_json *line, const sph2d_study_row *row, const study_column *c)
{
    const void *field = study_field(row, c);
    if (c->form == STUDY_NAME)
        json_text(line, c->json, *(const char *const *)field);
    else if (c->form == STUDY_TEXT && (row->record.end != SPH2D_STUDY_FINISHED || *(const char *)field != '\0'))
        json_text(line, c->json, field); /* one that finished has no reason */
    else if (c->form == STUDY_END)
        json_text(line, c->json, study_end_name(row->record.end));
    else if (c->form == STUDY_FLAG)
        json_flag(line, c->json, *(const bool *)field);
    else if (c->form == STUDY_COUNT)
        json_count(line, c->json, *(const uint64_t *)field);
    else if (c->form > STUDY_COUNT)
        json_number(line, c->json, study_number(row, c));
}

static void add_row(cli_json *line, const cli_study *s, const sph2d_study_row *row)
{
    json_open_object(line, NULL);
    for (size_t i = 0; i < study_column_count; ++i)
        add_field(line, row, &study_columns[i]);
    json_open_object(line, "set");
    for (size_t i = 0; i < row->run.override_count; ++i)
        json_text(line, row->run.overrides[i].path, row->run.overrides[i].value);
    json_close_object(line);
    json_open_array(line, "measures");
    for (size_t i = 0; i < s->study->measure_count; ++i)
        add_measure(line, &s->study->measures[i], &row->values[i]);
    json_close_array(line);
    json_close_object(line);
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
    json_text(&line, "device", device_name(&s->device));
    json_count(&line, "jobs", s->jobs);
    json_count(&line, "rows_by_shards", s->by_shards);
    json_text(&line, "processor", build_processor(processor, sizeof processor));
    json_text(&line, "compiler", build_compiler);
    json_text(&line, "flags", build_flags);
    json_text(&line, "commit", build_commit);
    json_open_array(&line, "rows");
    STUDY_FOR_ROWS (s, row)
        add_row(&line, s, row);
    json_close_array(&line);
    size_t judge = s->results->judge; /* and the cheapest row for the wanted error, null when none is good enough */
    const sph2d_study_row *cheapest = sph2d_study_cheapest(s->results, s->target);
    json_text(&line, "judge", judge < s->study->measure_count ? s->study->measures[judge].name : NULL);
    json_number(&line, "target", s->target);
    json_text(&line, "cheapest", cheapest ? cheapest->run.name : NULL);
    json_end(&line);
}
