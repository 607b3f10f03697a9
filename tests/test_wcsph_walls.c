/* SPDX-License-Identifier: MIT */
/** @file test_wcsph_walls.c
 *  Walls in one evaluation of method `wcsph` with symmetric operators, against sums over all pairs: what boundary
 *  particles take from the liquid, how they act on it, and images across periodic sides. */
#include <math.h>
#include <string.h>

#include "all_pairs.h"
#include "kernels/kernel.h"
#include "methods/wcsph/wcsph.h"

static const sph2d_slip slips[] = {SPH2D_SLIP_FREE, SPH2D_SLIP_NONE};

/** A random cloud between walls at left and below. */
static sph2d__system *make_walled(sph2d_slip slip)
{
    scene.domain = (sph2d_box){{0, 0}, {SIDE * DX, 1}};
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN, SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN};
    scene.wall_slip = slip;
    scene.gravity = (sph2d_vec2){2, -9};
    scene.fluid.dynamic_viscosity = 3;
    return make(SPH2D_ISA_AUTO);
}

/** The image's velocity over that of the liquid in front, which is `distance` before the surface in the mean. */
static double image_over_liquid(const sph2d__system *s, size_t b, double distance)
{
    double depth = s->walls.depth[b];
    if (!(depth < INFINITY))
        return -1;
    return -fmin(fmax(depth / fmax(distance, 0.1 * DX), 0.25), 4);
}

/** The distance of the liquid before the surface of boundary particle b, in the mean by W. */
static double distance_before(const sph2d__system *s, size_t b)
{
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    double sum = 0, before = 0;
    for (size_t j = 0; j < f->count; ++j) {
        double dx = w->x[b] - f->x[j], dy = w->y[b] - f->y[j];
        double v = weight(s->method.kernel, s->support, hypot(dx, dy));
        sum += v;
        before -= v * (dx * w->normal_x[b] + dy * w->normal_y[b]);
    }
    return before / sum - w->depth[b];
}

START_TEST(walls_carry_the_pressure_of_the_liquid_on)
{
    scene.method.viscosity_form = _i & 2 ? SPH2D_VISCOSITY_MORRIS : SPH2D_VISCOSITY_MONAGHAN;
    sph2d__system *s = make_walled(slips[_i & 1]);
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    for (size_t j = 0; j < f->count; ++j)
        f->filling[j] = 0.2 + 0.05 * (double)(j % 5); /* only liquid that is connected rests on a wall */
    sph2d__wcsph.evaluate(s);
    size_t wet = 0;
    for (size_t b = 0; b < w->count; ++b) {
        double sum = 0, p = 0, vx = 0, vy = 0;
        for (size_t j = 0; j < f->count; ++j) {
            double dx = w->x[b] - f->x[j], dy = w->y[b] - f->y[j];
            double v = weight(s->method.kernel, s->support, hypot(dx, dy));
            sum += v;
            p += v * (f->pressure[j] + sph2d__connection(f->filling[j]) * f->density[j] * (2 * dx - 9 * dy));
            vx += v * f->vx[j];
            vy += v * f->vy[j];
        }
        if (sum < 1e-9)
            continue;
        ++wet;
        close_to(w->pressure[b], p / sum, RHO0 * C0 * C0, "pressure", b);
        close_to(w->density[b], RHO0 + fmax(p / sum, 0) / (C0 * C0), RHO0, "density", b);
        close_to(w->volume[b], w->mass[b] / w->density[b], DX * DX, "volume", b);
        if (slips[_i & 1] == SPH2D_SLIP_NONE) {
            double image = s->walls_stick ? 0 : image_over_liquid(s, b, distance_before(s, b)); /* else by pair */
            close_to(w->image_vx[b], image * vx / sum, 4, "image vx", b);
            close_to(w->image_vy[b], image * vy / sum, 4, "image vy", b);
        }
    }
    ck_assert_uint_gt(wet, 2 * SIDE);
}
END_TEST

/** Whether liquid with weights of this sum is near enough to a boundary particle to count. */
static bool is_wet(const sph2d__system *s, double sum)
{
    return sum > 1e-12 * sph2d__kernel_constant(s->method.kernel) / (s->support * s->support);
}

