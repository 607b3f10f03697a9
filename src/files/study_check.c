/* SPDX-License-Identifier: MIT */
/** @file study_check.c
 *  What is wrong with a study beyond its keys and types. */
#include "files/study_check.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { PATH_SIZE = 96 };

typedef struct checker {
    const sph2d__node *root;
    sph2d__faults *faults;
    char above[PATH_SIZE]; /**< path of the measure or run that is checked */
} checker;

/** Whether a file gives a key of what is checked. */
static bool is_given(const checker *c, const char *name)
{
    return sph2d__node_find(sph2d__node_at(c->root, c->above), name, strlen(name)) != NULL;
}

/** Whether the value of a key could be read, where it is given. */
static bool is_sound(const checker *c, const char *name)
{
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "%.60s.%.30s", c->above, name);
    return !sph2d__faults_touch(c->faults, path);
}

/** Reports a fault of a key of what is checked, or with "" of all of it. */
static sph2d_diagnostic *fault(checker *c, sph2d_code code, const char *name, const char *message)
{
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "%.60s%s%.30s", c->above, name[0] && c->above[0] ? "." : "", name);
    sph2d__place nowhere = {c->root->place.source, SPH2D__NOWHERE};
    sph2d_diagnostic *d = sph2d__fault(c->faults, code, nowhere, path, "%s", message);
    if (d)
        sph2d__node_locate(c->root, d);
    return d;
}

/* ---- ranges ------------------------------------------------------------------------------------------------------ */

static void check_range(checker *c, const sph2d_key *key, const void *measure)
{
    double value;
    memcpy(&value, (const char *)measure + key->offset, sizeof value);
    bool below = key->min_excluded ? value <= key->min : value < key->min;
    if (isnan(value) || (!below && value <= key->max))
        return;
    char message[120];
    snprintf(message, sizeof message, "%g is out of range: must be %s %g", value,
             key->min_excluded ? "above" : "at least", key->min);
    sph2d_diagnostic_hint(fault(c, SPH2D_CODE_OUT_OF_RANGE, key->name, message), "%s: %s", key->name, key->text);
}

static void check_ranges(checker *c, const sph2d_study_measure *m)
{
    const sph2d_keys *study = sph2d_study_keys();
    const sph2d_keys *keys = NULL;
    for (size_t i = 0; i < study->count; ++i)
        if (strcmp(study->items[i].name, "measures") == 0)
            keys = study->items[i].keys;
    for (size_t i = 0; keys && i < keys->count; ++i)
        if (keys->items[i].kind == SPH2D_KEY_NUMBER)
            check_range(c, &keys->items[i], m);
}

/* ---- keys beside each other -------------------------------------------------------------------------------------- */

/** Reports a key that is given although it means nothing. */
static void refuse(checker *c, const char *name, const char *reason)
{
    char message[160];
    snprintf(message, sizeof message, "'%s' has no meaning %s", name, reason);
    if (is_given(c, name))
        fault(c, SPH2D_CODE_CONFLICT, name, message);
}

static void refuse_all(checker *c, const char *const *names, const char *reason)
{
    for (; *names; ++names)
        refuse(c, *names, reason);
}

static void demand(checker *c, const char *name, const char *reason)
{
    char message[160];
    snprintf(message, sizeof message, "'%s' must be given %s", name, reason);
    if (!is_given(c, name))
        fault(c, SPH2D_CODE_MISSING_KEY, "", message);
}

static void check_probe(checker *c, const sph2d_study_measure *m)
{
    demand(c, "column", "with a probe");
    if (m->from > m->to)
        fault(c, SPH2D_CODE_CONFLICT, "to", "'to' lies before 'from'");
    if (!is_sound(c, "take"))
        return;
    bool crosses = m->take == SPH2D_TAKE_PERIOD || m->take == SPH2D_TAKE_CROSSING;
    if (m->take == SPH2D_TAKE_CROSSING)
        demand(c, "level", "to take a crossing");
    if (m->take == SPH2D_TAKE_VALUE)
        demand(c, "at", "to take a value");
    if (!crosses)
        refuse(c, "level", "here: 'take' is neither period nor crossing");
    if (m->take != SPH2D_TAKE_VALUE)
        refuse(c, "at", "here: 'take' is not value");
}

static void check_profile(checker *c, const sph2d_study_measure *m)
{
    static const char *const of_series[] = {"column", "take", "level", "at", "from", "to", "expect", NULL};
    refuse_all(c, of_series, "with a profile");
    if (m->reference.shift > 0)
        fault(c, SPH2D_CODE_CONFLICT, "reference.shift", "a profile has no times to move");
    demand(c, "reference", "with a profile");
    const sph2d_points *line = &m->profile.line;
    if (!is_sound(c, "profile.line"))
        return;
    if (line->count != 2)
        fault(c, SPH2D_CODE_WRONG_TYPE, "profile.line", "a line has two ends: [[x, y], [x, y]]");
    else if (line->items[0].x == line->items[1].x && line->items[0].y == line->items[1].y)
        fault(c, SPH2D_CODE_CONFLICT, "profile.line", "the two ends are the same point");
}

static void check_expectation(checker *c, const sph2d_study_measure *m)
{
    static const char *const of_error[] = {"bound", "order", "relative", NULL};
    if (m->expectation == SPH2D_EXPECT_NOTHING && m->source != SPH2D_MEASURE_PROFILE)
        refuse_all(c, of_error, "without 'expect' or 'reference'");
    if (m->expectation != SPH2D_EXPECT_REFERENCE) {
        refuse(c, "norm", "without 'reference'");
    } else {
        refuse(c, "relative", "with a reference; 'scale' makes the differences relative to a number");
        if (m->source == SPH2D_MEASURE_PROBE && m->take != SPH2D_TAKE_DEFAULT)
            refuse(c, "take", "with a reference, which is compared with the whole series");
    }
    if (m->relative && m->expectation == SPH2D_EXPECT_NUMBER && m->expect == 0)
        fault(c, SPH2D_CODE_OUT_OF_RANGE, "expect", "nothing is relative to 0");
}

static void check_measure(checker *c, const sph2d_study_measure *m)
{
    check_ranges(c, m);
    if (m->source == SPH2D_MEASURE_PROBE)
        check_probe(c, m);
    else if (m->source == SPH2D_MEASURE_PROFILE)
        check_profile(c, m);
    else
        sph2d_diagnostic_hint(fault(c, SPH2D_CODE_MISSING_KEY, "", "there is nothing to measure"),
                              "give one of probe, profile");
    check_expectation(c, m);
}

/* ---- the study --------------------------------------------------------------------------------------------------- */

void sph2d__study_check(const sph2d_study *study, const sph2d__node *root, sph2d__faults *faults)
{
    checker c = {root, faults, ""};
    if (study->run_count == 0 && !sph2d__faults_touch(faults, "runs"))
        sph2d_diagnostic_hint(fault(&c, SPH2D_CODE_MISSING_KEY, "runs", "there is no run"),
                              "`- set: {}` runs the scene as it is");
    for (size_t i = 0; i < study->measure_count; ++i) {
        snprintf(c.above, sizeof c.above, "measures[%zu]", i);
        if (sph2d__node_at(root, c.above)->kind == SPH2D__NODE_MAPPING)
            check_measure(&c, &study->measures[i]);
    }
}
