/* SPDX-License-Identifier: MIT */
/** @file rows.c
 *  Projected Gauss-Seidel over contacts, accelerated by Nesterov's momentum (Nesterov, Soviet Math. Dokl. 27 (1983)
 *  372-376, equations 4 to 6). Nothing is known of the last step, and without momentum a pile of n layers takes n^2
 *  sweeps. To begin anew where changes grow had no use in piles.
 *  The nonsmooth conjugate gradients of Silcowitz-Hansen et al. (Vis. Comput. 26 (2010) 893-901) took three times the
 *  sweeps in piles with friction. */
#include "contacts/rows.h"

#include <math.h>

/* Sweeps end when no speed changes by more than this part of the largest change of the first sweep, */
#define TOLERANCE 1e-3
/* or after so many, since friction in piles takes thousands to settle beyond a few per cent. */
static int most_sweeps(size_t rows)
{
    return 40 + (int)(2 * sqrt((double)rows));
}

double sph2d__row_separation(const sph2d__row *row, const sph2d__mover *movers)
{
    const sph2d__mover *a = &movers[row->a], *b = &movers[row->b];
    return row->nx * (b->vx - a->vx) + row->ny * (b->vy - a->vy) + row->bn * b->w - row->an * a->w + row->wall_n;
}

double sph2d__row_slip(const sph2d__row *row, const sph2d__mover *movers)
{
    const sph2d__mover *a = &movers[row->a], *b = &movers[row->b];
    return row->nx * (b->vy - a->vy) - row->ny * (b->vx - a->vx) + row->bt * b->w - row->at * a->w + row->wall_t;
}

void sph2d__row_weigh(sph2d__row *row, const sph2d__mover *movers)
{
    const sph2d__mover *a = &movers[row->a], *b = &movers[row->b];
    double xx = row->nx * row->nx, yy = row->ny * row->ny, x = a->imx + b->imx, y = a->imy + b->imy;
    row->kn = xx * x + yy * y + row->an * row->an * a->ii + row->bn * row->bn * b->ii;
    row->kt = yy * x + xx * y + row->at * row->at * a->ii + row->bt * row->bt * b->ii;
    row->mn = row->kn > 0 ? 1 / row->kn : 0;
    row->mt = row->kt > 0 ? 1 / row->kt : 0;
}

/** Adds an impulse (x, y) on b with its turning part, and the opposite on a with that of a. */
static inline void push(sph2d__mover *a, sph2d__mover *b, double x, double y, double turn_a, double turn_b)
{
    a->vx -= a->imx * x;
    a->vy -= a->imy * y;
    a->w -= a->ii * turn_a;
    b->vx += b->imx * x;
    b->vy += b->imy * y;
    b->w += b->ii * turn_b;
}

/** The impulse of friction within its bounds. */
static double bounded(double jt, double most)
{
    double low = jt < -most ? -most : jt;
    return low > most ? most : low;
}

/** Changes the impulse along the normal such that the bodies separate fast enough. Returns the change. */
static inline double relax_normal(sph2d__row *row, sph2d__mover *movers)
{
    double jn = row->jn + (row->least - sph2d__row_separation(row, movers)) * row->mn;
    double change = (jn > 0 ? jn : 0) - row->jn;
    row->jn += change;
    if (change != 0)
        push(&movers[row->a], &movers[row->b], change * row->nx, change * row->ny, change * row->an, change * row->bn);
    return change;
}

/** Changes the impulse of friction such that the bodies do not slip, within its bounds. Returns the change. */
static inline double relax_friction(sph2d__row *row, sph2d__mover *movers)
{
    if (row->jn == 0 && row->jt == 0)
        return 0;
    double jt = row->jt - sph2d__row_slip(row, movers) * row->mt;
    double change = bounded(jt, row->friction * row->jn) - row->jt;
    row->jt += change;
    push(&movers[row->a], &movers[row->b], -change * row->ny, change * row->nx, change * row->at, change * row->bt);
    return change;
}

/** One sweep. Returns the largest change of a speed. */
static double sweep(sph2d__row *rows, size_t count, sph2d__mover *movers)
{
    double largest = 0;
    for (size_t i = 0; i < count; ++i) {
        sph2d__row *row = &rows[i];
        double n = fabs(relax_normal(row, movers)), t = fabs(relax_friction(row, movers));
        largest = fmax(largest, fmax(n * row->kn, t * row->kt));
    }
    return largest;
}

/** Goes on by the part `momentum` of what changed since the sweep before. */
static void go_on(sph2d__row *rows, size_t count, sph2d__mover *movers, double momentum)
{
    for (size_t i = 0; i < count; ++i) {
        sph2d__row *row = &rows[i];
        double jn = row->jn + momentum * (row->jn - row->pn);
        jn = jn > 0 ? jn : 0;
        double jt = bounded(row->jt + momentum * (row->jt - row->pt), row->friction * jn);
        double n = jn - row->jn, t = jt - row->jt;
        row->pn = row->jn;
        row->pt = row->jt;
        row->jn = jn;
        row->jt = jt;
        if (n != 0 || t != 0)
            push(&movers[row->a], &movers[row->b], n * row->nx - t * row->ny, n * row->ny + t * row->nx,
                 n * row->an + t * row->at, n * row->bn + t * row->bt);
    }
}

void sph2d__rows_solve(sph2d__row *rows, size_t count, sph2d__mover *movers)
{
    double first = sweep(rows, count, movers), largest = first, t = 1;
    for (int i = most_sweeps(count); i > 1 && largest > TOLERANCE * first; --i) {
        const double next = (1 + sqrt(1 + 4 * t * t)) / 2;
        go_on(rows, count, movers, (t - 1) / next);
        t = next;
        largest = sweep(rows, count, movers);
    }
}
