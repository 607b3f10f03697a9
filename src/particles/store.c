/* SPDX-License-Identifier: MIT */
/** @file store.c
 *  The particle store: room, order, removal. */
#include "particles/store.h"

#include <string.h>

#include "base/threads.h"

/** Length of the arrays for a capacity. */
static size_t length_of(size_t capacity)
{
    return capacity > 0 ? capacity + SPH2D__PADDING : 0;
}

/* Every array of a store, as blocks that grow and go together. */
#define SLOT(name, carried) {&store->name, sizeof(double)},
#define ALL_ARRAYS(store)                                                                                              \
    {                                                                                                                  \
        SPH2D__STORE_REALS(SLOT){&(store)->scratch, sizeof(double)}, {&(store)->id, sizeof(uint64_t)},                 \
        {                                                                                                              \
            &(store)->scratch_id, sizeof(uint64_t)                                                                     \
        }                                                                                                              \
    }

bool sph2d__store_reserve(sph2d__store *store, sph2d__memory *memory, size_t capacity)
{
    if (capacity <= store->capacity)
        return true;
    size_t grown = store->capacity + store->capacity / 2;
    capacity = capacity > grown ? capacity : grown;
    const sph2d__growth arrays[] = ALL_ARRAYS(store);
    if (!sph2d__grow_all(memory, arrays, sizeof arrays / sizeof arrays[0], length_of(store->capacity),
                         length_of(capacity)))
        return false;
    store->capacity = capacity;
    return true;
}

void sph2d__store_free(sph2d__store *store, sph2d__memory *memory)
{
    const sph2d__growth arrays[] = ALL_ARRAYS(store);
    for (size_t i = 0; i < sizeof arrays / sizeof arrays[0]; ++i) {
        void *block;
        memcpy(&block, arrays[i].slot, sizeof block);
        sph2d__release(memory, &block, length_of(store->capacity), arrays[i].size);
        memcpy(arrays[i].slot, &block, sizeof block);
    }
    store->count = store->capacity = 0;
}

size_t sph2d__store_add(sph2d__store *store, uint64_t id, double x, double y)
{
    size_t i = store->count++;
#define ZERO(name, carried) store->name[i] = 0;
    SPH2D__STORE_REALS(ZERO)
#undef ZERO
    store->x[i] = x;
    store->y[i] = y;
    store->id[i] = id;
    return i;
}

static void gather_reals(double **array, double **scratch, const uint32_t *order, size_t count, int threads)
{
    const double *from = *array;
    double *to = *scratch;
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (size_t k = 0; k < count; ++k)
        to[k] = from[order[k]];
    *scratch = *array;
    *array = to;
}

void sph2d__store_reorder(sph2d__store *store, const uint32_t *order, int threads)
{
    threads = sph2d__threads_for(threads, store->count);
#define GATHER(name, carried)                                                                                          \
    if (carried)                                                                                                       \
        gather_reals(&store->name, &store->scratch, order, store->count, threads);
    SPH2D__STORE_REALS(GATHER)
#undef GATHER
    uint64_t *to = store->scratch_id;
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (size_t k = 0; k < store->count; ++k)
        to[k] = store->id[order[k]];
    store->scratch_id = store->id;
    store->id = to;
}

void sph2d__store_remove(sph2d__store *store, const unsigned char *flags)
{
    size_t kept = 0;
    for (size_t i = 0; i < store->count; ++i) {
        if (flags[i])
            continue;
        if (kept != i) {
#define MOVE(name, carried) store->name[kept] = store->name[i];
            SPH2D__STORE_REALS(MOVE)
#undef MOVE
            store->id[kept] = store->id[i];
        }
        ++kept;
    }
    store->count = kept;
}
