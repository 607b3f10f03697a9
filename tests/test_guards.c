/* SPDX-License-Identifier: MIT */
/** @file test_guards.c
 *  What stops a run, and what must not: a fixed step that is too large, NaN, an escaped particle and a collapsing step
 *  are named; a burst of liquid pressed together survives by its time step alone. No step ever succeeds with a value
 *  that is not finite. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "common.h"
#include "sim/simulation.h"

static sph2d_report report;

static bool all_finite(const sph2d_sim *sim)
{
    sph2d_view f = sph2d_sim_fluid(sim);
    bool finite = isfinite(sph2d_sim_time(sim)) && isfinite(sph2d_sim_time_step(sim));
    for (size_t i = 0; i < f.count; ++i)
        finite = finite && isfinite(f.x[i] + f.y[i] + f.vx[i] + f.vy[i]) && isfinite(f.ax[i] + f.ay[i]) &&
                 isfinite(f.density[i]) && isfinite(f.pressure[i]) && f.density[i] > 0;
    return finite;
}

static sph2d_scene dam(sph2d_block *block)
{
    sph2d_scene scene = sph2d_scene_default();
    scene.method.name = SPH2D_METHOD_MULLER;
    scene.spacing = 0.02;
    scene.domain = (sph2d_box){{0, 0}, {1, 1}};
    *block = test_block(0, 0, 0.3, 0.4);
    scene.blocks = block;
    scene.block_count = 1;
    return scene;
}

/** Steps until one fails, at most so many; success only with finite values. */
static sph2d_status step_until_stopped(sph2d_sim *sim, int most)
{
    sph2d_status status = SPH2D_OK;
    sph2d_report_clear(&report);
    for (int n = 0; n < most && status == SPH2D_OK; ++n) {
        status = sph2d_sim_step(sim, &report);
        ck_assert_msg(status == SPH2D_GUARD || all_finite(sim), "step %d succeeds with values that are not finite", n);
    }
    return status;
}

/** The last step was stopped by this code, with a sentence that names the step and something to do. */
static void check_stopped(sph2d_sim *sim, sph2d_code code, const char *says)
{
    ck_assert_uint_eq(report.errors, 1);
    const sph2d_diagnostic *d = &report.items[0];
    ck_assert_msg(d->code == code, "%s", test_report_text(&report));
    ck_assert_msg(strstr(d->message, says) != NULL, "not \"%s\": %s", says, d->message);
    ck_assert_ptr_nonnull(strstr(d->message, "step"));
    ck_assert_uint_gt(strlen(d->hint), 10);
    /* Later steps fail too, and change nothing: what is there can be looked at and written. */
    sph2d_view f = sph2d_sim_fluid(sim);
    double time = sph2d_sim_time(sim), x = f.x[f.count / 2];
    uint64_t steps = sph2d_sim_steps(sim);
    for (int n = 0; n < 3; ++n) {
        ck_assert_int_eq(sph2d_sim_step(sim, NULL), SPH2D_GUARD);
        sph2d_view g = sph2d_sim_fluid(sim);
        ck_assert(g.count == f.count && memcmp(&g.x[g.count / 2], &x, sizeof x) == 0);
        ck_assert(sph2d_sim_time(sim) == time && sph2d_sim_steps(sim) == steps);
    }
    ck_assert_uint_gt(sph2d_sim_state(sim).array_count, 10);
    ck_assert_uint_eq(sph2d_sim_summary(sim).particles, f.count);
}

