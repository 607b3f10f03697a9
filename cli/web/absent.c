/* SPDX-License-Identifier: MIT */
/** @file absent.c
 *  What a page does not have: snapshots, drawings, files, devices, threads. */
#include <emscripten.h>
#include <stddef.h>

#include "../play/game.h"
#include "../play/turn.h"
#include "files/table_kind.h"
#include "sim/device_steps.h"

/* ---- files ------------------------------------------------------------------------------------------------------- */

sph2d_status sph2d_snapshot_read(const char *path, sph2d_snapshot **snapshot, sph2d_report *report)
{
    *snapshot = NULL;
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_FILE_OPEN, NULL, "a page reads no snapshots, such as '%s'", path);
    return SPH2D_NOINPUT;
}

void sph2d_snapshot_destroy(sph2d_snapshot *snapshot)
{
    (void)snapshot;
}

const sph2d_array *sph2d_snapshot_array(const sph2d_snapshot *snapshot, sph2d_group group, const char *name)
{
    (void)snapshot;
    (void)group;
    (void)name;
    return NULL;
}

sph2d_snapshot_info sph2d_snapshot_get_info(const sph2d_snapshot *snapshot)
{
    (void)snapshot;
    return (sph2d_snapshot_info){0};
}

/* A scene that is not read from a file has none beside it: the check says so. */
const sph2d__table_kind sph2d__closed_drawing = {.key = "svg", .file = offsetof(sph2d_shape, svg)};
const sph2d__table_kind sph2d__drawing = {.key = "svg", .file = offsetof(sph2d_shape, svg)};

/* Scenes and films become downloads, which the page's script makes of keys itself. */
void game_save(game *g)
{
    (void)g;
}

void game_film(game *g)
{
    (void)g;
}

void game_film_frame(game *g, sph2d_renderer *renderer, unsigned width, unsigned height)
{
    (void)g;
    (void)renderer;
    (void)width;
    (void)height;
}

/* ---- devices ----------------------------------------------------------------------------------------------------- */

sph2d_status sph2d__device_start(sph2d_sim *sim, int number, bool same_bits, sph2d_report *report)
{
    (void)sim;
    (void)same_bits;
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_UNSUPPORTED, NULL, "a page has no device %d", number);
    return SPH2D_INVALID;
}

void sph2d__device_end(sph2d_sim *sim)
{
    (void)sim;
}

sph2d_status sph2d__device_check(const sph2d_sim *sim, sph2d_report *report)
{
    (void)sim;
    (void)report;
    return SPH2D_OK;
}

void sph2d__host_changed(const sph2d__system *system, sph2d__set arrays)
{
    (void)system;
    (void)arrays;
}

void sph2d__host_changed_points(const sph2d__system *system)
{
    (void)system;
}

void sph2d__host_changed_walls(const sph2d__system *system, sph2d__set arrays)
{
    (void)system;
    (void)arrays;
}

bool sph2d__fluid_reserve(sph2d__system *system, size_t capacity)
{
    return sph2d__store_reserve(&system->fluid, system->memory, capacity);
}

/* What follows is called for devices alone, where the compiler does not see that. */
void sph2d__host_changed_block(const sph2d__system *system, void *block)
{
    (void)system;
    (void)block;
}

void sph2d__place_block(const sph2d__system *system, void *slot, size_t bytes, sph2d__owner owner)
{
    (void)system;
    (void)slot;
    (void)bytes;
    (void)owner;
}

void sph2d__place_store(const sph2d__system *system, sph2d__store *to, sph2d__owner owner)
{
    (void)system;
    (void)to;
    (void)owner;
}

void sph2d__place_cells(const sph2d__system *system, sph2d__cells *copy, sph2d__owner owner)
{
    (void)system;
    (void)copy;
    (void)owner;
}

uint64_t sph2d__device_offset(const sph2d__system *system, const void *array)
{
    (void)system;
    (void)array;
    return 0;
}

void sph2d__device_span_with(const sph2d__system *system, const char *kernel, size_t count, const void *with, size_t bytes)
{
    (void)system;
    (void)kernel;
    (void)count;
    (void)with;
    (void)bytes;
}

const void *sph2d__device_results(sph2d__device *device, const char *kernel, size_t count, const void *arguments,
                                  size_t bytes, unsigned writes, size_t size)
{
    (void)device;
    (void)kernel;
    (void)count;
    (void)arguments;
    (void)bytes;
    (void)writes;
    (void)size;
    return NULL;
}

/* ---- threads ----------------------------------------------------------------------------------------------------- */

/* A page has no threads: nobody starts a worker. */
void worker_begin(worker *w)
{
    (void)w;
}

void worker_wait(worker *w)
{
    (void)w;
}

void worker_stop(worker *w)
{
    (void)w;
}
