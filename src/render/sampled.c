/* SPDX-License-Identifier: MIT */
/** @file sampled.c
 *  Moving least squares (P. Lancaster and K. Salkauskas, Mathematics of Computation 37, 1981) of first order. */
#include "render/sampled.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Sums of a node: of weights, of these times the distances to the right and up and their products, all over the reach;
 * then of each value, and of it times the distances. */
enum { W, WX, WY, WXX, WXY, WYY, WF, WXF, WYF, WG, WXG, WYG, SUMS };

enum { MOST_NODES = 400000 };

/* How far a particle reaches, in spacings; the sum of (1 - r^2)^2 over a full disc of this radius is pi/3 times its
 * square. */
static const double reach_spacings = 3.0, full = 9.42477796076938;

static bool lay(sph2d__sampled *s, sph2d_box box, double step)
{
    const double width = box.max.x - box.min.x, height = box.max.y - box.min.y;
    s->step = fmax(step, fmax(sqrt(width * height / MOST_NODES), fmax(width, height) / MOST_NODES));
    s->origin = (sph2d_vec2){ceil(box.min.x / s->step) * s->step, ceil(box.min.y / s->step) * s->step};
    s->columns = (int)fmax(floor((box.max.x - s->origin.x) / s->step) + 1, 0);
    s->rows = (int)fmax(floor((box.max.y - s->origin.y) / s->step) + 1, 0);
    const size_t nodes = (size_t)s->columns * (size_t)s->rows;
    if (nodes > s->capacity) {
        double *grown = realloc(s->sums, nodes * SUMS * sizeof *grown);
        if (!grown)
            return false;
        s->sums = grown;
        s->capacity = nodes;
    }
    if (nodes > 0)
        memset(s->sums, 0, nodes * SUMS * sizeof *s->sums);
    return true;
}

/* Adds a particle to a node at a distance, in units of the reach. */
static void add(double *sum, double x, double y, double f, double g)
{
    const double rest = 1.0 - x * x - y * y;
    if (rest <= 0.0)
        return;
    const double w = rest * rest, wx = w * x, wy = w * y;
    const double terms[SUMS] = {w, wx, wy, wx * x, wx * y, wy * y, w * f, wx * f, wy * f, w * g, wx * g, wy * g};
    for (int k = 0; k < SUMS; ++k)
        sum[k] += terms[k];
}

/* The nodes within a distance of a coordinate, in steps from the first one. */
static void range_of(double at, double distance, int count, int *first, int *end)
{
    *first = (int)fmin(fmax(ceil(at - distance), 0.0), count);
    *end = (int)fmin(fmax(floor(at + distance) + 1.0, 0.0), count);
}

bool sph2d__sampled_take(sph2d__sampled *s, sph2d_box box, double step, const sph2d__samples *p)
{
    if (!lay(s, box, step))
        return false;
    const double reach = reach_spacings * p->spacing;
    for (size_t i = 0; i < p->count; ++i) {
        const double f = p->first[i], g = p->second ? p->second[i] : 0.0;
        const double x = (p->x[i] - s->origin.x) / s->step, y = (p->y[i] - s->origin.y) / s->step;
        if (!isfinite(x) || !isfinite(y) || !isfinite(f) || !isfinite(g))
            continue;
        int left, right, lower, upper;
        range_of(x, reach / s->step, s->columns, &left, &right);
        range_of(y, reach / s->step, s->rows, &lower, &upper);
        for (int row = lower; row < upper; ++row)
            for (int column = left; column < right; ++column)
                add(s->sums + ((size_t)row * (size_t)s->columns + (size_t)column) * SUMS,
                    (x - column) * s->step / reach, (y - row) * s->step / reach, f, g);
    }
    return true;
}

sph2d_vec2 sph2d__sampled_place(const sph2d__sampled *s, int column, int row)
{
    return (sph2d_vec2){s->origin.x + column * s->step, s->origin.y + row * s->step};
}

/* The fitted function at the node itself; the mean where the particles are on a line, or one. */
static double fit(const double *sum, const double *of)
{
    const double x = sum[WX] / sum[W], y = sum[WY] / sum[W], mean = of[0] / sum[W];
    const double xx = sum[WXX] / sum[W] - x * x, xy = sum[WXY] / sum[W] - x * y, yy = sum[WYY] / sum[W] - y * y;
    const double xf = of[1] / sum[W] - x * mean, yf = of[2] / sum[W] - y * mean, determinant = xx * yy - xy * xy;
    if (determinant < 1.0e-4 * (xx + yy) * (xx + yy))
        return mean;
    return mean - (x * (yy * xf - xy * yf) + y * (xx * yf - xy * xf)) / determinant;
}

bool sph2d__sampled_at(const sph2d__sampled *s, int column, int row, double part, double values[2])
{
    const double *sum = s->sums + ((size_t)row * (size_t)s->columns + (size_t)column) * SUMS;
    if (!(sum[W] > part * full))
        return false;
    values[0] = fit(sum, sum + WF);
    values[1] = fit(sum, sum + WG);
    return true;
}

void sph2d__sampled_free(sph2d__sampled *sampled)
{
    free(sampled->sums);
    *sampled = (sph2d__sampled){0};
}
