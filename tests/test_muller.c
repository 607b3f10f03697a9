/* SPDX-License-Identifier: MIT */
/** @file test_muller.c
 *  Density, pressure and acceleration of method `muller` against sums over all pairs, written here from the equations
 * of Mueller, Charypar & Gross 2003 with two-dimensional kernel constants:
 *
 *      rho_i = c sum_j m W(r_ij) + sum_b m_b W(r_ib),  W = 4/(pi H^8) (H^2 - r^2)^3
 *      p_i   = max(k (rho_i - rho0), 0), told as P p_i
 *      a_i   = 1/rho_i sum_j V_j (q_i + q_j)/2 30/(pi H^5) (H - r)^2 r_ij/r + mu/rho_i sum_k V_k (v_k - v_i) 40/(pi
 * H^5) (H - r) - P p_i/rho_i^2 sum_b m_b grad W(r_ib)
 *
 *  with q = G(rho) p, G by which the pairs of a compressed lattice do the work that P p tells, V = m/rho, j over fluid,
 *  b over heavy boundary particles and k over both, c = 1/(dx^2 sum of W over a filled
 * lattice), boundary masses m_b = rho0 / sum_b' W(r_bb') and boundary densities rho0 + c sum_j m W(r_bj). P is what the
 * pairs of a filled lattice carry, dx^2/4 sum r 30/(pi H^5) (H - r)^2, and mu 0.1 rho0 c0 H at least, where
 *  c0^2 = P k D and D is by how much c sum m W grows when a lattice is compressed. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "methods/state_equation.h"
#include "sim/simulation.h"

enum { SIDE = 20, COUNT = SIDE * SIDE, WALLS_MOST = 64 };
static const double DX = 0.01;

/** One set of particles as the reference sees it. */
typedef struct cloud {
    size_t count;
    double x[4 * COUNT], y[4 * COUNT], vx[4 * COUNT], vy[4 * COUNT], mass[4 * COUNT], rho[4 * COUNT], p[4 * COUNT];
    double gain[4 * COUNT];
} cloud;

typedef struct liquid {
    double support, rho0, mass, stiffness, mu, calibration, carried, dx;
} liquid;

static cloud fluid, walls;

static double kernel(double support, double r2)
{
    double h2 = support * support;
    return r2 < h2 ? 4 / (TEST_PI * pow(support, 8)) * pow(h2 - r2, 3) : 0;
}

static liquid liquid_of(const sph2d_scene *scene)
{
    double dx = scene->spacing, lattice = 0, pressed = 0;
    liquid l = {scene->method.support_ratio * dx, scene->fluid.density,           scene->fluid.density * dx * dx,
                0,                                scene->fluid.dynamic_viscosity, 0, 0, dx};
    for (int i = -7; i <= 7; ++i)
        for (int j = -7; j <= 7; ++j) {
            double r = hypot(i, j) * dx, near = fmax(l.support - r, 0), d = near * (l.support + r);
            lattice += dx * dx * kernel(l.support, r * r);
            pressed += dx * dx * 4 / (TEST_PI * pow(l.support, 8)) * 3 * d * d * r * r; /* -dW/d ln(r^2) */
            l.carried += dx * dx / 4 * r * 30 / (TEST_PI * pow(l.support, 5)) * near * near;
        }
    l.calibration = 1 / lattice;
    double c0 = scene->method.sound_speed;
    l.stiffness = c0 * c0 / (l.carried * pressed / lattice);
    double alpha = scene->method.artificial_viscosity > 0 ? scene->method.artificial_viscosity : 0.1;
    l.mu = fmax(l.mu, alpha * l.rho0 * c0 * l.support);
    return l;
}

/** Sum of masses times W over a cloud. */
static double summed(const liquid *l, const cloud *from, double x, double y)
{
    double sum = 0;
    for (size_t j = 0; j < from->count; ++j)
        sum += from->mass[j] * kernel(l->support, pow(x - from->x[j], 2) + pow(y - from->y[j], 2));
    return sum;
}

static double pressure(const liquid *l, double rho)
{
    return fmax(l->stiffness * (rho - l->rho0), 0);
}

