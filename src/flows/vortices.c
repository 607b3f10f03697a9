/* SPDX-License-Identifier: MIT */
/** @file vortices.c
 *  Vortices without a surface. */
#include <math.h>

#include "base/pi.h"
#include "flows/flow.h"

/** Taylor 1923; named after Taylor & Green 1937, whose flow is three-dimensional. With k = 2 pi/L and F = exp(-2 nu k^2
 *  t):
 *
 *      u = -U F cos kx sin ky,   v = U F sin kx cos ky,   p = -rho U^2/4 F^2 (cos 2kx + cos 2ky)
 *
 *  solves the Navier-Stokes equations: the advection is a gradient, which p balances, and nu laplace v = -2 nu k^2 v.
 */
sph2d__flow_value sph2d__flow_taylor_green(const sph2d__flow_moment *m, double x, double y)
{
    double k = 2 * SPH2D__PI / m->flow->length;
    double speed = m->flow->speed * exp(-2 * m->viscosity * k * k * m->time);
    return (sph2d__flow_value){
        .vx = -speed * cos(k * x) * sin(k * y),
        .vy = speed * sin(k * x) * cos(k * y),
        .pressure = -m->context->density / 4 * speed * speed * (cos(2 * k * x) + cos(2 * k * y)),
    };
}

/** Gresho & Chan 1990. Any round vortex is steady without viscosity when dp/dr = rho u^2/r. With s = r/L its speed u
 *  around the centre is a triangle, and p follows from p = 0 outside:
 *
 *      s < 0.2     u/U = 5 s         p/(rho U^2) = 2 - 4 ln 2 + 12.5 s^2
 *      s < 0.4     u/U = 2 - 5 s     p/(rho U^2) = 6 - 20 s + 12.5 s^2 + 4 ln(2.5 s)
 *
 *  The original has U = L = 1 and p = 3 + 4 ln 2 outside. */
sph2d__flow_value sph2d__flow_gresho(const sph2d__flow_moment *m, double x, double y)
{
    double s = sqrt(x * x + y * y) / m->flow->length, turn = 0, p = 0; /* turn: u/(U s) */
    if (s < 0.2) {
        turn = 5;
        p = 2 - 4 * log(2) + 12.5 * s * s;
    } else if (s < 0.4) {
        turn = 2 / s - 5;
        p = 6 - 20 * s + 12.5 * s * s + 4 * log(2.5 * s);
    }
    double rate = m->flow->speed / m->flow->length * turn;
    return (sph2d__flow_value){-rate * y, rate * x, m->context->density * m->flow->speed * m->flow->speed * p};
}
