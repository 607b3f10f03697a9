/* SPDX-License-Identifier: MIT */
/** @file invariances.c B: what must not change, by conservation or by symmetry. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cases.h"

enum { SIDE = 20, COUNT = SIDE * SIDE };

static const double dx = 0.05;

// ---- B1 -------------------------------------------------------------------------------------------------------------

typedef struct momenta {
    double x, y, angular, size, angular_size;
} momenta;

static momenta momenta_of(const sph2d_sim *sim)
{
    const sph2d_view f = sph2d_sim_fluid(sim);
    momenta sum = {0};
    for (size_t i = 0; i < f.count; ++i) {
        sum.x += f.vx[i];
        sum.y += f.vy[i];
        sum.angular += f.x[i] * f.vy[i] - f.y[i] * f.vx[i];
        sum.size += hypot(f.vx[i], f.vy[i]);
        sum.angular_size += hypot(f.x[i], f.y[i]) * hypot(f.vx[i], f.vy[i]);
    }
    return sum;
}

/** A square of liquid with random velocities, alone in the world. */
static void random_cloud(outcome *o, const char *options, const char *which)
{
    stage s;
    uint64_t seed = 7;
    if (!stage_read(&s, o, options,
                    "domain: {min: [-5, -5], max: [5, 5]}\n"
                    "boundary: {left: open, right: open, bottom: open, top: open}\n"
                    "gravity: [0, 0]\nspacing: %g\nparticles: those.csv\n",
                    dx))
        return;
    sph2d_particle *p = lattice(SIDE, SIDE, dx, (sph2d_vec2){-0.5, -0.5});
    for (int i = 0; i < COUNT; ++i) {
        p[i].vx = uniform(&seed) - 0.5;
        p[i].vy = uniform(&seed) - 0.5;
    }
    stage_put(&s, p, COUNT);
    if (stage_start(&s, o)) {
        const momenta start = momenta_of(s.sim);
        if (!stage_steps(&s, 300))
            tell_of(o, "stopped by a guard", which, 1, 0);
        const momenta end = momenta_of(s.sim);
        // Viscous forces of muller are not along the line between two particles.
        const double turn = o->method == MULLER ? (double)NAN : 1;
        tell_of(o, "momentum", which, hypot(end.x - start.x, end.y - start.y) / start.size, 1e-12);
        tell_of(o, "angular momentum", which, fabs(end.angular - start.angular) / start.angular_size, 1e-10 * turn);
        stage_close(&s);
    }
    free(p);
}

static void momentum(outcome *o)
{
    random_cloud(o, "sound_speed: 10", "defaults");
}

// ---- the flow of B2 to B4, B7 ---------------------------------------------------------------------------------------

/** A turn by `angle`, or a mirror image, and a boost along x. */
typedef struct frame {
    double angle, boost;
    bool mirrored, shuffled;
    double disturbed; /**< all particles, at random by so much at most [m] */
} frame;

static sph2d_vec2 seen(frame f, sph2d_vec2 p)
{
    const double x = f.mirrored ? -p.x : p.x, c = cos(f.angle), s = sin(f.angle);
    return (sph2d_vec2){c * x - s * p.y, s * x + c * p.y};
}

static sph2d_vec2 unseen(frame f, sph2d_vec2 p)
{
    const double c = cos(f.angle), s = sin(f.angle), x = c * p.x + s * p.y;
    return (sph2d_vec2){f.mirrored ? -x : x, -s * p.x + c * p.y};
}

/** Numbers 0 to COUNT - 1 in a random order. */
static void shuffle(int order[COUNT], bool shuffled)
{
    uint64_t seed = 3;
    for (int i = 0; i < COUNT; ++i)
        order[i] = i;
    for (int i = COUNT - 1; i > 0 && shuffled; --i) {
        const int k = (int)(uniform(&seed) * (i + 1)), other = order[k];
        order[k] = order[i];
        order[i] = other;
    }
}

/** A square that swirls and stretches at 1 m/s, or vortices in a periodic box by fitted operators, after some steps;
 *  as it would be in the frame without turn and boost. */
