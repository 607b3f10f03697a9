/* SPDX-License-Identifier: MIT */
/** @file degenerate.c A: input at the edge of what makes sense. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "cases.h"

static const char open_sides[] = "boundary: {left: open, right: open, bottom: open, top: open}\n";
static const char periodic_sides[] = "boundary: {left: periodic, right: periodic, bottom: periodic, top: periodic}\n";

// ---- A1 ----------------------------------------------------------------------------------------------------------------

static void nothing(outcome *o)
{
    stage s;
    if (!STAGE_OPEN(&s, o, "sound_speed: 10",
                    "domain: {min: [0, 0], max: [1, 1]}\n%sgravity: [0, -9.81]\nspacing: 0.02\n"
                    "sources: [{at: [0.5, 0.5], speed: 1, start: 1e6}]\n",
                    open_sides))
        return;
    const sph2d_summary before = sph2d_sim_summary(s.sim);
    stage_steps(&s, 100);
    const sph2d_summary after = sph2d_sim_summary(s.sim);
    tell(o, "errors in 100 steps", s.status != SPH2D_OK, 0);
    tell(o, "particles", (double)sph2d_sim_fluid(s.sim).count + (double)sph2d_sim_walls(s.sim).count, 0);
    tell(o, "steps less 100", fabs((double)sph2d_sim_steps(s.sim) - 100), 0);
    tell(o, "energy", fabs(before.kinetic + before.potential + after.kinetic + after.potential), 0);
    stage_close(&s);
    if (stage_read(&s, o, "sound_speed: 10",
                   "domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.02\nblocks:\n"
                   "  - box: {min: [0, 0], max: [1, 1]}\n")) {
        s.scene.block_count = 0;
        tell(o, "a scene of nothing is not refused", stage_try(&s) || !stage_reports(&s, SPH2D_CODE_NO_PARTICLES), 0);
        stage_close(&s);
    }
}

// ---- A2 ----------------------------------------------------------------------------------------------------------------

static void alone(outcome *o)
{
    stage s;
    const double dt = 1e-4, g = 9.81;
    const sph2d_particle one = {.x = 1, .y = 15, .vx = 0.5, .vy = 3, .density = 1000};
    if (!stage_read(&s, o, "sound_speed: 10, time_step: 1e-4",
                    "domain: {min: [0, 0], max: [4, 20]}\n%sgravity: [0, -9.81]\nspacing: 0.02\n"
                    "particles: those.csv\n",
                    open_sides))
        return;
    stage_put(&s, &one, 1);
    if (!stage_start(&s, o))
        return;
    double force = 0;
    for (int k = 0; k < 100 && stage_steps(&s, 100); ++k) {
        const sph2d_view f = sph2d_sim_fluid(s.sim);
        force = fmax(force, hypot(f.ax[0], f.ay[0] + g));
    }
    const sph2d_view f = sph2d_sim_fluid(s.sim);
    const double t = 1e4 * dt;
    tell(o, "stopped", s.status != SPH2D_OK || f.count != 1, 0);
    tell(o, "off its parabola / m", hypot(f.x[0] - one.x - one.vx * t, f.y[0] - one.y - one.vy * t + g * t * t / 2),
         1e-11);
    tell(o, "force / weight", force / g, 1e-12);
    stage_close(&s);
}

// ---- A3 ----------------------------------------------------------------------------------------------------------------

static void bounce(outcome *o, const char *form)
{
    stage s;
    const double height = 0.5, dx = 0.02, speed = sqrt(9.81 * height);
    const sph2d_particle one = {.x = 0.5, .y = height, .density = 1000};
    if (!stage_read(&s, o, "sound_speed: 31",
                    "domain: {min: [0, 0], max: [1, 1]}\nspacing: %g\nwalls: %s\nparticles: those.csv\n", dx, form))
        return;
    stage_put(&s, &one, 1);
    if (!stage_start(&s, o))
        return;
    double lowest = height, highest = 0, low = height, high = 0; // the last two in the last second
    while (sph2d_sim_time(s.sim) < 20 && stage_steps(&s, 1)) {
        const sph2d_view f = sph2d_sim_fluid(s.sim);
        if (f.y[0] < lowest)
            lowest = f.y[0];
        if (lowest < 2 * dx)
            highest = fmax(highest, f.y[0]);
        if (sph2d_sim_time(s.sim) > 19) {
            low = fmin(low, f.y[0]);
            high = fmax(high, f.y[0]);
        }
    }
    tell_of(o, "stopped by a guard", form, s.status != SPH2D_OK, 0);
    tell_of(o, "height of bounce / drop", form, highest / height, 1);
    tell_of(o, "penetration / dx", form, fmax(0, -lowest / dx), 0.5);
    tell_of(o, "way in the last second / U", form, (high - low) / speed, 1e-6);
    stage_close(&s);
}

static void walls(outcome *o)
{
    if (o->method == MULLER)
        bounce(o, "spring");
    if (o->method != WCSPH)
        bounce(o, "heavy");
    bounce(o, "reflect");
    if (o->method != MULLER)
        bounce(o, "generalised");
}

// ---- A4 to A6 ----------------------------------------------------------------------------------------------------------

/** Two particles so far apart: finite, and Newton's third law; refused only where they coincide, with the reason. */
static void pair(outcome *o, const char *which, double apart, double dx, bool may_refuse)
{
    stage s;
    const sph2d_particle two[2] = {{.x = 0, .y = 0, .density = 1000}, {.x = apart, .y = 0, .density = 1000}};
    if (!stage_read(&s, o, "sound_speed: 10",
                    "domain: {min: [-1, -1], max: [1, 1]}\n%sgravity: [0, 0]\nspacing: %g\nparticles: those.csv\n",
                    open_sides, dx))
        return;
    stage_put(&s, two, 2);
    if (!stage_try(&s)) {
        tell_of(o, "refused for another reason than overlap", which,
                !may_refuse || !stage_reports(&s, SPH2D_CODE_OVERLAP), 0);
        stage_close(&s);
        return;
    }
    const sph2d_view f = sph2d_sim_fluid(s.sim);
    const double sum = hypot(f.ax[0] + f.ax[1], f.ay[0] + f.ay[1]), one = hypot(f.ax[0], f.ay[0]);
    stage_steps(&s, 100);
    const sph2d_summary end = sph2d_sim_summary(s.sim);
    tell_of(o, "not finite", which, !all_finite(s.sim), 0);
    tell_of(o, "sum of forces / force", which, one > 0 ? sum / one : sum, 1e-12);
    tell_of(o, "momentum / (m c0)", which,
            hypot(end.momentum[0], end.momentum[1]) / (sph2d_sim_plan(s.sim)->particle_mass * 10), 1e-12);
    stage_close(&s);
}

