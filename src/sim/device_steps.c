/* SPDX-License-Identifier: MIT */
/** @file device_steps.c */
#include "sim/device_steps.h"

#include <string.h>

#include "device/device.h"
#include "methods/common/slabs.h"
#include "sim/stages.h"

/* ---- beginning and end ------------------------------------------------------------------------------------------- */

/* Room for contacts with walls in one step: half of the particles and so many more. */
enum { CONTACTS = 65536 };

static sph2d_status lend(sph2d_sim *sim)
{
    sph2d__system *s = &sim->system;
    const sph2d__barrier *b = &sim->barrier;
    sim->contact_room = (uint32_t)(s->fluid.count / 2 + CONTACTS);
    sim->contacts = sph2d__arena_alloc(&sim->arena, &sim->memory, sim->contact_room, sizeof *sim->contacts);
    sim->contact_count = sph2d__arena_alloc(&sim->arena, &sim->memory, 16, sizeof *sim->contact_count);
    if (!sim->contacts || !sim->contact_count)
        return SPH2D_NOMEM;
    const sph2d__kernel_block all[] = {{b->segments, b->capacity * sizeof *b->segments},
                                       {b->start, b->start_capacity * sizeof *b->start},
                                       {b->items, b->item_capacity * sizeof *b->items},
                                       {b->near, b->start_capacity > 0 ? b->start_capacity - 1 : 0},
                                       {sim->contacts, sim->contact_room * sizeof *sim->contacts},
                                       {sim->contact_count, sizeof *sim->contact_count},
                                       {sim->loads.forces, (s->walls.count + 1) * sizeof *sim->loads.forces}};
    _Static_assert(sizeof all / sizeof *all <= SPH2D__KERNEL_BLOCKS, "the system has room for them");
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
        if (all[k].block)
            s->lent[s->lent_count++] = all[k];
    return SPH2D_OK;
}

/** Whether the device lays out structs as the host does. */
static sph2d_status check_layout(sph2d_sim *sim, sph2d_report *report)
{
    enum { SIZES = 6 };
    const uint64_t own[SIZES] = {sizeof(sph2d__system), sizeof(sph2d__advection), sizeof(sph2d__slab_sum),
                                 sizeof(sph2d__limits), sizeof(sph2d__extremes),  sizeof(sph2d__events)};
    const uint64_t *its = sph2d__device_results(sim->system.device, "layout", 1, NULL, 0, 0, sizeof own);
    if (sph2d__device_check(sim, report) != SPH2D_OK)
        return SPH2D_DEVICE;
    if (its && memcmp(its, own, sizeof own) == 0)
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
    for (size_t k = 0; parts && k < sph2d__slabs(count); ++k)
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

/** Hands what walls did to particles, so many times, to the loads. */
static void take_contacts(sph2d_sim *sim, uint64_t count)
{
    sph2d__device *d = sim->system.device;
    sph2d__device_changed_on(d, sim->contacts);
    sph2d__device_fetch(d, sim->contacts);
    if (count > sim->contact_room)
        sph2d__device_give_up(d, "more particles met walls in one step than its list holds");
    for (uint64_t k = 0; k < count && k < sim->contact_room; ++k)
        sph2d__loads_contact(sim, sim->contacts[k].wall, sim->contacts[k].at, sim->contacts[k].change, 0);
    *sim->contact_count = 0;
    sph2d__device_changed_one(d, sim->contact_count);
}

sph2d_status sph2d__device_advect(sph2d_sim *sim, double dt)
{
    const sph2d__system *s = &sim->system;
    sph2d__advection with = {.dt = dt,
                             .quantum = sph2d__sim_energy_quantum(sim),
                             .walls = sim->barrier,
                             .contacts = sph2d__device_offset(s, sim->contacts),
                             .contact_count = sph2d__device_offset(s, sim->contact_count),
                             .contact_room = sim->contact_room,
                             .noted = sph2d__loads_wanted(sim)};
    const uint64_t offsets[] = {sph2d__device_offset(s, with.walls.segments), sph2d__device_offset(s, with.walls.start),
                                sph2d__device_offset(s, with.walls.items), sph2d__device_offset(s, with.walls.near)};
    memcpy(&with.walls.segments, &offsets[0], sizeof *offsets);
    memcpy(&with.walls.start, &offsets[1], sizeof *offsets);
    memcpy(&with.walls.items, &offsets[2], sizeof *offsets);
    memcpy(&with.walls.near, &offsets[3], sizeof *offsets);
    const sph2d__events *parts = sph2d__device_written_by(s, "advect", &with, sizeof with, sizeof *parts);
    sph2d__events all = {0};
    for (size_t k = 0; parts && k < sph2d__slabs(s->fluid.count); ++k)
        sph2d__add_events(&all, parts[k]);
    if (all.noted > 0)
        take_contacts(sim, all.noted);
    sph2d__advected(sim, &all);
    return all.not_finite == 0 ? SPH2D_OK : SPH2D_GUARD;
}

/* ---- guards ------------------------------------------------------------------------------------------------------ */

sph2d__extremes sph2d__device_extremes(const sph2d__system *s, const sph2d__limits *within)
{
    const sph2d__extremes *parts = sph2d__device_read_by(s, "extremes", within, sizeof *within, sizeof *parts);
    sph2d__extremes all = sph2d__no_extremes();
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
