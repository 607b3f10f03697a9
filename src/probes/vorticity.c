/* SPDX-License-Identifier: MIT */
/** @file vorticity.c
 *  Vorticity at particles, by linear functions that are fitted to the velocities around each of them: moving least
 *  squares of first order (P. Lancaster and K. Salkauskas, Mathematics of Computation 37, 1981). Particles are sorted by
 *  rows and along them, so that those around one are found by three marks that only advance, wherever stray ones are. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/memory.h"
#include "base/null.h"
#include "sph2d/field.h"

/* How far a particle is seen [spacings]. */
static const double reach_spacings = 3;

typedef struct particle {
    double row, x, y, vx, vy; /* the row is a whole number */
    size_t index;
} particle;

static int compare(const void *a, const void *b)
{
    const particle *p = a, *q = b;
    if (p->row != q->row)
        return p->row < q->row ? -1 : 1;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    return p->index < q->index ? -1 : p->index > q->index;
}

/* Weighted sums over the particles around one: distances and velocities from it. */
typedef struct sums {
    double w, x, y, xx, xy, yy, u, v, xv, yv, xu, yu;
} sums;

static void add(sums *s, double x, double y, double u, double v)
{
    const double rest = 1 - x * x - y * y;
    if (!(rest > 0))
        return;
    const double w = rest * rest;
    s->w += w;
    s->x += w * x;
    s->y += w * y;
    s->xx += w * x * x;
    s->xy += w * x * y;
    s->yy += w * y * y;
    s->u += w * u;
    s->v += w * v;
    s->xu += w * x * u;
    s->yu += w * y * u;
    s->xv += w * x * v;
    s->yv += w * y * v;
}

/* dv/dx - du/dy of the linear functions that fit best, distances in units of the reach; NaN where they are not unique. */
static double curl_of(const sums *s)
{
    const double x = s->x / s->w, y = s->y / s->w;
    const double xx = s->xx / s->w - x * x, xy = s->xy / s->w - x * y, yy = s->yy / s->w - y * y;
    const double xu = (s->xu - x * s->u) / s->w, yu = (s->yu - y * s->u) / s->w;
    const double xv = (s->xv - x * s->v) / s->w, yv = (s->yv - y * s->v) / s->w;
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-4 * (xx + yy) * (xx + yy)))
        return NAN;
    const double curl = (yy * xv - xy * yv - (xx * yu - xy * xu)) / determinant;
    return isfinite(curl) ? curl : NAN;
}

/* Takes the particles that are finite; returns their number. */
static size_t sort(particle *sorted, size_t count, const double *x, const double *y, const double *vx, const double *vy,
                   double reach)
{
    size_t taken = 0;
    for (size_t i = 0; i < count; ++i)
        if (isfinite(x[i]) && isfinite(y[i]) && isfinite(vx[i]) && isfinite(vy[i]))
            sorted[taken++] = (particle){floor(y[i] / reach), x[i], y[i], vx[i], vy[i], i};
    qsort(sorted, taken, sizeof *sorted, compare);
    return taken;
}

static void evaluate(const particle *sorted, size_t count, double reach, double *out)
{
    size_t first[3] = {0}; /* of those in the row below, the same and the one above that are near enough along it */
    for (size_t k = 0; k < count; ++k) {
        const particle *p = &sorted[k];
        sums s = {0};
        for (int side = 0; side < 3; ++side) {
            const double row = p->row + side - 1;
            size_t j = first[side];
            while (j < count && (sorted[j].row < row || (sorted[j].row == row && sorted[j].x < p->x - reach)))
                ++j;
            first[side] = j;
            for (; j < count && sorted[j].row == row && sorted[j].x <= p->x + reach; ++j)
                add(&s, (sorted[j].x - p->x) / reach, (sorted[j].y - p->y) / reach, sorted[j].vx - p->vx,
                    sorted[j].vy - p->vy);
        }
        out[p->index] = curl_of(&s) / reach;
    }
}

sph2d_status sph2d_vorticity(size_t count, const double *x, const double *y, const double *vx, const double *vy,
                             double spacing, double *out, sph2d_report *report)
{
    const void *const arrays[] = {x, y, vx, vy, out};
    static const char *const names[] = {"x", "y", "vx", "vy", "out"};
    for (int k = 0; k < 5 && count > 0; ++k)
        if (!arrays[k])
            return sph2d__null(report, "sph2d_vorticity", names[k]);
    if (!(spacing > 0 && isfinite(spacing))) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_OUT_OF_RANGE, NULL,
                         "the vorticity of particles needs their spacing: %g is not a positive number", spacing);
        return SPH2D_INVALID;
    }
    if (count == 0)
        return SPH2D_OK;
    sph2d__memory memory = sph2d__memory_from((sph2d_allocator){NULL, NULL});
    particle *sorted = sph2d__alloc(&memory, count, sizeof *sorted);
    if (!sorted) {
        sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL,
                         "out of memory for the vorticity of %zu particles", count);
        return SPH2D_NOMEM;
    }
    for (size_t i = 0; i < count; ++i)
        out[i] = NAN;
    const double reach = reach_spacings * spacing;
    evaluate(sorted, sort(sorted, count, x, y, vx, vy, reach), reach, out);
    sph2d__release(&memory, (void **)&sorted, count, sizeof *sorted);
    return SPH2D_OK;
}
