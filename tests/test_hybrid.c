/* SPDX-License-Identifier: MIT */
/** @file test_hybrid.c
 *  Method `hybrid`: flows with exact solutions, what is kept, what walls and pockets do, its solver, the same bits. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "boundary/rigid.h"
#include "methods/hybrid/grid.h"
#include "tank.h"

static const double RHO0 = 1000;

/** A tank of water without viscosity, as in tank.h, with liquid of a depth from one side to the other. */
static void basin(double width, double depth)
{
    tank_empty(SPH2D_METHOD_HYBRID, DX, width, 2 * depth, 0);
    tank_add(0, 0, width, depth);
}

/** A square [0, 1]^2 that is periodic in both directions, full of liquid, without gravity. */
static void full_square(double viscosity)
{
    tank_empty(SPH2D_METHOD_HYBRID, DX, 1, 1, viscosity);
    tank.scene.gravity.y = 0;
    tank.scene.boundary =
        (sph2d_boundary){SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
    tank_add(0, 0, 1, 1);
}

static void run_until(double time)
{
    while (sph2d_sim_time(tank.sim) < time)
        test_steps(tank.sim, 1);
}

/** Moves the obstacle along x for 2 s [m/s]. */
static void push(double speed)
{
    static sph2d_pose_point points[2];
    points[0] = (sph2d_pose_point){0, 0, 0, 0};
    points[1] = (sph2d_pose_point){2, 2 * speed, 0, 0};
    tank.obstacle.motion = sph2d_motion_default();
    tank.obstacle.motion.path = (sph2d_pose_path){points, 2};
}

/** Amplitude of the mode 2 pi x/length of the surface, by the moment of the liquid. */
static double mode_of(double length)
{
    sph2d_view f = sph2d_sim_fluid(tank.sim);
    double sum = 0;
    for (size_t i = 0; i < f.count; ++i)
        sum += cos(2 * TEST_PI * f.x[i] / length);
    return 2 * sum * DX * DX / length;
}

/* ---- known motions ----------------------------------------------------------------------------------------------- */

START_TEST(free_liquid_falls_on_a_parabola)
{
    tank_empty(SPH2D_METHOD_HYBRID, DX, 2, 2, 0);
    tank_add(0.3, 1.4, 0.7, 1.8);
    tank.blocks[0].velocity = (sph2d_vec2){2, 0.5};
    tank_start();
    const double before = tank_middle();
    run_until(0.3);
    const double t = sph2d_sim_time(tank.sim);
    sph2d_summary s = sph2d_sim_summary(tank.sim);
    const double step = t / (double)s.steps; /* moved by the new velocities, it is half a step ahead */
    ck_assert_double_eq_tol(tank_middle(), before + 0.5 * t - G * t * (t + step) / 2, 2e-4);
    const double mass = tank.sim->system.mass * (double)s.particles;
    ck_assert_double_eq_tol(s.momentum[0], mass * 2, 1e-5 * mass);
    ck_assert_double_eq_tol(s.momentum[1], mass * (0.5 - G * t), 1e-5 * mass);
    ck_assert_double_le(s.compression_p99, 0.05);
    tank_finish();
}
END_TEST

START_TEST(a_tank_comes_to_rest_at_its_level)
{
    basin(1, 0.5);
    tank.blocks[0].perturb.amplitude = 0.2;
    tank.blocks[0].perturb.seed = 1;
    tank_start();
    const double before = tank_middle();
    run_until(5);
    ck_assert_double_le(tank_fastest(), 0.025); /* 0.008 of sqrt(2 g h) */
    ck_assert_double_eq_tol(tank_middle(), before, 0.002);
    sph2d_view f = sph2d_sim_fluid(tank.sim);
    double worst = 0;
    for (size_t i = 0; i < f.count; ++i)
        worst = fmax(worst, fabs(f.pressure[i] - RHO0 * G * fmax(0.5 - f.y[i], 0)));
    ck_assert_double_le(worst, 0.075 * RHO0 * G * 0.5);
    ck_assert_double_le(sph2d_sim_summary(tank.sim).compression_p99, 0.03);
    tank_finish();
}
END_TEST

START_TEST(a_wave_keeps_its_period_and_height)
{
    /* omega^2 = g k tanh k d. */
    const double k = 2 * TEST_PI, period = 2 * TEST_PI / sqrt(G * k * tanh(k * 0.5));
    basin(1, 0.5);
    tank.scene.boundary.left = tank.scene.boundary.right = SPH2D_SIDE_PERIODIC;
    tank.blocks[0].start.flow = (sph2d_flow){SPH2D_FLOW_STANDING_WAVE, 0.2, 1, 0.5, {0, 0.5}};
    tank_start();
    double first = 0, last = 0;
    while (sph2d_sim_time(tank.sim) < 5.25 * period) {
        test_steps(tank.sim, 1);
        const double phase = sph2d_sim_time(tank.sim) / period, height = mode_of(1);
        first = fabs(phase - 0.25) < 0.1 ? fmax(first, fabs(height)) : first;
        last = fabs(phase - 5.25) < 0.1 ? fmax(last, fabs(height)) : last;
    }
    ck_assert_double_eq_tol(first * 2 * TEST_PI / (0.2 * period), 1, 0.1); /* speed over omega */
    ck_assert_double_ge(last / first, 0.78);                               /* 0.83: docs/notes/hybrid.md */
    ck_assert_double_le(last / first, 1);
    tank_finish();
}
END_TEST

START_TEST(viscosity_slows_a_shear_wave)
{
    /* u = sin(2 pi y) decays as exp(-nu k^2 t); the grid takes a part of what differs from its velocities. */
    const double nu = _i == 0 ? 0.02 : 2;
    full_square(RHO0 * nu);
    tank.scene.method.cfl = 0.2;
    tank.blocks[0].velocity = (sph2d_vec2){1, 0};
    tank_start();
    sph2d__store *f = &tank.sim->system.fluid;
    tank.sim->record.energy_low = tank.sim->record.error_low = INFINITY; /* what is written comes from nothing */
    for (size_t i = 0; i < f->count; ++i)
        f->vx[i] = sin(2 * TEST_PI * f->y[i]);
    const double time = 0.5 / (nu * 4 * TEST_PI * TEST_PI);
    double sum = 0;
    run_until(time);
    for (size_t i = 0; i < f->count; ++i)
        sum += 2 * f->vx[i] * sin(2 * TEST_PI * f->y[i]) / (double)f->count;
    const double t = sph2d_sim_time(tank.sim), steps = (double)tank.sim->record.steps;
    const double by_steps = pow(1 + nu * 4 * TEST_PI * TEST_PI * t / steps, -steps); /* implicit */
    ck_assert_double_eq_tol(log(sum) / log(by_steps), 1, 0.12);
    tank_finish();
}
END_TEST

/** Largest difference of the velocities from a profile between plates at y = 0 and 1. */
static double off_profile(double (*profile)(double y))
{
    sph2d_view f = sph2d_sim_fluid(tank.sim);
    double worst = 0;
    for (size_t i = 0; i < f.count; ++i)
        worst = fmax(worst, hypot(f.vx[i] - profile(f.y[i]), f.vy[i]));
    return worst;
}

static double of_plates(double y)
{
    return 4 * y * (1 - y);
}

static double of_a_belt(double y)
{
    return y;
}

START_TEST(walls_without_slip_hold_the_liquid)
{
    /* Driven by gravity, u = g y (1 - y)/(2 nu); drawn by the upper plate, u = y. */
    full_square(RHO0 * 1);
    tank.scene.boundary.bottom = tank.scene.boundary.top = SPH2D_SIDE_WALL;
    tank.scene.wall_slip = SPH2D_SLIP_NONE;
    tank.scene.gravity.x = _i == 0 ? 8 : 0;
    tank.scene.wall_speeds.top = _i == 0 ? 0 : 1;
    tank.scene.method.sound_speed = 10;
    tank_start();
    run_until(3);
    ck_assert_double_le(off_profile(_i == 0 ? of_plates : of_a_belt), 0.06);
    tank_finish();
}
END_TEST

/** Height of the highest particle between two places. */
static double top_of(double left, double right)
{
    sph2d_view f = sph2d_sim_fluid(tank.sim);
    double top = 0;
    for (size_t i = 0; i < f.count; ++i)
        if (f.x[i] >= left && f.x[i] < right)
            top = fmax(top, f.y[i]);
    return top;
}

START_TEST(thick_liquid_lies_level_between_walls)
{
    /* Walls without slip hold up nothing at rest: where viscosity acts on the forces that pressure balances, liquid of
     * 500 Pa s stands 4.6 spacings higher at them. */
    tank_empty(SPH2D_METHOD_HYBRID, DX, 1, 0.8, 500);
    tank_add(0, 0, 1, 0.4);
    tank.scene.wall_slip = SPH2D_SLIP_NONE;
    tank_start();
    run_until(2);
    const double middle = top_of(0.4, 0.6);
    ck_assert_double_eq_tol(top_of(0, 0.1), middle, DX / 2);
    ck_assert_double_eq_tol(top_of(0.9, 1), middle, DX / 2);
    ck_assert_double_eq_tol(middle, 0.4, DX);
    tank_finish();
}
END_TEST

START_TEST(vortices_between_periodic_sides_are_not_compressed)
{
    full_square(RHO0 * 0.01);
    tank.blocks[0].start.flow = (sph2d_flow){SPH2D_FLOW_TAYLOR_GREEN, 1, 1, 0, {0, 0}};
    tank.blocks[0].perturb.amplitude = 0.2;
    tank.scene.method.cfl = 0.3;
    tank_start();
    const double before = sph2d_sim_summary(tank.sim).kinetic;
    run_until(1);
    sph2d_summary s = sph2d_sim_summary(tank.sim);
    ck_assert_double_le(s.compression_p99, 0.04);
    ck_assert_double_le(hypot(s.momentum[0], s.momentum[1]), 0.02 * RHO0);
    const double exact = exp(-4 * 4 * TEST_PI * TEST_PI * 0.01 * sph2d_sim_time(tank.sim)); /* of the energy */
    ck_assert_double_ge(s.kinetic / before, 0.7 * exact);
    ck_assert_double_le(s.kinetic / before, 1.02 * exact);
    tank_finish();
}
END_TEST

START_TEST(tension_rounds_a_square_drop)
{
    const double radius = 0.5 / sqrt(TEST_PI);
    tank_empty(SPH2D_METHOD_HYBRID, DX, 2, 2, 50);
    tank.scene.gravity.y = 0;
    tank.scene.fluid.surface_tension = 50;
    tank_add(0.75, 0.75, 1.25, 1.25);
    tank_start();
    run_until(4);
    sph2d_view f = sph2d_sim_fluid(tank.sim);
    double least = INFINITY, most = 0; /* distance of the surface from the middle by direction */
    double middle_x = 0, middle_y = 0;
    for (size_t i = 0; i < f.count; ++i) {
        middle_x += f.x[i] / (double)f.count;
        middle_y += f.y[i] / (double)f.count;
    }
    for (int k = 0; k < 16; ++k) {
        double far = 0;
        for (size_t i = 0; i < f.count; ++i) {
            const double x = f.x[i] - middle_x, y = f.y[i] - middle_y, r = hypot(x, y);
            far = cos(atan2(y, x) - 2 * TEST_PI * k / 16) > cos(TEST_PI / 16) ? fmax(far, r) : far;
        }
        least = fmin(least, far + DX / 2);
        most = fmax(most, far + DX / 2);
    }
    ck_assert_double_ge(least, 0.95 * radius);
    ck_assert_double_le(most, 1.05 * radius);
    ck_assert_double_le(hypot(middle_x - 1, middle_y - 1), 0.1); /* it drifts: docs/notes/hybrid.md */
    const sph2d_summary s = sph2d_sim_summary(tank.sim);
    ck_assert_double_le(s.energy_rise, 0.02 * s.energy_start);
    tank_finish();
}
END_TEST

/* ---- walls ------------------------------------------------------------------------------------------------------- */

START_TEST(a_piston_raises_the_liquid)
{
    /* A plate that comes in from the left by 0.2 m takes 0.2 x 0.5 of 0.8 x 0.6 m^2. */
    basin(1, 0.5);
    tank.scene.domain.max.y = 1;
    tank.blocks[0] = test_block(0.1, 0, 1, 0.5);
    tank.obstacle = sph2d_obstacle_default();
    tank.obstacle.shape.kind = SPH2D_SHAPE_BOX;
    tank.obstacle.shape.box = (sph2d_box){{0, 0}, {0.1, 1}};
    push(0.2);
    tank.scene.obstacles = &tank.obstacle;
    tank.scene.obstacle_count = 1;
    tank_start();
    const double before = tank_middle();
    run_until(1);
    const double width = 0.9 - 0.2 * sph2d_sim_time(tank.sim);
    ck_assert_double_eq_tol(tank_middle() / before, 0.9 / width, 0.03);
    ck_assert_double_le(sph2d_sim_summary(tank.sim).compression_p99, 0.03);
    ck_assert_uint_eq(sph2d_sim_summary(tank.sim).particles, tank.sim->record.next_id);
    sph2d_view f = sph2d_sim_fluid(tank.sim);
    for (size_t i = 0; i < f.count; ++i)
        ck_assert_double_ge(f.x[i], 1 - width);
    tank_finish();
}
END_TEST

START_TEST(a_piston_pays_for_what_it_lifts)
{
    /* A floor that rises between the sides, at any height among the squares, and stops: m g h, and nothing leaks beside it.
     * It starts at once, at 0.2 m/s: m v more, at v. */
    basin(1, 0.5);
    tank.scene.domain.max.y = 1;
    if (_i) /* between periodic sides, at which its ends meet */
        tank.scene.boundary.left = tank.scene.boundary.right = SPH2D_SIDE_PERIODIC;
    tank.blocks[0] = test_block(0, 0.1, 1, 0.5);
    tank.obstacle = sph2d_obstacle_default();
    tank.obstacle.shape.kind = SPH2D_SHAPE_BOX;
    tank.obstacle.shape.box = (sph2d_box){{0, 0}, {1, 0.1}};
    static sph2d_pose_point path[] = {{0, 0, 0, 0}, {0.2, 0, 0, 0}, {1.2, 0, 0.2, 0}, {2, 0, 0.2, 0}};
    tank.obstacle.motion.path = (sph2d_pose_path){path, 4};
    tank.scene.obstacles = &tank.obstacle;
    tank.scene.obstacle_count = 1;
    tank_start();
    run_until(2);
    const sph2d_summary s = sph2d_sim_summary(tank.sim);
    const double lifted = 1000 * 0.4 * G * 0.2, set_in_motion = 1000 * 0.4 * 0.2 * 0.2;
    ck_assert_double_eq_tol(s.energy_walls, lifted + set_in_motion, 0.01 * lifted);
    ck_assert_double_le(fabs(s.energy_error), 0.02 * lifted);
    ck_assert_double_le(s.speed_max, 0.05);
    ck_assert_double_le(s.compression_p99, 0.025);
    tank_finish();
}
END_TEST

START_TEST(liquid_is_held_by_a_circle)
{
    basin(1, 0.5);
    tank.obstacle = sph2d_obstacle_default();
    tank.obstacle.shape.kind = SPH2D_SHAPE_CIRCLE;
    tank.obstacle.shape.circle = (sph2d_circle){{0.5, 0.25}, 0.1};
    tank.scene.obstacles = &tank.obstacle;
    tank.scene.obstacle_count = 1;
    tank_start();
    run_until(3);
    ck_assert_double_le(tank_fastest(), 0.03);
    ck_assert_double_le(sph2d_sim_summary(tank.sim).compression_max, 0.15);
    tank_finish();
}
END_TEST

/* Between boxes a tenth of a spacing apart, above and below the surface, there is neither liquid nor a sink. */
START_TEST(a_slit_is_no_channel)
{
    sph2d_obstacle boxes[2] = {sph2d_obstacle_default(), sph2d_obstacle_default()};
    basin(1, 0.4);
    for (int k = 0; k < 2; ++k)
        boxes[k].shape.kind = SPH2D_SHAPE_BOX;
    boxes[0].shape.box = (sph2d_box){{0.3, 0.15}, {0.5, 0.95}};
    boxes[1].shape.box = (sph2d_box){{0.5 + 0.1 * DX, 0.15}, {0.7, 0.95}};
    tank.scene.domain.max.y = 1;
    tank.scene.obstacles = boxes;
    tank.scene.obstacle_count = 2;
    tank_start();
    run_until(3);
    ck_assert_double_le(sph2d_sim_summary(tank.sim).compression_p99, 0.02);
    ck_assert_double_le(tank_fastest(), 0.1);
    tank_finish();
}
END_TEST

/* A slot of 2 and of 4 spacings between boxes, one of 2 beside a side, a wedge, and boxes that touch. */
START_TEST(a_narrow_channel_is_told)
{
    static const double slots[][2] = {{0.4, 0.4 + 2 * DX}, {0.4, 0.4 + 4 * DX}, {2 * DX, 1}, {0.4, 0.4}};
    static sph2d_vec2 wedge[] = {{0, 0}, {0.5, 0}, {0, 0.5}};
    sph2d_obstacle boxes[2] = {sph2d_obstacle_default(), sph2d_obstacle_default()};
    basin(1, 0.4);
    for (int k = 0; k < 2; ++k) {
        boxes[k].shape.kind = SPH2D_SHAPE_BOX;
        boxes[k].shape.box = (sph2d_box){{0, 0.5}, {slots[_i % 4][0], 0.6}};
    }
    boxes[1].shape.box = (sph2d_box){{slots[_i % 4][1], 0.5}, {1, 0.6}};
    if (_i == 2)
        boxes[0].shape.box.min.x = slots[2][0], boxes[0].shape.box.max.x = 1;
    if (_i == 4) {
        boxes[0].shape.kind = SPH2D_SHAPE_POLYGON;
        boxes[0].shape.points = (sph2d_points){wedge, 3};
    }
    tank.scene.domain.max.y = 1;
    tank.scene.block_count = 0;
    tank_add(0.6, 0.7, 0.9, 0.9);
    tank.scene.obstacles = boxes;
    tank.scene.obstacle_count = _i == 2 || _i == 4 ? 1 : 2;
    sph2d_report report = {0};
    ck_assert_int_eq(sph2d_scene_check(&tank.scene, &report), SPH2D_OK);
    bool told = false;
    for (size_t k = 0; k < report.count; ++k)
        told |= strcmp(report.items[k].path, "spacing") == 0;
    ck_assert_int_eq(told, _i == 0 || _i == 2);
    sph2d_report_clear(&report);
}
END_TEST

START_TEST(drops_cross_several_spacings_in_a_step)
{
    /* 16 m/s at 0.9 H sqrt(2 head)^-1, against a floor: nobody is behind it. */
    basin(1, 0.2);
    tank.scene.domain.max.y = 1;
    tank_add(0.45, 0.6, 0.55, 0.7);
    tank.blocks[1].velocity = (sph2d_vec2){0, -4};
    tank_start();
    const uint64_t all = sph2d_sim_summary(tank.sim).particles;
    run_until(1);
    sph2d_summary s = sph2d_sim_summary(tank.sim);
    ck_assert_uint_eq(s.particles, all);
    ck_assert_double_le(s.kinetic + s.potential, s.energy_start * 1.002);
    ck_assert_double_le(s.energy_rise, 0.005 * s.energy_scale);
    tank_finish();
}
END_TEST

START_TEST(a_step_is_refused_in_which_liquid_falls_further_than_it_looks)
{
    basin(1, 0.2);
    tank.scene.method.time_step = 0.05;
    sph2d_sim *sim = NULL;
    sph2d_report report = {0};
    ck_assert_int_eq(sph2d_sim_create(&tank.scene, NULL, &sim, &report), SPH2D_SCENE);
    ck_assert(test_report_has(&report, SPH2D_CODE_STEP_TOO_LARGE, "method.time_step"));
    sph2d_report_clear(&report);
}
END_TEST

START_TEST(a_source_fills_what_was_empty)
{
    tank_empty(SPH2D_METHOD_HYBRID, DX, 1, 1, 0);
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){0.5, 0.9};
    source.direction = (sph2d_vec2){0, -1};
    source.width = 0.1;
    source.speed = 1;
    tank.scene.sources = &source;
    tank.scene.source_count = 1;
    tank_start();
    run_until(2);
    sph2d_summary s = sph2d_sim_summary(tank.sim);
    ck_assert_double_eq_tol((double)s.particles * DX * DX, 0.1 * sph2d_sim_time(tank.sim), 0.01);
    ck_assert_double_le(s.compression_p99, 0.2);
    tank_finish();
}
END_TEST

