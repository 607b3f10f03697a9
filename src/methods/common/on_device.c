/* SPDX-License-Identifier: MIT */
/** @file on_device.c
 *  Hands a system over to its device. */
#include "methods/common/on_device.h"

#include <stddef.h>
#include <string.h>

#include "device/device.h"

/* ---- the system as kernels get it -------------------------------------------------------------------------------- */

/** An address in a struct, which becomes an offset. */
void sph2d__place_block(const sph2d__system *s, void *slot, size_t bytes, sph2d__owner owner)
{
    void *block;
    memcpy(&block, slot, sizeof block);
    const uint64_t offset = sph2d__device_place(s->device, block, bytes, owner);
    memcpy(slot, &offset, sizeof offset);
}

/* What kernels write of boundary particles. */
#define WALL_SUMS                                                                                                      \
    (SPH2D__BIT(density) | SPH2D__BIT(pressure) | SPH2D__BIT(volume) | SPH2D__BIT(packed_place) |                      \
     SPH2D__BIT(packed_state))

void sph2d__place_store(const sph2d__system *s, sph2d__store *t, sph2d__owner owner)
{
    const size_t bytes = t->capacity > 0 ? (t->capacity + SPH2D__PADDING) * sizeof(double) : 0;
#define PLACE(name)                                                                                                    \
    sph2d__place_block(s, &t->name, t->has &SPH2D__BIT(name) ? bytes : 0,                                              \
                       owner == SPH2D__OF_WALLS && SPH2D__BIT(name) & WALL_SUMS ? SPH2D__OF_WALL_SUMS : owner);
    SPH2D__STORE_REALS(PLACE)
#undef PLACE
    sph2d__place_block(s, &t->id, bytes, owner);
    sph2d__place_block(s, &t->color, t->colored ? bytes : 0, owner);
    sph2d__place_block(s, &t->scratch, bytes, owner);
}

void sph2d__place_cells(const sph2d__system *s, sph2d__cells *c, sph2d__owner owner)
{
    sph2d__place_block(s, &c->start, c->cell_capacity * sizeof(uint32_t), owner);
    sph2d__place_block(s, &c->places, c->place_capacity * sizeof(uint32_t), owner);
    sph2d__place_block(s, &c->cell, c->particle_capacity * sizeof(uint32_t), owner);
    sph2d__place_block(s, &c->order, c->particle_capacity * sizeof(uint32_t), owner);
}

/** The system as kernels get it, and what the method has behind it. */
typedef struct handed {
    sph2d__system system;
    unsigned char extra[SPH2D__MOST_EXTRA];
} handed;
_Static_assert(sizeof(handed) <= SPH2D__DEVICE_NUMBERS, "kernels get this as numbers");

static void place_all(const sph2d__system *s, handed *to)
{
    sph2d__system *copy = &to->system;
    const sph2d__neighbours *n = &s->neighbours;
    const size_t slabs = n->slices ? sph2d__slabs(n->particles) : 0;
    *copy = *s;
    sph2d__place_store(s, &copy->fluid, SPH2D__OF_FLUID);
    sph2d__place_store(s, &copy->walls, SPH2D__OF_WALLS);
    sph2d__place_cells(s, &copy->fluid_cells, SPH2D__OF_FLUID);
    sph2d__place_cells(s, &copy->wall_cells, SPH2D__OF_WALLS);
    sph2d__place_block(s, &copy->neighbours.slices, slabs * SPH2D__SLAB * sizeof *n->slices, SPH2D__OF_FLUID);
    sph2d__place_block(s, &copy->neighbours.index, slabs * SPH2D__SLAB * n->each * sizeof *n->index, SPH2D__OF_FLUID);
    sph2d__place_block(s, &copy->tables, sizeof *copy->tables, SPH2D__OF_SCENE);
    sph2d__place_block(s, &copy->wall_spin, s->walls.count * sizeof *s->wall_spin, SPH2D__OF_WALLS);
    sph2d__place_block(s, &copy->viscosities, 0, SPH2D__OF_FLUID);
    sph2d__place_block(s, &copy->wall_slips, s->walls.count, SPH2D__OF_SCENE);
    sph2d__place_block(s, &copy->forces.points.items, copy->points_room, SPH2D__OF_POINTS);
    for (size_t k = 0; k < copy->lent_count; ++k)
        sph2d__device_place(s->device, copy->lent[k].block, copy->lent[k].bytes, SPH2D__OF_SCENE);
    if (s->extra)
        s->extra->place(s, to->extra);
}

