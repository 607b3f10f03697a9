/* SPDX-License-Identifier: MIT */
/* Scenes as strangers would write them: every method, shape, wall and drive, sizes from millimetres to hundreds
 * of metres, liquids from light ones to mercury, a few of them faulty. Numbers have four digits, as people write
 * them. */
#include <math.h>

#include "draft.h"
#include "random_scene.h"

static const double pi = 3.14159265358979323846;

// ---- the room ------------------------------------------------------------------------------------------------------

/** Sides: mostly a tank, sometimes open ones, sometimes a period; rooms that are full are closed, drops fly free. */
static void write_room(draft *d)
{
    d->periodic_x = chance(d, d->full ? 0.7 : 0.15);
    d->periodic_y = d->full && chance(d, d->periodic_x ? 0.7 : 0.2);
    d->width = decades(d, 0.002, 300);
    d->height = d->width * (d->periodic_x && d->periodic_y ? 1 : decades(d, 0.4, 2.5));
    d->left = chance(d, 0.5) ? 0 : -d->width * between(d, 0, 1);
    d->bottom = chance(d, 0.5) ? 0 : -d->height * between(d, 0, 1);
    fprintf(d->out, "domain: {min: [%.4g, %.4g], max: [%.4g, %.4g]}\n", d->left, d->bottom, d->left + d->width,
            d->bottom + d->height);
    static const char *const names[] = {"left", "right", "bottom", "top"};
    const char *kinds[4];
    for (int side = 0; side < 4; ++side) {
        const bool periodic = side < 2 ? d->periodic_x : d->periodic_y;
        d->open[side] = !periodic && !d->full && (d->free || chance(d, side == 3 ? 0.6 : 0.12));
        kinds[side] = periodic ? "periodic" : d->open[side] ? "open" : "wall";
    }
    const bool said = !chance(d, 0.2) || d->full || d->free || d->periodic_x;
    if (!said) // the defaults
        for (int side = 0; side < 4; ++side)
            d->open[side] = side == 3;
    else {
        fputs("boundary: {", d->out);
        for (int side = 0; side < 4; ++side)
            fprintf(d->out, "%s%s: %s", side ? ", " : "", names[side], kinds[side]);
        fputs("}\n", d->out);
    }
}

static void write_gravity(draft *d)
{
    double x = 0, y = -9.81;
    const double kind = between(d, 0, 1);
    if (d->free || (d->full && chance(d, 0.7)) || kind < 0.08)
        y = 0;
    else if (kind < 0.16)
        y = decades(d, 0.05, 200) * (chance(d, 0.8) ? -1 : 1);
    else if (kind < 0.24) {
        x = between(d, -10, 10);
        y = between(d, -10, 10);
    } else if (kind < 0.6) { // not said
        d->gravity = 9.81;
        d->fall = d->height;
        return;
    }
    fprintf(d->out, "gravity: [%.4g, %.4g]\n", x, y);
    d->gravity = hypot(x, y);
    d->fall = d->gravity > 0 ? (fabs(x) * d->width + fabs(y) * d->height) / d->gravity : 0;
}

// ---- liquid --------------------------------------------------------------------------------------------------------

/** A liquid that is not Newtonian, as viscous as one with a Reynolds number of at least 3. */
static void write_model(draft *d, double speed)
{
    const double least = d->thick ? 0.01 : 3; /* Reynolds number */
    const double rate = speed / d->width, most = d->density * speed * d->width / decades(d, least, 1e4);
    const double index = between(d, 0.4, 1.5);
    const char *model = ONE_OF(d, "power_law", "carreau", "herschel_bulkley");
    fprintf(d->out, ", model: %s, index: %.3g", model, index);
    if (model[0] == 'c')
        fprintf(d->out, ", dynamic_viscosity: %.3g, infinite_viscosity: %.3g, relaxation_time: %.3g", most,
                most * between(d, 0, 0.5), between(d, 0.1, 10) / rate);
    else
        fprintf(d->out, ", consistency: %.3g, regularisation: %.3g", most * pow(rate, 1 - index) / 10, 10 / rate);
    if (model[0] == 'h')
        fprintf(d->out, ", yield_stress: %.3g", most * rate / 10);
    d->viscosity = 3 * most;
}

