/* SPDX-License-Identifier: MIT */
/** @file drops.c
 *  Free liquid that turns rigidly, as a disc and as a square, and a drop under surface tension. */
#include <math.h>

#include "base/pi.h"
#include "flows/flow.h"

/** Velocity w (-y, x), w = U/L; dp/dr = rho w^2 r and p = 0 at r = L:
 *
 *      p = rho w^2/2 (r^2 - L^2)
 *
 *  Nothing is sheared, so that viscosity does nothing. All pressures are below 0. */
sph2d__flow_value sph2d__flow_rotation(const sph2d__flow_moment *m, double x, double y)
{
    double w = m->flow->speed / m->flow->length;
    double from_edge = x * x + y * y - m->flow->length * m->flow->length;
    return (sph2d__flow_value){-w * y, w * x, m->context->density * w * w / 2 * fmin(0, from_edge)};
}

/* Where the terms of a patch's pressure end: those that follow come to less than 1e-11 of its largest value. */
static const double REST = 1e-11;

/** Solution q of laplace q = 2 in the square of side 1 around 0, with q = 0 on its sides, at (|x|, |y|). y^2 - 1/4 has
 *  that curvature and is 0 on two sides. On the other two it is -8/pi^3 sum_{n odd} (+-)1/n^3 cos(n pi y), which
 *  harmonic terms take away:
 *
 *      q = y^2 - 1/4 + 8/pi^3 sum_{n odd} (+-)1/n^3 cos(n pi y) cosh(n pi x)/cosh(n pi/2)
 *
 *  They fall like exp(-n pi (1/2 - x)), fastest when x is the smaller of the coordinates. This is Saint-Venant's
 *  function of a square shaft under torsion (Timoshenko & Goodier 1951, rectangular bars). */
static double torsion(double x, double y)
{
    if (x > y)
        return torsion(y, x);
    if (!(y < 0.5))
        return 0;
    double sum = 0, sign = 1;
    for (double n = 1;; n += 2) {
        double inner = exp(-n * SPH2D__PI * (0.5 - x)), outer = exp(-n * SPH2D__PI * (0.5 + x));
        double fall = (inner + outer) / (1 + exp(-n * SPH2D__PI)) / (n * n);
        sum += sign * fall / n * cos(n * SPH2D__PI * y);
        sign = -sign;
        if (!(fall >= REST)) /* NaN ends it too */
            return y * y - 0.25 + 8 / (SPH2D__PI * SPH2D__PI * SPH2D__PI) * sum;
    }
}

/** A square of side L with the velocity of the disc (Colagrossi 2005; there it turns clockwise): laplace p = 2 rho w^2,
 *  p = 0 on the sides. It does not stay a square. */
sph2d__flow_value sph2d__flow_patch(const sph2d__flow_moment *m, double x, double y)
{
    double w = m->flow->speed / m->flow->length, u = m->flow->speed;
    double q = torsion(fabs(x) / m->flow->length, fabs(y) / m->flow->length);
    return (sph2d__flow_value){-w * y, w * x, m->context->density * u * u * q};
}

/** Laplace: the pressure in a disc, curved in one plane only, is sigma/L. Rayleigh (1879), Lamb (1932), art. 275, for a
 *  cylinder's second mode: a small strain at time 0 oscillates at w = sqrt(6 sigma/(rho L^3)), with
 *
 *      v = U/L cos wt (x, -y),   p = sigma/L + rho U w/(2 L) sin wt (x^2 - y^2),   r(theta) = L + U/w sin wt cos 2
 *  theta */
sph2d__flow_value sph2d__flow_drop(const sph2d__flow_moment *m, double x, double y)
{
    double radius = m->flow->length, tension = m->context->surface_tension, density = m->context->density;
    double pace = sqrt(6 * tension / (density * radius * radius * radius));
    double rate = m->flow->speed / radius, r2 = x * x + y * y, cos2 = (x * x - y * y) / (r2 > 0 ? r2 : 1);
    double moved = pace > 0 ? m->flow->speed / pace * sin(pace * m->time) : m->flow->speed * m->time;
    double inside = tension / radius + density * rate * pace / 2 * sin(pace * m->time) * (x * x - y * y);
    double v = rate * cos(pace * m->time);
    return (sph2d__flow_value){v * x, -v * y, sqrt(r2) <= radius + moved * cos2 ? inside : 0};
}
