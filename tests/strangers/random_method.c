/* SPDX-License-Identifier: MIT */
/* Random numbers, and the method of a random scene with what depends on it. */
#include <math.h>
#include <string.h>

#include "draft.h"

/* SplitMix64 (Steele, Lea & Flood 2014). */
uint64_t draft_next(draft *d)
{
    uint64_t z = d->random += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double between(draft *d, double low, double high)
{
    return low + (high - low) * (double)(draft_next(d) >> 11) * 0x1p-53;
}

/** Evenly spread over decades. */
double decades(draft *d, double low, double high)
{
    return pow(10, between(d, log10(low), log10(high)));
}

bool chance(draft *d, double p)
{
    return between(d, 0, 1) < p;
}

const char *one_of(draft *d, const char *const *names, unsigned count)
{
    return names[draft_next(d) % count];
}

bool is(const draft *d, const char *method)
{
    return strcmp(d->method, method) == 0;
}

/** Mostly the one that is not the default. */
static const char *kernel_of(draft *d)
{
    return draft_next(d) % 5 == 0 ? "wendland_c2" : "wendland_c4";
}

static void write_wcsph(draft *d)
{
    d->fitted = !d->opened && (d->full ? chance(d, 0.6) : chance(d, 0.02));
    if (d->fitted) {
        fputs(", operators: fitted", d->out);
        (void)draft_next(d); /* unused: what follows is drawn as it always was */
        if (chance(d, 0.2))
            fprintf(d->out, ", density_diffusion: %.2g", between(d, 0.02, 0.3));
        if (chance(d, 0.2))
            fprintf(d->out, ", shifting: %s", ONE_OF(d, "0.5", "2"));
    } else if (chance(d, 0.35)) {
        fprintf(d->out, ", kernel: %s", kernel_of(d));
    }
}

static void write_solver(draft *d)
{
    if (chance(d, 0.3))
        fprintf(d->out, ", kernel: %s", kernel_of(d));
    if (chance(d, 0.2))
        fprintf(d->out, ", max_iterations: %s", ONE_OF(d, "50", "200", "3000"));
    if (!is(d, "pcisph") && chance(d, 0.15))
        fprintf(d->out, ", tolerance: %.2g", decades(d, 1e-6, 1e-2));
}

static void write_hybrid(draft *d)
{
    strcpy(d->method, "hybrid");
    d->max_compression = 0.02;
    d->support = 2.4;
    d->cfl = chance(d, 0.3) ? between(d, 0.2, 0.9) : 0.9;
    fprintf(d->out, "method: {name: hybrid, cfl: %.2g}\n", d->cfl);
}

void write_method(draft *d)
{
    if (d->gridded) {
        write_hybrid(d);
        return;
    }
    const bool named = (!chance(d, 0.15) && !(d->opened && chance(d, 0.5))) || d->thick;
    snprintf(d->method, sizeof d->method, "%s",
             d->opened                   ? "wcsph"
             : d->thick                  ? "constraint"
             : !named                    ? d->bodied ? "wcsph" : "muller"
             : d->full && chance(d, 0.7) ? "wcsph"
                                         : ONE_OF(d, "muller", "wcsph", "wcsph", "pcisph", "constraint"));
    const bool soft = is(d, "muller");
    d->max_compression = soft ? 0.1 : 0.01;
    d->support = soft ? 2 : is(d, "wcsph") ? 3 : 2.4;
    d->cfl = soft ? 0.4 : is(d, "wcsph") ? 0.2 : 0.4 / d->support;
    if (!named) /* scenes without bodies are as old as another default */
        return;
    fprintf(d->out, "method: {name: %s", d->method);
    if (is(d, "wcsph"))
        write_wcsph(d);
    else if (!soft)
        write_solver(d);
    if (chance(d, 0.3))
        fprintf(d->out, ", max_compression: %.2g",
                d->max_compression = soft ? decades(d, 0.02, 0.3) : decades(d, 0.003, 0.1));
    if (chance(d, 0.25))
        fprintf(d->out, ", support_ratio: %.2g", d->support = is(d, "wcsph") ? between(d, 2.4, 4) : between(d, 1.6, 3));
    if (chance(d, 0.15))
        fprintf(d->out, ", cfl: %.2g", d->cfl = between(d, 0.08, is(d, "wcsph") && !d->fitted ? 0.25 : 0.3));
    fputs("}\n", d->out);
}

void write_walls(draft *d)
{
    const bool soft = is(d, "muller");
    d->layered = !soft;
    if (d->gridded)
        return;
    if (d->thick && chance(d, 0.6)) {
        fputs("wall_slip: none\n", d->out);
        return;
    }
    if (chance(d, 0.2)) {
        const char *form = soft              ? ONE_OF(d, "spring", "heavy")
                           : is(d, "pcisph") ? ONE_OF(d, "generalised")
                                             : "generalised";
        fprintf(d->out, "walls: %s\n", form);
        if (soft && form[0] == 's' && chance(d, 0.5))
            fprintf(d->out, "wall_damping: %.2g\n", between(d, 0, 1));
    }
    if (is(d, "wcsph") && chance(d, 0.25)) {
        draft aside = *d; /* a choice that moves no other */
        bool smooth = !d->fitted && draft_next(&aside) & 1;
        fputs(smooth ? "wall_slip: smooth\n" : "wall_slip: none\n", d->out);
        if (smooth && draft_next(&aside) & 1)
            fprintf(d->out, "slip_length: %.2g\n", decades(&aside, 1e-5, 0.1));
        if (chance(d, 0.3) && !d->periodic_y)
            fprintf(d->out, "wall_speeds: {bottom: %.3g}\n", d->speed = between(d, 0.2, 1) * sqrt(d->fall * 9.81));
    }
    draft aside = *d;
    if (is(d, "wcsph") && !d->fitted && !d->open[0] && !d->periodic_x && chance(&aside, 0.3))
        fprintf(d->out, "side_slip: {left: %s}\n", ONE_OF(&aside, "free", "none", "smooth"));
}