START_TEST(a_jet_leaves_its_source_at_its_speed)
{
    /* It falls freely from there, and narrows; by rows of particles alone its middle was a third faster, and came apart. */
    const double speed = 1.2, mouth = 1.5 + 0.01 * _i;
    tank_empty(SPH2D_METHOD_HYBRID, DX, 1, 1.6, 0);
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){0.5, mouth};
    source.width = 0.24;
    source.speed = speed;
    tank.scene.sources = &source;
    tank.scene.source_count = 1;
    tank_start();
    run_until(0.5);
    sph2d_view f = sph2d_sim_fluid(tank.sim);
    double most = 0, least = INFINITY;
    for (size_t i = 0; i < f.count; ++i)
        if (f.y[i] > mouth - 0.2 && fabs(f.x[i] - 0.5) < 0.05) {
            const double ratio = -f.vy[i] / sqrt(speed * speed + 2 * G * (mouth - f.y[i]));
            most = fmax(most, ratio);
            least = fmin(least, ratio);
        }
    const sph2d_summary s = sph2d_sim_summary(tank.sim);
    ck_assert_double_le(most, 1.08);
    ck_assert_double_ge(least, 0.75); /* pressure within the jet makes it slower */
    ck_assert_uint_eq(s.blocked, 0);
    ck_assert_double_le(s.energy_rise, 0.002 * s.energy_scale);
    tank_finish();
}
END_TEST

