/* SPDX-License-Identifier: MIT */
/** @file test_impacts.c
 *  Methods `pcisph` and `constraint` where liquid meets something: drops, jets on thin walls, liquid that starts inside
 *  a wall, sources and drains. U = sqrt(g H) with the depth H. */
#include <math.h>
#include <stdlib.h>

#include "tank.h"

/* ---- what falls -------------------------------------------------------------------------------------------------- */

START_TEST(a_drop_falls_freely_and_splashes_no_faster_than_it_came)
{
    const double bottom = 0.5, pool = 0.2; /* of the drop; depth */
    tank_empty(both[_i], DX, 1, 0.8, 1e-3);
    tank_add(0, 0, 1, pool);
    tank.blocks[1] = sph2d_block_default();
    tank.blocks[1].shape.kind = SPH2D_SHAPE_CIRCLE;
    tank.blocks[1].shape.circle = (sph2d_circle){{0.5, bottom + 0.1}, 0.1};
    tank.blocks[2] = test_particle(DX, 0.15, 0.55, -0.5, 1);
    tank.scene.block_count = 3;
    tank_start();
    sph2d_view f = sph2d_sim_fluid(tank.sim);
    double y[TANK_MOST], speed = 0, meets = 0.9 * sqrt(2 * (bottom - pool - 3.2 * DX) / G);
    double impact = sqrt(2 * G * (bottom + 0.1 - pool)); /* of its middle */
    size_t count = f.count, flying = 0;
    ck_assert_uint_lt(count, TANK_MOST);
    for (size_t i = 0; i < count; ++i)
        y[f.id[i]] = f.y[i];
    /* Densities at the corners of the drop go to their sums, as far as the pool pays for it. */
    const double off = both[_i] == SPH2D_METHOD_PCISPH ? 1e-12 : 0.01;
    while (sph2d_sim_time(tank.sim) < meets) { /* free fall, to round-off */
        test_steps(tank.sim, 1);
        double t = sph2d_sim_time(tank.sim);
        f = sph2d_sim_fluid(tank.sim);
        flying = 0;
        for (size_t i = 0; i < count; ++i) {
            double start_y = y[f.id[i]];
            if (start_y < pool)
                continue;
            bool alone = f.x[i] < 0.3;
            ++flying;
            ck_assert_double_eq_tol(f.vx[i], alone ? -0.5 : 0, off);
            ck_assert_double_eq_tol(f.vy[i], (alone ? 1 : 0) - G * t, off);
            ck_assert_double_eq_tol(f.y[i], start_y + (alone ? t : 0) - G * t * t / 2, off);
        }
    }
    ck_assert_uint_gt(flying, 70);
    speed = tank_run_until(0.8).fastest;
    ck_assert_double_gt(speed, 0.9 * impact);
    ck_assert_double_le(speed, 1.5 * impact);
    ck_assert_uint_eq(sph2d_sim_fluid(tank.sim).count, count);
}
END_TEST

/* ---- jets -------------------------------------------------------------------------------------------------------- */

