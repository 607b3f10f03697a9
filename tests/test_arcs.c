/* SPDX-License-Identifier: MIT */
/** @file test_arcs.c
 *  Arcs as outlines of obstacles: their geometry, layers on either side, bowls that hold water, arcs that turn, and
 *  what is refused. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "scene/derive.h"
#include "scene/liquid.h"
#include "scene/shape.h"
#include "sim/simulation.h"

static const double DX = 0.02;

static sph2d_scene scene;
static sph2d_block block;
static sph2d_obstacle obstacles[2];
static sph2d_probe probes[2];
static sph2d_report report;

/* ---- geometry ---------------------------------------------------------------------------------------------------- */

static const sph2d_arc arcs[] = {
    {{0.3, -0.2}, 0.5, 0.4, 1.1},   {{0, 0}, 1, -0.7, 0.7}, {{1, 2}, 0.25, 2, 6},
    {{0.5, 0.5}, 0.4, -9.5, -7.5},  {{0, 0}, 0.02, 1, 4},   {{-1, 3}, 2, TEST_PI, 2 * TEST_PI},
    {{0.1, 0.2}, 0.3, 20.0, 26.28},
};
enum { ARCS = sizeof arcs / sizeof *arcs, SAMPLES = 4000 };

static sph2d_vec2 point_of(const sph2d_arc *arc, double part)
{
    double angle = arc->from + part * (arc->to - arc->from);
    return (sph2d_vec2){arc->center.x + arc->radius * cos(angle), arc->center.y + arc->radius * sin(angle)};
}

/** Pieces follow on each other from end to end, none longer than a spacing, and within the bulge of the arc. */
START_TEST(pieces_of_an_arc)
{
    const sph2d_arc *arc = &arcs[_i];
    const sph2d_shape outline = {.kind = SPH2D_SHAPE_ARC, .arc = *arc};
    size_t pieces = sph2d__shape_pieces(&outline, DX);
    sph2d_vec2 at = point_of(arc, 0), last = point_of(arc, 1);
    double bulge = sph2d__arc_bulge(arc, DX);
    ck_assert_double_le(bulge, 0.08 * arc->radius);
    for (size_t k = 0; k < pieces; ++k) {
        sph2d__segment s = sph2d__shape_piece(&outline, DX, k);
        double x = (s.a.x + s.b.x) / 2 - arc->center.x, y = (s.a.y + s.b.y) / 2 - arc->center.y;
        ck_assert_double_le(hypot(s.a.x - at.x, s.a.y - at.y), 1e-14);
        ck_assert_double_le(hypot(s.b.x - s.a.x, s.b.y - s.a.y), DX);
        ck_assert_double_eq_tol(arc->radius - hypot(x, y), bulge, 1e-14);
        ck_assert_double_gt(sph2d__segment_side(&s, arc->center), 0);
        at = s.b;
    }
    ck_assert_double_le(hypot(last.x - at.x, last.y - at.y), 1e-14);
    ck_assert(sph2d__shape_is_open(&outline) && !sph2d__shape_contains(&outline, arc->center));
}
END_TEST

/** Bounds, centroid, distances and sides against samples of the arc. */
START_TEST(measures_of_an_arc)
{
    const sph2d_arc *arc = &arcs[_i];
    const sph2d_shape outline = {.kind = SPH2D_SHAPE_ARC, .arc = *arc};
    sph2d_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}}, bounds = sph2d__arc_bounds(arc);
    sph2d_vec2 mean = {0, 0}, centroid = sph2d_shape_centroid(&outline);
    const double r = arc->radius, fine = 1e-5 * r;
    uint64_t random = 7;
    for (int k = 0; k <= SAMPLES; ++k) {
        sph2d_vec2 p = point_of(arc, (double)k / SAMPLES), q = point_of(arc, (k + 0.5) / SAMPLES);
        box = (sph2d_box){{fmin(box.min.x, p.x), fmin(box.min.y, p.y)}, {fmax(box.max.x, p.x), fmax(box.max.y, p.y)}};
        mean.x += k < SAMPLES ? q.x / SAMPLES : 0;
        mean.y += k < SAMPLES ? q.y / SAMPLES : 0;
    }
    ck_assert(fabs(box.min.x - bounds.min.x) < fine && fabs(box.min.y - bounds.min.y) < fine);
    ck_assert(fabs(box.max.x - bounds.max.x) < fine && fabs(box.max.y - bounds.max.y) < fine);
    ck_assert(fabs(mean.x - centroid.x) < fine && fabs(mean.y - centroid.y) < fine);
    for (int n = 0; n < 200; ++n) {
        sph2d_vec2 p = {arc->center.x + test_random(&random, -2 * r, 2 * r),
                        arc->center.y + test_random(&random, -2 * r, 2 * r)};
        double least = INFINITY, most = 0, side = 0, distance = sph2d__arc_distance(arc, p, &side);
        for (int k = 0; k <= SAMPLES; ++k) {
            sph2d_vec2 q = point_of(arc, (double)k / SAMPLES);
            least = fmin(least, hypot(p.x - q.x, p.y - q.y));
            most = fmax(most, hypot(p.x - q.x, p.y - q.y));
        }
        ck_assert_double_eq_tol(distance, least, 2e-3 * r);
        ck_assert_double_eq_tol(sph2d__shape_distance(&outline, p), most, fine);
    }
}
END_TEST

