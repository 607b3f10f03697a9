/* SPDX-License-Identifier: MIT */
/** @file local_correction.c
 *  Predicting all densities at once, and correcting few of them one by one. */
#include "methods/projection/local_correction.h"

#include <math.h>
#include <string.h>

#include "kernels/kernel.h"
#include "methods/common/shortest.h"

/* What is not right after so many turns, each a look at all particles and then sweeps over those in want of it, is left
 * to the next step. */
enum { TURNS = 2, SWEEPS = 6 };
/* So few of all disturb nobody who would be found by another look. */
static const double FEW = 1e-3;

/* In place of a residual where a particle has moved. Above every limit. */
static const double UNKNOWN = 1e9;

/** What does not change from particle to particle. */
typedef struct correction {
    double limit, share;
    double scale;        /**< makes a density over rest density of masses times f(q) */
    double own;          /**< mass times f(0) */
    double pressure;     /**< of a multiplier */
    double max_pressure; /**< largest pressure without corrections */
    double per_step2;    /**< acceleration for a way */
} correction;

/** The pairs of a row: those with the fluid from `first` to `fluid`, those with boundary particles from there on. */
typedef struct row {
    size_t first, fluid, walls;
} row;

static row row_of(const sph2d__neighbours *n, size_t i)
{
    const sph2d__slice *at = &n->slices[i / n->lanes];
    size_t first = at->begin + i % n->lanes, fluid = first + at->fluid * n->lanes;
    return (row){first, fluid, fluid + at->walls * n->lanes};
}

/** f(q) of particles at a distance. */
static double value_at(const sph2d__system *s, double x, double y)
{
    const sph2d__period *period = &s->fluid_cells.period;
    const sph2d__lanes none = {0};
    sph2d__lanes dx = sph2d__shortest(none + x, period->length_x), dy = sph2d__shortest(none + y, period->length_y);
    return sph2d__kernel_value(s->method.kernel, sph2d__lanes_sqrt(dx * dx + dy * dy) * (1 / s->support))[0];
}

/** Compression at particle i. */
static double compression(const sph2d__system *s, const correction *c, const row *r, size_t i)
{
    const sph2d__store *f = &s->fluid, *w = &s->walls;
    double x = f->next_x[i], y = f->next_y[i], sum = c->own;
    for (size_t k = r->first; k < r->fluid; k += s->neighbours.lanes) {
        uint32_t j = s->neighbours.index[k];
        sum += s->mass * value_at(s, x - f->next_x[j], y - f->next_y[j]);
    }
    for (size_t k = r->fluid; k < r->walls; k += s->neighbours.lanes) {
        uint32_t b = s->neighbours.index[k];
        sum += w->mass[b] * value_at(s, x - w->x[b] - s->step * w->vx[b], y - w->y[b] - s->step * w->vy[b]);
    }
    return c->scale * sum - 1;
}

/** Moves particle i where it will be, by acceleration: it will want a look. */
static void move(sph2d__system *s, const correction *c, size_t i, double x, double y)
{
    sph2d__store *f = &s->fluid;
    f->next_x[i] += x;
    f->next_y[i] += y;
    f->ax[i] += c->per_step2 * x;
    f->ay[i] += c->per_step2 * y;
    f->residual[i] = UNKNOWN;
}

/** Adds to the multiplier of particle i, with what it pushes. */
static void push(sph2d__system *s, const correction *c, const row *r, size_t i, double more)
{
    sph2d__store *f = &s->fluid;
    double x = 0, y = 0;
    for (size_t k = r->first; k < r->walls; k += s->neighbours.lanes) {
        float gradient[2];
        memcpy(gradient, &s->neighbours.gradient[k], sizeof gradient);
        double px = more * gradient[0], py = more * gradient[1];
        x -= px;
        y -= py;
        if (k < r->fluid)
            move(s, c, s->neighbours.index[k], px, py);
    }
    move(s, c, i, x, y);
    f->multiplier[i] += more;
    f->acting_pressure[i] =
        fmin(f->acting_pressure[i] + c->pressure * more, fmax(f->acting_pressure[i], c->max_pressure));
}

/** Looks at the particles that want it. True when none was corrected. */
static bool sweep(sph2d__system *s, const correction *c)
{
    sph2d__store *f = &s->fluid;
    bool done = true;
    for (size_t i = 0; i < f->count; ++i) {
        if (!(f->residual[i] > c->limit))
            continue;
        row r = row_of(&s->neighbours, i);
        double explained = c->share * f->multiplier[i], left = f->residual[i] = compression(s, c, &r, i);
        if (!(left > c->limit && left > explained))
            continue;
        push(s, c, &r, i, (left - fmax(explained, c->limit / 2)) * fabs(f->diagonal[i]));
        done = false;
    }
    return done;
}

/** Where particles will be; the largest pressure. */
static void step_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    sph2d__store *f = slab->rows;
    double dt = s->step;
    (void)with;
    for (size_t i = slab->first; i < slab->last; ++i) {
        sum->most = f->acting_pressure[i] > sum->most ? f->acting_pressure[i] : sum->most;
        f->next_x[i] = f->x[i] + dt * (f->vx[i] + dt * f->ax[i]);
        f->next_y[i] = f->y[i] + dt * (f->vy[i] + dt * f->ay[i]);
    }
}

/** Predicts the densities of a slab; counts those to correct. */
static void look_slab(sph2d__system *s, const sph2d__slab *slab, const void *with, sph2d__slab_sum *sum)
{
    const double *limit = with;
    sph2d__projection_predict(s, slab);
    for (size_t i = slab->first; i < slab->last; ++i)
        sum->first += slab->rows->residual[i] > *limit;
}

void sph2d__stragglers_correct(sph2d__system *s, double limit, double share)
{
    if (s->fluid.count == 0)
        return;
    double h2 = s->support * s->support;
    correction c = {.limit = limit,
                    .share = share,
                    .scale = s->calibration * sph2d__kernel_constant(s->method.kernel) / (h2 * s->rest_density),
                    .own = s->mass * sph2d__kernel_value_at(s->method.kernel, 0),
                    .pressure = s->moment * s->rest_density / (s->step * s->step),
                    .per_step2 = 1 / (s->step * s->step)};
    c.max_pressure = sph2d__over_fluid(s, step_slab, NULL).most;
    s->fluid.next_x[s->fluid.count] = s->fluid.next_y[s->fluid.count] = 1e30;
    double found = INFINITY;
    for (int turn = 0; turn < TURNS && found > FEW * (double)s->fluid.count; ++turn) {
        found = sph2d__over_fluid(s, look_slab, &limit).first;
        for (int k = 0; k < SWEEPS && found > 0 && !sweep(s, &c); ++k)
            ;
    }
}
