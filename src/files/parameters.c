/* SPDX-License-Identifier: MIT */
/** @file parameters.c
 *  Writes the values of a scene to a snapshot by the table of keys: `fluid.density`, `blocks[0].box.min`. */
#include <stdio.h>
#include <string.h>

#include "files/snapshot_parts.h"
#include "sph2d/key.h"

enum { PATH_SIZE = 256 };

static void put_struct(sph2d__h5_writer *w, hid_t at, const sph2d_keys *keys, const char *base, const char *above);

/** Writes a list of tuples of `width` doubles; nothing for an empty list. */
static void put_tuples(sph2d__h5_writer *w, hid_t at, const char *path, const void *items, size_t count, size_t width)
{
    if (count > 0)
        sph2d__h5_put(w, at, path, H5T_NATIVE_DOUBLE, count, width > 1 ? width : 0, items);
}

static size_t width_of(sph2d_key_kind kind)
{
    return kind == SPH2D_KEY_POINTS ? 2 : kind == SPH2D_KEY_PATH ? 3 : kind == SPH2D_KEY_POSES ? 4 : 1;
}

static void put_list(sph2d__h5_writer *w, hid_t at, const sph2d_keys *keys, const char *items, size_t count,
                     const char *path)
{
    for (size_t i = 0; i < count && w->ok; ++i) {
        char item[PATH_SIZE];
        snprintf(item, sizeof item, "%.200s[%zu]", path, i);
        put_struct(w, at, keys, items + i * keys->size, item);
    }
}

/** Writes keys whose slot is a pointer: lists with their count, and texts. */
static void put_pointed(sph2d__h5_writer *w, hid_t at, const sph2d_key *key, const char *base, const char *path)
{
    const void *items;
    size_t count = 0;
    memcpy(&items, base + key->offset, sizeof items);
    if (key->kind != SPH2D_KEY_TEXT)
        memcpy(&count, base + key->count_offset, sizeof count);
    if (key->kind == SPH2D_KEY_LIST)
        put_list(w, at, key->keys, items, count, path);
    else if (key->kind != SPH2D_KEY_TEXT)
        put_tuples(w, at, path, items, count, width_of(key->kind));
    else if (items)
        sph2d__h5_put_text(w, at, path, items);
}

static void put_key(sph2d__h5_writer *w, hid_t at, const sph2d_key *key, const char *base, const char *path)
{
    const void *slot = base + key->offset;
    int word = 0;
    switch (key->kind) {
    case SPH2D_KEY_NUMBER:
        sph2d__h5_put_reals(w, at, path, slot, 0);
        break;
    case SPH2D_KEY_COUNT:
        sph2d__h5_put_counts(w, at, path, slot, 0);
        break;
    case SPH2D_KEY_COUNTS2:
        sph2d__h5_put_counts(w, at, path, slot, 2);
        break;
    case SPH2D_KEY_WORD:
        memcpy(&word, slot, sizeof word);
        sph2d__h5_put_text(w, at, path, key->words[word]);
        break;
    case SPH2D_KEY_POINT:
        sph2d__h5_put_reals(w, at, path, slot, 2);
        break;
    case SPH2D_KEY_GROUP:
        put_struct(w, at, key->keys, slot, path);
        break;
    case SPH2D_KEY_TEXT:
    case SPH2D_KEY_POINTS:
    case SPH2D_KEY_PATH:
    case SPH2D_KEY_POSES:
    case SPH2D_KEY_NUMBERS:
    case SPH2D_KEY_LIST:
        put_pointed(w, at, key, base, path);
        break;
    }
}

static void put_struct(sph2d__h5_writer *w, hid_t at, const sph2d_keys *keys, const char *base, const char *above)
{
    for (size_t i = 0; i < keys->count && w->ok; ++i) {
        const sph2d_key *key = &keys->items[i];
        int choice = key->choice;
        if (choice)
            memcpy(&choice, base + key->choice_offset, sizeof choice);
        char path[PATH_SIZE];
        snprintf(path, sizeof path, "%s%s%s", above, above[0] ? "." : "", key->name);
        if (choice == key->choice)
            put_key(w, at, key, base, path);
    }
}

void sph2d__snapshot_put_parameters(sph2d__h5_writer *w, const sph2d_scene *scene)
{
    hid_t at = sph2d__h5_group(w, SPH2D__GROUP_PARAMETERS);
    put_struct(w, at, sph2d_scene_keys(), (const char *)scene, "");
    sph2d__h5_close(at);
    sph2d__h5_close(sph2d__h5_group(w, "/UnusedParameters")); /* some readers expect it */
}
