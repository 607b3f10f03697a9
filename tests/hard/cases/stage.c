/* SPDX-License-Identifier: MIT */
/** @file stage.c Scenes of hard cases, their runs, and what their particles show. */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <sph2d/contacts.h>

#include "cases.h"

static const char *const method_words[METHODS] = {
    "muller", "wcsph", "wcsph, operators: fitted", "pcisph", "constraint",
};

static void out_of_memory(void)
{
    fputs("hard_cases: out of memory\n", stderr);
    exit(3);
}

static void *zeros(size_t count, size_t size)
{
    void *memory = calloc(count + 1, size);
    if (memory == NULL)
        out_of_memory();
    return memory;
}

// ---- scenes ---------------------------------------------------------------------------------------------------------

static void say_error(const stage *s, outcome *o, const char *what)
{
    char measure[160];
    snprintf(measure, sizeof measure, "%s: %.130s", what, stage_error(s));
    for (char *c = measure; *c; ++c)
        *c = *c == '|' || *c == '\n' ? ' ' : *c;
    tell(o, measure, 1, 0);
}

bool stage_read(stage *s, outcome *o, const char *options, const char *format, ...)
{
    enum { TEXT = 4000 };
    char text[TEXT];
    *s = (stage){0};
    const int head =
        snprintf(text, sizeof text, "method: {name: %s%s%s}\n", method_words[o->method], *options ? ", " : "", options);
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(text + head, sizeof text - (size_t)head, format, arguments);
    va_end(arguments);
    if (head + length >= TEXT) {
        fputs("hard_cases: the text of a scene is too long\n", stderr);
        exit(3);
    }
    s->status = sph2d_scene_file_parse(text, strlen(text), "case", NULL, 0, &s->file, &s->report);
    if (s->status != SPH2D_OK) {
        say_error(s, o, "refused");
        return false;
    }
    s->scene = *sph2d_scene_file_scene(s->file);
    return true;
}

void stage_put(stage *s, const sph2d_particle *items, size_t count)
{
    s->scene.particles.file = NULL;
    s->scene.particles.items = items;
    s->scene.particles.count = count;
}

bool stage_try(stage *s)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    options.isa = SPH2D_ISA_BASELINE;
    sph2d_report_clear(&s->report);
    s->status = sph2d_sim_create(&s->scene, &options, &s->sim, &s->report);
    sph2d_contacts_attach(s->sim);
    return s->status == SPH2D_OK;
}

bool stage_start(stage *s, outcome *o)
{
    if (stage_try(s))
        return true;
    say_error(s, o, "refused");
    stage_close(s);
    return false;
}

bool stage_run(stage *s, double time)
{
    while (s->status == SPH2D_OK && sph2d_sim_time(s->sim) < time)
        s->status = sph2d_sim_step(s->sim, &s->report);
    return s->status == SPH2D_OK;
}

bool stage_steps(stage *s, unsigned long steps)
{
    for (; steps > 0 && s->status == SPH2D_OK; --steps)
        s->status = sph2d_sim_step(s->sim, &s->report);
    return s->status == SPH2D_OK;
}

bool stage_finish(stage *s, outcome *o, double time)
{
    if (stage_run(s, time))
        return true;
    fprintf(stderr, "hard_cases: stopped: %s\n", stage_error(s));
    tell(o, "stopped by a guard", 1, 0);
    return false;
}

void stage_close(stage *s)
{
    sph2d_sim_destroy(s->sim);
    sph2d_scene_file_destroy(s->file);
    s->sim = NULL;
    s->file = NULL;
}

const char *stage_error(const stage *s)
{
    for (size_t i = 0; i < s->report.count; ++i)
        if (s->report.items[i].severity == SPH2D_ERROR)
            return s->report.items[i].message;
    return sph2d_status_text(s->status);
}

bool stage_reports(const stage *s, sph2d_code code)
{
    for (size_t i = 0; i < s->report.count; ++i)
        if (s->report.items[i].code == code)
            return true;
    return false;
}

// ---- particles ------------------------------------------------------------------------------------------------------