/* ---- bodies ------------------------------------------------------------------------------------------------------ */

static sph2d_body raft;

/** A box 0.3 m wide and 0.2 m high whose middle is at `y`, in a basin 0.5 m deep. */
static void float_box(double y, double density)
{
    basin(1.2, 0.5);
    raft = sph2d_body_default();
    raft.shape.kind = SPH2D_SHAPE_BOX;
    raft.shape.box = (sph2d_box){{0.45, y - 0.1}, {0.75, y + 0.1}};
    raft.density = density;
    tank.scene.bodies = &raft;
    tank.scene.body_count = 1;
    tank.scene.spacing = DX / 2;
    tank.scene.method.cfl = density > 1000 ? 0.3 : 0; /* a body that falls a spacing in a step compresses liquid */
    tank_start();
}

/* A pressure that is known everywhere pushes a body by -grad p over its area A (Gauss): p = a x + b y by -A (a, b) without a
 * torque, p = x y from its middle by the torque -integral (x^2 - y^2) = -(w^3 h - w h^3)/12 of a box. */
START_TEST(a_known_pressure_pushes_and_turns_a_box)
{
    const double width = 0.3, height = 0.2, area = width * height, turn = area * (width * width - height * height) / 12;
    float_box(0.25, 1000);
    raft.hold.angle = SPH2D_SWITCH_ON;
    raft.velocity = (sph2d_vec2){0.8, 0.5};
    tank_finish();
    tank_start();
    run_until(0.05); /* somewhere else than it is drawn */
    const sph2d_vec2 center = sph2d_sim_body(tank.sim, 0).center;
    ck_assert_double_gt(fmin(center.x - 0.6, center.y - 0.25), 0.005);
    sph2d__grid *g = tank.sim->system.grid;
    for (size_t n = 0; n < g->part_count; ++n)
        g->parts[n].wet_before = g->parts[n].wet_after = 1;
    for (int field = 0; field < 2; ++field) {
        for (int j = 0; j <= g->ny + 1; ++j)
            for (int i = 0; i <= g->nx + 1; ++i) {
                const double x = g->low_x + (i - 0.5) * (double)g->hx - center.x,
                             y = g->low_y + (j - 0.5) * (double)g->hy - center.y;
                g->q[sph2d__at(g, i, j)] = (float)(field == 0 ? 3 * x + 5 * y : x * y);
            }
        sph2d__twist push[1];
        sph2d__grid_impulses(g, 1000, push);
        ck_assert_double_eq_tol(push->x, field == 0 ? -1000 * 3 * area : 0, 0.02 * 1000 * area);
        ck_assert_double_eq_tol(push->y, field == 0 ? -1000 * 5 * area : 0, 0.02 * 1000 * area);
        ck_assert_double_eq_tol(push->turn, field == 0 ? 0 : -1000 * turn,
                                field == 0 ? 5e-3 * 5000 * area * width : 50 * turn);
    }
    tank_finish();
}
END_TEST

