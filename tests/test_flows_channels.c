/* SPDX-License-Identifier: MIT */
/** @file test_flows_channels.c
 *  Known flows that are held together, vortices, channels between walls and liquid under gravity: their conditions at
 *  walls and surfaces, and numbers that were computed in another way. */
#include <math.h>

#include "known_flows.h"

/* ---- vortices ---------------------------------------------------------------------------------------------------- */

START_TEST(taylor_green)
{
    known k = centred(SPH2D_FLOW_TAYLOR_GREEN);
    double u = k.flow.speed, l = k.flow.length, rho = k.context.density;
    same(at(&k, 0, 0, l / 4).vx, -u, 1e-14);
    same(at(&k, 0, l / 4, 0).vy, u, 1e-14);
    same(at(&k, 0, 0, 0).p, -rho * u * u / 2, 1e-10);
    same(at(&k, 0, l / 4, l / 4).p, rho * u * u / 2, 1e-10);
    same(at(&k, 0, l / 4, 0).p, 0, 1e-10);
    for (int i = 0; i < 2; ++i) {
        value a = at(&k, 0.3, 0.13, -0.21), b = at(&k, 0.3, 0.13 + i * l, -0.21 + (1 - i) * l);
        same(a.vx, b.vx, 1e-14);
        same(a.vy, b.vy, 1e-14);
        same(a.p, b.p, 1e-10);
    }
    known re100 = {{SPH2D_FLOW_TAYLOR_GREEN, 1, 1, 0, {0, 0}}, {1000, 10, 0, {0, 0}, 0}};
    same(at(&re100, 1, 0.25, 0).vy, exp(-8 * TEST_PI * TEST_PI / 100), 1e-15);
    same(at(&re100, 1, 0.25, 0).vy, 0.454041, 5e-7);
    same(at(&re100, 1, 0, 0).p, -500 * 0.206153, 5e-4);
}
END_TEST

START_TEST(gresho)
{
    known k = centred(SPH2D_FLOW_GRESHO);
    double u = k.flow.speed, l = k.flow.length, q = k.context.density * u * u;
    static const double rows[][2] = {{0, 0},     {0.1, 0.5}, {0.199999, 0.999995}, {0.2, 1}, {0.20001, 0.99995},
                                     {0.3, 0.5}, {0.4, 0},   {0.40001, 0},         {0.7, 0}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i) {
        double r = rows[i][0] * l, speed = rows[i][1] * u;
        same(at(&k, 1, r, 0).vy, speed, 1e-14);
        same(at(&k, 1, -r, 0).vy, -speed, 1e-14);
        same(at(&k, 1, 0, r).vx, -speed, 1e-14);
        same(at(&k, 1, 0.6 * r, 0.8 * r).vx, -0.8 * speed, 1e-14);
    }
    /* The original's 5, 5 + 0.5 and 3 + 4 ln 2. */
    same(at(&k, 1, 0, 0).p, q * (2 - 4 * log(2)), 1e-9);
    same(at(&k, 1, 0.1 * l, 0).p, q * (2.125 - 4 * log(2)), 1e-9);
    same(at(&k, 1, 0.2 * l, 0).p, q * (2.5 - 4 * log(2)), 1e-9);
    same(at(&k, 1, 0.2 * l * (1 - 1e-12), 0).p, q * (2.5 - 4 * log(2)), 1e-8);
    same(at(&k, 1, 0.4 * l * (1 - 1e-12), 0).p, 0, 1e-8);
    ck_assert(at(&k, 1, 0.41 * l, 0).p == 0 && at(&k, 1, 0.3, 0.3).p == 0);
}
END_TEST

/* ---- channels ---------------------------------------------------------------------------------------------------- */

