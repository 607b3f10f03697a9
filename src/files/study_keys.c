/* SPDX-License-Identifier: MIT */
/** @file study_keys.c
 *  The table of a study's keys. The reader and the documentation read it. */
#include <math.h>

#include "sph2d/study.h"

/* Each row: name, kind, required, ...; the columns that a kind needs are set by the macros below. */
#define AT(type, member) .offset = offsetof(type, member)
#define ANY .min = -INFINITY, .max = INFINITY
#define ABOVE_0 .min = 0, .max = INFINITY, .min_excluded = true
#define FROM_0 .min = 0, .max = INFINITY
#define OR_NONE .nan_is_unset = true
#define LIST_AT(type, member, counter) AT(type, member), .count_offset = offsetof(type, counter)
#define CHOICE(type, member, value) .choice_offset = offsetof(type, member), .choice = (value)
#define KEYS(name, type, fill)                                                                                         \
    static const sph2d_keys name##_keys = {name##_items, sizeof name##_items / sizeof name##_items[0], sizeof(type),   \
                                           fill}

/* In the order of their enums; a flag is a word. */
static const char *const flag_words[] = {"false", "true", NULL};
static const char *const take_words[] = {"default", "last",   "max",      "min",   "mean",  "rms",
                                         "spread",  "period", "crossing", "value", "decay", NULL};
static const char *const norm_words[] = {"max", "rms", "mean", NULL};
static const char *const summary_words[] = {
    "compression", "compression_mean", "compression_max", "energy_change", "iterations",
    "energy_rise", "energy_error",     "density_apart",   "left",          NULL};
static const char *const quantity_words[] = {"vx", "vy", "speed", "pressure", "density", NULL};

/* ---- runs -------------------------------------------------------------------------------------------------------- */

static const sph2d_key override_items[] = {
    {"key", SPH2D_KEY_TEXT, true, AT(sph2d_override, path), .unit = "", .text = "a key path of the scene"},
    {"value", SPH2D_KEY_TEXT, true, AT(sph2d_override, value), .unit = "", .text = "its value"},
};
KEYS(override, sph2d_override, NULL);

static const sph2d_key run_items[] = {
    {"name", SPH2D_KEY_TEXT, false, AT(sph2d_study_run, name), .unit = "", .default_text = "made from set",
     .text = "of the row"},
    {"set", SPH2D_KEY_LIST, false, LIST_AT(sph2d_study_run, overrides, override_count), .keys = &override_keys,
     .as_mapping = true, .unit = "", .default_text = "none",
     .text = "keys of the scene with other values: {spacing: 0.02, method.cfl: 0.2}"},
    {"skip", SPH2D_KEY_WORD, false, AT(sph2d_study_run, skip), .words = flag_words, .unit = "", .default_text = "false",
     .text = "leaves the row out unless all are asked for"},
};
KEYS(run, sph2d_study_run, NULL);

/* ---- measures ---------------------------------------------------------------------------------------------------- */

static const sph2d_key profile_items[] = {
    {"line", SPH2D_KEY_POINTS, true, LIST_AT(sph2d_study_profile, line.items, line.count), ANY, .unit = "m",
     .text = "its two ends [[x, y], [x, y]]"},
    {"value", SPH2D_KEY_WORD, true, AT(sph2d_study_profile, value), .words = quantity_words, .unit = "",
     .text = "what is compared"},
};
KEYS(profile, sph2d_study_profile, NULL);

static const sph2d_key reference_items[] = {
    {"file", SPH2D_KEY_TEXT, true, AT(sph2d_study_reference, file), .unit = "", .text = "a CSV file"},
    {"x", SPH2D_KEY_TEXT, true, AT(sph2d_study_reference, x), .unit = "",
     .text = "its column of times, or of places along the line from 0 to 1"},
    {"y", SPH2D_KEY_TEXT, true, AT(sph2d_study_reference, y), .unit = "", .text = "its column of values"},
    {"shift", SPH2D_KEY_NUMBER, false, AT(sph2d_study_reference, shift), FROM_0, .unit = "s", .default_text = "0",
     .text = "how far its times may be moved to fit best"},
};
KEYS(reference, sph2d_study_reference, NULL);

