/* SPDX-License-Identifier: MIT */
/** @file perimeters.c
 *  The perimeters of perimeters.h. */
#include "perimeters.h"

#include <math.h>
#include <stdlib.h>

static const double INNER = 1.0, OUTER = 2.0;

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/** What of the circle of radius a around particle i no other disc covers [rad]: between the ends of the arcs that they
 *  do cover it is bare where the middle is. */
static double bare_angle(const double *x, const double *y, size_t count, size_t i, double a)
{
    double ends[2 * MOST + 2], bare = 0;
    int n = 0;
    ends[n++] = -TEST_PI;
    ends[n++] = TEST_PI;
    for (size_t j = 0; j < count; ++j) {
        double r = hypot(x[j] - x[i], y[j] - y[i]);
        if (j == i || r >= 2 * a)
            continue;
        for (int side = -1; side <= 1; side += 2)
            ends[n++] = remainder(atan2(y[j] - y[i], x[j] - x[i]) + side * acos(r / (2 * a)), 2 * TEST_PI);
    }
    qsort(ends, (size_t)n, sizeof *ends, by_size);
    for (int k = 0; k + 1 < n; ++k) {
        double middle = (ends[k] + ends[k + 1]) / 2, px = x[i] + a * cos(middle), py = y[i] + a * sin(middle);
        bool covered = false;
        for (size_t j = 0; j < count; ++j)
            covered |= j != i && hypot(x[j] - px, y[j] - py) < a;
        bare += covered ? 0 : ends[k + 1] - ends[k];
    }
    return bare;
}

/** (a^2 - a1^2)(a2^2 - a^2), in spacings. */
static double weight(double a)
{
    return (a * a - INNER * INNER) * (OUTER * OUTER - a * a);
}

/** Integral over a of the weight and the bare perimeter of particle i's disc, in spacings, by the midpoint rule. */
static double band(const double *x, const double *y, size_t count, size_t i, int radii)
{
    double sum = 0, step = (OUTER - INNER) / radii;
    for (int k = 0; k < radii; ++k) {
        double a = INNER + (k + 0.5) * step;
        sum += weight(a) * a * bare_angle(x, y, count, i, a * DX) * step;
    }
    return sum;
}

/** A straight row's pull and energy a length, over sigma, when the weight is taken as it is: a surface at distance a
 *  has the length 2 a asin(d/2a) a particle, d the distance between them, and pulls with its derivative. */
static void row(double *pull, double *energy)
{
    enum { RADII = 20000 };
    double step = (OUTER - INNER) / RADII;
    *pull = *energy = 0;
    for (int k = 0; k < RADII; ++k) {
        double a = INNER + (k + 0.5) * step;
        *energy += weight(a) * 2 * a * asin(1 / (2 * a)) * step;
        *pull += weight(a) / sqrt(1 - 1 / (4 * a * a)) * step;
    }
}

/** Energy over sigma and the band's integral: the mean of a row's two figures is sigma. */
static double scale(void)
{
    double pull, energy;
    row(&pull, &energy);
    return 2 / (pull + energy);
}

double film(void)
{
    double pull, energy;
    row(&pull, &energy);
    return 2 * pull / (pull + energy);
}

double energy_by_perimeters(const double *x, const double *y, size_t count, int radii)
{
    double sum = 0;
    for (size_t i = 0; i < count; ++i)
        sum += band(x, y, count, i, radii);
    return SIGMA * scale() * DX * sum;
}
