/* SPDX-License-Identifier: MIT */
/** @file test_tunnelling.c
 *  Nothing passes a wall one particle thick: jets at 10 sqrt(g H), H = 0.3 m, from five angles onto lines, corners, a
 *  circle, a box, a knife edge and into a bowl, heavy and reflecting, with adaptive steps and with the largest fixed
 *  step that the guards allow. Counted by place (the far side of a wall that closes it off) and by way (no particle's
 *  step crosses it). */
#include <math.h>
#include <string.h>

#include "common.h"
#include "sim/simulation.h"

enum { LINE, SLANTED, CORNER, CIRCLE, BOX, KNIFE, BOWL, TARGETS };
enum { ANGLES = 5, MOST = 4000 };

static const double DX = 0.02, G = 9.81, END = 0.06;
static const sph2d_circle CIRCLE_AT = {{0.5, 0.3}, 0.15};
static const sph2d_box BOX_AT = {{0.35, 0.1}, {0.65, 0.4}};
static const sph2d_arc BOWL_AT = {{0.5, 0.6}, 0.5, TEST_PI, 2 * TEST_PI}; /* from side to side */

/** The points of the open targets; the first three reach from side to side. */
static const sph2d_vec2 points[TARGETS][3] = {
    [LINE] = {{0, 0.3}, {1, 0.3}},
    [SLANTED] = {{0, 0.2}, {1, 0.45}},
    [CORNER] = {{0, 0.6}, {0.5, 0.15}, {1, 0.6}},
    [KNIFE] = {{0.5, 0}, {0.5, 0.4}},
};
static const size_t counts[TARGETS] = {[LINE] = 2, [SLANTED] = 2, [CORNER] = 3, [KNIFE] = 2};

/** Where the jets aim: on the line, the corner, the circle's top, the box's upper edge, the knife's tip. */
static const sph2d_vec2 aims[TARGETS] = {
    [LINE] = {0.5, 0.3}, [SLANTED] = {0.5, 0.325}, [CORNER] = {0.5, 0.15}, [CIRCLE] = {0.5, 0.45},
    [BOX] = {0.45, 0.4}, [KNIFE] = {0.5, 0.4},     [BOWL] = {0.5, 0.1},
};

static sph2d_shape outline_of(int target)
{
    sph2d_shape outline = {0};
    switch (target) {
    case CIRCLE:
        outline.kind = SPH2D_SHAPE_CIRCLE;
        outline.circle = CIRCLE_AT;
        break;
    case BOX:
        outline.kind = SPH2D_SHAPE_BOX;
        outline.box = BOX_AT;
        break;
    case BOWL:
        outline.kind = SPH2D_SHAPE_ARC;
        outline.arc = BOWL_AT;
        break;
    case CORNER:
        outline.kind = SPH2D_SHAPE_POLYLINE;
        outline.points = (sph2d_points){points[target], counts[target]};
        break;
    default:
        outline.kind = SPH2D_SHAPE_LINE;
        outline.points = (sph2d_points){points[target], counts[target]};
    }
    return outline;
}

static double jet_speed(void)
{
    return 10 * sqrt(G * 0.3);
}

/** A jet five particles wide onto a target, at most 60 degrees off the vertical; step 0 is adaptive. */
static sph2d_sim *jet(int target, sph2d_wall_form form, int angle, double step, sph2d_report *report)
{
    static const double degrees[ANGLES] = {0, 25, -40, 60, -55};
    double a = degrees[angle] * TEST_PI / 180, steep = target == CORNER ? 0.3 : target == BOWL ? 0.5 : 1;
    sph2d_scene scene = sph2d_scene_default();
    scene.method.name = SPH2D_METHOD_MULLER;
    scene.domain = (sph2d_box){{0, 0}, {1, 1}};
    scene.spacing = DX;
    scene.method.time_step = step;
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    obstacle.shape = outline_of(target);
    obstacle.form = form;
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    sph2d_source source = sph2d_source_default();
    source.direction = (sph2d_vec2){sin(steep * a), -cos(steep * a)};
    source.at = (sph2d_vec2){aims[target].x - 0.4 * source.direction.x, aims[target].y - 0.4 * source.direction.y};
    source.speed = jet_speed();
    source.width = 5 * DX;
    source.spread = 0.02;
    scene.sources = &source;
    scene.source_count = 1;
    sph2d_sim *sim = NULL;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    ck_assert_int_eq(sph2d_sim_create(&scene, &options, &sim, report), SPH2D_OK);
    return sim;
}

