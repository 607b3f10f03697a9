/* SPDX-License-Identifier: MIT */
/* What all programs of devices begin with: their language, the system as a kernel sees it, the shapes of kernels. A method's program
 * (methods/NAME/NAME.cl) includes it, defines SYSTEM, which declares `s`, includes kernels.cl, and defines its own kernels.
 *
 * The build puts a program together from the same headers as the library, with those of src/device/clc in place of C's. */
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

#include "boundary/sweep.c"
#include "particles/ranges.c"
#include "sim/device_data.h"
#include "sim/extremes.h"

/* ---- arguments --------------------------------------------------------------------------------------------------- */

/* The arena of all blocks, the numbers of all slots, where the system's and the kernel's own begin, how many threads have something to
 * do, where results go. */
#define ARGUMENTS                                                                                                      \
    __global uchar *arena, __global const uchar *numbers, const ulong system_at, const ulong own_at, const ulong count, \
        __global uchar *results_of_all, const ulong results_at

/* All are run in groups of that many, for which the compiler keeps registers. */
#define KERNEL(name) __kernel __attribute__((reqd_work_group_size(SPH2D__SLAB, 1, 1))) void name(ARGUMENTS)

/* A kernel's own. */
#define results (results_of_all + results_at)

/* The block at an offset, which stands where the host has an address. */
#define BLOCK(type, pointer) ((pointer) ? (__global type *)(arena + (ulong)(pointer)) : (__global type *)0)

static inline void place_store(__global uchar *arena, sph2d__store *t)
{
#define PLACE(name) t->name = BLOCK(double, t->name);
    SPH2D__STORE_REALS(PLACE)
#undef PLACE
    t->id = BLOCK(uint64_t, t->id);
    t->color = BLOCK(uint64_t, t->color);
    t->scratch = BLOCK(void, t->scratch);
}

static inline void place_cells(__global uchar *arena, sph2d__cells *c)
{
    c->start = BLOCK(uint32_t, c->start);
    c->places = BLOCK(uint32_t, c->places);
    c->cell = BLOCK(uint32_t, c->cell);
    c->order = BLOCK(uint32_t, c->order);
}

/* The host's system, with addresses of the device. */
static inline sph2d__system placed(__global uchar *arena, __global const uchar *at)
{
    sph2d__system s = *(__global const sph2d__system *)at;
    place_store(arena, &s.fluid);
    place_store(arena, &s.walls);
    place_cells(arena, &s.fluid_cells);
    place_cells(arena, &s.wall_cells);
    s.neighbours.slices = BLOCK(sph2d__slice, s.neighbours.slices);
    s.neighbours.index = BLOCK(uint32_t, s.neighbours.index);
    s.wall_slips = BLOCK(const unsigned char, s.wall_slips);
    s.tables = BLOCK(sph2d__tables, s.tables);
    s.wall_spin = BLOCK(double, s.wall_spin);
    s.viscosities = 0;
    s.forces.points.items = BLOCK(const sph2d__point_force, s.forces.points.items);
    return s;
}

/* ---- shapes of kernels ------------------------------------------------------------------------------------------- */

/* A function of a span of particles. */
#define SPAN(name, function)                                                                                           \
    KERNEL(name)                                                                                                       \
    {                                                                                                                  \
        const size_t i = get_global_id(0);                                                                             \
        SYSTEM                                                                                                         \
        if (i < count)                                                                                                 \
            function(&s, i, i + 1);                                                                                    \
    }

/* A function of one particle, with arguments of a type. */
#define WITH(name, type, function)                                                                                     \
    KERNEL(name)                                                                                                       \
    {                                                                                                                  \
        const size_t i = get_global_id(0);                                                                             \
        SYSTEM                                                                                                         \
        const type with = *(__global const type *)(numbers + own_at);                                                  \
        if (i < count)                                                                                                 \
            function(&s, i, &with);                                                                                    \
    }

/* The same of one that adds to the sums of its slab, to each once. They are added in the order of the particles, as the host does it. */
#define SUM(name, type, function)                                                                                      \
    KERNEL(name)                                                                                                       \
    {                                                                                                                  \
        __local sph2d__slab_sum parts[SPH2D__SLAB];                                                                    \
        const size_t i = get_global_id(0);                                                                             \
        SYSTEM                                                                                                         \
        const type with = *(__global const type *)(numbers + own_at);                                                  \
        sph2d__slab_sum sum = {0};                                                                                     \
        if (i < count)                                                                                                 \
            function(&s, i, &with, &sum);                                                                              \
        parts[get_local_id(0)] = sum;                                                                                  \
        add_parts(parts, (size_t)get_group_id(0) * SPH2D__SLAB, count, results);                                       \
    }

/* The same without arguments. */
#define TOTAL(name, function)                                                                                          \
    static inline void name##_one(sph2d__system *s, size_t i, const int *none, sph2d__slab_sum *sum)                   \
    {                                                                                                                  \
        function(s, i, sum);                                                                                           \
    }                                                                                                                  \
    SUM(name, int, name##_one)

/* The same of a span. */
#define SWEEP(name, function)                                                                                          \
    static inline void name##_one(sph2d__system *s, size_t i, const int *none, sph2d__slab_sum *sum)                   \
    {                                                                                                                  \
        function(s, i, i + 1, sum);                                                                                    \
    }                                                                                                                  \
    SUM(name, int, name##_one)

static inline void add_parts(__local const sph2d__slab_sum *parts, size_t first, size_t count, __global uchar *to)
{
    enum { SUMS = sizeof(sph2d__slab_sum) / sizeof(double) - 1 };
    const size_t l = get_local_id(0), some = count - first < SPH2D__SLAB ? count - first : SPH2D__SLAB;
    __local const double *values = (__local const double *)parts;
    double sum = 0;
    barrier(CLK_LOCAL_MEM_FENCE);
    if (l > SUMS)
        return;
    for (size_t k = 0; k < some; ++k) {
        const double value = values[k * (SUMS + 1) + l];
        sum = l < SUMS ? sum + value : value > sum ? value : sum;
    }
    ((__global double *)to)[get_group_id(0) * (SUMS + 1) + l] = sum;
}
