/* SPDX-License-Identifier: MIT */
/** @file test_scene_check.c
 *  Faults of meaning in a scene: each has its code and its key path, and all are found at once. Faults of range are in
 *  test_scene_keys.c. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "common.h"

/* ---- a sound scene, to be broken --------------------------------------------------------------------------------- */

static sph2d_vec2 corners[4], ends[3], turns[3];
static sph2d_path_point path[2];
static sph2d_block blocks[3];
static sph2d_source sources[1];
static sph2d_drain drains[1];
static sph2d_absorber absorbers[2];
static sph2d_obstacle obstacles[4];
static sph2d_interaction interactions[1];
static sph2d_probe probes[2];
static sph2d_scene scene;
static sph2d_report report;

static void fill_shapes(void)
{
    blocks[0] = test_block(0.1, 0.1, 0.3, 0.3);
    blocks[1] = blocks[2] = sph2d_block_default();
    blocks[1].shape.kind = SPH2D_SHAPE_CIRCLE;
    blocks[1].shape.circle = (sph2d_circle){{0.4, 0.5}, 0.08};
    blocks[2].shape.kind = SPH2D_SHAPE_POLYGON;
    corners[0] = (sph2d_vec2){0.5, 0.1};
    corners[1] = (sph2d_vec2){0.7, 0.1};
    corners[2] = (sph2d_vec2){0.7, 0.3};
    corners[3] = (sph2d_vec2){0.5, 0.35};
    blocks[2].shape.points = (sph2d_points){corners, 4};
    for (int i = 0; i < 4; ++i)
        obstacles[i] = sph2d_obstacle_default();
    ends[0] = (sph2d_vec2){0.1, 0.8};
    ends[1] = (sph2d_vec2){0.2, 0.85};
    obstacles[0].shape.kind = SPH2D_SHAPE_LINE;
    obstacles[0].shape.points = (sph2d_points){ends, 2};
    turns[0] = (sph2d_vec2){0.4, 0.8};
    turns[1] = (sph2d_vec2){0.5, 0.85};
    turns[2] = (sph2d_vec2){0.6, 0.8};
    obstacles[1].shape.kind = SPH2D_SHAPE_POLYLINE;
    obstacles[1].shape.points = (sph2d_points){turns, 3};
    obstacles[2].shape.kind = SPH2D_SHAPE_CIRCLE;
    obstacles[2].shape.circle = (sph2d_circle){{0.8, 0.6}, 0.05};
    obstacles[3].shape.kind = SPH2D_SHAPE_BOX;
    obstacles[3].shape.box = (sph2d_box){{0.05, 0.5}, {0.15, 0.6}};
}

static void start(void)
{
    fill_shapes();
    sources[0] = sph2d_source_default();
    sources[0].at = (sph2d_vec2){0.9, 0.9};
    sources[0].width = 0.05;
    sources[0].speed = 1;
    drains[0] = sph2d_drain_default();
    drains[0].shape = blocks[0].shape;
    absorbers[0] = absorbers[1] = (sph2d_absorber){.side = SPH2D_SIDE_NAME_LEFT, .length = 0.5};
    absorbers[1].side = SPH2D_SIDE_NAME_RIGHT;
    path[0] = (sph2d_path_point){0, 0.1, 0.1};
    path[1] = (sph2d_path_point){1, 0.9, 0.9};
    interactions[0] = sph2d_interaction_default();
    interactions[0].path = (sph2d_path){path, 2};
    interactions[0].radius = 0.2;
    probes[0] = probes[1] = sph2d_probe_default();
    probes[0].name = "Energy_of-all2";
    probes[0].rate.every = 0.1;
    probes[1].name = "speed";
    probes[1].kind = SPH2D_PROBE_SPEED;
    probes[1].at = (sph2d_vec2){0.2, 0.2};
    probes[1].rate.per_second = 10;
    scene = sph2d_scene_default();
    scene.method.name = SPH2D_METHOD_MULLER;
    scene.domain = (sph2d_box){{0, 0}, {1, 1}};
    scene.spacing = 0.02;
    scene.blocks = blocks;
    scene.block_count = 3;
    scene.sources = sources;
    scene.source_count = 1;
    scene.drains = drains;
    scene.drain_count = 1;
    scene.absorbers = absorbers;
    scene.absorber_count = 2;
    scene.obstacles = obstacles;
    scene.obstacle_count = 4;
    scene.interactions = interactions;
    scene.interaction_count = 1;
    scene.probes = probes;
    scene.probe_count = 2;
    sph2d_report_clear(&report);
}

/* ---- single faults ----------------------------------------------------------------------------------------------- */

