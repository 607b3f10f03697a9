/* SPDX-License-Identifier: MIT */
/** @file particles.c
 *  The CSV file of a scene's particles: read, checked, and a few of them run for two steps. */
#include <stdlib.h>
#include <string.h>

#include <sph2d/io.h>
#include <sph2d/sim.h>

#include "fuzz.h"
#include "input_file.h"

enum { MAX_PARTICLES = 3000, STEPS = 2 };

static const char scene_text[] = "domain: {min: [0, 0], max: [1, 1]}\n"
                                 "spacing: 0.05\n"
                                 "particles: particles.csv\n"
                                 "method: {name: wcsph, sound_speed: 20}\n";

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    input_file_write("particles.csv", data, size, "", 0);
    input_file_write("scene.yaml", scene_text, sizeof scene_text - 1, "", 0);
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    sph2d_status status = sph2d_scene_file_read("scene.yaml", NULL, 0, &file, &report);
    if (status != SPH2D_OK && report.errors == 0)
        abort(); /* refused without a word */
    if (status == SPH2D_OK && sph2d_scene_file_scene(file)->particles.count < MAX_PARTICLES) {
        sph2d_sim_options options = sph2d_sim_options_default();
        options.threads = 1;
        sph2d_sim *sim = NULL;
        status = sph2d_sim_create(sph2d_scene_file_scene(file), &options, &sim, &report);
        for (int i = 0; i < STEPS && status == SPH2D_OK; ++i)
            status = sph2d_sim_step(sim, &report);
        sph2d_sim_destroy(sim);
    }
    sph2d_scene_file_destroy(file);
    return 0;
}
