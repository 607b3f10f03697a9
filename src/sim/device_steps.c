/* SPDX-License-Identifier: MIT */
/** @file device_steps.c */
#include "sim/device_steps.h"

#include <string.h>

#include "device/device.h"
#include "methods/common/slabs.h"
#include "sim/simulation.h"

/* ---- beginning and end ------------------------------------------------------------------------------------------- */

/* Room for contacts with walls in one step: half of the particles and so many more. */
enum { CONTACTS = 65536 };

static void lend_block(sph2d__system *s, const void *block, size_t bytes)
{
    if (block && bytes > 0)
        s->lent[s->lent_count++] = (sph2d__kernel_block){block, bytes};
}

static void lend_barrier(sph2d__system *s, const sph2d__barrier *b)
{
    lend_block(s, b->segments, b->capacity * sizeof *b->segments);
    lend_block(s, b->start, b->start_capacity * sizeof *b->start);
    lend_block(s, b->items, b->item_capacity * sizeof *b->items);
    lend_block(s, b->near, b->start_capacity > 0 ? b->start_capacity - 1 : 0);
}

static sph2d_status lend(sph2d_sim *sim)
{
    enum { OWN = 4, OF_BARRIER = 4 };
    sph2d__system *s = &sim->system;
    const size_t moving = sim->moving_count;
    sim->contact_room = (uint32_t)(s->fluid.count / 2 + CONTACTS);
    sim->contacts = sph2d__arena_alloc(&sim->arena, &sim->memory, sim->contact_room, sizeof *sim->contacts);
    sim->contact_count = sph2d__arena_alloc(&sim->arena, &sim->memory, 16, sizeof *sim->contact_count);
    sim->drifts = sph2d__arena_alloc(&sim->arena, &sim->memory, moving + 1, sizeof *sim->drifts);
    s->lent =
        sph2d__arena_alloc(&sim->arena, &sim->memory, OWN + OF_BARRIER + (OF_BARRIER + 1) * moving, sizeof *s->lent);
    if (!sim->contacts || !sim->contact_count || !sim->drifts || !s->lent)
        return SPH2D_NOMEM;
    lend_block(s, sim->contacts, sim->contact_room * sizeof *sim->contacts);
    lend_block(s, sim->contact_count, sizeof *sim->contact_count);
    lend_block(s, sim->loads.forces, (s->walls.count + 1) * sizeof *sim->loads.forces);
    lend_block(s, sim->drifts, moving * sizeof *sim->drifts);
    lend_barrier(s, &sim->barrier);
    for (size_t k = 0; k < moving; ++k) {
        lend_barrier(s, &sim->moving[k].barrier);
        lend_block(s, sim->moving[k].poses, (SPH2D__MOST_CHORDS + 1) * sizeof *sim->moving[k].poses);
    }
    return SPH2D_OK;
}

/** Whether the device lays out structs as the host does. */
static sph2d_status check_layout(sph2d_sim *sim, sph2d_report *report)
{
    const uint64_t own[] = {sizeof(sph2d__system),  sizeof(sph2d__advection), sizeof(sph2d__slab_sum),
                            sizeof(sph2d__limits),  sizeof(sph2d__extremes),  sizeof(sph2d__events),
                            sizeof(sph2d__contact), sizeof(sph2d__drift),     sizeof(sph2d__reordered)};
    const uint64_t *its = sph2d__device_results(sim->system.device, "layout", 1, NULL, 0, 0, sizeof own);
    if (!its)
        return SPH2D_NOMEM;
    if (sph2d__device_check(sim, report) != SPH2D_OK)
        return SPH2D_DEVICE;
    if (memcmp(its, own, sizeof own) == 0)
        return SPH2D_OK;
    sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_DEVICE, NULL,
                     "%s: its compiler lays out data otherwise than the host's",
                     sph2d__device_name(sim->system.device));
    return SPH2D_DEVICE;
}