/** Of a filled lattice of spacing s: sums of m W, and of r |W'|, the pair force's kernel, for particles of area dx^2.
 *  */
static void lattice_sums(const liquid *l, double s, double *density, double *push)
{
    *density = *push = 0;
    for (int i = -20; i <= 20; ++i)
        for (int j = -20; j <= 20; ++j) {
            double r = hypot(i, j) * s, near = fmax(l->support - r, 0);
            *density += l->calibration * l->dx * l->dx * kernel(l->support, r * r);
            *push += l->dx * l->dx * r * 30 / (TEST_PI * pow(l->support, 5)) * near * near;
        }
}

/** G at a density over rest density: growth of density with the number on the area, over what pairs push, each over
 *  that of the lattice at rest. */
static double pair_gain(const liquid *l, double density)
{
    const double h = 1e-5;
    double near = 0.25 * l->dx, far = l->dx, rho[3], push[3], ratio[2];
    if (density <= 1)
        return 1;
    for (int k = 0; k < 60; ++k) {
        double middle = (near + far) / 2;
        lattice_sums(l, middle, &rho[0], &push[0]);
        *(rho[0] > density ? &near : &far) = middle;
    }
    for (int k = 0; k < 2; ++k) {
        double s = k == 0 ? far : l->dx;
        for (int step = -1; step <= 1; ++step)
            lattice_sums(l, s * (1 + step * h), &rho[step + 1], &push[step + 1]);
        ratio[k] = (rho[0] - rho[2]) / (4 * h) / push[1]; /* d ln n = -2 d ln s */
    }
    return ratio[0] / ratio[1];
}

/** G as the simulation has it, between the two densities next to one. */
static double gain_of(const sph2d_sim *sim, double density)
{
    double place = fmin(fmax(density - 1, 0) * SPH2D__PAIR_GAINS / (SPH2D__PAIR_GAIN_TOP - 1), SPH2D__PAIR_GAINS);
    size_t k = (size_t)fmin(place, SPH2D__PAIR_GAINS - 1);
    const double *gain = sim->system.pair_gain;
    return gain[k] * ((double)k + 1 - place) + gain[k + 1] * (place - (double)k);
}

static void sum_densities(const liquid *l)
{
    for (size_t b = 0; b < walls.count; ++b)
        walls.mass[b] = 1;
    static double weight[WALLS_MOST];
    for (size_t b = 0; b < walls.count; ++b)
        weight[b] = l->rho0 / summed(l, &walls, walls.x[b], walls.y[b]);
    memcpy(walls.mass, weight, walls.count * sizeof *weight);
    for (size_t i = 0; i < fluid.count; ++i)
        fluid.mass[i] = l->mass;
    for (size_t i = 0; i < fluid.count; ++i) {
        double x = fluid.x[i], y = fluid.y[i];
        fluid.rho[i] = l->calibration * summed(l, &fluid, x, y) + summed(l, &walls, x, y);
        fluid.p[i] = pressure(l, fluid.rho[i]);
    }
    for (size_t b = 0; b < walls.count; ++b) {
        walls.rho[b] = l->rho0 + l->calibration * summed(l, &fluid, walls.x[b], walls.y[b]);
        walls.p[b] = pressure(l, walls.rho[b]);
    }
}

/** Adds a cloud's part of a_i; *size sums the sizes of the terms, with k rho for p, since rounding of rho enters so. */
static void add_forces(const liquid *l, size_t i, const cloud *from, double a[2], double *size)
{
    double h5 = pow(l->support, 5);
    for (size_t j = 0; j < from->count; ++j) {
        double dx = fluid.x[i] - from->x[j], dy = fluid.y[i] - from->y[j], r = hypot(dx, dy);
        if (r >= l->support)
            continue;
        double volume = from->mass[j] / from->rho[j], near = l->support - r;
        double slope = 30 / (TEST_PI * h5) * near * near, laplacian = 40 / (TEST_PI * h5) * near;
        if (r > 0 && from == &walls) {
            double d = l->support * l->support - r * r, slope6 = 24 / (TEST_PI * pow(l->support, 8)) * d * d;
            double push = l->carried * fluid.p[i] / pow(fluid.rho[i], 2) * from->mass[j] * slope6;
            a[0] += push * dx;
            a[1] += push * dy;
        } else if (r > 0) {
            double q = fluid.gain[i] * fluid.p[i] + from->gain[j] * from->p[j];
            double push = volume * q / 2 * slope / fluid.rho[i];
            a[0] += push * dx / r;
            a[1] += push * dy / r;
        }
        double drag = l->mu / fluid.rho[i] * volume * laplacian;
        a[0] += drag * (from->vx[j] - fluid.vx[i]);
        a[1] += drag * (from->vy[j] - fluid.vy[i]);
        *size += volume * l->stiffness * (fluid.rho[i] + from->rho[j]) / 2 * slope / fluid.rho[i] +
                 drag * hypot(from->vx[j] - fluid.vx[i], from->vy[j] - fluid.vy[i]);
    }
}

