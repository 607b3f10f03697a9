/* SPDX-License-Identifier: MIT */
/** @file test_sources.c
 *  What comes and goes: sources feed even jets (rows one spacing apart, mass per time = density * rate), drains and
 *  open sides take and count, and the ledger closes at every step. */
#include <math.h>
#include <string.h>

#include "common.h"

static const double DX = 0.01;

static sph2d_sim *with_source(const sph2d_source *source, const sph2d_drain *drain)
{
    sph2d_scene scene = test_open_scene(DX, -2, -2, 2, 2);
    scene.method.artificial_viscosity = 1e-30; /* velocities stay as they are fed */
    scene.run.max_energy_rise = 1;             /* which makes some where the jet is wider than it is fed */
    scene.sources = source;
    scene.source_count = 1;
    scene.drains = drain;
    scene.drain_count = drain != NULL;
    return test_create(&scene, NULL);
}

static sph2d_source jet(double width, double speed)
{
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){-0.3, 0.2};
    source.direction = (sph2d_vec2){30, -40}; /* of any length */
    source.width = width;
    source.speed = speed;
    return source;
}

static void run_until(sph2d_sim *sim, double time)
{
    while (sph2d_sim_time(sim) < time)
        test_steps(sim, 1);
}

/* ---- the jet ----------------------------------------------------------------------------------------------------- */

