/* SPDX-License-Identifier: MIT */
/* The kernels that all programs have: cells, advection, sums and guards. */
/* The sizes of what host and device hand each other, as the device has them. */
__kernel void layout(ARGUMENTS)
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
}

/* ---- cells ------------------------------------------------------------------------------------------------------- */

__kernel void bounds(ARGUMENTS)
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

__kernel void empty_cells(ARGUMENTS)
{
    SYSTEM
    if (get_global_id(0) < count)
        s.fluid_cells.places[get_global_id(0)] = 0;
}

__kernel void count_cells(ARGUMENTS)
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
__kernel void scan_parts(ARGUMENTS)
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
__kernel void scan_sums(ARGUMENTS)
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
__kernel void scan_cells(ARGUMENTS)
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

__kernel void fill_cells(ARGUMENTS)
{
    const size_t i = get_global_id(0);
    SYSTEM
    if (i < count)
        ((__global uint32_t *)s.fluid.scratch)[atomic_inc(s.fluid_cells.places + s.fluid_cells.cell[i])] = (uint32_t)i;
}

/* Which thread was first is chance: a particle's place in its cell is as many as come before it in the order so far. */
__kernel void order_cells(ARGUMENTS)
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
__kernel void reorder(ARGUMENTS)
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

/* Notes what a wall did to a particle, for loads; beyond the room that there is it is counted alone. */
static inline void note_stops(__global uchar *arena, const sph2d__advection *with, sph2d_vec2 at,
                              const sph2d__stops *stops, sph2d__events *met)
{
    __global uint32_t *counter = BLOCK(uint32_t, with->contact_count);
    __global sph2d__contact *list = BLOCK(sph2d__contact, with->contacts);
    for (int k = 0; with->noted && k < stops->count; ++k) {
        const uint32_t n = atomic_inc(counter);
        ++met->noted;
        if (n < with->contact_room)
            list[n] = (sph2d__contact){at, stops->items[k].change, stops->items[k].wall};
    }
}

/* Moves particle i as sim/advect.c does it, where only walls at rest are in its way. */
static inline void advect_one(__global uchar *arena, const sph2d__system *s, const sph2d__advection *with, size_t i,
                              sph2d__way way, sph2d__events *met)
{
    const sph2d__store *f = &s->fluid;
    const sph2d__kicked who = {i, way.kick};
    sph2d_vec2 from = {f->x[i], f->y[i]}, v = way.v;
    const sph2d__end free = {{from.x + way.dx, from.y + way.dy}, v};
    sph2d_vec2 to = free.at;
    sph2d__barrier walls = with->walls;
    walls.segments = BLOCK(sph2d__piece, walls.segments);
    walls.start = BLOCK(uint32_t, walls.start);
    walls.items = BLOCK(uint32_t, walls.items);
    walls.near = BLOCK(unsigned char, walls.near);
    sph2d__stops stops;
    stops.count = 0;
    int hits = sph2d__barrier_sweep(&walls, from, &to, &v, &stops);
    if (hits > 0) {
        met->stopped += sph2d__quanta_between(s, with->quantum, who, free, (sph2d__end){to, v});
        note_stops(arena, with, from, &stops, met);
    }
    if (sph2d__wrap_end(&s->fluid_cells.period, &from, &to)) {
        const sph2d__end before = {to, v};
        stops.count = 0;
        const int held = sph2d__barrier_sweep(&walls, from, &to, &v, &stops);
        if (held > 0) {
            met->stopped += sph2d__quanta_between(s, with->quantum, who, before, (sph2d__end){to, v});
            note_stops(arena, with, from, &stops, met);
        }
        hits += held;
    }
    met->hits += (uint64_t)hits;
    met->not_finite += isfinite(to.x + to.y + v.x + v.y) ? 0 : 1;
    f->x[i] = to.x;
    f->y[i] = to.y;
    f->vx[i] = v.x;
    f->vy[i] = v.y;
}

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
    __kernel void advect(ARGUMENTS)                                                                                    \
    {                                                                                                                  \
        __local sph2d__events parts[SPH2D__SLAB];                                                                      \
        const size_t i = get_global_id(0);                                                                             \
        SYSTEM                                                                                                         \
        const sph2d__advection with = *(__global const sph2d__advection *)(numbers + own_at);                          \
        sph2d__events met = {0};                                                                                       \
        if (i < count) {                                                                                               \
            const sph2d__way way = set(&s, with.dt, i);                                                                \
            met.diffused = sph2d__quanta_of(with.quantum, way.diffused);                                               \
            advect_one(arena, &s, &with, i, way, &met);                                                                \
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

static inline void reverse_span(sph2d__system *s, size_t first, size_t last)
{
    for (size_t i = first; i < last; ++i) {
        s->fluid.vx[i] = -s->fluid.vx[i];
        s->fluid.vy[i] = -s->fluid.vy[i];
    }
}
SPAN(reverse_velocities, reverse_span)

/* ---- guards ------------------------------------------------------------------------------------------------------ */

__kernel void extremes(ARGUMENTS)
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
