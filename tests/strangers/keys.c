/* SPDX-License-Identifier: MIT */
/* Which keys of the scene's language a set of scenes does not use. */
#include <stdlib.h>
#include <string.h>

#include "judge.h"
#include "sph2d/key.h"

enum { MOST_KEYS = 1000, PATH_SIZE = 120 };

/** A key that has a value: "obstacles.motion.rate". */
typedef struct leaf {
    char path[PATH_SIZE];
    bool used;
} leaf;

typedef struct leaves {
    leaf items[MOST_KEYS];
    size_t count;
} leaves;

static void join(char out[PATH_SIZE], const char *path, const char *name)
{
    snprintf(out, PATH_SIZE, "%s%s%s", path, path[0] ? "." : "", name);
}

static void list_leaves(leaves *all, const sph2d_keys *keys, const char *path)
{
    for (size_t i = 0; i < keys->count && all->count < MOST_KEYS; ++i) {
        char inner[PATH_SIZE];
        join(inner, path, keys->items[i].name);
        if (keys->items[i].keys)
            list_leaves(all, keys->items[i].keys, inner);
        else
            memcpy(all->items[all->count++].path, inner, PATH_SIZE);
    }
}

/** Bytes of a value that is no list and no text. */
static size_t size_of(sph2d_key_kind kind)
{
    return kind == SPH2D_KEY_WORD                                 ? sizeof(int)
           : kind == SPH2D_KEY_POINT || kind == SPH2D_KEY_COUNTS2 ? 2 * sizeof(double)
                                                                  : sizeof(double);
}

/** Whether the value is another than the default, or must be given. */
static bool is_given(const sph2d_key *key, const char *owner, const char *defaults)
{
    const char *text = NULL, *usual = NULL;
    size_t count = 0;
    switch (key->kind) {
    case SPH2D_KEY_TEXT:
        memcpy(&text, owner + key->offset, sizeof text);
        memcpy(&usual, defaults + key->offset, sizeof usual);
        return text && (!usual || strcmp(text, usual) != 0);
    case SPH2D_KEY_POINTS:
    case SPH2D_KEY_PATH:
    case SPH2D_KEY_POSES:
    case SPH2D_KEY_NUMBERS:
        memcpy(&count, owner + key->count_offset, sizeof count);
        return count > 0;
    default:
        return key->required || memcmp(owner + key->offset, defaults + key->offset, size_of(key->kind)) != 0;
    }
}

static void mark(leaves *all, const char *path)
{
    for (size_t i = 0; i < all->count; ++i)
        if (strcmp(all->items[i].path, path) == 0)
            all->items[i].used = true;
}

static void mark_struct(leaves *all, const sph2d_keys *keys, const char *owner, const char *defaults, const char *path);

static void mark_items(leaves *all, const sph2d_key *key, const char *owner, const char *path)
{
    const char *items;
    size_t count;
    memcpy(&items, owner + key->offset, sizeof items);
    memcpy(&count, owner + key->count_offset, sizeof count);
    char *defaults = calloc(1, key->keys->size);
    if (defaults && key->keys->set_default)
        key->keys->set_default(defaults);
    for (size_t i = 0; defaults && i < count; ++i)
        mark_struct(all, key->keys, items + i * key->keys->size, defaults, path);
    free(defaults);
}

static void mark_struct(leaves *all, const sph2d_keys *keys, const char *owner, const char *defaults, const char *path)
{
    for (size_t i = 0; i < keys->count; ++i) {
        const sph2d_key *key = &keys->items[i];
        char inner[PATH_SIZE];
        int choice = 0;
        if (key->choice)
            memcpy(&choice, owner + key->choice_offset, sizeof choice);
        if (choice != key->choice)
            continue;
        join(inner, path, key->name);
        if (key->kind == SPH2D_KEY_GROUP)
            mark_struct(all, key->keys, owner + key->offset, defaults + key->offset, inner);
        else if (key->kind == SPH2D_KEY_LIST)
            mark_items(all, key, owner, inner);
        else if (is_given(key, owner, defaults))
            mark(all, inner);
    }
}

int tell_unused(const char *const *scenes, size_t count)
{
    static leaves all;
    const sph2d_scene defaults = sph2d_scene_default();
    list_leaves(&all, sph2d_scene_keys(), "");
    for (size_t i = 0; i < count; ++i) {
        sph2d_scene_file *file = NULL;
        sph2d_report report = {0};
        if (sph2d_scene_file_read(scenes[i], NULL, 0, &file, &report) != SPH2D_OK) {
            fprintf(stderr, "strangers: cannot read '%s'\n", scenes[i]);
            sph2d_report_clear(&report);
            return 2;
        }
        mark_struct(&all, sph2d_scene_keys(), (const char *)sph2d_scene_file_scene(file), (const char *)&defaults, "");
        sph2d_scene_file_destroy(file);
        sph2d_report_clear(&report);
    }
    for (size_t i = 0; i < all.count; ++i)
        if (!all.items[i].used)
            puts(all.items[i].path);
    return 0;
}
