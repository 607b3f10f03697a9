/* SPDX-License-Identifier: MIT */
/** @file test_contacts.c
 *  Contacts of single bodies, against what mechanics says of them. */
#include <check.h>
#include <math.h>

#include "base/pi.h"
#include "contact_world.h"
#include "sph2d/contacts.h"
#include "suites.h"

#define NEAR(a, b, tolerance) ck_assert_double_eq_tol(a, b, tolerance)

/** Two discs of masses 1 : 4 meet head on; without gravity. */
static contact_world *two_discs(double restitution)
{
    contact_world *w = world_new();
    w->gravity = (sph2d_vec2){0, 0};
    uint32_t a = world_disc(w, 0.3, 0.5, 0.05), b = world_disc(w, 0.6, 0.5, 0.1);
    w->bodies[a].restitution = restitution;
    w->states[a].velocity.x = 2;
    w->states[b].velocity.x = -1;
    return w;
}

START_TEST(impacts)
{
    for (int i = 0; i <= 2; ++i) {
        double e = i / 2.0;
        contact_world *w = two_discs(e);
        double m = 1 / w->states[0].inverse_mass_x, all = 5 * m, momentum = 2 * m - 4 * m, energy = world_kinetic(w);
        world_run(w, 200);
        double va = w->states[0].velocity.x, vb = w->states[1].velocity.x;
        NEAR(m * va + 4 * m * vb, momentum, 1e-13 * all);
        NEAR(vb - va, 3 * e, 1e-12);
        NEAR(world_kinetic(w), energy - (1 - e * e) * 0.8 * m * 9 / 2, 1e-10 * energy);
        ck_assert_double_eq(w->states[0].velocity.y, 0);
        ck_assert_double_le(w->overlap, 0);
    }
}
END_TEST

START_TEST(far_apart)
{
    contact_world *w = two_discs(0);
    sph2d_contact_body before = w->states[0];
    ck_assert(sph2d__contacts_solve(&w->scene, w->walls, w->dt, w->states, 2, w->work) == SPH2D_OK);
    ck_assert_double_eq(w->states[0].velocity.x, before.velocity.x);
    w->states[1].rate = NAN;
    ck_assert(sph2d__contacts_solve(&w->scene, w->walls, w->dt, w->states, 2, w->work) == SPH2D_INVALID);
    ck_assert(sph2d_contacts_attach(NULL) == SPH2D_INVALID);
}
END_TEST

/** A disc rolls down an incline of 30 degrees by 2/3 g sin if friction suffices; a box slides by g (sin - f cos). */
START_TEST(inclines)
{
    double g = 9.81, sine = 0.5, cosine = sqrt(0.75);
    for (int i = 0; i < 3; ++i) {
        contact_world *w = world_new();
        w->gravity = (sph2d_vec2){g * sine, -g * cosine};
        uint32_t a = i == 0 ? world_disc(w, 0.2, 0.0502, 0.05) : world_box(w, 0.2, 0.0502, 0.1, 0.1);
        w->bodies[a].friction = i == 1 ? 0.2 : 0.7;
        world_run(w, 600);
        double expected = i == 0 ? g * sine * 2 / 3 : i == 1 ? g * (sine - 0.2 * cosine) : 0;
        NEAR(w->states[a].velocity.x, 0.3 * expected, i == 2 ? 1e-9 : 0.002 * 0.3 * g);
        NEAR(w->states[a].rate, i == 0 ? -0.3 * expected / 0.05 : 0, 0.05);
        ck_assert_double_le(w->overlap, 0);
        ck_assert_double_le(w->gain, 1e-12);
    }
}
END_TEST