/** One thing broken at a time: name, key path, code, and the statement that breaks it. */
#define FAULT_LIST(X)                                                                                                  \
    X(domain_missing, "domain", OUT_OF_RANGE, scene.domain = sph2d_scene_default().domain)                             \
    X(domain_flat, "domain", OUT_OF_RANGE, scene.domain.max.y = scene.domain.min.y)                                    \
    X(domain_reversed, "domain", OUT_OF_RANGE, scene.domain.min.x = 2)                                                 \
    X(spacing_missing, "spacing", OUT_OF_RANGE, scene.spacing = sph2d_scene_default().spacing)                         \
    X(spacing_negative, "spacing", OUT_OF_RANGE, scene.spacing = -0.02)                                                \
    X(block_shapeless, "blocks[0]", MISSING_KEY, blocks[0].shape.kind = SPH2D_SHAPE_NONE)                              \
    X(block_reversed, "blocks[0].box", OUT_OF_RANGE, blocks[0].shape.box.max.x = 0.05)                                 \
    X(block_outside, "blocks[0].box", OUTSIDE, blocks[0].shape.box.max.x = 1.05)                                       \
    X(block_below, "blocks[0].box", OUTSIDE, blocks[0].shape.box.min.y = -0.01)                                        \
    X(disc_outside, "blocks[1].circle", OUTSIDE, blocks[1].shape.circle.center.x = 0.05)                               \
    X(disc_without_radius, "blocks[1].circle.radius", OUT_OF_RANGE, blocks[1].shape.circle.radius = 0)                 \
    X(polygon_of_two, "blocks[2].polygon", OUT_OF_RANGE, blocks[2].shape.points.count = 2)                             \
    X(polygon_on_a_line, "blocks[2].polygon", OUT_OF_RANGE, blocks[2].shape.points.count = 3;                          \
      corners[2] = (sph2d_vec2){0.9, 0.1})                                                                             \
    X(polygon_outside, "blocks[2].polygon", OUTSIDE, corners[3].y = 1.01)                                              \
    X(polygon_crosses_itself, "blocks[2].polygon", OUT_OF_RANGE, corners[3] = (sph2d_vec2){0.6, 0.05})                 \
    X(source_outside, "sources[0].at", OUTSIDE, sources[0].at.y = 1.5)                                                 \
    X(source_without_direction, "sources[0].direction", OUT_OF_RANGE, sources[0].direction = ((sph2d_vec2){0, 0}))     \
    X(source_without_speed, "sources[0].speed", OUT_OF_RANGE, sources[0].speed = 0)                                    \
    X(slip_length_of_free_walls, "slip_length", CONFLICT, scene.slip_length = 0.01)                                    \
    X(belts_of_free_walls, "wall_speeds", CONFLICT, scene.wall_speeds.top = 1)                                         \
    X(source_too_rich, "sources[0].rate", CONFLICT, sources[0].rate = 0.0501)                                          \
    X(source_stops_early, "sources[0].stop", CONFLICT, sources[0].start = 1; sources[0].stop = 0.5)                    \
    X(drain_shapeless, "drains[0]", MISSING_KEY, drains[0].shape.kind = SPH2D_SHAPE_NONE)                              \
    X(drain_reversed, "drains[0].box", OUT_OF_RANGE, drains[0].shape.box.min.y = 0.4)                                  \
    X(drain_outside, "drains[0].box", OUTSIDE, drains[0].shape.box = ((sph2d_box){{1.1, 0}, {1.2, 1}}))                \
    X(drain_stops_early, "drains[0].stop", CONFLICT, drains[0].start = 1; drains[0].stop = 0.5)                        \
    X(absorber_without_length, "absorbers[1].length", OUT_OF_RANGE, absorbers[1].length = 0)                           \
    X(absorber_too_long, "absorbers[0].length", OUT_OF_RANGE, absorbers[0].length = 1.1)                               \
    X(absorber_of_no_side, "absorbers[0].side", OUT_OF_RANGE, absorbers[0].side = (sph2d_side_name)7)                  \
    X(absorber_twice, "absorbers[1].side", CONFLICT, absorbers[1].side = SPH2D_SIDE_NAME_LEFT)                         \
    X(absorber_without_gravity, "absorbers[0].rate", MISSING_KEY, scene.gravity.y = 0; absorbers[1].rate = 1)          \
    X(absorber_at_periodic_side, "absorbers[1].side", CONFLICT,                                                        \
      scene.boundary.left = scene.boundary.right = SPH2D_SIDE_PERIODIC;                                                \
      absorbers[0].side = SPH2D_SIDE_NAME_TOP)                                                                         \
    X(obstacle_without_outline, "obstacles[3]", MISSING_KEY, obstacles[3].shape.kind = SPH2D_SHAPE_NONE)               \
    X(obstacle_of_springs, "obstacles[3].form", UNSUPPORTED, obstacles[3].form = SPH2D_WALL_SPRING)                    \
    X(line_of_one, "obstacles[0].line", OUT_OF_RANGE, obstacles[0].shape.points.count = 1)                             \
    X(line_of_three, "obstacles[0].line", OUT_OF_RANGE, obstacles[0].shape.points.count = 3;                           \
      ends[2] = (sph2d_vec2){0.3, 0.9})                                                                                \
    X(line_without_length, "obstacles[0].line", OUT_OF_RANGE, ends[1] = ends[0])                                       \
    X(line_outside, "obstacles[0].line", OUTSIDE, ends[1].x = -0.1)                                                    \
    X(polyline_of_one, "obstacles[1].polyline", OUT_OF_RANGE, obstacles[1].shape.points.count = 1)                     \
    X(polyline_stands_still, "obstacles[1].polyline", OUT_OF_RANGE, turns[2] = turns[1])                               \
    X(circle_outside, "obstacles[2].circle.center", OUTSIDE, obstacles[2].shape.circle.center.x = 1.2)                 \
    X(circle_without_radius, "obstacles[2].circle.radius", OUT_OF_RANGE, obstacles[2].shape.circle.radius = 0)         \
    X(box_flat, "obstacles[3].box", OUT_OF_RANGE, obstacles[3].shape.box.max.x = obstacles[3].shape.box.min.x)         \
    X(box_outside, "obstacles[3].box", OUTSIDE, obstacles[3].shape.box.max.y = 1.2)                                    \
    X(interaction_without_path, "interactions[0].path", MISSING_KEY, interactions[0].path.count = 0)                   \
    X(interaction_back_in_time, "interactions[0].path", CONFLICT, path[1].t = 0)                                       \
    X(interaction_outside, "interactions[0].path", OUTSIDE, path[0].x = path[1].x = 1.21)                              \
    X(interaction_without_radius, "interactions[0].radius", OUT_OF_RANGE, interactions[0].radius = 0)                  \
    X(probe_without_name, "probes[0].name", OUT_OF_RANGE, probes[0].name = NULL)                                       \
    X(probe_with_empty_name, "probes[0].name", OUT_OF_RANGE, probes[0].name = "")                                      \
    X(probe_in_a_folder, "probes[0].name", OUT_OF_RANGE, probes[0].name = "../energy")                                 \
    X(probe_with_a_space, "probes[0].name", OUT_OF_RANGE, probes[0].name = "a b")                                      \
    X(probe_with_a_dot, "probes[0].name", OUT_OF_RANGE, probes[0].name = "a.b")                                        \
    X(probe_twice, "probes[1].name", CONFLICT, probes[1].name = "Energy_of-all2")                                      \
    X(probe_without_rate, "probes[0]", MISSING_KEY, probes[0].rate.every = 0)                                          \
    X(probe_with_two_rates, "probes[0].every", CONFLICT, probes[0].rate.per_second = 10)                               \
    X(probe_outside, "probes[1].at", OUTSIDE, probes[1].at.x = -1)                                                     \
    X(pressure_outside, "probes[1].at", OUTSIDE, probes[1].kind = SPH2D_PROBE_PRESSURE; probes[1].at.y = 1.1)          \
    X(elevation_outside, "probes[1].at", OUTSIDE, probes[1].kind = SPH2D_PROBE_ELEVATION; probes[1].at.x = 1.1)        \
    X(probe_of_no_kind, "probes[0].kind", OUT_OF_RANGE, probes[0].kind = (sph2d_probe_kind)1000)                       \
    X(snapshots_with_two_rates, "run.snapshots.every", CONFLICT, scene.run.snapshots.rate = ((sph2d_rate){10, 0.1}))   \
    X(frames_with_two_rates, "run.frames.every", CONFLICT, scene.run.frames.rate = ((sph2d_rate){10, 0.1}))            \
    X(frames_of_nothing, "run.frames.view", OUT_OF_RANGE, scene.run.frames.view = ((sph2d_box){{1, 0}, {1, 2}}))       \
    X(frames_of_no_number, "run.frames.view.min", OUT_OF_RANGE,                                                        \
      scene.run.frames.view = ((sph2d_box){{NAN, 0}, {1, 2}}))                                                         \
    X(frames_follow_nobody, "run.frames.follow", CONFLICT, scene.run.frames.follow = "nobody")                         \
    X(arrows_backwards, "run.frames.arrow_spacing", OUT_OF_RANGE, scene.run.frames.arrow_spacing = -1)                 \
    X(streamlines_backwards, "run.frames.streamline_spacing", OUT_OF_RANGE, scene.run.frames.streamline_spacing = -1)  \
    X(isolines_of_no_step, "run.frames.isoline_step", OUT_OF_RANGE, scene.run.frames.isoline_step = NAN)               \
    X(frames_too_small, "run.frames.size", OUT_OF_RANGE, scene.run.frames.size[1] = 15)                                \
    X(frames_too_large, "run.frames.size", OUT_OF_RANGE, scene.run.frames.size[0] = 16385)                             \
    X(deflate_level, "run.snapshots.compress", OUT_OF_RANGE, scene.run.snapshots.compress = 10)                        \
    X(nothing_in_it, "blocks", NO_PARTICLES, scene.block_count = scene.source_count = 0)

