/* SPDX-License-Identifier: MIT */
/** @file probe_elevation.c
 *  A probe of the free surface above a place.
 *
 *  Liquid fills a place by the fraction sum_j V W(r_j), V the volume of a particle at rest, W Wendland's C2: 1 inside,
 *  1/2 at a surface, where half the kernel is empty. Behind the domain's walls liquid is mirrored, so that its surface
 *  is found as high there. */
#include <math.h>

#include "kernels/kernel.h"
#include "sim/probes.h"

/* Heights to look at, for each spacing; halvings of the last stretch. */
enum { LOOKS = 4, HALVINGS = 40 };

static double fill_without_mirrors(const sph2d_sim *sim, sph2d_vec2 at)
{
    const sph2d__system *s = &sim->system;
    double sum = 0;
    sph2d__ranges ranges;
    if (!sph2d__sim_around(sim, &at, &ranges))
        return 0;
    SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
        double dx = at.x + ranges.x[r] - s->fluid.x[j], dy = at.y + ranges.y[r] - s->fluid.y[j];
        double q = sqrt(dx * dx + dy * dy) / s->support;
        if (q < 1)
            sum += sph2d__kernel_value_at(SPH2D_KERNEL_WENDLAND_C2, q);
    }
    double volume = s->mass / s->rest_density, support2 = s->support * s->support;
    return volume * sph2d__kernel_constant(SPH2D_KERNEL_WENDLAND_C2) / support2 * sum;
}

/** A coordinate, and its images in the walls that are within the support radius. Returns how many. */
static int mirror(double x, double low, bool low_wall, double high, bool high_wall, double support, double out[3])
{
    int count = 0;
    out[count++] = x;
    if (low_wall && x - low < support)
        out[count++] = 2 * low - x;
    if (high_wall && high - x < support)
        out[count++] = 2 * high - x;
    return count;
}

/** Mirrored liquid is as far from a place as liquid is from the mirrored place. */
static double fill(const sph2d_sim *sim, double x, double y)
{
    sph2d_boundary b = sim->scene.boundary;
    sph2d_box d = sim->scene.domain;
    double xs[3], ys[3], support = sim->system.support, sum = 0;
    int nx = mirror(x, d.min.x, b.left == SPH2D_SIDE_WALL, d.max.x, b.right == SPH2D_SIDE_WALL, support, xs);
    int ny = mirror(y, d.min.y, b.bottom == SPH2D_SIDE_WALL, d.max.y, b.top == SPH2D_SIDE_WALL, support, ys);
    for (int i = 0; i < nx; ++i)
        for (int j = 0; j < ny; ++j)
            sum += fill_without_mirrors(sim, (sph2d_vec2){xs[i], ys[j]});
    return sum;
}

/** Height of the highest particle below y that is within the support radius of the line at x; -INFINITY for none. */
static double highest_below(const sph2d_sim *sim, double x, double y)
{
    const sph2d__store *f = &sim->system.fluid;
    double period = sim->system.fluid_cells.period.length_x, highest = -INFINITY;
    for (size_t i = 0; i < f->count; ++i)
        if (f->y[i] < y && f->y[i] > highest && fabs(sph2d__period_nearest(f->x[i] - x, period)) < sim->system.support)
            highest = f->y[i];
    return highest;
}

/** The height between `low`, inside liquid, and `high`, outside, where half is filled. */
static double bisect(const sph2d_sim *sim, double x, double low, double high)
{
    for (int k = 0; k < HALVINGS; ++k) {
        double middle = low + (high - low) / 2;
        if (fill(sim, x, middle) >= 0.5)
            low = middle;
        else
            high = middle;
    }
    return low + (high - low) / 2;
}

/** Looks downwards along the line at x, from the highest place where liquid may be to the lowest. */
static double find_surface(const sph2d_sim *sim, double x)
{
    sph2d_boundary b = sim->scene.boundary;
    sph2d_box d = sim->scene.domain;
    double height = d.max.y - d.min.y, step = sim->system.spacing / LOOKS;
    double y = b.top == SPH2D_SIDE_OPEN ? d.max.y + height : d.max.y;
    double end = b.bottom == SPH2D_SIDE_OPEN ? d.min.y - height : d.min.y;
    if (fill(sim, x, y) >= 0.5)
        return y;
    while (y > end) {
        double next = fmax(y - step, end), filled = fill(sim, x, next);
        if (filled >= 0.5)
            return bisect(sim, x, next, y);
        if (!(filled > 0)) /* far below may be more */
            next = fmin(next, highest_below(sim, x, next) + sim->system.support);
        y = next;
    }
    return NAN;
}

size_t sph2d__probe_elevation(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    values[0] = find_surface(sim, probe->at.x);
    return 1;
}