sph2d_status sph2d__device_start(sph2d_sim *sim, int number, bool same_bits, sph2d_report *report)
{
    sph2d_status status = lend(sim);
    if (status == SPH2D_OK)
        sim->system.device = sph2d__device_open(number, sim->method->name, (int)sim->world.scene.method.kernel,
                                                same_bits, &sim->memory, &status, report);
    return status == SPH2D_OK ? check_layout(sim, report) : status;
}

void sph2d__device_end(sph2d_sim *sim)
{
    sph2d__device_close(sim->system.device, &sim->memory);
    sim->system.device = NULL;
}

sph2d_status sph2d__device_check(const sph2d_sim *sim, sph2d_report *report)
{
    const sph2d__device *d = sim->system.device;
    const char *why, *doing;
    if (!d || !sph2d__device_failed(d, &why, &doing))
        return SPH2D_OK;
    sph2d_diagnostic *e =
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_DEVICE, NULL, "%s: %s (%s, step %llu, time %g s)",
                         sph2d__device_name(d), why, doing, (unsigned long long)sim->record.steps, sim->record.time);
    if (sph2d__device_lacks_memory(d))
        sph2d_diagnostic_hint(e, "a larger spacing takes less");
    else if (sim->record.steps > 0)
        sph2d_diagnostic_hint(e, "resume from the last snapshot, on the processor if it happens again");
    return SPH2D_DEVICE;
}

/* ---- cells ------------------------------------------------------------------------------------------------------- */

/** Puts an array on the list of those that are put in order. */
static void list_array(const sph2d__system *s, void *array, sph2d__reordered *list)
{
    list->arrays[list->count++] = (sph2d__moved){sph2d__device_offset(s, array), sph2d__device_spare(s->device, array)};
}

static void list_all(const sph2d__system *s, sph2d__reordered *list)
{
    const sph2d__store *f = &s->fluid;
    const sph2d__set moved = f->has & f->carried;
    list->count = 0;
#define LIST(name)                                                                                                     \
    if (moved & SPH2D__BIT(name))                                                                                      \
        list_array(s, f->name, list);
    SPH2D__STORE_REALS(LIST)
#undef LIST
    list_array(s, f->id, list);
    if (f->colored)
        list_array(s, f->color, list);
}

/** Puts all arrays in order at once, each from its place to its spare one. */
static void reorder_all(sph2d__system *s)
{
    const sph2d__store *f = &s->fluid;
    const sph2d__set moved = f->has & f->carried;
    sph2d__reordered list;
    list_all(s, &list);
    sph2d__device_rebind(s); /* which may move all blocks, where room for spares was missing */
    list_all(s, &list);
    sph2d__device_span_with(s, "reorder", f->count, &list, sizeof list);
#define SWAP(name)                                                                                                     \
    if (moved & SPH2D__BIT(name))                                                                                      \
        sph2d__device_swap(s->device, f->name);
    SPH2D__STORE_REALS(SWAP)
#undef SWAP
    sph2d__device_swap(s->device, f->id);
    if (f->colored)
        sph2d__device_swap(s->device, f->color);
}

bool sph2d__device_sort(sph2d__system *s)
{
    const size_t count = s->fluid.count;
    sph2d__bounds_of bounds = sph2d__no_bounds();
    const sph2d__bounds_of *parts = sph2d__device_read_by(s, "bounds", NULL, 0, sizeof bounds);
    if (!parts)
        return false;
    for (size_t k = 0; k < sph2d__slabs(count); ++k)
        bounds = sph2d__join_bounds(bounds, parts[k]);
    const double around[4] = {bounds.min_x, bounds.min_y, bounds.max_x, bounds.max_y};
    if (!sph2d__cells_lay(&s->fluid_cells, &s->fluid, around, s->reach, SPH2D__SCANNERS, s->memory))
        return false;
    sph2d__device_span(s, "empty_cells", (size_t)s->fluid_cells.nx * s->fluid_cells.ny);
    sph2d__device_span(s, "count_cells", count);
    sph2d__device_span(s, "scan_parts", SPH2D__SCANNERS);
    sph2d__device_span(s, "scan_sums", SPH2D__SLAB);
    sph2d__device_span(s, "scan_cells", SPH2D__SCANNERS);
    sph2d__device_span(s, "fill_cells", count);
    sph2d__device_span(s, "order_cells", count);
    reorder_all(s);
    return true;
}