static double turn(sph2d_vec2 a, sph2d_vec2 b, sph2d_vec2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/** Whether a place is on the side that no particle can reach. */
static bool on_far_side(int target, sph2d_vec2 p)
{
    const sph2d_vec2 *w = points[target];
    switch (target) {
    case CIRCLE: /* inside the polygon of pieces no longer than a spacing that stands for it */
        return hypot(p.x - CIRCLE_AT.center.x, p.y - CIRCLE_AT.center.y) < sqrt(pow(CIRCLE_AT.radius, 2) - DX * DX / 4);
    case BOX:
        return p.x > BOX_AT.min.x && p.x < BOX_AT.max.x && p.y > BOX_AT.min.y && p.y < BOX_AT.max.y;
    case CORNER:
        return turn(w[0], w[1], p) < 0 || turn(w[1], w[2], p) < 0;
    case BOWL:
        return p.y < BOWL_AT.center.y && hypot(p.x - BOWL_AT.center.x, p.y - BOWL_AT.center.y) > BOWL_AT.radius;
    case KNIFE:
        return p.y < 0;
    default:
        return turn(w[0], w[1], p) < 0;
    }
}

/** Whether a straight way crosses a target's line; circles, boxes and bowls are told by place alone. */
static bool crosses(int target, sph2d_vec2 p, sph2d_vec2 q)
{
    for (size_t i = 0; i + 1 < counts[target]; ++i) {
        sph2d_vec2 a = points[target][i], b = points[target][i + 1];
        if (turn(a, b, p) * turn(a, b, q) < 0 && turn(p, q, a) * turn(p, q, b) < 0)
            return true;
    }
    return false;
}

/** Runs a jet to its end or to a guard; counts the particles that crossed or are on the far side at any step. */
static size_t passed(sph2d_sim *sim, int target, sph2d_report *report, sph2d_status *status)
{
    static sph2d_vec2 last[MOST];
    static bool known[MOST];
    memset(known, 0, sizeof known);
    size_t count = 0;
    *status = SPH2D_OK;
    while (sph2d_sim_time(sim) < END && *status == SPH2D_OK) {
        *status = sph2d_sim_step(sim, report);
        sph2d_view f = sph2d_sim_fluid(sim);
        for (size_t i = 0; i < f.count; ++i) {
            sph2d_vec2 p = {f.x[i], f.y[i]};
            uint64_t id = f.id[i];
            if (id >= MOST || !isfinite(p.x + p.y))
                return SIZE_MAX;
            count += on_far_side(target, p) || (known[id] && crosses(target, last[id], p));
            last[id] = p;
            known[id] = true;
        }
    }
    return count;
}

static sph2d_wall_form form_of(int index)
{
    return index % 2 ? SPH2D_WALL_REFLECT : SPH2D_WALL_HEAVY;
}

START_TEST(nothing_passes_with_adaptive_steps)
{
    int target = _i / 2;
    for (int angle = 0; angle < ANGLES; ++angle) {
        static sph2d_report report;
        sph2d_status status;
        sph2d_sim *sim = jet(target, form_of(_i), angle, 0, &report);
        size_t count = passed(sim, target, &report, &status);
        ck_assert_msg(status == SPH2D_OK, "%s", test_report_text(&report));
        ck_assert_msg(count == 0, "angle %d: %zu passed", angle, count);
        sph2d_summary sum = sph2d_sim_summary(sim);
        ck_assert_uint_gt(sum.fed, 200);
        ck_assert_double_gt(sum.speed_max, 0.3 * jet_speed()); /* still violent */
        sph2d_sim_destroy(sim);
    }
}
END_TEST

START_TEST(nothing_passes_with_the_largest_fixed_step)
{
    /* From the longest step that the guard lets a jet take down to the first that runs through: whatever a guard stops
     * has let nothing pass before, nor in the step that was stopped. */
    int target = _i / 2;
    for (int angle = 0; angle < ANGLES; ++angle) {
        sph2d_status status = SPH2D_GUARD;
        double step = 0.95 * 2 * DX / jet_speed();
        for (int trial = 0; status != SPH2D_OK; ++trial) {
            static sph2d_report report;
            sph2d_report_clear(&report);
            sph2d_sim *sim = jet(target, form_of(_i), angle, step, &report);
            size_t count = passed(sim, target, &report, &status);
            ck_assert_msg(count == 0, "angle %d, step %g s: %zu passed", angle, step, count);
            ck_assert_int_lt(trial, 20);
            step *= 0.8;
            sph2d_sim_destroy(sim);
        }
    }
}
END_TEST

START_TEST(a_nozzle_close_to_a_wall_does_not_feed_through_it)
{
    /* A row has been under way since it was due: in one step nearly two spacings, but the wall is 0.9 of one away. */
    const double speed = 10, step = 0.95 * 2 * DX / speed;
    sph2d_scene scene = test_scene(DX, 0, 0, 1, 1);
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    obstacle.shape = outline_of(LINE);
    obstacle.form = form_of(_i);
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){0.5, 0.3 + 0.9 * DX};
    source.speed = speed;
    source.width = 3 * DX;
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    scene.sources = &source;
    scene.source_count = 1;
    scene.method.time_step = step;
    scene.method.sound_speed = 1; /* so soft that the step is a stable one */
    sph2d_sim *sim = test_create(&scene, NULL);
    static sph2d_report report;
    size_t through = 0;
    for (int n = 0; n < 40; ++n) {
        sph2d_sim_step(sim, &report); /* a guard may stop it */
        sph2d_view f = sph2d_sim_fluid(sim);
        for (size_t i = 0; i < f.count; ++i)
            through += f.y[i] < 0.3;
    }
    ck_assert_msg(through == 0, "%zu times a particle was on the far side", through);
    sph2d_sim_destroy(sim);
}
END_TEST

