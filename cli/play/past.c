/* SPDX-License-Identifier: MIT */
/** @file past.c
 *  What a scene was before the last acts of the user. */
#include "past.h"

#include <stdlib.h>
#include <string.h>

#include "lists.h"

static const size_t MOST_BYTES = (size_t)128 << 20;

enum { VALUE = 8 }; /* bytes of a number of a state */

static void drop_at(past *p, size_t k)
{
    past_act *act = &p->acts[k];
    free(act->lists);
    free(act->arrays);
    p->bytes -= act->bytes;
    --p->count;
    memmove(act, act + 1, (p->count - k) * sizeof *act);
}

void past_drop(past *p)
{
    if (p->count > 0)
        drop_at(p, p->count - 1);
}

void past_free(past *p)
{
    while (p->count > 0)
        past_drop(p);
}

static size_t bytes_of(const sph2d_state *state)
{
    size_t bytes = state->array_count * sizeof(sph2d_array);
    for (size_t i = 0; i < state->array_count; ++i)
        bytes += state->arrays[i].components * state->arrays[i].count * VALUE;
    return bytes;
}

/* The arrays with their data behind them, one block. */
static sph2d_array *copy_of(const sph2d_state *state, size_t bytes)
{
    sph2d_array *arrays = malloc(bytes + 1);
    void *behind = arrays ? arrays + state->array_count : NULL;
    char *next = behind;
    for (size_t i = 0; arrays && i < state->array_count; ++i) {
        arrays[i] = state->arrays[i];
        arrays[i].stride = 1;
        for (unsigned c = 0; c < arrays[i].components; ++c) {
            const char *from = state->arrays[i].data[c];
            arrays[i].data[c] = next;
            for (size_t k = 0; k < arrays[i].count; ++k, next += VALUE)
                memcpy(next, from + k * state->arrays[i].stride * VALUE, VALUE);
        }
    }
    return arrays;
}

void past_keep(past *p, const char *name, const sph2d_scene *scene, const sph2d_state *state)
{
    past_act act = {.name = name, .scene = *scene, .array_count = state->array_count, .bytes = bytes_of(state)};
    while (p->count > 0 && (p->count == PAST_MOST_ACTS || p->bytes + act.bytes > MOST_BYTES))
        drop_at(p, 0);
    if (state->arrays && act.bytes <= MOST_BYTES)
        act.lists = lists_copy(&act.scene, NULL);
    act.arrays = act.lists ? copy_of(state, act.bytes) : NULL;
    if (!act.arrays) {
        free(act.lists);
        past_free(p); /* or an earlier act would be taken for this one */
        return;
    }
    p->acts[p->count++] = act;
    p->bytes += act.bytes;
}
