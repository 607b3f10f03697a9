/* SPDX-License-Identifier: MIT */
/** @file test_scene_keys.c
 *  The key table against the scene checker: whatever number the table knows is refused when it is NaN, infinite or out
 *  of range, under its own key path, and the ranges are those that sph2d/scene.h documents. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common.h"

/* ---- a scene with every key -------------------------------------------------------------------------------------- */

static sph2d_vec2 corners[3] = {{0.5, 0.1}, {0.7, 0.1}, {0.6, 0.3}}, ends[2] = {{0.1, 0.8}, {0.2, 0.8}};
static sph2d_vec2 drain_corners[3] = {{0.8, 0.1}, {0.9, 0.1}, {0.9, 0.2}},
                  turns[3] = {{0.4, 0.8}, {0.5, 0.85}, {0.6, 0.8}};
static sph2d_pose_point poses[2] = {{0, 0, 0, 0}, {1, 0.1, 0.1, 0.5}};
static sph2d_swing swings[2] = {{{0.01, 0}, 0, 1, 0}, {{0, 0}, 0.1, 2, 0}};
static sph2d_path_point path[2] = {{0, 0.1, 0.1}, {1, 0.9, 0.9}};
static double impacts[2] = {0.1, 0.2};
static sph2d_block blocks[3];
static sph2d_source sources[1];
static sph2d_drain drains[3];
static sph2d_obstacle obstacles[4];
static sph2d_body bodies[3];
static sph2d_spring body_springs[1];
static sph2d_interaction interactions[1];
static sph2d_probe probes[2];
static sph2d_scene scene;

static void fill_lists(void)
{
    blocks[0] = test_block(0.1, 0.1, 0.3, 0.3);
    blocks[1] = blocks[2] = sph2d_block_default();
    blocks[1].shape.kind = SPH2D_SHAPE_CIRCLE;
    blocks[1].shape.circle = (sph2d_circle){{0.4, 0.5}, 0.1};
    blocks[2].shape.kind = SPH2D_SHAPE_POLYGON;
    blocks[2].shape.points = (sph2d_points){corners, 3};
    drains[0] = drains[1] = drains[2] = sph2d_drain_default();
    drains[0].shape = blocks[0].shape;
    drains[1].shape = blocks[1].shape;
    drains[2].shape.kind = SPH2D_SHAPE_POLYGON;
    drains[2].shape.points = (sph2d_points){drain_corners, 3};
    sources[0] = sph2d_source_default();
    sources[0].at = (sph2d_vec2){0.9, 0.9};
    sources[0].width = 0.05;
    sources[0].speed = 1;
    for (int i = 0; i < 4; ++i) {
        obstacles[i] = sph2d_obstacle_default();
        obstacles[i].motion.path = (sph2d_pose_path){poses, 2};
        obstacles[i].motion.swings = swings;
        obstacles[i].motion.swing_count = 2;
        obstacles[i].motion.center = (sph2d_vec2){0.5, 0.5};
        obstacles[i].motion.rate = 0.5;
    }
    obstacles[0].shape.kind = SPH2D_SHAPE_LINE;
    obstacles[0].shape.points = (sph2d_points){ends, 2};
    obstacles[1].shape.kind = SPH2D_SHAPE_POLYLINE;
    obstacles[1].shape.points = (sph2d_points){turns, 3};
    obstacles[2].shape.kind = SPH2D_SHAPE_CIRCLE;
    obstacles[2].shape.circle = (sph2d_circle){{0.8, 0.6}, 0.05};
    obstacles[3].shape.kind = SPH2D_SHAPE_BOX;
    obstacles[3].shape.box = (sph2d_box){{0.05, 0.5}, {0.15, 0.6}};
    interactions[0] = sph2d_interaction_default();
    interactions[0].path = (sph2d_path){path, 2};
    interactions[0].radius = 0.2;
    interactions[0].acceleration = 5;
    probes[0] = probes[1] = sph2d_probe_default();
    probes[0].name = "energy";
    probes[0].rate.every = 0.1;
    probes[1].name = "speed";
    probes[1].kind = SPH2D_PROBE_SPEED;
    probes[1].at = (sph2d_vec2){0.2, 0.2};
    probes[1].rate.per_second = 10;
}

static void set_up_bodies(void)
{
    static sph2d_vec2 bow[3] = {{0.85, 0.8}, {0.95, 0.8}, {0.9, 0.9}};
    body_springs[0] = sph2d_spring_default();
    body_springs[0].to = (sph2d_vec2){0.3, 0.9};
    body_springs[0].stiffness = 10;
    for (int i = 0; i < 3; ++i) {
        bodies[i] = sph2d_body_default();
        bodies[i].density = 500;
        bodies[i].springs = body_springs;
        bodies[i].spring_count = 1;
    }
    bodies[0].shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.3, 0.7}, 0.05}};
    bodies[1].shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.55, 0.5}, {0.65, 0.6}}};
    bodies[2].shape = (sph2d_shape){.kind = SPH2D_SHAPE_POLYGON, .points = {bow, 3}};
    scene.bodies = bodies;
    scene.body_count = 3;
}