/* ---- the simulation under test ----------------------------------------------------------------------------------- */

static sph2d_vec2 line[2] = {{-0.05, 0.013}, {0.08, -0.031}};

/** A simulation of side^2 particles, whose scene outlives it. */
static sph2d_sim *make(sph2d_isa isa, double ratio, double mu, bool walled, int side, int threads)
{
    static sph2d_obstacle obstacle;
    static sph2d_block block;
    obstacle = sph2d_obstacle_default();
    obstacle.outline.kind = SPH2D_OUTLINE_LINE;
    obstacle.outline.line = (sph2d_points){line, 2};
    sph2d_scene scene = test_open_scene(DX, -1, -1, 1, 1);
    block = test_block(-0.9, -0.9, -0.9 + side * DX, -0.9 + side * DX);
    scene.blocks = &block;
    scene.block_count = 1;
    scene.obstacles = walled ? &obstacle : NULL;
    scene.obstacle_count = walled;
    scene.method.support_ratio = ratio;
    scene.fluid.dynamic_viscosity = mu;
    scene.method.artificial_viscosity = mu > 0 ? 0 : 1e-30; /* its default, or next to none */
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = threads;
    options.isa = isa;
    return test_create(&scene, &options);
}

/** Puts `count` particles at random into a square of liquid pressed together, and evaluates. */
static void scatter(sph2d_sim *sim, size_t count, uint64_t seed)
{
    sph2d__system *s = &sim->system;
    ck_assert_uint_le(count, s->fluid.count);
    s->fluid.count = count;
    double half = 0.4 * DX * sqrt((double)count); /* 1/0.64 times rest density */
    for (size_t i = 0; i < count; ++i) {
        s->fluid.x[i] = test_random(&seed, -half, half);
        s->fluid.y[i] = test_random(&seed, -half, half);
        s->fluid.vx[i] = test_random(&seed, -1, 1);
        s->fluid.vy[i] = test_random(&seed, -1, 1);
    }
    ck_assert(sph2d__cells_build(&s->fluid_cells, &s->fluid, s->support, s->memory, s->team));
    sim->method->evaluate(s);
}

static void look(const sph2d_sim *sim)
{
    sph2d_view f = sph2d_sim_fluid(sim), w = sph2d_sim_walls(sim);
    ck_assert_uint_le(f.count, 4 * COUNT);
    ck_assert_uint_le(w.count, WALLS_MOST);
    memset(&walls, 0, sizeof walls);
    fluid.count = f.count;
    walls.count = w.count;
    memcpy(fluid.x, f.x, f.count * sizeof(double));
    memcpy(fluid.y, f.y, f.count * sizeof(double));
    memcpy(fluid.vx, f.vx, f.count * sizeof(double));
    memcpy(fluid.vy, f.vy, f.count * sizeof(double));
    if (w.count > 0) {
        memcpy(walls.x, w.x, w.count * sizeof(double));
        memcpy(walls.y, w.y, w.count * sizeof(double));
    }
}

