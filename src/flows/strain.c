/* SPDX-License-Identifier: MIT */
/** @file strain.c
 *  A free disc that becomes an ellipse: Monaghan 1994, without a force; Monaghan & Rafiee 2013, under a central force
 *  -B^2 x.
 *
 *  The velocity is (A x, -A y), so that the semi-axes follow a' = A a, b' = -A b. With p = pc (1 - x^2/a^2 - y^2/b^2),
 *  which is 0 on the ellipse, the momentum equations along x and y are
 *
 *      A' + A^2 + B^2 = 2 pc/(rho a^2),   -A' + A^2 + B^2 = 2 pc/(rho b^2)
 *
 *  and therefore pc = rho (A^2 + B^2) a^2 b^2/(a^2 + b^2),   A' = -(A^2 + B^2) (a^2 - b^2)/(a^2 + b^2).
 *
 *  Area is conserved, a b = L^2, so that with a = L exp(s), b = L exp(-s) two equations remain:
 *
 *      s' = A,   A' = -(A^2 + B^2) tanh 2s
 *
 *  Kinetic plus potential energy is proportional to (A^2 + B^2) (a^2 + b^2), and a^2 + b^2 has its minimum at the
 *  start: the rate sqrt(A^2 + B^2) is never larger than there. */
#include <math.h>

#include "flows/flow.h"

/* Length of a Runge-Kutta step times the largest rate. */
static const double STEP = 0.002;

typedef struct shape {
    double s, rate;
} shape;

double sph2d__flow_strain_pace(const sph2d_flow *flow, const sph2d_flow_context *context)
{
    return hypot(flow->speed / flow->length, context->central_rate);
}

/** Its change in time. */
static shape slope(shape now, double b2)
{
    return (shape){now.rate, -(now.rate * now.rate + b2) * tanh(2 * now.s)};
}

static shape ahead(shape now, double dt, shape change)
{
    return (shape){now.s + dt * change.s, now.rate + dt * change.rate};
}

/** Kutta's step of fourth order. */
static shape step(shape now, double dt, double b2)
{
    shape k1 = slope(now, b2);
    shape k2 = slope(ahead(now, dt / 2, k1), b2);
    shape k3 = slope(ahead(now, dt / 2, k2), b2);
    shape k4 = slope(ahead(now, dt, k3), b2);
    shape mean = {(k1.s + 2 * k2.s + 2 * k3.s + k4.s) / 6, (k1.rate + 2 * k2.rate + 2 * k3.rate + k4.rate) / 6};
    return ahead(now, dt, mean);
}

void sph2d__flow_strain_axes(sph2d__flow_moment *m)
{
    double b2 = m->context->central_rate * m->context->central_rate;
    size_t steps = (size_t)ceil(m->time * sph2d__flow_strain_pace(m->flow, m->context) / STEP);
    shape now = {0, m->flow->speed / m->flow->length};
    for (size_t i = 0; i < steps; ++i)
        now = step(now, m->time / (double)steps, b2);
    m->a = m->flow->length * exp(now.s);
    m->b = m->flow->length * exp(-now.s);
    m->rate = now.rate;
}

sph2d__flow_value sph2d__flow_strain(const sph2d__flow_moment *m, double x, double y)
{
    double a2 = m->a * m->a, b2 = m->b * m->b, central = m->context->central_rate;
    double middle = m->context->density * (m->rate * m->rate + central * central) * a2 * b2 / (a2 + b2);
    double inside = 1 - x * x / a2 - y * y / b2;
    return (sph2d__flow_value){m->rate * x, -m->rate * y, fmax(0, middle * inside)};
}