static void start(void)
{
    fill_lists();
    scene = sph2d_scene_default();
    scene.domain = (sph2d_box){{0, 0}, {1, 1}};
    scene.spacing = 0.02;
    scene.method.stiffness = 100;
    scene.gravity_path = (sph2d_path){path, 2};
    scene.motion.path = (sph2d_pose_path){poses, 2};
    scene.motion.between = SPH2D_BETWEEN_CUBIC;
    scene.motion.swings = swings;
    scene.motion.swing_count = 2;
    scene.run.until = 0.9; /* it ends at a speed */
    scene.blocks = blocks;
    scene.block_count = 3;
    scene.sources = sources;
    scene.source_count = 1;
    scene.drains = drains;
    scene.drain_count = 3;
    scene.obstacles = obstacles;
    scene.obstacle_count = 4;
    set_up_bodies();
    scene.interactions = interactions;
    scene.interaction_count = 1;
    scene.probes = probes;
    scene.probe_count = 2;
    scene.run.impacts.items = impacts;
    scene.run.impacts.count = 2;
}

/** Whether the scene is refused with this code at this path. */
static bool refused(sph2d_code code, const char *at)
{
    static sph2d_report report;
    sph2d_report_clear(&report);
    return sph2d_scene_check(&scene, &report) == SPH2D_SCENE && test_report_has(&report, code, at);
}

static bool accepted(const char *at)
{
    static sph2d_report report;
    sph2d_report_clear(&report);
    sph2d_scene_check(&scene, &report);
    return !test_report_has(&report, SPH2D_CODE_OUT_OF_RANGE, at);
}

/* ---- a walk over the table --------------------------------------------------------------------------------------- */

typedef void visitor(const sph2d_key *key, char *slot, char *owner, const char *at);

static void *list_of(const char *slot)
{
    void *items;
    memcpy(&items, slot, sizeof items);
    return items;
}

/** Visits every key that the scene holds a value of, with its place in memory, its struct and its path. */
static void walk(const sph2d_keys *keys, char *owner, const char *prefix, visitor *visit)
{
    for (size_t k = 0; k < keys->count; ++k) {
        const sph2d_key *key = &keys->items[k];
        int chosen = 0;
        memcpy(&chosen, owner + key->choice_offset, sizeof chosen);
        if (key->choice != 0 && chosen != key->choice)
            continue;
        char at[128], *slot = owner + key->offset;
        snprintf(at, sizeof at, "%s%s%s", prefix, prefix[0] ? "." : "", key->name);
        visit(key, slot, owner, at);
        if (key->kind == SPH2D_KEY_GROUP)
            walk(key->keys, slot, at, visit);
        size_t count = 0;
        if (key->kind == SPH2D_KEY_LIST)
            memcpy(&count, owner + key->count_offset, sizeof count);
        for (size_t i = 0; i < count; ++i) {
            char item[160];
            snprintf(item, sizeof item, "%s[%zu]", at, i);
            walk(key->keys, (char *)list_of(slot) + i * key->keys->size, item, visit);
        }
    }
}

static size_t visited, wrong;
static char first_wrong[160];

static void note(bool good, const char *at, double value)
{
    ++visited;
    if (!good && wrong++ == 0)
        snprintf(first_wrong, sizeof first_wrong, "%s = %g", at, value);
}

static void walk_all(visitor *visit)
{
    visited = wrong = 0;
    walk(sph2d_scene_keys(), (char *)&scene, "", visit);
}

/** The numbers of a key: first one and how many. */
static double *numbers_of(const sph2d_key *key, char *slot, const char *owner, size_t *count)
{
    *count = 0;
    if (key->count_offset)
        memcpy(count, owner + key->count_offset, sizeof *count);
    switch (key->kind) {
    case SPH2D_KEY_NUMBER:
        *count = 1;
        return (double *)(void *)slot;
    case SPH2D_KEY_POINT:
        *count = 2;
        return (double *)(void *)slot;
    case SPH2D_KEY_POINTS:
        *count *= 2;
        return list_of(slot);
    case SPH2D_KEY_POSES:
        *count *= 4;
        return list_of(slot);
    case SPH2D_KEY_PATH:
        *count *= 3;
        return list_of(slot);
    case SPH2D_KEY_NUMBERS:
        return list_of(slot);
    default:
        *count = 0;
        return NULL;
    }
}