/** Compares everything with the sums over all pairs; `g` is what gravity adds. */
static void compare(const sph2d_sim *sim, sph2d_vec2 g)
{
    liquid l = liquid_of(sph2d_sim_scene(sim));
    look(sim);
    sum_densities(&l);
    for (size_t i = 0; i < fluid.count; ++i)
        fluid.gain[i] = gain_of(sim, fluid.rho[i] / l.rho0);
    sph2d_view f = sph2d_sim_fluid(sim), w = sph2d_sim_walls(sim);
    double rho_error = 0, p_error = 0, a_error = 0;
    for (size_t i = 0; i < f.count; ++i) {
        double a[2] = {0, 0}, size = hypot(g.x, g.y) + 1e-300;
        add_forces(&l, i, &fluid, a, &size);
        add_forces(&l, i, &walls, a, &size);
        rho_error = fmax(rho_error, fabs(f.density[i] / fluid.rho[i] - 1));
        p_error = fmax(p_error, fabs(f.pressure[i] - l.carried * fluid.p[i]) / (l.stiffness * l.rho0));
        a_error = fmax(a_error, hypot(f.ax[i] - a[0] - g.x, f.ay[i] - a[1] - g.y) / size);
    }
    for (size_t b = 0; b < w.count; ++b) {
        rho_error = fmax(rho_error, fabs(w.density[b] / walls.rho[b] - 1));
        p_error = fmax(p_error, fabs(w.pressure[b] - l.carried * walls.p[b]) / (l.stiffness * l.rho0));
    }
    ck_assert_double_le(rho_error, 1e-12);
    ck_assert_double_le(p_error, 1e-11);
    ck_assert_double_le(a_error, 1e-12);
}

static bool missing(sph2d_isa isa)
{
    return !sph2d_isa_available(isa);
}

/** Loop index: instruction set, viscosity or none, obstacle or none. */
enum { CASES = 3 * 2 * 2 };

static sph2d_isa isa_of(int index)
{
    return (sph2d_isa)(SPH2D_ISA_BASELINE + index / 4);
}

START_TEST(all_pairs_agree)
{
    static const double ratios[] = {2.0, 2.6, 4.0};
    if (missing(isa_of(_i)))
        return;
    for (int k = 0; k < 3; ++k) {
        sph2d_sim *sim = make(isa_of(_i), ratios[k], _i & 1 ? 30 : 0, _i & 2, SIDE, 1);
        ck_assert_int_eq(sph2d_sim_isa(sim), isa_of(_i));
        ck_assert_uint_eq(sph2d_sim_walls(sim).count, _i & 2 ? 15 : 0); /* 13.7 spacings: 14 pieces */
        scatter(sim, COUNT, 100 + (uint64_t)k);
        compare(sim, (sph2d_vec2){0, 0});
        sph2d_sim_destroy(sim);
    }
}
END_TEST

