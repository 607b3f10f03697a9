/* SPDX-License-Identifier: MIT */
/** @file study_record.c
 *  What a run of a row leaves behind, as text and back. */
#include "study_record.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include <sph2d/sim.h>

static const char head[] = "sph2d study row 1";

/* ---- growing ----------------------------------------------------------------------------------------------------- */

bool study_series_add(study_series *series, double time, const double *values)
{
    if (series->count == series->room) {
        size_t room = series->room > 0 ? 2 * series->room : 256;
        double *times = realloc(series->time, room * sizeof *times);
        if (times != NULL)
            series->time = times;
        double *larger = realloc(series->values, room * series->columns * sizeof *larger);
        if (larger != NULL)
            series->values = larger;
        if (times == NULL || larger == NULL)
            return false;
        series->room = room;
    }
    series->time[series->count] = time;
    memcpy(series->values + series->count * series->columns, values, series->columns * sizeof *values);
    ++series->count;
    return true;
}

study_samples *study_record_add_samples(study_record *record, size_t count)
{
    study_samples *grown = realloc(record->samples, (record->samples_count + 1) * sizeof *grown);
    if (grown == NULL)
        return NULL;
    record->samples = grown;
    study_samples *added = &grown[record->samples_count];
    *added = (study_samples){.count = count,
                             .along = malloc((count + 1) * sizeof *added->along),
                             .values = malloc((count + 1) * sizeof *added->values)};
    ++record->samples_count;
    return added->along != NULL && added->values != NULL ? added : NULL;
}

void study_record_free(study_record *record)
{
    for (size_t i = 0; i < record->series_count; ++i) {
        free(record->series[i].probe);
        free(record->series[i].headings);
        free(record->series[i].time);
        free(record->series[i].values);
    }
    for (size_t i = 0; i < record->samples_count; ++i) {
        free(record->samples[i].along);
        free(record->samples[i].values);
    }
    free(record->series);
    free(record->samples);
    *record = (study_record){0};
}

/* ---- writing ----------------------------------------------------------------------------------------------------- */

/* A text of one line. */
static void put_line(FILE *out, const char *name, const char *text)
{
    fprintf(out, "%s ", name);
    for (; *text != '\0'; ++text)
        putc((unsigned char)*text < 0x20 ? ' ' : *text, out);
    putc('\n', out);
}

static void put_numbers(FILE *out, const double *values, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        fprintf(out, "%s%.17g", i > 0 ? " " : "", values[i]);
    putc('\n', out);
}

void study_record_write(const study_record *record, FILE *out)
{
    fprintf(out, "%s\nend %d %d\n", head, (int)record->end, record->code);
    put_line(out, "reason", record->reason);
    put_line(out, "isa", record->isa);
    fprintf(out, "counts %" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64 " %" PRIu64 "\n", record->particles,
            record->left, record->steps, record->particle_steps, record->repeats);
    const double numbers[] = {record->spacing, record->time, record->cpu, record->wall, record->start, record->probes};
    fprintf(out, "numbers ");
    put_numbers(out, numbers, sizeof numbers / sizeof *numbers);
    fprintf(out, "summary ");
    put_numbers(out, record->summary, SPH2D_SUMMARY_VALUES);
    for (size_t i = 0; i < record->series_count; ++i) {
        const study_series *s = &record->series[i];
        fprintf(out, "series %zu %zu\n", s->columns, s->count);
        put_line(out, "probe", s->probe);
        put_line(out, "headings", s->headings);
        for (size_t k = 0; k < s->count; ++k) {
            fprintf(out, "%.17g ", s->time[k]);
            put_numbers(out, s->values + k * s->columns, s->columns);
        }
    }
    for (size_t i = 0; i < record->samples_count; ++i) {
        const study_samples *s = &record->samples[i];
        fprintf(out, "samples %d %zu\n", (int)s->quantity, s->count);
        put_numbers(out, (const double[]){s->ends[0].x, s->ends[0].y, s->ends[1].x, s->ends[1].y}, 4);
        put_numbers(out, s->along, s->count);
        put_numbers(out, s->values, s->count);
    }
    fputs("whole\n", out);
}

/* ---- reading ----------------------------------------------------------------------------------------------------- */

/* Text that is taken word by word. */
typedef struct reader {
    const char *rest;
    bool ok;
} reader;

/* Takes `word` and the blank or newline behind it, if that is what comes next. */
static bool takes(reader *r, const char *word)
{
    size_t length = strlen(word);
    bool next = r->ok && strncmp(r->rest, word, length) == 0 && (r->rest[length] == ' ' || r->rest[length] == '\n');
    if (next)
        r->rest += length + 1;
    return next;
}

static void take(reader *r, const char *word)
{
    r->ok = takes(r, word);
}

