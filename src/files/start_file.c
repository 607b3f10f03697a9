/* SPDX-License-Identifier: MIT */
/** @file start_file.c
 *  The starts of a scene that name files: what of a snapshot is taken, and what is kept to resume. */
#include "files/scene_file.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "files/text.h"
#include "sph2d/io.h"

/** The start of block `i`, or of the scene behind them: the items were converted into the pool, which is writable. */
static sph2d_start *start_of(sph2d_scene *scene, size_t i)
{
    return i < scene->block_count ? (sph2d_start *)(uintptr_t)&scene->blocks[i].start : &scene->start;
}

/* ---- snapshots --------------------------------------------------------------------------------------------------- */

static double array_value(const sph2d_array *array, unsigned component, size_t i)
{
    return ((const double *)array->data[component])[i * array->stride];
}

static sph2d_status refuse_snapshot(const char *path, sph2d_report *report)
{
    sph2d_diagnostic *d =
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_FIELD, NULL, "this snapshot has no liquid");
    if (d)
        snprintf(d->file, sizeof d->file, "%s", path);
    return SPH2D_FORMAT;
}

static sph2d_status copy_liquid(const sph2d_snapshot *snapshot, const char *path, sph2d_cloud *cloud, sph2d__pool *pool,
                                sph2d_report *report)
{
    const sph2d_array *at = sph2d_snapshot_array(snapshot, SPH2D_GROUP_FLUID, "Coordinates");
    const sph2d_array *velocity = sph2d_snapshot_array(snapshot, SPH2D_GROUP_FLUID, "Velocities");
    const sph2d_array *pressure = sph2d_snapshot_array(snapshot, SPH2D_GROUP_FLUID, "Pressures");
    if (!at || !velocity || !pressure || at->count == 0)
        return refuse_snapshot(path, report);
    sph2d_cloud_point *items = sph2d__pool_alloc(pool, at->count, sizeof *items);
    if (!items)
        return SPH2D_NOMEM;
    for (size_t i = 0; i < at->count; ++i)
        items[i] = (sph2d_cloud_point){array_value(at, 0, i), array_value(at, 1, i), array_value(velocity, 0, i),
                                       array_value(velocity, 1, i), array_value(pressure, 0, i)};
    cloud->items = items;
    cloud->count = at->count;
    cloud->spacing = sph2d_snapshot_get_info(snapshot).spacing;
    return SPH2D_OK;
}

/** Whether a scene gets the liquid of its start's snapshot, and its sound speed is for the snapshot to tell. */
static bool wants_sound_speed(const sph2d_scene *scene)
{
    const sph2d_method_options *m = &scene->method;
    return scene->start.snapshot.file && !(m->sound_speed > 0) && !(m->stiffness > 0) && !scene->particles.file;
}

static sph2d_status read_snapshot(sph2d_scene *scene, sph2d_start *start, const char *path, sph2d__pool *pool,
                                  sph2d_report *report)
{
    sph2d_snapshot *snapshot;
    sph2d_status status = sph2d_snapshot_read(path, &snapshot, report);
    if (status != SPH2D_OK)
        return status;
    status = copy_liquid(snapshot, path, &start->snapshot, pool, report);
    const sph2d_snapshot_info info = sph2d_snapshot_get_info(snapshot);
    bool same = strcmp(info.method, sph2d_method_of(&scene->method)->word) == 0;
    if (status == SPH2D_OK && start == &scene->start && same && wants_sound_speed(scene))
        scene->method.sound_speed = info.sound_speed;
    sph2d_snapshot_destroy(snapshot);
    return status;
}

/** Reads the snapshot of start `i`. */
static sph2d_status read_start(sph2d_scene *scene, size_t i, const char *from, sph2d__pool *pool, sph2d_report *report)
{
    sph2d_start *start = start_of(scene, i);
    char key[64] = "start.snapshot";
    if (i < scene->block_count)
        snprintf(key, sizeof key, "blocks[%zu].start.snapshot", i);
    const char *path = sph2d__pool_join(pool, from, start->snapshot.file);
    if (!path)
        return SPH2D_NOMEM;
    size_t first = report ? report->count : 0;
    sph2d_status status = read_snapshot(scene, start, path, pool, report);
    sph2d__report_key(report, first, key);
    return status;
}

/* ---- speeds ------------------------------------------------------------------------------------------------------ */

/** Whether the largest speed of a start is for a file to tell. */
static bool wants_top_speed(const sph2d_start *start)
{
    return (start->table.file || start->snapshot.file) && start->top_speed == 0;
}

/** The largest speed of what was read. */
static double top_speed(const sph2d_start *start)
{
    const sph2d_grid *g = &start->table;
    const sph2d_cloud *cloud = &start->snapshot;
    double speed = 0;
    for (size_t k = 0; k < g->nx * g->ny; ++k)
        speed = fmax(speed, hypot(g->vx ? g->vx[k] : 0, g->vy ? g->vy[k] : 0));
    for (size_t k = 0; k < cloud->count; ++k)
        speed = fmax(speed, hypot(cloud->items[k].vx, cloud->items[k].vy));
    return speed;
}

sph2d_status sph2d__starts_read(sph2d_scene *scene, const char *from, sph2d__pool *pool, sph2d_report *report)
{
    sph2d_status status = SPH2D_OK;
    for (size_t i = 0; status == SPH2D_OK && i <= scene->block_count; ++i) {
        sph2d_start *start = start_of(scene, i);
        if (start->snapshot.file && !start->table.file) /* of two the check will refuse one */
            status = read_start(scene, i, from, pool, report);
        if (wants_top_speed(start))
            start->top_speed = top_speed(start);
    }
    return status;
}

void sph2d__starts_keep(sph2d_scene *scene, const sph2d_scene *kept)
{
    for (size_t i = 0; i < scene->block_count && i < kept->block_count; ++i)
        if (wants_top_speed(start_of(scene, i)))
            start_of(scene, i)->top_speed = kept->blocks[i].start.top_speed;
    if (wants_top_speed(&scene->start))
        scene->start.top_speed = kept->start.top_speed;
    if (wants_sound_speed(scene))
        scene->method.sound_speed = kept->method.sound_speed;
}
