/* SPDX-License-Identifier: MIT */
/** @file test_outlines.c
 *  The outlines of walls and bodies: sides that meet are one, the liquid is where they say, and they move along. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "sph2d/field.h"

static sph2d_scene scene;
static sph2d_block block;

static void set_tank(void)
{
    scene = test_scene(0.05, 0, 0, 2, 1);
    scene.method = sph2d_scene_default().method;
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.gravity = (sph2d_vec2){0, -9.81};
    scene.boundary = (sph2d_boundary){
        .left = SPH2D_SIDE_WALL, .right = SPH2D_SIDE_WALL, .bottom = SPH2D_SIDE_WALL, .top = SPH2D_SIDE_OPEN};
    block = test_block(0.1, 0.1, 0.9, 0.5);
    scene.blocks = &block;
    scene.block_count = 1;
}

/** The outlines of a simulation. */
typedef struct outlines {
    size_t count;
    const double *x, *y;
    const uint64_t *id, *liquid;
} outlines;

static outlines outlines_of(const sph2d_sim *sim)
{
    const sph2d_array at = sph2d_field(sim, SPH2D_GROUP_OUTLINE, 0), id = sph2d_field(sim, SPH2D_GROUP_OUTLINE, 1),
                      liquid = sph2d_field(sim, SPH2D_GROUP_OUTLINE, 2);
    ck_assert_str_eq(at.name, "Coordinates");
    ck_assert_str_eq(id.name, "OutlineIDs");
    ck_assert_str_eq(liquid.name, "LiquidSides");
    ck_assert_str_eq(sph2d_field(sim, SPH2D_GROUP_OUTLINE, 3).name, "WallIDs");
    ck_assert_uint_eq(sph2d_field(sim, SPH2D_GROUP_OUTLINE, 3).count, at.count);
    ck_assert_uint_eq(id.count, at.count);
    ck_assert_uint_eq(liquid.count, at.count);
    return (outlines){at.count, at.data[0], at.data[1], id.data[0], liquid.data[0]};
}

static void check_corners(const outlines *o, size_t first, const double (*corners)[2], size_t count, uint64_t id,
                          uint64_t liquid)
{
    ck_assert_uint_ge(o->count, first + count);
    for (size_t k = 0; k < count; ++k) {
        ck_assert_double_eq_tol(o->x[first + k], corners[k][0], 1e-12);
        ck_assert_double_eq_tol(o->y[first + k], corners[k][1], 1e-12);
        ck_assert_uint_eq(o->id[first + k], id);
        ck_assert_uint_eq(o->liquid[first + k], liquid);
    }
}

/** Three walls are one chain from the open side round to it; four are closed; two that do not meet are two. */
START_TEST(sides_that_meet_are_one)
{
    static const double open[4][2] = {{0, 1}, {0, 0}, {2, 0}, {2, 1}};
    static const double closed[5][2] = {{0, 0}, {2, 0}, {2, 1}, {0, 1}, {0, 0}};
    static const double bottom[2][2] = {{0, 0}, {2, 0}}, top[2][2] = {{2, 1}, {0, 1}};
    set_tank();
    sph2d_sim *sim = test_create(&scene, NULL);
    outlines o = outlines_of(sim);
    ck_assert_uint_eq(o.count, 4);
    check_corners(&o, 0, open, 4, 0, SPH2D_OUTLINE_LIQUID_LEFT);
    sph2d_sim_destroy(sim);
    scene.boundary.top = SPH2D_SIDE_WALL;
    sim = test_create(&scene, NULL);
    o = outlines_of(sim);
    ck_assert_uint_eq(o.count, 5);
    check_corners(&o, 0, closed, 5, 0, SPH2D_OUTLINE_LIQUID_LEFT);
    sph2d_sim_destroy(sim);
    scene.boundary.left = scene.boundary.right = SPH2D_SIDE_PERIODIC;
    sim = test_create(&scene, NULL);
    o = outlines_of(sim);
    ck_assert_uint_eq(o.count, 4);
    check_corners(&o, 0, bottom, 2, 0, SPH2D_OUTLINE_LIQUID_LEFT);
    check_corners(&o, 2, top, 2, 1, SPH2D_OUTLINE_LIQUID_LEFT);
    sph2d_sim_destroy(sim);
}
END_TEST