static cloud swirl(outcome *o, frame f, const char *options, double dt, unsigned long steps)
{
    stage s;
    char all[200];
    int order[COUNT];
    const bool periodic = o->method == FITTED;
    static const char *const sides[] = {"open", "periodic"};
    const char *side = sides[periodic];
    cloud c = {.count = 0}, sorted = {.count = 0};
    snprintf(all, sizeof all, "%s, time_step: %.17g", options, dt);
    if (!stage_read(&s, o, all,
                    "domain: {min: [%g, %g], max: [%g, %g]}\nboundary: {left: %s, right: %s, bottom: %s, top: %s}\n"
                    "gravity: [0, 0]\nspacing: %g\nparticles: those.csv\n",
                    periodic ? -0.5 : -4.0, periodic ? -0.5 : -4.0, periodic ? 0.5 : 4.0, periodic ? 0.5 : 4.0, side,
                    side, side, side, dx))
        return c;
    shuffle(order, f.shuffled);
    sph2d_particle *p = lattice(SIDE, SIDE, dx, (sph2d_vec2){-0.5, -0.5}),
                   *put = lattice(SIDE, SIDE, dx, (sph2d_vec2){0, 0});
    for (int i = 0; i < COUNT; ++i) {
        const double k = 2 * CASE_PI, x = p[i].x, y = p[i].y;
        const sph2d_vec2 at = seen(f, (sph2d_vec2){x, y});
        const sph2d_vec2 v =
            seen(f, periodic ? (sph2d_vec2){sin(k * y) * cos(k * x) + 0.3 * sin(2 * k * y), -sin(k * x) * cos(k * y)}
                             : (sph2d_vec2){x - y + 0.3 * sin(k * y), x - y + 0.2 * sin(k * x)});
        put[order[i]] = (sph2d_particle){.x = at.x, .y = at.y, .vx = v.x + f.boost, .vy = v.y, .density = 1000};
    }
    uint64_t seed = 5;
    for (int i = 0; i < COUNT && f.disturbed > 0; ++i) {
        put[i].x += f.disturbed * (2 * uniform(&seed) - 1);
        put[i].y += f.disturbed * (2 * uniform(&seed) - 1);
    }
    stage_put(&s, put, COUNT);
    if (stage_start(&s, o)) {
        if (!stage_steps(&s, steps))
            tell(o, "stopped by a guard", 1, 0);
        c = cloud_of(s.sim);
        sorted = cloud_of(s.sim);
        for (size_t i = 0; i < c.count; ++i) {
            const size_t k = (size_t)order[i];
            double x = c.x[k] - f.boost * c.time;
            if (periodic)
                x -= round(x);
            const sph2d_vec2 at = unseen(f, (sph2d_vec2){x, c.y[k]});
            sorted.x[i] = at.x;
            sorted.y[i] = at.y;
        }
        cloud_free(&c);
        stage_close(&s);
    }
    free(p);
    free(put);
    return sorted;
}

/** Largest distance between two such runs, where a side of a periodic box is the other one. */
static double between(const outcome *o, const cloud *a, const cloud *b)
{
    double most = a->count == COUNT && b->count == COUNT ? 0 : NAN;
    for (size_t i = 0; i < a->count && i < b->count; ++i) {
        double x = a->x[i] - b->x[i], y = a->y[i] - b->y[i];
        if (o->method == FITTED) {
            x -= round(x);
            y -= round(y);
        }
        most = hypot(x, y) > most || isnan(x + y) ? hypot(x, y) : most;
    }
    return most;
}

/** The same flow in another frame. Round-off may be multiplied, by switches and iterations, as it is in one frame: the
 *  bound is not below ten times what a disturbance of all places by 1e-15 m does. */