/** The rate of density by the formulas of wcsph.h: liquid, walls that move, and what they give back. */
static double rate_of(const sph2d__system *s, size_t i, double *size)
{
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    double rate = 0;
    for (size_t j = 0; j < f->count; ++j) {
        other o = other_of(s, i, f, j);
        rate += o.mass * (o.vx * o.dx + o.vy * o.dy) * o.slope;
    }
    *size = fabs(rate);
    for (size_t b = 0; b < w->count; ++b) {
        other o = other_of(s, i, w, b);
        sph2d_vec2 t;
        double part = slides(s, b, &t);
        double sum = 0, back = 0, mean = 0;
        for (size_t j = 0; j < f->count; ++j) {
            other p = other_of(s, j, w, b);
            double vx = f->vx[j] - w->vx[b], vy = f->vy[j] - w->vy[b], slip = part * (vx * t.x + vy * t.y);
            sum += p.weight;
            mean += p.weight * slip;
            back += (vx * p.dx + vy * p.dy - slip * (p.dx * t.x + p.dy * t.y)) * p.slope;
        }
        mean = is_wet(s, sum) ? mean / sum : 0;
        double vx = f->vx[i] - w->vx[b] - mean * t.x, vy = f->vy[i] - w->vy[b] - mean * t.y;
        double across = vx * o.dx + vy * o.dy;
        double ratio = f->density[i] / w->density[b];
        rate += w->mass[b] * across * o.slope;
        if (is_wet(s, sum))
            rate += w->mass[b] * o.weight * ratio * ratio * back / sum;
        *size += w->mass[b] * (fabs(across * o.slope) + (is_wet(s, sum) ? o.weight * fabs(back) / sum : 0));
    }
    return rate;
}

START_TEST(walls_act_like_liquid)
{
    scene.method.kernel = (sph2d_kernel)(_i / 2);
    sph2d__system *s = make_walled(slips[_i % 2]);
    sph2d__wcsph.evaluate(s);
    check_forces(s);
    for (size_t b = 0; b < s->walls.count; ++b)
        s->walls.vx[b] = 0.1 * (double)(b % 3);
    s->walls_move = true;
    double filling[SIDE * SIDE]; /* that the rate is by, before it finds it anew */
    ck_assert_uint_eq(s->fluid.count, SIDE * SIDE);
    memcpy(filling, s->fluid.filling, sizeof filling);
    sph2d__wcsph.density_rate(s);
    memcpy(s->fluid.filling, filling, sizeof filling);
    for (size_t i = 0; i < s->fluid.count; ++i) {
        double size, rate = rate_of(s, i, &size);
        close_to(s->fluid.density_rate[i], rate, size, "rate", i);
    }
}
END_TEST

/* What walls at rest do to the liquid, elastic energy gets and no more: with walls on two sides and a corner, liquid of
 * any density that moves in any way, a lone particle too. No gravity, whose part of the walls' pressure has no
 * potential. */
START_TEST(walls_make_no_energy)
{
    scene.gravity = (sph2d_vec2){0, 0};
    scene.wall_slip = _i & 8 ? SPH2D_SLIP_FREE : SPH2D_SLIP_NONE; /* along smooth walls liquid slides, too */
    scene.method.state_equation = _i & 1 ? SPH2D_STATE_TAIT : SPH2D_STATE_LINEAR;
    scene.method.support_ratio = _i & 2 ? 2.3 : 3;
    scene.domain = (sph2d_box){{0, 0}, {SIDE * DX, 1}};
    scene.boundary = (sph2d_boundary){SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN, SPH2D_SIDE_WALL, SPH2D_SIDE_OPEN};
    scene.fluid.dynamic_viscosity = 0;
    sph2d__system *s = make(SPH2D_ISA_AUTO);
    sph2d__store *f = &s->fluid;
    if (_i & 4)
        f->count = 1; /* by itself in the corner */
    ck_assert(sph2d__cells_build(&s->fluid_cells, f, s->reach, s->memory));
    sph2d__wcsph.evaluate(s);
    sph2d__wcsph.density_rate(s);
    double kinetic = 0, elastic = 0, size = 0;
    for (size_t i = 0; i < f->count; ++i) {
        kinetic += f->vx[i] * f->ax[i] + f->vy[i] * f->ay[i];
        elastic += f->pressure[i] / (f->density[i] * f->density[i]) * f->density_rate[i];
        size += fabs(f->vx[i] * f->ax[i] + f->vy[i] * f->ay[i]);
    }
    ck_assert_double_gt(size, 0.01);
    ck_assert_double_eq_tol(kinetic + elastic, 0, 1e-10 * size);
}
END_TEST

START_TEST(particles_that_only_reflect_do_not_push)
{
    sph2d__system *s = make_walled(slips[_i]);
    for (size_t b = 0; b < s->walls.count; b += 2) {
        s->walls.mass[b] = 0;
        s->walls.bounce[b] = 0.5;
    }
    sph2d__wcsph.walls_placed(s);
    sph2d__wcsph.evaluate(s);
    check_forces(s);
}
END_TEST

