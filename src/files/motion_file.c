/* SPDX-License-Identifier: MIT */
/** @file motion_file.c */
#include "files/motion_file.h"

#include <math.h>
#include <stdint.h>

#include "sph2d/io.h"

enum { T, X, Y, ANGLE, COLUMNS };
static const sph2d_table_column columns[COLUMNS] = {
    [T] = {"t", "s", false},
    [X] = {"x", "m", true},
    [Y] = {"y", "m", true},
    [ANGLE] = {"angle", "rad", true},
};

static double number(const sph2d_table *table, size_t row, size_t column)
{
    return sph2d_table_has(table, column) ? sph2d_table_value(table, row, column) : 0;
}

static sph2d_status fault(const sph2d_table *table, size_t row, const char *message, sph2d_report *report)
{
    sph2d_table_locate(table, row, sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_FIELD, NULL, "%s", message));
    return SPH2D_FORMAT;
}

static sph2d_status copy_rows(const sph2d_table *table, sph2d_motion *motion, sph2d__pool *pool, sph2d_report *report)
{
    size_t count = sph2d_table_rows(table);
    if (count == 0)
        return fault(table, 0, "this file has no rows", report);
    if (!sph2d_table_has(table, X) && !sph2d_table_has(table, Y) && !sph2d_table_has(table, ANGLE))
        return fault(table, 0, "a motion needs one of the columns x, y, angle", report);
    sph2d_pose_point *items = sph2d__pool_alloc(pool, count, sizeof *items);
    if (!items)
        return SPH2D_NOMEM;
    for (size_t row = 0; row < count; ++row) {
        const sph2d_pose_point p = {number(table, row, T), number(table, row, X), number(table, row, Y),
                                    number(table, row, ANGLE)};
        if (!isfinite(p.t + p.x + p.y + p.angle))
            return fault(table, row, "a row lacks a number", report);
        if (row > 0 && !(p.t > items[row - 1].t))
            return fault(table, row, "times must increase from row to row", report);
        items[row] = p;
    }
    motion->path = (sph2d_pose_path){items, count};
    return SPH2D_OK;
}

static sph2d_status read_motion(sph2d_motion *motion, const char *from, sph2d__pool *pool, sph2d_report *report)
{
    const char *path = sph2d__pool_join(pool, from, motion->file);
    if (!path)
        return SPH2D_NOMEM;
    sph2d_table *table;
    sph2d_status status = sph2d_table_read(path, columns, COLUMNS, &table, report);
    if (status == SPH2D_OK)
        status = copy_rows(table, motion, pool, report);
    sph2d_table_destroy(table);
    motion->file = NULL;
    if (motion->between == SPH2D_BETWEEN_DEFAULT)
        motion->between = SPH2D_BETWEEN_CUBIC;
    return status;
}

sph2d_status sph2d__motions_read(sph2d_scene *scene, const char *from, sph2d__pool *pool, sph2d_report *report)
{
    sph2d_status status = SPH2D_OK;
    if (scene->motion.file && scene->motion.path.count == 0)
        status = read_motion(&scene->motion, from, pool, report);
    for (size_t i = 0; status == SPH2D_OK && i < scene->obstacle_count; ++i) {
        /* the items were converted into the pool, which is writable */
        sph2d_motion *motion = (sph2d_motion *)(uintptr_t)&scene->obstacles[i].motion;
        if (motion->file && motion->path.count == 0) /* both: the check refuses them */
            status = read_motion(motion, from, pool, report);
    }
    return status;
}
