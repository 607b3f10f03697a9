/* SPDX-License-Identifier: MIT */
/** @file coarse_run.c
 *  The coarse run: k times the spacing means k^2 times fewer particles and k times fewer steps; k is 1 where the scene
 *  itself takes no longer. */
#include "coarse_run.h"

#include <math.h>
#include <sph2d/contacts.h>
#include <stdlib.h>

#include "clock.h"

/* Target and maximum of its duration [s], and the minimum number of particles for a flow like the scene's. */
static const double TARGET = 0.5, LONGEST = 0.7, MIN_PARTICLES = 150;

/* Maximum coarsening, which keeps the shape of a scene. */
static const double COARSEST = 8;

/* With sources the first steps do not show the cost of later ones, so the coarse run may take longer; its own duration
 * is estimated by this time of a particle and step [s]. */
static const double TARGET_WITH_SOURCES = 0.7, LONGEST_WITH_SOURCES = 1, USUAL = 4e-7;

/* Number of its first steps, whose time is the reference for later ones. */
enum { FIRST = 50 };

#define UNKNOWN ((coarse_run){.steps = 1, .particles = 1, .cost = 1})

/** Estimated mean number of particles of a scene with sources, without losses, limited by the domain's area. */
static double mean_particles(const sph2d_scene *scene, double start)
{
    const sph2d_box d = scene->domain;
    const double area = scene->spacing * scene->spacing, until = scene->run.until;
    double fed = 0;
    for (size_t i = 0; i < scene->source_count; ++i) {
        const sph2d_source *s = &scene->sources[i];
        const double rate = s->rate > 0 ? s->rate : fmax(s->width, scene->spacing) * s->speed;
        fed += rate * fmax((s->stop > 0 ? fmin(s->stop, until) : until) - s->start, 0) / area;
    }
    return fmin(start + fed / 2, (d.max.x - d.min.x) * (d.max.y - d.min.y) / area);
}

/** The factor of the spacing; 1 for scenes of few particles, or of single ones, which have no coarser form. `steps` and
 *  `seconds` are expected from the scene's first steps. */
static double choose_coarsening(const sph2d_scene *scene, double steps, double seconds, double particles)
{
    if (scene->particles.count > 0)
        return 1;
    if (scene->source_count > 0) {
        seconds = steps * mean_particles(scene, particles) * USUAL;
        return fmin(fmax(cbrt(seconds / TARGET_WITH_SOURCES), 1), COARSEST);
    }
    return fmax(fmin(fmin(cbrt(seconds / TARGET), COARSEST), sqrt(particles / MIN_PARTICLES)), 1);
}

sph2d_block *coarse_scene(sph2d_scene *scene, double k)
{
    sph2d_block *blocks = malloc((scene->block_count + 1) * sizeof *blocks);
    if (!blocks)
        return NULL;
    for (size_t i = 0; i < scene->block_count; ++i) {
        blocks[i] = scene->blocks[i];
        blocks[i].spacing *= k;
    }
    scene->blocks = blocks;
    scene->spacing *= k;
    return blocks;
}

/** Sums for a linear fit of the time of steps over their number of particles. */
typedef struct line_fit {
    double steps, n, nn, t, nt;
} line_fit;

static void fit_add(line_fit *f, double n, double t)
{
    f->steps += 1;
    f->n += n;
    f->nn += n * n;
    f->t += t;
    f->nt += n * t;
}

/** Fits the time of a step: a constant, and a part per particle. If the number of particles hardly changes, all of it
 *  is attributed to the particles. */
static void fit_end(const line_fit *f, double *of_step, double *of_particle)
{
    const double spread = f->steps * f->nn - f->n * f->n;
    *of_particle = spread > 0.01 * f->n * f->n ? (f->steps * f->nt - f->n * f->t) / spread : 0;
    *of_step = f->steps > 0 ? (f->t - *of_particle * f->n) / f->steps : 0;
    if (*of_particle > 0 && *of_step >= 0)
        return;
    *of_particle = f->n > 0 ? f->t / f->n : 0;
    *of_step = 0;
}

/** The mean number of particles in the rest of the run, `left`, from the gain or loss per second of what was run. A loss
 *  is not taken to go on for longer than it was seen: a splash that throws out a few in a millionth of the run would
 *  leave nothing to compute. */
static double mean_of_rest(double end, double gain, double seen, double left)
{
    const double lasts = gain < 0 ? fmin(seen, left) : left;
    return left > 0 ? fmax(end + gain * lasts * (1 - lasts / (2 * left)), 0) : end;
}

static coarse_run run_coarse(sph2d_sim *sim, double until, double longest)
{
    const double begun = clock_cpu(), first_step = sph2d_sim_plan(sim)->time_step;
    double start = (double)sph2d_sim_count(sim), before = begun, count_time = 0;
    double first_cost = 0;
    line_fit fit = {0};
    sph2d_report report = {0};
    sph2d_status status = SPH2D_OK;
    while (status == SPH2D_OK && sph2d_sim_time(sim) < until && before - begun < longest) {
        const double time = sph2d_sim_time(sim);
        status = sph2d_sim_step(sim, &report);
        const double now = clock_cpu(), n = (double)sph2d_sim_count(sim);
        fit_add(&fit, n, now - before);
        count_time += n * (sph2d_sim_time(sim) - time);
        before = now;
        if (sph2d_sim_steps(sim) == FIRST && fit.n > 0)
            first_cost = (now - begun) / fit.n;
    }
    sph2d_report_clear(&report);
    const double steps = (double)sph2d_sim_steps(sim), time = sph2d_sim_time(sim);
    if (!(steps > 0 && time > 0 && before > begun && fit.n > 0))
        return UNKNOWN;
    const double end = (double)sph2d_sim_count(sim), left = fmax(until - time, 0);
    const double mean = (count_time + left * mean_of_rest(end, (end - start) / time, time, left)) / (time + left);
    const double cost = (before - begun) / fit.n;
    coarse_run run = {.steps = steps * first_step / time,
                      .particles = start > 0 ? mean / start : 1,
                      .cost = start > 0 && first_cost > 0 ? cost / first_cost : 1,
                      .mean = mean};
    fit_end(&fit, &run.cpu_of_step, &run.cpu_of_particle);
    return run;
}

coarse_run coarse_run_estimate(const sph2d_scene *scene, double steps, double seconds, double particles)
{
    coarse_run run = UNKNOWN;
    const double k = choose_coarsening(scene, steps, seconds, particles);
    sph2d_scene coarse = *scene;
    sph2d_block *blocks = coarse_scene(&coarse, k);
    if (!blocks)
        return run;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    sph2d_sim *sim = NULL;
    sph2d_report report = {0};
    sph2d_status status = sph2d_sim_create(&coarse, &options, &sim, &report);
    sph2d_contacts_attach(sim);
    if (status == SPH2D_OK)
        run = run_coarse(sim, coarse.run.until, scene->source_count > 0 ? LONGEST_WITH_SOURCES : LONGEST);
    run.mean *= k * k;
    sph2d_sim_destroy(sim);
    sph2d_report_clear(&report);
    free(blocks);
    return run;
}