#define MAKE_FAULT(label, at, code, ...)                                                                               \
    static void label(void)                                                                                            \
    {                                                                                                                  \
        __VA_ARGS__;                                                                                                   \
    }
FAULT_LIST(MAKE_FAULT)

static const struct {
    void (*make)(void);
    const char *path;
    sph2d_code code;
} faults[] = {
#define FAULT_ROW(label, at, code, ...) {label, at, SPH2D_CODE_##code},
    FAULT_LIST(FAULT_ROW)
#undef FAULT_ROW
};
enum { FAULTS = sizeof faults / sizeof faults[0] };

START_TEST(the_sound_scene_is_sound)
{
    ck_assert_msg(sph2d_scene_check(&scene, &report) == SPH2D_OK, "%s", test_report_text(&report));
    ck_assert_msg(report.count == 0, "%s", test_report_text(&report));
    ck_assert_int_eq(sph2d_scene_check(&scene, NULL), SPH2D_OK);
}
END_TEST

START_TEST(a_warning_does_not_refuse)
{
    sources[0].at.x = 1; /* on a side */
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_OK);
    ck_assert_uint_eq(report.count, 1);
    ck_assert_uint_eq(report.errors, 0);
    ck_assert_int_eq(report.items[0].severity, SPH2D_WARNING);
    ck_assert_str_eq(report.items[0].path, "sources[0].at");
}
END_TEST

/** Gravity along periodic sides drives a flow, and compresses nothing. */
START_TEST(a_driven_flow_has_no_depth)
{
    sph2d_scene channel = sph2d_scene_default();
    sph2d_block filled = sph2d_block_default();
    filled.shape.kind = SPH2D_SHAPE_BOX;
    filled.shape.box = channel.domain = (sph2d_box){{0, 0}, {1, 1}};
    channel.spacing = 0.05;
    channel.blocks = &filled;
    channel.block_count = 1;
    channel.method.sound_speed = 1;
    channel.gravity = (sph2d_vec2){1, 0};
    ck_assert_int_eq(sph2d_scene_check(&channel, &report), SPH2D_OK);
    ck_assert_uint_eq(report.count, 1);
    sph2d_report_clear(&report);
    channel.boundary.left = channel.boundary.right = SPH2D_SIDE_PERIODIC;
    ck_assert_int_eq(sph2d_scene_check(&channel, &report), SPH2D_OK);
    ck_assert_msg(report.count == 0, "%s", test_report_text(&report));
}
END_TEST

