/* SPDX-License-Identifier: MIT */
/** @file history_file.c */
#include "files/history_file.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "files/table_rows.h"
#include "files/text.h"
#include "sph2d/io.h"

static const sph2d_table_column columns[1 + SPH2D__HISTORIES] = {
    {"t", "s", false},        {"velocity", "m/s", true}, {"flow_rate", "m^2/s", true},
    {"pressure", "Pa", true}, {"level", "m", true},
};

void sph2d__history_key(char key[64], size_t opening, size_t kind)
{
    snprintf(key, 64, "openings[%zu].history.%s", opening, columns[1 + kind].name);
}

/** The history of opening `i`: the scene's items were converted into the pool, which is writable. */
static sph2d_opening_history *history_of(sph2d_scene *scene, size_t i)
{
    return (sph2d_opening_history *)(uintptr_t)&scene->openings[i].history;
}

static sph2d_history *list_of(sph2d_opening_history *history, size_t kind)
{
    sph2d_history *lists[] = {&history->velocity, &history->flow_rate, &history->pressure, &history->level};
    return lists[kind];
}

/** Whether a file is to give a history; if there is a list too, the check refuses them. */
static bool is_wanted(sph2d_opening_history *history)
{
    size_t points = 0;
    for (size_t kind = 0; kind < SPH2D__HISTORIES; ++kind)
        points += list_of(history, kind)->count;
    return history->file && points == 0;
}

static void fill(sph2d_opening_history *history, size_t kind, const void *rows, size_t count)
{
    *list_of(history, kind) = (sph2d_history){rows, count};
    history->file = NULL;
}

/* ---- from files -------------------------------------------------------------------------------------------------- */

static sph2d_status copy_history(const sph2d_table *table, sph2d_opening_history *history, sph2d__pool *pool,
                                 sph2d_report *report)
{
    size_t which[2] = {0, 0}, given = 0;
    for (size_t column = 1; column <= SPH2D__HISTORIES; ++column)
        if (sph2d_table_has(table, column)) {
            which[1] = column;
            ++given;
        }
    if (given != 1)
        return sph2d__table_fault(
            table, 0, "an opening needs just one of the columns velocity, flow_rate, pressure, level", report);
    double *rows;
    sph2d_status status = sph2d__table_rows(table, columns, which, 2, NULL, pool, &rows, report);
    if (status == SPH2D_OK)
        fill(history, which[1] - 1, rows, sph2d_table_rows(table));
    return status;
}

static sph2d_status read_history(sph2d_opening_history *history, const char *key, const char *from, sph2d__pool *pool,
                                 sph2d_report *report)
{
    const char *path = sph2d__pool_join(pool, from, history->file);
    if (!path)
        return SPH2D_NOMEM;
    sph2d_table *table;
    size_t first = report ? report->count : 0;
    sph2d_status status = sph2d_table_read(path, columns, 1 + SPH2D__HISTORIES, &table, report);
    if (status == SPH2D_OK)
        status = copy_history(table, history, pool, report);
    sph2d__report_key(report, first, key);
    sph2d_table_destroy(table);
    return status;
}

sph2d_status sph2d__histories_read(sph2d_scene *scene, const char *from, sph2d__pool *pool, sph2d_report *report)
{
    sph2d_status status = SPH2D_OK;
    for (size_t i = 0; status == SPH2D_OK && i < scene->opening_count; ++i) {
        char key[64];
        snprintf(key, sizeof key, "openings[%zu].history.file", i);
        if (is_wanted(history_of(scene, i)))
            status = read_history(history_of(scene, i), key, from, pool, report);
    }
    return status;
}

/* ---- from a snapshot --------------------------------------------------------------------------------------------- */

static const sph2d__kept_path *find_kept(const sph2d__kept_path *paths, size_t count, size_t i, size_t kind)
{
    char key[64];
    sph2d__history_key(key, i, kind);
    for (size_t k = 0; k < count; ++k)
        if (strcmp(paths[k].key, key) == 0 && paths[k].width == 2 && paths[k].count > 0)
            return &paths[k];
    return NULL;
}

sph2d_status sph2d__histories_keep(sph2d_scene *scene, const sph2d__kept_path *paths, size_t count, sph2d__pool *pool)
{
    for (size_t i = 0; i < scene->opening_count; ++i)
        for (size_t kind = 0; kind < SPH2D__HISTORIES && is_wanted(history_of(scene, i)); ++kind) {
            const sph2d__kept_path *kept = find_kept(paths, count, i, kind);
            void *rows = kept ? sph2d__pool_alloc(pool, kept->count, 2 * sizeof(double)) : NULL;
            if (kept && !rows)
                return SPH2D_NOMEM;
            if (!kept)
                continue;
            memcpy(rows, kept->rows, kept->count * 2 * sizeof(double));
            fill(history_of(scene, i), kind, rows, kept->count);
        }
    return SPH2D_OK;
}
