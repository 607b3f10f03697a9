/* SPDX-License-Identifier: MIT */
/** @file completion.c
 *  Paths of keys by the table, with as many items as the lists of a scene have. */
#include "completion.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <sph2d/io.h>
#include <sph2d/key.h>
#include <sph2d/study.h>

#include "input.h"

enum { PATH_SIZE = 256 };

static void print_key(const char *path, const char *const *words)
{
    printf("key\t%s\t", path);
    for (size_t i = 0; words && words[i]; ++i)
        printf("%s%s", i > 0 ? " " : "", words[i]);
    puts(words ? "" : "-");
}

static void print_keys(const sph2d_keys *keys, const char *base, const char *above);

/* Without a list there is one item, to show how its keys are written. */
static void print_list(const sph2d_key *key, const char *base, const char *path)
{
    const char *items = NULL;
    size_t count = 1;
    if (base) {
        memcpy(&items, base + key->offset, sizeof items);
        memcpy(&count, base + key->count_offset, sizeof count);
    }
    print_key(path, NULL);
    for (size_t i = 0; i < count; ++i) {
        char item[PATH_SIZE];
        snprintf(item, sizeof item, "%.200s[%zu].", path, i);
        print_keys(key->keys, items ? items + i * key->keys->size : NULL, item);
    }
}

static void print_group(const sph2d_key *key, const char *base, const char *path)
{
    char inner[PATH_SIZE];
    for (size_t i = 0; i < key->keys->count; ++i)
        if (key->keys->items[i].stands_alone)
            print_key(path, key->keys->items[i].words);
    snprintf(inner, sizeof inner, "%.250s.", path);
    print_keys(key->keys, base ? base + key->offset : NULL, inner);
}

/* The keys of a struct, NULL where there is none. Those that another one excludes cannot be set. */
static void print_keys(const sph2d_keys *keys, const char *base, const char *above)
{
    for (size_t i = 0; i < keys->count; ++i) {
        const sph2d_key *key = &keys->items[i];
        int choice = 0;
        char path[PATH_SIZE];
        if (base && key->choice)
            memcpy(&choice, base + key->choice_offset, sizeof choice);
        if (choice != 0 && choice != key->choice)
            continue;
        snprintf(path, sizeof path, "%.200s%s", above, key->name);
        if (key->kind == SPH2D_KEY_LIST)
            print_list(key, base, path);
        else if (key->kind == SPH2D_KEY_GROUP)
            print_group(key, base, path);
        else
            print_key(path, key->kind == SPH2D_KEY_WORD ? key->words : NULL);
    }
}

/* ---- the scene that a path names or holds ------------------------------------------------------------------------ */

static sph2d_scene_file *of_study(const char *path)
{
    sph2d_study_file *study = NULL;
    sph2d_scene_file *file = NULL;
    if (sph2d_study_file_read(path, &study, NULL) != SPH2D_OK)
        return NULL;
    sph2d_scene_file_read(sph2d_study_file_study(study)->scene, NULL, 0, &file, NULL);
    sph2d_study_file_destroy(study);
    return file;
}

static sph2d_scene_file *of_snapshot(const char *path)
{
    sph2d_snapshot *snapshot = NULL;
    sph2d_scene_file *file = NULL;
    if (sph2d_snapshot_read_unchecked(path, &snapshot, NULL) != SPH2D_OK)
        return NULL;
    sph2d_snapshot_scene(snapshot, NULL, 0, &file, NULL);
    sph2d_snapshot_destroy(snapshot);
    return file;
}

static sph2d_scene_file *of_folder(const char *path)
{
    char first[4096];
    size_t count;
    sph2d_status status = SPH2D_OK;
    uint64_t *numbers = snapshot_numbers(path, &count, &status);
    if (count > 0)
        snprintf(first, sizeof first, "%.4000s/snapshot_%06" PRIu64 ".h5", path, numbers[0]);
    free(numbers);
    return count > 0 ? of_snapshot(first) : NULL;
}

static void print_name(const char *name)
{
    if (name)
        printf("name\t%s\n", name);
}

void completion_print(const char *path)
{
    struct stat found;
    const size_t length = strlen(path);
    const bool there = stat(path, &found) == 0, folder = there && S_ISDIR(found.st_mode);
    sph2d_scene_file *file = NULL;
    if (folder)
        file = of_folder(path);
    else if (!there || !S_ISREG(found.st_mode)) /* a pipe would make the shell wait */
        file = NULL;
    else if (length > 3 && strcmp(path + length - 3, ".h5") == 0)
        file = of_snapshot(path);
    else if (sph2d_scene_file_read(path, NULL, 0, &file, NULL) != SPH2D_OK)
        file = of_study(path);
    const sph2d_scene *scene = file ? sph2d_scene_file_scene(file) : NULL;
    if (folder) /* all that `sph2d resume` lets change */
        print_key("run.until", NULL);
    else
        print_keys(sph2d_scene_keys(), (const char *)scene, "");
    for (size_t i = 0; scene && i < scene->obstacle_count; ++i)
        print_name(scene->obstacles[i].name);
    for (size_t i = 0; scene && i < scene->body_count; ++i)
        print_name(scene->bodies[i].name);
    sph2d_scene_file_destroy(file);
}