/** What the hard cases say of films, disorder and springs, each at its bound. */
START_TEST(what_a_method_computes_badly_is_warned_of)
{
    sph2d_scene weak = sph2d_scene_default();
    sph2d_block block = sph2d_block_default();
    sph2d_particle particle = {.x = 0.5, .y = 0.024, .density = 1000};
    block.shape.kind = SPH2D_SHAPE_BOX;
    block.shape.box = (sph2d_box){{0, 0}, {1, 0.17}};
    weak.domain = (sph2d_box){{0, 0}, {1, 1}};
    weak.spacing = 0.05;
    weak.blocks = &block;
    weak.block_count = 1;
    for (int deeper = 0; deeper < 2; ++deeper) { /* 3.4 and 3.6 rows */
        block.shape.box.max.y = deeper ? 0.18 : 0.17;
        sph2d_report_clear(&report);
        ck_assert_int_eq(sph2d_scene_check(&weak, &report), SPH2D_OK);
        ck_assert_msg(report.count == (deeper ? 0 : 1), "%s", test_report_text(&report));
    }
    const struct {
        sph2d_method method;
        double amplitude;
        size_t warnings;
    } disorders[] = {{SPH2D_METHOD_MULLER, 0.3, 1}, {SPH2D_METHOD_MULLER, 0.29, 0}, {SPH2D_METHOD_WCSPH, 0.3, 0}};
    block.shape.box.max.y = 0.5;
    for (size_t k = 0; k < sizeof disorders / sizeof *disorders; ++k) {
        weak.method.name = disorders[k].method;
        block.perturb.amplitude = disorders[k].amplitude;
        sph2d_report_clear(&report);
        ck_assert_int_eq(sph2d_scene_check(&weak, &report), SPH2D_OK);
        ck_assert_msg(report.count == disorders[k].warnings, "%s", test_report_text(&report));
    }
    weak.block_count = 0;
    weak.particles = (sph2d_particles){.items = &particle, .count = 1};
    weak.method.name = SPH2D_METHOD_MULLER;
    weak.method.sound_speed = 40;
    weak.walls = SPH2D_WALL_SPRING;
    for (int farther = 0; farther < 2; ++farther) {
        particle.y = farther ? 0.025 : 0.024;
        sph2d_report_clear(&report);
        ck_assert_int_eq(sph2d_scene_check(&weak, &report), SPH2D_OK);
        ck_assert_msg(report.count == (farther ? 0 : 1), "%s", test_report_text(&report));
    }
}
END_TEST

/** 0.5 m deep it falls at U = 3.13 m/s, and walls slow a layer of sqrt(nu L/U) = 5 spacings from 195.8 Pa s on. */
START_TEST(thick_liquid_that_slides_is_warned_of)
{
    static const struct {
        sph2d_rheology model;
        double viscosity, yield_stress; /* the first also the consistency, for an index of 1 */
        sph2d_slip slip;
        sph2d_wall_slip bottom;
        sph2d_method method;
        size_t warnings;
    } liquids[] = {
        {SPH2D_RHEOLOGY_NEWTONIAN, 190, 0, SPH2D_SLIP_FREE, SPH2D_WALL_SLIP_DEFAULT, SPH2D_METHOD_WCSPH, 0},
        {SPH2D_RHEOLOGY_NEWTONIAN, 200, 0, SPH2D_SLIP_FREE, SPH2D_WALL_SLIP_DEFAULT, SPH2D_METHOD_WCSPH, 1},
        {SPH2D_RHEOLOGY_NEWTONIAN, 200, 0, SPH2D_SLIP_NONE, SPH2D_WALL_SLIP_DEFAULT, SPH2D_METHOD_WCSPH, 0},
        {SPH2D_RHEOLOGY_NEWTONIAN, 200, 0, SPH2D_SLIP_FREE, SPH2D_WALL_SLIP_FREE, SPH2D_METHOD_WCSPH, 0},
        {SPH2D_RHEOLOGY_NEWTONIAN, 200, 0, SPH2D_SLIP_FREE, SPH2D_WALL_SLIP_DEFAULT, SPH2D_METHOD_MULLER, 0},
        {SPH2D_RHEOLOGY_HERSCHEL_BULKLEY, 0, 590, SPH2D_SLIP_FREE, SPH2D_WALL_SLIP_DEFAULT, SPH2D_METHOD_WCSPH, 0},
        {SPH2D_RHEOLOGY_HERSCHEL_BULKLEY, 50, 590, SPH2D_SLIP_FREE, SPH2D_WALL_SLIP_DEFAULT, SPH2D_METHOD_WCSPH, 1},
    };
    sph2d_scene thick = sph2d_scene_default();
    sph2d_block block = test_block(0, 0, 1, 0.5);
    thick.domain = (sph2d_box){{0, 0}, {1, 1}};
    thick.spacing = 0.05;
    thick.blocks = &block;
    thick.block_count = 1;
    for (size_t k = 0; k < sizeof liquids / sizeof *liquids; ++k) {
        thick.fluid.model = liquids[k].model;
        bool newtonian = liquids[k].model == SPH2D_RHEOLOGY_NEWTONIAN;
        thick.fluid.dynamic_viscosity =
            newtonian ? liquids[k].viscosity : sph2d_scene_default().fluid.dynamic_viscosity;
        thick.fluid.consistency = newtonian ? 0 : liquids[k].viscosity;
        thick.fluid.yield_stress = liquids[k].yield_stress;
        thick.wall_slip = liquids[k].slip;
        thick.side_slip.bottom = liquids[k].bottom;
        thick.method.name = liquids[k].method;
        sph2d_report_clear(&report);
        sph2d_scene_check(&thick, &report);
        size_t warnings = 0;
        for (size_t i = 0; i < report.count; ++i)
            warnings += strstr(report.items[i].message, "slides") != NULL;
        ck_assert_msg(warnings == liquids[k].warnings, "%zu: %s", k, test_report_text(&report));
    }
}
END_TEST

/** Liquid as deep as 1 m compresses itself by 16 % where sound has 8 m/s, by less than 10 % where it has 12; without a
 *  sound speed there is nothing to warn of. */
START_TEST(a_sound_speed_too_low_for_the_depth_is_warned_of)
{
    sph2d_scene deep = sph2d_scene_default();
    sph2d_block column = sph2d_block_default();
    column.shape.kind = SPH2D_SHAPE_BOX;
    column.shape.box = (sph2d_box){{0, 0}, {0.5, 1}};
    deep.domain = (sph2d_box){{0, 0}, {1, 1.5}};
    deep.spacing = 0.05;
    deep.blocks = &column;
    deep.block_count = 1;
    const struct {
        double sound_speed;
        size_t warnings;
    } cases[] = {{8, 1}, {12, 0}, {0, 0}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        deep.method.sound_speed = cases[k].sound_speed;
        sph2d_report_clear(&report);
        ck_assert_int_eq(sph2d_scene_check(&deep, &report), SPH2D_OK);
        ck_assert_uint_eq(report.count, cases[k].warnings);
        if (report.count > 0)
            ck_assert_str_eq(report.items[0].path, "method.sound_speed");
    }
    /* the same of single particles that a file gave, from which nothing else is derived */
    sph2d_particle two[] = {{.x = 0.2, .y = 0.05}, {.x = 0.2, .y = 1}};
    deep.block_count = 0;
    deep.particles = (sph2d_particles){.file = "column.csv", .items = two, .count = 2};
    for (size_t k = 0; k < 2; ++k) {
        deep.method.sound_speed = cases[k].sound_speed;
        sph2d_report_clear(&report);
        ck_assert_msg(sph2d_scene_check(&deep, &report) == SPH2D_OK, "%s", test_report_text(&report));
        ck_assert_msg(report.count == cases[k].warnings, "%s", test_report_text(&report));
    }
}
END_TEST

