/* SPDX-License-Identifier: MIT */
/** @file study_rows.c
 *  The rows of a study: its runs, each with every combination of the values that are varied. */
#include "files/study_file.h"

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

/** The first override of a key, from `first` on, and the last, which counts. */
static const sph2d_override *first_of(const sph2d_study_run *run, size_t first, const char *path)
{
    while (strcmp(run->overrides[first].path, path) != 0)
        ++first;
    return &run->overrides[first];
}

static const sph2d_override *last_of(const sph2d_study_run *run, const char *path)
{
    size_t last = run->override_count - 1;
    while (strcmp(run->overrides[last].path, path) != 0)
        --last;
    return &run->overrides[last];
}

size_t sph2d_study_run_name(const sph2d_study_run *run, const char *but, char *out, size_t size)
{
    if (!out)
        size = 0;
    if (size > 0)
        out[0] = '\0';
    if (!run)
        return 0;
    bool given = run->given && run->given[0];
    for (size_t i = 0; but && i < run->given_count; ++i)
        given = given && strcmp(run->overrides[i].path, but) != 0;
    size_t first = given ? run->given_count : 0;
    size_t used = given ? (size_t)snprintf(out, size, "%s", run->given) : 0;
    for (size_t i = first; i < run->override_count; ++i) {
        const char *path = run->overrides[i].path;
        if ((but && strcmp(path, but) == 0) || first_of(run, first, path) != &run->overrides[i])
            continue;
        size_t room = used < size ? size - used : 0;
        used += (size_t)snprintf(room > 0 ? out + used : NULL, room, "%s%s=%s", used > 0 ? ", " : "", last_step(path),
                                 last_of(run, path)->value);
    }
    if (used == 0)
        used = (size_t)snprintf(out, size, "scene");
    if (size > 0)
        sph2d__text_clean(out);
    return used;
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
    run->given = run->name;
    run->given_count = run->override_count;
    run->overrides = c->overrides;
    run->places = c->places;
    run->override_count = c->count;
    size_t size = sph2d_study_run_name(run, NULL, NULL, 0) + 1;
    char *name = sph2d__pool_alloc(pool, size, 1);
    if (name)
        sph2d_study_run_name(run, NULL, name, size);
    run->name = name;
    return name;
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
    return steps;
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
    return rows;
}

bool sph2d__study_rows_make(sph2d_study *study, const sph2d__node *root, sph2d__pool *pool)
{
    return make_runs(study, root, pool) && make_refinements(study, pool);
}
