/* SPDX-License-Identifier: MIT */
/** @file test_flows.c
 *  What all known flows share: they obey the equations of motion, by finite differences of the code's values, and move
 *  with their centre; what their functions refuse, and what they do with points. */
#include <math.h>
#include <string.h>

#include "known_flows.h"

/* ---- equations of motion ----------------------------------------------------------------------------------------- */

START_TEST(flows_obey_the_equations_of_motion)
{
    /* dv/dt + v . grad v + grad p/rho - nu laplace v - forces = 0, of waves without v . grad v; div v = 0. */
    const struct example *e = &examples[_i];
    const known k = known_of(e);
    double t = e->time, nu = e->viscosity / 870, b2 = e->central * e->central, h = 1e-3;
    bool linear = e->kind == SPH2D_FLOW_STANDING_WAVE || e->kind == SPH2D_FLOW_DROP;
    uint64_t seed = 1;
    for (int i = 0; i < 100; ++i) {
        double x = test_random(&seed, e->box[0], e->box[1]), y = test_random(&seed, e->box[2], e->box[3]);
        double cx = x + k.flow.center[0], cy = y + k.flow.center[1];
        change dt = along(&k, t, cx, cy, h, 0, 0), dx = along(&k, t, cx, cy, 0, h, 0),
               dy = along(&k, t, cx, cy, 0, 0, h);
        value v = linear ? (value){0, 0, 0} : at(&k, t, cx, cy);
        double rx = dt.first.vx + v.vx * dx.first.vx + v.vy * dy.first.vx + dx.first.p / 870 -
                    nu * (dx.second.vx + dy.second.vx) - e->gx + b2 * x;
        double ry = dt.first.vy + v.vx * dx.first.vy + v.vy * dy.first.vy + dy.first.p / 870 -
                    nu * (dx.second.vy + dy.second.vy) - e->gy + b2 * y;
        ck_assert_msg(fabs(rx) < 1e-6 && fabs(ry) < 1e-6 && fabs(dx.first.vx + dy.first.vy) < 1e-6,
                      "%s: residual %g, %g, divergence %g at %g, %g", sph2d_flow_name(e->kind), rx, ry,
                      dx.first.vx + dy.first.vy, x, y);
    }
}
END_TEST

START_TEST(flows_move_with_their_centre)
{
    for (sph2d_flow_kind kind = SPH2D_FLOW_STILL; kind <= SPH2D_FLOW_DROP; ++kind) {
        known here = example(kind), there = centred(kind);
        uint64_t seed = 5;
        for (int i = 0; i < 20; ++i) {
            double x = test_random(&seed, -0.3, 0.3), y = test_random(&seed, -0.3, 0.3);
            value a = at(&here, 0, x + here.flow.center[0], y + here.flow.center[1]), b = at(&there, 0, x, y);
            same(a.vx, b.vx, 1e-13);
            same(a.vy, b.vy, 1e-13);
            same(a.p, b.p, 1e-9);
        }
    }
}
END_TEST

/* ---- the interface ----------------------------------------------------------------------------------------------- */

START_TEST(names_and_default)
{
    static const char *const names[] = {"none",          "still",  "taylor_green", "gresho", "poiseuille", "couette",
                                        "standing_wave", "strain", "rotation",     "patch",  "drop"};
    for (int i = 0; i <= 10; ++i)
        ck_assert_str_eq(sph2d_flow_name((sph2d_flow_kind)i), names[i]);
    ck_assert_str_eq(sph2d_flow_name((sph2d_flow_kind)11), "unknown");
    ck_assert_str_eq(sph2d_flow_name((sph2d_flow_kind)-1), "unknown");
    sph2d_flow f = sph2d_flow_default();
    ck_assert(f.kind == SPH2D_FLOW_NONE && f.speed == 0 && f.length == 0 && f.depth == 0);
    ck_assert(f.center[0] == 0 && f.center[1] == 0);
}
END_TEST