START_TEST(any_number_of_particles_agrees)
{
    /* Blocks of lanes end in the middle of cells, and at the store's end. */
    if (missing(isa_of(_i)))
        return;
    sph2d_sim *sim = make(isa_of(_i), 2.6, _i & 1 ? 30 : 0, _i & 2, SIDE, 1);
    for (size_t count = 1; count <= 36; count += count < 19 ? 1 : 17) {
        sim->system.fluid.count = COUNT;
        scatter(sim, count, count);
        compare(sim, (sph2d_vec2){0, 0});
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(threads_and_gravity_agree)
{
    if (missing(isa_of(_i)))
        return;
    /* Two particle grains and more: a second thread takes part. */
    sph2d_sim *sim = make(isa_of(_i), 2.0, _i & 1 ? 5 : 0, _i & 2, 40, 2);
    sim->system.body.gravity_x = 3;
    sim->system.body.gravity_y = -9.81;
    scatter(sim, 4 * COUNT, 9);
    compare(sim, (sph2d_vec2){3, -9.81});
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(inner_forces_do_not_push_or_turn_the_whole)
{
    /* Pair forces are antisymmetric; without viscosity they act along the line between the two. */
    if (missing(isa_of(_i)) || _i & 2)
        return;
    sph2d_sim *sim = make(isa_of(_i), 2.6, _i & 1 ? 30 : 0, false, SIDE, 1);
    scatter(sim, COUNT, 31);
    sph2d_view f = sph2d_sim_fluid(sim);
    double sum[2] = {0, 0}, turn = 0, size = 0, turn_size = 0;
    for (size_t i = 0; i < f.count; ++i) {
        sum[0] += f.ax[i];
        sum[1] += f.ay[i];
        turn += f.x[i] * f.ay[i] - f.y[i] * f.ax[i];
        size += hypot(f.ax[i], f.ay[i]);
        turn_size += hypot(f.x[i], f.y[i]) * hypot(f.ax[i], f.ay[i]);
    }
    ck_assert_double_gt(size / (double)f.count, 100); /* there are forces */
    ck_assert_double_le(hypot(sum[0], sum[1]), 1e-14 * size);
    if (!(_i & 1))
        ck_assert_double_le(fabs(turn), 1e-14 * turn_size);
    sph2d_sim_destroy(sim);
}
END_TEST

/* ---- special places ---------------------------------------------------------------------------------------------- */

START_TEST(a_filled_lattice_has_rest_density)
{
    static const double ratios[] = {1.2, 2.0, 2.6, 3.0, 4.0, 6.0};
    sph2d_sim *sim = make(SPH2D_ISA_AUTO, ratios[_i], 0, false, SIDE, 1);
    sph2d_view f = sph2d_sim_fluid(sim);
    double middle = -0.9 + SIDE / 2 * DX, inner = 0;
    for (size_t i = 0; i < f.count; ++i)
        if (fmax(fabs(f.x[i] - middle), fabs(f.y[i] - middle)) < 3 * DX)
            inner = fmax(inner, fabs(f.density[i] / 1000 - 1));
    ck_assert_double_le(inner, 1e-12);
    sph2d_sim_destroy(sim);
}
END_TEST

/** Evaluates two particles `distance` apart along x and tells the first's acceleration. */
static sph2d_vec2 pair(sph2d_sim *sim, double distance)
{
    sph2d__store *f = &sim->system.fluid;
    f->count = 2;
    for (size_t i = 0; i < 2; ++i) {
        f->x[i] = i == 0 ? 0 : distance;
        f->y[i] = 0;
        f->vx[i] = f->vy[i] = 0;
        f->id[i] = i;
    }
    ck_assert(sph2d__cells_build(&sim->system.fluid_cells, f, sim->system.support, sim->system.memory, NULL));
    sim->method->evaluate(&sim->system);
    size_t first = f->id[0] == 0 ? 0 : 1;
    ck_assert(isfinite(f->ax[0]) && isfinite(f->ay[0]) && isfinite(f->density[0]) && isfinite(f->pressure[0]));
    ck_assert(f->ay[0] == 0 && f->ay[1] == 0);
    ck_assert(f->ax[0] == -f->ax[1]);
    return (sph2d_vec2){f->ax[first], f->ay[first]};
}

START_TEST(particles_on_each_other_stay_finite)
{
    /* At H/dx = 1.2 two on one place have 1.77 c of rest density, so they press. No direction: no force at r = 0. */
    static const double distances[] = {0, 1e-300, 1e-160, 1e-22, 1e-17, 1e-12};
    sph2d_isa isa = (sph2d_isa)_i;
    if (missing(isa))
        return;
    sph2d_sim *sim = make(isa, 1.2, 5, false, SIDE, 1);
    for (size_t k = 0; k < sizeof distances / sizeof distances[0]; ++k) {
        sph2d_vec2 a = pair(sim, distances[k]);
        ck_assert_double_gt(sim->system.fluid.pressure[0], 0);
        /* V p slope(0) / rho is the force at r -> 0+; no distance may give more. */
        liquid l = liquid_of(sph2d_sim_scene(sim));
        double rho = sim->system.fluid.density[0], p = sim->system.fluid.pressure[0] / l.carried;
        double most = l.mass / rho * gain_of(sim, rho / l.rho0) * p * 30 / (TEST_PI * pow(l.support, 3)) / rho;
        ck_assert_double_le(-a.x, most * (1 + 1e-12));
        ck_assert_double_ge(-a.x, 0);
        if (distances[k] == 0)
            ck_assert(a.x == 0);
        if (distances[k] >= 1e-12)
            ck_assert_double_ge(-a.x, most * 0.999);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(particles_at_the_support_do_not_meet)
{
    sph2d_sim *sim = make(SPH2D_ISA_AUTO, 2.0, 5, false, SIDE, 1);
    liquid l = liquid_of(sph2d_sim_scene(sim));
    double alone = l.calibration * l.mass * kernel(l.support, 0);
    static const double factors[] = {1, 1 + 1e-15, 1 - 1e-15, 1 + 1e-9, 1.5};
    for (size_t k = 0; k < sizeof factors / sizeof factors[0]; ++k) {
        sph2d_vec2 a = pair(sim, l.support * factors[k]);
        ck_assert_double_le(fabs(a.x), 1e-20);
        ck_assert_double_eq_tol(sim->system.fluid.density[0] / alone, 1, 1e-14);
        ck_assert_double_eq_tol(sim->system.fluid.density[1] / alone, 1, 1e-14);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(pairs_of_a_pressed_lattice_do_the_work_that_is_told)
{
    static const double ratios[] = {1.32, 1.6, 2, 2.4, 3};
    sph2d_sim *sim = make(SPH2D_ISA_AUTO, ratios[_i], 0, false, SIDE, 1);
    liquid l = liquid_of(sph2d_sim_scene(sim));
    for (int k = 0; k <= SPH2D__PAIR_GAINS; k += 8) {
        double density = 1 + (double)k * (SPH2D__PAIR_GAIN_TOP - 1) / SPH2D__PAIR_GAINS;
        ck_assert_double_eq_tol(sim->system.pair_gain[k] / pair_gain(&l, density), 1, 1e-6);
    }
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(tension_is_cut_off)
{
    sph2d_sim *sim = make(SPH2D_ISA_AUTO, 2.0, 0, false, SIDE, 1);
    sph2d_vec2 a = pair(sim, 0.9 * DX); /* far below rest density */
    ck_assert(sim->system.fluid.density[0] < 700);
    ck_assert(sim->system.fluid.pressure[0] == 0 && a.x == 0);
    sph2d_sim_destroy(sim);
}
END_TEST

START_TEST(steps_are_as_long_as_is_stable)
{
    sph2d_sim *sim = make(SPH2D_ISA_AUTO, 2.0, 0, false, SIDE, 1);
    sph2d__system *s = &sim->system;
    double h = s->support, acoustic = s->method.cfl * h / (s->sound_speed + 2);
    s->viscosity = _i ? 100 * s->rest_density : 0;
    double viscous = _i ? 0.04 * h * h / 100 : INFINITY, force = 0.25 * sqrt(h / 1e7);
    sph2d__limit limit;
    ck_assert_double_eq_tol(sim->method->stable_step(s, 2, 0, &limit), fmin(acoustic, viscous), 1e-15);
    ck_assert_int_eq(limit, viscous < acoustic ? SPH2D__LIMIT_VISCOUS : SPH2D__LIMIT_ACOUSTIC);
    ck_assert_double_eq_tol(sim->method->stable_step(s, 2, 1e7, &limit), fmin(force, viscous), 1e-15);
    sph2d_sim_destroy(sim);
}
END_TEST

Suite *suite_muller(void)
{
    Suite *suite = suite_create("muller");
    TCase *sums = tcase_create("sums");
    tcase_add_loop_test(sums, all_pairs_agree, 0, CASES);
    tcase_add_loop_test(sums, any_number_of_particles_agrees, 0, CASES);
    tcase_add_loop_test(sums, threads_and_gravity_agree, 0, CASES);
    tcase_add_loop_test(sums, inner_forces_do_not_push_or_turn_the_whole, 0, CASES);
    suite_add_tcase(suite, sums);
    TCase *places = tcase_create("places");
    tcase_add_loop_test(places, a_filled_lattice_has_rest_density, 0, 6);
    tcase_add_loop_test(places, particles_on_each_other_stay_finite, SPH2D_ISA_BASELINE, SPH2D_ISA_AVX512 + 1);
    tcase_add_test(places, particles_at_the_support_do_not_meet);
    tcase_add_loop_test(places, pairs_of_a_pressed_lattice_do_the_work_that_is_told, 0, 5);
    tcase_add_test(places, tension_is_cut_off);
    tcase_add_loop_test(places, steps_are_as_long_as_is_stable, 0, 2);
    suite_add_tcase(suite, places);
    return suite;
}
