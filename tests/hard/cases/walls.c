/* SPDX-License-Identifier: MIT */
/** @file walls.c D: liquid at rest on walls, thrown at them, started in them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cases.h"

// ---- D4, D5 ---------------------------------------------------------------------------------------------------------

/** A film of some rows of particles on a floor. */
static void film(outcome *o, int rows, const char *which)
{
    stage s;
    const double dx = 0.02, depth = rows * dx;
    if (!STAGE_OPEN(
            &s, o, "",
            "domain: {min: [0, 0], max: [1, 0.5]}\nspacing: %g\nblocks:\n  - box: {min: [0, 0], max: [1, %g]}\n", dx,
            depth))
        return;
    double fastest = 0, highest = 0;
    stage_run(&s, 2);
    while (sph2d_sim_time(s.sim) < 3 && stage_steps(&s, 10)) {
        const sph2d_view f = sph2d_sim_fluid(s.sim);
        for (size_t i = 0; i < f.count; ++i)
            highest = fmax(highest, f.y[i]);
        fastest = fmax(fastest, speed_of(s.sim));
    }
    tell_of(o, "stopped by a guard", which, s.status != SPH2D_OK, 0);
    tell_of(o, "speed after 2 s / sqrt(g H)", which, fastest / sqrt(9.81 * depth), 0.02);
    tell_of(o, "above its depth / dx", which, highest / dx - rows + 0.5, 0.5);
    stage_close(&s);
}

static void films(outcome *o)
{
    film(o, 1, "one row");
    film(o, 3, "three rows");
}

static void falling(outcome *o)
{
    stage s;
    const double height = 0.9, depth = 0.3, impact = sqrt(2 * 9.81 * (height - depth));
    if (!STAGE_OPEN(&s, o, "",
                    "domain: {min: [0, 0], max: [1, 1.4]}\nspacing: 0.02\nblocks:\n"
                    "  - box: {min: [0, 0], max: [1, %g]}\n  - disc: {center: [0.5, %g], radius: 0.06}\n",
                    depth, height + 0.06))
        return;
    const cloud start = cloud_of(s.sim);
    double off = 0, fastest = 0, sum_x = 0, sum_y = 0, count = 0;
    const double contact = sqrt(2 * (height - depth - 0.12) / 9.81);
    stage_run(&s, 0.9 * contact);
    const cloud before = cloud_of(s.sim);
    for (size_t i = 0; i < before.count && before.count == start.count; ++i)
        if (start.y[i] > depth + 0.1) {
            const double x = before.x[i] - start.x[i];
            const double y = before.y[i] - start.y[i] + 9.81 * before.time * before.time / 2;
            off = fmax(off, hypot(x, y)), sum_x += x, sum_y += y, ++count;
        }
    while (sph2d_sim_time(s.sim) < 1 && stage_steps(&s, 1))
        fastest = fmax(fastest, speed_of(s.sim));
    tell(o, "stopped by a guard", s.status != SPH2D_OK, 0);
    tell(o, "off free flight / m", off, 1e-9);
    tell(o, "centre off free flight / m", hypot(sum_x, sum_y) / count, 1e-9);
    tell(o, "speed at most / impact", fastest / impact, 1.5);
    stage_close(&s);
}

// ---- D6 -------------------------------------------------------------------------------------------------------------

static bool crosses(sph2d_vec2 p, sph2d_vec2 q, sph2d_vec2 a, sph2d_vec2 b)
{
    const double ex = b.x - a.x, ey = b.y - a.y, dx = q.x - p.x, dy = q.y - p.y;
    const double p_side = ex * (p.y - a.y) - ey * (p.x - a.x), q_side = ex * (q.y - a.y) - ey * (q.x - a.x);
    const double a_side = dx * (a.y - p.y) - dy * (a.x - p.x), b_side = dx * (b.y - p.y) - dy * (b.x - p.x);
    return p_side * q_side < 0 && a_side * b_side < 0;
}

