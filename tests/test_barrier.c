/* SPDX-License-Identifier: MIT */
/** @file test_barrier.c
 *  The swept test against walls (boundary/barrier.h), by what it promises: a motion ends on its own side of every wall,
 *  speed never grows, only the part into the wall is lost, sliding is free, corners hold.
 *
 *  Sides are told by the sign of the cross product and by compartments that no path can leave: cells of an arrangement
 *  of lines, insides of closed polygons. */
#include <math.h>
#include <string.h>

#include "boundary/barrier.h"
#include "common.h"

static const double CLEARANCE = 0.001;

static sph2d__memory memory;
static sph2d__barrier barrier;

static void start(void)
{
    memory = sph2d__memory_from((sph2d_allocator){0});
    barrier = (sph2d__barrier){0};
}

static void finish(void)
{
    sph2d__barrier_free(&barrier, &memory);
    ck_assert_uint_eq(memory.bytes, 0);
}

static void add(double ax, double ay, double bx, double by)
{
    ck_assert(sph2d__barrier_add(&barrier, (sph2d__segment){{ax, ay}, {bx, by}}, &memory));
}

static void build(double bucket)
{
    ck_assert(sph2d__barrier_build(&barrier, bucket, CLEARANCE, &memory));
}

/** Twice the area of a triangle, positive when it turns left. */
static double turn(sph2d_vec2 a, sph2d_vec2 b, sph2d_vec2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static bool cross(sph2d_vec2 a, sph2d_vec2 b, sph2d_vec2 c, sph2d_vec2 d)
{
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

static sph2d_vec2 random_point(uint64_t *random, double low, double high)
{
    double x = test_random(random, low, high);
    return (sph2d_vec2){x, test_random(random, low, high)};
}

/** A motion of any length from 1e-6 to 10, in any direction. */
static sph2d_vec2 random_motion(uint64_t *random)
{
    double angle = test_random(random, 0, 2 * TEST_PI), length = pow(10, test_random(random, -6, 1));
    return (sph2d_vec2){length * cos(angle), length * sin(angle)};
}

static double length(sph2d_vec2 v)
{
    return hypot(v.x, v.y);
}

START_TEST(nothing_in_the_way_changes_nothing)
{
    sph2d_vec2 to = {3, 4}, v = {5, 6};
    ck_assert_int_eq(sph2d__barrier_sweep(&barrier, (sph2d_vec2){1, 2}, &to, &v, NULL), 0); /* no walls at all */
    build(0.1);
    ck_assert_int_eq(sph2d__barrier_sweep(&barrier, (sph2d_vec2){1, 2}, &to, &v, NULL), 0);
    ck_assert(to.x == 3 && to.y == 4 && v.x == 5 && v.y == 6);
    add(0, 0, 1, 0);
    build(0.1);
    sph2d_vec2 away = {0.5, 9};
    ck_assert_int_eq(sph2d__barrier_sweep(&barrier, (sph2d_vec2){0.5, 0.01}, &away, &v, NULL), 0);
    sph2d_vec2 beside = {1.1, -1};
    ck_assert_int_eq(sph2d__barrier_sweep(&barrier, (sph2d_vec2){1.1, 1}, &beside, &v, NULL), 0);
    ck_assert(away.y == 9 && beside.y == -1 && v.x == 5 && v.y == 6);
}
END_TEST

START_TEST(a_motion_into_a_wall_stops_at_the_clearance_and_slides)
{
    add(-1, 0, 1, 0);
    build(0.1);
    sph2d_vec2 to = {0.3, -0.5}, v = {3, -5};
    ck_assert_int_eq(sph2d__barrier_sweep(&barrier, (sph2d_vec2){0, 0.5}, &to, &v, NULL), 1);
    ck_assert_double_eq_tol(to.x, 0.3, 1e-15); /* the way along the wall is not lost */
    ck_assert_double_eq_tol(to.y, CLEARANCE, 1e-15);
    ck_assert_double_eq_tol(v.x, 3, 1e-15);
    ck_assert_double_eq_tol(v.y, 0, 1e-15);
    /* From below, and with a velocity that points away already: it keeps that. */
    to = (sph2d_vec2){-0.2, 7};
    v = (sph2d_vec2){1, -2};
    ck_assert_int_eq(sph2d__barrier_sweep(&barrier, (sph2d_vec2){0.1, -0.2}, &to, &v, NULL), 1);
    ck_assert_double_eq_tol(to.x, -0.2, 1e-15);
    ck_assert_double_eq_tol(to.y, -CLEARANCE, 1e-15);
    ck_assert(v.x == 1 && v.y == -2);
}
END_TEST

START_TEST(the_first_of_several_walls_counts)
{
    for (int i = 0; i < 5; ++i)
        add(-1, -0.1 * i, 1, -0.1 * i);
    build(0.02);
    sph2d_vec2 to = {0.8, -0.7}, v = {8, -7};
    ck_assert_int_eq(sph2d__barrier_sweep(&barrier, (sph2d_vec2){-0.2, 0.3}, &to, &v, NULL), 1);
    ck_assert_double_eq_tol(to.x, 0.8, 1e-12);
    ck_assert_double_eq_tol(to.y, CLEARANCE, 1e-12);
    ck_assert(v.x == 8 && v.y == 0);
}
END_TEST

START_TEST(one_wall_is_never_crossed)
{
    uint64_t random = 1 + (uint64_t)_i;
    size_t crossed = 0, faster = 0, missed = 0, spurious = 0, tested = 0;
    for (int k = 0; k < 20000; ++k) {
        sph2d_vec2 a = random_point(&random, -1, 1), m = random_motion(&random);
        sph2d__segment wall = {a, {a.x + m.x, a.y + m.y}};
        if (length(m) < 1e-4)
            continue; /* far shorter than the clearance */
        sph2d__barrier_free(&barrier, &memory);
        add(wall.a.x, wall.a.y, wall.b.x, wall.b.y);
        build(0.02 * length(m) + 1e-3);
        sph2d_vec2 from = random_point(&random, -2, 2), way = random_motion(&random);
        sph2d_vec2 aim = {from.x + way.x, from.y + way.y}, to = aim, v = random_motion(&random), before = v;
        if (k % 2) { /* half of them aimed at the wall, from nearby */
            double t = test_random(&random, -0.05, 1.05);
            sph2d_vec2 at = {a.x + t * m.x, a.y + t * m.y};
            from = (sph2d_vec2){at.x + 0.01 * way.x, at.y + 0.01 * way.y};
            to = aim = (sph2d_vec2){at.x - way.x, at.y - way.y};
        }
        int hits = sph2d__barrier_sweep(&barrier, from, &to, &v, NULL);
        ++tested;
        crossed += cross(wall.a, wall.b, from, to) || !isfinite(to.x + to.y);
        faster += !(length(v) <= length(before) * (1 + 1e-14));
        missed += hits == 0 && cross(wall.a, wall.b, from, aim);
        /* A way that stays clear of the wall is left alone. */
        bool clear = !cross(wall.a, wall.b, from, aim) && sph2d__segment_distance(&wall, from) > 2 * CLEARANCE &&
                     sph2d__segment_distance(&wall, aim) > 2 * CLEARANCE;
        sph2d__segment path = {from, aim};
        clear = clear && sph2d__segment_distance(&path, wall.a) > 2 * CLEARANCE &&
                sph2d__segment_distance(&path, wall.b) > 2 * CLEARANCE;
        spurious += clear && (hits > 0 || to.x != aim.x || to.y != aim.y);
    }
    ck_assert_uint_gt(tested, 9000);
    ck_assert_msg(crossed + faster + missed + spurious == 0, "%zu crossed, %zu faster, %zu missed, %zu spurious",
                  crossed, faster, missed, spurious);
}
END_TEST

enum { MOST_LINES = 12 };

/** The side of each line that a point is on, a bit a line. */
static unsigned sides(sph2d_vec2 p)
{
    unsigned bits = 0;
    for (size_t i = 0; i < barrier.count; ++i)
        bits |= (unsigned)(turn(barrier.segments[i].ends.a, barrier.segments[i].ends.b, p) > 0) << i;
    return bits;
}

START_TEST(no_motion_leaves_its_cell_of_crossing_lines)
{
    /* A box cut by random lines from side to side: cells with corners of every angle. */
    uint64_t random = 100 + (uint64_t)_i;
    add(-0.1, 0, 1.1, 0);
    add(1, -0.1, 1, 1.1);
    add(1.1, 1, -0.1, 1);
    add(0, 1.1, 0, -0.1);
    while (barrier.count < MOST_LINES) {
        double a = test_random(&random, -0.1, 1.1), b = test_random(&random, -0.1, 1.1);
        if (barrier.count % 2)
            add(a, -0.2, b, 1.2);
        else
            add(-0.2, a, 1.2, b);
    }
    build(0.07);
    size_t left = 0, faster = 0, hit = 0;
    for (int k = 0; k < 200; ++k) {
        sph2d_vec2 p = random_point(&random, 0.001, 0.999), v = random_motion(&random);
        unsigned home = sides(p);
        double speed = length(v);
        for (int n = 0; n < 100; ++n) {
            sph2d_vec2 way = random_motion(&random), to = {p.x + way.x, p.y + way.y};
            if (n % 10 == 0) { /* the velocity points along the way, as in a run */
                v = way;
                speed = length(v);
            }
            hit += sph2d__barrier_sweep(&barrier, p, &to, &v, NULL) > 0;
            faster += !(length(v) <= speed * (1 + 1e-14));
            speed = length(v);
            p = to;
            left += sides(p) != home;
        }
    }
    ck_assert_uint_gt(hit, 5000);
    ck_assert_msg(left + faster == 0, "%zu left their cell, %zu got faster", left, faster);
}
END_TEST

START_TEST(a_narrow_corner_holds_from_within_the_clearance)
{
    /* Two walls at a small angle: near the tip a particle is within the clearance of both, on either side. */
    static const double angles[] = {1.0, 0.3, 0.05, 0.005};
    double angle = angles[_i];
    uint64_t random = 7;
    add(0, 0, cos(angle), sin(angle));
    add(0, 0, 1, 0);
    add(cos(angle), sin(angle), 1, 0);
    build(0.05);
    size_t left = 0;
    for (int k = 0; k < 20000; ++k) {
        double r = pow(10, test_random(&random, -6, -0.1)), f = test_random(&random, 0.01, 0.99) * angle;
        sph2d_vec2 p = {r * cos(f), r * sin(f)}, way = random_motion(&random);
        if (k % 3 == 0) /* straight at the tip */
            way = (sph2d_vec2){-p.x * 2, -p.y * 2};
        sph2d_vec2 to = {p.x + way.x, p.y + way.y}, v = way;
        unsigned home = sides(p);
        sph2d__barrier_sweep(&barrier, p, &to, &v, NULL);
        left += sides(to) != home || !(length(v) <= length(way) * (1 + 1e-14));
    }
    ck_assert_msg(left == 0, "%zu left", left);
}
END_TEST

/** A star with spikes, closed; tips are thinner than the clearance. */
enum { SPIKES = 9 };
static sph2d_vec2 star[2 * SPIKES];

static bool in_star(sph2d_vec2 p)
{
    bool inside = false;
    for (size_t i = 0; i < 2 * SPIKES; ++i) {
        sph2d_vec2 a = star[i], b = star[(i + 1) % (2 * SPIKES)];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
            inside = !inside;
    }
    return inside;
}

START_TEST(nothing_gets_into_or_out_of_a_star)
{
    for (int i = 0; i < 2 * SPIKES; ++i) {
        double angle = TEST_PI * i / SPIKES + 0.1, r = i % 2 ? 1 : 0.07;
        star[i] = (sph2d_vec2){r * cos(angle), r * sin(angle)};
    }
    for (int i = 0; i < 2 * SPIKES; ++i) {
        sph2d_vec2 a = star[i], b = star[(i + 1) % (2 * SPIKES)];
        add(a.x, a.y, b.x, b.y);
    }
    build(0.03);
    uint64_t random = 50 + (uint64_t)_i;
    size_t passed = 0, inside = 0;
    for (int k = 0; k < 400; ++k) {
        sph2d_vec2 p = k % 2 ? random_point(&random, -0.06, 0.06) : random_point(&random, -1.5, 1.5);
        bool home = in_star(p);
        inside += home;
        for (int n = 0; n < 60; ++n) {
            sph2d_vec2 way = random_motion(&random), to = {p.x + way.x, p.y + way.y}, v = way;
            if (n % 3 == 0) /* back to the middle, where the walls are */
                to = random_point(&random, -0.3, 0.3);
            sph2d__barrier_sweep(&barrier, p, &to, &v, NULL);
            p = to;
            passed += in_star(p) != home;
        }
    }
    ck_assert_uint_gt(inside, 100);
    ck_assert_uint_lt(inside, 380);
    ck_assert_msg(passed == 0, "%zu passed", passed);
}
END_TEST

START_TEST(what_is_far_together_is_far_alone)
{
    uint64_t random = 29;
    int far = 0;
    add(0.2, 0.3, 0.7, 0.35);
    add(0.5, -0.4, 0.5, 0.1);
    build(0.05);
    for (int round = 0; round < 20000; ++round) {
        sph2d_vec2 a = random_point(&random, -1, 1), size = random_point(&random, 0, 0.2);
        sph2d_vec2 low = {a.x, a.y}, high = {a.x + size.x, a.y + size.y};
        double way = test_random(&random, 0, 0.06);
        bool together = sph2d__barrier_far_from(&barrier, low, high, way);
        far += together;
        for (int k = 0; k < 20 && together; ++k) {
            sph2d_vec2 to = {test_random(&random, low.x, high.x), test_random(&random, low.y, high.y)};
            double x = test_random(&random, -way, way), y = test_random(&random, -1, 1) * (way - fabs(x));
            ck_assert(sph2d__barrier_far(&barrier, (sph2d_vec2){to.x + x, to.y + y}, to));
        }
    }
    ck_assert_int_gt(far, 2000);
    ck_assert_int_lt(far, 18000);
    ck_assert(sph2d__barrier_far_from(&barrier, (sph2d_vec2){-0.9, 0}, (sph2d_vec2){-0.8, 0}, 0.04));
    ck_assert(!sph2d__barrier_far_from(&barrier, (sph2d_vec2){-0.9, 0}, (sph2d_vec2){-0.8, 0}, 0.06));
}
END_TEST

START_TEST(walls_hold_against_what_comes_from_far_away)
{
    /* The buckets cover the walls only; motions start and end far outside them. */
    enum { PIECES = 300 };
    for (int i = 0; i < PIECES; ++i) {
        double a = 2 * TEST_PI * i / PIECES, b = 2 * TEST_PI * (i + 1) / PIECES;
        add(cos(a), sin(a), cos(b), sin(b));
    }
    build(0.02);
    uint64_t random = 12;
    size_t entered = 0;
    for (int k = 0; k < 20000; ++k) {
        double a = test_random(&random, 0, 2 * TEST_PI), r = pow(10, test_random(&random, 0.01, 8));
        sph2d_vec2 from = {r * cos(a), r * sin(a)}, to = random_point(&random, -1, 1),
                   v = {to.x - from.x, to.y - from.y};
        if (k % 2)
            to = (sph2d_vec2){-from.x, -from.y};
        sph2d__barrier_sweep(&barrier, from, &to, &v, NULL);
        entered += length(to) < cos(TEST_PI / PIECES) || !isfinite(to.x + to.y);
    }
    ck_assert_uint_eq(entered, 0);
}
END_TEST

START_TEST(sliding_is_free_over_joints)
{
    /* A straight floor of many pieces, as a polyline has them: one long slide, pressed down at each step. */
    for (int i = 0; i < 50; ++i)
        add(i, 0, i + 1, 0);
    build(0.5);
    sph2d_vec2 p = {0.5, 0.01}, v = {1, 0};
    for (int n = 0; n < 4000; ++n) {
        v.y -= 0.1;
        sph2d_vec2 to = {p.x + 0.012 * v.x, p.y + 0.012 * v.y};
        sph2d__barrier_sweep(&barrier, p, &to, &v, NULL);
        p = to;
    }
    ck_assert_double_eq_tol(p.x, 0.5 + 4000 * 0.012, 1e-9);
    ck_assert_double_eq_tol(p.y, CLEARANCE, 1e-9);
    ck_assert_double_eq_tol(v.x, 1, 1e-12);
}
END_TEST

START_TEST(a_corner_takes_the_whole_motion)
{
    add(0, 0, 1, 0);
    add(0, 0, 0, 1);
    build(0.1);
    sph2d_vec2 to = {-1, -3}, v = {-1, -3};
    ck_assert_int_eq(sph2d__barrier_sweep(&barrier, (sph2d_vec2){0.2, 0.3}, &to, &v, NULL), 2);
    ck_assert_double_eq_tol(to.x, CLEARANCE, 1e-12);
    ck_assert_double_eq_tol(to.y, CLEARANCE, 1e-12);
    ck_assert_double_eq_tol(length(v), 0, 1e-12);
}
END_TEST

/* Liquid that slides along a wall passes a convex corner as if the wall behind it were not there: where that wall's line
 * at the clearance went on past the corner, all that slid stopped there, at one spot. _i: how sharp the corner is. */
START_TEST(sliding_goes_on_beyond_a_convex_corner)
{
    double angle = -TEST_PI / 8 * (_i + 1);
    add(-1, 0, 0, 0);
    add(0, 0, cos(angle), sin(angle));
    build(0.1);
    sph2d_vec2 p = {-0.01, CLEARANCE}, v = {1, 0};
    for (int n = 0; n < 100; ++n) {
        sph2d_vec2 to = {p.x + 0.0003 * v.x, p.y};
        ck_assert_int_eq(sph2d__barrier_sweep(&barrier, p, &to, &v, NULL), 0);
        p = to;
    }
    ck_assert_double_eq_tol(p.x, 0.02, 1e-12);
    ck_assert_double_eq(v.x, 1);
}
END_TEST

Suite *suite_barrier(void)
{
    Suite *suite = suite_create("barrier");
    TCase *tests = tcase_create("barrier");
    tcase_add_checked_fixture(tests, start, finish);
    tcase_add_test(tests, nothing_in_the_way_changes_nothing);
    tcase_add_test(tests, a_motion_into_a_wall_stops_at_the_clearance_and_slides);
    tcase_add_test(tests, the_first_of_several_walls_counts);
    tcase_add_loop_test(tests, no_motion_leaves_its_cell_of_crossing_lines, 0, 12);
    tcase_add_loop_test(tests, a_narrow_corner_holds_from_within_the_clearance, 0, 4);
    tcase_add_loop_test(tests, nothing_gets_into_or_out_of_a_star, 0, 4);
    tcase_add_test(tests, sliding_is_free_over_joints);
    tcase_add_test(tests, a_corner_takes_the_whole_motion);
    tcase_add_loop_test(tests, sliding_goes_on_beyond_a_convex_corner, 0, 7);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_checked_fixture(slow, start, finish);
    tcase_add_loop_test(slow, one_wall_is_never_crossed, 0, 3);
    tcase_add_test(slow, what_is_far_together_is_far_alone);
    tcase_add_test(slow, walls_hold_against_what_comes_from_far_away);
    return suite;
}