cloud cloud_of(const sph2d_sim *sim)
{
    const sph2d_view f = sph2d_sim_fluid(sim);
    uint64_t most = 0;
    for (size_t i = 0; i < f.count; ++i)
        most = f.id[i] > most ? f.id[i] : most;
    size_t *where = zeros(most + 1, sizeof *where);
    for (size_t i = 0; i < f.count; ++i)
        where[f.id[i]] = i + 1;
    double *all = zeros(5 * f.count, sizeof *all);
    cloud c = {.count = f.count, .x = all, .time = sph2d_sim_time(sim)};
    c.y = c.x + f.count;
    c.vx = c.y + f.count;
    c.vy = c.vx + f.count;
    c.density = c.vy + f.count;
    for (size_t id = 0, k = 0; id <= most && k < f.count; ++id)
        if (where[id] > 0) {
            const size_t i = where[id] - 1;
            c.x[k] = f.x[i];
            c.y[k] = f.y[i];
            c.vx[k] = f.vx[i];
            c.vy[k] = f.vy[i];
            c.density[k++] = f.density[i];
        }
    free(where);
    return c;
}

void cloud_free(cloud *c)
{
    free(c->x);
    *c = (cloud){0};
}

double cloud_apart(const cloud *a, const cloud *b)
{
    double most = a->count == b->count ? 0 : INFINITY;
    for (size_t i = 0; i < a->count && isfinite(most); ++i) {
        const double d = hypot(a->x[i] - b->x[i], a->y[i] - b->y[i]);
        most = d > most || isnan(d) ? d : most;
    }
    return most;
}

/** Distance to the nearest neighbour; `period` in both directions, 0 for none. */
static double nearest(const cloud *c, size_t i, double period)
{
    double least = INFINITY;
    for (size_t j = 0; j < c->count; ++j) {
        double dx = c->x[j] - c->x[i], dy = c->y[j] - c->y[i];
        if (period > 0) {
            dx -= period * round(dx / period);
            dy -= period * round(dy / period);
        }
        if (j != i)
            least = fmin(least, hypot(dx, dy));
    }
    return least;
}

double cloud_least(const cloud *c, double period)
{
    double least = INFINITY;
    for (size_t i = 0; i < c->count; ++i)
        least = fmin(least, nearest(c, i, period));
    return least;
}

double cloud_paired(const cloud *c, double period, double near)
{
    size_t paired = 0;
    for (size_t i = 0; i < c->count; ++i)
        paired += nearest(c, i, period) < near;
    return (double)paired / (double)c->count;
}

bool all_finite(const sph2d_sim *sim)
{
    const sph2d_view f = sph2d_sim_fluid(sim);
    for (size_t i = 0; i < f.count; ++i)
        if (!isfinite(f.x[i] + f.y[i] + f.vx[i] + f.vy[i] + f.ax[i] + f.ay[i] + f.density[i] + f.pressure[i]))
            return false;
    return true;
}

double speed_of(const sph2d_sim *sim)
{
    const sph2d_view f = sph2d_sim_fluid(sim);
    double most = 0;
    for (size_t i = 0; i < f.count; ++i)
        most = fmax(most, hypot(f.vx[i], f.vy[i]));
    return most;
}

double density_of(const sph2d_sim *sim)
{
    const sph2d_view f = sph2d_sim_fluid(sim);
    double most = 0;
    for (size_t i = 0; i < f.count; ++i)
        most = fmax(most, f.density[i]);
    return most / sph2d_sim_scene(sim)->fluid.density;
}

double density_rms(const sph2d_sim *sim)
{
    const sph2d_view f = sph2d_sim_fluid(sim);
    double sum = 0;
    for (size_t i = 0; i < f.count; ++i)
        sum += pow(f.density[i] / sph2d_sim_scene(sim)->fluid.density - 1, 2);
    return sqrt(sum / (double)f.count);
}

double ledger(const sph2d_sim *sim, size_t at_start)
{
    const sph2d_summary s = sph2d_sim_summary(sim);
    double left = (double)at_start + (double)s.fed - (double)s.drained - (double)sph2d_sim_fluid(sim).count;
    for (int side = 0; side < 4; ++side)
        left -= (double)s.left_open[side];
    return fabs(left);
}

double uniform(uint64_t *seed)
{
    uint64_t z = *seed += 0x9E3779B97F4A7C15u; // splitmix64
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return (double)((z ^ z >> 31) >> 11) * 0x1p-53;
}

sph2d_particle *lattice(size_t columns, size_t rows, double dx, sph2d_vec2 corner)
{
    sph2d_particle *p = zeros(columns * rows, sizeof *p);
    for (size_t k = 0; k < columns * rows; ++k)
        p[k] = (sph2d_particle){.x = corner.x + ((double)(k % columns) + 0.5) * dx,
                                .y = corner.y + ((double)(k / columns) + 0.5) * dx,
                                .density = 1000};
    return p;
}