static void compare(outcome *o, const char *measure, frame f, const char *options, unsigned long steps, double bound)
{
    cloud here = swirl(o, (frame){0}, options, 2e-4, steps), there = swirl(o, f, options, 2e-4, steps);
    cloud near = swirl(o, (frame){.disturbed = 1e-15}, options, 2e-4, steps);
    const double alone = between(o, &here, &near);
    tell(o, measure, between(o, &here, &there), fmax(bound, 10 * alone));
    if (10 * alone > bound)
        tell_of(o, measure, "a disturbance of 1e-15 m", alone, NAN);
    cloud_free(&here);
    cloud_free(&there);
    cloud_free(&near);
}

static void boosted(outcome *o)
{
    const bool solves = o->method == PCISPH || o->method == CONSTRAINT;
    if (o->method == FITTED)
        compare(o, "apart / m, shifting 0", (frame){.boost = 10}, "sound_speed: 20, shifting: 0", 500, 1e-9);
    compare(o, "apart / m", (frame){.boost = 10}, "sound_speed: 20", 500, solves ? 1e-3 : 1e-9);
}

static void turned(outcome *o)
{
    compare(o, "mirrored, apart / m", (frame){.mirrored = true}, "sound_speed: 20", 20, 1e-12);
    // A box that is periodic can be turned by right angles.
    compare(o, "turned, apart / m", (frame){.angle = o->method == FITTED ? CASE_PI / 2 : CASE_PI / 6},
            "sound_speed: 20", 20, 1e-12);
}

static void shuffled(outcome *o)
{
    compare(o, "apart / m", (frame){.shuffled = true}, "sound_speed: 20", 100, 1e-12);
}

// ---- B7 -------------------------------------------------------------------------------------------------------------

static double order_of(outcome *o, const char *options)
{
    cloud c[3];
    for (int k = 0; k < 3; ++k)
        c[k] = swirl(o, (frame){0}, options, 2e-4 / (1 << k), 250ul << k);
    const double order = log2(between(o, &c[0], &c[1]) / between(o, &c[1], &c[2]));
    for (int k = 0; k < 3; ++k)
        cloud_free(&c[k]);
    return order;
}

/** The order of the time scheme; what is done once per step, as shifting, or by a time of some steps is of the first. */
static void halved(outcome *o)
{
    if (o->method == FITTED)
        tell(o, "1.8 less order of the scheme", 1.8 - order_of(o, "sound_speed: 20, shifting: 0"), 0);
    if (o->method == MULLER)
        tell(o, "1.8 less order of the scheme", 1.8 - order_of(o, "sound_speed: 20"), 0);
    if (o->method == CONSTRAINT)
        tell(o, "0.9 less order of the scheme", 0.9 - order_of(o, "sound_speed: 20, tolerance: 1e-12"), 0);
    if (o->method == PCISPH)
        tell(o, "0.9 less order of the scheme", 0.9 - order_of(o, "sound_speed: 20, max_compression: 1e-5"), 0);
    const double order = order_of(o, "sound_speed: 20");
    tell_only(o, "order by defaults", order);
    if (o->method == WCSPH) // what it dissipates, and pairs that stand still, are of the first
        tell(o, "0.9 less order by defaults", 0.9 - order, 0);
}

static const hard_case items[] = {
    {"B1", "a cloud alone with random velocities", "momentum to 1e-12, angular to 1e-10 of its sum of magnitudes",
     BY_FREE, 0.4, momentum},
    {"B2", "a boost by 10 U", "the same to 1e-9 m after 500 steps, by solvers to 1e-3, or as a disturbance of 1e-15 m",
     BY_ALL, 2, boosted},
    {"B3", "mirrored; turned by 30 degrees", "the same to 1e-12 m after 20 steps, or as a disturbance of 1e-15 m",
     BY_ALL, 0.2, turned},
    {"B4", "the particles in another order", "the same to 1e-12 m after 100 steps, or as a disturbance of 1e-15 m",
     BY_ALL, 0.5, shuffled},
    {"B7", "the step halved twice", "order 1.8; by wcsph, and by solvers, whose damping takes steps, 0.9", BY_ALL, 4,
     halved},
};
const case_list invariance_cases = {items, sizeof items / sizeof *items};