static void coincident(outcome *o)
{
    pair(o, "r 0", 0, 0.02, true);
    pair(o, "r 1e-300", 1e-300, 0.02, true);
    pair(o, "r 1e-20 H", 1e-22, 0.02, true);
}

static void all_at_one(outcome *o)
{
    enum { COUNT = 1000 };
    static sph2d_particle all[COUNT];
    for (int spread = 0; spread < 2; ++spread) { // at one point, and within a millionth of a spacing
        stage s;
        uint64_t seed = 1;
        for (int i = 0; i < COUNT; ++i)
            all[i] = (sph2d_particle){
                .x = 1e-8 * spread * uniform(&seed), .y = 1e-8 * spread * uniform(&seed), .density = 1000};
        if (!stage_read(
                &s, o, "sound_speed: 10",
                "domain: {min: [-1, -1], max: [1, 1]}\n%sgravity: [0, 0]\nspacing: 0.02\nparticles: those.csv\n",
                open_sides))
            return;
        stage_put(&s, all, COUNT);
        const char *which = spread ? "within 1e-6 dx" : "at a point";
        if (!stage_try(&s))
            tell_of(o, "refused without a reason", which, s.report.errors == 0, 0);
        else {
            stage_steps(&s, 20);
            tell_of(o, "not finite without a guard", which, s.status == SPH2D_OK && !all_finite(s.sim), 0);
            tell_of(o, "memory / MB", which, (double)sph2d_sim_memory(s.sim) / 1e6, 100);
        }
        stage_close(&s);
    }
}

static void at_the_edge(outcome *o)
{
    for (int k = -1; k <= 1; ++k) {
        // With dx = 1/32 and H/dx = 2.5 or so, H is a sum of a few powers of 2, and the distance is exact.
        const double ratio = o->method == MULLER ? 2 : o->method == WCSPH ? 3 : 2.4, dx = 0.03125;
        pair(o, k < 0 ? "H(1 - 1e-15)" : k > 0 ? "H(1 + 1e-15)" : "H", ratio * dx * (1 + k * 1e-15), dx, false);
    }
}

// ---- A7, A8 ------------------------------------------------------------------------------------------------------------