/* u/U at s = y/L and tau = nu t/L^2 from sums of sines, checked by finite differences. */
static const double ages[] = {0.01, 0.05, 0.1, 0.2, 0.5, 5};
static const struct {
    double s, u[6];
} poiseuille_table[] =
    {
        {0.05, {0.0360696577, 0.0912318306, 0.129824638, 0.167573068, 0.188838884, 0.19}},
        {0.2, {0.07545679, 0.269229455, 0.413901718, 0.555733277, 0.635637236, 0.64}},
        {0.5, {0.0799922973, 0.370386318, 0.615352514, 0.856636891, 0.992577623, 1}},
        {0.7, {0.0793578951, 0.330128454, 0.528807716, 0.724016807, 0.833995171, 0.84}},
        {0.975, {0.0201849396, 0.0479606205, 0.0673192516, 0.0862518598, 0.096917647, 0.0975}},
},
  couette_table[] = {
      {0.05, {1.83719461e-11, 0.00176420647, 0.0147669858, 0.0362025646, 0.0492837658, 0.05}},
      {0.2, {1.54172579e-08, 0.0112642341, 0.0663479124, 0.148132766, 0.197308829, 0.2}},
      {0.5, {0.000406952017, 0.113844197, 0.26275627, 0.41156643, 0.495421505, 0.5}},
      {0.7, {0.0338948535, 0.342781635, 0.502191295, 0.628343014, 0.696295919, 0.7}},
      {0.975, {0.859683795, 0.936987332, 0.955416027, 0.96804304, 0.974640775, 0.975}},
};

/** u/U at s and tau. */
static double channel(const known *k, double s, double tau)
{
    double l = k->flow.length, nu = k->context.dynamic_viscosity / k->context.density;
    value v = at(k, tau * l * l / nu, 17, (s - 0.5) * l);
    ck_assert(v.vy == 0 && v.p == 0);
    return v.vx / k->flow.speed;
}

START_TEST(channels_follow_the_tables)
{
    known poiseuille = centred(SPH2D_FLOW_POISEUILLE), couette = centred(SPH2D_FLOW_COUETTE);
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 6; ++j) {
            same(channel(&poiseuille, poiseuille_table[i].s, ages[j]), poiseuille_table[i].u[j], 6e-10);
            same(channel(&couette, couette_table[i].s, ages[j]), couette_table[i].u[j], 6e-10);
        }
    ck_assert_double_eq_tol(channel(&couette, 0.2, 0.01) / 1.54172579e-08, 1, 1e-8);
}
END_TEST

START_TEST(channels_equal_sums_of_sines)
{
    /* Morris, Fox & Zhu 1997. Late enough for 400 terms, and on both sides of where the flow is called steady. */
    static const double taus[] = {3e-5, 1e-3, 0.01, 0.1, 0.3, 1, 2, 3.05, 3.9, 4.1, 100};
    known p = centred(SPH2D_FLOW_POISEUILLE), c = centred(SPH2D_FLOW_COUETTE);
    for (size_t i = 0; i < sizeof taus / sizeof taus[0]; ++i)
        for (double s = 0; s <= 1; s += 0.0625) {
            double poiseuille = 4 * s * (1 - s), couette = s;
            for (int n = 400; n > 0; --n) {
                double term = sin(n * TEST_PI * s) * exp(-n * n * TEST_PI * TEST_PI * taus[i]) / n / TEST_PI;
                couette += (n % 2 ? -2 : 2) * term;
                poiseuille -= n % 2 ? 32 * term / n / n / TEST_PI / TEST_PI : 0;
            }
            same(channel(&p, s, taus[i]), poiseuille, 2e-14);
            same(channel(&c, s, taus[i]), couette, 1e-14);
        }
}
END_TEST

START_TEST(channels_start_at_rest_and_stick_to_walls)
{
    known p = centred(SPH2D_FLOW_POISEUILLE), c = centred(SPH2D_FLOW_COUETTE);
    for (double s = -0.5; s <= 1.5; s += 0.125)
        ck_assert(channel(&p, s, 0) == 0 && channel(&c, s, 0) == 0);
    for (double tau = 1e-12; tau < 20; tau *= 3) {
        same(channel(&p, 0, tau), 0, 1e-14);
        same(channel(&p, 1, tau), 0, 1e-14);
        same(channel(&c, 0, tau), 0, 1e-14);
        same(channel(&c, 1, tau), 1, 1e-14);
        same(channel(&p, -0.1, tau), 0, 1e-14); /* beyond them, as they do */
        same(channel(&p, 1.1, tau), 0, 1e-14);
        same(channel(&c, -0.1, tau), 0, 1e-14);
        same(channel(&c, 1.1, tau), 1, 1e-14);
        if (tau < 1e-3) /* far from walls as if there were none */
            same(channel(&p, 0.5, tau) / tau, 8, 1e-13);
    }
}
END_TEST

/* ---- liquid under gravity ---------------------------------------------------------------------------------------- */