/* ---- advection --------------------------------------------------------------------------------------------------- */

/** Fetches what walls did to particles, so many times. */
static void fetch_contacts(sph2d_sim *sim, uint64_t count)
{
    sph2d__device *d = sim->system.device;
    sph2d__device_fetch_first(d, sim->contacts, count * sizeof *sim->contacts);
    if (count > sim->contact_room)
        sph2d__device_give_up(d, "more particles met walls in one step than its list holds");
    *sim->contact_count = 0;
    sph2d__device_changed_one(d, sim->contact_count);
}

/** An address in a struct becomes the offset of its block. */
static void to_offset(const sph2d__system *s, void *slot)
{
    void *block;
    memcpy(&block, slot, sizeof block);
    const uint64_t offset = block ? sph2d__device_offset(s, block) : 0;
    memcpy(slot, &offset, sizeof offset);
}

static sph2d__barrier offsets_of(const sph2d__system *s, const sph2d__barrier *barrier)
{
    sph2d__barrier b = *barrier;
    to_offset(s, &b.segments);
    to_offset(s, &b.start);
    to_offset(s, &b.items);
    to_offset(s, &b.near);
    return b;
}

/** Sends the ways of obstacles that move. */
static void send_drifts(sph2d_sim *sim)
{
    const sph2d__system *s = &sim->system;
    for (size_t k = 0; k < sim->moving_count; ++k) {
        sph2d__drift drift = sim->moving[k].drift;
        drift.barrier = offsets_of(s, &drift.barrier);
        to_offset(s, &drift.poses);
        sim->drifts[k] = drift;
        sph2d__device_changed_one(s->device, sim->moving[k].poses);
    }
    if (sim->moving_count > 0)
        sph2d__device_changed_one(s->device, sim->drifts);
}

sph2d__events sph2d__device_advect(sph2d_sim *sim, double dt, double quantum, bool noted)
{
    const sph2d__system *s = &sim->system;
    send_drifts(sim);
    const sph2d__advection with = {.dt = dt,
                                   .quantum = quantum,
                                   .walls = offsets_of(s, &sim->barrier),
                                   .drifts = sph2d__device_offset(s, sim->drifts),
                                   .drift_count = (uint32_t)sim->moving_count,
                                   .holds = sim->method->walls_hold,
                                   .contacts = sph2d__device_offset(s, sim->contacts),
                                   .contact_count = sph2d__device_offset(s, sim->contact_count),
                                   .contact_room = sim->contact_room,
                                   .noted = noted};
    const sph2d__events *parts = sph2d__device_written_by(s, "advect", &with, sizeof with, sizeof *parts);
    sph2d__events all = {0};
    for (size_t k = 0; parts && k < sph2d__slabs(s->fluid.count); ++k)
        sph2d__add_events(&all, parts[k]);
    if (all.noted > 0)
        fetch_contacts(sim, all.noted);
    all.noted = all.noted < sim->contact_room ? all.noted : sim->contact_room;
    return all;
}

/* ---- guards ------------------------------------------------------------------------------------------------------ */

sph2d__extremes sph2d__device_extremes(const sph2d__system *s, const sph2d__limits *within)
{
    const sph2d__extremes *parts = sph2d__device_read_by(s, "extremes", within, sizeof *within, sizeof *parts);
    sph2d__extremes all = sph2d__no_extremes();
    if (sph2d__device_is_lost(s)) /* its results are zeros, which no guard should see */
        return all;
    for (size_t k = 0; parts && k < sph2d__slabs(s->fluid.count); ++k)
        all = sph2d__join_extremes(all, parts[k]);
    return all;
}

void sph2d__device_wall_forces(const sph2d__system *s, sph2d__wall_force *forces)
{
    const uint64_t to = sph2d__device_offset(s, forces);
    if (s->walls.count == 0)
        return;
    sph2d__device_span_with(s, "wall_forces", s->walls.count, &to, sizeof to);
    sph2d__device_changed_on(s->device, forces);
    sph2d__device_fetch(s->device, forces);
}