/** A block at ten times sqrt(g 0.2 m) against a line; how often a particle crosses it. */
static void jet_on(outcome *o, const char *which, const char *form, sph2d_vec2 a, sph2d_vec2 b)
{
    stage s;
    if (!STAGE_OPEN(&s, o, "",
                    "domain: {min: [0, 0], max: [1, 1]}\nspacing: 0.02\ngravity: [0, 0]\n"
                    "boundary: {left: open, right: open, bottom: open, top: open}\n"
                    "obstacles:\n  - line: [[%g, %g], [%g, %g]]\n    form: %s\n"
                    "blocks:\n  - box: {min: [0.1, 0.4], max: [0.4, 0.6]}\n    velocity: [14, 0]\n",
                    a.x, a.y, b.x, b.y, form))
        return;
    const size_t start = sph2d_sim_fluid(s.sim).count;
    size_t crossed = 0;
    while (sph2d_sim_time(s.sim) < 0.05) {
        const cloud before = cloud_of(s.sim);
        if (!stage_steps(&s, 1))
            break;
        const cloud after = cloud_of(s.sim);
        for (size_t i = 0; i < before.count && before.count == after.count; ++i)
            crossed += crosses((sph2d_vec2){before.x[i], before.y[i]}, (sph2d_vec2){after.x[i], after.y[i]}, a, b);
        free(before.x);
        free(after.x);
    }
    char name[60];
    snprintf(name, sizeof name, "%s, %s", which, form);
    tell_of(o, "stopped by a guard", name, s.status != SPH2D_OK, 0);
    tell_of(o, "crossed", name, (double)crossed, 0);
    tell_of(o, "particles that nobody counted", name, ledger(s.sim, start), 0);
    stage_close(&s);
}

static void tunnel(outcome *o)
{
    const char *forms[2] = {o->method == MULLER ? "heavy" : "generalised", "reflect"};
    for (int k = 0; k < (o->method == MULLER ? 2 : 1); ++k) {
        jet_on(o, "wall", forms[k], (sph2d_vec2){0.5, 0}, (sph2d_vec2){0.5, 1});
        jet_on(o, "edge", forms[k], (sph2d_vec2){0.6, 0.5}, (sph2d_vec2){0.9, 0.5});
    }
}

// ---- D7 -------------------------------------------------------------------------------------------------------------

static void overlap(outcome *o, const char *form)
{
    enum { COLUMNS = 25, ROWS = 20 };
    stage s;
    const double dx = 0.02, depth = ROWS * dx;
    if (!stage_read(&s, o, "sound_speed: 40",
                    "domain: {min: [0, 0], max: [%g, 1]}\nspacing: %g\nwalls: %s\nparticles: those.csv\n", COLUMNS * dx,
                    dx, form))
        return;
    sph2d_particle *p = lattice(COLUMNS, ROWS, dx, (sph2d_vec2){0, -0.499 * dx});
    stage_put(&s, p, (size_t)COLUMNS * ROWS);
    if (!stage_try(&s)) // an answer, too
        tell_of(o, "refused for another reason than overlap", form, !stage_reports(&s, SPH2D_CODE_OVERLAP), 0);
    else {
        double fastest = 0;
        while (sph2d_sim_time(s.sim) < 0.5 && stage_steps(&s, 1))
            fastest = fmax(fastest, speed_of(s.sim));
        tell_of(o, "stopped by a guard", form, s.status != SPH2D_OK, 0);
        tell_of(o, "speed at most / sqrt(2 g H)", form, fastest / sqrt(2 * 9.81 * depth), 1);
        tell_of(o, "particles that nobody counted", form, ledger(s.sim, (size_t)COLUMNS * ROWS), 0);
    }
    stage_close(&s);
    free(p);
}

static void overlapping(outcome *o)
{
    static const char *const forms[] = {"spring", "heavy", "reflect"};
    for (int k = 0; k < 3 && o->method == MULLER; ++k)
        overlap(o, forms[k]);
    if (o->method != MULLER)
        overlap(o, "generalised");
}

// ---- D8 to D10 ------------------------------------------------------------------------------------------------------

static void dragged(outcome *o)
{
    stage s;
    if (!STAGE_OPEN(
            &s, o, "",
            "domain: {min: [0, 0], max: [2, 1]}\nspacing: 0.02\nblocks:\n  - box: {min: [0, 0], max: [2, 0.6]}\n"
            "obstacles:\n  - box: {min: [0.4, 0.2], max: [0.6, 0.4]}\n"
            "    motion: {amplitude: [0.4, 0], frequency: 0.25, phase: -1.570796326794897}\n"))
        return;
    // It passes 0.6 m to the right of where it was at 0.63 m/s after 1 s: the middle of its way.
    stage_finish(&s, o, 1);
    double least = INFINITY;
    for (int k = -3; k <= 3; ++k) {
        sph2d_sample near = {.neighbours = 0}, far = {.neighbours = 0};
        const double moved = 0.4 * (1 - cos(0.5 * CASE_PI * sph2d_sim_time(s.sim)));
        sph2d_sim_sample(s.sim, (sph2d_vec2){0.4 + moved - 0.06, 0.3 + 0.02 * k}, &near);
        sph2d_sim_sample(s.sim, (sph2d_vec2){1.6, 0.3}, &far);
        least = fmin(least, near.neighbours / far.neighbours);
    }
    tell(o, "1 - neighbours behind / neighbours elsewhere", 1 - least, 0.5);
    tell(o, "speed at most / its speed", speed_of(s.sim) / 0.63, 3);
    stage_close(&s);
}