START_TEST(a_box_floats_by_its_weight)
{
    /* Let go where it rests, wherever its underside then lies among the squares: its block left room for it. */
    const double density = 400 + 50 * _i, draught = 0.2 * density / 1000;
    float_box(0.6 - draught, density);
    run_until(4);
    const sph2d_body_state b = sph2d_sim_body(tank.sim, 0);
    const double level = tank_middle() * 2, blocked = 0.3 * draught / 1.2;
    ck_assert_double_eq_tol(b.center.y, 0.6 - draught, 0.03 * draught);
    ck_assert_double_eq_tol(level, 0.5 - blocked, 0.03);
    ck_assert_double_le(hypot(b.velocity.x, b.velocity.y), 0.02);
    ck_assert_double_le(fabs(b.angle), 0.015);
    tank_finish();
}
END_TEST

START_TEST(a_ball_leaves_the_floor)
{
    /* A light cylinder on a floor under water: the liquid that it moves counts like 2.29 times its own volume, pi^2/3 - 1,
     * as long as it touches (Lamb, Hydrodynamics, 1932, art. 99), and like once far away. */
    const double density = 700, time = 0.3, lift = (1000 - density) * G;
    float_box(0.25, density);
    sph2d_sim_destroy(tank.sim);
    raft.shape.kind = SPH2D_SHAPE_CIRCLE;
    raft.shape.circle = (sph2d_circle){{0.6, 0.1}, 0.1};
    tank_start();
    run_until(time);
    const double t = sph2d_sim_time(tank.sim), rise = sph2d_sim_body(tank.sim, 0).center.y - 0.1;
    ck_assert_double_ge(rise, lift / (density + 2290) * t * t / 2);
    ck_assert_double_le(rise, lift / (density + 1000) * t * t / 2);
    tank_finish();
}
END_TEST

