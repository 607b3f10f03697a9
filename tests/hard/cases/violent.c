/* SPDX-License-Identifier: MIT */
/** @file violent.c F: impacts and long runs. */
#include <math.h>

#include "cases.h"

/** What is asked of a collision at `speed` each: density is low at surfaces where it is a sum over particles. */
static void collide(outcome *o, stage *s, const char *which, double speed, double until)
{
    double fastest = 0, densest = 0, thinnest = 0;
    while (sph2d_sim_time(s->sim) < until && stage_steps(s, 1)) {
        const sph2d_view f = sph2d_sim_fluid(s->sim);
        fastest = fmax(fastest, speed_of(s->sim));
        for (size_t i = 0; i < f.count; ++i) {
            densest = fmax(densest, f.density[i] / 1000 - 1);
            thinnest = fmax(thinnest, 1 - f.density[i] / 1000);
        }
    }
    tell_of(o, "stopped by a guard", which, s->status != SPH2D_OK, 0);
    tell_of(o, "speed at most / U", which, fastest / speed, 2);
    tell_of(o, "rho/rho0 - 1 at most", which, densest, 0.1);
    if (o->method == WCSPH)
        tell_of(o, "1 - rho/rho0 at most", which, thinnest, 0.1);
    stage_close(s);
}

static void collisions(outcome *o)
{
    stage s;
    const double speed = 3;
    const char *options = o->method == MULLER || o->method == WCSPH ? "sound_speed: 10" : "";
    if (STAGE_OPEN(&s, o, options,
                   "domain: {min: [-0.5, -0.5], max: [0.5, 0.5]}\nspacing: 0.01\ngravity: [0, 0]\n"
                   "boundary: {left: open, right: open, bottom: open, top: open}\nblocks:\n"
                   "  - disc: {center: [-0.12, 0], radius: 0.1}\n    velocity: [%g, 0]\n"
                   "  - disc: {center: [0.12, 0], radius: 0.1}\n    velocity: [-%g, 0]\n",
                   speed, speed))
        collide(o, &s, "drops", speed, 0.1);
    if (STAGE_OPEN(&s, o, options,
                   "domain: {min: [-0.5, -0.5], max: [0.5, 0.5]}\nspacing: 0.01\ngravity: [0, 0]\n"
                   "boundary: {left: open, right: open, bottom: open, top: open}\nsources:\n"
                   "  - {at: [-0.3, 0], direction: [1, 0], width: 0.1, speed: %g}\n"
                   "  - {at: [0.3, 0], direction: [-1, 0], width: 0.1, speed: %g}\n",
                   speed, speed))
        collide(o, &s, "jets", speed, 0.3);
}

/** A stream between two walls, from a nozzle as wide as the channel to a drain, for 100 times the channel's length. */
static void through(outcome *o)
{
    stage s;
    if (!STAGE_OPEN(&s, o, o->method == MULLER || o->method == WCSPH ? "sound_speed: 10" : "",
                    "domain: {min: [0, 0], max: [1.2, 0.25]}\nspacing: 0.025\ngravity: [0, 0]\n"
                    "boundary: {left: open, right: open, top: wall}\n"
                    "sources: [{at: [0.1, 0.125], direction: [1, 0], width: 0.25, speed: 1}]\n"
                    "drains: [{box: {min: [1.1, 0], max: [1.2, 0.25]}}]\n"))
        return;
    double early = 0, late = 0, early_time = 0, late_time = 0; // means over time, as rows come and go
    while (sph2d_sim_time(s.sim) < 100) {
        const double before = sph2d_sim_time(s.sim), count = (double)sph2d_sim_fluid(s.sim).count;
        if (!stage_steps(&s, 1))
            break;
        const double dt = sph2d_sim_time(s.sim) - before;
        if (before >= 10 && before < 40) {
            early += dt * count;
            early_time += dt;
        } else if (before >= 70) {
            late += dt * count;
            late_time += dt;
        }
    }
    const sph2d_summary end = sph2d_sim_summary(s.sim);
    tell(o, "stopped by a guard", s.status != SPH2D_OK, 0);
    tell(o, "drift of mass, early to late", fabs(late / late_time / (early / early_time) - 1), 0.001);
    tell(o, "out of the nozzle / what it should give - 1",
         fabs((double)end.fed * 0.025 * 0.025 / (0.25 * end.time) - 1), 0.005);
    tell(o, "particles that nobody counted", ledger(s.sim, 0), 0);
    stage_close(&s);
}

static const hard_case items[] = {
    {"F5", "drops and jets that collide at Mach 0.3", "twice their speed at most, density to 10 %", BY_FREE, 4,
     collisions},
    {"F9", "a channel from a nozzle to a drain, 100 times through (profile: study `poiseuille`)",
     "mass to 0.1 %, the nozzle's rate to 0.5 %", BY_FREE, 20, through},
};
const case_list violent_cases = {items, sizeof items / sizeof *items};
