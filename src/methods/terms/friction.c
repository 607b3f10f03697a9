/* SPDX-License-Identifier: MIT */
/** @file friction.c
 *  Friction of smooth walls: a pass over the first layer of boundary particles, then one over the liquid near them. */
#include "methods/terms/friction.h"

#include <math.h>

#include "kernels/kernel.h"
#include "methods/common/slabs.h"
#include "methods/common/traverse.h"

/* The law of the wall: f(s) = ln(E s)/KARMAN, equal to s at LAMINAR_LIMIT. */
static const double KARMAN = 0.41, E = 9, LAMINAR_LIMIT = 11.2659;
/* Newton's method ends with a relative step below this: the remaining error is about its square. */
static const double TOLERANCE = 1e-5;
/* Least distance from the surface [dx]: a particle's centre may reach it, but it represents liquid a spacing thick. */
static const double MIN_DISTANCE = 0.25;
/* Particles of a row on either side of one within the widest support. */
enum { REACH = 8 };

bool sph2d__has_friction(const sph2d__system *s)
{
    return s->walls_smooth && s->viscosity > 0 && s->walls_press;
}

/** The wall coordinate s = c y/nu (y+) for Re = u y/nu: s^2 L/y + s f(s) = Re. With the logarithm this is convex, so
 *  that Newton's method converges from above after its first step. */
static double wall_coordinate(double reynolds, double slip)
{
    double s = sqrt(reynolds / (1 + slip));
    if (s <= LAMINAR_LIMIT)
        return s;
    for (int k = 0; k < 20; ++k) {
        double f = log(E * s), excess = reynolds - s * (slip * s + f / KARMAN);
        double step = excess / (2 * slip * s + (f + 1) / KARMAN);
        s += step;
        if (fabs(step) < TOLERANCE * s)
            break;
    }
    return s;
}

double sph2d__friction_stress(double speed, double distance, double slip_length, double density, double viscosity)
{
    double nu = viscosity / density, s = wall_coordinate(speed * distance / nu, slip_length / distance);
    return density * (s * nu / distance) * (s * nu / distance);
}

/** Sum of W_ib over a full row of particles next to a surface. */
static double row_weight(const sph2d__system *s)
{
    double sum = 0;
    for (int i = -REACH; i <= REACH; ++i)
        sum += sph2d__kernel_value_at(s->method.kernel, hypot(i, 1) * s->spacing / s->support);
    return sum;
}

/** W_ib of a particle at (dx, dy) from b; 0 behind the row of b. */
static inline double weight_of(const sph2d__system *s, size_t b, double dx, double dy)
{
    double r2 = dx * dx + dy * dy;
    if (!(r2 < s->support * s->support) || !(s->walls.normal_x[b] * dx + s->walls.normal_y[b] * dy > 0))
        return 0;
    return sph2d__kernel_value_at(s->method.kernel, sqrt(r2) / s->support);
}

/** The friction of b over the sum of weights, along (-normal_y, normal_x) [N/m]. */
static double drag_of(const sph2d__system *s, size_t b, const sph2d__ranges *ranges, double full)
{
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    double weights = 0, slip = 0, distance = 0;
    sph2d_vec2 wall = sph2d__surface_velocity(s, b);
    SPH2D__FOR_NEIGHBOURS (ranges, r, i) {
        double dx = f->x[i] - (w->x[b] + ranges->x[r]), dy = f->y[i] - (w->y[b] + ranges->y[r]);
        double weight = weight_of(s, b, dx, dy);
        if (weight == 0)
            continue;
        weights += weight;
        slip += weight * (w->normal_x[b] * (f->vy[i] - wall.y) - w->normal_y[b] * (f->vx[i] - wall.x));
        distance += weight * (w->normal_x[b] * dx + w->normal_y[b] * dy - w->depth[b]);
    }
    if (!(weights > 1e-9 * full))
        return 0;
    double speed = fabs(slip / weights), y = fmax(distance / weights, MIN_DISTANCE * s->spacing);
    double stress = sph2d__friction_stress(speed, y, s->slip_length, s->rest_density, s->viscosity);
    if (s->step > 0) /* never reverses the slip: this force acts for half a step, the next one for the other half */
        stress = fmin(stress, s->rest_density * s->spacing * speed / (2 * s->step));
    return -copysign(w->skin[b] * stress / fmax(weights, full), slip);
}

static void set_drags(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *w = &s->walls;
    double full = row_weight(s);
    sph2d__cursor near = SPH2D__CURSOR_START;
    for (size_t b = first; b < last; ++b) {
        bool faces = w->skin[b] > 0 && sph2d__cursor_move(&near, &s->fluid_cells, w->x[b], w->y[b]);
        w->drag[b] = faces ? drag_of(s, b, &near.ranges, full) : 0;
    }
}

void sph2d__friction_set(sph2d__system *s)
{
    if (sph2d__has_friction(s))
        sph2d__over_particles(s, s->walls.count, set_drags, NULL);
}

static inline sph2d_vec2 force_of(const sph2d__system *s, size_t b, double dx, double dy)
{
    double along = s->walls.drag[b] * weight_of(s, b, dx, dy);
    return (sph2d_vec2){-along * s->walls.normal_y[b], along * s->walls.normal_x[b]};
}

sph2d_vec2 sph2d__friction_of(const sph2d__system *s, size_t b, double dx, double dy)
{
    return sph2d__has_friction(s) ? force_of(s, b, dx, dy) : (sph2d_vec2){0, 0};
}

static void add_accelerations(sph2d__system *s, size_t first, size_t last)
{
    sph2d__store *f = &s->fluid, *w = &s->walls;
    sph2d__cursor near = SPH2D__CURSOR_START;
    for (size_t i = first; i < last; ++i) {
        if (!sph2d__cursor_move(&near, &s->wall_cells, f->x[i], f->y[i]))
            continue;
        double x = 0, y = 0;
        SPH2D__FOR_NEIGHBOURS (&near.ranges, r, b) {
            if (w->drag[b] == 0)
                continue;
            sph2d_vec2 force =
                force_of(s, b, f->x[i] + near.ranges.x[r] - w->x[b], f->y[i] + near.ranges.y[r] - w->y[b]);
            x += force.x;
            y += force.y;
        }
        f->ax[i] += x / s->mass;
        f->ay[i] += y / s->mass;
    }
}

void sph2d__friction_add(sph2d__system *s)
{
    if (sph2d__has_friction(s))
        sph2d__over_particles(s, s->fluid.count, add_accelerations, NULL);
}