static double take_number(reader *r)
{
    char *end = NULL;
    double value = r->ok ? strtod(r->rest, &end) : 0;
    r->ok = r->ok && end != r->rest && (*end == ' ' || *end == '\n');
    if (r->ok)
        r->rest = end + 1;
    return value;
}

static uint64_t take_count(reader *r)
{
    char *end = NULL;
    uint64_t value = r->ok ? strtoull(r->rest, &end, 10) : 0;
    r->ok = r->ok && end != r->rest && (*end == ' ' || *end == '\n');
    if (r->ok)
        r->rest = end + 1;
    return value;
}

static void take_numbers(reader *r, double *values, size_t count)
{
    for (size_t i = 0; i < count && r->ok; ++i)
        values[i] = take_number(r);
    if (count == 0) /* an empty line */
        r->ok = r->ok && *r->rest++ == '\n';
}

/* The rest of a line, without its end; the caller frees it. */
static char *take_line(reader *r, const char *word)
{
    take(r, word);
    if (!r->ok)
        return NULL;
    size_t length = strcspn(r->rest, "\n");
    char *line = strndup(r->rest, length);
    r->ok = line != NULL && r->rest[length] == '\n';
    r->rest += length + (r->rest[length] == '\n');
    return line;
}

static void take_text(reader *r, const char *word, char *out, size_t size)
{
    char *line = take_line(r, word);
    if (line != NULL)
        snprintf(out, size, "%s", line);
    free(line);
}

/* No line of a record is shorter than a byte a number, so that a damaged count cannot ask for the whole memory. */
static bool can_hold(reader *r, uint64_t count, uint64_t width)
{
    uint64_t left = strlen(r->rest);
    r->ok = r->ok && width > 0 && width <= SPH2D_PROBE_MAX_COLUMNS + 1 && count <= left / width;
    return r->ok;
}

static void take_series(reader *r, study_record *record)
{
    study_series *grown = realloc(record->series, (record->series_count + 1) * sizeof *grown);
    r->ok = r->ok && grown != NULL;
    if (grown == NULL)
        return;
    record->series = grown;
    study_series *s = &grown[record->series_count++];
    *s = (study_series){.columns = take_count(r)};
    uint64_t count = take_count(r);
    s->probe = take_line(r, "probe");
    s->headings = take_line(r, "headings");
    if (!can_hold(r, count, s->columns + 1))
        return;
    s->room = count;
    s->time = malloc((count + 1) * sizeof *s->time);
    s->values = malloc((count + 1) * s->columns * sizeof *s->values);
    r->ok = s->time != NULL && s->values != NULL;
    for (; r->ok && s->count < count; ++s->count) {
        s->time[s->count] = take_number(r);
        take_numbers(r, s->values + s->count * s->columns, s->columns);
    }
}

static void take_samples(reader *r, study_record *record)
{
    sph2d_quantity quantity = (sph2d_quantity)take_count(r);
    uint64_t count = take_count(r);
    study_samples *s = can_hold(r, count, 2) ? study_record_add_samples(record, count) : NULL;
    r->ok = s != NULL;
    if (s == NULL)
        return;
    double ends[4] = {0};
    take_numbers(r, ends, 4);
    s->quantity = quantity;
    s->ends[0] = (sph2d_vec2){ends[0], ends[1]};
    s->ends[1] = (sph2d_vec2){ends[2], ends[3]};
    take_numbers(r, s->along, count);
    take_numbers(r, s->values, count);
}

bool study_record_read(study_record *record, const char *text)
{
    reader r = {text, true};
    double numbers[6] = {0};
    take(&r, head);
    take(&r, "end");
    uint64_t end = take_count(&r);
    record->end = end <= STUDY_DIED ? (study_end)end : STUDY_DIED;
    record->code = (int)take_count(&r);
    take_text(&r, "reason", record->reason, sizeof record->reason);
    take_text(&r, "isa", record->isa, sizeof record->isa);
    take(&r, "counts");
    uint64_t *const counts[] = {&record->particles, &record->left, &record->steps, &record->particle_steps,
                                &record->repeats};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; ++i)
        *counts[i] = take_count(&r);
    take(&r, "numbers");
    take_numbers(&r, numbers, 6);
    take(&r, "summary");
    take_numbers(&r, record->summary, SPH2D_SUMMARY_VALUES);
    record->spacing = numbers[0];
    record->time = numbers[1];
    record->cpu = numbers[2];
    record->wall = numbers[3];
    record->start = numbers[4];
    record->probes = numbers[5];
    while (takes(&r, "series"))
        take_series(&r, record);
    while (takes(&r, "samples"))
        take_samples(&r, record);
    return takes(&r, "whole") && *r.rest == '\0' && end <= STUDY_DIED;
}
