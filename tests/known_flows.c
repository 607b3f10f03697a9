/* SPDX-License-Identifier: MIT */
/** @file known_flows.c
 *  The flows of known_flows.h. */
#include "known_flows.h"

#include <math.h>

value at(const known *k, double t, double x, double y)
{
    value v = {NAN, NAN, NAN};
    sph2d_report report = {0};
    sph2d_status status = sph2d_flow_values(&k->flow, &k->context, t, 1, &x, &y, &v.vx, &v.vy, &v.p, &report);
    ck_assert_msg(status == SPH2D_OK, "%s: %s", sph2d_flow_name(k->flow.kind), test_report_text(&report));
    ck_assert(report.count == 0);
    return v;
}

const struct example examples[] = {
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

known known_of(const struct example *e)
{
    return (known){{e->kind, e->speed, 0.7, e->depth, {0.31, -0.17}},
                   {870, e->viscosity, 0.07, {e->gx, e->gy}, e->central}};
}

known example(sph2d_flow_kind kind)
{
    int i = 0;
    while (i < EXAMPLES - 1 && examples[i].kind != kind)
        ++i;
    return known_of(&examples[i]);
}

known centred(sph2d_flow_kind kind)
{
    known k = example(kind);
    k.flow.center[0] = k.flow.center[1] = 0;
    return k;
}

/** First and second differences of fourth order from values at -2 ... 2. */
static double first(const double f[5], double h)
{
    return (8 * (f[3] - f[1]) - (f[4] - f[0])) / (12 * h);
}

static double second(const double f[5], double h)
{
    return (16 * (f[3] + f[1]) - (f[4] + f[0]) - 30 * f[2]) / (12 * h * h);
}

change along(const known *k, double t, double x, double y, double ht, double hx, double hy)
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
