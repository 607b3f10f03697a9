/* SPDX-License-Identifier: MIT */
/** @file degenerate.c A: input at the edge of what makes sense. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "cases.h"

static const char open_sides[] = "boundary: {left: open, right: open, bottom: open, top: open}\n";
static const char periodic_sides[] = "boundary: {left: periodic, right: periodic, bottom: periodic, top: periodic}\n";

// ---- A1 -------------------------------------------------------------------------------------------------------------

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

// ---- A2 -------------------------------------------------------------------------------------------------------------

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

// ---- A3 -------------------------------------------------------------------------------------------------------------

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
    static const char *const forms[] = {"spring", "heavy", "reflect"};
    for (int k = 0; k < 3 && o->method == MULLER; ++k)
        bounce(o, forms[k]);
    if (o->method != MULLER)
        bounce(o, "generalised");
}

// ---- A4 to A6 -------------------------------------------------------------------------------------------------------

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

// ---- A7, A8 ---------------------------------------------------------------------------------------------------------

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
                    "blocks:\n  - box: {min: [0, 0], max: [1, %g]}\n",
                    o->method == FITTED ? periodic_sides : "", o->method == FITTED ? 1 : 0.8))
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
};
const case_list degenerate_cases = {items, sizeof items / sizeof *items};