static void write_fluid(draft *d)
{
    d->density = chance(d, 0.6) ? 1000 : decades(d, 1, 13600);
    const double speed = sqrt(2 * d->gravity * d->fall + d->speed * d->speed) + 1e-3 * d->width;
    const double water = 0.001;
    const bool said = !chance(d, 0.3);
    d->viscosity = said ? d->density * speed * d->width / decades(d, d->thick ? 1e-3 : 3, d->thick ? 1e3 : 1e7) : water;
    if (d->full && chance(d, 0.1))
        d->viscosity = 0;
    d->tension = !d->fitted && !d->gridded && chance(d, d->width < 0.1 ? 0.35 : 0.1)
                     ? d->width < 0.1 ? 0.0728 : decades(d, 1e-4, 0.1) * d->density * speed * speed * d->width
                     : 0;
    fprintf(d->out, "fluid: {density: %.4g", d->density);
    if ((d->opened || d->thick) && chance(d, 0.25))
        write_model(d, speed);
    else if (said)
        fprintf(d->out, ", dynamic_viscosity: %.3g", d->viscosity);
    if (d->tension > 0)
        fprintf(d->out, ", surface_tension: %.3g", d->tension);
    fputs("}\n", d->out);
}

/** A place for something of so large a half size, free of what is there. */
static bool find_place(draft *d, places *taken, double half_x, double half_y, bool on_floor, place *out)
{
    for (int attempt = 0; attempt < 30 && taken->count < MOST_PLACES; ++attempt) {
        *out = (place){.half_x = half_x, .half_y = half_y};
        out->x = between(d, d->left + half_x, d->left + d->width - half_x);
        out->y = on_floor ? d->bottom + half_y : between(d, d->bottom + half_y, d->bottom + d->height - half_y);
        bool free = true;
        for (int i = 0; i < taken->count; ++i)
            free = free && (fabs(out->x - taken->items[i].x) > half_x + taken->items[i].half_x + 2 * d->spacing ||
                            fabs(out->y - taken->items[i].y) > half_y + taken->items[i].half_y + 2 * d->spacing);
        if (free) {
            taken->items[taken->count++] = *out;
            return true;
        }
    }
    return false;
}

static void write_polygon(draft *d, const place *at)
{
    const int corners = 3 + (int)(draft_next(d) % 4);
    const double turn = between(d, 0, 2 * pi);
    fputs("  - polygon: [", d->out);
    for (int i = 0; i < corners; ++i)
        fprintf(d->out, "%s[%.4g, %.4g]", i ? ", " : "", at->x + at->half_x * cos(turn + 2 * pi * i / corners),
                at->y + at->half_y * sin(turn + 2 * pi * i / corners));
    fputs("]\n", d->out);
}

static void write_block(draft *d, const place *at, const char *shape)
{
    if (shape[0] == 'b')
        fprintf(d->out, "  - box: {min: [%.4g, %.4g], max: [%.4g, %.4g]}\n", at->x - at->half_x, at->y - at->half_y,
                at->x + at->half_x, at->y + at->half_y);
    else if (shape[0] == 'd') {
        fprintf(d->out, "  - disc: {center: [%.4g, %.4g], radius: %.4g}\n", at->x, at->y, at->half_x);
        if (chance(d, 0.4))
            fputs("    arrangement: rings\n", d->out);
    } else
        write_polygon(d, at);
    if (chance(d, d->free ? 0.5 : d->gravity > 0 ? 0.35 : 0.9)) {
        const double speed = between(d, 0.05, 1.5) * sqrt(fmax(d->gravity, 1) * d->width);
        const double turn = between(d, 0, 2 * pi);
        fprintf(d->out, "    velocity: [%.3g, %.3g]\n", speed * cos(turn), speed * sin(turn));
        d->speed = fmax(d->speed, speed);
    } else if (d->free && shape[0] == 'd') {
        const double speed = between(d, 0.1, 2) * sqrt(d->width);
        fprintf(d->out, "    start: {flow: %s, speed: %.3g, length: %.4g, center: [%.4g, %.4g]}\n",
                ONE_OF(d, "rotation", "strain"), speed, at->half_x, at->x, at->y);
        d->speed = fmax(d->speed, speed);
    }
    if (chance(d, 0.15))
        fprintf(d->out, "    perturb: {amplitude: %.2g, seed: %d}\n", decades(d, 1e-3, 0.25),
                (int)(draft_next(d) % 1000));
    if (!d->gridded && chance(d, 0.03))
        fprintf(d->out, "    spacing: %.4g\n", d->spacing * between(d, 0.8, 1));
}

