/* SPDX-License-Identifier: MIT */
/** @file study_rows.c
 *  The rows of a study: its runs, each with every combination of the values that are varied. */
#include "files/study_rows.h"

#include <stdio.h>
#include <string.h>

enum { PLACE_SIZE = 64 };

/** What is varied, as the tree has it: mappings of sequences. */
static const sph2d__node *varied(const sph2d__node *root)
{
    return sph2d__node_find(root, "vary", strlen("vary"));
}

size_t sph2d__study_rows_count(const sph2d_study *study, const sph2d__node *root)
{
    const sph2d__node *vary = varied(root);
    size_t count = study->run_count > 0 ? study->run_count : 1;
    for (const sph2d__node *key = vary ? vary->first : NULL; key && count <= SPH2D_STUDY_MOST_RUNS; key = key->next)
        count *= key->count;
    return count;
}

/* ---- names ------------------------------------------------------------------------------------------------------- */

/** The last step of a key path: "sound_speed" of "method.sound_speed". */
static const char *last_step(const char *path)
{
    const char *point = strrchr(path, '.');
    return point && point[1] ? point + 1 : path;
}

/** "NAME, spacing=0.02, sound_speed=10" from a name, or none, and the overrides from `first` on; NULL when memory is
 *  short. */
static const char *made_name(const char *name, const sph2d_study_run *run, size_t first, sph2d__pool *pool)
{
    bool named = name && name[0];
    size_t size = (named ? strlen(name) : 0) + sizeof "scene", used = 0;
    for (size_t i = first; i < run->override_count; ++i)
        size += strlen(last_step(run->overrides[i].path)) + strlen(run->overrides[i].value) + strlen(", =");
    char *text = sph2d__pool_alloc(pool, size, 1);
    if (!text)
        return NULL;
    if (named || first == run->override_count)
        used = (size_t)snprintf(text, size, "%s", named ? name : "scene");
    for (size_t i = first; i < run->override_count; ++i)
        used += (size_t)snprintf(text + used, size - used, "%s%s=%s", used > 0 ? ", " : "",
                                 last_step(run->overrides[i].path), run->overrides[i].value);
    sph2d__text_clean(text);
    return text;
}

/* ---- rows -------------------------------------------------------------------------------------------------------- */

static const char *place(sph2d__pool *pool, const char *format, size_t outer, size_t inner)
{
    char text[PLACE_SIZE];
    int length = snprintf(text, sizeof text, format, outer, inner);
    return sph2d__pool_text(pool, text, (size_t)length);
}

/** The overrides of a row while they are collected. */
typedef struct collection {
    sph2d_override *overrides;
    const char **places;
    size_t count;
    bool ok; /**< false when memory is short */
} collection;

static collection begin_row(sph2d__pool *pool, size_t most)
{
    collection c = {sph2d__pool_alloc(pool, most + 1, sizeof *c.overrides),
                    sph2d__pool_alloc(pool, most + 1, sizeof *c.places), 0, true};
    c.ok = c.overrides && c.places;
    return c;
}

static void add(collection *c, const char *path, const char *value, const char *where)
{
    c->ok = c->ok && value && where;
    if (!c->ok)
        return;
    c->overrides[c->count] = (sph2d_override){path, value};
    c->places[c->count++] = where;
}

/** Adds what a run sets itself; `format` makes a place of the run's number and the override's. */
static void add_own(collection *c, const sph2d_study_run *run, const char *format, size_t number, sph2d__pool *pool)
{
    for (size_t i = 0; i < run->override_count; ++i)
        add(c, run->overrides[i].path, run->overrides[i].value, place(pool, format, number, i));
}

/** Adds combination `number` of what is varied, the first key turning slowest. */
static void add_combination(collection *c, const sph2d__node *vary, size_t number, size_t combinations,
                            sph2d__pool *pool)
{
    size_t axis = 0;
    for (const sph2d__node *key = vary ? vary->first : NULL; key; key = key->next, ++axis) {
        combinations /= key->count;
        size_t item = number / combinations % key->count;
        add(c, key->key, sph2d__node_text(sph2d__node_item(key, item), pool),
            place(pool, "vary[%zu][%zu]", axis, item));
    }
}

/** Puts what was collected into `run`, and gives it a name. False when memory is short. */
static bool end_row(const collection *c, sph2d_study_run *run, sph2d__pool *pool)
{
    if (!c->ok)
        return false;
    size_t named = run->name && run->name[0] ? run->override_count : 0;
    run->overrides = c->overrides;
    run->places = c->places;
    run->override_count = c->count;
    run->name = made_name(run->name, run, named, pool);
    return run->name != NULL;
}

static bool make_refinements(sph2d_study *study, sph2d__pool *pool)
{
    sph2d_study_run *steps = sph2d__pool_alloc(pool, study->refinement_count, sizeof *steps);
    for (size_t i = 0; steps && i < study->refinement_count; ++i) {
        steps[i] = study->refinements[i];
        collection c = begin_row(pool, steps[i].override_count);
        add_own(&c, &steps[i], "refine[%zu].set[%zu]", i, pool);
        if (!end_row(&c, &steps[i], pool))
            return false;
    }
    study->refinements = steps;
    return steps != NULL;
}

static bool make_runs(sph2d_study *study, const sph2d__node *root, sph2d__pool *pool)
{
    static const sph2d_study_run plain = {0};
    const sph2d_study_run *given = study->run_count > 0 ? study->runs : &plain;
    const sph2d__node *vary = varied(root);
    size_t count = sph2d__study_rows_count(study, root);
    size_t combinations = count / (study->run_count > 0 ? study->run_count : 1);
    sph2d_study_run *rows = sph2d__pool_alloc(pool, count, sizeof *rows);
    for (size_t i = 0; rows && i < count; ++i) {
        rows[i] = given[i / combinations];
        collection c = begin_row(pool, rows[i].override_count + study->vary_count);
        add_own(&c, &rows[i], "runs[%zu].set[%zu]", i / combinations, pool);
        add_combination(&c, vary, i % combinations, combinations, pool);
        if (!end_row(&c, &rows[i], pool))
            return false;
    }
    study->runs = rows;
    study->run_count = count;
    return rows != NULL;
}

bool sph2d__study_rows_make(sph2d_study *study, const sph2d__node *root, sph2d__pool *pool)
{
    return make_runs(study, root, pool) && make_refinements(study, pool);
}