/* A room that goes on at its left and right side, and in which the floor does. */
START_TEST(images_act_across_periodic_sides)
{
    scene.domain = (sph2d_box){{0, 0}, {SIDE * DX, SIDE * DX}};
    /* everywhere; a floor across the sides; a wall on the left across floor and top */
    sph2d_side sides[4] = {SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC, SPH2D_SIDE_PERIODIC};
    if (_i > 0) {
        sides[_i == 1 ? 2 : 0] = SPH2D_SIDE_WALL;
        sides[_i == 1 ? 3 : 1] = SPH2D_SIDE_OPEN;
    }
    scene.boundary = (sph2d_boundary){sides[0], sides[1], sides[2], sides[3]};
    scene.method.artificial_viscosity = 0.05;
    sph2d__system *s = make(SPH2D_ISA_AUTO);
    sph2d__wcsph.evaluate(s);
    check_forces(s);
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    for (size_t b = 0; b < w->count; ++b) {
        double sum = 0, p = 0;
        for (size_t j = 0; j < f->count; ++j) {
            double dx = w->x[b] - f->x[j], dy = w->y[b] - f->y[j];
            dx = _i == 1 ? sph2d__period_nearest(dx, SIDE * DX) : dx;
            dy = _i == 2 ? sph2d__period_nearest(dy, SIDE * DX) : dy;
            double v = weight(s->method.kernel, s->support, hypot(dx, dy));
            sum += v;
            p += v * f->pressure[j];
        }
        if (sum > 1e-9)
            close_to(w->pressure[b], p / sum, RHO0 * C0 * C0, "pressure", b);
    }
}
END_TEST

/** The first boundary particle of the left wall, or of the floor, that the middle of the cloud is near. */
static size_t wall_particle(const sph2d__store *w, bool left)
{
    size_t b = 0;
    for (;; ++b) {
        double along = left ? w->y[b] : w->x[b], behind = left ? w->x[b] : w->y[b];
        if (behind < 0 && behind > -DX && along > 4 * DX && along < 5 * DX)
            return b;
    }
}

/* The image at a rough wall has the wall's velocity, and what it is mirrored by of it; the rate of density sees the wall's own. */
START_TEST(a_moving_wall_adds_its_own_velocity)
{
    bool left = _i & 1, rough = _i & 2;
    sph2d__system *s = make_walled(rough ? SPH2D_SLIP_NONE : SPH2D_SLIP_FREE);
    sph2d__store *w = &s->walls;
    sph2d__wcsph.evaluate(s);
    size_t b = wall_particle(w, left);
    double ratio = rough ? 1 - image_over_liquid(s, b, distance_before(s, b)) : 0;
    double before_x = w->image_vx[b], before_y = w->image_vy[b], before_p = w->pressure[b];
    s->walls_move = true;
    w->vx[b] = 0.5;
    w->vy[b] = 0.25;
    sph2d__wcsph.evaluate(s);
    ck_assert_double_eq_tol(w->image_vx[b], before_x + ratio * 0.5, 1e-12);
    ck_assert_double_eq_tol(w->image_vy[b], before_y + ratio * 0.25, 1e-12);
    ck_assert(w->pressure[b] == before_p);
    sph2d__wcsph.density_rate(s);
    if (rough)
        ck_assert(w->image_vx[b] == 0.5 && w->image_vy[b] == 0.25);
    else
        ck_assert(left ? w->image_vx[b] == 0.5 : w->image_vy[b] == 0.25);
    *(left ? &w->ax[b] : &w->ay[b]) = 3; /* it is pushed into the liquid */
    sph2d__wcsph.evaluate(s);
    ck_assert_double_gt(w->pressure[b], before_p + 3 * 0.9 * RHO0 * 0.4 * DX);
    ck_assert_double_lt(w->pressure[b], before_p + 3 * 1.1 * RHO0 * 3 * DX);
}
END_TEST

Suite *suite_wcsph_walls(void)
{
    Suite *suite = suite_create("wcsph_walls");
    TCase *tests = tcase_create("walls");
    tcase_add_checked_fixture(tests, start, finish);
    tcase_add_loop_test(tests, walls_carry_the_pressure_of_the_liquid_on, 0, 4);
    tcase_add_loop_test(tests, walls_act_like_liquid, 0, 2 * SPH2D_KERNEL_COUNT);
    tcase_add_loop_test(tests, walls_make_no_energy, 0, 16);
    tcase_add_loop_test(tests, particles_that_only_reflect_do_not_push, 0, 2);
    tcase_add_loop_test(tests, images_act_across_periodic_sides, 0, 3);
    tcase_add_loop_test(tests, a_moving_wall_adds_its_own_velocity, 0, 4);
    suite_add_tcase(suite, tests);
    return suite;
}
