/* SPDX-License-Identifier: MIT */
/** @file elevation.c
 *  A probe of the free surface above a place.
 *
 *  Liquid fills a place by the fraction sum_j V W(r_j), V the volume of a particle at rest, W Wendland's C2: 1 inside,
 *  1/2 at a surface, where half the kernel is empty. Beside a wall the liquid's half is cut by what the wall takes of
 *  it: there the surface is where liquid and the part of the wall below it fill a half,
 *
 *      sum_j V W(r_j) + sum_b V_b c_b W(r_b) = 1/2,   c_b from 1 below to 0 above, over a spacing,
 *
 *  below being where the force per mass points that a liquid at rest on the wall feels, g - a_b with a_b the wall's
 *  acceleration: across it lies a surface whose pressure is uniform, whatever the slope of the wall, in corners and at
 *  edges. Sides of the domain without boundary particles in layers mirror the liquid instead. A place from which a wall
 *  hides the nearest liquid is none of the liquid's. */
#include <math.h>

#include "kernels/kernel.h"
#include "probes/probes.h"

/* Heights to look at, for each spacing; halvings of the last stretch. */
enum { LOOKS = 4, HALVINGS = 40 };
/* Liquid that fills less than this has no surface there, though a wall may take all the rest. */
static const double LEAST = 0.02;
/* Liquid that fills this with the walls around reaches up to the roof. */
static const double ROOF = 0.75;
/* A place on a wall counts as before it, in spacings. */
static const double NUDGE = 0.01;

/** What fills the surroundings of a place. */
typedef struct filling {
    double liquid, below, walls; /**< fractions; `below` is the part of the walls that is below the place */
    sph2d_vec2 nearest;          /**< way to the nearest liquid [m] */
    double nearest2;
} filling;

static double weight_at(const sph2d__system *s, double dx, double dy)
{
    double q = sqrt(dx * dx + dy * dy) / s->support;
    return q < 1 ? sph2d__kernel_value_at(SPH2D_KERNEL_WENDLAND_C2, q) : 0;
}

/** Factor that makes a fraction of weights and areas [1/m^2]. */
static double unit_of(const sph2d__system *s)
{
    return sph2d__kernel_constant(SPH2D_KERNEL_WENDLAND_C2) / (s->support * s->support);
}

static void add_liquid(const sph2d_sim *sim, sph2d_vec2 at, filling *sum)
{
    const sph2d__system *s = &sim->system;
    double unit = s->mass / s->rest_density * unit_of(s);
    sph2d__ranges ranges;
    if (!sph2d__sim_around(sim, &at, &ranges))
        return;
    SPH2D__FOR_NEIGHBOURS (&ranges, r, j) {
        double dx = at.x + ranges.x[r] - s->fluid.x[j], dy = at.y + ranges.y[r] - s->fluid.y[j];
        double r2 = dx * dx + dy * dy;
        sum->liquid += unit * weight_at(s, dx, dy);
        if (r2 < sum->nearest2) {
            sum->nearest2 = r2;
            sum->nearest = (sph2d_vec2){-dx, -dy};
        }
    }
}

/** How far below a place boundary particle b is that lies (x, y) off [m]. */
static double depth_of(const sph2d__system *s, size_t b, double x, double y)
{
    double gx = s->body.gravity_x, gy = s->body.gravity_y;
    if (s->walls.ax) {
        gx -= s->walls.ax[b];
        gy -= s->walls.ay[b];
    }
    double g = hypot(gx, gy);
    return gy < 0 ? (x * gx + y * gy) / g : -y;
}

static void add_walls(const sph2d_sim *sim, sph2d_vec2 at, filling *sum)
{
    const sph2d__system *s = &sim->system;
    const sph2d__store *w = &s->walls;
    const sph2d__period *period = &s->wall_cells.period;
    at.x = sph2d__period_wrap(at.x, period->low_x, period->length_x);
    at.y = sph2d__period_wrap(at.y, period->low_y, period->length_y);
    uint32_t cell = w->count > 0 && w->mass ? sph2d__cells_find(&s->wall_cells, at.x, at.y) : UINT32_MAX;
    if (cell == UINT32_MAX)
        return;
    sph2d__ranges ranges;
    sph2d__cells_ranges(&s->wall_cells, cell, &ranges);
    SPH2D__FOR_NEIGHBOURS (&ranges, r, b) {
        double dx = at.x + ranges.x[r] - w->x[b], dy = at.y + ranges.y[r] - w->y[b];
        double part = unit_of(s) * w->mass[b] / s->rest_density * weight_at(s, dx, dy);
        double depth = depth_of(s, b, -dx, -dy) / s->spacing;
        sum->walls += part;
        sum->below += part * fmin(fmax(0.5 + depth, 0), 1);
    }
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
static filling fill(const sph2d_sim *sim, double x, double y)
{
    sph2d_boundary b = sim->scene.boundary;
    sph2d_box d = sim->scene.domain;
    bool mirrors = sim->scene.walls != SPH2D_WALL_GENERALISED;
    double xs[3], ys[3], support = sim->system.support;
    int nx = mirror(x, d.min.x, mirrors && b.left == SPH2D_SIDE_WALL, d.max.x, mirrors && b.right == SPH2D_SIDE_WALL,
                    support, xs);
    int ny = mirror(y, d.min.y, mirrors && b.bottom == SPH2D_SIDE_WALL, d.max.y, mirrors && b.top == SPH2D_SIDE_WALL,
                    support, ys);
    filling sum = {.nearest2 = INFINITY};
    for (int i = 0; i < nx; ++i)
        for (int j = 0; j < ny; ++j)
            add_liquid(sim, (sph2d_vec2){xs[i], ys[j]}, &sum);
    add_walls(sim, (sph2d_vec2){x, y}, &sum);
    return sum;
}

/** Whether no wall stands between a place and the nearest liquid. */
static bool is_before_walls(const sph2d_sim *sim, double x, double y, const filling *sum)
{
    double r = sqrt(sum->nearest2), nudge = r > 0 ? NUDGE * sim->scene.spacing / r : 0;
    if (!(nudge < 1))
        return true;
    sph2d_vec2 from = {x + nudge * sum->nearest.x, y + nudge * sum->nearest.y};
    sph2d_vec2 to = {x + sum->nearest.x, y + sum->nearest.y};
    return !sph2d__sim_crosses_wall(sim, from, to);
}

/** Whether a place is in liquid, and what fills it. */
static bool is_filled(const sph2d_sim *sim, double x, double y, filling *sum)
{
    *sum = fill(sim, x, y);
    return sum->liquid >= LEAST && sum->liquid + sum->below >= 0.5 && is_before_walls(sim, x, y, sum);
}

/** Whether liquid reaches up to the highest place where it may be. */
static bool is_full(const sph2d_sim *sim, double x, double y)
{
    filling sum;
    if (sim->scene.boundary.top == SPH2D_SIDE_WALL && sim->scene.walls == SPH2D_WALL_GENERALISED) {
        sum = fill(sim, x, y);
        return sum.liquid + sum.walls >= ROOF;
    }
    return is_filled(sim, x, y, &sum);
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
        filling sum;
        double middle = low + (high - low) / 2;
        if (is_filled(sim, x, middle, &sum))
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
    if (is_full(sim, x, y))
        return y;
    while (y > end) {
        double next = fmax(y - step, end);
        filling sum;
        if (is_filled(sim, x, next, &sum))
            return bisect(sim, x, next, y);
        if (!(sum.liquid > 0)) /* far below may be more */
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
