/* SPDX-License-Identifier: MIT */
/** @file test_wcsph_surface.c
 *  Where method `wcsph` with symmetric operators sees a surface, and what it does there and inside, against sums over
 *  all pairs: shifts, the fields that they meet on their way, and forces under tension. */
#include <math.h>

#include "all_pairs.h"
#include "methods/terms/shift.h"
#include "methods/wcsph/wcsph.h"

enum { MOST = SIDE * SIDE };

/** Sets the block at rest at a density, and evaluates until the distance to the surface is known. */
static sph2d__system *at_rest(double density)
{
    scene.method.shifting = 1;
    scene.method.tensile_control = SPH2D_SWITCH_ON;
    sph2d__system *s = make(SPH2D_ISA_AUTO);
    for (size_t i = 0; i < s->fluid.count; ++i) {
        s->fluid.vx[i] = s->fluid.vy[i] = 0;
        s->fluid.density[i] = density;
    }
    sph2d__wcsph.evaluate(s);
    sph2d__wcsph.density_rate(s);
    sph2d__wcsph.evaluate(s);
    return s;
}

static double depth_of(const sph2d__store *f, size_t i)
{
    double x = fmin(f->x[i], SIDE * DX - f->x[i]), y = fmin(f->y[i], SIDE * DX - f->y[i]);
    return fmin(x, y);
}

START_TEST(the_surface_is_known)
{
    block.perturb.amplitude = 0;
    sph2d__system *s = at_rest(RHO0);
    const sph2d__store *f = &s->fluid;
    for (size_t i = 0; i < f->count; ++i) {
        double depth = depth_of(f, i);
        if (depth > s->support)
            ck_assert_double_eq_tol(f->min_eigenvalue[i], 1, 0.02);
        if (depth < 0.6 * DX) {
            ck_assert_double_lt(f->min_eigenvalue[i],
                                0.6); /* a corner has a quarter, a side half and its own row's part */
            ck_assert(f->surface_distance[i] == 0);
        } else {
            double rows = fmin(depth - DX / 2, s->support);
            ck_assert_double_eq_tol(f->surface_distance[i], rows, 1e-12);
        }
    }
}
END_TEST

START_TEST(fullness_is_the_smaller_eigenvalue)
{
    sph2d__system *s = at_rest(RHO0);
    const sph2d__store *f = &s->fluid;
    for (size_t i = 0; i < f->count; ++i) {
        double xx = 0, xy = 0, yy = 0;
        for (size_t j = 0; j < f->count; ++j) {
            other o = other_of(s, i, f, j);
            double v = o.mass / o.density * o.slope;
            xx -= v * o.dx * o.dx;
            xy -= v * o.dx * o.dy;
            yy -= v * o.dy * o.dy;
        }
        /* (M - l)(x) = 0 for some x: the determinant vanishes, and the trace says which root it is */
        double l = f->min_eigenvalue[i];
        ck_assert_double_eq_tol((xx - l) * (yy - l) - xy * xy, 0, 1e-10);
        ck_assert_double_le(l, (xx + yy) / 2 + 1e-10);
    }
}
END_TEST

/* A film of one row: the slope of a field across it cannot be known, and is not guessed. */
START_TEST(a_row_of_particles_has_no_slope)
{
    block = test_block(0, 0, SIDE * DX, DX);
    scene.method.density_diffusion = 0.1;
    scene.method.shifting = 1;
    sph2d__system *s = make(SPH2D_ISA_AUTO);
    s->speed = 1;
    s->shift_gain = 2;
    for (size_t i = 0; i < s->fluid.count; ++i)
        s->fluid.y[i] = 0.3;
    sph2d__wcsph.evaluate(s);
    for (size_t i = 0; i < s->fluid.count; ++i)
        ck_assert(s->fluid.density_grad_x[i] == 0 && s->fluid.density_grad_y[i] == 0);
}
END_TEST

