/* SPDX-License-Identifier: MIT */
/* The kernels that all programs have: cells, advection, sums and guards. */
/* The sizes of what host and device hand each other, as the device has them. */
KERNEL(layout)
{
    __global ulong *sizes = (__global ulong *)results;
    if (get_global_id(0) > 0)
        return;
    sizes[0] = sizeof(sph2d__system);
    sizes[1] = sizeof(sph2d__advection);
    sizes[2] = sizeof(sph2d__slab_sum);
    sizes[3] = sizeof(sph2d__limits);
    sizes[4] = sizeof(sph2d__extremes);
    sizes[5] = sizeof(sph2d__events);
    sizes[6] = sizeof(sph2d__contact);
    sizes[7] = sizeof(sph2d__drift);
    sizes[8] = sizeof(sph2d__reordered);
}

/* ---- cells ------------------------------------------------------------------------------------------------------- */

KERNEL(bounds)
{
    __local sph2d__bounds_of parts[SPH2D__SLAB];
    const size_t i = get_global_id(0), l = get_local_id(0);
    SYSTEM
    sph2d__bounds_of part = sph2d__no_bounds();
    if (i < count)
        part = (sph2d__bounds_of){s.fluid.x[i], s.fluid.y[i], s.fluid.x[i], s.fluid.y[i]};
    parts[l] = part;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (l > 0)
        return;
    for (size_t k = 1; k < SPH2D__SLAB; ++k)
        part = sph2d__join_bounds(part, parts[k]);
    ((__global sph2d__bounds_of *)results)[get_group_id(0)] = part;
}

KERNEL(empty_cells)
{
    SYSTEM
    if (get_global_id(0) < count)
        s.fluid_cells.places[get_global_id(0)] = 0;
}

KERNEL(count_cells)
{
    const size_t i = get_global_id(0);
    SYSTEM
    if (i >= count)
        return;
    const uint32_t cell = sph2d__cell_of(&s.fluid_cells, s.fluid.x[i], s.fluid.y[i]);
    s.fluid_cells.cell[i] = cell;
    atomic_inc(s.fluid_cells.places + cell);
}

/* Each of SPH2D__SCANNERS threads has a part of the cells: first it counts their particles, ... */
KERNEL(scan_parts)
{
    const size_t k = get_global_id(0);
    SYSTEM
    const sph2d__cells *c = &s.fluid_cells;
    const size_t cells = (size_t)c->nx * c->ny, each = (cells + SPH2D__SCANNERS - 1) / SPH2D__SCANNERS;
    uint32_t sum = 0;
    for (size_t n = k * each; n < (k + 1) * each && n < cells; ++n)
        sum += c->places[n];
    c->places[cells + k] = sum;
}

/* ... then one group adds up these counts, ... */
KERNEL(scan_sums)
{
    __local uint32_t parts[SPH2D__SLAB];
    const size_t l = get_local_id(0), each = SPH2D__SCANNERS / SPH2D__SLAB;
    SYSTEM
    const sph2d__cells *c = &s.fluid_cells;
    __global uint32_t *sums = c->places + (size_t)c->nx * c->ny + l * each;
    uint32_t sum = 0;
    for (size_t n = 0; n < each; ++n)
        sum += sums[n];
    parts[l] = sum;
    barrier(CLK_LOCAL_MEM_FENCE);
    sum = 0;
    for (size_t n = 0; n < l; ++n)
        sum += parts[n];
    for (size_t n = 0; n < each; ++n) {
        const uint32_t part = sums[n];
        sums[n] = sum;
        sum += part;
    }
}

/* ... and each sets where the particles of its cells begin. */
KERNEL(scan_cells)
{
    const size_t k = get_global_id(0);
    SYSTEM
    const sph2d__cells *c = &s.fluid_cells;
    const size_t cells = (size_t)c->nx * c->ny, each = (cells + SPH2D__SCANNERS - 1) / SPH2D__SCANNERS;
    uint32_t sum = c->places[cells + k];
    for (size_t n = k * each; n < (k + 1) * each && n < cells; ++n) {
        const uint32_t part = c->places[n];
        c->start[n] = sum;
        c->places[n] = sum;
        sum += part;
    }
    if (k == SPH2D__SCANNERS - 1)
        c->start[cells] = (uint32_t)s.fluid.count;
}