/** Its centre is on its left. Beyond an end the tangent there divides the sides. */
/** The bounds of arcs of any angles are those of their points, r (cos, sin). */
START_TEST(bounds_are_those_of_the_points)
{
    enum { LOOKS = 2000 };
    uint64_t random = 3;
    for (int k = 0; k < 300; ++k) {
        const double from = test_random(&random, -7, 7), turn = test_random(&random, 0.01, 2 * TEST_PI);
        const sph2d_arc arc = {.center = {0.3, -0.4}, .radius = 2, .from = from, .to = from + turn};
        sph2d_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}}, bounds = sph2d__arc_bounds(&arc);
        for (int n = 0; n <= LOOKS; ++n) {
            const double x = 0.3 + 2 * cos(from + turn * n / LOOKS), y = -0.4 + 2 * sin(from + turn * n / LOOKS);
            box = (sph2d_box){{fmin(box.min.x, x), fmin(box.min.y, y)}, {fmax(box.max.x, x), fmax(box.max.y, y)}};
        }
        const double fine = 2 * pow(turn / LOOKS, 2) / 8 + 1e-12; /* r (1 - cos) of half the way between looks */
        ck_assert_double_eq_tol(bounds.min.x, box.min.x, fine);
        ck_assert_double_eq_tol(bounds.min.y, box.min.y, fine);
        ck_assert_double_eq_tol(bounds.max.x, box.max.x, fine);
        ck_assert_double_eq_tol(bounds.max.y, box.max.y, fine);
    }
}
END_TEST

START_TEST(sides_of_an_arc)
{
    const sph2d_arc *arc = &arcs[_i];
    double side, r = arc->radius;
    for (int k = 0; k <= 20; ++k)
        for (int out = -1; out <= 1; out += 2)
            for (int beyond = 0; beyond < 2; ++beyond) {
                double part = beyond ? k % 2 : k / 20.0, angle = arc->from + part * (arc->to - arc->from);
                double away = (1 + out * (k + 1) / 45.0) * r, ahead = beyond ? (part > 0 ? 0.1 : -0.1) * r : 0;
                sph2d__arc_distance(arc,
                                    (sph2d_vec2){arc->center.x + away * cos(angle) - ahead * sin(angle),
                                                 arc->center.y + away * sin(angle) + ahead * cos(angle)},
                                    &side);
                if (!beyond || arc->to - arc->from < 5) /* else the other end is near */
                    ck_assert_msg(side * out < 0, "%d %d %d: %g", k, out, beyond, side);
            }
}
END_TEST

/* ---- bowls ------------------------------------------------------------------------------------------------------- */

enum { CORNERS = 120 };
static const sph2d_arc BOWL = {{0.5, 0.6}, 0.4, TEST_PI, 2 * TEST_PI};
static sph2d_vec2 corners[CORNERS + 1];