static const struct bad_number {
    const char *key;
    double value;
} bad_ones[] = {
    {"particles", NAN},
    {"particles", -INFINITY},
    {"particles", NAN},
    {"particles", -1},
    {"fluid.density", 0},
    {"fluid.density", -1},
    {"fluid.density", NAN},
    {"method.time_step", -1},
    {"method.time_step", INFINITY},
    {"method.support_ratio", -1},
    {"spacing", 0},
    {"spacing", NAN},
    {"gravity", NAN},
    {"blocks[0].velocity", INFINITY},
    {"run.until", NAN},
    {"fluid.dynamic_viscosity", -1},
};
enum { BAD_ONES = sizeof bad_ones / sizeof *bad_ones, BAD_PARTICLES = 4 };

/** Whether a scene with this value is refused, by an error that names the key. */
static bool is_refused(outcome *o, size_t which)
{
    stage s;
    sph2d_particle one = {.x = 0.5, .y = 0.9, .density = 1000};
    if (!stage_read(&s, o, "sound_speed: 10",
                    "domain: {min: [0, 0], max: [1, 1]}\n%sspacing: 0.05\n"
                    "blocks:\n  - box: {min: [0, 0], max: [1, 0.8]}\n",
                    o->method == FITTED ? periodic_sides : ""))
        return false;
    sph2d_block block = s.scene.blocks[0];
    s.scene.blocks = &block;
    if (which < BAD_PARTICLES)
        stage_put(&s, &one, 1);
    double *const values[BAD_ONES] = {&one.x,
                                      &one.y,
                                      &one.vx,
                                      &one.density,
                                      &s.scene.fluid.density,
                                      &s.scene.fluid.density,
                                      &s.scene.fluid.density,
                                      &s.scene.method.time_step,
                                      &s.scene.method.time_step,
                                      &s.scene.method.support_ratio,
                                      &s.scene.spacing,
                                      &s.scene.spacing,
                                      &s.scene.gravity.y,
                                      &block.velocity.x,
                                      &s.scene.run.until,
                                      &s.scene.fluid.dynamic_viscosity};
    *values[which] = bad_ones[which].value;
    bool named = false;
    const bool refused = !stage_try(&s) && s.sim == NULL;
    for (size_t i = 0; i < s.report.count; ++i)
        named = named || strncmp(s.report.items[i].path, bad_ones[which].key, strlen(bad_ones[which].key)) == 0;
    stage_close(&s);
    return refused && named;
}

static void bad_numbers(outcome *o)
{
    size_t taken = 0;
    for (size_t which = 0; which < BAD_ONES; ++which)
        if (!is_refused(o, which)) {
            ++taken;
            tell_of(o, "taken", bad_ones[which].key, bad_ones[which].value, -INFINITY);
        }
    tell(o, "taken, of 16 that are no numbers for this", (double)taken, 0);
}

/** What a fault in memory would do: a value of a particle is not a number from one step to the next. */
static void poison(outcome *o, const char *what, bool position)
{
    stage s;
    if (!STAGE_OPEN(&s, o, "sound_speed: 20",
                    "domain: {min: [0, 0], max: [1, 1]}\n%sgravity: [0, 0]\nspacing: 0.05\n"
                    "blocks:\n  - box: {min: [0, 0], max: [1, 1]}\n    perturb: {amplitude: 0.02}\n",
                    periodic_sides))
        return;
    stage_steps(&s, 100);
    const sph2d_view f = sph2d_sim_fluid(s.sim);
    double *const value = (double *)(uintptr_t)(position ? f.x : f.vx);
    value[f.count / 2] = (double)NAN;
    const bool before = s.status == SPH2D_OK;
    const sph2d_status status = sph2d_sim_step(s.sim, &s.report);
    tell_of(o, "not noticed in a step", what, !before || status != SPH2D_GUARD, 0);
    tell_of(o, "not called by its name", what, !stage_reports(&s, SPH2D_CODE_NOT_FINITE), 0);
    stage_close(&s);
}

static void poisoned(outcome *o)
{
    poison(o, "velocity", false);
    poison(o, "position", true);
}

// ---- A9 to A12 ---------------------------------------------------------------------------------------------------------