/** A disc flies at a line from each of its sides, and stops at it: the line is seen before the disc is in it. */
START_TEST(lines_stop_discs_from_all_sides)
{
    static const sph2d_vec2 to[] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    const sph2d_vec2 d = to[_i];
    sph2d_vec2 line[2] = {{0.5 - 0.2 * d.y, 0.5 + 0.2 * d.x}, {0.5 + 0.2 * d.y, 0.5 - 0.2 * d.x}};
    contact_world *w = world_new();
    w->gravity = (sph2d_vec2){0, 0};
    world_obstacle(w, (sph2d_shape){.kind = SPH2D_SHAPE_LINE, .points = {line, 2}}, line[0]);
    uint32_t a = world_disc(w, 0.5 - 0.1003 * d.x, 0.5 - 0.1003 * d.y, 0.05);
    w->states[a].velocity = d;
    for (int step = 0; step < 400; ++step) {
        world_step(w, false);
        const sph2d_vec2 c = w->states[a].center;
        ck_assert_double_ge((0.5 - c.x) * d.x + (0.5 - c.y) * d.y, 0.05 - 1e-6);
    }
    NEAR(hypot(w->states[a].velocity.x, w->states[a].velocity.y), 0, 1e-9);
    ck_assert_double_le(w->gain, 1e-12);
}
END_TEST

/** What is held along x is a wall along x, and moves along y. */
START_TEST(held)
{
    contact_world *w = two_discs(1);
    w->states[1].inverse_mass_x = 0;
    w->states[1].velocity.x = 0;
    w->states[0].center.y = 0.54;
    double energy = world_kinetic(w);
    world_run(w, 300);
    ck_assert_double_eq(w->states[1].velocity.x, 0);
    ck_assert_double_eq(w->states[1].center.x, 0.6);
    ck_assert_double_lt(w->states[1].velocity.y, -0.01);
    ck_assert_double_lt(w->states[0].velocity.x, 0);
    NEAR(world_kinetic(w), energy, 0.1 * energy);
    ck_assert_double_le(w->gain, 1e-12);
}
END_TEST

/** A wall moves along x to a disc of radius 0.05 at x, from 0.2; without gravity. */
static uint32_t wall_meets_disc(contact_world *w, double x, double speed)
{
    sph2d_shape outline = {.kind = SPH2D_SHAPE_BOX, .box = {{0.1, 0.3}, {0.2, 0.7}}};
    w->gravity.y = 0;
    world_obstacle(w, outline, (sph2d_vec2){0.15, 0.5});
    w->walls[0].velocity.x = speed;
    return world_disc(w, x, 0.5, 0.05);
}

/** A belt takes a box to its speed; a wall that moves takes a disc along. */
START_TEST(moving_walls)
{
    contact_world *w = world_new();
    w->scene.wall_speeds.bottom = 0.5;
    uint32_t a = world_box(w, 0.2, 0.0502, 0.1, 0.1);
    world_run(w, 600);
    NEAR(w->states[a].velocity.x, 0.5, 1e-6);
    NEAR(w->work[SPH2D__SIDE_BOTTOM], 10 * 0.5 * 0.5, 1e-4); /* momentum by the belt's speed: half of it is lost */
    ck_assert_double_eq(w->work[SPH2D__SIDE_LEFT], 0);
    ck_assert_double_le(w->gain, 1e-12);

    w = world_new();
    a = wall_meets_disc(w, 0.4, 1);
    world_run(w, 600);
    NEAR(w->states[a].velocity.x, 1, 1e-12);
    NEAR(w->states[a].center.x, 0.2 + 0.3 + 0.05, 0.001);
    NEAR(w->work[SPH2D__SIDES], 1000 * SPH2D__PI * 0.0025, 1e-6);

    /* A bar that turns hits it away. */
    w = world_new();
    w->gravity.y = 0;
    a = world_disc(w, 0.7, 0.6, 0.05);
    sph2d_vec2 bar[2] = {{0.5, 0.5}, {0.8, 0.5}};
    world_obstacle(w, (sph2d_shape){.kind = SPH2D_SHAPE_LINE, .points = {bar, 2}}, bar[0]);
    w->walls[0].rate = 5;
    world_run(w, 200);
    ck_assert_double_gt(w->states[a].velocity.y, 0.5);
    ck_assert_double_le(w->gain, 1e-12);
}
END_TEST