/** A bowl, the lower half of a circle, that water fills up to a height below the centre. */
static void bowl(double height)
{
    scene = test_scene(DX, 0, 0, 1, 1);
    scene.boundary.top = SPH2D_SIDE_OPEN;
    scene.method = sph2d_scene_default().method;
    scene.gravity = (sph2d_vec2){0, -9.81};
    scene.fluid.dynamic_viscosity = 2;
    obstacles[0] = sph2d_obstacle_default();
    obstacles[0].shape = (sph2d_shape){.kind = SPH2D_SHAPE_ARC, .arc = BOWL};
    obstacles[0].name = "bowl";
    double half = acos((BOWL.center.y - height) / BOWL.radius); /* of the angle over the surface */
    sph2d_arc wet = {BOWL.center, BOWL.radius, 1.5 * TEST_PI - half, 1.5 * TEST_PI + half};
    for (int k = 0; k <= CORNERS; ++k)
        corners[k] = point_of(&wet, (double)k / CORNERS);
    block = sph2d_block_default();
    block.shape = (sph2d_shape){.kind = SPH2D_SHAPE_POLYGON, .points = {corners, CORNERS + 1}};
    scene.blocks = &block;
    scene.block_count = 1;
    scene.obstacles = obstacles;
    scene.obstacle_count = 1;
    for (int k = 0; k < 2; ++k) {
        probes[k] = sph2d_probe_default();
        probes[k].kind = k ? SPH2D_PROBE_LEVEL : SPH2D_PROBE_FORCE;
        probes[k].name = k ? "level" : "force";
        probes[k].rate.every = 0.1;
    }
    probes[0].on = "bowl";
    scene.probes = probes;
    scene.probe_count = 2;
}