static double turn(sph2d_vec2 a, sph2d_vec2 b, sph2d_vec2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/** Targets of jets: a line, a corner that points down, a knife edge. */
enum { LINE, CORNER, KNIFE, TARGETS };

START_TEST(no_jet_passes_a_thin_wall)
{
    static const sph2d_vec2 points[TARGETS][3] = {
        [LINE] = {{0, 0.3}, {1, 0.3}}, [CORNER] = {{0, 0.6}, {0.5, 0.15}, {1, 0.6}}, [KNIFE] = {{0.5, 0}, {0.5, 0.4}}};
    static const size_t counts[TARGETS] = {2, 3, 2};
    static sph2d_vec2 last[TANK_MOST];
    int target = _i % TARGETS;
    const double speed = 10 * sqrt(G * 0.3);
    const sph2d_method method = both[_i / TARGETS];
    tank_empty(method, DX, 1, 1, 1e-3);
    tank.obstacle = sph2d_obstacle_default();
    tank.obstacle.shape.kind = SPH2D_SHAPE_POLYLINE;
    tank.obstacle.shape.points = (sph2d_points){points[target], counts[target]};
    tank.scene.obstacles = &tank.obstacle;
    tank.scene.obstacle_count = 1;
    tank_add(0.45, 0.46, 0.55, 0.96);
    tank.blocks[0].velocity = (sph2d_vec2){0.1 * speed, -speed};
    tank_start();
    sph2d_view f = sph2d_sim_fluid(tank.sim);
    size_t count = f.count;
    for (size_t i = 0; i < count; ++i)
        last[f.id[i]] = (sph2d_vec2){f.x[i], f.y[i]};
    double most = 0;
    while (sph2d_sim_time(tank.sim) < 0.04) {
        test_steps(tank.sim, 1);
        most = fmax(most, tank_fastest());
        f = sph2d_sim_fluid(tank.sim);
        for (size_t i = 0; i < f.count; ++i) {
            sph2d_vec2 q = {f.x[i], f.y[i]}, *p = &last[f.id[i]];
            ck_assert(q.x > 0 && q.x < 1 && q.y > 0);
            for (size_t k = 0; k + 1 < counts[target]; ++k) {
                sph2d_vec2 a = points[target][k], b = points[target][k + 1];
                ck_assert_msg(turn(a, b, *p) * turn(a, b, q) >= 0 || turn(*p, q, a) * turn(*p, q, b) >= 0,
                              "from (%g, %g) to (%g, %g)", p->x, p->y, q.x, q.y);
            }
            *p = q;
        }
    }
    ck_assert_double_gt(most, speed);
    ck_assert_double_le(most, 3 * speed);
    /* Walls let it be compressed by 5.4 % in the corner; 7.1 % in the worst of 20 jets at 10 to 25 m/s, at other places.
     * speed/c0 is 0.1, which a step of method constraint ends beyond. */
    ck_assert_double_le(sph2d_sim_summary(tank.sim).compression_max, method == SPH2D_METHOD_PCISPH ? 0.1 : 0.19);
}
END_TEST

/* ---- too much liquid --------------------------------------------------------------------------------------------- */

START_TEST(liquid_inside_the_floor_is_let_out_gently)
{
    /* A lattice half a spacing too low: its first row is on the floor. The sound speed is that of 1 % for method
     * constraint; pcisph, which corrects within one step what it can, needs a soft liquid. */
    const double H = 0.3;
    tank_empty(both[_i], DX, H, 0.6, 1e-3);
    tank.scene.method.sound_speed = both[_i] == SPH2D_METHOD_PCISPH ? sqrt(20 * G * H) : sqrt(200 * G * H);
    for (int i = 0; i < 225; ++i)
        tank.particles[i] = (sph2d_particle){(i % 15 + 0.5) * DX, (i / 15 + 1e-4) * DX, 0, 0, 1000, 0};
    tank.scene.particles = (sph2d_particles){NULL, tank.particles, 225};
    tank_start();
    if (both[_i] == SPH2D_METHOD_PCISPH) /* the other takes the density that it is given */
        ck_assert_double_gt(sph2d_sim_summary(tank.sim).compression_max, 0.25);
    ck_assert_double_lt(tank_run_until(1).fastest, sqrt(2 * G * H));
    sph2d_summary s = sph2d_sim_summary(tank.sim);
    ck_assert_uint_eq(s.particles, 225);
    ck_assert_double_lt(s.kinetic, 0.01 * 225 * 0.4 * G * H / 2);
}
END_TEST

START_TEST(a_source_into_a_full_box_finds_no_room)
{
    const double H = 0.3;
    tank_empty(both[_i], DX, H, H, 1e-3);
    tank.scene.boundary.top = SPH2D_SIDE_WALL;
    tank_add(0, 0, H, H);
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){H / 2, 0.7 * H};
    source.width = 0.08;
    source.speed = 1;
    tank.scene.sources = &source;
    tank.scene.source_count = 1;
    tank_start();
    tank_span s = tank_run_until(2);
    sph2d_summary sum = sph2d_sim_summary(tank.sim);
    ck_assert_double_lt(s.fastest, 2 * sqrt(G * H));
    ck_assert_double_lt(sum.compression_max, 0.1);
    ck_assert_uint_eq(sum.particles, 225 + sum.fed);
    ck_assert_uint_le(sum.fed, 4); /* where two particles happen to be far apart */
    ck_assert_uint_gt(sum.blocked, 300);
    ck_assert(tank_is_finite());
}
END_TEST

/* The pressure of a step is found for the particles that are there then: a tank that starts empty, is fed and drained.
 */
START_TEST(what_comes_and_goes_is_pressed_like_the_rest)
{
    tank_empty(both[_i], DX, 1, 1, 1e-3);
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){0.5, 0.8};
    source.width = 0.2;
    source.speed = 3;
    tank.scene.sources = &source;
    tank.scene.source_count = 1;
    sph2d_drain drain = sph2d_drain_default();
    drain.shape.kind = SPH2D_SHAPE_BOX;
    drain.shape.box = (sph2d_box){{0, 0}, {0.2, 0.1}};
    tank.scene.drains = &drain;
    tank.scene.drain_count = 1;
    tank.scene.method.sound_speed = 60;
    tank_start();
    double fastest = 0;
    while (sph2d_sim_time(tank.sim) < 0.6) {
        test_steps(tank.sim, 1);
        fastest = fmax(fastest, sph2d_sim_summary(tank.sim).speed_max);
    }
    sph2d_summary sum = sph2d_sim_summary(tank.sim);
    ck_assert_uint_gt(sum.fed, 700);
    ck_assert_uint_gt(sum.drained, 50);
    ck_assert_uint_eq(sum.particles + sum.drained + sum.left_open[3], sum.fed); /* the top is open */
    ck_assert_double_lt(fastest, 2.5 * sqrt(3 * 3 + 2 * G * 0.8));
    ck_assert_double_lt(sum.compression_p99, 0.03);
    tank_finish();
}
END_TEST

Suite *suite_impacts(void)
{
    Suite *suite = suite_create("impacts");
    TCase *cases = tcase_create("impacts");
    tcase_add_checked_fixture(cases, NULL, tank_finish);
    tcase_add_loop_test(cases, liquid_inside_the_floor_is_let_out_gently, 0, 2);
    tcase_add_loop_test(cases, a_source_into_a_full_box_finds_no_room, 0, 2);
    tcase_add_loop_test(cases, what_comes_and_goes_is_pressed_like_the_rest, 0, 2);
    suite_add_tcase(suite, cases);
    TCase *slow = test_long(suite);
    tcase_add_checked_fixture(slow, NULL, tank_finish);
    tcase_add_loop_test(slow, a_drop_falls_freely_and_splashes_no_faster_than_it_came, 0, 2);
    tcase_add_loop_test(slow, no_jet_passes_a_thin_wall, 0, TARGETS * 2);
    return suite;
}