static void wide(outcome *o)
{
    stage s;
    if (STAGE_OPEN(
            &s, o, "sound_speed: 10",
            "domain: {min: [0, 0], max: [1e6, 1]}\n%sgravity: [0, 0]\nspacing: 0.01\n"
            "blocks:\n  - box: {min: [0, 0], max: [0.1, 0.1]}\n  - box: {min: [999999, 0], max: [999999.1, 0.1]}\n",
            open_sides)) {
        stage_steps(&s, 100);
        tell_of(o, "stopped", "a domain of 1e6:1", s.status != SPH2D_OK || !all_finite(s.sim), 0);
        tell_of(o, "memory / MB", "a domain of 1e6:1", (double)sph2d_sim_memory(s.sim) / 1e6, 10);
        stage_close(&s);
    }
    const sph2d_particle two[2] = {{.x = 0, .density = 1000}, {.x = 1e12, .y = 1e12, .density = 1000}};
    if (!stage_read(&s, o, "sound_speed: 10",
                    "domain: {min: [0, 0], max: [1e12, 1e12]}\n%sgravity: [0, 0]\nspacing: 1\nparticles: those.csv\n",
                    open_sides))
        return;
    stage_put(&s, two, 2);
    if (!stage_try(&s))
        tell_of(o, "refused without a reason", "at 1e12 m", s.report.errors == 0, 0);
    else {
        stage_steps(&s, 100);
        tell_of(o, "stopped", "at 1e12 m", s.status != SPH2D_OK || !all_finite(s.sim), 0);
        tell_of(o, "memory / MB", "at 1e12 m", (double)sph2d_sim_memory(s.sim) / 1e6, 10);
    }
    stage_close(&s);
}

static void leaving(outcome *o)
{
    stage s;
    if (!STAGE_OPEN(&s, o, "",
                    "domain: {min: [0, 0], max: [1, 1]}\n%sspacing: 0.02\nblocks:\n"
                    "  - box: {min: [0.1, 0.4], max: [0.3, 0.6]}\n    velocity: [-3, 2]\n"
                    "  - box: {min: [0.7, 0.4], max: [0.9, 0.6]}\n    velocity: [3, 2]\n"
                    "  - box: {min: [0.4, 0.7], max: [0.6, 0.9]}\n    velocity: [0, 9]\n"
                    "  - box: {min: [0.4, 0.1], max: [0.6, 0.3]}\n",
                    open_sides))
        return;
    const size_t start = sph2d_sim_fluid(s.sim).count;
    double worst = 0;
    while (sph2d_sim_time(s.sim) < 3 && stage_steps(&s, 1)) {
        worst = fmax(worst, ledger(s.sim, start));
        if (sph2d_sim_fluid(s.sim).count == 0)
            break;
    }
    const sph2d_summary end = sph2d_sim_summary(s.sim);
    tell(o, "stopped by a guard", s.status != SPH2D_OK, 0);
    tell(o, "particles that nobody counted", worst, 0);
    tell(o, "sides that none left by", (end.left_open[0] == 0) + (end.left_open[1] == 0) + (end.left_open[2] == 0), 0);
    stage_close(&s);
}

/** Where a column of 0.5 m by 1 m is 0.1 s after its dam broke, seen from the corner of its tank at (d, d). */
static cloud broken_dam(outcome *o, double d, double disturbed)
{
    stage s;
    cloud c = {.count = 0};
    const bool fitted = o->method == FITTED; // a shear flow without a free surface
    if (!STAGE_OPEN(&s, o, fitted ? "sound_speed: 20, time_step: 2e-4" : "time_step: 2e-4",
                    "domain: {min: [%.17g, %.17g], max: [%.17g, %.17g]}\nspacing: 0.03125\n%s"
                    "blocks:\n  - box: {min: [%.17g, %.17g], max: [%.17g, %.17g]}\n    perturb: {amplitude: %g}\n",
                    d, d, d + 2, d + 1,
                    fitted ? "boundary: {left: periodic, right: periodic, top: wall}\nwall_slip: none\n"
                             "gravity: [1, 0]\n"
                           : "",
                    d, d, d + (fitted ? 2 : 0.5), d + 1, disturbed))
        return c;
    stage_finish(&s, o, 0.1);
    c = cloud_of(s.sim);
    for (size_t i = 0; i < c.count; ++i) {
        c.x[i] -= d;
        c.y[i] -= d;
    }
    stage_close(&s);
    return c;
}