/** Adds the sums by which a particle is shifted: the crowding, the direction across the surface, the packing. */
static void add_crowd(const sph2d__system *s, size_t i, const sph2d__store *from, sph2d_vec2 *g, sph2d_vec2 *n,
                      double *packing)
{
    double close = weight(s->method.kernel, s->support, DX);
    for (size_t j = 0; j < from->count; ++j) {
        other o = other_of(s, i, from, j);
        double crowd = o.mass / o.density * (1 + 0.2 * pow(o.weight / close, 4)) * o.slope;
        *g = (sph2d_vec2){g->x + crowd * o.dx, g->y + crowd * o.dy};
        *n = (sph2d_vec2){n->x + o.mass * o.slope * o.dx, n->y + o.mass * o.slope * o.dy};
        *packing += o.weight / close * o.mass / s->mass;
    }
}

/* In the air, and on a wall, beside which the shift fades at the surface, to none where the wall is 0.3 of what is
 * around. */
START_TEST(shifts_lead_away_from_the_crowd)
{
    if (_i == 1) {
        scene.boundary.bottom = SPH2D_SIDE_WALL;
        scene.domain.min.y = 0;
    }
    sph2d__system *s = at_rest(RHO0);
    const sph2d__store *f = &s->fluid;
    size_t faded = 0;
    s->step = 1e-4;
    for (size_t i = 0; i < f->count; ++i)
        f->stretch[i] = (3 + (double)(i % 4)) / 2;
    sph2d__wcsph.evaluate(s);
    for (size_t i = 0; i < f->count; ++i) {
        sph2d_vec2 g = {0, 0}, n = {0, 0};
        double packing = 0, of_walls = 0;
        add_crowd(s, i, f, &g, &n, &packing);
        add_crowd(s, i, &s->walls, &g, &n, &of_walls);
        double gx = g.x, gy = g.y;
        if (f->min_eigenvalue[i] < 0.75 || f->surface_distance[i] < s->support) { /* along the surface alone */
            double across = (gx * n.x + gy * n.y) / (n.x * n.x + n.y * n.y);
            gx -= across * n.x;
            gy -= across * n.y;
        }
        if (f->surface_distance[i] < s->support) {
            double calm = 0.1 * C0 / s->support, rate = sph2d__strain_rate(f, i);
            double edge = 1 - fmin(of_walls / s->lattice_values / 0.3, 1) * calm * calm / (calm * calm + rate * rate);
            gx *= edge;
            gy *= edge;
            faded += edge < 1;
        }
        double strain = 2 * fabs(f->stretch[i]), sieved = 2.5 * strain * strain / (strain + 0.001 * C0 / s->support);
        double d = fmin(sieved * s->support * s->support, 0.1 * s->support * s->support / s->step);
        double wx = -d * gx, wy = -d * gy, crowd = s->support * hypot(gx, gy);
        double less = f->min_eigenvalue[i] < 0.4 ? 0 : crowd > 0.25 ? 0.25 / crowd : 1; /* none in spray */
        sph2d_vec2 shift = sph2d__shift_velocity(s, i, (sph2d_vec2){0, 0});
        close_to(shift.x, less * wx, 100, "shift x", i);
        close_to(shift.y, less * wy, 100, "shift y", i);
    }
    ck_assert_uint_eq(faded > 0, _i == 1);
}
END_TEST

/** The mean of H grad C over the neighbours of an inner particle, itself too; 0 near the surface. */
static sph2d_vec2 crowd_around(const sph2d__system *s, size_t i)
{
    const sph2d__store *f = &s->fluid;
    double x = 0, y = 0, all = 0;
    if (!(f->min_eigenvalue[i] > 0.75) || f->surface_distance[i] < s->support)
        return (sph2d_vec2){0, 0};
    for (size_t j = 0; j < f->count; ++j) {
        double slope = other_of(s, i, f, j).slope;
        x += slope * f->grad_c_x[j];
        y += slope * f->grad_c_y[j];
        all += slope;
    }
    return (sph2d_vec2){x / all, y / all};
}

