/* SPDX-License-Identifier: MIT */
/** @file test_flows_free.c
 *  Known flows of free liquid, the ellipse, the turning disc and square, the drop under surface tension: the conditions
 *  at their surface, and numbers that were computed in another way. */
#include <math.h>

#include "known_flows.h"

/* ---- the ellipse ------------------------------------------------------------------------------------------------- */

static void axes(const known *k, double t, double *a, double *b, double *rate)
{
    sph2d_report report = {0};
    ck_assert_msg(sph2d_flow_axes(&k->flow, &k->context, t, a, b, rate, &report) == SPH2D_OK, "%s",
                  test_report_text(&report));
}

/* Half axes and rate by a Taylor method with 20 digits, from equations in (a, b, A). */
static const struct {
    double rate0, central, radius, time, a, b, rate;
} ellipses[] = {
    {1, 0, 1, 0, 1, 1, 1},
    {1, 0, 1, 0.82, 2.0267623293313612, 0.49339776328382071, 0.67796946000595106},
    {1, 0, 1, 2, 3.6789853237385371, 0.27181407698137077, 0.38335826271771522},
    {1, 0, 1, 20, 29.131491073818025, 0.034327113482315075, 0.04854583574062263},
    {1, 1, 1, 2, 1.4534097762988571, 0.68803720485940589, -0.73953562104090481},
    {1, 1, 1, 24, 0.87367361053745781, 1.1445922000377578, 0.96395089038941138},
    {0.5, 1, 1, 7.3, 0.81311549409699618, 1.2298375904280954, -0.38747296843770319},
    {-3, 2, 0.4, 1.7, 0.9282291834727015, 0.17237122345303365, 0.81684058212230302},
    {0.7, 1.3, 0.9, 3.1, 0.69155155049983878, 1.1712792768876726, 0.46779255138234},
    {1, 0, 1, 1e-4, 1.0001000049998333, 0.99990000500016664, 0.99999999000000018},
};
enum { ELLIPSES = sizeof ellipses / sizeof ellipses[0] };

START_TEST(axes_of_the_ellipse)
{
    double l = ellipses[_i].radius, pace = hypot(ellipses[_i].rate0, ellipses[_i].central), a, b, rate;
    known k = {{SPH2D_FLOW_STRAIN, ellipses[_i].rate0 * l, l, 0, {7, 8}}, {870, 0, 0, {0, 0}, ellipses[_i].central}};
    axes(&k, ellipses[_i].time, &a, &b, &rate);
    same(a / ellipses[_i].a, 1, 2e-11);
    same(b / ellipses[_i].b, 1, 2e-11);
    same(rate / pace, ellipses[_i].rate / pace, 2e-11);
    same(a * b / (l * l), 1, 1e-14);
    /* On the ellipse the pressure is 0, beyond too; inside above 0. */
    same(at(&k, ellipses[_i].time, 7 + 0.6 * a, 8 - 0.8 * b).p, 0, 1e-10);
    ck_assert(at(&k, ellipses[_i].time, 7 - 0.61 * a, 8 + 0.81 * b).p == 0);
    double middle = at(&k, ellipses[_i].time, 7, 8).p;
    double b2 = ellipses[_i].central * ellipses[_i].central;
    same(middle / (870 * (rate * rate + b2) / (1 / a / a + 1 / b / b)), 1, 1e-13);
    same(at(&k, ellipses[_i].time, 7 + 0.6 * a, 8).p / middle, 0.64, 1e-13);
    same(at(&k, ellipses[_i].time, 7, 8 + 0.6 * b).p / middle, 0.64, 1e-13);
}
END_TEST

START_TEST(ellipse_follows_the_table)
{
    /* A0 t, a, b, A/A0, pressure in the middle over rho A0^2 R^2; Monaghan 1994 has A0 = 100/s. */
    static const double rows[][5] = {{0, 1, 1, 1, 0.5},
                                     {0.25, 1.27777309, 0.782611565, 0.943819482, 0.396758058},
                                     {0.5, 1.59476279, 0.627052504, 0.825282653, 0.231942787},
                                     {0.825, 2.03363404, 0.491730557, 0.675932906, 0.104372086},
                                     {1, 2.27551598, 0.439460768, 0.610215774, 0.06932721},
                                     {1.5, 2.97485549, 0.336150782, 0.472382774, 0.0248969538},
                                     {2, 3.67898532, 0.271814077, 0.383358263, 0.0107991436}};
    known k = {{SPH2D_FLOW_STRAIN, 250, 2.5, 0, {0, 0}}, {870, 0, 0, {0, 0}, 0}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i) {
        double a, b, rate;
        axes(&k, rows[i][0] / 100, &a, &b, &rate);
        same(a / 2.5, rows[i][1], 6e-9);
        same(b / 2.5, rows[i][2], 6e-10);
        same(rate / 100, rows[i][3], 6e-10);
        same(at(&k, rows[i][0] / 100, 0, 0).p / (870 * 250 * 250), rows[i][4], 6e-10);
    }
}
END_TEST

