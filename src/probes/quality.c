/* SPDX-License-Identifier: MIT */
/** @file quality.c
 *  A probe of the quality of the particle distribution: how even the spacing is, how uniform the density. */
#include <math.h>

#include "base/parallel.h"
#include "probes/probes.h"

/* Bins of distances from 0 to the support radius. */
enum { BINS = 2048 };

/** Histogram of the distances to the nearest neighbours: counts and minima, the same for any number of threads. */
typedef struct distances {
    size_t counts[BINS];
    double least[BINS]; /**< smallest in each bin [m] */
    size_t paired;      /**< number of distances below half a spacing */
} distances;

/** Distance from particle `i` to its nearest neighbour [m], at most the support radius. */
static double nearest(const sph2d_sim *sim, size_t i)
{
    const sph2d__store *f = &sim->system.fluid;
    double least2 = sim->system.support * sim->system.support;
    sph2d_vec2 at = {f->x[i], f->y[i]};
    sph2d__ranges ranges;
    if (!sph2d__sim_around(sim, &at, &ranges))
        return sim->system.support;
    SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
        double dx = at.x + ranges.x[r] - f->x[j], dy = at.y + ranges.y[r] - f->y[j];
        double r2 = dx * dx + dy * dy;
        least2 = j != i && r2 < least2 ? r2 : least2;
    }
    return sqrt(least2);
}

static void count_distances(const sph2d__system *s, distances *d, const double *found, size_t count)
{
    for (size_t k = 0; k < count; ++k) {
        size_t bin = (size_t)(found[k] / s->support * BINS);
        bin = bin < BINS ? bin : BINS - 1;
        ++d->counts[bin];
        d->least[bin] = found[k] < d->least[bin] ? found[k] : d->least[bin];
        d->paired += found[k] < s->spacing / 2;
    }
}

static void find_distances(const sph2d_sim *sim, distances *d)
{
    const sph2d__system *s = &sim->system;
    size_t count = s->fluid.count;
    for (int b = 0; b < BINS; ++b)
        d->least[b] = INFINITY;
#pragma omp taskloop num_tasks(sph2d__tasks(count, SPH2D__SLAB)) if (count > SPH2D__SLAB)
    for (size_t first = 0; first < count; first += SPH2D__SLAB) {
        double found[SPH2D__SLAB];
        size_t n = 0;
        for (; n < SPH2D__SLAB && first + n < count; ++n)
            found[n] = nearest(sim, first + n);
#pragma omp critical(sph2d_quality)
        count_distances(s, d, found, n);
    }
}

/** The quantile of the distances with rank `below`, to 1/2048 of the support radius [m]. */
static double quantile(const distances *d, size_t below)
{
    size_t bin = 0, seen = 0;
    while (seen + d->counts[bin] <= below)
        seen += d->counts[bin++];
    return d->least[bin];
}

size_t sph2d__probe_quality(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    (void)probe;
    const sph2d__system *s = &sim->system;
    const sph2d__store *f = &s->fluid;
    for (int k = 0; k < 8; ++k)
        values[k] = NAN;
    if (f->count == 0)
        return 8;
    distances found = {0}, *d = &found;
    find_distances(sim, d);
    double n = (double)f->count, square = 0, largest = 0, speed2 = 0;
    for (size_t i = 0; i < f->count; ++i) {
        double error = f->density[i] / s->rest_density - 1, v2 = f->vx[i] * f->vx[i] + f->vy[i] * f->vy[i];
        square += error * error;
        largest = fmax(largest, fabs(error));
        speed2 = fmax(speed2, v2);
    }
    values[0] = quantile(d, 0) / s->spacing;
    values[1] = quantile(d, f->count / 100) / s->spacing;
    values[2] = (double)d->paired / n;
    values[3] = sqrt(square / n);
    values[4] = largest;
    values[5] = sqrt(speed2) / s->sound_speed;
    sph2d_densities inside = sph2d_sim_densities(sim);
    values[6] = inside.reported;
    values[7] = inside.counted;
    return 8;
}