START_TEST(bodies_of_any_mass_are_stable)
{
    /* From 0.05 to 20 times as dense as the liquid, let go under water: the liquid that it sets in motion holds it back. */
    static const double density[] = {50, 500, 2000, 20000};
    const bool light = _i < 2;
    float_box(light ? 0.25 : 0.35, density[_i]);
    while (sph2d_sim_time(tank.sim) < (light ? 1 : 0.2)) {
        test_steps(tank.sim, 1);
        const double fall = G * sph2d_sim_time(tank.sim);
        ck_assert_double_le(fabs(sph2d_sim_body(tank.sim, 0).velocity.y), light ? 2.5 : fall);
    }
    const sph2d_body_state b = sph2d_sim_body(tank.sim, 0);
    if (light)
        ck_assert_double_ge(b.center.y, 0.4);
    else
        ck_assert_double_le(b.velocity.y, -G * 0.2 * (_i == 2 ? 0.2 : 0.8));
    ck_assert_double_le(sph2d_sim_summary(tank.sim).compression_p99, 0.05);
    ck_assert_double_le(sph2d_sim_summary(tank.sim).compression_max, light ? 1 : 10);
    tank_finish();
}
END_TEST

START_TEST(a_thin_wall_holds_a_tank)
{
    basin(1, 0.4);
    tank.blocks[0] = test_block(0, 0, 0.5, 0.4);
    tank.obstacle = sph2d_obstacle_default();
    tank.obstacle.shape.kind = SPH2D_SHAPE_BOX;
    tank.obstacle.shape.box = (sph2d_box){{0.5, 0}, {0.5 + 0.1 * DX, 0.7}};
    tank.scene.obstacles = &tank.obstacle;
    tank.scene.obstacle_count = 1;
    tank_start();
    run_until(2);
    ck_assert_double_le(tank_fastest(), 0.1); /* liquid that got through would fall, at 1 m/s and more */
    ck_assert_double_eq_tol(tank_middle(), 0.2, 0.006);
    tank_finish();
}
END_TEST