/** Blocks with places of their own; the spacing follows from their area, for a few hundred particles. */
static void draw_blocks(draft *d, places *taken, const char **shapes)
{
    d->spacing = 0.02 * fmin(d->width, d->height);
    const int wanted = 1 + (chance(d, 0.35) ? 1 : 0) + (chance(d, 0.1) ? 1 : 0);
    for (int i = 0; i < wanted; ++i) {
        const char *shape = d->free && i == 0 ? "disc" : ONE_OF(d, "box", "box", "box", "disc", "polygon");
        place at;
        double half_x = d->width * between(d, 0.1, wanted == 1 ? 0.5 : 0.25);
        double half_y = d->height * between(d, 0.1, wanted == 1 ? 0.4 : 0.25);
        if (shape[0] == 'd')
            half_x = half_y = 0.6 * fmin(half_x, half_y);
        if (shape[0] == 'b' && chance(d, 0.25)) // a pool from side to side
            half_x = d->width / 2;
        if (!find_place(d, taken, half_x, half_y, shape[0] == 'b' && chance(d, 0.6), &at))
            continue;
        shapes[taken->count - 1] = shape;
        d->area += shape[0] == 'b' ? 4 * half_x * half_y : 2.6 * half_x * half_y;
    }
    const double particles = decades(d, 60, 600);
    d->spacing = fmax(sqrt(d->area / particles), fmax(d->width, d->height) / 200);
}

static void write_full(draft *d)
{
    fprintf(d->out, "blocks:\n  - box: {min: [%.4g, %.4g], max: [%.4g, %.4g]}\n", d->left, d->bottom,
            d->left + d->width, d->bottom + d->height);
    const double speed = decades(d, 0.01, 10);
    const double length = fmin(d->width, d->height);
    if (d->periodic_x && d->periodic_y)
        fprintf(d->out, "    start: {flow: %s, speed: %.3g, length: %.4g, center: [%.4g, %.4g]}\n",
                ONE_OF(d, "taylor_green", "gresho"), speed, d->width, d->left + d->width / 2,
                d->bottom + d->height / 2);
    else if (d->periodic_x || d->periodic_y || chance(d, 0.5))
        fprintf(d->out, "    velocity: [%.3g, %.3g]\n", d->periodic_x ? speed : 0, d->periodic_y ? speed : 0);
    else
        fprintf(d->out, "    start: {flow: gresho, speed: %.3g, length: %.4g, center: [%.4g, %.4g]}\n", speed,
                0.9 * length, d->left + d->width / 2, d->bottom + d->height / 2);
    if (chance(d, 0.5))
        fprintf(d->out, "    perturb: {amplitude: %.2g}\n", between(d, 0.01, 0.2));
    d->speed = fmax(d->speed, speed);
}

// ---- what stands and moves in it -----------------------------------------------------------------------------------

static void write_motion(draft *d, double half)
{
    const double speed = between(d, 0.1, 0.6) * sqrt(fmax(d->gravity, 0.1) * d->height);
    const double reach = between(d, 1, 5) * d->spacing;
    d->speed = fmax(d->speed, speed);
    if (chance(d, 0.5))
        fprintf(d->out, "    motion: {amplitude: [%.3g, %.3g], frequency: %.3g%s", reach * between(d, -1, 1),
                reach * between(d, -1, 1), speed / (2 * pi * reach), chance(d, 0.5) ? ", phase: -1.5708" : "");
    else
        fprintf(d->out, "    motion: {path: [[0, 0, 0], [%.3g, %.3g, %.3g], [%.3g, 0, 0]]", reach / speed,
                reach * between(d, -1, 1), reach * between(d, -1, 1), 3 * reach / speed);
    if (chance(d, 0.5))
        fprintf(d->out, ", rate: %.3g", between(d, -0.7, 0.7) * speed / half);
    fputs("}\n", d->out);
}