KERNEL(fill_cells)
{
    const size_t i = get_global_id(0);
    SYSTEM
    if (i < count)
        ((__global uint32_t *)s.fluid.scratch)[atomic_inc(s.fluid_cells.places + s.fluid_cells.cell[i])] = (uint32_t)i;
}

/* Which thread was first is chance: a particle's place in its cell is as many as come before it in the order so far. */
KERNEL(order_cells)
{
    const size_t k = get_global_id(0);
    SYSTEM
    const sph2d__cells *c = &s.fluid_cells;
    if (k >= count)
        return;
    __global const uint32_t *found = (__global const uint32_t *)s.fluid.scratch;
    const uint32_t i = found[k], cell = c->cell[i], first = c->start[cell], end = c->start[cell + 1];
    uint32_t before = first;
    for (uint32_t n = first; n < end; ++n)
        before += found[n] < i;
    c->order[before] = i;
}

/* All arrays are of 8 bytes. */
KERNEL(reorder)
{
    const size_t k = get_global_id(0);
    SYSTEM
    __global const sph2d__reordered *with = (__global const sph2d__reordered *)(numbers + own_at);
    if (k >= count)
        return;
    const uint32_t from = s.fluid_cells.order[k];
    for (ulong n = 0; n < with->count; ++n)
        BLOCK(ulong, with->arrays[n].to)[k] = BLOCK(const ulong, with->arrays[n].from)[from];
}

/* ---- advection --------------------------------------------------------------------------------------------------- */

/* What a particle may meet: advect_one.h. */
typedef struct passage {
    const sph2d__system *system;
    const sph2d__barrier *walls;
    double quantum;
    bool holds;
    __global uchar *arena;
    const sph2d__advection *with;
} passage;

static inline sph2d__barrier placed_barrier(__global uchar *arena, sph2d__barrier b)
{
    b.segments = BLOCK(sph2d__piece, b.segments);
    b.start = BLOCK(uint32_t, b.start);
    b.items = BLOCK(uint32_t, b.items);
    b.near = BLOCK(unsigned char, b.near);
    return b;
}

/* Lists it for loads; beyond the room that there is it is counted alone. */
static inline void note_contact(const passage *p, sph2d__events *met, int wall, sph2d_vec2 at, sph2d_vec2 change, double work)
{
    __global uchar *arena = p->arena;
    if (!p->with->noted)
        return;
    const uint32_t n = atomic_inc(BLOCK(uint32_t, p->with->contact_count));
    ++met->noted;
    if (n < p->with->contact_room)
        BLOCK(sph2d__contact, p->with->contacts)[n] = (sph2d__contact){at, change, work, wall};
}

static inline bool reflect(const passage *p, sph2d_vec2 at, sph2d_vec2 *v)
{
    return false;
}

static inline uint64_t sweep_moving(const passage *p, sph2d__events *met, sph2d__kicked who, sph2d_vec2 from,
                                    sph2d_vec2 *to, sph2d_vec2 *v, double *to_bodies)
{
    __global uchar *arena = p->arena;
    uint64_t all = 0;
    for (uint32_t k = 0; k < p->with->drift_count; ++k) {
        const sph2d__end before = {*to, *v};
        sph2d__drift drift = BLOCK(const sph2d__drift, p->with->drifts)[k];
        drift.poses = BLOCK(const sph2d__pose, drift.poses);
        drift.barrier = placed_barrier(arena, drift.barrier);
        const int hits = sph2d__drift_sweep(&drift, from, to, v);
        if (hits > 0 && p->with->noted)
            note_contact(p, met, drift.wall, from, (sph2d_vec2){v->x - before.v.x, v->y - before.v.y},
                         sph2d__energy_kicked(p->system, who, (sph2d__end){*to, *v}) -
                             sph2d__energy_kicked(p->system, who, before));
        all += (uint64_t)hits;
    }
    return all;
}

#include "sim/advect_one.h"

/* Adds up the events of a group. */
static inline void add_events(__local sph2d__events *parts, __global uchar *to)
{
    barrier(CLK_LOCAL_MEM_FENCE);
    if (get_local_id(0) > 0)
        return;
    sph2d__events all = parts[0];
    for (size_t k = 1; k < SPH2D__SLAB; ++k)
        sph2d__add_events(&all, parts[k]);
    ((__global sph2d__events *)to)[get_group_id(0)] = all;
}