/** Values are refused, with one sentence of this code that has `word`, and the results left alone. */
static void refused(const known *k, double t, sph2d_code code, const char *word)
{
    double x = 0.1, y = -0.1, vx = 5, vy = 6, p = 7;
    sph2d_report report = {0};
    sph2d_status status = sph2d_flow_values(&k->flow, &k->context, t, 1, &x, &y, &vx, &vy, &p, &report);
    ck_assert_msg(status == SPH2D_INVALID, "%s: %s", sph2d_flow_name(k->flow.kind), word);
    ck_assert(vx == 5 && vy == 6 && p == 7);
    ck_assert_msg(report.errors == 1 && strstr(report.items[0].message, word), "%s: %s", word,
                  test_report_text(&report));
    ck_assert_int_eq((int)report.items[0].code, (int)code);
    status = sph2d_flow_values(&k->flow, &k->context, t, 1, &x, &y, &vx, &vy, &p, NULL);
    ck_assert_int_eq((int)status, SPH2D_INVALID);
}

START_TEST(numbers_out_of_range_are_refused)
{
    static const double wrong[] = {0, -1, INFINITY, -INFINITY, NAN};
    for (sph2d_flow_kind kind = SPH2D_FLOW_STILL; kind <= SPH2D_FLOW_DROP; ++kind)
        for (int i = 0; i < 5; ++i) {
            const sph2d_code code = SPH2D_CODE_OUT_OF_RANGE;
            known k = example(kind);
            bool fast = kind != SPH2D_FLOW_STILL, large = kind != SPH2D_FLOW_STILL;
#define REFUSED_FROM(first, member, word)                                                                              \
    if (i >= (first)) {                                                                                                \
        known bad = k;                                                                                                 \
        bad.member = wrong[i];                                                                                         \
        refused(&bad, 0, code, word);                                                                                  \
    }
            REFUSED_FROM(0, context.density, "density")
            REFUSED_FROM(1, context.dynamic_viscosity, "viscosity")
            REFUSED_FROM(1, context.surface_tension, "surface tension")
            REFUSED_FROM(1, context.central_rate, "central force")
            REFUSED_FROM(2, context.gravity[0], "gravity")
            REFUSED_FROM(2, context.gravity[1], "gravity")
            REFUSED_FROM(2, flow.center[0], "centre")
            REFUSED_FROM(2, flow.center[1], "centre")
            REFUSED_FROM(fast ? 2 : 9, flow.speed, "speed")
            REFUSED_FROM(large ? 0 : 9, flow.length, "length")
            if (i > 0)
                refused(&k, wrong[i], code, "time");
            if (kind == SPH2D_FLOW_STANDING_WAVE && wrong[i] != INFINITY)
                REFUSED_FROM(0, flow.depth, "depth")
#undef REFUSED_FROM
        }
}
END_TEST

START_TEST(what_a_kind_needs_is_asked_for)
{
    known k = example(SPH2D_FLOW_POISEUILLE);
    k.context.dynamic_viscosity = 0;
    refused(&k, 1, SPH2D_CODE_OUT_OF_RANGE, "viscosity");
    k.flow.kind = SPH2D_FLOW_COUETTE;
    refused(&k, 1, SPH2D_CODE_OUT_OF_RANGE, "viscosity");
    k = example(SPH2D_FLOW_STANDING_WAVE);
    static const double gravity[][2] = {{0, 0}, {0, 9.81}, {0.1, -9.81}, {-0.1, -9.81}};
    for (int i = 0; i < 4; ++i) {
        memcpy(k.context.gravity, gravity[i], sizeof gravity[i]);
        refused(&k, 1, SPH2D_CODE_OUT_OF_RANGE, "gravity");
    }
    k = example(SPH2D_FLOW_PATCH);
    refused(&k, 1e-300, SPH2D_CODE_UNSUPPORTED, "patch");
    k = (known){{SPH2D_FLOW_STRAIN, 3, 1, 0, {0, 0}}, {1000, 0, 0, {0, 0}, 4}};
    refused(&k, 2000.1, SPH2D_CODE_OUT_OF_RANGE, "time");
    ck_assert(sph2d_flow_axes(&k.flow, &k.context, 1999.9, NULL, NULL, NULL, NULL) == SPH2D_OK);
    k.flow.length = 1e-320; /* U/L overflows */
    refused(&k, 0, SPH2D_CODE_OUT_OF_RANGE, "time");
    k.flow.kind = SPH2D_FLOW_NONE;
    refused(&k, 0, SPH2D_CODE_GENERAL, "unknown flow");
    k.flow.kind = (sph2d_flow_kind)11;
    refused(&k, 0, SPH2D_CODE_GENERAL, "unknown flow");
    k.flow.kind = (sph2d_flow_kind)-1;
    refused(&k, 0, SPH2D_CODE_GENERAL, "unknown flow");
}
END_TEST