/** Each side is a belt of its own, and a box that is pressed on it takes momentum by the belt's speed. */
START_TEST(belts)
{
    static const sph2d_vec2 to[SPH2D__SIDES] = {{-9.81, 0}, {9.81, 0}, {0, -9.81}, {0, 9.81}};
    contact_world *w = world_new();
    double *const speeds[SPH2D__SIDES] = {&w->scene.wall_speeds.left, &w->scene.wall_speeds.right,
                                          &w->scene.wall_speeds.bottom, &w->scene.wall_speeds.top};
    w->gravity = to[_i];
    *speeds[_i] = 0.4;
    world_box(w, 0.5 + 0.4498 * to[_i].x / 9.81, 0.5 + 0.4498 * to[_i].y / 9.81, 0.1, 0.1);
    world_run(w, 600);
    for (int side = 0; side < SPH2D__SIDES; ++side)
        NEAR(w->work[side], side == _i ? 10 * 0.4 * 0.4 : 0, 1e-4);
}
END_TEST

/** A wall that moves brings all that a bounce without friction has, and what pushes out a disc that it overlaps. */
START_TEST(work)
{
    contact_world *w = world_new();
    uint32_t a = wall_meets_disc(w, 0.4, 1);
    w->bodies[a].restitution = 1;
    w->bodies[a].friction = 0;
    world_run(w, 600);
    NEAR(w->states[a].velocity.x, 2, 1e-9);
    NEAR(w->work[SPH2D__SIDES], world_kinetic(w), 1e-9);

    w = world_new();
    a = wall_meets_disc(w, 0.2501, 0.004);
    world_run(w, 50);
    NEAR(w->states[a].velocity.x, 2 * 0.004, 1e-9); /* the push wants three times the speed; energy is for twice */
    NEAR(w->work[SPH2D__SIDES], world_kinetic(w), 1e-12);
    ck_assert_double_le(w->gain, 1e-12);
}
END_TEST

/** Thin walls stop what moves by more than its size in a step, a plate that turns, too. */
START_TEST(fast)
{
    static const sph2d_vec2 line[3] = {{0, 0.3}, {0.5, 0.2}, {1, 0.3}};
    for (int i = 0; i < 20; ++i) {
        contact_world *w = world_new();
        world_obstacle(w, (sph2d_shape){.kind = SPH2D_SHAPE_POLYLINE, .points = {line, 3}}, line[1]);
        uint32_t a = i % 2 ? world_disc(w, 0.1 + 0.04 * i, 0.6, 0.005) : world_box(w, 0.1 + 0.04 * i, 0.6, 0.03, 0.004);
        w->states[a].velocity = (sph2d_vec2){3 * (i % 3 - 1), -40};
        w->states[a].rate = i % 2 ? 0 : 100;
        world_run(w, 400);
        double x = w->states[a].center.x, floor = 0.2 + 0.2 * fabs(x - 0.5);
        ck_assert_msg(w->states[a].center.y > floor, "%d: at %g, %g", i, x, w->states[a].center.y);
    }
}
END_TEST

/** A disc in a cup that falls, and rests in it. */
START_TEST(concave)
{
    static const sph2d_vec2 cup[8] = {{0.3, 0.1},   {0.7, 0.1},   {0.7, 0.4},  {0.65, 0.4},
                                      {0.65, 0.15}, {0.35, 0.15}, {0.35, 0.4}, {0.3, 0.4}};
    contact_world *w = world_new();
    uint32_t a = world_polygon(w, (sph2d_points){cup, 8}, (sph2d_vec2){0.5, 0.18}, 45, 1);
    uint32_t b = world_disc(w, 0.45, 0.5, 0.08);
    world_run(w, 3000);
    ck_assert_double_lt(world_kinetic(w), 1e-6);
    NEAR(w->states[a].center.y, 0.08, 0.0005);
    NEAR(w->states[b].center.y, 0.13, 0.001);
    ck_assert_double_lt(fabs(w->states[b].center.x - w->states[a].center.x), 0.07);
    ck_assert_double_le(w->gain, 1e-12);
}
END_TEST

