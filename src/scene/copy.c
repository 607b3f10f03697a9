/* SPDX-License-Identifier: MIT */
/** @file copy.c
 *  The copy of a scene that a world owns: deep, by the key table, which lists all pointers but those to particles and
 *  values at the start. */

#include <stdint.h>
#include <string.h>

#include "scene/world.h"
#include "sph2d/key.h"

typedef struct copier {
    sph2d__arena *arena;
    sph2d__memory *memory;
} copier;

/** Replaces the pointer at `slot`, to `count` items of `size` bytes, by one to a copy of them. */
static bool copy_items(copier *c, void *slot, size_t count, size_t size)
{
    const void *items;
    memcpy(&items, slot, sizeof items);
    if (!items || count == 0)
        return true;
    void *fresh = sph2d__arena_alloc(c->arena, c->memory, count, size);
    if (!fresh)
        return false;
    memcpy(fresh, items, count * size);
    memcpy(slot, &fresh, sizeof fresh);
    return true;
}

/** Copies the pointees of `owner`, which is a shallow copy of the original. */
static bool copy_struct(copier *c, const sph2d_keys *keys, char *owner)
{
    for (size_t k = 0; k < keys->count; ++k) {
        const sph2d_key *key = &keys->items[k];
        char *slot = owner + key->offset;
        const size_t *count = (const size_t *)(const void *)(owner + key->count_offset);
        bool ok = true;
        if (key->choice && *(const int *)(const void *)(owner + key->choice_offset) != key->choice)
            continue; /* the pointer of another choice is not valid */
        switch (key->kind) {
        case SPH2D_KEY_TEXT: {
            const char *text;
            memcpy(&text, slot, sizeof text);
            ok = !text || copy_items(c, slot, strlen(text) + 1, 1);
            break;
        }
        case SPH2D_KEY_POINTS:
            ok = copy_items(c, slot, *count, sizeof(sph2d_vec2));
            break;
        case SPH2D_KEY_PATH:
            ok = copy_items(c, slot, *count, sizeof(sph2d_path_point));
            break;
        case SPH2D_KEY_POSES:
            ok = copy_items(c, slot, *count, sizeof(sph2d_pose_point));
            break;
        case SPH2D_KEY_NUMBERS:
            ok = copy_items(c, slot, *count, sizeof(double));
            break;
        case SPH2D_KEY_GROUP:
            ok = copy_struct(c, key->keys, slot);
            break;
        case SPH2D_KEY_LIST:
            ok = copy_items(c, slot, *count, key->keys->size);
            if (ok && *count > 0) {
                char *items;
                memcpy(&items, slot, sizeof items);
                for (size_t i = 0; ok && i < *count; ++i)
                    ok = copy_struct(c, key->keys, items + i * key->keys->size);
            }
            break;
        case SPH2D_KEY_NUMBER:
        case SPH2D_KEY_COUNT:
        case SPH2D_KEY_COUNTS2:
        case SPH2D_KEY_WORD:
        case SPH2D_KEY_POINT:
            break;
        }
        if (!ok)
            return false;
    }
    return true;
}

/** Copies the values of a start, which no key holds. */
static bool copy_start(copier *c, sph2d_start *start)
{
    sph2d_grid *g = &start->table;
    size_t places = g->nx > 1 && g->ny > 1 && g->nx <= SIZE_MAX / g->ny ? g->nx * g->ny : 0;
    if (places == 0) /* no table: the checks say so */
        g->vx = g->vy = g->pressure = NULL;
    return copy_items(c, &g->x, g->nx, sizeof(double)) && copy_items(c, &g->y, g->ny, sizeof(double)) &&
           copy_items(c, &g->vx, places, sizeof(double)) && copy_items(c, &g->vy, places, sizeof(double)) &&
           copy_items(c, &g->pressure, places, sizeof(double)) &&
           copy_items(c, &start->snapshot.items, start->snapshot.count, sizeof(sph2d_cloud_point));
}

bool sph2d__scene_copy(const sph2d_scene *from, sph2d__arena *arena, sph2d__memory *memory, sph2d_scene *to)
{
    *to = *from;
    copier c = {arena, memory};
    bool ok = copy_struct(&c, sph2d_scene_keys(), (char *)to) &&
              copy_items(&c, &to->particles.items, to->particles.count, sizeof(sph2d_particle)) &&
              copy_start(&c, &to->start);
    for (size_t i = 0; ok && i < to->block_count; ++i)
        ok = copy_start(&c, (sph2d_start *)(uintptr_t)&to->blocks[i].start); /* of the fresh list */
    return ok;
}