/* ---- the solver -------------------------------------------------------------------------------------------------- */

/** What is left of a right side after iterations from 0, over the right side. */
static double left_after(sph2d__grid *g, int iterations)
{
    uint64_t state = 7;
    double before = 0, after = 0;
    memset(g->s, 0, g->size * sizeof *g->s);
    for (size_t k = 0; k < g->size; ++k) {
        g->pressure.residual[k] = g->level->inverse[k] > 0 ? (float)test_random(&state, -1, 1) : 0;
        before += (double)g->pressure.residual[k] * (double)g->pressure.residual[k];
    }
    sph2d__grid_level_pockets(g, g->pressure.residual);
    g->solver->prepare(g);
    g->solver->solve(g, &g->pressure, g->s, true, iterations);
    for (size_t k = 0; k < g->size; ++k)
        after += (double)g->pressure.residual[k] * (double)g->pressure.residual[k];
    return sqrt(after / before);
}

START_TEST(the_solver_converges)
{
    if (_i == 0)
        basin(1, 0.5);
    else
        full_square(0);
    tank.scene.method.sound_speed = 10; /* where nothing else says how fast it will be */
    tank.scene.spacing = DX / 2;
    tank_start();
    test_steps(tank.sim, 1);
    sph2d__grid *g = tank.sim->system.grid;
    ck_assert_uint_eq(g->pockets, _i == 0 ? 0 : 1);
    const double three = left_after(g, 3), six = left_after(g, 6), twelve = left_after(g, 12);
    ck_assert_double_le(three, 0.3);
    ck_assert_double_le(six, 0.15 * three);
    ck_assert_double_le(twelve, 1e-4);
    tank_finish();
}
END_TEST

