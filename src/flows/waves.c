/* SPDX-License-Identifier: MIT */
/** @file waves.c
 *  Liquid under gravity: at rest, and with a small standing wave. */
#include <math.h>

#include "base/pi.h"
#include "flows/flow.h"

/** Hydrostatics: p = rho g . (x - center), 0 above the surface. */
sph2d__flow_value sph2d__flow_still(const sph2d__flow_moment *m, double x, double y)
{
    const double *g = m->context->gravity;
    return (sph2d__flow_value){0, 0, fmax(0, m->context->density * (g[0] * x + g[1] * y))};
}

/** Linear theory of waves at depth d (Lamb 1932, art. 228), started by an impulse: the surface is at
 *
 *      eta = U/omega cos kx sin(omega t),   k = 2 pi/L,   omega^2 = g k tanh kd
 *
 *  and with the potential phi = U/k cos kx cos(omega t) cosh k(y + d)/sinh kd of the velocity
 *
 *      u = dphi/dx,   v = dphi/dy,   p = -rho g y - rho dphi/dt
 *
 *  Products of small quantities, k eta, are left out. Hyperbolic functions are written with exp(-kd), which has no
 *  overflow in deep water. */
sph2d__flow_value sph2d__flow_standing_wave(const sph2d__flow_moment *m, double x, double y)
{
    double g = -m->context->gravity[1], speed = m->flow->speed, depth = m->flow->depth;
    double k = 2 * SPH2D__PI / m->flow->length, omega = sqrt(g * k * tanh(k * depth));
    double down = exp(k * y), up = exp(-k * (y + 2 * depth)), all = -expm1(-2 * k * depth);
    double cosh_part = (down + up) / all, sinh_part = (down - up) / all; /* over sinh kd */
    double now = speed * cos(omega * m->time);
    double lift = speed * omega / k * sin(omega * m->time) * cos(k * x) * cosh_part; /* -dphi/dt */
    return (sph2d__flow_value){
        .vx = -now * sin(k * x) * cosh_part,
        .vy = now * cos(k * x) * sinh_part,
        .pressure = fmax(0, m->context->density * (lift - g * y)),
    };
}
