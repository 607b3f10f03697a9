/* SPDX-License-Identifier: MIT */
/* Rigid bodies of a random scene: what they are, what holds, pulls and turns them; and the motion of its tank. */
#include <math.h>

#include "draft.h"

static const double pi = 3.14159265358979323846;
enum { MOST_BODIES = 4 };

/** A body that is being written. */
typedef struct body {
    place at;
    double mass, half; /**< [kg/m]; mean half size [m] */
    bool held_x, held_y, held_angle;
} body;

/** A place in the domain, often at a side, with a small gap to what is taken; numbers of the domain are rounded. */
static bool find_room(draft *d, const places *taken, int first, const places *bodies, place *out)
{
    const double gap = 0.3 * d->spacing;
    const int side = chance(d, 0.35) ? (int)(draft_next(d) % 4) : 4;
    const double off_x = 1e-3 * (fabs(d->left) + d->width), off_y = 1e-3 * (fabs(d->bottom) + d->height);
    const double left = d->left + off_x + out->half_x, right = d->left + d->width - off_x - out->half_x;
    const double bottom = d->bottom + off_y + out->half_y, top = d->bottom + d->height - off_y - out->half_y;
    for (int attempt = 0; attempt < 30; ++attempt) {
        out->x = side == 0 ? left : side == 1 ? right : between(d, left, right);
        out->y = side == 2 ? bottom : side == 3 ? top : between(d, bottom, top);
        bool free = true;
        const places *lists[2] = {taken, bodies};
        for (int k = 0; k < 2; ++k)
            for (int i = k == 0 ? first : 0; i < lists[k]->count; ++i) {
                const place *other = &lists[k]->items[i];
                free = free && (fabs(out->x - other->x) > out->half_x + other->half_x + gap ||
                                fabs(out->y - other->y) > out->half_y + other->half_y + gap);
            }
        if (free)
            return true;
    }
    return false;
}

/** Corners on an ellipse; of stars each second one is nearer to the centre. Returns its area. */
static double write_corners(draft *d, const place *at, bool star)
{
    const int corners = star ? 2 * (3 + (int)(draft_next(d) % 3)) : 3 + (int)(draft_next(d) % 4);
    const double turn = between(d, 0, 2 * pi), inner = star ? between(d, 0.5, 0.9) : 1;
    fputs("  - polygon: [", d->out);
    for (int i = 0; i < corners; ++i) {
        const double r = i % 2 ? inner : 1, angle = turn + 2 * pi * i / corners;
        fprintf(d->out, "%s[%.6g, %.6g]", i ? ", " : "", at->x + r * at->half_x * cos(angle),
                at->y + r * at->half_y * sin(angle));
    }
    fputs("]\n", d->out);
    return corners * inner * sin(2 * pi / corners) / 2 * at->half_x * at->half_y;
}

static double write_outline(draft *d, const place *at, const char *shape)
{
    if (shape[0] == 'c') {
        fprintf(d->out, "  - circle: {center: [%.6g, %.6g], radius: %.6g}\n", at->x, at->y, at->half_x);
        return pi * at->half_x * at->half_x;
    }
    if (shape[0] == 'b') {
        fprintf(d->out, "  - box: {min: [%.6g, %.6g], max: [%.6g, %.6g]}\n", at->x - at->half_x, at->y - at->half_y,
                at->x + at->half_x, at->y + at->half_y);
        return 4 * at->half_x * at->half_y;
    }
    return write_corners(d, at, shape[0] == 's');
}

static void write_mass(draft *d, body *b, double area)
{
    const double density = d->density * decades(d, 0.05, 20);
    b->mass = density * area;
    if (chance(d, 0.75))
        fprintf(d->out, "    density: %.4g\n", density);
    else {
        fprintf(d->out, "    mass: %.4g\n", b->mass);
        if (chance(d, 0.5))
            fprintf(d->out, "    inertia: %.4g\n", b->mass * b->half * b->half * between(d, 0.2, 0.8));
        if (chance(d, 0.5))
            fprintf(d->out, "    center: [%.6g, %.6g]\n", b->at.x + b->half * between(d, -0.2, 0.2),
                    b->at.y + b->half * between(d, -0.2, 0.2));
    }
}

static void write_hold(draft *d, body *b)
{
    if (!chance(d, 0.25))
        return;
    b->held_x = chance(d, 0.5);
    b->held_y = chance(d, 0.5);
    b->held_angle = chance(d, 0.4);
    fprintf(d->out, "    hold: {x: %s, y: %s, angle: %s}\n", b->held_x ? "on" : "off", b->held_y ? "on" : "off",
            b->held_angle ? "on" : "off");
}