/** A wall that has 0.5 m/s at once compresses liquid by 5 % where sound has 10 m/s, five times what is wanted; where
 *  pressure knows no sound it loses v^2/2 of energy. One of 0.09 m/s does neither, and a swing that starts at rest has
 *  no jump. */
START_TEST(a_blow_of_a_wall_is_warned_of)
{
    static const sph2d_pose_point steps[2] = {{0.1, 0, 0, 0}, {0.2, 0.009, 0, 0}};
    static const sph2d_pose_point jump[3] = {{0.1, 0, 0, 0}, {0.2, -0.05, 0, 0}, {0.4, -0.15, 0, 0}};
    scene.method = sph2d_scene_default().method;
    scene.method.sound_speed = 10;
    sph2d_motion *motion = &obstacles[2].motion;
    const struct {
        sph2d_motion motion;
        sph2d_method method;
        const char *warned; /* of this; NULL: of nothing */
    } cases[] = {
        {{.path = {jump, 3}}, SPH2D_METHOD_WCSPH, "by 0.49 m/s at t = 0.1 s, which compresses"},
        {{.path = {jump, 3}}, SPH2D_METHOD_CONSTRAINT, "by 0.49 m/s at t = 0.1 s, an impact: it loses up to 0.12"},
        {{.path = {jump, 3}}, SPH2D_METHOD_PCISPH, "an impact"},
        {{.path = {steps, 2}}, SPH2D_METHOD_WCSPH, NULL},
        {{.path = {steps, 2}}, SPH2D_METHOD_CONSTRAINT, NULL},
        {{.amplitude = {-0.1, 0}, .frequency = 1}, SPH2D_METHOD_WCSPH, "at t = 0 s, which compresses"},
        {{.amplitude = {-0.1, 0}, .frequency = 1}, SPH2D_METHOD_CONSTRAINT, "at t = 0 s, an impact"},
        {{.amplitude = {-0.1, 0}, .frequency = 1, .phase = -1.5708}, SPH2D_METHOD_WCSPH, NULL}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        *motion = cases[k].motion;
        scene.method.name = cases[k].method;
        ck_assert_msg(sph2d_scene_check(&scene, &report) == SPH2D_OK, "%s", test_report_text(&report));
        ck_assert_msg(report.count == (cases[k].warned != NULL), "case %zu: %s", k, test_report_text(&report));
        if (cases[k].warned) {
            ck_assert_str_eq(report.items[0].path, "obstacles[2].motion");
            ck_assert_msg(strstr(report.items[0].message, cases[k].warned) != NULL, "%s", report.items[0].message);
        }
        sph2d_report_clear(&report);
    }
}
END_TEST

/** Only what moves across a face with liquid pushes it: a gate beside a column may be lifted at once. */
/** A wall at the right of a column goes along itself, towards it, away from it (it pushes when it stops), and turns. */
START_TEST(a_wall_that_slides_along_itself_blows_at_nothing)
{
    sph2d_block column = test_block(0, 0, 0.6, 0.5);
    sph2d_obstacle gate = sph2d_obstacle_default();
    sph2d_pose_point way[2] = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    sph2d_scene s = test_scene(0.02, 0, 0, 2, 2);
    s.method = sph2d_scene_default().method;
    s.method.sound_speed = 30;
    s.gravity.y = -9.81;
    s.blocks = &column;
    s.block_count = 1;
    gate.shape.kind = SPH2D_SHAPE_BOX;
    gate.shape.box = (sph2d_box){{0.6, 0}, {0.7, 0.8}};
    gate.motion.path = (sph2d_pose_path){way, 2};
    s.obstacles = &gate;
    s.obstacle_count = 1;
    const struct {
        double time, x, y, angle;
        const char *warned;
    } cases[] = {{0.4, 0, 0.6, 0, NULL},
                 {0.4, -0.2, 0.6, 0, "by 0.5 m/s at t = 0 s"},
                 {0.4, 0.2, 0, 0, "by 0.5 m/s at t = 0.4 s"},
                 {0.4, 0, 0, 0.5, "by 0.5"}};
    sph2d_particle drop = {1, 1.5, 0, 0, 1000, 0};
    for (int k = 0; k < 5; ++k) {
        const int way_of = k < 4 ? k : 0; /* the last time liquid may be anywhere */
        way[1] = (sph2d_pose_point){cases[way_of].time, cases[way_of].x, cases[way_of].y, cases[way_of].angle};
        s.particles = (sph2d_particles){NULL, &drop, k == 4};
        sph2d_report_clear(&report);
        ck_assert_int_eq(sph2d_scene_check(&s, &report), SPH2D_OK);
        const char *told = strstr(test_report_text(&report), "its velocity jumps"),
                   *wanted = k < 4 ? cases[k].warned : "by 1.5 m/s";
        ck_assert_msg(!told == !wanted && (!told || strstr(told, wanted)), "case %d: %s", k, test_report_text(&report));
    }
    sph2d_report_clear(&report);
}
END_TEST

/** The two triangles of a symmetric bow tie cancel: it has no area, but is no line. */
START_TEST(a_bow_tie_is_told_that_it_crosses_itself)
{
    corners[1] = (sph2d_vec2){0.7, 0.3};
    corners[2] = (sph2d_vec2){0.7, 0.1};
    corners[3] = (sph2d_vec2){0.5, 0.3};
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);
    ck_assert_msg(strstr(report.items[0].message, "cross") != NULL, "%s", report.items[0].message);
    sph2d_report_clear(&report);
    for (int k = 0; k < 4; ++k)
        corners[k] = (sph2d_vec2){0.5 + 0.07 * (k + 3 * (k == 1)), 0.1 + 0.03 * (k + 3 * (k == 1))};
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);
    ck_assert_msg(strstr(report.items[0].message, "on one line") != NULL, "%s", report.items[0].message);
}
END_TEST