/* The kernel `advect`: `set` gives a particle's way, `after` is done to it at its end. */
#define ADVECT(set, after)                                                                                             \
    KERNEL(advect)                                                                                                     \
    {                                                                                                                  \
        __local sph2d__events parts[SPH2D__SLAB];                                                                      \
        const size_t i = get_global_id(0);                                                                             \
        SYSTEM                                                                                                         \
        const sph2d__advection with = *(__global const sph2d__advection *)(numbers + own_at);                          \
        const sph2d__barrier walls = placed_barrier(arena, with.walls);                                                \
        const passage by = {&s, &walls, with.quantum, with.holds, arena, &with};                                       \
        sph2d__events met = {0};                                                                                       \
        if (i < count) {                                                                                               \
            const sph2d__way way = set(&s, with.dt, i);                                                                \
            met.diffused = sph2d__quanta_of(with.quantum, way.diffused);                                               \
            advect_one(&by, i, way, &met);                                                                             \
            after(&s, with.dt, i);                                                                                     \
        }                                                                                                              \
        parts[get_local_id(0)] = met;                                                                                  \
        add_events(parts, results);                                                                                    \
    }

/* ---- balances ---------------------------------------------------------------------------------------------------- */

static inline void one_momentum(const sph2d__system *s, size_t i, const sph2d_vec2 *gravity, sph2d__slab_sum *sum)
{
    sph2d__forces external = s->forces;
    external.springs.stiffness = 0;
    external.gravity.x = gravity->x;
    external.gravity.y = gravity->y;
    sph2d__add_momentum(s, &external, i, sum);
}
SUM(sum_momentum, sph2d_vec2, one_momentum)

static inline void one_power(const sph2d__system *s, size_t i, const int *kind, sph2d__slab_sum *sum)
{
    sph2d__add_power(s, (sph2d__work_kind)*kind, i, sum);
}
SUM(sum_power, int, one_power)

static inline void one_work(const sph2d__system *s, size_t i, const int *none, sph2d__slab_sum *sum)
{
    sph2d__add_work(s, i, sum);
}
SUM(sum_work, int, one_work)

/* Forces on the sides of the domain and on boundary particles, by what a method has for each. */
#define LOADS(push, force)                                                                                             \
    static inline void one_side(const sph2d__system *s, size_t i, const sph2d__side_load *load, sph2d__slab_sum *sum)  \
    {                                                                                                                  \
        double fill[4];                                                                                                \
        push(s, i, fill);                                                                                              \
        sph2d__add_sides(s, load, i, fill, sum);                                                                       \
    }                                                                                                                  \
    SUM(sum_sides, sph2d__side_load, one_side)                                                                         \
                                                                                                                       \
    SPH2D__FORCE_OF_WALL(force_of_wall, int, none, force)                                                              \
                                                                                                                       \
    KERNEL(wall_forces)                                                                                                \
    {                                                                                                                  \
        const size_t b = get_global_id(0);                                                                             \
        SYSTEM                                                                                                         \
        const ulong to = *(__global const ulong *)(numbers + own_at);                                                  \
        if (b < count)                                                                                                 \
            BLOCK(sph2d__wall_force, to)[b] = force_of_wall(&s, 0, b);                                                 \
    }

static inline void reverse_span(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i) {
        s->fluid.vx[i] = -s->fluid.vx[i];
        s->fluid.vy[i] = -s->fluid.vy[i];
    }
}
SPAN(reverse_velocities, reverse_span)

/* ---- guards ------------------------------------------------------------------------------------------------------ */

KERNEL(extremes)
{
    __local sph2d__extremes parts[SPH2D__SLAB];
    const size_t i = get_global_id(0), l = get_local_id(0);
    SYSTEM
    const sph2d__limits within = *(__global const sph2d__limits *)(numbers + own_at);
    sph2d__extremes part = sph2d__no_extremes();
    if (i < count)
        sph2d__see_particle(&s.fluid, &within, i, &part);
    parts[l] = part;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (l > 0)
        return;
    for (size_t k = 1; k < SPH2D__SLAB; ++k)
        part = sph2d__join_extremes(part, parts[k]);
    ((__global sph2d__extremes *)results)[get_group_id(0)] = part;
}