static void write_start(draft *d, const body *b)
{
    const double speed = decades(d, 0.03, 1) * sqrt(fmax(d->gravity, 0.1) * d->height);
    if (chance(d, 0.35)) {
        const double turn = between(d, 0, 2 * pi);
        fprintf(d->out, "    velocity: [%.3g, %.3g]\n", b->held_x ? 0 : speed * cos(turn),
                b->held_y ? 0 : speed * sin(turn));
        d->speed = fmax(d->speed, speed);
    }
    if (!b->held_angle && chance(d, 0.25)) {
        fprintf(d->out, "    rate: %.3g\n", (chance(d, 0.5) ? 1 : -1) * speed / b->half);
        d->speed = fmax(d->speed, speed);
    }
    if (!b->held_angle && chance(d, 0.25))
        fprintf(d->out, "    motor: {rate: %.3g, torque: %.3g}\n",
                chance(d, 0.4) ? 0 : (chance(d, 0.5) ? 1 : -1) * speed / b->half,
                decades(d, 0.03, 3) * b->mass * fmax(d->gravity, 1) * b->half);
}

static void write_springs(draft *d, const body *b)
{
    if (!chance(d, 0.35))
        return;
    const int count = 1 + (chance(d, 0.4) ? 1 : 0);
    fputs("    springs:\n", d->out);
    for (int i = 0; i < count; ++i) {
        const double omega = decades(d, 0.5, 30) * sqrt(fmax(d->gravity, 0.1) / d->height), reach = between(d, 0.5, 5);
        const double turn = between(d, 0, 2 * pi);
        fprintf(d->out, "      - {to: [%.4g, %.4g], stiffness: %.3g", b->at.x + reach * b->half * cos(turn),
                b->at.y + reach * b->half * sin(turn), b->mass * omega * omega);
        if (chance(d, 0.5))
            fprintf(d->out, ", damping: %.3g", decades(d, 0.02, 2) * b->mass * omega);
        if (chance(d, 0.5))
            fprintf(d->out, ", at: [%.4g, %.4g]", b->at.x + b->half * between(d, -0.6, 0.6),
                    b->at.y + b->half * between(d, -0.6, 0.6));
        if (chance(d, 0.4))
            fprintf(d->out, ", length: %.3g", chance(d, 0.2) ? 0 : reach * b->half * between(d, 0.3, 1.5));
        if (chance(d, 0.4))
            fputs(", slack: on", d->out);
        fputs("}\n", d->out);
    }
}

static void write_surface(draft *d)
{
    if (chance(d, 0.4))
        fprintf(d->out, "    friction: %.3g\n", chance(d, 0.3) ? 0 : decades(d, 0.05, 5));
    if (chance(d, 0.4))
        fprintf(d->out, "    restitution: %.2g\n", chance(d, 0.3) ? 1 : between(d, 0, 1));
    if (chance(d, 0.25))
        fprintf(d->out, "    form: %s\n",
                is(d, "muller")  ? "heavy"
                : is(d, "wcsph") ? "generalised"
                                 : ONE_OF(d, "generalised"));
}

void write_bodies(draft *d, const places *taken, int first)
{
    const int wanted = d->fitted ? 0 : 1 + (int)(draft_next(d) % MOST_BODIES);
    places bodies = {.count = 0};
    for (int i = 0; i < wanted; ++i) {
        const char *shape = ONE_OF(d, "circle", "box", "polygon", "star");
        const double room = 0.25 * fmin(d->width, d->height);
        body b = {.half = fmin(room, fmax(2.5 * d->spacing, room * between(d, 0.1, 1)))};
        const double ratio = shape[0] == 'c' ? 1 : decades(d, 0.6, 1.6);
        b.at.half_x = b.half * ratio;
        b.at.half_y = b.half / ratio;
        if (!find_room(d, taken, first, &bodies, &b.at))
            continue;
        if (bodies.count == 0)
            fputs("bodies:\n", d->out);
        bodies.items[bodies.count++] = b.at;
        const double area = write_outline(d, &b.at, shape);
        fprintf(d->out, "    name: body%d\n", bodies.count);
        write_mass(d, &b, area);
        write_hold(d, &b);
        write_start(d, &b);
        write_springs(d, &b);
        write_surface(d);
    }
}

void write_tank(draft *d)
{
    if (d->fitted || d->free || d->periodic_x || d->periodic_y || !chance(d, 0.2))
        return;
    const double speed = between(d, 0.1, 0.5) * sqrt(fmax(d->gravity, 0.1) * d->height);
    const double reach = d->width * decades(d, 0.01, 0.2), frequency = speed / (2 * pi * reach);
    fprintf(d->out, "motion: {frequency: %.3g, amplitude: [%.3g, %.3g]", frequency, reach * between(d, -1, 1),
            chance(d, 0.3) ? reach * between(d, -1, 1) : 0);
    if (chance(d, 0.4))
        fprintf(d->out, ", angle: %.3g", between(d, -0.3, 0.3) * reach / d->width);
    if (chance(d, 0.5))
        fputs(", phase: -1.5708", d->out);
    if (chance(d, 0.3))
        fprintf(d->out, ", ramp: %.3g", between(d, 0.2, 2) / frequency);
    fputs("}\n", d->out);
    d->speed = fmax(d->speed, speed);
}