static void set_measure(void *out)
{
    *(sph2d_study_measure *)out =
        (sph2d_study_measure){.level = NAN, .at = NAN, .from = NAN, .to = NAN, .scale = 1, .expect = NAN, .bound = NAN};
}

static const sph2d_key measure_items[] = {
    {"name", SPH2D_KEY_TEXT, true, AT(sph2d_study_measure, name), .unit = "", .text = "heading of the column"},
    {"probe", SPH2D_KEY_TEXT, false, AT(sph2d_study_measure, probe),
     CHOICE(sph2d_study_measure, source, SPH2D_MEASURE_PROBE), .unit = "", .text = "name of a probe of the scene"},
    {"profile", SPH2D_KEY_GROUP, false, AT(sph2d_study_measure, profile),
     CHOICE(sph2d_study_measure, source, SPH2D_MEASURE_PROFILE), .keys = &profile_keys, .unit = "",
     .text = "the liquid along a line at the end, instead of a probe"},
    {"summary", SPH2D_KEY_WORD, false, AT(sph2d_study_measure, summary),
     CHOICE(sph2d_study_measure, source, SPH2D_MEASURE_SUMMARY), .words = summary_words, .unit = "",
     .text = "what the run says of itself: the compression that 1 % of the particles exceed, its mean, the "
             "largest; the change of energy over that at the start; iterations of a pressure solver a step; the energy "
             "that came from nothing and what does not add up, as parts of the scene's; how far the density that "
             "particles tell lies from the one by counting; particles lost through open sides"},
    {"column", SPH2D_KEY_TEXT, false, AT(sph2d_study_measure, column), .unit = "",
     .text = "of the probe, without its unit"},
    {"take", SPH2D_KEY_WORD, false, AT(sph2d_study_measure, take), .words = take_words, .unit = "",
     .default_text = "last, or all for a reference and for finest", .text = "how the series becomes a number"},
    {"level", SPH2D_KEY_NUMBER, false, AT(sph2d_study_measure, level), ANY, OR_NONE, .unit = "",
     .default_text = "the mean", .text = "what a crossing, period or decay refers to, in units of the column"},
    {"at", SPH2D_KEY_NUMBER, false, AT(sph2d_study_measure, at), FROM_0, OR_NONE, .unit = "s",
     .text = "value: the time"},
    {"from", SPH2D_KEY_NUMBER, false, AT(sph2d_study_measure, from), FROM_0, OR_NONE, .unit = "s",
     .default_text = "the start", .text = "where the part of the series that counts begins"},
    {"to", SPH2D_KEY_NUMBER, false, AT(sph2d_study_measure, to), FROM_0, OR_NONE, .unit = "s",
     .default_text = "the end", .text = "where it ends"},
    {"scale", SPH2D_KEY_NUMBER, false, AT(sph2d_study_measure, scale), ABOVE_0, .unit = "", .default_text = "1",
     .text = "divides what is taken; expect, reference and bound are in units of it"},
    {"expect", SPH2D_KEY_NUMBER, false, AT(sph2d_study_measure, expect), ANY, OR_NONE,
     CHOICE(sph2d_study_measure, expectation, SPH2D_EXPECT_NUMBER), .unit = "", .text = "the right value"},
    {"reference", SPH2D_KEY_GROUP, false, AT(sph2d_study_measure, reference),
     CHOICE(sph2d_study_measure, expectation, SPH2D_EXPECT_REFERENCE), .keys = &reference_keys, .unit = "",
     .text = "points that the series or profile is compared with, instead of expect"},
    {"finest", SPH2D_KEY_WORD, false, AT(sph2d_study_measure, finest),
     CHOICE(sph2d_study_measure, expectation, SPH2D_EXPECT_FINEST), .words = flag_words, .unit = "",
     .text = "true: what the run of the smallest spacing gives is right, instead of expect"},
    {"norm", SPH2D_KEY_WORD, false, AT(sph2d_study_measure, norm), .words = norm_words, .unit = "",
     .default_text = "max", .text = "of the differences from the reference, or from the series of the finest run"},
    {"relative", SPH2D_KEY_WORD, false, AT(sph2d_study_measure, relative), .words = flag_words, .unit = "",
     .default_text = "false",
     .text = "makes the error |value/expect - 1|, or the norm over the largest value of the finest series"},
    {"bound", SPH2D_KEY_NUMBER, false, AT(sph2d_study_measure, bound), FROM_0, OR_NONE, .unit = "",
     .default_text = "none", .text = "largest error; above it the study fails"},
    {"order", SPH2D_KEY_WORD, false, AT(sph2d_study_measure, order), .words = flag_words, .unit = "",
     .default_text = "false",
     .text = "reports the observed order of convergence between rows, listed from coarse to fine"},
};
KEYS(measure, sph2d_study_measure, set_measure);

