/* SPDX-License-Identifier: MIT */
/** @file study_check.c
 *  What is wrong with a study beyond its keys and types. */
#include "files/study_file.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
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
    return sph2d__node_find(sph2d__node_at(c->root, c->above), name, strlen(name));
}

/** Whether the value of a key could be read, where it is given. */
static bool is_sound(const checker *c, const char *name)
{
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "%.60s%s%.30s", c->above, c->above[0] ? "." : "", name);
    return !sph2d__faults_affect(c->faults, path);
}

/** Reports a fault of a key of what is checked, or with "" of all of it. */
static sph2d_diagnostic *fault(checker *c, sph2d_code code, const char *name, const char *format, ...)
{
    char path[PATH_SIZE], message[160];
    va_list values;
    va_start(values, format);
    vsnprintf(message, sizeof message, format, values);
    va_end(values);
    snprintf(path, sizeof path, "%.60s%s%.30s", c->above, name[0] && c->above[0] ? "." : "", name);
    sph2d__place nowhere = {c->root->place.source, SPH2D__NOWHERE};
    sph2d_diagnostic *d = sph2d__fault(c->faults, code, nowhere, path, "%s", message);
    if (d)
        sph2d__node_locate(c->root, d);
    return d;
}

/* ---- keys beside each other -------------------------------------------------------------------------------------- */

/** Reports a key that is given although it means nothing. */
static void refuse(checker *c, const char *name, const char *reason)
{
    if (is_given(c, name))
        fault(c, SPH2D_CODE_CONFLICT, name, "'%s' has no meaning %s", name, reason);
}

static void refuse_all(checker *c, const char *const *names, const char *reason)
{
    for (; *names; ++names)
        refuse(c, *names, reason);
}

static void demand(checker *c, const char *name, const char *reason)
{
    if (!is_given(c, name))
        fault(c, SPH2D_CODE_MISSING_KEY, "", "'%s' must be given %s", name, reason);
}

static void check_probe(checker *c, const sph2d_study_measure *m)
{
    demand(c, "column", "with a probe");
    if (m->from > m->to)
        fault(c, SPH2D_CODE_CONFLICT, "to", "'to' lies before 'from'");
    if (!is_sound(c, "take"))
        return;
    bool crosses = m->take == SPH2D_TAKE_PERIOD || m->take == SPH2D_TAKE_CROSSING || m->take == SPH2D_TAKE_DECAY;
    if (m->take == SPH2D_TAKE_CROSSING)
        demand(c, "level", "to take a crossing");
    if (m->take == SPH2D_TAKE_VALUE)
        demand(c, "at", "to take a value");
    if (!crosses)
        refuse(c, "level", "here: 'take' is none of period, crossing and decay");
    if (m->take != SPH2D_TAKE_VALUE)
        refuse(c, "at", "here: 'take' is not value");
}

static void check_profile(checker *c, const sph2d_study_measure *m)
{
    static const char *const of_series[] = {"column", "take", "level", "at", "from", "to", "expect", NULL};
    refuse_all(c, of_series, "with a profile");
    if (m->reference.shift > 0)
        fault(c, SPH2D_CODE_CONFLICT, "reference.shift", "a profile has no times to move");
    if (m->expectation != SPH2D_EXPECT_FINEST)
        demand(c, "reference", "with a profile, or 'finest'");
    const sph2d_points *line = &m->profile.line;
    if (!is_sound(c, "profile.line"))
        return;
    if (line->count != 2)
        fault(c, SPH2D_CODE_WRONG_TYPE, "profile.line", "a line has two ends: [[x, y], [x, y]]");
    else if (line->items[0].x == line->items[1].x && line->items[0].y == line->items[1].y)
        fault(c, SPH2D_CODE_CONFLICT, "profile.line", "the two ends are the same point");
}

static void check_summary(checker *c)
{
    static const char *const of_series[] = {"column", "take", "level", "at", "from", "to", "norm", "reference", NULL};
    refuse_all(c, of_series, "with a summary, which is one number");
}