START_TEST(a_fixed_step_is_right_or_stopped)
{
    /* From a tenth of the acoustic step to ten thousand times as much. */
    sph2d_block block;
    sph2d_scene scene = dam(&block);
    sph2d_plan plan;
    ck_assert_int_eq(sph2d_scene_plan(&scene, &plan, NULL), SPH2D_OK);
    int stopped = 0, ran = 0;
    for (double factor = 0.1; factor < 2e4; factor *= 2.3) {
        scene.method.time_step = factor * plan.time_step;
        sph2d_sim *sim = test_create(&scene, NULL);
        sph2d_status status = step_until_stopped(sim, 100);
        if (status == SPH2D_GUARD) {
            ++stopped;
            sph2d_code code = report.items[0].code;
            ck_assert_msg(code == SPH2D_CODE_STEP_TOO_LARGE || code == SPH2D_CODE_NOT_FINITE, "%s",
                          test_report_text(&report));
            check_stopped(sim, code, "time");
            ck_assert_ptr_nonnull(strstr(report.items[0].hint, "method.time_step"));
            ck_assert_double_gt(factor, 2); /* what is sound is not stopped */
        } else {
            ++ran;
            ck_assert_double_lt(factor, 50);
        }
        sph2d_sim_destroy(sim);
    }
    ck_assert_int_ge(stopped, 5);
    ck_assert_int_ge(ran, 3);
}
END_TEST

START_TEST(a_step_beyond_the_support_is_refused_at_the_start)
{
    sph2d_block block;
    sph2d_scene scene = dam(&block);
    block.velocity.x = 1;
    scene.method.time_step = 0.05; /* 0.05 m in a step, H = 0.04 m */
    sph2d_sim *sim = NULL;
    sph2d_report_clear(&report);
    ck_assert_int_eq(sph2d_sim_create(&scene, NULL, &sim, &report), SPH2D_SCENE);
    ck_assert_ptr_null(sim);
    ck_assert(test_report_has(&report, SPH2D_CODE_STEP_TOO_LARGE, "method.time_step"));
}
END_TEST

/** Methods with a projection may move particles by a spacing in a step, wcsph by what it is stable for. */
START_TEST(a_step_past_the_neighbours_is_refused)
{
    sph2d_block block;
    sph2d_scene scene = dam(&block);
    scene.method.name = (sph2d_method)_i;
    scene.method.support_ratio = 2.5;
    bool wcsph = _i == SPH2D_METHOD_WCSPH;
    scene.method.cfl = wcsph ? 0.25 : 0.4;
    sph2d_report_clear(&report);
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), SPH2D_OK);
    scene.method.cfl += 0.01;
    bool limited = wcsph || _i == SPH2D_METHOD_CONSTRAINT || _i == SPH2D_METHOD_PCISPH;
    ck_assert_int_eq(sph2d_scene_check(&scene, &report), limited ? SPH2D_SCENE : SPH2D_OK);
    ck_assert(test_report_has(&report, SPH2D_CODE_OUT_OF_RANGE, "method.cfl") == limited);
    const char *hint = wcsph                           ? "use 0.25 or less, or leave it out for 0.2"
                       : _i == SPH2D_METHOD_CONSTRAINT ? "use 0.4 or less, or leave it out for 0.32"
                                                       : "use 0.4 or less, or leave it out for 0.16";
    ck_assert(!limited || strstr(report.items[report.count - 1].hint, hint));
}
END_TEST

START_TEST(nan_is_found_in_the_step_in_which_it_appears)
{
    sph2d_block block;
    sph2d_scene scene = dam(&block);
    for (int where = 0; where < 3; ++where) {
        sph2d_sim *sim = test_create(&scene, NULL);
        test_steps(sim, 10);
        sph2d__store *f = &sim->system.fluid;
        double *values[3] = {f->x, f->vy, f->ax};
        char name[64];
        snprintf(name, sizeof name, "particle %llu", (unsigned long long)f->id[37]);
        values[where][37] = where == 1 ? INFINITY : NAN;
        ck_assert_int_eq(step_until_stopped(sim, 1), SPH2D_GUARD);
        check_stopped(sim, SPH2D_CODE_NOT_FINITE, where == 1 ? name : "particle"); /* NaN may have spread to others */
        sph2d_sim_destroy(sim);
    }
}
END_TEST

