/* SPDX-License-Identifier: MIT */
/** @file history_file.c */
#include "files/history_file.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files/table_rows.h"
#include "files/text.h"
#include "sph2d/io.h"

enum { TIME, VELOCITY, X = 1 + SPH2D__HISTORIES, Y, COLUMNS };
static const sph2d_table_column columns[COLUMNS] = {
    [TIME] = {"t", "s", true},    [VELOCITY] = {"velocity", "m/s", true},
    {"flow_rate", "m^2/s", true}, {"pressure", "Pa", true},
    {"level", "m", true},         [X] = {"x", "m", true},
    [Y] = {"y", "m", true},
};

void sph2d__history_key(char key[64], size_t opening, size_t kind)
{
    snprintf(key, 64, "openings[%zu].history.%s", opening,
             kind < SPH2D__HISTORIES ? columns[1 + kind].name : "profile");
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
    size_t points = history->profile.count;
    for (size_t kind = 0; kind < SPH2D__HISTORIES; ++kind)
        points += list_of(history, kind)->count;
    return history->file && points == 0;
}

static void fill(sph2d_opening_history *history, size_t kind, const void *rows, size_t count)
{
    if (kind == SPH2D__HISTORIES)
        history->profile = (sph2d_path){rows, count};
    else
        *list_of(history, kind) = (sph2d_history){rows, count};
    history->file = NULL;
}

/* ---- velocity over place, from files ----------------------------------------------------------------------------- */

/** A row of a table of places. */
typedef struct spot {
    sph2d_path_point at;
    size_t row;
} spot;

static int by_time_and_place(const void *a, const void *b)
{
    const spot *p = a, *q = b;
    if (p->at.t != q->at.t)
        return p->at.t < q->at.t ? -1 : 1;
    if (p->at.x != q->at.x)
        return p->at.x < q->at.x ? -1 : 1;
    return (p->row > q->row) - (p->row < q->row);
}

/** Checks that sorted rows have each place once, and the same places at each time. */
static sph2d_status check_places(const sph2d_table *table, const spot *spots, size_t count, sph2d_report *report)
{
    size_t places = 1;
    while (places < count && spots[places].at.t == spots[0].at.t)
        ++places;
    for (size_t k = 1; k < count; ++k) {
        const sph2d_path_point *p = &spots[k].at, *before = &spots[k - 1].at;
        bool twice = p->t == before->t && p->x == before->x;
        bool here = p->x == spots[k % places].at.x && (p->t > before->t) == (k % places == 0);
        if (!twice && here && (k + 1 < count || (k + 1) % places == 0))
            continue;
        char message[160];
        if (twice)
            snprintf(message, sizeof message, "the place %g is given twice at t = %g", p->x, p->t);
        else
            snprintf(message, sizeof message, "the places at t = %g are not those at t = %g", p->t, spots[0].at.t);
        return sph2d__table_fault(table, spots[k].row, message, report);
    }
    return SPH2D_OK;
}

/** Takes rows of places in any order; without times all are of one. */
static sph2d_status copy_places(const sph2d_table *table, size_t along, sph2d_opening_history *history,
                                sph2d__pool *pool, sph2d_report *report)
{
    const size_t which[] = {TIME, along, VELOCITY};
    size_t count = sph2d_table_rows(table);
    if (count == 0)
        return sph2d__table_fault(table, 0, "this file has no rows", report);
    spot *spots = sph2d__pool_alloc(pool, count, sizeof *spots);
    sph2d_path_point *points = sph2d__pool_alloc(pool, count, sizeof *points);
    if (!spots || !points)
        return SPH2D_NOMEM;
    for (size_t row = 0; row < count; ++row) {
        double values[3];
        for (int k = 0; k < 3; ++k) {
            values[k] = sph2d_table_has(table, which[k]) ? sph2d_table_value(table, row, which[k]) : 0;
            char message[80];
            snprintf(message, sizeof message, "this row lacks a number: its column '%s' is empty or nan",
                     columns[which[k]].name);
            if (!isfinite(values[k]))
                return sph2d__table_fault(table, row, message, report);
        }
        spots[row] = (spot){{values[0], values[1], values[2]}, row};
    }
    qsort(spots, count, sizeof *spots, by_time_and_place);
    for (size_t k = 0; k < count; ++k)
        points[k] = spots[k].at;
    sph2d_status status = check_places(table, spots, count, report);
    if (status == SPH2D_OK)
        fill(history, SPH2D__HISTORIES, points, count);
    return status;
}

