/* SPDX-License-Identifier: MIT */
/** @file record.c
 *  Serialises the record of a row: a head, the struct, then each series and its numbers, all in their memory layout. */
#include "study/parts.h"

#include <stdlib.h>
#include <string.h>

#include "base/random.h"

/** The head of a block, with length and checksum of the rest. */
typedef struct head {
    char mark[16];
    uint64_t size, checksum;
} head;

static const char mark[16] = "sph2d row 2";

/* ---- making ------------------------------------------------------------------------------------------------------ */

sph2d_study_series *sph2d__record_add(sph2d_study_record *record, size_t columns, size_t room)
{
    sph2d_study_series *grown = realloc(record->series, (record->series_count + 1) * sizeof *grown);
    if (!grown)
        return NULL;
    record->series = grown;
    sph2d_study_series *added = &grown[record->series_count];
    memset(added, 0, sizeof *added);
    added->columns = columns;
    added->room = room;
    added->rows = malloc((room + 1) * (columns + 1) * sizeof *added->rows);
    record->series_count += added->rows != NULL;
    return added->rows ? added : NULL;
}

bool sph2d__series_add(sph2d_study_series *series, double x, const double *values)
{
    size_t width = series->columns + 1;
    if (series->count == series->room) {
        size_t room = 2 * series->room + 256;
        double *grown = realloc(series->rows, room * width * sizeof *grown);
        if (!grown)
            return false;
        series->rows = grown;
        series->room = room;
    }
    double *row = series->rows + width * series->count++;
    row[0] = x;
    memcpy(row + 1, values, series->columns * sizeof *values);
    return true;
}

void sph2d_study_record_free(sph2d_study_record *record)
{
    if (!record)
        return;
    for (size_t i = 0; i < record->series_count; ++i)
        free(record->series[i].rows);
    free(record->series);
    *record = (sph2d_study_record){0};
}

/* ---- writing ----------------------------------------------------------------------------------------------------- */

/** A block being written: bytes that do not fit are only counted. */
typedef struct writer {
    char *out;
    size_t size, used;
} writer;

static void put(writer *w, const void *bytes, size_t count)
{
    size_t room = w->used < w->size ? w->size - w->used : 0;
    if (room > 0 && count > 0)
        memcpy(w->out + w->used, bytes, count < room ? count : room);
    w->used += count;
}

size_t sph2d_study_record_pack(const sph2d_study_record *record, void *out, size_t size)
{
    if (!record)
        return 0;
    if (!out)
        size = 0;
    writer w = {out, size, sizeof(head)};
    sph2d_study_record copy = *record;
    copy.series = NULL; /* a pointer means nothing there */
    put(&w, &copy, sizeof copy);
    for (size_t i = 0; i < record->series_count; ++i) {
        sph2d_study_series series = record->series[i];
        series.rows = NULL;
        series.room = series.count;
        put(&w, &series, sizeof series);
        put(&w, record->series[i].rows, series.count * (series.columns + 1) * sizeof(double));
    }
    if (out && w.used <= size) {
        head h = {.size = w.used - sizeof h};
        memcpy(h.mark, mark, sizeof mark);
        h.checksum = sph2d__hash(SPH2D__HASH_START, w.out + sizeof h, h.size);
        memcpy(w.out, &h, sizeof h);
    }
    return w.used;
}

/* ---- reading ----------------------------------------------------------------------------------------------------- */

/** The rest of a block being read. */
typedef struct reader {
    const char *rest;
    size_t left;
} reader;

static bool take(reader *r, void *out, size_t size)
{
    if (size > r->left)
        return false;
    memcpy(out, r->rest, size);
    r->rest += size;
    r->left -= size;
    return true;
}

/** Reads one series. No memory is allocated for a count that the block cannot hold. */
static sph2d_status take_series(reader *r, sph2d_study_record *record)
{
    sph2d_study_series s;
    if (!take(r, &s, sizeof s) || s.columns < 1 || s.columns > SPH2D_PROBE_MAX_COLUMNS ||
        s.count > r->left / sizeof(double) / (s.columns + 1))
        return SPH2D_FORMAT;
    sph2d_study_series *added = sph2d__record_add(record, s.columns, s.count);
    if (!added)
        return SPH2D_NOMEM;
    s.rows = added->rows;
    s.room = s.count;
    s.probe[sizeof s.probe - 1] = '\0';
    *added = s;
    take(r, s.rows, s.count * (s.columns + 1) * sizeof *s.rows);
    return SPH2D_OK;
}

sph2d_status sph2d_study_record_unpack(sph2d_study_record *record, const void *block, size_t size)
{
    if (!record || (!block && size > 0))
        return SPH2D_INVALID;
    reader r = {block, size};
    head h;
    sph2d_study_record copy;
    if (!take(&r, &h, sizeof h) || memcmp(h.mark, mark, sizeof mark) != 0 || h.size != r.left ||
        h.checksum != sph2d__hash(SPH2D__HASH_START, r.rest, r.left) || !take(&r, &copy, sizeof copy) ||
        (unsigned)copy.end > SPH2D_STUDY_DIED)
        return SPH2D_FORMAT;
    size_t count = copy.series_count;
    copy.series = NULL;
    copy.series_count = 0;
    copy.reason[sizeof copy.reason - 1] = copy.isa[sizeof copy.isa - 1] = '\0';
    *record = copy;
    sph2d_status status = SPH2D_OK;
    for (size_t i = 0; i < count && status == SPH2D_OK; ++i)
        status = take_series(&r, record);
    if (status == SPH2D_OK && r.left > 0)
        status = SPH2D_FORMAT;
    if (status != SPH2D_OK)
        sph2d_study_record_free(record);
    return status;
}
