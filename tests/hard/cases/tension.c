/* SPDX-License-Identifier: MIT */
/** @file tension.c C: liquid under tension, pairs of particles, starts without order. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cases.h"

enum { SIDE = 20, COUNT = SIDE * SIDE };

/** Particles in a periodic box: a lattice of so many times the rest density, each coordinate displaced by up to `noise`
 *  spacings; with noise above 1 anywhere. */
static bool open_box(stage *s, outcome *o, const char *options, double density, double noise, sph2d_particle *p)
{
    const double dx = 0.05, apart = dx / sqrt(density), period = SIDE * apart;
    uint64_t seed = 11;
    if (!stage_read(s, o, options,
                    "domain: {min: [0, 0], max: [%.17g, %.17g]}\n"
                    "boundary: {left: periodic, right: periodic, bottom: periodic, top: periodic}\n"
                    "gravity: [0, 0]\nspacing: %g\nparticles: those.csv\n",
                    period, period, dx))
        return false;
    for (int i = 0; i < COUNT; ++i) {
        const double u = 2 * uniform(&seed) - 1, v = 2 * uniform(&seed) - 1;
        p[i] = (sph2d_particle){.x = apart * (i % SIDE + 0.5 + noise * u),
                                .y = apart * (i / SIDE + 0.5 + noise * v),
                                .density = 1000 * density};
        p[i].x -= period * floor(p[i].x / period);
        p[i].y -= period * floor(p[i].y / period);
    }
    stage_put(s, p, COUNT);
    return true;
}

// ---- C4 -------------------------------------------------------------------------------------------------------------

/** Steps until two particles are nearer than 0.8 dx, of 1e4; the least distance then or at last, over dx. */
static unsigned long torn_after(outcome *o, const char *options, double *least)
{
    static sph2d_particle p[COUNT];
    stage s;
    *least = 0;
    if (!open_box(&s, o, options, 0.97, 1e-3, p) || !stage_start(&s, o))
        return 0;
    const double period = s.scene.domain.max.x, dx = 0.05;
    for (int k = 0; k < 100 && stage_steps(&s, 100); ++k) {
        cloud c = cloud_of(s.sim);
        *least = cloud_least(&c, period) / dx;
        cloud_free(&c);
        if (*least < 0.8)
            break;
    }
    const unsigned long steps = (unsigned long)sph2d_sim_steps(s.sim);
    tell_of(o, "stopped by a guard", options, s.status != SPH2D_OK, 0);
    stage_close(&s);
    return steps;
}

static void tension(outcome *o)
{
    double least;
    torn_after(o, "sound_speed: 10", &least);
    tell(o, "0.8 less nearest / dx", 0.8 - least, 0);
    if (o->method != FITTED)
        return;
    const unsigned long steps = torn_after(o, "sound_speed: 10, shifting: 0", &least);
    tell_only(o, "without shifting: steps until 0.8 dx, or 1e4", (double)steps);
}

// ---- C5 -------------------------------------------------------------------------------------------------------------

static double paired(outcome *o, const char *options)
{
    static sph2d_particle p[COUNT];
    stage s;
    double part = NAN;
    if (!open_box(&s, o, options, 1.02, 1e-3, p) || !stage_start(&s, o))
        return part;
    stage_finish(&s, o, 50 * sph2d_sim_plan(s.sim)->support_radius / 10);
    cloud c = cloud_of(s.sim);
    part = cloud_paired(&c, s.scene.domain.max.x, 0.5 * 0.05);
    cloud_free(&c);
    stage_close(&s);
    return part;
}

static void pairing(outcome *o)
{
    for (int ratio = 2; ratio <= 4; ++ratio) {
        char options[100], name[40];
        snprintf(options, sizeof options, "sound_speed: 10, support_ratio: %d", ratio);
        snprintf(name, sizeof name, "H/dx %d", ratio);
        const bool judged = o->method != MULLER || ratio == 2; // the kernel of muller is meant for 2
        tell_of(o, "paired", name, paired(o, options), judged ? 0 : (double)NAN);
    }
}

// ---- C6 -------------------------------------------------------------------------------------------------------------

static void disordered(outcome *o)
{
    static sph2d_particle p[COUNT];
    static const double noises[] = {0.1, 0.3, 0.5, 100};
    for (int k = 0; k < 4; ++k) {
        stage s;
        char which[40];
        const bool anywhere = noises[k] > 1;
        snprintf(which, sizeof which, anywhere ? "anywhere" : "%g dx", noises[k]);
        if (!open_box(&s, o, "sound_speed: 10", 1, noises[k], p))
            return;
        if (!stage_try(&s)) {
            tell_of(o, "refused", which, !anywhere, 0);
            stage_close(&s);
            continue;
        }
        const double until = 50 * sph2d_sim_plan(s.sim)->support_radius / 10;
        double fastest = 0;
        while (sph2d_sim_time(s.sim) < until && stage_steps(&s, 1))
            fastest = fmax(fastest, speed_of(s.sim));
        tell_of(o, "not finite", which, !all_finite(s.sim), 0);
        if (!anywhere) {
            tell_of(o, "stopped by a guard", which, s.status != SPH2D_OK, 0);
            tell_of(o, "speed at most / c0", which, fastest / 10, 0.3);
            tell_of(o, "rms of rho/rho0 - 1 at last", which, density_rms(s.sim), 0.01);
        }
        stage_close(&s);
    }
}

static const hard_case items[] = {
    {"C4", "a periodic lattice at 0.97 of the rest density, 1e4 steps", "nobody nearer than 0.8 dx",
     BY_WCSPH | BY_FITTED, 6, tension},
    {"C5", "a lattice at 1.02 of the rest density, H/dx 2, 3, 4, for 50 H/c0",
     "nobody nearer than 0.5 dx; muller from 3 on told", BY_FREE, 6, pairing},
    {"C6", "particles off their lattice by up to 0.1, 0.3, 0.5 dx, and anywhere",
     "no faster than 0.3 c0, after 50 H/c0 1 % rms; anywhere: finite or refused", BY_ALL, 2, disordered},
};
const case_list tension_cases = {items, sizeof items / sizeof *items};
