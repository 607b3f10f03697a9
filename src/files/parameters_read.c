/* SPDX-License-Identifier: MIT */
/** @file parameters_read.c
 *  Reads single values of a scene from a snapshot, for uses that do not run it, and what files gave it. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "files/scene_tables.h"
#include "files/snapshot.h"
#include "files/table_kind.h"
#include "sph2d/key.h"

enum { PATH_SIZE = 256 };

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
    sph2d__tables_each_list(scene, get_list, r);
}