START_TEST(what_a_kind_does_not_read_may_be_anything)
{
    for (sph2d_flow_kind kind = SPH2D_FLOW_STILL; kind <= SPH2D_FLOW_DROP; ++kind) {
        known k = example(kind), odd = k;
        if (kind == SPH2D_FLOW_STILL)
            odd.flow.speed = NAN;
        if (kind == SPH2D_FLOW_STILL)
            odd.flow.length = NAN;
        if (kind != SPH2D_FLOW_STANDING_WAVE)
            odd.flow.depth = NAN;
        value a = at(&k, 0, 0.2, -0.3), b = at(&odd, 0, 0.2, -0.3);
        ck_assert(a.vx == b.vx && a.vy == b.vy && a.p == b.p);
    }
}
END_TEST

START_TEST(every_fault_is_told)
{
    known k = {{SPH2D_FLOW_STANDING_WAVE, NAN, 0, -1, {NAN, NAN}}, {0, -1, -1, {0, NAN}, -1}};
    sph2d_report report = {0};
    ck_assert_int_eq((int)sph2d_flow_values(&k.flow, &k.context, -1, 0, NULL, NULL, NULL, NULL, NULL, &report),
                     SPH2D_INVALID);
    ck_assert_uint_eq(report.errors, 10);
    ck_assert_str_eq(report.items[0].message, "the time of a flow is -1: must be at least 0");
    ck_assert_str_eq(report.items[3].message, "the length of a flow is 0: must be above 0");
    ck_assert_str_eq(report.items[8].message, "gravity of a flow is nan: must be finite");
}
END_TEST

START_TEST(axes_belong_to_the_ellipse)
{
    double a = 5, b = 6, rate = 7;
    for (int kind = 0; kind <= 11; ++kind) {
        known k = example(SPH2D_FLOW_STRAIN);
        k.flow.depth = 1;
        k.context.gravity[1] = -1;
        k.flow.kind = (sph2d_flow_kind)kind;
        sph2d_report report = {0};
        sph2d_status status = sph2d_flow_axes(&k.flow, &k.context, 0, &a, &b, &rate, &report);
        ck_assert((status == SPH2D_OK) == (kind == SPH2D_FLOW_STRAIN));
        ck_assert(status == SPH2D_OK || (status == SPH2D_INVALID && report.errors == 1));
        ck_assert(status == SPH2D_OK || kind == SPH2D_FLOW_PATCH || report.items[0].code == SPH2D_CODE_GENERAL);
        ck_assert(kind >= SPH2D_FLOW_STRAIN || (a == 5 && b == 6 && rate == 7));
    }
    known k = example(SPH2D_FLOW_STRAIN);
    ck_assert(a == k.flow.length && b == a && rate == k.flow.speed / k.flow.length);
    ck_assert(sph2d_flow_axes(&k.flow, &k.context, 0, NULL, NULL, NULL, NULL) == SPH2D_OK);
    ck_assert(sph2d_flow_axes(&k.flow, &k.context, -1, &a, &b, &rate, NULL) == SPH2D_INVALID);
    ck_assert(sph2d_flow_axes(NULL, &k.context, 0, &a, &b, &rate, NULL) == SPH2D_INVALID);
    ck_assert(sph2d_flow_axes(&k.flow, NULL, 0, &a, &b, &rate, NULL) == SPH2D_INVALID);
}
END_TEST