START_TEST(still)
{
    known k = centred(SPH2D_FLOW_STILL);
    value v = at(&k, 2, 0.3, -0.2);
    ck_assert(v.vx == 0 && v.vy == 0);
    same(v.p, 870 * (1.7 * 0.3 + 9.3 * 0.2), 1e-10);
    same(at(&k, 2, 0.93, 0.17).p, 0, 1e-10); /* along the surface */
    same(at(&k, 2, -9.3, -1.7).p, 0, 1e-10);
    ck_assert(at(&k, 2, 0.3, 0.2).p == 0 && at(&k, 2, -1, 0.1).p == 0); /* above it */
}
END_TEST

START_TEST(wave_in_a_tank)
{
    /* Half a wave in a tank of 1 m, 0.5 m deep: omega is 5.316553. */
    known k = {{SPH2D_FLOW_STANDING_WAVE, 0.01, 2, 0.5, {0, 0}}, {1000, 0, 0, {0, -9.81}, 0}};
    double omega = sqrt(9.81 * TEST_PI * tanh(TEST_PI / 2));
    same(omega, 5.316553, 5e-7);
    for (int i = 0; i < 20; ++i) {
        double t = 0.07 * i, y = -0.025 * i, x = 0.05 * i;
        same(at(&k, t, 0, 0).vy, 0.01 * cos(omega * t), 1e-15); /* the surface, where it swings most */
        same(at(&k, t, 1, 0).vy, -0.01 * cos(omega * t), 1e-15);
        same(at(&k, t, 0.5, y).vy, 0, 1e-16); /* a node */
        same(at(&k, t, 0, y).vx, 0, 1e-16);   /* walls and bottom */
        same(at(&k, t, 1, y).vx, 0, 1e-16);
        same(at(&k, t, x, -0.5).vy, 0, 1e-16);
        /* On the mean surface lies the weight of the wave, eta = U/omega cos kx sin(omega t). */
        double eta = 0.01 / omega * cos(TEST_PI * x) * sin(omega * t);
        same(at(&k, t, x, 0).p, fmax(0, 9810 * eta), 1e-10);
        same(at(&k, t, x, fmin(eta, 0) - 0.01).p, 9810 * (eta - fmin(eta, 0) + 0.01), 1); /* 1 % of k y */
    }
    value start = at(&k, 0, 0.25, -0.3);
    same(start.p, 9810 * 0.3, 1e-10);
    ck_assert(start.vx < 0 && start.vy > 0); /* upwards, and towards the crest that comes */
    ck_assert(at(&k, 0, 0.25, 0.1).p == 0);
}
END_TEST

START_TEST(wave_on_deep_water)
{
    known deep = {{SPH2D_FLOW_STANDING_WAVE, 0.01, 2, INFINITY, {0, 0}}, {1000, 0, 0, {0, -9.81}, 0}};
    known finite = deep, deeper = deep;
    finite.flow.depth = 20;
    deeper.flow.depth = 1e6;
    for (int i = 0; i < 20; ++i) {
        value a = at(&deep, 0.1 * i, 0.13 * i, -0.2 * i), b = at(&finite, 0.1 * i, 0.13 * i, -0.2 * i),
              c = at(&deeper, 0.1 * i, 0.13 * i, -0.2 * i);
        same(hypot(a.vx, a.vy), 0.01 * exp(-TEST_PI * 0.2 * i) * fabs(cos(0.1 * i * sqrt(9.81 * TEST_PI))), 1e-16);
        same(a.vx, b.vx, 1e-16);
        same(a.vy, b.vy, 1e-16);
        same(a.p, b.p, 1e-10);
        ck_assert(a.vx == c.vx && a.vy == c.vy && a.p == c.p);
    }
}
END_TEST

Suite *suite_flows_channels(void)
{
    Suite *suite = suite_create("flows_channels");
    TCase *tests = tcase_create("channels");
    tcase_add_test(tests, taylor_green);
    tcase_add_test(tests, gresho);
    tcase_add_test(tests, channels_follow_the_tables);
    tcase_add_test(tests, channels_equal_sums_of_sines);
    tcase_add_test(tests, channels_start_at_rest_and_stick_to_walls);
    tcase_add_test(tests, still);
    tcase_add_test(tests, wave_in_a_tank);
    tcase_add_test(tests, wave_on_deep_water);
    suite_add_tcase(suite, tests);
    return suite;
}
