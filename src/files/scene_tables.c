/* SPDX-License-Identifier: MIT */
/** @file scene_tables.c
 *  Which keys of a scene name tables or drawings, and one way to read them all. A key is a row of `places`; what its table is about
 *  is a kind (table_kind.h). */
#include "files/scene_file.h"

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "files/table_kind.h"
#include "files/text.h"

enum { KEY_SIZE = 64 };

/* ---- kinds whose rows are items as they stand -------------------------------------------------------------------- */

static const sph2d__table_kind gravity_table = {
    .key = "gravity_file",
    .file = offsetof(sph2d_scene, gravity_file),
    .columns = {{"t", "s", false}, {"gx", "m/s^2", true}, {"gy", "m/s^2", true}},
    .column_count = 3,
    .lacks_all = "gravity in time needs one of the columns gx, gy",
    .lists = {{"gravity_path", offsetof(sph2d_scene, gravity_path), 3}},
    .take = sph2d__table_take,
    .refuse = sph2d__table_refuse_time,
    .otherwise = offsetof(sph2d_scene, gravity),
};

/** Measured motions are smooth. */
static void settle_motion(void *owner)
{
    sph2d_motion *motion = owner;
    if (motion->between == SPH2D_BETWEEN_DEFAULT)
        motion->between = SPH2D_BETWEEN_CUBIC;
}

static const sph2d__table_kind motion_table = {
    .key = "file",
    .file = offsetof(sph2d_motion, file),
    .columns = {{"t", "s", false}, {"x", "m", true}, {"y", "m", true}, {"angle", "rad", true}},
    .column_count = 4,
    .lacks_all = "a motion needs one of the columns x, y, angle",
    .lists = {{"path", offsetof(sph2d_motion, path), 4}},
    .take = sph2d__table_take,
    .refuse = sph2d__table_refuse_time,
    .settle = settle_motion,
};

static sph2d_status take_particles(const sph2d__table_input *in, void *owner)
{
    if (sph2d_table_rows(in->table) == 0)
        return sph2d__table_fault(in, 0, "this file has no particles");
    return sph2d__table_take(in, owner);
}

static const char *refuse_density(const sph2d_table *table, size_t row)
{
    bool wrong = sph2d_table_has(table, 4) && !(sph2d_table_value(table, row, 4) > 0);
    return wrong ? "a density must be above 0" : NULL;
}

_Static_assert(sizeof(sph2d_particle) == 6 * sizeof(double), "particles are read as doubles");
static const sph2d__table_kind particles_table = {
    .key = "particles",
    .file = offsetof(sph2d_particles, file),
    .columns = {{"x", "m", false},
                {"y", "m", false},
                {"vx", "m/s", true},
                {"vy", "m/s", true},
                {"density", "kg/m^3", true},
                {"color", "", true}},
    .column_count = 6,
    .lists = {{NULL, offsetof(sph2d_particles, items), 6}},
    .take = take_particles,
    .refuse = refuse_density,
};

/* ---- places ------------------------------------------------------------------------------------------------------ */

/** Where tables of a kind are named: in the scene, or in each item of one of its lists. */
typedef struct place {
    const char *list;          /**< NULL: in the scene */
    size_t items, count, size; /**< of the list: offsets in the scene, and bytes of an item */
    const char *group;         /**< that the key is in, with its point */
    size_t at;                 /**< offset of the struct that the kind fills, in an item or the scene */
    const sph2d__table_kind *kind;
} place;

#define IN_SCENE NULL, 0, 0, 0
#define IN_LIST(list, counter, type) #list, offsetof(sph2d_scene, list), offsetof(sph2d_scene, counter), sizeof(type)

