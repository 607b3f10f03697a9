/* SPDX-License-Identifier: MIT */
/* Openings of a random scene: in any wall, of every kind, some of which liquid cannot meet. */
#include <math.h>

#include "draft.h"

/** A speed of the scene: that of a fall through its room, or of its liquid. */
static double speed_of(const draft *d)
{
    return fmax(d->speed, sqrt(2 * d->gravity * d->height)) + 1e-3 * d->width;
}

/** What is prescribed, as a number or over time. */
static void write_value(draft *d, const char *key, double value)
{
    if (chance(d, 0.25)) {
        const double time = d->height / speed_of(d);
        fprintf(d->out, ", history: {%s: [[0, %.4g], [%.4g, %.4g], [%.4g, %.4g]]}", key, value * between(d, 0, 1),
                time * between(d, 0.1, 1), value, time * between(d, 1.5, 3), value * between(d, 0.5, 1.2));
    } else
        fprintf(d->out, ", %s: %.4g", key, value);
}

/** A wall without an opening, mostly an upright one, or -1; now and then anything. */
static int wall_of(draft *d, bool taken[4])
{
    if (chance(d, 0.05))
        return (int)(draft_next(d) % 4);
    for (int attempt = 0; attempt < 20; ++attempt) {
        const int side = chance(d, 0.8) ? (int)(draft_next(d) % 2) : (int)(draft_next(d) % 4);
        if (!taken[side] && !d->open[side] && !(side < 2 ? d->periodic_x : d->periodic_y)) {
            taken[side] = true;
            return side;
        }
    }
    return -1;
}

static void write_opening(draft *d, int index, bool taken[4])
{
    static const char *const sides[] = {"left", "right", "bottom", "top"};
    const int side = wall_of(d, taken);
    if (side < 0)
        return;
    const bool upright = side < 2;
    const double low = upright ? d->bottom : d->left, length = upright ? d->height : d->width;
    fprintf(d->out, "  - {name: opening_%d, side: %s", index, sides[side]);
    double from = low, to = low + length;
    if (chance(d, 0.6)) {
        from = low + length * between(d, 0, 0.6);
        to = from + length * between(d, 0.1, 0.4);
        fprintf(d->out, ", from: %.4g, to: %.4g", from, to);
    }
    const double speed = speed_of(d) * between(d, -0.3, 0.6), kind = between(d, 0, 1);
    if (kind < 0.5 && !(d->full && index > 0)) {
        const bool rate = chance(d, 0.4);
        write_value(d, rate ? "flow_rate" : "velocity", rate ? speed * (to - from) : speed);
        const bool surface = upright && d->gravity > 0 && !d->full && chance(d, 0.4);
        if (surface)
            fputs(", free_surface: on", d->out);
        else if (chance(d, 0.3))
            fputs(", profile: parabola", d->out);
        if (chance(d, 0.5))
            fprintf(d->out, ", ramp: %.3g", between(d, 0.1, 1) * d->height / speed_of(d));
        d->speed = fmax(d->speed, fabs(speed));
    } else if (kind < 0.75 && d->gravity > 0)
        write_value(d, "level", from + (d->bottom + d->height - from) * between(d, 0.1, 1));
    else
        write_value(d, "pressure", d->density * speed_of(d) * speed_of(d) / 2 * between(d, -0.1, 0.6));
    fputs("}\n", d->out);
}

void write_openings(draft *d)
{
    bool taken[4] = {false};
    fputs("openings:\n", d->out);
    const int count = d->full ? 2 : 1 + (int)(draft_next(d) % 3);
    for (int i = 0; i < count; ++i)
        write_opening(d, i, taken);
}
