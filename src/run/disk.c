/* SPDX-License-Identifier: MIT */
/** @file disk.c
 *  The size of a snapshot without compression: the values of particles, by the table of fields, the keys of the scene, by
 *  the table of keys, and what every snapshot has. `tests/cli/disk.sh` compares it with snapshots. */
#include <string.h>

#include "run/fields.h"
#include "run/run.h"
#include "sph2d/key.h"

/** Bytes of a number; numbers of a point; bytes of an attribute besides its value, its name in the mean over all keys. */
enum { NUMBER = 8, POINT_NUMBERS = 3, ATTRIBUTE = 56 };

/** Bytes that VTK reads of a point: its kind, where its cell begins, its place in the cell. */
static const double VTK_POINT = 1 + 2 * NUMBER;

/** Bytes of a snapshot of nothing: descriptions and units of 60 datasets and groups, the list of the state. */
static const double FIXED = 65e3;

/* ---- particles and corners --------------------------------------------------------------------------------------- */

/** Bytes of one row of an array. */
static double width(const sph2d_array *array)
{
    return array->components > 1 ? NUMBER * POINT_NUMBERS : NUMBER;
}

static bool is_public(const sph2d_array *array)
{
    for (size_t i = 0; i < sph2d_field_count(array->group); ++i)
        if (strcmp(sph2d_field(NULL, array->group, i).name, array->name) == 0)
            return true;
    return false;
}

/** Bytes of a particle or corner: public fields, what the method carries from step to step, what VTK reads. */
static double point_bytes(sph2d_sim *sim, sph2d_group group)
{
    double bytes = VTK_POINT;
    for (size_t i = 0; i < sph2d_field_count(group); ++i) {
        const sph2d_array field = sph2d_field(NULL, group, i);
        bytes += width(&field);
    }
    sph2d__lent carried[SPH2D__FIELDS_OF_STATE];
    const size_t count = sph2d__fields_of_state(sim, carried);
    for (size_t i = 0; i < count; ++i)
        if (carried[i].array.group == group && !is_public(&carried[i].array))
            bytes += width(&carried[i].array);
    return bytes;
}

/* ---- keys -------------------------------------------------------------------------------------------------------- */

static double keys_bytes(const sph2d_keys *keys, const char *base);

/** Bytes of a list or text, which the scene points to. */
static double pointed_bytes(const sph2d_key *key, const char *base)
{
    const char *items;
    memcpy(&items, base + key->offset, sizeof items);
    if (key->kind == SPH2D_KEY_TEXT)
        return items ? ATTRIBUTE + (double)strlen(items) : 0;
    size_t count;
    memcpy(&count, base + key->count_offset, sizeof count);
    if (key->kind != SPH2D_KEY_LIST) {
        const double numbers = key->kind == SPH2D_KEY_POINTS  ? 2
                               : key->kind == SPH2D_KEY_PATH  ? 3
                               : key->kind == SPH2D_KEY_POSES ? 4
                                                              : 1;
        return count > 0 ? ATTRIBUTE + NUMBER * numbers * (double)count : 0;
    }
    double bytes = 0;
    for (size_t i = 0; i < count; ++i)
        bytes += keys_bytes(key->keys, items + i * key->keys->size);
    return bytes;
}

static double key_bytes(const sph2d_key *key, const char *base)
{
    switch (key->kind) {
    case SPH2D_KEY_GROUP:
        return keys_bytes(key->keys, base + key->offset);
    case SPH2D_KEY_NUMBER:
    case SPH2D_KEY_COUNT:
    case SPH2D_KEY_WORD:
        return ATTRIBUTE + NUMBER;
    case SPH2D_KEY_COUNTS2:
    case SPH2D_KEY_POINT:
        return ATTRIBUTE + 2 * NUMBER;
    case SPH2D_KEY_TEXT:
    case SPH2D_KEY_POINTS:
    case SPH2D_KEY_PATH:
    case SPH2D_KEY_POSES:
    case SPH2D_KEY_NUMBERS:
    case SPH2D_KEY_LIST:
        break;
    }
    return pointed_bytes(key, base);
}

/** Bytes of the keys of a struct at `base`; of those that exclude each other only the chosen one is written. */
static double keys_bytes(const sph2d_keys *keys, const char *base)
{
    double bytes = 0;
    for (size_t i = 0; i < keys->count; ++i) {
        const sph2d_key *key = &keys->items[i];
        int choice = key->choice;
        if (choice != 0)
            memcpy(&choice, base + key->choice_offset, sizeof choice);
        if (choice == key->choice)
            bytes += key_bytes(key, base);
    }
    return bytes;
}

/* ---- the file ---------------------------------------------------------------------------------------------------- */

double sph2d__snapshot_bytes(sph2d_sim *sim, double *of_particle)
{
    *of_particle = point_bytes(sim, SPH2D_GROUP_FLUID);
    return FIXED + keys_bytes(sph2d_scene_keys(), (const char *)sph2d_sim_scene(sim)) +
           (double)sim->system.fluid.count * *of_particle +
           (double)sim->system.walls.count * point_bytes(sim, SPH2D_GROUP_WALL) +
           (double)sim->outlines.count * point_bytes(sim, SPH2D_GROUP_OUTLINE);
}