/* ---- from files -------------------------------------------------------------------------------------------------- */

static sph2d_status copy_history(const sph2d_table *table, sph2d_opening_history *history, bool vertical,
                                 sph2d__pool *pool, sph2d_report *report)
{
    size_t which[2] = {TIME, 0}, given = 0, along = vertical ? Y : X;
    for (size_t column = 1; column <= SPH2D__HISTORIES; ++column)
        if (sph2d_table_has(table, column)) {
            which[1] = column;
            ++given;
        }
    if (given != 1)
        return sph2d__table_fault(
            table, 0, "an opening needs just one of the columns velocity, flow_rate, pressure, level", report);
    if (which[1] == VELOCITY && sph2d_table_has(table, along))
        return copy_places(table, along, history, pool, report);
    if (!sph2d_table_has(table, TIME)) {
        char message[100];
        snprintf(message, sizeof message, "there is no column 't', nor '%s' with a velocity over places",
                 columns[along].name);
        return sph2d__table_fault(table, 0, message, report);
    }
    double *rows;
    sph2d_status status = sph2d__table_rows(table, columns, which, 2, NULL, pool, &rows, report);
    if (status == SPH2D_OK)
        fill(history, which[1] - 1, rows, sph2d_table_rows(table));
    return status;
}

static sph2d_status read_history(sph2d_opening_history *history, bool vertical, const char *key, const char *from,
                                 sph2d__pool *pool, sph2d_report *report)
{
    const char *path = sph2d__pool_join(pool, from, history->file);
    if (!path)
        return SPH2D_NOMEM;
    sph2d_table *table;
    size_t first = report ? report->count : 0;
    sph2d_status status = sph2d_table_read(path, columns, COLUMNS, &table, report);
    if (status == SPH2D_OK)
        status = copy_history(table, history, vertical, pool, report);
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
        bool vertical =
            scene->openings[i].side == SPH2D_SIDE_NAME_LEFT || scene->openings[i].side == SPH2D_SIDE_NAME_RIGHT;
        if (is_wanted(history_of(scene, i)))
            status = read_history(history_of(scene, i), vertical, key, from, pool, report);
    }
    return status;
}

/* ---- from a snapshot --------------------------------------------------------------------------------------------- */

/** Numbers in a row of a kind. */
static size_t width_of(size_t kind)
{
    return kind == SPH2D__HISTORIES ? 3 : 2;
}

static const sph2d__kept_path *find_kept(const sph2d__kept_path *paths, size_t count, size_t i, size_t kind)
{
    char key[64];
    sph2d__history_key(key, i, kind);
    for (size_t k = 0; k < count; ++k)
        if (strcmp(paths[k].key, key) == 0 && paths[k].width == width_of(kind) && paths[k].count > 0)
            return &paths[k];
    return NULL;
}

sph2d_status sph2d__histories_keep(sph2d_scene *scene, const sph2d__kept_path *paths, size_t count, sph2d__pool *pool)
{
    for (size_t i = 0; i < scene->opening_count; ++i)
        for (size_t kind = 0; kind <= SPH2D__HISTORIES && is_wanted(history_of(scene, i)); ++kind) {
            const sph2d__kept_path *kept = find_kept(paths, count, i, kind);
            size_t size = width_of(kind) * sizeof(double);
            void *rows = kept ? sph2d__pool_alloc(pool, kept->count, size) : NULL;
            if (kept && !rows)
                return SPH2D_NOMEM;
            if (!kept)
                continue;
            memcpy(rows, kept->rows, kept->count * size);
            fill(history_of(scene, i), kind, rows, kept->count);
        }
    return SPH2D_OK;
}
