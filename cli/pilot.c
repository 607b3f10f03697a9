/* SPDX-License-Identifier: MIT */
/** @file pilot.c
 *  The run with larger particles: with k times the spacing it has k^2 times fewer particles and k times fewer steps. */
#include "pilot.h"

#include <math.h>
#include <stdlib.h>

#include "clock.h"

/* What it may take, and the fewest particles that still flow like the scene's. */
static const double WANTED = 0.7, LONGEST = 1.5, FEWEST = 150;

/* Coarser than this, nothing is left of a scene; less, and nothing is gained. */
static const double COARSEST = 8, FINEST = 1.4;

/* With sources the start tells nothing of what comes. */
static const double SOURCES = 4;

/* The steps whose time the scene's own first ones are compared with. */
enum { FIRST = 50 };

#define NOTHING_KNOWN ((cli_pilot){.steps = 1, .particles = 1, .cost = 1})

/** How much coarser, or 0 where that is of no use. */
static double choose_coarsening(const sph2d_scene *scene, double seconds, double particles)
{
    if (scene->particles.count > 0)
        return 0;
    double k = fmin(fmax(cbrt(seconds / WANTED), FINEST), COARSEST);
    if (scene->source_count > 0)
        return fmax(k, SOURCES);
    return k * k * FEWEST > particles ? sqrt(particles / FEWEST) : k;
}

/** The scene with larger particles. The blocks are copies that the caller frees; NULL without memory. */
static sph2d_block *coarsen(sph2d_scene *scene, double k)
{
    sph2d_block *blocks = malloc((scene->block_count + 1) * sizeof *blocks);
    if (blocks == NULL)
        return NULL;
    for (size_t i = 0; i < scene->block_count; ++i) {
        blocks[i] = scene->blocks[i];
        blocks[i].spacing *= k;
    }
    scene->blocks = blocks;
    scene->spacing *= k;
    return blocks;
}

static cli_pilot follow(sph2d_sim *sim, double until)
{
    const double begun = clock_cpu(), first_step = sph2d_sim_time_step(sim);
    double start = (double)sph2d_sim_fluid(sim).count, particle_steps = 0;
    double first_cost = 0;
    sph2d_report report = {0};
    sph2d_status status = SPH2D_OK;
    while (status == SPH2D_OK && sph2d_sim_time(sim) < until && clock_cpu() - begun < LONGEST) {
        status = sph2d_sim_step(sim, &report);
        particle_steps += (double)sph2d_sim_fluid(sim).count;
        if (sph2d_sim_steps(sim) == FIRST && particle_steps > 0)
            first_cost = (clock_cpu() - begun) / particle_steps;
    }
    sph2d_report_clear(&report);
    const double steps = (double)sph2d_sim_steps(sim), time = sph2d_sim_time(sim);
    const double cost = particle_steps > 0 ? (clock_cpu() - begun) / particle_steps : 0;
    if (!(steps > 0 && time > 0 && cost > 0))
        return NOTHING_KNOWN;
    return (cli_pilot){.steps = steps * first_step / time,
                       .particles = start > 0 ? particle_steps / steps / start : 1,
                       .cost = start > 0 && first_cost > 0 ? cost / first_cost : 1,
                       .cpu_of_particle = cost,
                       .mean = particle_steps / steps};
}

cli_pilot pilot_run(const sph2d_scene *scene, double seconds, double particles)
{
    cli_pilot pilot = NOTHING_KNOWN;
    const double k = choose_coarsening(scene, seconds, particles);
    if (!(k >= FINEST))
        return pilot;
    sph2d_scene coarse = *scene;
    sph2d_block *blocks = coarsen(&coarse, k);
    if (blocks == NULL)
        return pilot;
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    sph2d_sim *sim = NULL;
    sph2d_report report = {0};
    if (sph2d_sim_create(&coarse, &options, &sim, &report) == SPH2D_OK)
        pilot = follow(sim, coarse.run.until);
    pilot.mean *= k * k;
    sph2d_sim_destroy(sim);
    sph2d_report_clear(&report);
    free(blocks);
    return pilot;
}