START_TEST(points_come_in_arrays)
{
    enum { COUNT = 50 };
    double x[COUNT], y[COUNT], vx[COUNT + 1], vy[COUNT + 1], p[COUNT + 1];
    uint64_t seed = 3;
    for (int i = 0; i < COUNT; ++i) {
        x[i] = test_random(&seed, -0.5, 0.5);
        y[i] = test_random(&seed, -0.5, 0.5);
    }
    for (sph2d_flow_kind kind = SPH2D_FLOW_STILL; kind <= SPH2D_FLOW_DROP; ++kind) {
        known k = example(kind);
        double t = kind == SPH2D_FLOW_PATCH ? 0 : 0.3;
        vx[COUNT] = vy[COUNT] = p[COUNT] = 77;
        ck_assert(sph2d_flow_values(&k.flow, &k.context, t, COUNT, x, y, vx, vy, p, NULL) == SPH2D_OK);
        for (int i = 0; i < COUNT; ++i) {
            value one = at(&k, t, x[i], y[i]);
            ck_assert(one.vx == vx[i] && one.vy == vy[i] && one.p == p[i]);
        }
        ck_assert(vx[COUNT] == 77 && vy[COUNT] == 77 && p[COUNT] == 77);
        double alone[COUNT];
        ck_assert(sph2d_flow_values(&k.flow, &k.context, t, COUNT, x, y, alone, NULL, NULL, NULL) == SPH2D_OK);
        ck_assert_int_eq(memcmp(alone, vx, sizeof alone), 0);
        ck_assert(sph2d_flow_values(&k.flow, &k.context, t, COUNT, x, y, NULL, alone, NULL, NULL) == SPH2D_OK);
        ck_assert_int_eq(memcmp(alone, vy, sizeof alone), 0);
        ck_assert(sph2d_flow_values(&k.flow, &k.context, t, COUNT, x, y, NULL, NULL, alone, NULL) == SPH2D_OK);
        ck_assert_int_eq(memcmp(alone, p, sizeof alone), 0);
        ck_assert(sph2d_flow_values(&k.flow, &k.context, t, 0, NULL, NULL, vx, vy, p, NULL) == SPH2D_OK);
        sph2d_report report = {0};
        ck_assert(sph2d_flow_values(&k.flow, &k.context, t, 1, NULL, y, vx, vy, p, &report) == SPH2D_INVALID);
        ck_assert(sph2d_flow_values(&k.flow, &k.context, t, 1, x, NULL, vx, vy, p, &report) == SPH2D_INVALID);
        ck_assert(sph2d_flow_values(NULL, &k.context, t, 1, x, y, vx, vy, p, &report) == SPH2D_INVALID);
        ck_assert(sph2d_flow_values(&k.flow, NULL, t, 1, x, y, vx, vy, p, &report) == SPH2D_INVALID);
        for (int i = 0; i < 4; ++i)
            ck_assert(report.errors == 4 && report.items[i].code == SPH2D_CODE_GENERAL);
    }
}
END_TEST

START_TEST(points_that_are_no_numbers_end)
{
    static const double odd[] = {NAN, INFINITY, -INFINITY, 1e300, 1e-320};
    for (sph2d_flow_kind kind = SPH2D_FLOW_STILL; kind <= SPH2D_FLOW_DROP; ++kind)
        for (int i = 0; i < 25; ++i)
            at(&(known[]){example(kind)}[0], 0, odd[i / 5], odd[i % 5]);
}
END_TEST

Suite *suite_flows(void)
{
    Suite *suite = suite_create("flows");
    TCase *tests = tcase_create("flows");
    tcase_add_loop_test(tests, flows_obey_the_equations_of_motion, 0, EXAMPLES - 1);
    tcase_add_test(tests, flows_move_with_their_centre);
    tcase_add_test(tests, names_and_default);
    tcase_add_test(tests, numbers_out_of_range_are_refused);
    tcase_add_test(tests, what_a_kind_needs_is_asked_for);
    tcase_add_test(tests, what_a_kind_does_not_read_may_be_anything);
    tcase_add_test(tests, every_fault_is_told);
    tcase_add_test(tests, axes_belong_to_the_ellipse);
    tcase_add_test(tests, points_come_in_arrays);
    tcase_add_test(tests, points_that_are_no_numbers_end);
    suite_add_tcase(suite, tests);
    return suite;
}
