/* SPDX-License-Identifier: MIT */
/** @file table.c
 *  The CSV file of values that liquid starts with, and of the velocity over an opening: read, checked, run for two steps. */
#include <stdlib.h>

#include <sph2d/io.h>
#include <sph2d/sim.h>

#include "fuzz.h"
#include "input_file.h"

enum { STEPS = 2 };

static const char start_text[] = "domain: {min: [0, 0], max: [1, 1]}\n"
                                 "spacing: 0.1\n"
                                 "blocks: [{box: {min: [0, 0], max: [1, 0.5]}, start: {table: table.csv}}]\n";
static const char opening_text[] = "domain: {min: [0, 0], max: [1, 1]}\n"
                                   "spacing: 0.1\n"
                                   "boundary: {top: wall}\n"
                                   "gravity: [0, 0]\n"
                                   "openings:\n"
                                   "  - {side: left, history: {file: table.csv}}\n"
                                   "  - {side: right, pressure: 0}\n";

static void try_scene(const char *text, size_t length)
{
    input_file_write("scene.yaml", text, length, "", 0);
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    sph2d_status status = sph2d_scene_file_read("scene.yaml", NULL, 0, &file, &report);
    if (status == SPH2D_OK) {
        sph2d_sim_options options = sph2d_sim_options_default();
        options.threads = 1;
        sph2d_sim *sim = NULL;
        status = sph2d_sim_create(sph2d_scene_file_scene(file), &options, &sim, &report);
        for (int i = 0; i < STEPS && status == SPH2D_OK; ++i)
            status = sph2d_sim_step(sim, &report);
        sph2d_sim_destroy(sim);
    }
    if (status != SPH2D_OK && report.errors == 0)
        abort(); /* refused without a word */
    sph2d_scene_file_destroy(file);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    input_file_write("table.csv", data, size, "", 0);
    try_scene(start_text, sizeof start_text - 1);
    try_scene(opening_text, sizeof opening_text - 1);
    return 0;
}