/** The wet side is found, layers are behind it, and normals point to the liquid. */
START_TEST(layers_of_a_bowl_are_outside)
{
    bowl(0.4);
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_int_eq(sim->world.walls[SPH2D__WALL_OBSTACLE].liquid, SPH2D_LIQUID_LEFT);
    const sph2d__store *w = &sim->system.walls;
    double area = 0, skin = 0, thick = 3 * DX;
    for (size_t b = 0; b < w->count; ++b) {
        const sph2d__ids *own = &sim->wall_ids[SPH2D__WALL_OBSTACLE];
        if (w->id[b] < own->first || w->id[b] >= own->end)
            continue;
        double x = w->x[b] - BOWL.center.x, y = w->y[b] - BOWL.center.y, out = hypot(x, y) - BOWL.radius;
        ck_assert(out > 0.4 * DX && out < thick);
        ck_assert_double_le((w->normal_x[b] * x + w->normal_y[b] * y) / hypot(x, y), -0.99);
        ck_assert_double_eq_tol(w->depth[b], out, 0.05 * DX);
        area += w->mass[b] / scene.fluid.density;
        skin += fabs(w->depth[b] - DX / 2) < 1e-9;
    }
    double wanted = TEST_PI / 2 * (pow(BOWL.radius + thick, 2) - pow(BOWL.radius, 2));
    ck_assert_msg(fabs(area / wanted - 1) < 0.01, "%g of %g", area, wanted);
    ck_assert_double_ge(skin * DX, TEST_PI * BOWL.radius);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Water beside an arc has the area that it should, weighs on the bowl what it should, and stays in, at its level. The
 *  sound speed is for its depth in the bowl. */
START_TEST(a_bowl_holds_water)
{
    const double height = 0.45;
    double values[SPH2D_PROBE_MAX_COLUMNS], level[SPH2D_PROBE_MAX_COLUMNS], mean = 0;
    bowl(height);
    scene.method.name = _i ? SPH2D_METHOD_PCISPH : SPH2D_METHOD_WCSPH;
    ck_assert_double_eq_tol(sph2d__basin_height(test_world(&scene), 0), height - 0.2, 1.5 * DX);
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d_plan *plan = sph2d_sim_plan(sim);
    ck_assert_msg(fabs(plan->area_placed / plan->area_asked - 1) < 0.005, "%g", plan->area_placed / plan->area_asked);
    ck_assert_uint_eq(plan->places_left_free, 0);
    size_t count = sim->system.fluid.count;
    int samples = 0;
    while (sph2d_sim_time(sim) < 0.8) {
        test_steps(sim, 1);
        if (sph2d_sim_time(sim) > 0.4 && ++samples)
            mean += sph2d_sim_probe(sim, 0, values) ? values[1] : NAN;
    }
    ck_assert(sph2d_sim_probe(sim, 1, level));
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, count);
    for (size_t i = 0; i < f.count; ++i)
        ck_assert_double_lt(hypot(f.x[i] - BOWL.center.x, f.y[i] - BOWL.center.y), BOWL.radius);
    double weight = 9.81 * sim->system.mass * (double)count;
    ck_assert_msg(fabs(mean / samples / -weight - 1) < 0.02, "%g", mean / samples / -weight);
    ck_assert_msg(fabs(level[0] - height) < 0.5 * DX, "level %g", level[0]);
    ck_assert_double_lt(sph2d_sim_summary(sim).speed_max, 0.2);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Liquid outside an arc has its layers inside; with liquid on both sides it is a solid, half of it on either side. */
START_TEST(layers_inside_an_arc_and_on_both_sides)
{
    bowl(0.4);
    scene.block_count = 0;
    scene.probe_count = 0;
    scene.method.sound_speed = 20;
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){0.5, 0.9};
    source.speed = 1;
    scene.sources = &source;
    scene.source_count = 1;
    obstacles[0].shape.arc = (sph2d_arc){{0.5, 0.3}, 0.3, 0.2, TEST_PI - 0.2};
    obstacles[0].liquid = _i ? SPH2D_LIQUID_BOTH : SPH2D_LIQUID_AUTO; /* found by the source */
    sph2d_sim *sim = test_create(&scene, NULL);
    const sph2d__store *w = &sim->system.walls;
    double inner = 0.3 - (_i ? 1.5 : 3) * DX, outer = 0.3 + (_i ? 1.5 : 0) * DX, area = 0;
    for (size_t b = 0; b < w->count; ++b) {
        const sph2d__ids *own = &sim->wall_ids[SPH2D__WALL_OBSTACLE];
        if (w->id[b] < own->first || w->id[b] >= own->end)
            continue;
        double r = hypot(w->x[b] - 0.5, w->y[b] - 0.3);
        ck_assert_msg(r > inner - 0.01 * DX && r < outer + 0.01 * DX, "%g", r);
        area += w->mass[b] / scene.fluid.density;
    }
    double wanted = (TEST_PI - 0.4) / 2 * (outer * outer - inner * inner);
    ck_assert_msg(fabs(area / wanted - 1) < 0.02, "%g of %g", area, wanted);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- arcs that turn ---------------------------------------------------------------------------------------------- */

/** A scoop of three quarters of a circle spins in or around liquid: followed in its frame, nothing goes through it. */
START_TEST(nothing_passes_an_arc_that_turns)
{
    static const struct {
        sph2d_method method;
        sph2d_wall_form form;
    } kinds[] = {{SPH2D_METHOD_WCSPH, SPH2D_WALL_GENERALISED},
                 {SPH2D_METHOD_MULLER, SPH2D_WALL_HEAVY},
                 {SPH2D_METHOD_PCISPH, SPH2D_WALL_GENERALISED},
                 {SPH2D_METHOD_CONSTRAINT, SPH2D_WALL_GENERALISED}};
    static const sph2d_arc scoop = {{0.5, 0.5}, 0.25, 0, 1.5 * TEST_PI};
    enum { MOST = 4000 };
    static int sides[MOST];
    memset(sides, 0, sizeof sides);
    bowl(0.4);
    scene.probe_count = 0;
    scene.gravity.y = -2;
    scene.method.name = kinds[_i].method;
    block = sph2d_block_default();
    block.shape = (sph2d_shape){.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.5, 0.5}, 0.2}};
    if (kinds[_i].form != SPH2D_WALL_GENERALISED)
        block = test_block(0, 0, 1, 0.6);
    obstacles[0].shape.arc = scoop;
    obstacles[0].form = kinds[_i].form;
    obstacles[0].motion.rate = 100;
    obstacles[0].motion.ramp = 0.02;
    obstacles[0].motion.center = (sph2d_vec2){0.45, 0.5};
    scene.run.max_energy_rise = 1e9;
    sph2d_sim *sim = test_create(&scene, NULL);
    size_t passed = 0, steps = 0, seen = 0;
    double bulge = sph2d__arc_bulge(&scoop, DX);
    while (steps < 300 && sph2d_sim_step(sim, &report) == SPH2D_OK) { /* a guard may stop it */
        sph2d_view f = sph2d_sim_fluid(sim);
        for (size_t i = 0; i < f.count; ++i) {
            sph2d_vec2 p = sph2d__pose_invert(&sim->moving[0].to, (sph2d_vec2){f.x[i], f.y[i]});
            double x = p.x - scoop.center.x, y = p.y - scoop.center.y, r = hypot(x, y), angle = atan2(y, x);
            ck_assert_uint_lt(f.id[i], MOST);
            int *known = &sides[f.id[i]];
            bool beside = (angle < 0 ? angle + 2 * TEST_PI : angle) < scoop.to && fabs(r / scoop.radius - 1) < 0.5;
            int side = !beside ? 0 : r < scoop.radius - bulge ? 1 : r > scoop.radius ? -1 : *known;
            passed += side * *known < 0;
            *known = side;
            seen += side != 0;
        }
        ++steps;
    }
    sph2d_report_clear(&report);
    ck_assert_uint_gt(steps, 20);
    ck_assert_double_gt(sim->moving[0].to.angle, 0.2);
    ck_assert_uint_gt(seen, 1000);
    ck_assert_msg(passed == 0, "%zu passed in %zu steps", passed, steps);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- checks ------------------------------------------------------------------------------------------------------ */

