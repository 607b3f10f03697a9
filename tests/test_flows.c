/* SPDX-License-Identifier: MIT */
/** @file test_flows.c
 *  Known flows against what makes them known: the equations of motion, by finite differences of the code's values;
 *  their conditions at walls and surfaces; and numbers that were computed in another way. Nothing has the size 1, so
 *  that no factor can be lost. */
#include <math.h>
#include <string.h>

#include "common.h"
#include "sph2d/flow.h"

typedef struct value {
    double vx, vy, p;
} value;

/** A flow with all that belongs to it. */
typedef struct known {
    sph2d_flow flow;
    sph2d_flow_context context;
} known;

static value at(const known *k, double t, double x, double y)
{
    value v = {NAN, NAN, NAN};
    sph2d_report report = {0};
    sph2d_status status = sph2d_flow_values(&k->flow, &k->context, t, 1, &x, &y, &v.vx, &v.vy, &v.p, &report);
    ck_assert_msg(status == SPH2D_OK, "%s: %s", sph2d_flow_name(k->flow.kind), test_report_text(&report));
    ck_assert(report.count == 0);
    return v;
}

#define same(is, should_be, tolerance) ck_assert_double_eq_tol(is, should_be, tolerance)

/* ---- the flows that are looked at -------------------------------------------------------------------------------- */

/* L = 0.7 m, density 870 kg/m^3, centre (0.31, -0.17) m. Points are taken from a box around the centre, at times
 * on both sides of every switch of formulas. */
static const struct example {
    sph2d_flow_kind kind;
    double speed, depth, viscosity, gx, gy, central, time, box[4];
} examples[] = {
    {SPH2D_FLOW_STILL, 0, 0, 0, 1.7, -9.3, 0, 3, {0.1, 0.9, -0.9, -0.2}},
    {SPH2D_FLOW_TAYLOR_GREEN, 1.3, 0, 8, 0, 0, 0, 0.01, {-0.4, 0.4, -0.4, 0.4}},
    {SPH2D_FLOW_TAYLOR_GREEN, -1.3, 0, 8, 0, 0, 0, 0.6, {-0.4, 0.4, -0.4, 0.4}},
    {SPH2D_FLOW_GRESHO, 1.3, 0, 0, 0, 0, 0, 0.2, {-0.09, 0.09, -0.09, 0.09}},
    {SPH2D_FLOW_GRESHO, -1.3, 0, 0, 0, 0, 0, 0.2, {0.12, 0.18, -0.18, -0.12}},
    {SPH2D_FLOW_GRESHO, 1.3, 0, 0, 0, 0, 0, 0.2, {0.21, 0.5, 0.21, 0.5}},
    {SPH2D_FLOW_POISEUILLE, 1.3, 0, 8.7, 0.104 / 0.49, 0, 0, 0.98, {-1, 1, -0.34, 0.34}}, /* gx = 8 nu U/L^2 */
    {SPH2D_FLOW_POISEUILLE, -1.3, 0, 8.7, -0.104 / 0.49, 0, 0, 9.8, {-1, 1, -0.34, 0.34}},
    {SPH2D_FLOW_POISEUILLE, 1.3, 0, 8.7, 0.104 / 0.49, 0, 0, 245, {-1, 1, -0.34, 0.34}},
    {SPH2D_FLOW_COUETTE, 1.3, 0, 8.7, 0, 0, 0, 0.98, {-1, 1, -0.34, 0.34}},
    {SPH2D_FLOW_COUETTE, -1.3, 0, 8.7, 0, 0, 0, 9.8, {-1, 1, -0.34, 0.34}},
    {SPH2D_FLOW_COUETTE, 1.3, 0, 8.7, 0, 0, 0, 245, {-1, 1, -0.34, 0.34}},
    {SPH2D_FLOW_STANDING_WAVE, 0.1, 0.8, 0, 0, -9.81, 0, 0.37, {-1, 1, -0.79, -0.1}},
    {SPH2D_FLOW_STANDING_WAVE, -0.1, 0.1, 0, 0, -9.81, 0, 0.37, {-1, 1, -0.099, -0.05}},
    {SPH2D_FLOW_STANDING_WAVE, 0.1, INFINITY, 0, 0, -9.81, 0, 0.37, {-1, 1, -0.79, -0.1}},
    {SPH2D_FLOW_STRAIN, 1.3, 0, 5, 0, 0, 0, 0.4, {-0.4, 0.4, -0.2, 0.2}},
    {SPH2D_FLOW_STRAIN, -1.3, 0, 0, 0, 0, 0, 0.4, {-0.2, 0.2, -0.4, 0.4}},
    {SPH2D_FLOW_STRAIN, 1.3, 0, 0, 0, 0, 1.9, 0.9, {-0.3, 0.3, -0.3, 0.3}},
    {SPH2D_FLOW_ROTATION, 1.3, 0, 50, 0, 0, 0, 1.7, {-0.4, 0.4, -0.4, 0.4}},
    {SPH2D_FLOW_DROP, 0, 0, 50, 0, 0, 0, 1.7, {-0.4, 0.4, -0.4, 0.4}},
    {SPH2D_FLOW_DROP, 0.002, 0, 0, 0, 0, 0, 17, {-0.4, 0.4, -0.4, 0.4}},
    {SPH2D_FLOW_PATCH, 1.3, 0, 50, 0, 0, 0, 0, {0, 0, 0, 0}}, /* no time but 0: has a test of its own */
};
enum { EXAMPLES = sizeof examples / sizeof examples[0] };