/** The part of the system that kernels read. */
enum { READ = offsetof(sph2d__system, profile) };

/** Whether the device has what kernels read of a system, and its method's extra. */
static bool knows(const sph2d__system *s)
{
    const bool system = sph2d__device_knows(s->device, 0, s, READ);
    return (!s->extra || sph2d__device_knows(s->device, sizeof(sph2d__system), s->extra->data(s), s->extra->bytes)) &&
           system;
}

/** Sends the system if it is not as the device knows it. */
static void bind(const sph2d__system *s)
{
    handed to;
    if (knows(s))
        return;
    sph2d__device_list(s->device);
    if (s->whole)
        place_all(s->whole, &to);
    place_all(s, &to);
    if (sph2d__device_moved(s->device))
        place_all(s, &to);
    sph2d__device_numbers(s->device, &to, offsetof(handed, extra) + (s->extra ? s->extra->bytes : 0));
}

bool sph2d__device_is_lost(const sph2d__system *s)
{
    const char *why, *doing;
    return sph2d__device_failed(s->device, &why, &doing);
}

void sph2d__device_rebind(const sph2d__system *s)
{
    if (sph2d__device_is_short(s->device)) {
        sph2d__device_forget_numbers(s->device);
        bind(s);
    }
}

/* ---- kernels ----------------------------------------------------------------------------------------------------- */

static unsigned writes_of(const char *kernel)
{
    return strncmp(kernel, "wall_", 5) == 0   ? SPH2D__OF_WALL_SUMS
           : strncmp(kernel, "grid_", 5) == 0 ? SPH2D__OF_GRID
                                              : SPH2D__OF_FLUID;
}

void sph2d__device_span_with(const sph2d__system *s, const char *kernel, size_t count, const void *with, size_t bytes)
{
    if (!kernel) {
        sph2d__device_give_up(s->device, "a part of the step has no kernel, though the scene was taken");
        return;
    }
    bind(s);
    sph2d__device_run(s->device, kernel, count, with, bytes, writes_of(kernel));
}

void sph2d__device_span(const sph2d__system *s, const char *kernel, size_t count)
{
    sph2d__device_span_with(s, kernel, count, NULL, 0);
}

const void *sph2d__device_read_by(const sph2d__system *s, const char *kernel, const void *with, size_t bytes,
                                  size_t size)
{
    bind(s);
    return sph2d__device_results(s->device, kernel, s->fluid.count, with, bytes, 0, size);
}

const void *sph2d__device_written_by(const sph2d__system *s, const char *kernel, const void *with, size_t bytes,
                                     size_t size)
{
    bind(s);
    return sph2d__device_results(s->device, kernel, s->fluid.count, with, bytes, SPH2D__OF_FLUID, size);
}

static sph2d__slab_sum total_of(const sph2d__system *s, const sph2d__slab_sum *sums)
{
    sph2d__slab_sum total = {0};
    for (size_t k = 0; sums && k < sph2d__slabs(s->fluid.count); ++k)
        sph2d__slab_add(&total, &sums[k]);
    return total;
}

sph2d__slab_sum sph2d__device_sum(const sph2d__system *s, const char *kernel, const void *with, size_t bytes)
{
    return total_of(s, sph2d__device_read_by(s, kernel, with, bytes, sizeof(sph2d__slab_sum)));
}