static void spoil_numbers(const sph2d_key *key, char *slot, char *owner, const char *at)
{
    size_t count;
    double *numbers = numbers_of(key, slot, owner, &count);
    double bad[6] = {NAN, INFINITY, -INFINITY};
    int n = 3;
    if (isfinite(key->min))
        bad[n++] = key->min_excluded ? key->min : nextafter(key->min, -INFINITY);
    if (isfinite(key->min))
        bad[n++] = key->min - 1;
    if (isfinite(key->max))
        bad[n++] = nextafter(key->max, INFINITY);
    for (size_t i = 0; i < count; ++i)
        for (int b = key->nan_is_unset ? 1 : 0; b < n; ++b) {
            double good = numbers[i];
            numbers[i] = bad[b];
            note(refused(SPH2D_CODE_OUT_OF_RANGE, at), at, bad[b]);
            numbers[i] = good;
        }
}

START_TEST(every_number_is_checked)
{
    ck_assert_int_eq(sph2d_scene_check(&scene, NULL), SPH2D_OK);
    walk_all(spoil_numbers);
    ck_assert_uint_gt(visited, 300);
    ck_assert_msg(wrong == 0, "%zu of %zu accepted, the first is %s", wrong, visited, first_wrong);
    ck_assert_int_eq(sph2d_scene_check(&scene, NULL), SPH2D_OK);
}
END_TEST

static void spoil_words(const sph2d_key *key, char *slot, char *owner, const char *at)
{
    (void)owner;
    if (key->kind != SPH2D_KEY_WORD)
        return;
    int good, count = 0;
    memcpy(&good, slot, sizeof good);
    while (key->words[count])
        ++count;
    int bad[4] = {-1, count, 99, -2147483647 - 1};
    for (int b = 0; b < 4; ++b) {
        memcpy(slot, &bad[b], sizeof good);
        note(refused(SPH2D_CODE_OUT_OF_RANGE, at), at, bad[b]);
    }
    memcpy(slot, &good, sizeof good);
}

START_TEST(every_word_is_checked)
{
    walk_all(spoil_words);
    ck_assert_uint_gt(visited, 40);
    ck_assert_msg(wrong == 0, "%zu of %zu accepted, the first is %s", wrong, visited, first_wrong);
}
END_TEST

static void spoil_counts(const sph2d_key *key, char *slot, char *owner, const char *at)
{
    (void)owner;
    if ((key->kind != SPH2D_KEY_COUNT && key->kind != SPH2D_KEY_COUNTS2) || !isfinite(key->max))
        return;
    uint64_t *counts = (uint64_t *)(void *)slot;
    for (int i = 0; i < (key->kind == SPH2D_KEY_COUNTS2 ? 2 : 1); ++i) {
        uint64_t good = counts[i], bad[3] = {(uint64_t)key->max + 1, UINT64_MAX, (uint64_t)key->min - 1};
        for (int b = 0; b < (key->min > 0 ? 3 : 2); ++b) {
            counts[i] = bad[b];
            note(refused(SPH2D_CODE_OUT_OF_RANGE, at), at, (double)bad[b]);
        }
        counts[i] = good;
    }
}

START_TEST(every_count_is_checked)
{
    walk_all(spoil_counts);
    ck_assert_uint_ge(visited, 8); /* the frame's two sizes, the deflate level */
    ck_assert_msg(wrong == 0, "%zu of %zu accepted, the first is %s", wrong, visited, first_wrong);
}
END_TEST

static void spoil_lists(const sph2d_key *key, char *slot, char *owner, const char *at)
{
    if (key->count_offset == 0)
        return;
    void *items = list_of(slot), *none = NULL;
    size_t count, zero = 0, one = 1;
    memcpy(&count, owner + key->count_offset, sizeof count);
    memcpy(slot, &none, sizeof none);
    if (count == 0) /* the scene has none of these */
        memcpy(owner + key->count_offset, &one, sizeof one);
    note(refused(SPH2D_CODE_CONFLICT, at), at, 0);
    memcpy(owner + key->count_offset, &zero, sizeof zero);
    sph2d_scene_check(&scene, NULL); /* none and 0 agree; whatever it means, it must not be read */
    memcpy(owner + key->count_offset, &count, sizeof count);
    memcpy(slot, &items, sizeof items);
}

START_TEST(a_count_without_a_list_is_refused)
{
    walk_all(spoil_lists);
    ck_assert_uint_ge(visited, 12);
    ck_assert_msg(wrong == 0, "%zu of %zu accepted, the first is %s", wrong, visited, first_wrong);
}
END_TEST

/* ---- the table itself -------------------------------------------------------------------------------------------- */