static known known_of(const struct example *e)
{
    return (known){{e->kind, e->speed, 0.7, e->depth, {0.31, -0.17}},
                   {870, e->viscosity, 0.07, {e->gx, e->gy}, e->central}};
}

/** The first example of a kind. */
static known example(sph2d_flow_kind kind)
{
    int i = 0;
    while (i < EXAMPLES - 1 && examples[i].kind != kind)
        ++i;
    return known_of(&examples[i]);
}

/** The same with centre (0, 0). */
static known centred(sph2d_flow_kind kind)
{
    known k = example(kind);
    k.flow.center[0] = k.flow.center[1] = 0;
    return k;
}

/* ---- equations of motion ----------------------------------------------------------------------------------------- */

/** First and second differences of fourth order from values at -2 ... 2. */
static double first(const double f[5], double h)
{
    return (8 * (f[3] - f[1]) - (f[4] - f[0])) / (12 * h);
}

static double second(const double f[5], double h)
{
    return (16 * (f[3] + f[1]) - (f[4] + f[0]) - 30 * f[2]) / (12 * h * h);
}

/** Derivatives along one direction: x, y or t. */
typedef struct change {
    value first, second;
} change;

static change along(const known *k, double t, double x, double y, double ht, double hx, double hy)
{
    double vx[5], vy[5], p[5], h = ht + hx + hy;
    for (int i = 0; i < 5; ++i) {
        value v = at(k, t + (i - 2) * ht, x + (i - 2) * hx, y + (i - 2) * hy);
        vx[i] = v.vx;
        vy[i] = v.vy;
        p[i] = v.p;
    }
    return (change){{first(vx, h), first(vy, h), first(p, h)}, {second(vx, h), second(vy, h), second(p, h)}};
}

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
    refused(&k, 0, SPH2D_CODE_GENERAL, "none");
    k.flow.kind = (sph2d_flow_kind)11;
    refused(&k, 0, SPH2D_CODE_GENERAL, "none");
    k.flow.kind = (sph2d_flow_kind)-1;
    refused(&k, 0, SPH2D_CODE_GENERAL, "none");
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
    tcase_add_test(tests, taylor_green);
    tcase_add_test(tests, gresho);
    tcase_add_test(tests, channels_follow_the_tables);
    tcase_add_test(tests, channels_equal_sums_of_sines);
    tcase_add_test(tests, channels_start_at_rest_and_stick_to_walls);
    tcase_add_test(tests, still);
    tcase_add_test(tests, wave_in_a_tank);
    tcase_add_test(tests, wave_on_deep_water);
    tcase_add_loop_test(tests, axes_of_the_ellipse, 0, ELLIPSES);
    tcase_add_test(tests, ellipse_follows_the_table);
    tcase_add_test(tests, ellipse_swings_with_its_period);
    tcase_add_test(tests, ellipse_at_rest_stays_a_disc);
    tcase_add_test(tests, rotation);
    tcase_add_test(tests, patch);
    tcase_add_test(tests, patch_turns_and_is_free);
    tcase_add_test(tests, drop);
    tcase_add_test(tests, drop_swings);
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