START_TEST(the_grid_has_no_divergence_left)
{
    /* A block at 1 m/s against a wall: what flows out of squares inside it. */
    basin(1, 0.5);
    tank.blocks[0].velocity = (sph2d_vec2){1, 0};
    tank_start();
    test_steps(tank.sim, 1);
    sph2d__grid *g = tank.sim->system.grid;
    double worst = 0;
    for (int j = 1; j <= g->ny; ++j)
        for (int i = 1; i <= g->nx; ++i) {
            const size_t k = sph2d__at(g, i, j), up = k + g->stride;
            if (g->mass[k] > 0.5F && g->level->air[k] <= 0) {
                const float right = g->open_x[k + 1] > 0 ? SPH2D__NEW(g->face_x[k + 1]) : 0;
                const float left = g->open_x[k] > 0 ? SPH2D__NEW(g->face_x[k]) : 0;
                const float top = g->open_y[up] > 0 ? SPH2D__NEW(g->face_y[up]) : 0;
                const float low = g->open_y[k] > 0 ? SPH2D__NEW(g->face_y[k]) : 0;
                worst = fmax(worst, fabs((double)(right - left + top - low)));
            }
        }
    ck_assert_double_le(worst, 0.15); /* of 1 m/s; three iterations */
    tank_finish();
}
END_TEST

START_TEST(all_that_falls_is_on_the_grid)
{
    /* Its rows are summed in parts, whose borders lie elsewhere among the particles in each step. */
    tank_empty(SPH2D_METHOD_HYBRID, DX, 1, 2, 0);
    tank_add(0.2, 1, 0.8, 1.9);
    tank_start();
    for (int step = 0; step < 20; ++step) {
        test_steps(tank.sim, 1);
        const sph2d__grid *g = tank.sim->system.grid;
        const sph2d_view f = sph2d_sim_fluid(tank.sim);
        double weight = 0, momentum = 0;
        for (size_t k = 0; k < g->size; ++k) {
            weight += (double)g->sums.middle[k][0];
            momentum += (double)g->sums.y[k].value;
        }
        ck_assert_double_eq_tol(weight, (double)f.count, 1e-4 * (double)f.count);
        ck_assert_double_eq_tol(momentum, (double)f.count * f.vy[0], 1e-4 * (double)f.count * fabs(f.vy[0]));
    }
    tank_finish();
}
END_TEST

/* ---- the same bits ----------------------------------------------------------------------------------------------- */

static void splash(void)
{
    basin(1, 0.3);
    tank.scene.domain.max.y = 1;
    tank_add(0.3, 0.5, 0.6, 0.9);
    tank.obstacle = sph2d_obstacle_default();
    tank.obstacle.shape.kind = SPH2D_SHAPE_CIRCLE;
    tank.obstacle.shape.circle = (sph2d_circle){{0.7, 0.3}, 0.1};
    push(-0.3);
    tank.scene.obstacles = &tank.obstacle;
    tank.scene.obstacle_count = 1;
    tank.scene.fluid.dynamic_viscosity = 1;
    tank.scene.spacing = DX / 2;
}

static sph2d_sim *another(int threads, sph2d_isa isa)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = threads;
    options.isa = isa;
    return test_create(&tank.scene, &options);
}

