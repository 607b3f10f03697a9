/* SPDX-License-Identifier: MIT */
/** @file elevation.c
 *  A probe of the free surface above a point.
 *
 *  The fill fraction at a position is sum_j V W(r_j), V the volume of a particle at rest, W Wendland's C2: 1 inside,
 *  1/2 at a surface, where half the kernel is empty. A wall takes part of the kernel: beside it the surface is where
 *  the liquid and the part of the wall below it fill a half,
 *
 *      sum_j V W(r_j) + sum_b V_b c_b W(r_b) = 1/2,   c_b from 1 below to 0 above, over a spacing,
 *
 *  where "below" is the direction of the body force on liquid at rest on the wall, g - a_b with a_b the wall's
 *  acceleration: a surface of uniform pressure is normal to it, for any slope of the wall, in corners and at edges.
 *  Sides of the domain without layers of boundary particles mirror the liquid instead. A position that a wall separates
 *  from the nearest liquid is outside the liquid. */
#include <math.h>

#include "kernels/kernel.h"
#include "probes/probes.h"

/* Sampled heights per spacing; bisections of the last interval. */
enum { SAMPLES = 4, BISECTIONS = 40 };
/* Below this fill fraction of liquid there is no surface, even if a wall fills all the rest. */
static const double MIN_FILL = 0.02;
/* At this fill fraction of liquid and walls the liquid reaches up to the roof. */
static const double ROOF_FILL = 0.75;
/* Positions within this distance of a wall count as in front of it [spacings]. */
static const double NUDGE = 0.01;

/** The fill fractions at a position. */
typedef struct filling {
    double liquid, below, walls; /**< `below`: the part of the walls below the position */
    sph2d_vec2 nearest;          /**< displacement to the nearest liquid [m] */
    double nearest2;
} filling;

static double weight_at(const sph2d__system *s, double dx, double dy)
{
    double q = sqrt(dx * dx + dy * dy) / s->support;
    return q < 1 ? sph2d__kernel_value_at(SPH2D_KERNEL_WENDLAND_C2, q) : 0;
}

/** The kernel's normalisation, which turns weights times areas into fractions [1/m^2]. */
static double normalisation(const sph2d__system *s)
{
    return sph2d__kernel_constant(SPH2D_KERNEL_WENDLAND_C2) / (s->support * s->support);
}

static void add_liquid(const sph2d_sim *sim, sph2d_vec2 at, filling *sum)
{
    const sph2d__system *s = &sim->system;
    double unit = s->mass / s->rest_density * normalisation(s);
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

/** How far below a position boundary particle b is, at (x, y) from it [m]. */
static double depth_of(const sph2d__system *s, size_t b, double x, double y)
{
    double gx = s->forces.gravity.x, gy = s->forces.gravity.y;
    if (s->forces.frame.moves)
        sph2d__frame_add(&s->forces.frame, (sph2d__place){s->walls.x[b], s->walls.y[b], s->walls.vx[b], s->walls.vy[b]},
                         &gx, &gy);
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
        double part = normalisation(s) * w->mass[b] / s->rest_density * weight_at(s, dx, dy);
        double depth = depth_of(s, b, -dx, -dy) / s->spacing;
        sum->walls += part;
        sum->below += part * fmin(fmax(0.5 + depth, 0), 1);
    }
}

/** A coordinate, and its mirror images in walls within the support radius. Returns their number. */
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

/** Mirrored liquid is as far from a position as liquid is from the mirrored position. */
static filling fill(const sph2d_sim *sim, double x, double y)
{
    sph2d_boundary b = sim->world.scene.boundary;
    sph2d_box d = sim->world.box;
    bool mirrors = sim->world.scene.walls != SPH2D_WALL_GENERALISED;
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

/** Whether no wall is between a position and the nearest liquid. */
static bool sees_liquid(const sph2d_sim *sim, double x, double y, const filling *sum)
{
    double r = sqrt(sum->nearest2), nudge = r > 0 ? NUDGE * sim->world.scene.spacing / r : 0;
    if (!(nudge < 1))
        return true;
    sph2d_vec2 from = {x + nudge * sum->nearest.x, y + nudge * sum->nearest.y};
    sph2d_vec2 to = {x + sum->nearest.x, y + sum->nearest.y};
    return !sph2d__sim_crosses_wall(sim, from, to);
}

/** Whether a position is in liquid, and its fill fractions. */
static bool is_filled(const sph2d_sim *sim, double x, double y, filling *sum)
{
    *sum = fill(sim, x, y);
    return sum->liquid >= MIN_FILL && sum->liquid + sum->below >= 0.5 && sees_liquid(sim, x, y, sum);
}

/** Whether liquid reaches the highest possible position. */
static bool is_full(const sph2d_sim *sim, double x, double y)
{
    filling sum;
    if (sim->world.scene.boundary.top == SPH2D_SIDE_WALL && sim->world.scene.walls == SPH2D_WALL_GENERALISED) {
        sum = fill(sim, x, y);
        return sum.liquid + sum.walls >= ROOF_FILL;
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

/** The height of the surface between `low`, inside the liquid, and `high`, outside. */
static double bisect(const sph2d_sim *sim, double x, double low, double high)
{
    for (int k = 0; k < BISECTIONS; ++k) {
        filling sum;
        double middle = low + (high - low) / 2;
        if (is_filled(sim, x, middle, &sum))
            low = middle;
        else
            high = middle;
    }
    return low + (high - low) / 2;
}

/** Searches the line at x downwards, from the highest possible position of liquid to the lowest. */
static double find_surface(const sph2d_sim *sim, double x)
{
    sph2d_boundary b = sim->world.scene.boundary;
    sph2d_box d = sim->world.box;
    double height = d.max.y - d.min.y, step = sim->system.spacing / SAMPLES;
    double y = b.top == SPH2D_SIDE_OPEN ? d.max.y + height : d.max.y;
    double end = b.bottom == SPH2D_SIDE_OPEN ? d.min.y - height : d.min.y;
    if (is_full(sim, x, y))
        return y;
    while (y > end) {
        double next = fmax(y - step, end);
        filling sum;
        if (is_filled(sim, x, next, &sum))
            return bisect(sim, x, next, y);
        if (!(sum.liquid > 0)) /* skip to the next liquid below */
            next = fmin(next, highest_below(sim, x, next) + sim->system.support);
        y = next;
    }
    return NAN;
}

size_t sph2d__probe_elevation(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    sph2d_vec2 along;
    values[0] = find_surface(sim, sph2d__probe_place(sim, probe, &along).x);
    return 1;
}
