/* SPDX-License-Identifier: MIT */
/** @file store.c
 *  The particle store: memory, sorting, removal. */
#include "particles/store.h"

#include <string.h>

#include "base/parallel.h"

_Static_assert(sizeof(double) == sizeof(uint64_t), "ids are reordered through the same scratch array as doubles");

/** Length of the arrays for a capacity. */
static size_t length_of(size_t capacity)
{
    return capacity > 0 ? capacity + SPH2D__PADDING : 0;
}

/** The addresses of a store's arrays of doubles, in the order of their indices. */
static void list_reals(sph2d__store *store, double **slots[SPH2D__STORE_COUNT])
{
    int n = 0;
#define SLOT(name) slots[n++] = &store->name;
    SPH2D__STORE_REALS(SLOT)
#undef SLOT
}

enum { MAX_BLOCKS = SPH2D__STORE_COUNT + 3 };

/** Lists the blocks of the store, which are grown and freed together. Returns their number. */
static size_t list_blocks(sph2d__store *store, sph2d__growth blocks[MAX_BLOCKS])
{
    double **slots[SPH2D__STORE_COUNT];
    list_reals(store, slots);
    size_t n = 0;
    for (int a = 0; a < SPH2D__STORE_COUNT; ++a)
        if (store->has >> a & 1)
            blocks[n++] = (sph2d__growth){slots[a], sizeof(double)};
    blocks[n++] = (sph2d__growth){&store->scratch, sizeof(double)};
    blocks[n++] = (sph2d__growth){&store->id, sizeof(uint64_t)};
    if (store->colored)
        blocks[n++] = (sph2d__growth){&store->color, sizeof(uint64_t)};
    return n;
}

size_t sph2d__store_bytes(const sph2d__store *store)
{
    size_t arrays = 1;
    for (int a = 0; a < SPH2D__STORE_COUNT; ++a)
        arrays += store->has >> a & 1;
    return arrays * sizeof(double) + (store->colored ? 2 : 1) * sizeof(uint64_t);
}

bool sph2d__store_reserve(sph2d__store *store, sph2d__memory *memory, size_t capacity)
{
    if (capacity <= store->capacity)
        return true;
    size_t grown = store->capacity + store->capacity / 2;
    capacity = capacity > grown ? capacity : grown;
    sph2d__growth blocks[MAX_BLOCKS];
    size_t count = list_blocks(store, blocks);
    if (!sph2d__grow_all(memory, blocks, count, length_of(store->capacity), length_of(capacity)))
        return false;
    store->capacity = capacity;
    return true;
}

void sph2d__store_free(sph2d__store *store, sph2d__memory *memory)
{
    sph2d__growth blocks[MAX_BLOCKS];
    size_t count = list_blocks(store, blocks);
    for (size_t i = 0; i < count; ++i) {
        void *block;
        memcpy(&block, blocks[i].slot, sizeof block);
        sph2d__release(memory, &block, length_of(store->capacity), blocks[i].size);
        memcpy(blocks[i].slot, &block, sizeof block);
    }
    store->count = store->capacity = 0;
}

size_t sph2d__store_add(sph2d__store *store, uint64_t id, double x, double y)
{
    size_t i = store->count++;
    double **slots[SPH2D__STORE_COUNT];
    list_reals(store, slots);
    for (int a = 0; a < SPH2D__STORE_COUNT; ++a)
        if (store->has >> a & 1)
            (*slots[a])[i] = 0;
    store->x[i] = x;
    store->y[i] = y;
    store->id[i] = id;
    if (store->colored)
        store->color[i] = 0;
    return i;
}

/** Reorders an array of whole numbers, which changes places with the scratch array. */
static void reorder_counts(sph2d__store *store, uint64_t **array, const uint32_t *order)
{
    const size_t count = store->count;
    uint64_t *from = *array, *to = store->scratch;
#pragma omp taskloop num_tasks(sph2d__tasks(count, SPH2D__GRAIN)) if (count > SPH2D__GRAIN)
    for (size_t k = 0; k < count; ++k)
        to[k] = from[order[k]];
    *array = to;
    store->scratch = from;
}

void sph2d__store_reorder(sph2d__store *store, const uint32_t *order)
{
    double **slots[SPH2D__STORE_COUNT];
    list_reals(store, slots);
    const sph2d__set moved = store->has & store->carried;
    const size_t count = store->count;
    for (int a = 0; a < SPH2D__STORE_COUNT; ++a) {
        if (!(moved >> a & 1))
            continue;
        double *from = *slots[a], *to = store->scratch;
#pragma omp taskloop num_tasks(sph2d__tasks(count, SPH2D__GRAIN)) if (count > SPH2D__GRAIN)
        for (size_t k = 0; k < count; ++k)
            to[k] = from[order[k]];
        *slots[a] = to;
        store->scratch = from;
    }
    reorder_counts(store, &store->id, order);
    if (store->colored)
        reorder_counts(store, &store->color, order);
}

/** Moves the values without a flag to the front of an array. */
static void keep(void *array, size_t size, size_t count, const unsigned char *flags)
{
    char *values = array;
    size_t kept = 0;
    for (size_t i = 0; i < count; ++i)
        if (!flags[i])
            memmove(values + size * kept++, values + size * i, size);
}

void sph2d__store_remove(sph2d__store *store, const unsigned char *flags)
{
    double **slots[SPH2D__STORE_COUNT];
    list_reals(store, slots);
    for (int a = 0; a < SPH2D__STORE_COUNT; ++a)
        if (store->has >> a & 1)
            keep(*slots[a], sizeof(double), store->count, flags);
    keep(store->id, sizeof(uint64_t), store->count, flags);
    if (store->colored)
        keep(store->color, sizeof(uint64_t), store->count, flags);
    size_t kept = 0;
    for (size_t i = 0; i < store->count; ++i)
        kept += !flags[i];
    store->count = kept;
}