/** Where an arc is refused, why, and what is wrong with it. */
#define REFUSALS(X)                                                                                                    \
    X("obstacles[0].arc.radius", OUT_OF_RANGE, arc->radius = 0)                                                        \
    X("obstacles[0].arc.radius", OUT_OF_RANGE, arc->radius = -0.4)                                                     \
    X("obstacles[0].arc.to", OUT_OF_RANGE, arc->to = arc->from)                                                        \
    X("obstacles[0].arc.to", OUT_OF_RANGE, arc->to = arc->from - 1)                                                    \
    X("obstacles[0].arc.to", OUT_OF_RANGE, arc->to = arc->from + 2 * TEST_PI)                                          \
    X("obstacles[0].arc.to", OUT_OF_RANGE, arc->to = 12)                                                               \
    X("obstacles[0].arc.from", OUT_OF_RANGE, arc->from = NAN)                                                          \
    X("obstacles[0].arc", OUTSIDE, arc->center.y = 0.3)                                                                \
    X("obstacles[0].arc", OUTSIDE, arc->radius = 0.55)                                                                 \
    X("obstacles[0].arc.radius", CONFLICT, arc->radius = 0.06; obstacles[0].liquid = SPH2D_LIQUID_RIGHT;               \
      scene.block_count = 0)                                                                                           \
    X("obstacles[0].arc", CONFLICT, arc->radius = 0.025; obstacles[0].liquid = SPH2D_LIQUID_BOTH;                      \
      scene.block_count = 0)                                                                                           \
    X("obstacles[0].arc", CONFLICT, block = test_block(0, 0, 1, 0.5))                                                  \
    X("obstacles[0].liquid", CONFLICT, obstacles[0].liquid = SPH2D_LIQUID_INSIDE)                                      \
    X("obstacles[0].motion", OUTSIDE, obstacles[0].motion.rate = 3)                                                    \
    X("obstacles[0].motion", OUTSIDE, obstacles[0].motion.amplitude.y = 0.15; obstacles[0].motion.frequency = 1;       \
      scene.obstacle_count = 2)                                                                                        \
    X("obstacles", OUT_OF_RANGE, obstacles[0].liquid = SPH2D_LIQUID_BOTH; scene.spacing = 2e-4)

#define NUMBER(at, code, what) +1
enum { REFUSED = 0 REFUSALS(NUMBER) };

START_TEST(what_cannot_work_is_refused)
{
    int k = 0;
    sph2d_arc *arc = &obstacles[0].shape.arc;
    sph2d_report_clear(&report);
#define REFUSE(at, code, what)                                                                                         \
    if (k++ == _i) {                                                                                                   \
        bowl(0.4);                                                                                                     \
        obstacles[1] = sph2d_obstacle_default();                                                                       \
        obstacles[1].shape = (sph2d_shape){.kind = SPH2D_SHAPE_BOX, .box = {{0.3, 0}, {0.7, 0.12}}};                   \
        scene.method.sound_speed = 20;                                                                                 \
        what;                                                                                                          \
        ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_SCENE);                                             \
        ck_assert_msg(test_report_has(&report, SPH2D_CODE_##code, at), "%s: %s", at, test_report_text(&report));       \
    }
    REFUSALS(REFUSE)
    sph2d_report_clear(&report);
}
END_TEST

Suite *suite_arcs(void)
{
    Suite *suite = suite_create("arcs");
    TCase *geometry = tcase_create("geometry"), *walls = tcase_create("walls");
    tcase_add_loop_test(geometry, pieces_of_an_arc, 0, ARCS);
    tcase_add_loop_test(geometry, measures_of_an_arc, 0, ARCS);
    tcase_add_test(geometry, bounds_are_those_of_the_points);
    tcase_add_loop_test(geometry, sides_of_an_arc, 0, ARCS);
    tcase_add_test(walls, layers_of_a_bowl_are_outside);
    tcase_add_loop_test(walls, a_bowl_holds_water, 0, 2);
    tcase_add_loop_test(walls, layers_inside_an_arc_and_on_both_sides, 0, 2);
    tcase_add_loop_test(walls, what_cannot_work_is_refused, 0, REFUSED);
    suite_add_tcase(suite, geometry);
    suite_add_tcase(suite, walls);
    TCase *slow = test_long(suite);
    tcase_add_loop_test(slow, nothing_passes_an_arc_that_turns, 0, 4);
    return suite;
}