sph2d__slab_sum sph2d__device_work(const sph2d__system *s, const char *kernel, const void *with, size_t bytes)
{
    return total_of(s, sph2d__device_written_by(s, kernel, with, bytes, sizeof(sph2d__slab_sum)));
}

/** Adds up the sums of slabs. */
static void take_sums(void *to, const void *results, size_t groups)
{
    const sph2d__slab_sum *sums = results;
    sph2d__slab_sum total = {0};
    for (size_t k = 0; k < groups; ++k)
        sph2d__slab_add(&total, &sums[k]);
    *(sph2d__slab_sum *)to = total;
}

void sph2d__device_work_later(const sph2d__system *s, const char *kernel, const void *with, size_t bytes,
                              sph2d__slab_sum *to)
{
    bind(s);
    sph2d__device_results_later(s->device, kernel, s->fluid.count, with, bytes, SPH2D__OF_FLUID,
                                sizeof(sph2d__slab_sum), take_sums, to);
}

uint64_t sph2d__device_offset(const sph2d__system *s, const void *array)
{
    bind(s);
    return sph2d__device_offset_of(s->device, array);
}

/* ---- transfers --------------------------------------------------------------------------------------------------- */

/** What is done to a block. */
typedef void block_work(sph2d__device *device, void *block);

static void with_arrays(sph2d__device *d, const sph2d__store *t, sph2d__set arrays, block_work *work)
{
#define WITH(name)                                                                                                     \
    if (arrays & t->has & SPH2D__BIT(name))                                                                            \
        work(d, t->name);
    SPH2D__STORE_REALS(WITH)
#undef WITH
    if (arrays & SPH2D__IDS)
        work(d, t->id);
    if (arrays & SPH2D__COLORS)
        work(d, t->color);
}

void sph2d__device_fetch_arrays(const sph2d__system *s, sph2d__set arrays)
{
    with_arrays(s->device, &s->fluid, arrays, sph2d__device_ask);
    if (arrays == SPH2D__EVERYTHING)
        sph2d__device_ask(s->device, s->fluid_cells.start);
    sph2d__device_arrive(s->device);
}

void sph2d__device_fetch_walls(const sph2d__system *s)
{
    with_arrays(s->device, &s->walls, SPH2D__EVERYTHING, sph2d__device_ask);
    sph2d__device_arrive(s->device);
}

void sph2d__host_changed(const sph2d__system *s, sph2d__set arrays)
{
    if (sph2d__is_on_device(s))
        with_arrays(s->device, &s->fluid, arrays, sph2d__device_changed_one);
}

void sph2d__host_changed_points(const sph2d__system *s)
{
    if (sph2d__is_on_device(s))
        sph2d__device_changed(s->device, SPH2D__OF_POINTS);
}

void sph2d__host_changed_walls(const sph2d__system *s, sph2d__set arrays)
{
    if (!sph2d__is_on_device(s))
        return;
    with_arrays(s->device, &s->walls, arrays, sph2d__device_changed_one);
    if (arrays == SPH2D__EVERYTHING) {
        const sph2d__cells *c = &s->wall_cells;
        void *const parts[] = {c->start, c->places, c->cell, c->order, s->wall_spin};
        for (size_t k = 0; k < sizeof parts / sizeof *parts; ++k)
            sph2d__device_changed_one(s->device, parts[k]);
    }
}

void sph2d__host_changed_block(const sph2d__system *s, void *block)
{
    sph2d__device_changed_one(s->device, block);
}

bool sph2d__fluid_reserve(sph2d__system *s, size_t capacity)
{
    if (capacity <= s->fluid.capacity)
        return true;
    sph2d__host_reads(s, SPH2D__EVERYTHING);
    if (sph2d__is_on_device(s)) {
        with_arrays(s->device, &s->fluid, SPH2D__EVERYTHING, sph2d__device_forget);
        sph2d__device_forget(s->device, s->fluid.scratch);
    }
    const bool reserved = sph2d__store_reserve(&s->fluid, s->memory, capacity);
    sph2d__host_changed(s, SPH2D__EVERYTHING);
    return reserved;
}