/** Hollow obstacles hold what is in them. */
START_TEST(hollow)
{
    static const sph2d_vec2 bowl[6] = {{0.2, 0.5}, {0.4, 0.1}, {0.6, 0.1}, {0.8, 0.5}, {0.55, 0.9}, {0.5, 0.6}};
    for (int i = 0; i < 3; ++i) {
        contact_world *w = world_new();
        sph2d_shape outlines[3] = {{.kind = SPH2D_SHAPE_CIRCLE, .circle = {{0.5, 0.5}, 0.3}},
                                   {.kind = SPH2D_SHAPE_BOX, .box = {{0.25, 0.25}, {0.75, 0.75}}},
                                   {.kind = SPH2D_SHAPE_POLYGON, .points = {bowl, 6}}};
        world_obstacle(w, outlines[i], (sph2d_vec2){0.5, 0.5});
        w->obstacles[0].liquid = SPH2D_LIQUID_INSIDE;
        uint32_t a = world_disc(w, 0.45, 0.5, 0.05), b = world_box(w, 0.56, 0.5, 0.08, 0.06);
        w->states[a].velocity = (sph2d_vec2){-8, 5};
        w->states[b].rate = 30;
        world_run(w, 4000);
        double bottom = i == 0 ? 0.2 : i == 1 ? 0.25 : 0.1;
        NEAR(w->states[a].center.y, bottom + 0.055, 0.03);
        NEAR(w->states[b].center.y, bottom + 0.04, 0.03);
        ck_assert_double_le(w->overlap, 0);
        ck_assert_double_le(w->gain, 1e-12);
        ck_assert_double_lt(world_kinetic(w), 0.001); /* a disc in a round bowl rolls to and fro */
    }
}
END_TEST

/** Discs meet across a periodic side, whatever period their centres are in. */
START_TEST(periodic)
{
    for (int i = 0; i < 2; ++i) {
        contact_world *w = two_discs(1);
        w->scene.boundary.left = w->scene.boundary.right = SPH2D_SIDE_PERIODIC;
        w->states[0].velocity.x = -2;
        w->states[1].velocity.x = 1;
        w->states[1].center.x += 3 * i;
        world_run(w, 600);
        NEAR(w->states[1].velocity.x - w->states[0].velocity.x, -3, 1e-12);
    }
}
END_TEST

/** What overlaps at the start goes apart, as far as there is energy for it. */
START_TEST(overlapping)
{
    contact_world *w = world_new();
    world_disc(w, 0.5, 0.098, 0.1);
    world_disc(w, 0.52, 0.295, 0.1);
    for (int i = 0; i < 4000; ++i)
        world_step(w, false);
    ck_assert_double_le(w->gain, 1e-12);
    ck_assert_double_le(world_overlap(w, 0, 1), 0);
    ck_assert_double_ge(w->states[0].center.y, 0.1);

    w = two_discs(0);
    w->states[1].center.x = 0.4;
    w->states[0].velocity.x = w->states[1].velocity.x = 0;
    uint32_t a = world_disc(w, 0.8, 0.0503, 0.05);
    w->states[a].velocity.y = -1; /* what it loses at the floor is not theirs */
    world_step(w, false);
    ck_assert_double_gt(w->states[a].velocity.y, -0.7);
    w->states[a].velocity.y = 0;
    ck_assert_double_eq(world_kinetic(w), 0);
}
END_TEST

Suite *suite_contacts(void)
{
    Suite *suite = suite_create("contacts");
    TCase *tests = tcase_create("contacts");
    tcase_add_test(tests, impacts);
    tcase_add_test(tests, far_apart);
    tcase_add_test(tests, inclines);
    tcase_add_loop_test(tests, lines_stop_discs_from_all_sides, 0, 4);
    tcase_add_test(tests, held);
    tcase_add_test(tests, moving_walls);
    tcase_add_loop_test(tests, belts, 0, SPH2D__SIDES);
    tcase_add_test(tests, work);
    tcase_add_test(tests, fast);
    tcase_add_test(tests, concave);
    tcase_add_test(tests, hollow);
    tcase_add_test(tests, periodic);
    tcase_add_test(tests, overlapping);
    suite_add_tcase(suite, tests);
    return suite;
}
