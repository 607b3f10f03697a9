/* SPDX-License-Identifier: MIT */
/** @file channels.c
 *  Flow along x between two walls, starting at rest: du/dt = F + nu d^2u/dy^2, pressure 0. SPH codes have been held
 *  against both since Morris, Fox & Zhu 1997, who print them as sums of sines. Those need ever more terms towards time
 *  0. Here the walls are mirrors instead (Carslaw & Jaeger 1959, chapter III): each term is the answer of a half space
 *  to a wall, seen from one of its images. Terms come to 2 sqrt(tau) 6 at most, with tau = nu t/L^2.
 *
 *  Lengths are in L from here on: s = 0 at the lower wall, 1 at the upper, and w = 1/(2 sqrt(tau)). */
#include <math.h>

#include "base/pi.h"
#include "flows/flow.h"

/* erfc(6) is 2e-17. */
static const double FAR = 6;
/* From this tau on the flow is steady: exp(-pi^2 tau) is 7e-18. */
static const double STEADY = 4;

/** Position between the walls, 0 to 1; beyond a wall, that of the wall. */
static double place(const sph2d__flow_moment *m, double y)
{
    return fmin(fmax(y / m->flow->length + 0.5, 0), 1);
}

/** nu t/L^2. */
static double age(const sph2d__flow_moment *m)
{
    return m->viscosity * m->time / m->flow->length / m->flow->length;
}

/** The velocity deficit near a wall in liquid under a uniform force: 4 i^2erfc(z), 1 at the wall, where i^2erfc is erfc
 *  integrated twice (Carslaw & Jaeger 1959, appendix II). */
static double held_back(double z)
{
    return (1 + 2 * z * z) * erfc(z) - 2 / sqrt(SPH2D__PI) * z * exp(-z * z);
}

/** In the end u = 4 U s (1 - s), which F = 8 nu U/L^2 keeps going. Before,
 *
 *      u = F t (1 - sum_{n >= 0} (-1)^n (held_back((n + s) w) + held_back((n + 1 - s) w)))  */
static double poiseuille(double s, double tau)
{
    if (tau >= STEADY)
        return 4 * s * (1 - s);
    if (tau <= 0)
        return 0;
    double w = 0.5 / sqrt(tau), sum = 1, sign = -1;
    for (int n = 0; n * w < FAR; ++n) {
        sum += sign * (held_back((n + s) * w) + held_back((n + 1 - s) * w));
        sign = -sign;
    }
    return 8 * tau * sum;
}

/** In the end u = U s. Before,
 *
 *      u = U sum_{n >= 0} (erfc((2n + 1 - s) w) - erfc((2n + 1 + s) w))  */
static double couette(double s, double tau)
{
    if (tau >= STEADY)
        return s;
    if (tau <= 0)
        return 0;
    double w = 0.5 / sqrt(tau), sum = 0;
    for (int n = 0; n * w < FAR; n += 2)
        sum += erfc((n + 1 - s) * w) - erfc((n + 1 + s) * w);
    return sum;
}

sph2d__flow_value sph2d__flow_poiseuille(const sph2d__flow_moment *m, double x, double y)
{
    (void)x;
    return (sph2d__flow_value){m->flow->speed * poiseuille(place(m, y), age(m)), 0, 0};
}

sph2d__flow_value sph2d__flow_couette(const sph2d__flow_moment *m, double x, double y)
{
    (void)x;
    return (sph2d__flow_value){m->flow->speed * couette(place(m, y), age(m)), 0, 0};
}