/* u = (2x - 5y, 3x - 2y) and a rate of volume: |S| = sqrt(2 S:S) without its trace; density along a shift, and inside
 * no mean of the shift. */
START_TEST(a_shift_meets_the_density_on_its_way)
{
    block.perturb.amplitude = 0.2;
    scene.method.density_diffusion = _i ? 0.1 : 0;
    sph2d__system *s = at_rest(RHO0);
    sph2d__store *f = &s->fluid;
    for (size_t i = 0; i < f->count; ++i) {
        f->vx[i] = 2.5 * f->x[i] - 5 * f->y[i];
        f->vy[i] = 3 * f->x[i] - 1.5 * f->y[i];
        f->density[i] = RHO0 + 40 * f->x[i] + 10 * f->y[i];
    }
    s->step = 1e-4;
    sph2d__wcsph.evaluate(s);
    double before[MOST] = {0};
    s->method.shifting = 1e-30;
    sph2d__wcsph.density_rate(s);
    s->method.shifting = 1;
    for (size_t i = 0; i < f->count; ++i)
        before[i] = f->density_rate[i];
    for (size_t i = 0; i < f->count; ++i) {
        close_to(f->stretch[i], 2, 10, "half of dvx/dx - dvy/dy", i);
        close_to(f->shear[i], -1, 10, "half of dvx/dy + dvy/dx", i);
        close_to(sph2d__strain_rate(f, i), hypot(4, 2), 10, "rate of strain", i);
    }
    sph2d__wcsph.density_rate(s);
    size_t moved = 0, kept = 0, inside = 0;
    for (size_t i = 0; i < f->count; ++i) {
        sph2d_vec2 mean = crowd_around(s, i), w = sph2d__shift_velocity(s, i, mean);
        inside += hypot(mean.x, mean.y) > 1e-3;
        close_to(f->shift_x[i], w.x, 1, "shift x", i);
        close_to(f->shift_y[i], w.y, 1, "shift y", i);
        if (f->min_eigenvalue[i] < 0.75) { /* the slope is not known there */
            w = (sph2d_vec2){0, 0};
            ++kept;
        }
        moved += hypot(w.x, w.y) > 1e-4;
        close_to(f->density_rate[i] - before[i], 40 * w.x + 10 * w.y, 1e5, "way rho", i);
    }
    ck_assert_uint_gt(inside, 10);
    ck_assert_uint_gt(moved, f->count / 2);
    ck_assert_uint_gt(kept, SIDE);
}
END_TEST

/* Density comes to what places say, inside alone: c0/(100 H) of the difference each second. */
START_TEST(density_follows_the_packing_inside)
{
    block.perturb.amplitude = 0.1;
    sph2d__system *s = at_rest(1.001 * RHO0);
    const sph2d__store *f = &s->fluid;
    double own = 0;
    for (int a = -9; a <= 9; ++a)
        for (int b = -9; b <= 9; ++b)
            own += weight(s->method.kernel, s->support, DX * hypot(a, b));
    size_t inside = 0;
    for (size_t i = 0; i < f->count; ++i) {
        double sum = 0;
        for (size_t j = 0; j < f->count; ++j)
            sum += other_of(s, i, f, j).weight;
        close_to(f->packing[i], RHO0 * sum / own, RHO0, "packing", i);
        bool deep = f->min_eigenvalue[i] > 0.75 && f->surface_distance[i] >= s->support;
        inside += deep;
        double rate = deep ? (RHO0 * sum / own - 1.001 * RHO0) * C0 / (100 * s->support) : 0;
        close_to(f->density_rate[i], rate, RHO0, "rate", i);
    }
    ck_assert_uint_gt(inside, 10);
}
END_TEST

