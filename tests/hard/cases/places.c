/* SPDX-License-Identifier: MIT */
/** @file places.c A, continued: domains and coordinates at the edge of what makes sense. */
#include <math.h>
#include <stdlib.h>

#include "cases.h"

static const char open_sides[] = "boundary: {left: open, right: open, bottom: open, top: open}\n";
static const char periodic_sides[] = "boundary: {left: periodic, right: periodic, bottom: periodic, top: periodic}\n";

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
    {"A9", "a domain of 1e6:1; a particle at 1e12 m", "memory by particles, no hang", BY_FREE, 0.3, wide},
    {"A10", "particles that leave by every side", "count exact in every step", BY_FREE, 0.5, leaving},
    {"A11", "coordinates 1e6 H from the origin",
     "as at the origin after 500 steps, to 1e-6 m or as a disturbance of 1 ulp has it", BY_ALL, 0.9, offset},
    {"A12", "rows and columns on the edges of cells", "neighbours as by all pairs", BY_ALL, 0.5, aligned},
};
const case_list place_cases = {items, sizeof items / sizeof *items};