/* ---- the study --------------------------------------------------------------------------------------------------- */

static const sph2d_key vary_items[] = {
    {"key", SPH2D_KEY_TEXT, true, AT(sph2d_override, path), .unit = "", .text = "a key path of the scene"},
    {"values", SPH2D_KEY_TEXT, true, AT(sph2d_override, value), .unit = "", .text = "a list of values"},
};
KEYS(vary, sph2d_override, NULL);

static void set_study(void *out)
{
    *(sph2d_study *)out = (sph2d_study){.along = "spacing", .repeat = 1, .target = 0.01};
}

static const sph2d_key study_items[] = {
    {"scene", SPH2D_KEY_TEXT, true, AT(sph2d_study, scene), .unit = "", .text = "the scene file, from this folder"},
    {"runs", SPH2D_KEY_LIST, false, LIST_AT(sph2d_study, runs, run_count), .keys = &run_keys, .unit = "",
     .default_text = "the scene as it is", .text = "one row of the table each"},
    {"vary", SPH2D_KEY_LIST, false, LIST_AT(sph2d_study, vary, vary_count), .keys = &vary_keys, .as_mapping = true,
     .unit = "", .default_text = "none",
     .text = "keys of the scene with a list of values each, {spacing: [0.02, 0.01], method.cfl: [0.1, 0.3]}: each "
             "combination is a row"},
    {"refine", SPH2D_KEY_LIST, false, LIST_AT(sph2d_study, refinements, refinement_count), .keys = &run_keys,
     .unit = "", .default_text = "none",
     .text = "steps after that: the cheapest rows for their error, of those with the smallest spacing, once more with "
             "set"},
    {"measures", SPH2D_KEY_LIST, false, LIST_AT(sph2d_study, measures, measure_count), .keys = &measure_keys,
     .unit = "", .default_text = "none", .text = "one to three columns of the table each"},
    {"judge", SPH2D_KEY_TEXT, false, AT(sph2d_study, judge), .unit = "", .default_text = "the first with an error",
     .text = "the measure whose error is weighed against the time"},
    {"along", SPH2D_KEY_TEXT, false, AT(sph2d_study, along), .unit = "", .default_text = "spacing",
     .text = "the key on the axis of the plot; rows that differ in nothing else belong together"},
    {"target", SPH2D_KEY_TEXT, false, AT(sph2d_study, target_text), .unit = "", .default_text = "0.01",
     .text = "the error that the cheapest row is named for, 0.01 or 1%; of a relative error 1 and more need the %"},
    {"repeat", SPH2D_KEY_COUNT, false, AT(sph2d_study, repeat), .min = 1, .max = 100, .unit = "", .default_text = "1",
     .text = "how often a row of less than 10 s is run; the least time counts"},
};
KEYS(study, sph2d_study, set_study);

const sph2d_keys *sph2d_study_keys(void)
{
    return &study_keys;
}