START_TEST(a_particle_outside_a_wall_is_named)
{
    sph2d_block block;
    sph2d_scene scene = dam(&block);
    static const sph2d_vec2 outside[3] = {{1.3, 0.2}, {-0.1, 0.2}, {0.5, -0.3}};
    for (int k = 0; k < 3; ++k) {
        sph2d_sim *sim = test_create(&scene, NULL);
        test_steps(sim, 5);
        sph2d__store *f = &sim->system.fluid;
        char name[64];
        snprintf(name, sizeof name, "particle %llu", (unsigned long long)f->id[11]);
        f->x[11] = outside[k].x;
        f->y[11] = outside[k].y;
        ck_assert_int_eq(step_until_stopped(sim, 1), SPH2D_GUARD);
        check_stopped(sim, SPH2D_CODE_ESCAPED, name);
        sph2d_sim_destroy(sim);
    }
}
END_TEST

/** The hint names what moves there, and a fixed step only where the scene has one. */
START_TEST(a_hint_on_an_escape_names_what_squeezes)
{
    sph2d_block block;
    sph2d_scene scene = dam(&block);
    sph2d_obstacle gate = sph2d_obstacle_default();
    gate.shape.kind = SPH2D_SHAPE_BOX;
    gate.shape.box = (sph2d_box){{0.9, 0.3}, {0.99, 0.6}};
    gate.motion.rate = _i == 1 ? 1e-9 : 0;
    scene.obstacles = &gate;
    scene.obstacle_count = 1;
    scene.method.time_step = _i == 2 ? 1e-5 : 0;
    sph2d_sim *sim = test_create(&scene, NULL);
    test_steps(sim, 5);
    sim->system.fluid.x[11] = 1.005;
    sim->system.fluid.y[11] = 0.45;
    ck_assert_int_eq(step_until_stopped(sim, 1), SPH2D_GUARD);
    const char *hint = report.items[0].hint;
    ck_assert_int_eq(report.items[0].code, SPH2D_CODE_ESCAPED);
    ck_assert_msg((strstr(hint, "obstacles[0] squeezes it against the right side") != NULL) == (_i == 1), "%s", hint);
    ck_assert_msg((strstr(hint, "method.time_step") != NULL) == (_i == 2), "%s", hint);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(a_collapsing_step_is_stopped)
{
    /* A particle of 10^4 c0 makes steps of 4e-5 H/c0, which go on; one of 10^6 c0 is stopped, but not at once. */
    for (int k = 0; k < 2; ++k) {
        sph2d_scene scene = test_open_scene(0.01, -1e3, -1e3, 1e3, 1e3);
        sph2d_block block = test_particle(0.01, 0, 0, k == 0 ? 1e5 : 1e7, 0);
        scene.blocks = &block;
        scene.block_count = 1;
        sph2d_sim *sim = test_create(&scene, NULL);
        ck_assert_int_eq(step_until_stopped(sim, 300), k == 0 ? SPH2D_OK : SPH2D_GUARD);
        if (k == 1) {
            check_stopped(sim, SPH2D_CODE_STEP_COLLAPSE, "collapsed");
            ck_assert_uint_gt(sph2d_sim_steps(sim), 50);
        }
        sph2d_sim_destroy(sim);
    }
}
END_TEST

START_TEST(a_step_grows_by_a_fifth_at_most)
{
    /* One of two particles is fast, makes short steps, and is soon gone: jumps of the step would pump energy. */
    sph2d_scene scene = test_open_scene(0.01, -0.1, -0.1, 0.1, 0.1);
    sph2d_block blocks[2] = {test_particle(0.01, 0, 0, 0, 0), test_particle(0.01, 0.09, 0, 1e4, 0)};
    scene.blocks = blocks;
    scene.block_count = 2;
    sph2d_sim *sim = test_create(&scene, NULL);
    double first = sph2d_sim_time_step(sim), growth = 0;
    for (int n = 0; n < 200; ++n) {
        double step = sph2d_sim_time_step(sim);
        test_steps(sim, 1);
        growth = fmax(growth, sph2d_sim_time_step(sim) / step);
    }
    ck_assert_uint_eq(sph2d_sim_fluid(sim).count, 1);
    ck_assert_double_eq_tol(sph2d_sim_time_step(sim) / first, 1001, 1e-9); /* c0 + v_max was 10010, is 10 */
    ck_assert_double_eq_tol(growth, 1.2, 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- what must survive ------------------------------------------------------------------------------------------- */

START_TEST(a_burst_survives_and_keeps_its_momentum)
{
    /* 400 particles at a twelfth of the spacing, all of them within one support radius. */
    const double dx = 0.01;
    sph2d_scene scene = test_scene(dx, -0.5, -0.5, 0.5, 0.5);
    sph2d_block block = test_block(-10 * dx / 12, -10 * dx / 12, 10 * dx / 12, 10 * dx / 12);
    block.spacing = dx / 12;
    scene.blocks = &block;
    scene.block_count = 1;
    scene.fluid.dynamic_viscosity = _i;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_view f = sph2d_sim_fluid(sim);
    ck_assert_uint_eq(f.count, 400);
    double reach = 0, worst = 0, turn = 0, fastest = 0, acoustic = 0;
    int steps = 0;
    while (reach < 0.5 - 2 * dx) {
        test_steps(sim, 1);
        acoustic = fmax(acoustic, sph2d_sim_time_step(sim) * (10 + sph2d_sim_summary(sim).speed_max) / (2 * dx));
        ck_assert_int_lt(++steps, 20000);
        f = sph2d_sim_fluid(sim);
        double p[2] = {0, 0}, size = 0, l = 0, l_size = 0;
        reach = 0;
        for (size_t i = 0; i < f.count; ++i) {
            double speed = hypot(f.vx[i], f.vy[i]);
            p[0] += f.vx[i];
            p[1] += f.vy[i];
            size += speed;
            l += f.x[i] * f.vy[i] - f.y[i] * f.vx[i];
            l_size += hypot(f.x[i], f.y[i]) * speed;
            reach = fmax(reach, fmax(fabs(f.x[i]), fabs(f.y[i])));
            fastest = fmax(fastest, speed);
        }
        worst = fmax(worst, hypot(p[0], p[1]) / size);
        turn = fmax(turn, fabs(l) / l_size);
    }
    ck_assert_double_gt(fastest, 10);                 /* c0: it did burst */
    ck_assert_double_le(acoustic, 0.4 * (1 + 1e-12)); /* dt <= cfl H/(c0 + v_max) */
    ck_assert_double_le(worst, 1e-13);
    if (_i == 0) /* viscosity does not act along the line between two particles */
        ck_assert_double_le(turn, 1e-13);
    ck_assert_double_gt(sph2d_sim_summary(sim).compression_max, 50);
    ck_assert_int_eq(step_until_stopped(sim, 200), SPH2D_OK); /* and it survives the walls */
    ck_assert_uint_eq(sph2d_sim_summary(sim).particles, 400);
    sph2d_sim_destroy(sim);
}
END_TEST

/* A density that falls or rises beyond any liquid's, and energy that somebody put in unseen, stop a run. */
START_TEST(densities_and_energies_of_no_liquid_are_stopped)
{
    static const double factors[] = {0.02, 40};
    sph2d_block block;
    sph2d_scene scene = dam(&block);
    scene.method.name = SPH2D_METHOD_WCSPH;
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_int_eq(step_until_stopped(sim, 30), SPH2D_OK);
    sph2d_summary sum = sph2d_sim_summary(sim);
    double head = 9.81 * 0.4, n = (double)sum.particles, mass = 1000 * 0.02 * 0.02;
    ck_assert_double_eq_tol(sum.energy_scale, n * mass * head / 2, 1e-9 * n * mass * head);
    ck_assert_double_lt(sum.energy_rise, 0.001 * sum.energy_scale);
    sph2d__store *f = &sim->system.fluid;
    if (_i < 2)
        f->log_density[7] = log(factors[_i]);
    else
        for (size_t i = 0; i < f->count; ++i)
            f->vx[i] += 0.5 * sqrt(head); /* m v^2/2 is a quarter of the scale */
    sim->momentum_kept = 0;               /* is not that of the last step */
    ck_assert_int_eq(step_until_stopped(sim, 20), SPH2D_GUARD);
    check_stopped(sim, _i < 2 ? SPH2D_CODE_DENSITY : SPH2D_CODE_ENERGY, _i < 2 ? "density" : "from nothing");
    sph2d_sim_destroy(sim);
}
END_TEST

/* The hint names what shortens this run's steps: cfl does not where viscosity or the scene sets them. */
START_TEST(a_hint_on_energy_names_what_helps)
{
    static const struct {
        double viscosity, time_step;
        const char *hint;
    } cases[] = {
        {0.001, 0, "try a smaller method.cfl, more fluid.dynamic_viscosity, or"},
        {200, 0, "try shorter steps, by a method.time_step of "},
        {0.001, 0.01, "try leaving method.time_step out, for an adaptive step, or"},
    };
    sph2d_block block;
    sph2d_scene scene = dam(&block);
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.method.time_step = cases[_i].time_step;
    scene.fluid.dynamic_viscosity = cases[_i].viscosity;
    sph2d_sim *sim = test_create(&scene, NULL);
    sph2d_status status = step_until_stopped(sim, 30);
    ck_assert_int_eq(status, SPH2D_OK);
    for (size_t i = 0; i < sim->system.fluid.count && status == SPH2D_OK; ++i)
        sim->system.fluid.vx[i] += 2;
    sim->momentum_kept = 0;
    if (status == SPH2D_OK)
        status = step_until_stopped(sim, 20);
    ck_assert_int_eq(status, SPH2D_GUARD);
    check_stopped(sim, SPH2D_CODE_ENERGY, "from nothing");
    const char *hint = report.items[0].hint;
    ck_assert_msg(strstr(hint, cases[_i].hint) && strstr(hint, "times the scale"), "%s", hint);
    sph2d_sim_destroy(sim);
}
END_TEST

/* A drop that falls until it is faster than the sound speed that somebody set. */
START_TEST(liquid_faster_than_its_sound_is_stopped)
{
    sph2d_block block;
    sph2d_scene scene = dam(&block);
    scene.method.name = SPH2D_METHOD_WCSPH;
    scene.method.sound_speed = 1;
    block = test_block(0.4, 0.7, 0.5, 0.8);
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_int_eq(step_until_stopped(sim, 10000), SPH2D_GUARD);
    ck_assert_double_eq_tol(sph2d_sim_time(sim), 1 / 9.81, 0.01); /* of free fall */
    check_stopped(sim, SPH2D_CODE_SUPERSONIC, "faster than sound");
    sph2d_sim_destroy(sim);
}
END_TEST

/** Scenes at the edge of what numbers can hold: each is refused, stopped, or right. 0 leaves a number as it is; `scale`
 *  is of all lengths, `block_spacing` over the scene's. */
static const struct {
    double gravity, velocity, density, viscosity, stiffness, max_compression, time_step, block_spacing, scale;
} extremes[] = {
    {.gravity = 1e300},   {.gravity = 1e-300},   {.gravity = 1e5},       {.velocity = 1e200},
    {.velocity = 1e5},    {.density = 1e300},    {.density = 1e-300},    {.viscosity = 1e300},
    {.viscosity = 1e6},   {.stiffness = 1e300},  {.stiffness = 1e-300},  {.max_compression = 1e-6},
    {.time_step = 1e300}, {.time_step = 1e-300}, {.block_spacing = 0.1}, {.block_spacing = 0.05},
    {.scale = 1e30},      {.scale = 1e-30},      {.scale = 1e100},       {.scale = 1e-100},
};
enum { EXTREMES = sizeof extremes / sizeof extremes[0] };

static void take(double *slot, double value)
{
    *slot = value != 0 ? value : *slot;
}

static void make_extreme(int index, sph2d_scene *scene, sph2d_block *block)
{
    double scale = 1;
    take(&scene->gravity.y, -extremes[index].gravity);
    take(&block->velocity.x, extremes[index].velocity);
    take(&block->velocity.y, -extremes[index].velocity);
    take(&scene->fluid.density, extremes[index].density);
    take(&scene->fluid.dynamic_viscosity, extremes[index].viscosity);
    take(&scene->method.stiffness, extremes[index].stiffness);
    if (scene->method.stiffness > 0)
        scene->method.sound_speed = 0;
    take(&scene->method.max_compression, extremes[index].max_compression);
    take(&scene->method.time_step, extremes[index].time_step);
    take(&scale, extremes[index].scale);
    block->spacing = extremes[index].block_spacing * scene->spacing;
    if (block->spacing > 0)
        block->shape.box.max = (sph2d_vec2){0.02, 0.02};
    scene->spacing *= scale;
    scene->domain.max = (sph2d_vec2){scale, scale};
    block->shape.box.max.x *= scale;
    block->shape.box.max.y *= scale;
}

START_TEST(extreme_scenes_are_refused_or_right)
{
    sph2d_block block;
    sph2d_scene scene = dam(&block);
    make_extreme(_i % EXTREMES, &scene, &block);
    if (_i >= EXTREMES)
        scene.method.name = SPH2D_METHOD_WCSPH;
    sph2d_sim *sim = NULL;
    sph2d_report_clear(&report);
    sph2d_status status = sph2d_sim_create(&scene, NULL, &sim, &report);
    ck_assert_msg(status == SPH2D_OK || (status == SPH2D_SCENE && report.errors > 0), "%d", status);
    if (status != SPH2D_OK)
        return;
    ck_assert(all_finite(sim));
    ck_assert_double_gt(sph2d_sim_time_step(sim), 0);
    double before = -1;
    for (int n = 0; n < 20 && status == SPH2D_OK; ++n) {
        ck_assert_double_gt(sph2d_sim_time(sim), before); /* no run that stands still */
        before = sph2d_sim_time(sim);
        status = step_until_stopped(sim, 1);
    }
    ck_assert_uint_eq(sph2d_sim_summary(sim).particles, sph2d_sim_plan(sim)->fluid_particles);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(nothing_is_no_fault)
{
    /* A source that has not opened yet: no particle, but time goes on. */
    sph2d_scene scene = test_scene(0.01, 0, 0, 1, 1);
    sph2d_source source = sph2d_source_default();
    source.at = (sph2d_vec2){0.5, 0.5};
    source.speed = 1;
    source.start = 0.05;
    scene.sources = &source;
    scene.source_count = 1;
    sph2d_sim *sim = test_create(&scene, NULL);
    ck_assert_double_gt(sph2d_sim_time_step(sim), 0);
    while (sph2d_sim_time(sim) < 0.04) {
        double before = sph2d_sim_time(sim);
        test_steps(sim, 1);
        ck_assert_double_gt(sph2d_sim_time(sim), before);
        ck_assert_uint_eq(sph2d_sim_fluid(sim).count, 0);
    }
    sph2d_summary s = sph2d_sim_summary(sim);
    ck_assert(s.kinetic == 0 && s.potential == 0 && s.speed_max == 0 && s.compression_max == 0 && s.neighbours == 0);
    while (sph2d_sim_time(sim) < 0.1)
        test_steps(sim, 1);
    ck_assert_uint_gt(sph2d_sim_fluid(sim).count, 3);
    sph2d_sim_destroy(sim);
}
END_TEST

/* Methods that sum density, with steps and supports that are too large: whatever the energy does from the first step
 * on, between samples of the balance, too. */
static const struct {
    const char *scene; /* dam: liquid that starts at rest; fall: a block that meets the floor */
    sph2d_method method;
    double spacing, cfl, support_ratio, max_compression, tolerance;
} greedy[] = {
    {"dam", SPH2D_METHOD_CONSTRAINT, 0.02, 0.5, 2, 0, 0},
    {"fall", SPH2D_METHOD_CONSTRAINT, 0.0125, 0.4, 2, 0.1, 0},
    {"fall", SPH2D_METHOD_CONSTRAINT, 0.02, 0.4, 2.4, 0.1, 4e-4},
    {"fall", SPH2D_METHOD_MULLER, 0.02, 0.9, 2.4, 0.01, 0},
};

static double energy_of(const sph2d_sim *sim)
{
    sph2d_summary s = sph2d_sim_summary(sim);
    return s.kinetic + s.potential + s.elastic;
}

START_TEST(energy_of_no_step_comes_from_nothing_unseen)
{
    bool falls = strcmp(greedy[_i].scene, "fall") == 0;
    sph2d_scene scene = falls ? test_scene(greedy[_i].spacing, 0, 0, 1, 1) : test_scene(greedy[_i].spacing, 0, 0, 2, 1);
    sph2d_block block = falls ? test_block(0.3, 0.4, 0.7, 0.8) : test_block(0, 0, 1, 0.5);
    scene.blocks = &block;
    scene.block_count = 1;
    scene.method.name = greedy[_i].method;
    scene.method.cfl = greedy[_i].cfl;
    scene.method.support_ratio = greedy[_i].support_ratio;
    scene.method.max_compression = greedy[_i].max_compression;
    scene.method.tolerance = greedy[_i].tolerance;
    sph2d_sim *sim = test_create(&scene, NULL);
    double low = energy_of(sim), rise = 0, scale = sph2d_sim_summary(sim).energy_scale;
    sph2d_status status = SPH2D_OK;
    sph2d_report_clear(&report);
    while (status == SPH2D_OK && sph2d_sim_time(sim) < (falls ? 0.4 : 0.3)) {
        status = sph2d_sim_step(sim, &report);
        low = fmin(low, energy_of(sim));
        if (status == SPH2D_OK)
            rise = fmax(rise, energy_of(sim) - low);
    }
    ck_assert_msg(status == SPH2D_OK || report.items[0].code == SPH2D_CODE_ENERGY, "%s", test_report_text(&report));
    ck_assert_msg(rise <= 0.1001 * scale, "%g of the scale came unseen", rise / scale);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_guards(void)
{
    Suite *suite = suite_create("guards");
    TCase *tests = tcase_create("guards");
    tcase_add_test(tests, a_fixed_step_is_right_or_stopped);
    tcase_add_test(tests, a_step_beyond_the_support_is_refused_at_the_start);
    tcase_add_loop_test(tests, a_step_past_the_neighbours_is_refused, 0, SPH2D_METHOD_CONSTRAINT + 1);
    tcase_add_test(tests, nan_is_found_in_the_step_in_which_it_appears);
    tcase_add_test(tests, a_particle_outside_a_wall_is_named);
    tcase_add_loop_test(tests, a_hint_on_an_escape_names_what_squeezes, 0, 3);
    tcase_add_test(tests, a_collapsing_step_is_stopped);
    tcase_add_test(tests, a_step_grows_by_a_fifth_at_most);
    suite_add_tcase(suite, tests);
    TCase *survivors = tcase_create("survivors");
    tcase_add_loop_test(survivors, a_burst_survives_and_keeps_its_momentum, 0, 2);
    tcase_add_loop_test(survivors, densities_and_energies_of_no_liquid_are_stopped, 0, 3);
    tcase_add_loop_test(survivors, a_hint_on_energy_names_what_helps, 0, 3);
    tcase_add_loop_test(survivors, energy_of_no_step_comes_from_nothing_unseen, 0, sizeof greedy / sizeof *greedy);
    tcase_add_test(survivors, liquid_faster_than_its_sound_is_stopped);
    tcase_add_loop_test(survivors, extreme_scenes_are_refused_or_right, 0, 2 * EXTREMES);
    tcase_add_test(survivors, nothing_is_no_fault);
    suite_add_tcase(suite, survivors);
    return suite;
}