/** What a scene has and what does nothing: said, not refused. A drain may extend beyond the domain, and an interaction
 *  enter from outside. */
START_TEST(what_does_nothing_is_warned_of)
{
    static sph2d_swing swings[2] = {{.amplitude = {0.01, 0}, .frequency = 1, .phase = -1.5708}, {.angle = 0.1}};
    scene.method = sph2d_scene_default().method;
    static const char *const says[] = {"obstacles[2].motion: has an amplitude or angle but no frequency",
                                       "obstacles[2].motion.swings[1]: has an amplitude",
                                       "warning[S105]: motion: has an amplitude", NULL, NULL};
    for (int k = 0; k < 5; ++k) {
        obstacles[2].motion.angle = k == 0 ? 0.1 : 0;
        obstacles[2].motion.swings = swings;
        obstacles[2].motion.swing_count = k == 1 ? 2 : 0;
        scene.motion.amplitude.x = k == 2 ? 0.1 : 0;
        drains[0].shape.box.max.x = k == 3 ? 1.5 : 0.3;
        path[0].x = k == 4 ? -0.5 : 0.1;
        sph2d_report_clear(&report);
        ck_assert_msg(sph2d_scene_check(&scene, &report) == SPH2D_OK, "%s", test_report_text(&report));
        ck_assert_msg(says[k] ? strstr(test_report_text(&report), says[k]) != NULL : report.count == 0, "case %d: %s",
                      k, test_report_text(&report));
    }
}
END_TEST

/** Cubics are no advice where the path is one. */
START_TEST(a_hint_on_a_jump_says_what_a_cubic_lacks)
{
    static const sph2d_pose_point way[3] = {{0, 0, 0, 0}, {0.2, -0.1, 0, 0}, {0.4, -0.2, 0, 0}};
    scene.method = sph2d_scene_default().method;
    for (int k = 0; k < 2; ++k) {
        obstacles[2].motion.path = (sph2d_pose_path){way, 3};
        obstacles[2].motion.between = k == 0 ? SPH2D_BETWEEN_CUBIC : SPH2D_BETWEEN_LINES;
        sph2d_report_clear(&report);
        ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_OK);
        const char *hint = report.items[0].hint;
        ck_assert_msg((strstr(hint, "`between: cubic`") != NULL) == (k == 1), "%s", hint);
        ck_assert_msg(strstr(hint, "three equal points") != NULL, "%s", hint);
    }
}
END_TEST

/** A natural cubic through 0.2 s of rest, 0.5 m in 0.4 s and rest: s = 6 (0.5/0.4)/(2 (0.2 + 0.4) - 0.4) = 9.375 m/s^2 at
 *  the inner points, and 0.2^2/6 s 2/(3 sqrt 3) = 24.06 mm beyond both ends. */
START_TEST(a_cubic_that_overshoots_is_warned_of)
{
    static sph2d_pose_point rests[4] = {{0, 0, 0, 0}, {0.2, 0, 0, 0}, {0.6, 0, 0, 0}, {0.8, 0, 0, 0}};
    static sph2d_pose_point close[8] = {{0, 0, 0, 0},   {0.18, 0, 0, 0}, {0.19, 0, 0, 0}, {0.2, 0, 0, 0},
                                        {0.6, 0, 0, 0}, {0.61, 0, 0, 0}, {0.62, 0, 0, 0}, {0.8, 0, 0, 0}};
    scene.method = sph2d_scene_default().method;
    obstacles[3].motion.between = SPH2D_BETWEEN_CUBIC;
    for (int k = 0; k < 4; ++k) {
        double x = k == 0 || k == 3 ? 0.5 : 0, angle = k == 1 ? 1 : 0;
        rests[2].x = rests[3].x = x;
        rests[2].angle = rests[3].angle = angle;
        for (int n = 4; n < 8; ++n)
            close[n].x = x;
        obstacles[3].motion.path = k == 3 ? (sph2d_pose_path){close, 8} : (sph2d_pose_path){rests, 4};
        sph2d_report_clear(&report);
        ck_assert_msg(sph2d_scene_check(&scene, &report) == SPH2D_OK, "%s", test_report_text(&report));
        const char *text = test_report_text(&report);
        const char *says = k == 0 ? "obstacles[3].motion: its cubic path goes 0.024 m beyond its points in x at t = 0."
                                  : "its cubic path goes 0.048 rad beyond its points in angle at t = 0.";
        ck_assert_msg(k < 2 ? strstr(text, says) != NULL : !strstr(text, "beyond"), "case %d: %s", k, text);
    }
}
END_TEST

/** What comes nearer to a wall than a spacing from farther away is warned of, by how much and when; what was as near at
 *  the start is not, and an opening is no wall. */