static void look_at_key(const sph2d_key *key, char *slot, char *owner, const char *at)
{
    (void)slot;
    (void)owner;
    bool good = key->name && key->name[0] && key->text && key->text[0] && key->unit && !(key->min > key->max);
    good = good && (key->kind != SPH2D_KEY_WORD || (key->words && key->words[0]));
    good = good && ((key->kind != SPH2D_KEY_GROUP && key->kind != SPH2D_KEY_LIST) || (key->keys && key->keys->count));
    good = good && (key->kind != SPH2D_KEY_LIST || (key->keys->set_default && key->count_offset));
    note(good, at, 0);
}

START_TEST(rows_are_complete)
{
    walk_all(look_at_key);
    ck_assert_uint_gt(visited, 100);
    ck_assert_msg(wrong == 0, "%zu rows, the first is %s", wrong, first_wrong);
    ck_assert_uint_eq(sph2d_scene_keys()->size, sizeof(sph2d_scene));
    sph2d_scene fresh;
    sph2d_scene_keys()->set_default(&fresh);
    ck_assert_uint_eq(fresh.struct_size, sizeof fresh);
    ck_assert(fresh.gravity.y == -9.81 && fresh.fluid.density == 1000 && fresh.method.density_diffusion == 0.1);
}
END_TEST

START_TEST(ranges_are_as_documented)
{
    const struct {
        const char *at;
        double *slot, min, max;
        bool excluded;
    } rows[] = {
        {"fluid.density", &scene.fluid.density, 0, INFINITY, true},
        {"fluid.dynamic_viscosity", &scene.fluid.dynamic_viscosity, 0, INFINITY, false},
        {"method.max_compression", &scene.method.max_compression, 1e-6, 0.9, false},
        {"method.support_ratio", &scene.method.support_ratio, 1.2, 6, false},
        {"method.cfl", &scene.method.cfl, 0.01, 0.25, false}, /* of this method */
        {"method.time_step", &scene.method.time_step, 0, INFINITY, false},
        {"method.stiffness", &scene.method.stiffness, 0, INFINITY, false},
        {"spacing", &scene.spacing, 0, INFINITY, true},
        {"slip_length", &scene.slip_length, 0, INFINITY, false},
        {"wall_damping", &scene.wall_damping, 0, 1, false},
        {"run.until", &scene.run.until, 0, INFINITY, false},
        {"run.snapshots.every", &scene.run.snapshots.rate.every, 0, INFINITY, false},
        {"run.frames.per_second", &scene.run.frames.rate.per_second, 0, INFINITY, false},
        {"run.frames.radius", &scene.run.frames.radius, 0, INFINITY, false},
        {"blocks[0].spacing", &blocks[0].spacing, 0, INFINITY, false},
        {"blocks[1].circle.radius", &blocks[1].shape.circle.radius, 0, INFINITY, true},
        {"sources[0].width", &sources[0].width, 0, INFINITY, false},
        {"sources[0].speed", &sources[0].speed, 0, INFINITY, true},
        {"sources[0].spread", &sources[0].spread, 0, 1, false},
        {"sources[0].rate", &sources[0].rate, 0, INFINITY, false},
        {"sources[0].start", &sources[0].start, 0, INFINITY, false},
        {"obstacles[0].restitution", &obstacles[0].restitution, 0, 1, false},
        {"obstacles[2].circle.radius", &obstacles[2].shape.circle.radius, 0, INFINITY, true},
        {"interactions[0].radius", &interactions[0].radius, 0, INFINITY, true},
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i) {
        double good = *rows[i].slot;
        *rows[i].slot = rows[i].min;
        ck_assert_msg(accepted(rows[i].at) == !rows[i].excluded, "%s = %g", rows[i].at, rows[i].min);
        *rows[i].slot = rows[i].min - 1e-7;
        ck_assert_msg(!accepted(rows[i].at), "%s = %g", rows[i].at, *rows[i].slot);
        if (isfinite(rows[i].max)) {
            *rows[i].slot = rows[i].max;
            ck_assert_msg(accepted(rows[i].at), "%s = %g", rows[i].at, rows[i].max);
            *rows[i].slot = rows[i].max + 1e-7;
            ck_assert_msg(!accepted(rows[i].at), "%s = %g", rows[i].at, *rows[i].slot);
        }
        *rows[i].slot = good;
    }
}
END_TEST

Suite *suite_scene_keys(void)
{
    Suite *suite = suite_create("scene_keys");
    TCase *tests = tcase_create("keys");
    tcase_add_checked_fixture(tests, start, NULL);
    tcase_add_test(tests, every_number_is_checked);
    tcase_add_test(tests, every_word_is_checked);
    tcase_add_test(tests, every_count_is_checked);
    tcase_add_test(tests, a_count_without_a_list_is_refused);
    tcase_add_test(tests, rows_are_complete);
    tcase_add_test(tests, ranges_are_as_documented);
    suite_add_tcase(suite, tests);
    return suite;
}
