/* SPDX-License-Identifier: MIT */
/** @file motion_file.c */
#include "files/motion_file.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "files/table_rows.h"
#include "files/text.h"
#include "sph2d/io.h"

/** What a file is about: its columns, time first, of which one more must be there. */
typedef struct path_kind {
    sph2d_table_column columns[4];
    size_t width; /**< number of columns */
    const char *lacks_columns;
} path_kind;

static const path_kind motion_kind = {
    {{"t", "s", false}, {"x", "m", true}, {"y", "m", true}, {"angle", "rad", true}},
    4,
    "a motion needs one of the columns x, y, angle",
};
static const path_kind gravity_kind = {
    {{"t", "s", false}, {"gx", "m/s^2", true}, {"gy", "m/s^2", true}},
    3,
    "gravity in time needs one of the columns gx, gy",
};

/** A path that a file gives: where the scene names the file, and where the rows go. */
typedef struct path_slot {
    const path_kind *kind;
    char key[64]; /**< of the rows */
    char file_key[64];
    const char **file;
    void *items; /**< the pointer to them */
    size_t *count;
    double otherwise[4]; /**< the numbers of columns that are not there */
    sph2d_between *between;
} path_slot;

static path_slot slot_of_motion(sph2d_motion *motion, size_t i)
{
    path_slot slot = {.kind = &motion_kind,
                      .key = "motion.path",
                      .file_key = "motion.file",
                      .file = &motion->file,
                      .items = &motion->path.items,
                      .count = &motion->path.count,
                      .between = &motion->between};
    if (i < SIZE_MAX) {
        snprintf(slot.key, sizeof slot.key, "obstacles[%zu].motion.path", i);
        snprintf(slot.file_key, sizeof slot.file_key, "obstacles[%zu].motion.file", i);
    }
    return slot;
}

/** Slot number `k`: gravity, the tank, and the obstacles. */
static path_slot slot_of(sph2d_scene *scene, size_t k)
{
    if (k == 0)
        return (path_slot){.kind = &gravity_kind,
                           .key = "gravity_path",
                           .file_key = "gravity_file",
                           .file = &scene->gravity_file,
                           .items = &scene->gravity_path.items,
                           .count = &scene->gravity_path.count,
                           .otherwise = {0, scene->gravity.x, scene->gravity.y}};
    if (k == 1)
        return slot_of_motion(&scene->motion, SIZE_MAX);
    /* the items were converted into the pool, which is writable */
    return slot_of_motion((sph2d_motion *)(uintptr_t)&scene->obstacles[k - 2].motion, k - 2);
}

/** Whether a file is to give the path; if there is one too, the check refuses them. */
static bool is_wanted(const path_slot *slot)
{
    return *slot->file && *slot->count == 0;
}

static void fill(const path_slot *slot, const void *rows, size_t count)
{
    memcpy(slot->items, &rows, sizeof rows);
    *slot->count = count;
    *slot->file = NULL;
    if (slot->between && *slot->between == SPH2D_BETWEEN_DEFAULT)
        *slot->between = SPH2D_BETWEEN_CUBIC;
}

/* ---- from files -------------------------------------------------------------------------------------------------- */

static sph2d_status copy_rows(const sph2d_table *table, const path_slot *slot, sph2d__pool *pool, sph2d_report *report)
{
    static const size_t all[] = {0, 1, 2, 3};
    size_t width = slot->kind->width, given = 0;
    for (size_t column = 1; column < width; ++column)
        given += sph2d_table_has(table, column);
    if (given == 0)
        return sph2d__table_fault(table, 0, slot->kind->lacks_columns, report);
    double *rows;
    sph2d_status status =
        sph2d__table_rows(table, slot->kind->columns, all, width, slot->otherwise, pool, &rows, report);
    if (status == SPH2D_OK)
        fill(slot, rows, sph2d_table_rows(table));
    return status;
}

static sph2d_status read_path(const path_slot *slot, const char *from, sph2d__pool *pool, sph2d_report *report)
{
    const char *path = sph2d__pool_join(pool, from, *slot->file);
    if (!path)
        return SPH2D_NOMEM;
    sph2d_table *table;
    size_t first = report ? report->count : 0;
    sph2d_status status = sph2d_table_read(path, slot->kind->columns, slot->kind->width, &table, report);
    if (status == SPH2D_OK)
        status = copy_rows(table, slot, pool, report);
    sph2d__report_key(report, first, slot->file_key);
    sph2d_table_destroy(table);
    return status;
}

sph2d_status sph2d__motions_read(sph2d_scene *scene, const char *from, sph2d__pool *pool, sph2d_report *report)
{
    sph2d_status status = SPH2D_OK;
    for (size_t k = 0; status == SPH2D_OK && k < scene->obstacle_count + 2; ++k) {
        path_slot slot = slot_of(scene, k);
        if (is_wanted(&slot))
            status = read_path(&slot, from, pool, report);
    }
    return status;
}

/* ---- from a snapshot --------------------------------------------------------------------------------------------- */

sph2d_status sph2d__motions_keep(sph2d_scene *scene, const sph2d__kept_path *paths, size_t count, sph2d__pool *pool)
{
    for (size_t k = 0; k < scene->obstacle_count + 2; ++k) {
        path_slot slot = slot_of(scene, k);
        for (size_t i = 0; i < count && is_wanted(&slot); ++i) {
            const sph2d__kept_path *p = &paths[i];
            if (strcmp(p->key, slot.key) != 0 || p->width != slot.kind->width || p->count == 0)
                continue;
            void *rows = sph2d__pool_alloc(pool, p->count, p->width * sizeof(double));
            if (!rows)
                return SPH2D_NOMEM;
            memcpy(rows, p->rows, p->count * p->width * sizeof(double));
            fill(&slot, rows, p->count);
        }
    }
    return SPH2D_OK;
}