/** In the order in which they are read. */
static const place places[] = {
    {IN_SCENE, "", 0, &gravity_table},
    {IN_SCENE, "motion.", offsetof(sph2d_scene, motion), &motion_table},
    {IN_LIST(obstacles, obstacle_count, sph2d_obstacle), "motion.", offsetof(sph2d_obstacle, motion), &motion_table},
    {IN_LIST(openings, opening_count, sph2d_opening), "history.", 0, &sph2d__history_table},
    {IN_SCENE, "", offsetof(sph2d_scene, particles), &particles_table},
    {IN_LIST(blocks, block_count, sph2d_block), "start.", offsetof(sph2d_block, start.table), &sph2d__grid_table},
    {IN_SCENE, "start.", offsetof(sph2d_scene, start.table), &sph2d__grid_table},
    {IN_LIST(blocks, block_count, sph2d_block), "", offsetof(sph2d_block, shape), &sph2d__closed_drawing},
    {IN_LIST(drains, drain_count, sph2d_drain), "", offsetof(sph2d_drain, shape), &sph2d__closed_drawing},
    {IN_LIST(obstacles, obstacle_count, sph2d_obstacle), "", offsetof(sph2d_obstacle, shape), &sph2d__drawing},
    {IN_LIST(bodies, body_count, sph2d_body), "", offsetof(sph2d_body, shape), &sph2d__closed_drawing},
};
static const place *const places_end = places + sizeof places / sizeof places[0];

/** How many structs of a scene a place is in. */
static size_t count_of(const place *p, const sph2d_scene *scene)
{
    size_t count = 1;
    if (p->list)
        memcpy(&count, (const char *)scene + p->count, sizeof count);
    return count;
}

/** Struct number `i` of a place. */
static const char *struct_of(const place *p, const sph2d_scene *scene, size_t i)
{
    const char *first = (const char *)scene;
    if (p->list)
        memcpy(&first, first + p->items, sizeof first);
    return first + i * p->size + p->at;
}

/** The same to be changed: lists were made in the pool, which is writable. */
static char *struct_to_fill(const place *p, const sph2d_scene *scene, size_t i)
{
    return (char *)(uintptr_t)struct_of(p, scene, i);
}

/** Writes a key of struct `i` of a place: `obstacles[2].motion.path`. */
static void key_of(const place *p, size_t i, const char *name, char key[KEY_SIZE])
{
    if (p->list)
        snprintf(key, KEY_SIZE, "%s[%zu].%s%s", p->list, i, p->group, name);
    else
        snprintf(key, KEY_SIZE, "%s%s", p->group, name);
}

static sph2d__list list_of(const sph2d__list_slot *slot, const char *owner)
{
    sph2d__list list;
    memcpy(&list, owner + slot->at, sizeof list);
    return list;
}

/** Which of several lists that share a place a struct has; 0: none. */
static int choice_of(const sph2d__list_slot *slot, const char *owner)
{
    int choice;
    memcpy(&choice, owner + slot->choice_at, sizeof choice);
    return choice;
}

/** The name of the file that is to fill a struct; NULL for none. If there is a list, too, the check refuses them. */
static const char *wanted_file(const sph2d__table_kind *kind, const char *owner)
{
    const char *file;
    memcpy(&file, owner + kind->file, sizeof file);
    for (const sph2d__list_slot *slot = kind->lists; slot->width > 0; ++slot) {
        if (list_of(slot, owner).count > 0)
            return NULL;
    }
    return file;
}

/** Ends the reading of a struct: one whose list has a key names the file no more. */
static void settle(const sph2d__table_kind *kind, char *owner)
{
    static const char *const none = NULL;
    if (kind->lists[0].key)
        memcpy(owner + kind->file, &none, sizeof none);
    if (kind->settle)
        kind->settle(owner);
}

/* ---- from files -------------------------------------------------------------------------------------------------- */

static bool lacks_all(const sph2d__table_kind *kind, const sph2d_table *table)
{
    for (size_t k = 0; k < kind->column_count; ++k)
        if (kind->columns[k].optional && sph2d_table_has(table, k))
            return false;
    return true;
}

static sph2d_status fill(const sph2d__table_input *in, char *owner)
{
    if (in->kind->lacks_all && lacks_all(in->kind, in->table))
        return sph2d__table_fault(in, 0, "%s", in->kind->lacks_all);
    return in->kind->take(in, owner);
}

static sph2d_status read_table(const sph2d__table_kind *kind, char *owner, const char *path, sph2d__pool *pool,
                               sph2d_report *report)
{
    sph2d_table *table;
    sph2d_status status = sph2d_table_read(path, kind->columns, kind->column_count, &table, report);
    if (status == SPH2D_OK)
        status = fill(&(sph2d__table_input){kind, table, pool, report}, owner);
    sph2d_table_destroy(table);
    return status;
}