START_TEST(a_jet_is_a_lattice_that_moves)
{
    /* Ids count along the rows; row r left the nozzle at r interval, columns are centred on it. */
    static const struct {
        int columns;
        double rate; /**< over width * speed */
    } cases[] = {{1, 1}, {4, 1}, {5, 0.5}};
    int columns = cases[_i].columns;
    double speed = 2, interval = DX / speed / cases[_i].rate;
    sph2d_source source = jet(columns * DX, speed);
    source.rate = cases[_i].rate < 1 ? cases[_i].rate * source.width * speed : 0;
    sph2d_sim *sim = with_source(&source, NULL);
    double worst = 0, fed_at = 0;
    for (int n = 0; n < 300; ++n) {
        fed_at = sph2d_sim_time(sim);
        test_steps(sim, 1);
        double t = sph2d_sim_time(sim);
        sph2d_view f = sph2d_sim_fluid(sim);
        size_t rows = (size_t)floor(fed_at / interval * (1 + 1e-12)) + 1;
        ck_assert_uint_eq(f.count, rows * (size_t)columns);
        for (size_t i = 0; i < f.count; ++i) {
            double along = (f.x[i] - source.at.x) * 0.6 - (f.y[i] - source.at.y) * 0.8;
            double across = fabs((f.x[i] - source.at.x) * 0.8 + (f.y[i] - source.at.y) * 0.6);
            double row = (double)(f.id[i] / (uint64_t)columns), column = (double)(f.id[i] % (uint64_t)columns);
            worst = fmax(worst, fabs(along - speed * (t - row * interval)));
            worst = fmax(worst, fabs(across - fabs(column - (columns - 1) / 2.0) * DX));
            worst = fmax(worst, hypot(f.vx[i] - 1.2, f.vy[i] + 1.6));
        }
    }
    ck_assert_double_le(worst, 1e-9);
    sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert_uint_gt(sum.fed, 20);
    ck_assert_uint_eq(sum.fed, sum.particles);
    ck_assert_uint_eq(sum.blocked, 0);
    /* Mass per time: the rows fed cover their time, to one row. */
    double mass = (double)sum.fed * sph2d_sim_plan(sim)->particle_mass, row_mass = columns * 1000 * DX * DX;
    double wanted = 1000 * cases[_i].rate * source.width * speed * fed_at;
    ck_assert_double_ge(mass, wanted);
    ck_assert_double_le(mass, wanted + row_mass * (1 + 1e-9));
    ck_assert_double_eq_tol(sum.energy_fed / (mass * speed * speed / 2), 1, 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(the_default_rate_is_width_times_speed)
{
    /* Also where the width is no whole number of spacings. */
    static const double widths[] = {0.3, 1, 2.6, 3.4, 7};
    double width = widths[_i] * DX, carried = fmax(width, DX); /* at least one particle */
    sph2d_source source = jet(width, 2);
    sph2d_sim *sim = with_source(&source, NULL);
    run_until(sim, 0.5);
    sph2d_summary sum = sph2d_sim_summary(sim);
    double area = (double)(sum.fed + sum.blocked) * DX * DX;
    ck_assert_double_eq_tol(area / (carried * 2 * 0.5), 1, 0.03);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(direction_points_down_and_one_particle_is_the_least)
{
    sph2d_source source = sph2d_source_default();
    source.speed = 1;
    sph2d_sim *sim = with_source(&source, NULL);
    test_steps(sim, 1);
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 1);
    ck_assert(f.vx[0] == 0 && f.vy[0] == -1 && f.x[0] == 0);
    ck_assert_double_eq_tol(f.y[0], -sph2d_sim_time(sim), 1e-15);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(start_and_stop_are_kept)
{
    sph2d_source source = jet(3 * DX, 1);
    source.start = 0.1;
    source.stop = 0.25;
    sph2d_sim *sim = with_source(&source, NULL);
    while (sph2d_sim_time(sim) < 0.4) {
        double t = sph2d_sim_time(sim); /* of feeding: rows due at 0.10, 0.11 ... 0.24 */
        test_steps(sim, 1);
        double rows = t * (1 + 1e-12) < 0.1 ? 0 : fmin(floor((t - 0.1) / 0.01 + 1e-9) + 1, 15);
        ck_assert_uint_eq(sph2d_sim_fluid(sim).count, 3 * (size_t)rows);
    }
    ck_assert_uint_eq(sph2d_sim_summary(sim).fed, 45);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Velocities of the first row of a wide jet with spread, by column. */
static void first_row(uint64_t seed, sph2d_vec2 out[80])
{
    sph2d_source source = jet(80 * DX, 2);
    source.spread = 0.25;
    source.seed = seed;
    sph2d_sim *sim = with_source(&source, NULL);
    test_steps(sim, 1); /* alone, a row has no pressure: its velocities are those it was fed with */
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 80);
    for (size_t i = 0; i < f.count; ++i)
        out[f.id[i]] = (sph2d_vec2){f.vx[i], f.vy[i]};
    sph2d_sim_destroy(sim);
}

START_TEST(spread_is_random_bounded_and_from_the_seed)
{
    sph2d_vec2 a[80], b[80], other[80];
    first_row(1, a);
    first_row(1, b);
    first_row(2, other);
    ck_assert_mem_eq(a, b, sizeof a);
    double low = 0, high = 0, mean = 0, product = 0, same = 0, drawn[160];
    for (int i = 0; i < 80; ++i) {
        double x = (a[i].x - 1.2) / 0.5, y = (a[i].y + 1.6) / 0.5; /* in units of spread * speed */
        low = fmin(low, fmin(x, y));
        high = fmax(high, fmax(x, y));
        mean += (x + y) / 160;
        product += x * y / 80;
        same += a[i].x == other[i].x;
        drawn[2 * i] = x;
        drawn[2 * i + 1] = y;
    }
    for (int i = 0; i < 160; ++i) /* every number is a new one */
        for (int j = 0; j < i; ++j)
            same += fabs(drawn[i] - drawn[j]) < 1e-9;
    ck_assert(low >= -1 && low < -0.9 && high <= 1 && high > 0.9);
    ck_assert_double_le(fabs(mean), 0.15);    /* of 160 uniform numbers: 0.046 */
    ck_assert_double_le(fabs(product), 0.15); /* the components are independent: 0.037 */
    ck_assert(same == 0);
}
END_TEST

START_TEST(each_source_is_its_own)
{
    sph2d_scene scene = test_open_scene(DX, -2, -2, 2, 2);
    sph2d_source sources[2] = {jet(2 * DX, 1), jet(3 * DX, 2)};
    sources[1].at = (sph2d_vec2){1, 1};
    sources[1].direction = (sph2d_vec2){0, 1};
    sources[1].start = 0.05;
    scene.sources = sources;
    scene.source_count = 2;
    sph2d_sim *sim = test_create(&scene, NULL);
    run_until(sim, 0.2);
    double t = sph2d_sim_time(sim);
    sph2d_view f = sph2d_sim_fluid(sim);
    size_t first = 0, second = 0;
    for (size_t i = 0; i < f.count; ++i)
        if (f.x[i] < 0.5) {
            first += hypot(f.vx[i] - 0.6, f.vy[i] + 0.8) < 1e-9;
        } else {
            second += hypot(f.vx[i], f.vy[i] - 2) < 1e-9 && f.y[i] < 1 + 2 * (t - 0.05) + 1e-9;
        }
    ck_assert_uint_eq(first + second, f.count);
    ck_assert_uint_ge(first, 2 * 20);
    ck_assert_uint_le(first, 2 * 22);
    ck_assert_uint_ge(second, 3 * 30);
    ck_assert_uint_le(second, 3 * 32);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- no room ----------------------------------------------------------------------------------------------------- */

START_TEST(taken_places_are_counted_and_stay_empty)
{
    /* A closed box full of liquid at rest, and a nozzle in the middle of it. */
    sph2d_scene scene = test_scene(DX, 0, 0, 0.3, 0.3);
    sph2d_block block = test_block(0, 0, 0.3, 0.3);
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){0.15, 0.15};
    source.width = 6 * DX;
    source.speed = 1;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.sources = &source;
    scene.source_count = 1;
    scene.fluid.dynamic_viscosity = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    double fed_at = 0;
    while (sph2d_sim_time(sim) < 0.2) {
        fed_at = sph2d_sim_time(sim);
        test_steps(sim, 1);
    }
    sph2d_summary sum = sph2d_sim_summary(sim);
    uint64_t places = 6 * ((uint64_t)floor(fed_at / 0.01 + 1e-9) + 1);
    ck_assert_uint_eq(sum.fed + sum.blocked, places);
    ck_assert_uint_ge(sum.blocked, places - 6);
    ck_assert_uint_eq(sum.particles, 900 + sum.fed);
    ck_assert_double_lt(sum.compression_max, 0.1);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(walls_take_places_too)
{
    /* A nozzle 8 wide over a line, and half outside the domain: where there is no room, nothing is fed. */
    sph2d_scene scene = test_scene(DX, 0, 0, 1, 1);
    sph2d_vec2 line[2] = {{0.03, 0.5}, {0.3, 0.5}};
    sph2d_obstacle obstacle = sph2d_obstacle_default();
    obstacle.shape.kind = SPH2D_SHAPE_LINE;
    obstacle.shape.points = (sph2d_points){line, 2};
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){0, 0.5};
    source.width = 8 * DX;
    source.speed = 1;
    source.stop = 1e-6; /* one row */
    scene.obstacles = &obstacle;
    scene.obstacle_count = 1;
    scene.sources = &source;
    scene.source_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    test_steps(sim, 2);
    sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert_uint_eq(sum.fed + sum.blocked, 8); /* columns at x = -3.5 dx ... 3.5 dx; the line begins at 3 dx */
    ck_assert_uint_eq(sum.fed, 2);
    sph2d_view f = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < f.count; ++i)
        ck_assert(f.x[i] > 0 && f.x[i] < 1.6 * DX);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- drains and open sides --------------------------------------------------------------------------------------- */

START_TEST(a_drain_takes_what_is_in_it_while_it_is_open)
{
    sph2d_source source = jet(3 * DX, 2);
    sph2d_drain drain = sph2d_drain_default();
    drain.shape.kind = SPH2D_SHAPE_CIRCLE; /* across the jet, 0.2 m from the nozzle */
    drain.shape.circle = (sph2d_circle){{-0.3 + 0.2 * 0.6, 0.2 - 0.2 * 0.8}, 0.05};
    drain.start = 0.3;
    drain.stop = 0.5;
    sph2d_sim *sim = with_source(&source, &drain);
    while (sph2d_sim_time(sim) < 0.6) {
        double t = sph2d_sim_time(sim);
        sph2d_summary before = sph2d_sim_summary(sim);
        sph2d_view f = sph2d_sim_fluid(sim);
        size_t inside = 0;
        for (size_t i = 0; i < f.count; ++i)
            inside += hypot(f.x[i] - drain.shape.circle.center.x, f.y[i] - drain.shape.circle.center.y) < 0.05;
        test_steps(sim, 1);
        uint64_t taken = sph2d_sim_summary(sim).drained - before.drained;
        if (t < 0.3 || t >= 0.5)
            ck_assert_uint_eq(taken, 0);
        else
            ck_assert_uint_eq(taken, inside);
    }
    sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert_uint_ge(sum.drained, 3 * 40); /* what flows through in 0.2 s, and what was there */
    ck_assert_uint_le(sum.drained, 3 * 52);
    ck_assert_uint_eq(sum.particles, sum.fed - sum.drained);
    double mass = 1000 * DX * DX; /* what is there brought its energy, what is gone took it */
    ck_assert_double_eq_tol(sum.energy_fed / ((double)sum.particles * mass * 2), 1, 1e-9);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(open_sides_count_what_is_a_domain_away)
{
    /* Left, right, bottom, top, with a domain of 0.4 by 0.2. */
    static const sph2d_vec2 directions[4] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    sph2d_vec2 v = directions[_i];
    sph2d_scene scene = test_open_scene(DX, 0, 0, 0.4, 0.2);
    sph2d_block block = test_particle(DX, 0.2, 0.1, v.x, v.y);
    scene.blocks = &block;
    scene.block_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    double limit = _i < 2 ? 0.2 + 0.4 : 0.1 + 0.2; /* to the side, and once more the domain */
    while (sph2d_sim_time(sim) < limit) {
        ck_assert_uint_eq(sph2d_sim_fluid(sim).count, 1);
        test_steps(sim, 1);
    }
    test_steps(sim, 2);
    sph2d_summary sum = sph2d_sim_summary(sim);
    ck_assert_uint_eq(sum.particles, 0);
    for (int k = 0; k < 4; ++k)
        ck_assert_uint_eq(sum.left_open[k], k == _i);
    test_steps(sim, 3); /* an empty simulation goes on */
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(the_ledger_closes_at_every_step)
{
    sph2d_scene scene = test_scene(DX, 0, 0, 0.5, 0.4);
    scene.boundary.right = SPH2D_SIDE_OPEN;
    scene.boundary.bottom = SPH2D_SIDE_OPEN;
    scene.gravity.y = -9.81;
    sph2d_block block = test_block(0.05, 0.05, 0.25, 0.25);
    sph2d_source sources[2] = {sph2d_source_default(), sph2d_source_default()};
    sources[0].at = (sph2d_vec2){0.3, 0.3};
    sources[0].width = 5 * DX;
    sources[0].speed = 3;
    sources[0].spread = 0.2;
    sources[1].at = (sph2d_vec2){0.15, 0.2}; /* into the block */
    sources[1].speed = 1;
    sph2d_drain drain = sph2d_drain_default();
    drain.shape.kind = SPH2D_SHAPE_BOX;
    drain.shape.box = (sph2d_box){{0.1, -0.1}, {0.2, 0.1}};
    scene.blocks = &block;
    scene.block_count = 1;
    scene.sources = sources;
    scene.source_count = 2;
    scene.drains = &drain;
    scene.drain_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    size_t wrong = 0, duplicates = 0;
    for (int n = 0; n < 600; ++n) {
        test_steps(sim, 1);
        sph2d_summary s = sph2d_sim_summary(sim);
        uint64_t left = s.left_open[0] + s.left_open[1] + s.left_open[2] + s.left_open[3];
        wrong += s.particles != 400 + s.fed - s.drained - left || s.particles != sph2d_sim_fluid(sim).count;
    }
    static bool met[20000];
    sph2d_view f = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < f.count; ++i) {
        ck_assert_uint_lt(f.id[i], sizeof met);
        duplicates += met[f.id[i]];
        met[f.id[i]] = true;
    }
    ck_assert_uint_eq(wrong + duplicates, 0);
    sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert(s.fed > 0 && s.blocked > 0 && s.drained > 0 && s.left_open[2] > 0);
    ck_assert(s.left_open[0] == 0 && s.left_open[3] == 0);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_sources(void)
{
    Suite *suite = suite_create("sources");
    TCase *tests = tcase_create("sources");
    tcase_add_loop_test(tests, a_jet_is_a_lattice_that_moves, 0, 3);
    tcase_add_test(tests, direction_points_down_and_one_particle_is_the_least);
    tcase_add_test(tests, start_and_stop_are_kept);
    tcase_add_test(tests, spread_is_random_bounded_and_from_the_seed);
    tcase_add_test(tests, each_source_is_its_own);
    tcase_add_test(tests, taken_places_are_counted_and_stay_empty);
    tcase_add_test(tests, walls_take_places_too);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_loop_test(slow, the_default_rate_is_width_times_speed, 0, 5);
    TCase *losses = tcase_create("losses");
    tcase_add_test(losses, a_drain_takes_what_is_in_it_while_it_is_open);
    tcase_add_loop_test(losses, open_sides_count_what_is_a_domain_away, 0, 4);
    tcase_add_test(losses, the_ledger_closes_at_every_step);
    suite_add_tcase(suite, losses);
    return suite;
}