START_TEST(a_motion_that_squeezes_liquid_is_warned_of)
{
    static sph2d_pose_point way[3] = {{0.1, 0, 0, 0}, {0.6, 0, 0, 0}, {0.8, 0, 0, 0}};
    const struct {
        double x, y;
        const char *warned;       /* of this; NULL: of nothing */
    } cases[] = {{0.13, 0, NULL}, /* to 0.98, a spacing from the side */
                 {0.14, 0, "to 0.5 spacings from the right side of the domain at t = 0.6 s"},
                 {0.15, 0, "to 0 spacings from the right side of the domain at t = 0.6 s"},
                 {0, 0.11, "to 0.5 spacings from obstacles[1] at t = 0.6"},
                 {0, 0.1, NULL}};
    scene.method = sph2d_scene_default().method;
    obstacles[2].motion.path = (sph2d_pose_path){way, 3};
    obstacles[2].motion.between = SPH2D_BETWEEN_LINES;
    ends[0] = (sph2d_vec2){0.7, 0.77}; /* obstacles[0], a line above the circle */
    ends[1] = (sph2d_vec2){0.9, 0.77};
    obstacles[1] = obstacles[0];
    obstacles[0] = obstacles[3];
    obstacles[1].liquid = SPH2D_LIQUID_RIGHT;
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        way[1].x = way[2].x = cases[k].x;
        way[1].y = way[2].y = cases[k].y;
        ck_assert_msg(sph2d_scene_check(&scene, &report) == SPH2D_OK, "%s", test_report_text(&report));
        ck_assert_msg(report.count == (cases[k].warned != NULL), "case %zu: %s", k, test_report_text(&report));
        if (cases[k].warned)
            ck_assert_msg(strstr(report.items[0].message, cases[k].warned) != NULL, "%s", report.items[0].message);
        sph2d_report_clear(&report);
    }
    way[1].x = way[2].x = 0.15;
    way[1].y = way[2].y = 0;
    scene.boundary.right = SPH2D_SIDE_OPEN;
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_OK);
    ck_assert_msg(report.count == 0, "%s", test_report_text(&report));
}
END_TEST

START_TEST(probes_have_no_use_for_some_places)
{
    for (int k = 0; k <= SPH2D_PROBE_ERROR; ++k) {
        probes[1].kind = (sph2d_probe_kind)k;
        bool at_a_point = k == SPH2D_PROBE_SPEED || k == SPH2D_PROBE_PRESSURE;
        probes[1].at = (sph2d_vec2){0.2, -7}; /* no height is needed to find one */
        ck_assert_int_eq(sph2d_scene_check(&scene, NULL), at_a_point ? SPH2D_SCENE : SPH2D_OK);
        probes[1].at.x = -7;
        bool on_a_line = at_a_point || k == SPH2D_PROBE_ELEVATION;
        ck_assert_int_eq(sph2d_scene_check(&scene, NULL), on_a_line ? SPH2D_SCENE : SPH2D_OK);
    }
}
END_TEST

START_TEST(every_fault_is_found)
{
    faults[_i].make();
    ck_assert_msg(sph2d_scene_check(&scene, &report) == SPH2D_SCENE, "accepted: fault at %s", faults[_i].path);
    ck_assert_msg(test_report_has(&report, faults[_i].code, faults[_i].path), "wanted %s at %s, got\n%s",
                  sph2d_code_text(faults[_i].code), faults[_i].path, test_report_text(&report));
    ck_assert_int_eq(sph2d_scene_check(&scene, NULL), SPH2D_SCENE);
    for (size_t i = 0; i < report.count; ++i) {
        size_t length = strlen(report.items[i].message);
        ck_assert_uint_gt(length, 5); /* a sentence, without a full stop */
        ck_assert_int_ne(report.items[i].message[length - 1], '.');
    }
    /* The same fault stops a simulation, with nothing made. */
    sph2d_sim *sim = (sph2d_sim *)&scene;
    ck_assert_int_eq(sph2d_sim_create(&scene, NULL, &sim, NULL), SPH2D_SCENE);
    ck_assert_ptr_null(sim);
}
END_TEST

/** W(0) over the sum of W on a filled lattice, by the kernels' formulas, is above and below two thirds at these
 *  supports: of wendland_c2 78 and 65 %, of wendland_c4 74 and 63 %. */
START_TEST(pressure_solvers_need_neighbours)
{
    static const struct {
        sph2d_kernel kernel;
        double narrow, wide;
    } supports[] = {{SPH2D_KERNEL_WENDLAND_C2, 1.6, 1.8}, {SPH2D_KERNEL_WENDLAND_C4, 1.9, 2.1}};
    static const sph2d_method solvers[] = {SPH2D_METHOD_PCISPH, SPH2D_METHOD_CONSTRAINT, SPH2D_METHOD_WCSPH};
    for (size_t k = 0; k < sizeof solvers / sizeof *solvers; ++k) {
        scene.method = sph2d_scene_default().method;
        scene.method.name = solvers[k];
        scene.method.kernel = supports[_i].kernel;
        scene.method.support_ratio = supports[_i].wide;
        ck_assert_int_eq(sph2d_scene_check(&scene, NULL), SPH2D_OK);
        scene.method.support_ratio = supports[_i].narrow;
        bool refused = solvers[k] != SPH2D_METHOD_WCSPH;
        ck_assert_int_eq(sph2d_scene_check(&scene, &report), refused ? SPH2D_SCENE : SPH2D_OK);
        ck_assert_int_eq(test_report_has(&report, SPH2D_CODE_OUT_OF_RANGE, "method.support_ratio"), refused);
        sph2d_report_clear(&report);
    }
}
END_TEST

/** 1 m/s and spacings of 0.02 m: 100 times the viscosity of 0.2 Pa s. */
START_TEST(fitted_operators_take_no_wide_support_without_viscosity)
{
    scene.method = sph2d_scene_default().method;
    scene.method.operators = SPH2D_OPERATORS_FITTED;
    blocks[0].velocity = (sph2d_vec2){1, 0};
    sources[0].speed = 0.5;
    for (int wide = 0; wide < 2; ++wide)
        for (int thin = 0; thin < 2; ++thin) {
            scene.method.support_ratio = wide ? 3.1 : 3;
            scene.fluid.dynamic_viscosity = thin ? 0.19 : 0.21;
            sph2d_scene_check(&scene, &report); /* the scene has a free surface, which is another fault */
            ck_assert_int_eq(test_report_has(&report, SPH2D_CODE_OUT_OF_RANGE, "method.support_ratio"), wide && thin);
            sph2d_report_clear(&report);
        }
}
END_TEST

