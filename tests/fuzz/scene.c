/* SPDX-License-Identifier: MIT */
/** @file scene.c
 *  The text of a scene: read, checked, planned, and a small one run for two steps. */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include <sph2d/contacts.h>
#include <sph2d/io.h>
#include <sph2d/sim.h>

#include "fuzz.h"

/* A plan of more particles than LARGEST_PLAN takes seconds under a sanitizer: slow, and no finding. */
enum { MAX_PARTICLES = 3000, LARGEST_PLAN = 300000, STEPS = 2 };

/** What is written of a scene reads as a scene again. */
static void write_again(const sph2d_scene *scene)
{
    size_t size = sph2d_scene_text(scene, NULL, 0);
    char *text = malloc(size + 1);
    sph2d_scene_file *again = NULL;
    if (text) {
        sph2d_scene_text(scene, text, size + 1);
        if (sph2d_scene_file_parse(text, size, "again.yaml", NULL, 0, &again, NULL) == SPH2D_SCENE)
            abort();
    }
    sph2d_scene_file_destroy(again);
    free(text);
}

static void step(const sph2d_scene *scene)
{
    sph2d_sim_options options = sph2d_sim_options_default();
    options.threads = 1;
    sph2d_report report = {0};
    sph2d_sim *sim = NULL;
    sph2d_status status = sph2d_sim_create(scene, &options, &sim, &report);
    if (status == SPH2D_OK)
        status = sph2d_contacts_attach(sim);
    for (int i = 0; i < STEPS && status == SPH2D_OK; ++i)
        status = sph2d_sim_step(sim, &report);
    sph2d_sim_destroy(sim);
}

/** Whether the domain full of liquid would have few enough particles to plan. */
static bool is_small(const sph2d_scene *scene)
{
    double spacing = scene->spacing;
    for (size_t b = 0; b < scene->block_count; ++b)
        if (scene->blocks[b].spacing > 0)
            spacing = fmin(spacing, scene->blocks[b].spacing);
    double width = scene->domain.max.x - scene->domain.min.x, height = scene->domain.max.y - scene->domain.min.y;
    return width * height < LARGEST_PLAN * spacing * spacing;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    if (sph2d_scene_file_parse((const char *)data, size, "scene.yaml", NULL, 0, &file, &report) == SPH2D_OK) {
        const sph2d_scene *scene = sph2d_scene_file_scene(file);
        write_again(scene);
        sph2d_plan plan;
        if (is_small(scene) && sph2d_scene_plan(scene, &plan, &report) == SPH2D_OK &&
            plan.fluid_particles + plan.wall_particles < MAX_PARTICLES)
            step(scene);
    } else if (report.errors == 0) {
        abort(); /* refused without a word */
    }
    sph2d_scene_file_destroy(file);
    return 0;
}