static void write_obstacles(draft *d, places *taken)
{
    const int wanted = d->full || d->free ? 0 : (chance(d, 0.4) ? 1 : 0) + (chance(d, 0.15) ? 1 : 0);
    for (int i = 0, written = 0; i < wanted; ++i) {
        const double half = fmax(between(d, 0.05, 0.15) * d->width, 4 * d->spacing);
        place at;
        if (2 * half > fmin(d->width, d->height) || !find_place(d, taken, half, half, false, &at))
            continue;
        if (written++ == 0)
            fputs("obstacles:\n", d->out);
        const char *shape = ONE_OF(d, "circle", "box", "line", "polyline");
        draft aside = *d; /* choices that move no other */
        const bool bent = shape[0] == 'l' && chance(&aside, 0.4);
        const double turn = between(d, 0, 2 * pi), x = half * cos(turn), y = half * sin(turn);
        if (shape[0] == 'c')
            fprintf(d->out, "  - circle: {center: [%.4g, %.4g], radius: %.4g}\n", at.x, at.y, half);
        else if (shape[0] == 'b')
            fprintf(d->out, "  - box: {min: [%.4g, %.4g], max: [%.4g, %.4g]}\n", at.x - half, at.y - half, at.x + half,
                    at.y + half * 0.6);
        else if (bent)
            fprintf(d->out, "  - arc: {center: [%.4g, %.4g], radius: %.4g, from: %.4g, to: %.4g}\n", at.x, at.y, half,
                    turn, turn + between(&aside, 0.5, 5));
        else if (shape[0] == 'l')
            fprintf(d->out, "  - line: [[%.4g, %.4g], [%.4g, %.4g]]\n", at.x - x, at.y - y, at.x + x, at.y + y);
        else
            fprintf(d->out, "  - polyline: [[%.4g, %.4g], [%.4g, %.4g], [%.4g, %.4g]]\n", at.x - x, at.y - y, at.x,
                    at.y, at.x - y, at.y + x);
        const bool own_form = !d->gridded && chance(d, 0.3);
        if (own_form)
            fprintf(d->out, "    form: %s\n",
                    is(d, "muller") ? ONE_OF(d, "heavy", "reflect") : ONE_OF(d, "generalised"));
        if (!own_form && is(d, "wcsph") && !d->fitted && chance(&aside, 0.3))
            fprintf(d->out, "    slip: %s\n", ONE_OF(&aside, "free", "none", "smooth"));
        if (chance(d, 0.25))
            write_motion(d, half);
    }
}

static void write_drives(draft *d, places *taken)
{
    place at;
    const double half = 3 * d->spacing;
    if (!d->full && chance(d, 0.12) && find_place(d, taken, half, half, false, &at)) {
        const double speed = between(d, 0.1, 1) * sqrt(2 * fmax(d->gravity, 0.1) * d->height);
        fprintf(d->out, "sources:\n  - {at: [%.4g, %.4g], direction: [%.2g, %.2g], width: %.3g, speed: %.3g", at.x,
                at.y, between(d, -1, 1), between(d, -1, -0.1), between(d, 1, 5) * d->spacing, speed);
        if (chance(d, 0.3))
            fprintf(d->out, ", spread: %.2g", between(d, 0, 0.2));
        fputs("}\n", d->out);
        d->speed = fmax(d->speed, speed);
    }
    if (!d->full && chance(d, 0.1))
        fprintf(d->out, "drains:\n  - box: {min: [%.4g, %.4g], max: [%.4g, %.4g]}\n", d->left, d->bottom,
                d->left + between(d, 0.05, 0.3) * d->width, d->bottom + between(d, 0.05, 0.3) * d->height);
    if (chance(d, 0.08)) {
        const double radius = d->width * between(d, 0.1, 0.4), pull = between(d, -3, 3) * fmax(d->gravity, 1);
        fprintf(d->out, "interactions:\n  - {path: [[0, %.4g, %.4g]], radius: %.3g, acceleration: %.3g}\n",
                d->left + d->width * between(d, 0.2, 0.8), d->bottom + d->height * between(d, 0.2, 0.8), radius, pull);
        d->speed = fmax(d->speed, sqrt(radius * fabs(pull)));
    }
    if (d->free && chance(d, 0.4)) {
        const double rate = fmax(d->speed, 0.1) / d->width * between(d, 0.5, 3);
        fprintf(d->out, "central_force: {center: [%.4g, %.4g], rate: %.3g}\n", d->left + d->width / 2,
                d->bottom + d->height / 2, rate);
        d->speed = fmax(d->speed, rate * d->width / 2);
    }
}

