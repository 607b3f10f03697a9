/* SPDX-License-Identifier: MIT */
/** @file parameters.c
 *  The values of a scene in a snapshot by the table of keys: `fluid.density`, `blocks[0].box.min`. Written all; read, for uses
 *  that do not run it, as single values, and what files gave it. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "files/scene_file.h"
#include "files/snapshot.h"
#include "files/table_kind.h"
#include "sph2d/key.h"

enum { PATH_SIZE = 256 };

/* ---- writing ----------------------------------------------------------------------------------------------------- */

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

/* ---- reading ----------------------------------------------------------------------------------------------------- */

static void check_range(sph2d__h5_reader *r, const sph2d_key *key, const char *path, double value)
{
    if ((key->zero_is_unset && value == 0) || (key->nan_is_unset && isnan(value)))
        return;
    if (!isfinite(value) || value < key->min || value > key->max || (key->min_excluded && value <= key->min))
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%.100s' is out of range", path);
}

static void get_reals(sph2d__h5_reader *r, const sph2d_key *key, const char *path, double *out, size_t count)
{
    if (sph2d__h5_get_reals(r, SPH2D__GROUP_PARAMETERS, path, out, count))
        for (size_t i = 0; i < count; ++i)
            check_range(r, key, path, out[i]);
}

static void get_counts(sph2d__h5_reader *r, const sph2d_key *key, const char *path, uint64_t *out, size_t count)
{
    if (sph2d__h5_get_counts(r, SPH2D__GROUP_PARAMETERS, path, out, count))
        for (size_t i = 0; i < count; ++i)
            check_range(r, key, path, (double)out[i]);
}

static void get_word(sph2d__h5_reader *r, const sph2d_key *key, const char *path, void *slot)
{
    const char *text = sph2d__h5_get_text(r, SPH2D__GROUP_PARAMETERS, path);
    if (!text)
        return;
    for (int word = 0; key->words[word]; ++word)
        if (strcmp(key->words[word], text) == 0) {
            memcpy(slot, &word, sizeof word);
            return;
        }
    sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%.100s' has a value that this program does not know: '%.60s'", path,
                     text);
}

static void get_key(sph2d__h5_reader *r, const sph2d_key *key, const char *path, void *slot)
{
    const char *text;
    switch (key->kind) {
    case SPH2D_KEY_NUMBER:
        get_reals(r, key, path, slot, 1);
        break;
    case SPH2D_KEY_POINT:
        get_reals(r, key, path, slot, 2);
        break;
    case SPH2D_KEY_COUNT:
        get_counts(r, key, path, slot, 1);
        break;
    case SPH2D_KEY_COUNTS2:
        get_counts(r, key, path, slot, 2);
        break;
    case SPH2D_KEY_WORD:
        get_word(r, key, path, slot);
        break;
    case SPH2D_KEY_TEXT:
        text = sph2d__h5_get_text(r, SPH2D__GROUP_PARAMETERS, path);
        if (text)
            memcpy(slot, &text, sizeof text);
        break;
    default:
        break;
    }
}

/** Keys missing in the file keep their defaults, unless they are required. */
static void get_struct(sph2d__h5_reader *r, const sph2d_keys *keys, char *base, const char *above)
{
    for (size_t i = 0; i < keys->count; ++i) {
        const sph2d_key *key = &keys->items[i];
        char path[PATH_SIZE];
        snprintf(path, sizeof path, "%s%s%s", above, above[0] ? "." : "", key->name);
        if (key->kind == SPH2D_KEY_GROUP)
            get_struct(r, key->keys, base + key->offset, path);
        else if (key->required || sph2d__h5_has(r, SPH2D__GROUP_PARAMETERS, path))
            get_key(r, key, path, base + key->offset);
    }
}

void sph2d__snapshot_get_parameters(sph2d__h5_reader *r, sph2d_scene *scene)
{
    *scene = sph2d_scene_default();
    get_struct(r, sph2d_scene_keys(), (char *)scene, "");
}

/* ---- what files gave --------------------------------------------------------------------------------------------- */

/** Makes a list of zeros with as many items as the file has: each of them has the key `each`. */
static void *make_items(sph2d__h5_reader *r, const char *list, const char *each, size_t size, size_t *count)
{
    char key[64];
    *count = 0;
    do
        snprintf(key, sizeof key, "%s[%zu].%s", list, *count, each);
    while (sph2d__h5_has(r, SPH2D__GROUP_PARAMETERS, key) && ++*count);
    void *items = sph2d__pool_alloc(r->pool, *count, size);
    if (!items) {
        r->status = SPH2D_NOMEM;
        *count = 0;
    }
    return items;
}

/** Reads a list over time, if the file has it. */
static void get_list(void *context, const char *key, size_t width, void *list)
{
    sph2d__h5_reader *r = context;
    sph2d__h5_item item;
    if (r->status == SPH2D_NOMEM || !sph2d__h5_has(r, SPH2D__GROUP_PARAMETERS, key) ||
        !sph2d__h5_item_open(r, SPH2D__GROUP_PARAMETERS, key, &item))
        return;
    double *rows = NULL;
    if (H5Tget_class(item.type) != H5T_FLOAT || item.rank != 2)
        sph2d__h5_refuse(r, SPH2D_CODE_FILE_FIELD, "'%.100s' has the wrong shape or type", key);
    else if (!(rows = sph2d__pool_alloc(r->pool, item.sizes[0] * item.sizes[1] + 1, sizeof *rows)))
        r->status = SPH2D_NOMEM;
    else if (sph2d__h5_item_read(r, &item, H5T_NATIVE_DOUBLE, rows, key) && item.sizes[1] == width)
        memcpy(list, &(sph2d__list){rows, item.sizes[0]}, sizeof(sph2d__list));
    sph2d__h5_item_close(&item);
}

void sph2d__snapshot_get_given(sph2d__h5_reader *r, sph2d_scene *scene)
{
    sph2d_block *blocks = make_items(r, "blocks", "velocity", sizeof *blocks, &scene->block_count);
    for (size_t i = 0; i < scene->block_count && r->status != SPH2D_NOMEM; ++i) {
        char key[64];
        snprintf(key, sizeof key, "blocks[%zu].start.top_speed", i);
        if (sph2d__h5_has(r, SPH2D__GROUP_PARAMETERS, key))
            sph2d__h5_get_reals(r, SPH2D__GROUP_PARAMETERS, key, &blocks[i].start.top_speed, 1);
    }
    scene->blocks = blocks;
    scene->obstacles = make_items(r, "obstacles", "restitution", sizeof *scene->obstacles, &scene->obstacle_count);
    scene->openings = make_items(r, "openings", "side", sizeof *scene->openings, &scene->opening_count);
    scene->drains = make_items(r, "drains", "start", sizeof *scene->drains, &scene->drain_count);
    scene->bodies = make_items(r, "bodies", "friction", sizeof *scene->bodies, &scene->body_count);
    sph2d__tables_each_list(scene, get_list, r);
}