/** A ramp has its liquid on the left, whichever way it was drawn; by `muller`, whose lines have no layers, on both sides. */
START_TEST(lines_know_where_liquid_is)
{
    set_tank();
    sph2d_vec2 ramp[2] = {{1.2, 0.4}, {1.8, 0.2}};
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    obstacle.shape = (sph2d_shape){.kind = SPH2D_SHAPE_LINE, .points = {ramp, 2}};
    obstacle.liquid = _i ? SPH2D_LIQUID_AUTO : SPH2D_LIQUID_RIGHT;
    scene.method.name = _i ? SPH2D_METHOD_MULLER : SPH2D_METHOD_PCISPH;
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    const outlines o = outlines_of(sim);
    static const double back[2][2] = {{1.8, 0.2}, {1.2, 0.4}}, forth[2][2] = {{1.2, 0.4}, {1.8, 0.2}};
    ck_assert_uint_eq(o.count, 6);
    check_corners(&o, 4, _i ? forth : back, 2, 1, _i ? SPH2D_OUTLINE_LIQUID_BOTH : SPH2D_OUTLINE_LIQUID_LEFT);
    sph2d_sim_destroy(sim);
}
END_TEST

/** A box that turns, and one that falls, are where their poses say. */
START_TEST(outlines_move_along)
{
    set_tank();
    sph2d_obstacle wheel = sph2d_obstacle_default();
    wheel.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{1.3, 0.5}, {1.7, 0.7}}};
    wheel.motion.rate = 3;
    sph2d_body falling = sph2d_body_default();
    falling.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.3, 0.7}, {0.6, 0.9}}};
    falling.density = 500;
    scene.obstacles = &wheel;
    scene.obstacle_count = 1;
    scene.bodies = &falling;
    scene.body_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    test_steps(sim, 100);
    const outlines o = outlines_of(sim);
    ck_assert_uint_eq(o.count, 4 + 4 + 4);
    const uint64_t *walls = sph2d_field(sim, SPH2D_GROUP_OUTLINE, 3).data[0];
    for (size_t k = 0; k < o.count; ++k) /* a side, the obstacle, the body */
        ck_assert_uint_eq(walls[k], k < 4 ? UINT64_MAX : k < 8 ? 0 : 1);
    const double angle = 3 * sph2d_sim_time(sim), c = cos(angle), s = sin(angle);
    const double turned[4][2] = {{1.5 - 0.2 * c + 0.1 * s, 0.6 - 0.2 * s - 0.1 * c},
                                 {1.5 + 0.2 * c + 0.1 * s, 0.6 + 0.2 * s - 0.1 * c},
                                 {1.5 + 0.2 * c - 0.1 * s, 0.6 + 0.2 * s + 0.1 * c},
                                 {1.5 - 0.2 * c - 0.1 * s, 0.6 - 0.2 * s + 0.1 * c}};
    check_corners(&o, 4, turned, 4, 1, SPH2D_OUTLINE_LIQUID_OUTSIDE);
    const sph2d_body_state body = sph2d_sim_body(sim, 0);
    ck_assert_double_lt(body.center.y, 0.8);
    double x = 0, y = 0;
    for (size_t k = 8; k < 12; ++k) {
        ck_assert_uint_eq(o.liquid[k], SPH2D_OUTLINE_LIQUID_OUTSIDE);
        x += o.x[k] / 4;
        y += o.y[k] / 4;
    }
    ck_assert_double_eq_tol(x, body.center.x, 1e-12);
    ck_assert_double_eq_tol(y, body.center.y, 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Beside an opening the side is solid, and where it lets liquid in nothing is drawn. */
START_TEST(openings_are_open)
{
    set_tank();
    block = test_block(0, 0, 2, 1);
    scene.gravity = (sph2d_vec2){0, 0};
    scene.boundary = (sph2d_boundary){
        .left = SPH2D_SIDE_WALL, .right = SPH2D_SIDE_WALL, .bottom = SPH2D_SIDE_WALL, .top = SPH2D_SIDE_WALL};
    sph2d_opening openings[2] = {sph2d_opening_default(), sph2d_opening_default()};
    openings[0].name = "in";
    openings[0].side = SPH2D_SIDE_NAME_LEFT;
    openings[0].from = 0.4;
    openings[0].to = 1;
    openings[0].velocity = 0.5;
    openings[1].name = "out";
    openings[1].side = SPH2D_SIDE_NAME_RIGHT;
    openings[1].pressure = 0;
    scene.openings = openings;
    scene.opening_count = 2;
    sph2d_sim *sim = test_create(&scene, NULL);
    const outlines o = outlines_of(sim);
    for (size_t k = 0; k < o.count; ++k) {
        const bool in = fabs(o.x[k]) < 1e-9 && o.y[k] > 0.4 + 1e-9 && o.y[k] < 1 - 1e-9;
        ck_assert(!in);
    }
    bool step = false; /* the corner of the solid below the inlet */
    for (size_t k = 0; k < o.count; ++k)
        step |= o.liquid[k] == SPH2D_OUTLINE_LIQUID_OUTSIDE && fabs(o.x[k]) < 1e-9 && fabs(o.y[k] - 0.4) < 1e-9;
    ck_assert(step);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Solids beside openings are no obstacles: what follows them in the list of walls keeps its number. */
START_TEST(bodies_are_numbered_behind_obstacles)
{
    set_tank();
    sph2d_opening in = sph2d_opening_default();
    in.side = SPH2D_SIDE_NAME_LEFT;
    in.from = 0.3;
    in.to = 0.6;
    in.velocity = 0.1;
    scene.openings = &in;
    scene.opening_count = 1;
    block = test_block(0, 0, 1, 0.7);
    sph2d_obstacle post = sph2d_obstacle_default();
    post.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{1.7, 0}, {1.9, 0.2}}};
    sph2d_body raft = sph2d_body_default();
    raft.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{1.2, 0.7}, {1.5, 0.9}}};
    raft.density = 500;
    scene.obstacles = &post;
    scene.obstacle_count = 1;
    scene.bodies = &raft;
    scene.body_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    test_steps(sim, 20);
    const outlines o = outlines_of(sim);
    const uint64_t *walls = sph2d_field(sim, SPH2D_GROUP_OUTLINE, 3).data[0];
    for (size_t k = 0; k < o.count; ++k) {
        const bool is_post = o.x[k] > 1.6 && o.x[k] < 1.95 && o.y[k]<0.25, is_raft = o.x[k]> 1.15 && o.x[k] < 1.55;
        ck_assert_uint_eq(walls[k], is_post ? 0 : is_raft ? 1 : UINT64_MAX);
        if (is_raft) /* it falls */
            ck_assert_double_lt(o.y[k], o.y[k] > 0.8 ? 0.9 : 0.7);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_outlines(void)
{
    Suite *suite = suite_create("outlines");
    TCase *cases = tcase_create("outlines");
    tcase_add_test(cases, sides_that_meet_are_one);
    tcase_add_loop_test(cases, lines_know_where_liquid_is, 0, 2);
    tcase_add_test(cases, outlines_move_along);
    tcase_add_test(cases, openings_are_open);
    tcase_add_test(cases, bodies_are_numbered_behind_obstacles);
    suite_add_tcase(suite, cases);
    return suite;
}