/** Fills a struct from a file, which `key` names. */
static sph2d_status read_file(const sph2d__table_kind *kind, char *owner, const char *path, const char *key,
                              const sph2d_scene *scene, sph2d__pool *pool, sph2d_report *report)
{
    if (!path)
        return SPH2D_NOMEM;
    size_t first = report ? report->count : 0;
    sph2d_status status = kind->read ? kind->read(&(sph2d__file_input){kind, path, scene, pool, report}, owner)
                                     : read_table(kind, owner, path, pool, report);
    if (status == SPH2D_OK)
        settle(kind, owner);
    sph2d__report_key(report, first, key);
    return status;
}

sph2d_status sph2d__tables_read(sph2d_scene *scene, const char *from, sph2d__pool *pool, sph2d_report *report)
{
    sph2d_status status = SPH2D_OK;
    for (const place *p = places; p < places_end; ++p)
        for (size_t i = 0; status == SPH2D_OK && i < count_of(p, scene); ++i) {
            char *owner = struct_to_fill(p, scene, i), key[KEY_SIZE];
            const char *file = wanted_file(p->kind, owner);
            if (!file)
                continue;
            key_of(p, i, p->kind->key, key);
            status = read_file(p->kind, owner, sph2d__pool_join(pool, from, file), key, scene, pool, report);
        }
    return status;
}

void sph2d__tables_skip(const sph2d_scene *scene, sph2d__faults *faults)
{
    for (const place *p = places; p < places_end; ++p)
        for (size_t i = 0; i < count_of(p, scene); ++i) {
            char key[KEY_SIZE];
            key_of(p, i, p->kind->key, key);
            if (wanted_file(p->kind, struct_of(p, scene, i)))
                sph2d__faults_mark_invalid(faults, key);
        }
}

/* ---- from a snapshot --------------------------------------------------------------------------------------------- */

void sph2d__tables_each_list(sph2d_scene *scene,
                             void (*visit)(void *context, const char *key, size_t width, void *list), void *context)
{
    for (const place *p = places; p < places_end; ++p)
        for (size_t i = 0; i < count_of(p, scene); ++i)
            for (const sph2d__list_slot *slot = p->kind->lists; slot->key; ++slot) {
                char key[KEY_SIZE];
                key_of(p, i, slot->key, key);
                char *owner = struct_to_fill(p, scene, i);
                visit(context, key, slot->width, owner + slot->at);
                if (slot->choice && list_of(slot, owner).count > 0 && choice_of(slot, owner) == 0)
                    memcpy(owner + slot->choice_at, &slot->choice, sizeof slot->choice);
            }
}

/** Copies the one list with a key that a struct has. False when memory is short. */
static bool copy_list(const sph2d__table_kind *kind, char *owner, const char *kept, sph2d__pool *pool)
{
    for (const sph2d__list_slot *slot = kind->lists; slot->key; ++slot) {
        sph2d__list list = list_of(slot, kept);
        if (list.count == 0 || (slot->choice && choice_of(slot, kept) != slot->choice))
            continue;
        void *items = sph2d__pool_alloc(pool, list.count, slot->width * sizeof(double));
        if (!items)
            return false;
        memcpy(items, list.items, list.count * slot->width * sizeof(double));
        memcpy(owner + slot->at, &(sph2d__list){items, list.count}, sizeof list);
        if (slot->choice)
            memcpy(owner + slot->choice_at, &slot->choice, sizeof slot->choice);
        settle(kind, owner);
        break;
    }
    return true;
}

sph2d_status sph2d__tables_keep(sph2d_scene *scene, const sph2d_scene *kept, sph2d__pool *pool)
{
    for (const place *p = places; p < places_end; ++p)
        for (size_t i = 0; i < count_of(p, scene) && i < count_of(p, kept); ++i) {
            char *owner = struct_to_fill(p, scene, i);
            if (wanted_file(p->kind, owner) && !copy_list(p->kind, owner, struct_of(p, kept, i), pool))
                return SPH2D_NOMEM;
        }
    return SPH2D_OK;
}