static void offset(outcome *o)
{
    // At 1e6 H coordinates are known to 1.5e-11 m, 5e-10 spacings: what that does by itself is no fault.
    cloud near = broken_dam(o, 0, 0), disturbed = broken_dam(o, 0, 5e-10), far = broken_dam(o, 1e6 * 3 * 0.03125, 0);
    const double apart = cloud_apart(&near, &far), alone = cloud_apart(&near, &disturbed);
    tell(o, "apart / m", apart, fmax(1e-6, 10 * alone));
    tell_only(o, "by a disturbance of 1 ulp", alone);
    cloud_free(&near);
    cloud_free(&disturbed);
    cloud_free(&far);
}

/** Neighbours around each particle as sampled, against all pairs; those at H to round-off may count or not. */
static size_t mismatches(const sph2d_sim *sim, double period)
{
    const sph2d_view f = sph2d_sim_fluid(sim);
    const double h = sph2d_sim_plan(sim)->support_radius;
    size_t wrong = 0;
    for (size_t i = 0; i < f.count; ++i) {
        double least = 0, most = 0;
        for (size_t j = 0; j < f.count; ++j) {
            double dx = f.x[j] - f.x[i], dy = f.y[j] - f.y[i];
            dx -= period * round(dx / period);
            dy -= period * round(dy / period);
            least += hypot(dx, dy) < h * (1 - 1e-9);
            most += hypot(dx, dy) < h * (1 + 1e-9);
        }
        sph2d_sample sample = {{0}, 0, 0, -1};
        sph2d_sim_sample(sim, (sph2d_vec2){f.x[i], f.y[i]}, &sample);
        wrong += sample.neighbours < least || sample.neighbours > most;
    }
    return wrong;
}

static void aligned(outcome *o)
{
    stage s;
    const char *options = o->method == FITTED ? "sound_speed: 10" : "sound_speed: 10, support_ratio: 3";
    if (!stage_read(
            &s, o, options,
            "domain: {min: [0, 0], max: [1.5, 1.5]}\n%sgravity: [0, 0]\nspacing: 0.0625\nparticles: those.csv\n",
            periodic_sides))
        return;
    // On the edges of the cells, if they are as wide as the support; uneven in x and y afterwards.
    sph2d_particle *p = lattice(24, 24, 0.0625, (sph2d_vec2){-0.03125, -0.03125});
    for (int i = 0; i < 24 * 24; ++i)
        p[i].vx = 0.1 * sin(4 * CASE_PI * p[i].y / 1.5);
    stage_put(&s, p, (size_t)24 * 24);
    if (stage_start(&s, o)) {
        tell(o, "particles with other neighbours at the start", (double)mismatches(s.sim, 1.5), 0);
        stage_steps(&s, 50);
        tell(o, "particles with other neighbours after 50 steps", (double)mismatches(s.sim, 1.5), 0);
    }
    stage_close(&s);
    free(p);
}

static const hard_case items[] = {
    {"A1", "no particles, no boundary, no steps", "no error, nothing there; a scene of nothing is refused", BY_FREE,
     0.1, nothing},
    {"A2", "one particle in gravity, 1e4 steps", "on its parabola to 1e-12 of the way, no force", BY_FREE, 0.1, alone},
    {"A3", "one particle dropped on each form of wall",
     "bounces no higher than it fell, still at last to 1e-6 U, < 0.5 dx deep", BY_FREE, 0.5, walls},
    {"A4", "two particles at one place, or 1e-300 m, 1e-20 H apart",
     "finite, momentum to 1e-12; or refused with the reason", BY_FREE, 0.1, coincident},
    {"A5", "1000 particles at one place", "finite, or an error; no hang", BY_FREE, 0.5, all_at_one},
    {"A6", "two particles H apart, and H(1 +- 1e-15)", "no force from nothing, third law to 1e-12", BY_FREE, 0.1,
     at_the_edge},
    {"A7", "NaN, Inf, 0 or below 0 where none may be", "refused by an error that names the key", BY_ALL, 0.1,
     bad_numbers},
    {"A8", "NaN in a particle after 100 steps", "found within a step", BY_ALL, 0.2, poisoned},
    {"A9", "a domain of 1e6:1; a particle at 1e12 m", "memory by particles, no hang", BY_FREE, 0.3, wide},
    {"A10", "particles that leave by every side", "count exact in every step", BY_FREE, 0.5, leaving},
    {"A11", "coordinates 1e6 H from the origin",
     "as at the origin after 500 steps, to 1e-6 m or as a disturbance of 1 ulp has it", BY_ALL, 0.9, offset},
    {"A12", "rows and columns on the edges of cells", "neighbours as by all pairs", BY_ALL, 0.5, aligned},
};
const case_list degenerate_cases = {items, sizeof items / sizeof *items};