/** (1/0.95)^2 and (1/1.05)^2 are within 10 and 11 % of 1. */
START_TEST(stiff_blocks_start_near_rest_density)
{
    static const struct {
        sph2d_method method;
        double spacing; /* over that of the scene */
        bool refused;
    } cases[] = {{SPH2D_METHOD_WCSPH, 0.96, false},      {SPH2D_METHOD_WCSPH, 0.95, true},
                 {SPH2D_METHOD_WCSPH, 1.05, false},      {SPH2D_METHOD_WCSPH, 1.06, true},
                 {SPH2D_METHOD_CONSTRAINT, 0.96, false}, {SPH2D_METHOD_CONSTRAINT, 0.95, true},
                 {SPH2D_METHOD_PCISPH, 0.8, false},      {SPH2D_METHOD_MULLER, 0.1, false}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        scene.method = sph2d_scene_default().method;
        scene.method.name = cases[k].method;
        blocks[1].spacing = cases[k].spacing * scene.spacing;
        ck_assert_int_eq(sph2d_scene_check(&scene, &report), cases[k].refused ? SPH2D_SCENE : SPH2D_OK);
        ck_assert_int_eq(test_report_has(&report, SPH2D_CODE_OUT_OF_RANGE, "blocks[1].spacing"), cases[k].refused);
        sph2d_report_clear(&report);
    }
}
END_TEST

START_TEST(all_faults_are_found_at_once)
{
    static void (*const some[])(void) = {block_outside, polygon_of_two, source_too_rich,          drain_shapeless,
                                         line_of_one,   circle_outside, interaction_back_in_time, probe_twice,
                                         deflate_level};
    size_t count = sizeof some / sizeof some[0];
    for (size_t k = 0; k < count; ++k)
        some[k]();
    scene.wall_damping = 2;
    scene.fluid.density = NAN;
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);
    ck_assert_uint_ge(report.errors, count + 2);
    for (size_t k = 0; k < count; ++k)
        for (int i = 0; i < FAULTS; ++i)
            if (faults[i].make == some[k])
                ck_assert_msg(test_report_has(&report, faults[i].code, faults[i].path), "%s", faults[i].path);
    ck_assert(test_report_has(&report, SPH2D_CODE_OUT_OF_RANGE, "wall_damping"));
    ck_assert(test_report_has(&report, SPH2D_CODE_OUT_OF_RANGE, "fluid.density"));
}
END_TEST

START_TEST(more_faults_than_a_report_holds_are_counted)
{
    static sph2d_block many[50];
    for (int i = 0; i < 50; ++i)
        many[i] = sph2d_block_default(); /* without a shape */
    scene.blocks = many;
    scene.block_count = 50;
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);
    ck_assert_uint_eq(report.count, 20);
    ck_assert_uint_eq(report.dropped, 30);
    ck_assert_uint_eq(report.errors, 50);
    ck_assert_str_eq(report.items[19].path, "blocks[19]");
}
END_TEST

START_TEST(nothing_gives_the_sound_speed)
{
    scene.gravity = (sph2d_vec2){0, 0};
    scene.source_count = scene.interaction_count = scene.absorber_count = 0;
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);
    ck_assert(test_report_has(&report, SPH2D_CODE_MISSING_KEY, "method.stiffness"));
    scene.method.stiffness = 1;
    ck_assert_int_eq(sph2d_scene_check(&scene, NULL), SPH2D_OK);
    scene.method.stiffness = 0;
    blocks[0].velocity.x = 1;
    ck_assert_int_eq(sph2d_scene_check(&scene, NULL), SPH2D_OK);
}
END_TEST

START_TEST(a_scene_that_was_not_made_is_refused)
{
    ck_assert_int_eq(sph2d_scene_check(NULL, &report), SPH2D_INVALID);
    for (int k = 0; k < 3; ++k) {
        memset(&scene, k == 0 ? 0 : k == 1 ? 0xff : 0xa5, sizeof scene);
        sph2d_report_clear(&report);
        ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);
        ck_assert_uint_eq(report.errors, 1);
        ck_assert_ptr_nonnull(strstr(report.items[0].message, "sph2d_scene_default"));
    }
}
END_TEST

START_TEST(a_scene_without_a_name_is_no_crash)
{
    scene.name = NULL;
    sph2d_sim *sim = NULL;
    sph2d_status status = sph2d_sim_create(&scene, NULL, &sim, &report);
    ck_assert(status == SPH2D_OK || status == SPH2D_SCENE);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_scene_check(void)
{
    Suite *suite = suite_create("scene_check");
    TCase *tests = tcase_create("faults");
    tcase_add_checked_fixture(tests, start, NULL);
    tcase_add_test(tests, the_sound_scene_is_sound);
    tcase_add_test(tests, a_warning_does_not_refuse);
    tcase_add_test(tests, a_sound_speed_too_low_for_the_depth_is_warned_of);
    tcase_add_test(tests, a_driven_flow_has_no_depth);
    tcase_add_test(tests, what_a_method_computes_badly_is_warned_of);
    tcase_add_test(tests, thick_liquid_that_slides_is_warned_of);
    tcase_add_test(tests, a_blow_of_a_wall_is_warned_of);
    tcase_add_test(tests, a_wall_that_slides_along_itself_blows_at_nothing);
    tcase_add_test(tests, a_bow_tie_is_told_that_it_crosses_itself);
    tcase_add_test(tests, what_does_nothing_is_warned_of);
    tcase_add_test(tests, a_hint_on_a_jump_says_what_a_cubic_lacks);
    tcase_add_test(tests, a_cubic_that_overshoots_is_warned_of);
    tcase_add_test(tests, a_motion_that_squeezes_liquid_is_warned_of);
    tcase_add_test(tests, probes_have_no_use_for_some_places);
    tcase_add_loop_test(tests, every_fault_is_found, 0, FAULTS);
    tcase_add_loop_test(tests, pressure_solvers_need_neighbours, 0, 2);
    tcase_add_test(tests, fitted_operators_take_no_wide_support_without_viscosity);
    tcase_add_test(tests, stiff_blocks_start_near_rest_density);
    tcase_add_test(tests, all_faults_are_found_at_once);
    tcase_add_test(tests, more_faults_than_a_report_holds_are_counted);
    tcase_add_test(tests, nothing_gives_the_sound_speed);
    tcase_add_test(tests, a_scene_that_was_not_made_is_refused);
    tcase_add_test(tests, a_scene_without_a_name_is_no_crash);
    suite_add_tcase(suite, tests);
    return suite;
}