/** A line that sweeps at 30 m/s through a particle at rest takes it along, in both methods. What it did is counted. */
START_TEST(a_wall_that_moves_takes_what_rests_along)
{
    static const sph2d_vec2 line[2] = {{0.4, 0.9}, {0.4, 0.1}};
    static const sph2d_pose_point way[2] = {{0, 0, 0, 0}, {0.03, 0.9, 0, 0}};
    sph2d_scene scene = test_open_scene(DX, 0, 0, 2, 1);
    if (_i == 1) {
        scene.method = sph2d_scene_default().method;
        scene.method.name = SPH2D_METHOD_PCISPH;
    }
    sph2d_block particle = test_particle(DX, 0.5, 0.5, 0, 0);
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    obstacle.shape.kind = SPH2D_SHAPE_LINE;
    obstacle.shape.points = (sph2d_points){line, 2};
    obstacle.form = _i == 1 ? SPH2D_WALL_DEFAULT : SPH2D_WALL_REFLECT;
    obstacle.motion.path = (sph2d_pose_path){way, 2};
    scene.blocks = &particle;
    scene.block_count = 1;
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    while (sph2d_sim_time(sim) < 0.03) {
        test_steps(sim, 1);
        double wall = 0.4 + 30 * fmin(sph2d_sim_time(sim), 0.03), x = sph2d_sim_fluid(sim).x[0];
        ck_assert_msg(x >= fmin(0.5, wall), "wall at %g, particle at %g", wall, x);
    }
    sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert_uint_gt(s.backstop_hits + s.reflections, 0);
    ck_assert_uint_le(s.backstop_hits, s.steps * 4);
    ck_assert_uint_le(s.reflections, s.steps * 4);
    sph2d_sim_destroy(sim);
}
END_TEST

/** A blade that turns at 200 rad/s in a pool: no particle is ever in it, by any method or form of wall. */
START_TEST(nothing_gets_into_a_blade_that_turns)
{
    static const struct {
        sph2d_method method;
        sph2d_wall_form form;
    } kinds[] = {{SPH2D_METHOD_WCSPH, SPH2D_WALL_GENERALISED},
                 {SPH2D_METHOD_MULLER, SPH2D_WALL_HEAVY},
                 {SPH2D_METHOD_PCISPH, SPH2D_WALL_GENERALISED},
                 {SPH2D_METHOD_CONSTRAINT, SPH2D_WALL_GENERALISED}};
    sph2d_scene scene = test_scene(0.02, 0, 0, 1, 1);
    scene.method = sph2d_scene_default().method;
    scene.method.name = kinds[_i].method;
    scene.gravity = (sph2d_vec2){0, -9.81};
    scene.boundary.top = SPH2D_SIDE_OPEN;
    sph2d_block pool = test_block(0, 0, 1, 0.4);
    sph2d_obstacle blade = sph2d_obstacle_default();
    blade.form = kinds[_i].form;
    blade.shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.3, 0.2}, {0.7, 0.28}}};
    blade.motion.rate = 200;
    blade.motion.ramp = 0.02;
    scene.blocks = &pool;
    scene.block_count = 1;
    scene.obstacles = &blade;
    scene.obstacle_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_report report = {0};
    size_t inside = 0, steps = 0;
    while (steps < 300 && sph2d_sim_step(sim, &report) == SPH2D_OK) { /* a guard may stop it: 45 m/s at its ends */
        sph2d_view f = sph2d_sim_fluid(sim);
        double angle = sim->moving[0].to.angle, c = cos(angle), s = sin(angle);
        for (size_t i = 0; i < f.count; ++i) {
            double x = f.x[i] - 0.5, y = f.y[i] - 0.24;
            inside += fabs(c * x + s * y) < 0.2 && fabs(c * y - s * x) < 0.04;
        }
        ++steps;
    }
    sph2d_report_clear(&report);
    ck_assert_uint_gt(steps, 20);
    ck_assert_double_gt(sim->moving[0].to.angle, 0.2);
    ck_assert_msg(inside == 0, "%zu times a particle was inside in %zu steps", inside, steps);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_tunnelling(void)
{
    Suite *suite = suite_create("tunnelling");
    TCase *tests = tcase_create("jets");
    tcase_add_loop_test(tests, a_nozzle_close_to_a_wall_does_not_feed_through_it, 0, 2);
    tcase_add_loop_test(tests, a_wall_that_moves_takes_what_rests_along, 0, 2);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_loop_test(slow, nothing_passes_with_adaptive_steps, 0, 2 * TARGETS);
    tcase_add_loop_test(slow, nothing_passes_with_the_largest_fixed_step, 0, 2 * TARGETS);
    tcase_add_loop_test(slow, nothing_gets_into_a_blade_that_turns, 0, 4);
    return suite;
}