START_TEST(the_same_bits)
{
    splash();
    sph2d_sim *one = another(1, SPH2D_ISA_BASELINE);
    sph2d_sim *others[] = {another(3, SPH2D_ISA_BASELINE), another(1, SPH2D_ISA_AUTO), another(2, SPH2D_ISA_AUTO)};
    test_steps(one, 40);
    for (size_t k = 0; k < sizeof others / sizeof *others; ++k) {
        test_steps(others[k], 40);
        const sph2d_view a = sph2d_sim_fluid(one), b = sph2d_sim_fluid(others[k]);
        const double *of[][2] = {
            {a.x, b.x}, {a.y, b.y}, {a.vx, b.vx}, {a.vy, b.vy}, {a.density, b.density}, {a.pressure, b.pressure}};
        ck_assert_uint_eq(a.count, b.count);
        for (size_t n = 0; n < sizeof of / sizeof *of; ++n)
            ck_assert_msg(memcmp(of[n][0], of[n][1], a.count * sizeof(double)) == 0, "values %zu of other %zu", n, k);
        sph2d_sim_destroy(others[k]);
    }
    sph2d_sim_destroy(one);
}
END_TEST

START_TEST(what_it_lacks_is_refused)
{
    sph2d_report report = {0};
    basin(1, 0.5);
    tank.scene.method.support_ratio = _i == 0 ? 1.9 : _i == 1 ? 2.7 : 0;
    tank.scene.domain.max.y = _i == 3 ? 1e6 : 1;
    tank.scene.wall_slip = _i == 2 ? SPH2D_SLIP_SMOOTH : SPH2D_SLIP_FREE;
    static const char *const paths[] = {"method.support_ratio", "method.support_ratio", "wall_slip", "domain"};
    ck_assert_int_eq(sph2d_scene_check(&tank.scene, &report), SPH2D_SCENE);
    ck_assert_uint_eq(report.errors, 1);
    ck_assert(test_report_has(&report, _i != 2 ? SPH2D_CODE_OUT_OF_RANGE : SPH2D_CODE_UNSUPPORTED, paths[_i]));
    sph2d_report_clear(&report);
}
END_TEST

Suite *suite_hybrid(void)
{
    Suite *suite = suite_create("hybrid");
    TCase *motions = tcase_create("known motions"), *walls = tcase_create("walls");
    TCase *bodies = tcase_create("bodies"), *solver = tcase_create("solver"), *bits = tcase_create("same bits");
    tcase_add_test(motions, free_liquid_falls_on_a_parabola);
    tcase_add_test(motions, a_tank_comes_to_rest_at_its_level);
    tcase_add_test(motions, a_wave_keeps_its_period_and_height);
    tcase_add_loop_test(motions, viscosity_slows_a_shear_wave, 0, 2);
    tcase_add_loop_test(motions, walls_without_slip_hold_the_liquid, 0, 2);
    tcase_add_test(motions, thick_liquid_lies_level_between_walls);
    tcase_add_test(motions, vortices_between_periodic_sides_are_not_compressed);
    tcase_add_test(motions, tension_rounds_a_square_drop);
    tcase_add_test(walls, a_piston_raises_the_liquid);
    tcase_add_loop_test(walls, a_piston_pays_for_what_it_lifts, 0, 2);
    tcase_add_test(walls, liquid_is_held_by_a_circle);
    tcase_add_test(walls, a_slit_is_no_channel);
    tcase_add_loop_test(walls, a_narrow_channel_is_told, 0, 5);
    tcase_add_test(walls, drops_cross_several_spacings_in_a_step);
    tcase_add_test(walls, a_step_is_refused_in_which_liquid_falls_further_than_it_looks);
    tcase_add_test(walls, a_source_fills_what_was_empty);
    tcase_add_loop_test(walls, a_jet_leaves_its_source_at_its_speed, 0, 3);
    tcase_add_test(bodies, a_known_pressure_pushes_and_turns_a_box);
    tcase_add_test(bodies, a_ball_leaves_the_floor);
    tcase_add_test(walls, a_thin_wall_holds_a_tank);
    tcase_add_loop_test(solver, the_solver_converges, 0, 2);
    tcase_add_test(solver, the_grid_has_no_divergence_left);
    tcase_add_test(solver, all_that_falls_is_on_the_grid);
    tcase_add_loop_test(bits, what_it_lacks_is_refused, 0, 4);
    suite_add_tcase(suite, motions);
    suite_add_tcase(suite, walls);
    suite_add_tcase(suite, bodies);
    TCase *long_bodies = test_long(suite);
    tcase_add_loop_test(long_bodies, a_box_floats_by_its_weight, 0, 5);
    tcase_add_loop_test(long_bodies, bodies_of_any_mass_are_stable, 0, 4);
    suite_add_tcase(suite, solver);
    suite_add_tcase(suite, bits);
    TCase *long_bits = test_long(suite);
    tcase_add_test(long_bits, the_same_bits);
    return suite;
}