START_TEST(ellipse_swings_with_its_period)
{
    /* A0 = B: the period is 4.827343 in 1/B (Sun et al. 2017 print 4.827), the largest half axis (sqrt 6 + sqrt 2)/2.
     */
    const double period = 4.8273430084023136;
    known k = {{SPH2D_FLOW_STRAIN, 1, 1, 0, {0, 0}}, {1000, 0, 0, {0, 0}, 1}};
    double a, b, rate;
    for (int i = 1; i <= 20; ++i) {
        axes(&k, period * i, &a, &b, &rate);
        same(a, 1, 1e-11);
        same(rate, 1, 1e-11);
    }
    axes(&k, period / 4, &a, &b, &rate);
    same(a, (sqrt(6) + sqrt(2)) / 2, 1e-12);
    same(rate, 0, 1e-11);
    axes(&k, 9000 / sqrt(2), &a, &b, &rate);
    same((rate * rate + 1) * (a * a + b * b), 4, 1e-10); /* the energy */
}
END_TEST

START_TEST(ellipse_at_rest_stays_a_disc)
{
    known k = {{SPH2D_FLOW_STRAIN, 0, 0.7, 0, {0, 0}}, {870, 0, 0, {0, 0}, 3}};
    double a, b, rate;
    axes(&k, 2, &a, &b, &rate);
    ck_assert(a == 0.7 && b == 0.7 && rate == 0);
    same(at(&k, 2, 0, 0).p, 870 * 9 * 0.49 / 2, 1e-10);
    k.context.central_rate = 0; /* nothing at all, for ever */
    axes(&k, 1e200, &a, &b, &rate);
    ck_assert(a == 0.7 && b == 0.7 && rate == 0 && at(&k, 1e200, 0, 0).p == 0);
}
END_TEST

/* ---- drops ------------------------------------------------------------------------------------------------------- */

START_TEST(rotation)
{
    known k = centred(SPH2D_FLOW_ROTATION);
    double u = k.flow.speed, r = k.flow.length, rho = k.context.density;
    same(at(&k, 1, r, 0).vy, u, 1e-15);
    same(at(&k, 1, 0, r).vx, -u, 1e-15);
    same(at(&k, 1, 0, -2 * r).vx, 2 * u, 1e-14);
    same(at(&k, 1, 0, 0).p, -0.5 * rho * u * u, 1e-10);
    same(at(&k, 1, 0.3 * r, 0.4 * r).p, -0.375 * rho * u * u, 1e-10);
    same(at(&k, 1, 0.6 * r, 0.8 * r).p, 0, 1e-10);
    ck_assert(at(&k, 1, 0.6 * r, 0.81 * r).p == 0);
}
END_TEST

/** Pressure over rho w^2 L^2 at (x, y) in L from the centre. */
static double patch_pressure(double x, double y)
{
    known k = centred(SPH2D_FLOW_PATCH);
    double l = k.flow.length, u = k.flow.speed;
    return at(&k, 0, x * l, y * l).p / (k.context.density * u * u);
}

START_TEST(patch)
{
    /* Distances from two sides. A double series of sines, to 3e-8; and the single one with 30 digits. */
    static const double table[][3] = {{0.05, 0.05, -0.00874196306}, {0.25, 0.05, -0.0257459583},
                                      {0.1, 0.1, -0.0261428939},    {0.35, 0.15, -0.07516225},
                                      {0.25, 0.25, -0.0905723105},  {0.45, 0.25, -0.113757589},
                                      {0.5, 0.3, -0.126759433},     {0.45, 0.45, -0.144851821}};
    static const double exact[][3] = {{0.5, 0.5, -0.147342706563027631},     {0.25, 0.25, -0.0905723162189454115},
                                      {0.6, 0.95, -0.03049575823598327},     {0.2, 0.7, -0.0866823746083185493},
                                      {0.999, 0.999, -8.47773535801357e-06}, {0.9999, 0.99, -6.34066560787187553e-6}};
    for (size_t i = 0; i < 8; ++i)
        same(patch_pressure(table[i][0] - 0.5, table[i][1] - 0.5), table[i][2], 3e-8);
    for (size_t i = 0; i < 6; ++i)
        for (int turn = 0; turn < 8; ++turn) {
            double x = (exact[i][0] - 0.5) * (turn & 1 ? -1 : 1), y = (exact[i][1] - 0.5) * (turn & 2 ? -1 : 1);
            same(patch_pressure(turn & 4 ? y : x, turn & 4 ? x : y), exact[i][2], 2e-13);
        }
}
END_TEST