/** Some hundred steps to a few thousand, by the rules of the man page; solvers take few and costly ones. */
static double run_time(draft *d)
{
    const double reach = d->support * d->spacing, nu = d->viscosity / d->density;
    const double speed = sqrt(2 * d->gravity * d->fall + d->speed * d->speed) + 1e-9;
    const bool solver = is(d, "pcisph") || is(d, "constraint") || d->gridded;
    const double sound = solver ? 0 : speed / sqrt(d->max_compression);
    const double particles = d->area / (d->spacing * d->spacing);
    double step = d->cfl * reach / (sound + speed);
    if (nu > 0 && !d->thick && !d->gridded)
        step = fmin(step, 0.05 * reach * reach / nu);
    if (d->tension > 0)
        step = fmin(step, 0.2 * sqrt(d->density * pow(d->spacing, 3) / d->tension));
    const double most = fmin(solver ? 500 : 3000, (solver ? 1e5 : 4e5) / particles);
    return step * decades(d, solver ? 60 : 200, fmax(most, 300));
}

/** Things that `check` must refuse, and `run` with the same words. */
static void write_fault(draft *d)
{
    fputs(ONE_OF(d, "impact: 3\n", "walls: sprung\n", "wall_damping: 2\n", "wall_damping: .nan\n",
                 "probes: [{name: energy, kind: energy, every: 1}, {name: energy, kind: extent, every: 1}]\n",
                 "interactions: [{path: [[0, 0, 0]], acceleration: 1}]\n", "particles: nowhere.csv\n",
                 "drains: [{disc: {center: [0, 0], radius: 0}}]\n"),
          d->out);
}

/* Scenes up to this seed have no bodies and no tank that moves: older than both, and the same since. */
enum { WITHOUT_BODIES = 1000 };
/* From this one on they have openings. */
enum { WITH_OPENINGS = 2001 };
/* From this one on they have thick liquids in their place, by methods that solve for viscosity. */
enum { WITH_THICK = 3001 };
/* From this one on they are by method hybrid, as the first. */
enum { WITH_GRID = 4001 };

/* From this one on they are of one of these kinds, by turns. */
enum { OF_ANY_KIND = 5001 };

void random_scene_write(uint64_t seed, FILE *out)
{
    static const uint64_t kinds[] = {WITHOUT_BODIES, WITHOUT_BODIES + 1, WITH_OPENINGS, WITH_THICK, WITH_GRID};
    const uint64_t like = seed < OF_ANY_KIND ? seed : kinds[seed % (sizeof kinds / sizeof *kinds)];
    const bool gridded = like >= WITH_GRID, thick = like >= WITH_THICK && !gridded;
    const bool opened = like >= WITH_OPENINGS && !thick && !gridded;
    draft d = {.out = out,
               .random = seed * 0x2545f4914f6cdd1du,
               .bodied = like > WITHOUT_BODIES && !thick && !gridded,
               .opened = opened,
               .thick = thick,
               .gridded = gridded};
    const double kind = between(&d, 0, 1);
    d.full = kind < 0.15;
    d.free = kind > 0.88 && !opened;
    places taken = {.count = 0};
    const char *shapes[MOST_PLACES] = {NULL};
    fprintf(out, "name: stranger_%llu\n", (unsigned long long)seed);
    write_room(&d);
    write_gravity(&d);
    write_method(&d);
    write_walls(&d);
    if (d.full) {
        d.area = d.width * d.height;
        d.spacing = sqrt(d.area / decades(&d, 150, 600));
        if (d.periodic_x || d.periodic_y) // whole rows
            d.spacing = (d.periodic_x ? d.width : d.height) / ceil((d.periodic_x ? d.width : d.height) / d.spacing);
    } else
        draw_blocks(&d, &taken, shapes);
    fprintf(out, "spacing: %.4g\n", d.spacing);
    if (d.full)
        write_full(&d);
    else {
        fputs("blocks:\n", out);
        for (int i = 0; i < taken.count && shapes[i]; ++i)
            write_block(&d, &taken.items[i], shapes[i]);
    }
    const int first = taken.count;
    write_obstacles(&d, &taken);
    write_drives(&d, &taken);
    write_fluid(&d);
    if (opened)
        write_openings(&d);
    if (d.bodied && (!opened || chance(&d, 0.15))) {
        if (!opened)
            write_tank(&d);
        write_bodies(&d, &taken, first);
    }
    const double until = run_time(&d);
    if (chance(&d, 0.06))
        write_fault(&d);
    else
        fprintf(out, "probes: [{name: energy, kind: energy, every: %.3g}]\n", until / 50);
    fprintf(out, "run: {until: %.4g}\n", until);
}