static void overfilled(outcome *o)
{
    stage s;
    if (!STAGE_OPEN(&s, o, "",
                    "domain: {min: [0, 0], max: [0.5, 0.5]}\nspacing: 0.02\nboundary: {top: wall}\n"
                    "blocks:\n  - box: {min: [0, 0], max: [0.5, 0.5]}\n"
                    "sources: [{at: [0.25, 0.25], width: 0.1, speed: 0.5}]\n"))
        return;
    const size_t start = sph2d_sim_fluid(s.sim).count;
    double densest = 0;
    while (sph2d_sim_time(s.sim) < 2 && stage_steps(&s, 5))
        densest = fmax(densest, density_of(s.sim));
    tell(o, "stopped by a guard", s.status != SPH2D_OK, 0);
    tell(o, "rho / rho0 at most", densest, 1.1);
    tell(o, "particles that nobody counted", ledger(s.sim, start), 0);
    tell(o, "not told to be blocked", sph2d_sim_summary(s.sim).blocked == 0, 0);
    stage_close(&s);
}

/** A column of 10 m with the sound speed that 0.1 m of liquid would have: compressed by no more than 1 %, or told. */
static void tall(outcome *o)
{
    stage s;
    const char *options = o->method == MULLER ? "sound_speed: 4.4" : o->method == WCSPH ? "sound_speed: 14" : "";
    if (!stage_read(
            &s, o, options,
            "domain: {min: [0, 0], max: [0.1, 11]}\nspacing: 0.02\nblocks:\n  - box: {min: [0, 0], max: [0.1, 10]}\n"))
        return;
    sph2d_report warnings = {0};
    sph2d_plan plan;
    sph2d_scene_plan(&s.scene, &plan, &warnings);
    bool told = warnings.count > 0;
    if (stage_try(&s)) {
        stage_run(&s, 1.5);
        told = told || s.status == SPH2D_GUARD || s.report.count > 0;
        const double compression = sph2d_sim_summary(s.sim).compression_p99;
        tell_only(o, "compression, p99", compression);
        tell(o, "compression without a word", told ? 0 : compression, 0.01);
        tell(o, "not finite", !all_finite(s.sim), 0);
        if (o->method == PCISPH || o->method == CONSTRAINT)
            tell_only(o, "iterations in a step",
                      (double)sph2d_sim_summary(s.sim).iterations / (double)sph2d_sim_steps(s.sim));
    }
    tell(o, "neither run nor refused", s.sim == NULL && s.report.errors == 0, 0);
    stage_close(&s);
}

static const hard_case items[] = {
    {"D4", "a film of one row, of three rows (two: study film)",
     "still to 0.02 sqrt(g H) after 2 s, in its place to 0.5 dx", BY_FREE, 4, films},
    {"D5", "a drop that falls into a pool", "free flight to 1e-9 m, then 1.5 times the speed of impact at most",
     BY_FREE, 2, falling},
    {"D6", "a block at 10 sqrt(g H) on a thin wall, and on an edge", "nothing crosses", BY_FREE, 0.9, tunnel},
    {"D7", "liquid that starts half a spacing in the floor", "no faster than sqrt(2 g H), nothing lost; or refused",
     BY_FREE, 2, overlapping},
    {"D8", "a square that is moved through a pool", "no gap behind it: half of the neighbours or more", BY_FREE, 5,
     dragged},
    {"D9", "a nozzle in a closed box that is full", "rho/rho0 below 1.1, and what was blocked is told", BY_FREE, 4,
     overfilled},
    {"D10", "a column of 10 m with the sound speed for 0.1 m; by solvers their own",
     "compressed by 1 % at most, or told", BY_FREE, 4, tall},
};
const case_list wall_cases = {items, sizeof items / sizeof *items};
