/* SPDX-License-Identifier: MIT */
/** @file particles_file.c
 *  Reads the single particles of a scene from a CSV file. */
#include "files/particles_file.h"

#include <math.h>
#include <stdio.h>

#include "files/text.h"
#include "sph2d/io.h"

enum { X, Y, VX, VY, DENSITY, COLUMNS };
static const sph2d_table_column columns[COLUMNS] = {
    [X] = {"x", "m", false},
    [Y] = {"y", "m", false},
    [VX] = {"vx", "m/s", true},
    [VY] = {"vy", "m/s", true},
    [DENSITY] = {"density", "kg/m^3", true},
};

/** A number of a row, or a default if the file has no such column. */
static double number(const sph2d_table *table, size_t row, size_t column, double default_value)
{
    return sph2d_table_has(table, column) ? sph2d_table_value(table, row, column) : default_value;
}

/** The column of which a row has no number; COLUMNS if it has all. */
static size_t lacking(const sph2d_table *table, size_t row)
{
    size_t column = 0;
    while (column < COLUMNS && !(sph2d_table_has(table, column) && isnan(sph2d_table_value(table, row, column))))
        ++column;
    return column;
}

static sph2d_status fault(const sph2d_table *table, size_t row, const char *message, sph2d_report *report)
{
    sph2d_table_locate(table, row, sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_FIELD, NULL, "%s", message));
    return SPH2D_FORMAT;
}

static sph2d_status copy_rows(const sph2d_table *table, sph2d_scene *scene, sph2d__pool *pool, sph2d_report *report)
{
    size_t count = sph2d_table_rows(table);
    if (count == 0)
        return fault(table, 0, "this file has no particles", report);
    sph2d_particle *items = sph2d__pool_alloc(pool, count + 1, sizeof *items);
    if (!items)
        return SPH2D_NOMEM;
    for (size_t row = 0; row < count; ++row) {
        items[row] = (sph2d_particle){.x = number(table, row, X, 0),
                                      .y = number(table, row, Y, 0),
                                      .vx = number(table, row, VX, 0),
                                      .vy = number(table, row, VY, 0),
                                      .density = number(table, row, DENSITY, 0)};
        if (lacking(table, row) < COLUMNS) {
            char message[80];
            snprintf(message, sizeof message, "this row lacks a number: its column '%s' is empty or nan",
                     columns[lacking(table, row)].name);
            return fault(table, row, message, report);
        }
        if (sph2d_table_has(table, DENSITY) && !(items[row].density > 0))
            return fault(table, row, "a density must be above 0", report);
    }
    scene->particles.items = items;
    scene->particles.count = count;
    return SPH2D_OK;
}

sph2d_status sph2d__particles_read(sph2d_scene *scene, const char *from, sph2d__pool *pool, sph2d_report *report)
{
    const char *path = sph2d__pool_join(pool, from, scene->particles.file);
    if (!path)
        return SPH2D_NOMEM;
    sph2d_table *table;
    size_t first = report ? report->count : 0;
    sph2d_status status = sph2d_table_read(path, columns, COLUMNS, &table, report);
    if (status == SPH2D_OK)
        status = copy_rows(table, scene, pool, report);
    sph2d__report_key(report, first, "particles");
    sph2d_table_destroy(table);
    return status;
}