/* One by itself, a pair, a row, a corner of liquid. */
START_TEST(connection_tells_spray_from_liquid)
{
    scene.method.support_ratio = _i == 0 ? 3 : 4;
    block.perturb.amplitude = 0;
    sph2d__system *s = at_rest(RHO0);
    sph2d__store *f = &s->fluid;
    for (size_t i = 0; i < f->count; ++i)
        ck_assert(sph2d__connection(f->filling[i]) > 0.99);
    for (size_t count = 1; count <= 2; ++count) {
        f->count = count;
        f->x[0] = 0.1;
        f->x[1] = 0.1 + DX;
        f->y[0] = f->y[1] = 0.1;
        ck_assert(sph2d__cells_build(&s->fluid_cells, f, s->reach, s->memory));
        sph2d__wcsph.density_rate(s);
        ck_assert(sph2d__connection(f->filling[0]) == 0);
    }
}
END_TEST

/* Liquid under even tension: plain forces vanish in the bulk of a lattice; controlled ones push every pair apart,
 * but those that go where they push. */
START_TEST(tension_pushes_apart_inside_and_pulls_at_the_surface)
{
    scene.method.max_compression = 0.05; /* tension of 2 % is within what liquid bears */
    scene.method.turbulence = SPH2D_TURBULENCE_NONE;
    sph2d__system *s = at_rest(0.98 * RHO0);
    const sph2d__store *f = &s->fluid;
    double p = -0.02 * RHO0 * C0 * C0, rho = 0.98 * RHO0;
    for (size_t i = 0; i < f->count && _i == 1; ++i) {
        f->vx[i] = sin(7 * (double)i);
        f->vy[i] = cos(3 * (double)i);
        f->stretch[i] = (i % 3 ? 0.00505 : 0.00495) * C0 / s->support; /* one in three is calm */
    }
    sph2d__wcsph.evaluate(s);
    size_t pushed = 0, let_go = 0;
    for (size_t i = 0; i < f->count; ++i) {
        double plain[2] = {0, 0}, size = 0, work = 0;
        sph2d_vec2 among = {0, 0}; /* times a negative number */
        for (size_t j = 0; j < f->count; ++j) {
            other o = other_of(s, i, f, j);
            plain[0] += o.slope * o.dx;
            plain[1] += o.slope * o.dy;
            among = (sph2d_vec2){among.x + o.slope * o.vx, among.y + o.slope * o.vy};
            size += o.mass * fabs(p / (rho * rho) * o.slope) * o.r;
        }
        work = plain[0] * among.x + plain[1] * among.y; /* of a push away from the neighbours */
        bool deep = f->min_eigenvalue[i] > 0.75 && f->surface_distance[i] >= s->support, calm = i % 3 == 0 || _i == 0;
        bool held = deep && (calm || work <= 0);
        double push = -s->mass * ((held ? -p : p) + p) / (rho * rho);
        pushed += held;
        let_go += deep && !held;
        close_to(f->ax[i], push * plain[0], size, "ax", i);
        close_to(f->ay[i], push * plain[1], size, "ay", i);
    }
    ck_assert_uint_gt(pushed, 5);
    ck_assert(_i == 1 ? let_go > 5 : let_go == 0);
}
END_TEST

Suite *suite_wcsph_surface(void)
{
    Suite *suite = suite_create("wcsph_surface");
    TCase *tests = tcase_create("surface");
    tcase_add_checked_fixture(tests, start, finish);
    tcase_add_test(tests, the_surface_is_known);
    tcase_add_test(tests, fullness_is_the_smaller_eigenvalue);
    tcase_add_test(tests, a_row_of_particles_has_no_slope);
    tcase_add_loop_test(tests, shifts_lead_away_from_the_crowd, 0, 2);
    tcase_add_loop_test(tests, a_shift_meets_the_density_on_its_way, 0, 2);
    tcase_add_test(tests, density_follows_the_packing_inside);
    tcase_add_loop_test(tests, connection_tells_spray_from_liquid, 0, 2);
    tcase_add_loop_test(tests, tension_pushes_apart_inside_and_pulls_at_the_surface, 0, 2);
    suite_add_tcase(suite, tests);
    return suite;
}