START_TEST(patch_turns_and_is_free)
{
    known k = centred(SPH2D_FLOW_PATCH);
    double l = k.flow.length, w = k.flow.speed / l;
    value v = at(&k, 0, 0.2, -0.3);
    same(v.vx, 0.3 * w, 1e-15);
    same(v.vy, 0.2 * w, 1e-15);
    for (double s = 0; s <= 0.5; s += 0.0625) {
        ck_assert(patch_pressure(s, 0.5) == 0 && patch_pressure(-0.5, s) == 0 && patch_pressure(0.51, s) == 0);
        /* Close to a side it falls with its slope there; its derivative is bounded by that in the middle, 0.675. */
        double near = patch_pressure(s, 0.5 - 1e-6);
        ck_assert(near <= 0 && near >= -0.676e-6);
    }
    same(patch_pressure(0, 0.5 - 1e-6) / 1e-6, -0.6753, 1e-4); /* torsion: 1.350631/2 */
    /* The divergence of the momentum equation. */
    uint64_t seed = 9;
    double rho = k.context.density;
    for (int i = 0; i < 100; ++i) {
        double x = test_random(&seed, -0.48 * l, 0.48 * l), y = test_random(&seed, -0.48 * l, 0.48 * l);
        change dx = along(&k, 0, x, y, 0, 2e-3, 0), dy = along(&k, 0, x, y, 0, 0, 2e-3);
        same((dx.second.p + dy.second.p) / (2 * rho * w * w), 1, 1e-6);
    }
}
END_TEST

START_TEST(drop)
{
    known k = centred(SPH2D_FLOW_DROP);
    for (double angle = 0; angle < 6.3; angle += 0.3) {
        value in = at(&k, 3, 0.6999 * cos(angle), 0.6999 * sin(angle));
        ck_assert(in.vx == 0 && in.vy == 0);
        same(in.p, 0.07 / 0.7, 1e-16);
        ck_assert(at(&k, 3, 0.7001 * cos(angle), 0.7001 * sin(angle)).p == 0);
    }
    ck_assert(at(&k, 3, 0, 0.7).p > 0);
}
END_TEST

/** The surface moves with the liquid, and its pressure is sigma times its curvature, 1/L + 3 eta/L^2 for a displacement
 *  eta that goes with cos 2 theta. */
START_TEST(drop_swings)
{
    known k = centred(SPH2D_FLOW_DROP);
    double speed = 1e-6, pace = sqrt(6 * 0.07 / 870 / (0.7 * 0.7 * 0.7));
    k.flow.speed = speed;
    for (double t = 0; t < 700; t += 50) {
        double moved = speed / pace * sin(pace * t);
        for (double angle = 0; angle < 6.3; angle += 0.3) {
            double x = cos(angle), y = sin(angle), eta = moved * cos(2 * angle), r = 0.7 + eta;
            value in = at(&k, t, (r - 1e-12) * x, (r - 1e-12) * y);
            ck_assert(at(&k, t, (r + 1e-12) * x, (r + 1e-12) * y).p == 0);
            same(in.p, 0.07 * (1 / 0.7 + 3 * eta / 0.49), 1e-9);
            same(in.vx * x + in.vy * y, speed * cos(pace * t) * cos(2 * angle), 1e-9);
        }
    }
}
END_TEST

Suite *suite_flows_free(void)
{
    Suite *suite = suite_create("flows_free");
    TCase *tests = tcase_create("free");
    tcase_add_loop_test(tests, axes_of_the_ellipse, 0, ELLIPSES);
    tcase_add_test(tests, ellipse_follows_the_table);
    tcase_add_test(tests, ellipse_at_rest_stays_a_disc);
    tcase_add_test(tests, rotation);
    tcase_add_test(tests, patch);
    tcase_add_test(tests, patch_turns_and_is_free);
    tcase_add_test(tests, drop);
    tcase_add_test(tests, drop_swings);
    suite_add_tcase(suite, tests);
    TCase *slow = test_long(suite);
    tcase_add_test(slow, ellipse_swings_with_its_period);
    return suite;
}