static void check_expectation(checker *c, const sph2d_study_measure *m)
{
    static const char *const of_error[] = {"bound", "order", "relative", NULL};
    if (m->expectation == SPH2D_EXPECT_NOTHING && m->source != SPH2D_MEASURE_PROFILE)
        refuse_all(c, of_error, "without 'expect', 'reference' or 'finest'");
    if (m->expectation == SPH2D_EXPECT_FINEST) {
        if (!m->finest && is_sound(c, "finest"))
            fault(c, SPH2D_CODE_CONFLICT, "finest", "'finest' is true or is left out");
        if (m->source == SPH2D_MEASURE_PROBE && m->take != SPH2D_TAKE_DEFAULT)
            refuse(c, "norm", "where 'take' makes one number of the series");
    } else if (m->expectation != SPH2D_EXPECT_REFERENCE) {
        refuse(c, "norm", "without 'reference' or 'finest'");
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
    if (m->source == SPH2D_MEASURE_PROBE)
        check_probe(c, m);
    else if (m->source == SPH2D_MEASURE_PROFILE)
        check_profile(c, m);
    else if (m->source == SPH2D_MEASURE_SUMMARY)
        check_summary(c);
    else
        sph2d_diagnostic_hint(fault(c, SPH2D_CODE_MISSING_KEY, "", "there is nothing to measure"),
                              "give one of probe, profile, summary");
    check_expectation(c, m);
}

/* ---- the study --------------------------------------------------------------------------------------------------- */

static void check_vary(checker *c, const sph2d_study *study)
{
    char name[32];
    bool lists = !sph2d__faults_affect(c->faults, "vary");
    for (size_t i = 0; lists && i < study->vary_count; ++i) {
        snprintf(name, sizeof name, "vary[%zu]", i);
        const sph2d__node *values = sph2d__node_at(c->root, name);
        if (values->kind == SPH2D__NODE_SEQUENCE && values->count > 0)
            continue;
        lists = false;
        fault(c, SPH2D_CODE_WRONG_TYPE, name, "what is varied needs a list of one value or more: [0.02, 0.01]");
    }
    if (lists && sph2d__study_rows_count(study, c->root) > SPH2D_STUDY_MOST_RUNS)
        sph2d_diagnostic_hint(
            fault(c, SPH2D_CODE_TOO_MANY, study->vary_count > 0 ? "vary" : "runs", "there are more than 10000 rows"),
            "vary fewer keys at once, and refine the best");
}

void sph2d__study_target(sph2d_study *study)
{
    if (!study->target_text)
        return;
    char *end;
    study->target = strtod(study->target_text, &end);
    study->percent = end != study->target_text && strcmp(end, "%") == 0;
    bool whole = end != study->target_text && (*end == '\0' || study->percent);
    study->target = whole && isfinite(study->target) && study->target > 0 ? study->target : NAN;
    if (study->percent)
        study->target /= 100;
}

/** Whether the error that is weighed is a fraction: that of the measure `judge`, else of the first that has one. */
static bool judges_fraction(const sph2d_study *study)
{
    for (size_t i = 0; i < study->measure_count; ++i) {
        const sph2d_study_measure *m = &study->measures[i];
        bool named = !study->judge || (m->name && strcmp(m->name, study->judge) == 0);
        if (named && m->expectation != SPH2D_EXPECT_NOTHING)
            return m->relative;
    }
    return false;
}

static void check_target(checker *c, const sph2d_study *study)
{
    double target = study->target;
    if (isnan(target) && is_sound(c, "target"))
        sph2d_diagnostic_hint(fault(c, SPH2D_CODE_OUT_OF_RANGE, "target", "a target must be a number above 0"),
                              "such as 0.01 or 1%%");
    else if (target >= 1 && !study->percent && judges_fraction(study))
        sph2d_diagnostic_hint(fault(c, SPH2D_CODE_OUT_OF_RANGE, "target",
                                    "a target of %g is %g %%, as the error is relative", target, 100 * target),
                              "%g%% or %g; or, if that is meant, %g%%", target, target / 100, 100 * target);
}

static void check_judge(checker *c, const sph2d_study *study)
{
    bool named = false;
    for (size_t i = 0; study->judge && i < study->measure_count; ++i) {
        const sph2d_study_measure *m = &study->measures[i];
        bool same = m->name && strcmp(m->name, study->judge) == 0;
        named = named || same;
        if (same && m->expectation != SPH2D_EXPECT_NOTHING)
            return;
    }
    if (named)
        fault(c, SPH2D_CODE_CONFLICT, "judge", "that measure has no error: nothing is expected of it");
    else if (study->judge && is_sound(c, "judge"))
        fault(c, SPH2D_CODE_WRONG_TYPE, "judge", "no measure is called '%.60s'", study->judge);
}

/** Two columns of one name cannot be distinguished. */
static void check_names(checker *c, const sph2d_study *study)
{
    for (size_t i = 0; i < study->measure_count; ++i)
        for (size_t k = 0; k < i; ++k)
            if (study->measures[i].name && study->measures[k].name &&
                strcmp(study->measures[i].name, study->measures[k].name) == 0) {
                char name[32];
                snprintf(name, sizeof name, "measures[%zu].name", i);
                fault(c, SPH2D_CODE_CONFLICT, name, "another measure has this name");
                break;
            }
}

/** A step that changes nothing would run the same rows again. Where there are faults it may be one of them. */
static void check_refinements(checker *c, const sph2d_study *study)
{
    for (size_t i = 0; i < study->refinement_count; ++i) {
        char name[32];
        snprintf(name, sizeof name, "refine[%zu]", i);
        if (study->refinements[i].override_count == 0 && c->faults->errors == 0)
            sph2d_diagnostic_hint(fault(c, SPH2D_CODE_MISSING_KEY, name, "a refinement must set a key"),
                                  "set: {spacing: 0.01}");
    }
}

static bool sets(const sph2d_study_run *runs, size_t count, const char *path)
{
    for (size_t i = 0; i < count; ++i)
        for (size_t k = 0; k < runs[i].override_count; ++k)
            if (strcmp(runs[i].overrides[k].path, path) == 0)
                return true;
    return false;
}

static void check_along(checker *c, const sph2d_study *study)
{
    bool known = strcmp(study->along, "spacing") == 0 || sets(study->runs, study->run_count, study->along) ||
                 sets(study->refinements, study->refinement_count, study->along);
    for (size_t i = 0; i < study->vary_count; ++i)
        known = known || strcmp(study->vary[i].path, study->along) == 0;
    if (!known)
        sph2d_diagnostic_hint(fault(c, SPH2D_CODE_WRONG_TYPE, "along", "no row sets that key"),
                              "give a key that 'vary' or 'set' has, or leave it out for spacing");
}

/** Names are compared with each other, and every measure is a column. */
static bool check_counts(checker *c, const sph2d_study *study)
{
    if (study->measure_count > SPH2D_STUDY_MOST_MEASURES)
        fault(c, SPH2D_CODE_TOO_MANY, "measures", "there are more than %d measures", SPH2D_STUDY_MOST_MEASURES);
    if (study->refinement_count > SPH2D_STUDY_MOST_MEASURES)
        fault(c, SPH2D_CODE_TOO_MANY, "refine", "there are more than %d refinements", SPH2D_STUDY_MOST_MEASURES);
    return study->measure_count <= SPH2D_STUDY_MOST_MEASURES && study->refinement_count <= SPH2D_STUDY_MOST_MEASURES;
}

void sph2d__study_check(const sph2d_study *study, const sph2d__document *document, sph2d__faults *faults)
{
    const sph2d__node *root = document->root;
    checker c = {root, faults, ""};
    if (!check_counts(&c, study))
        return;
    sph2d_report ranges = {0};
    sph2d_keys_check(sph2d_study_keys(), study, &ranges);
    sph2d__document_pass(document, &ranges, faults, NULL);
    check_vary(&c, study);
    check_target(&c, study);
    check_judge(&c, study);
    check_names(&c, study);
    check_refinements(&c, study);
    if (study->along && is_sound(&c, "along") && !sph2d__faults_affect(faults, "vary") &&
        !sph2d__faults_affect(faults, "runs"))
        check_along(&c, study);
    if (is_given(&c, "runs") && study->run_count == 0 && !sph2d__faults_affect(faults, "runs"))
        sph2d_diagnostic_hint(fault(&c, SPH2D_CODE_MISSING_KEY, "runs", "there is no run"),
                              "`- set: {}` runs the scene as it is; without 'runs' that is the only one");
    for (size_t i = 0; i < study->measure_count; ++i) {
        snprintf(c.above, sizeof c.above, "measures[%zu]", i);
        if (sph2d__node_at(root, c.above)->kind == SPH2D__NODE_MAPPING)
            check_measure(&c, &study->measures[i]);
    }
}
