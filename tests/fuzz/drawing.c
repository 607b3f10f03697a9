/* SPDX-License-Identifier: MIT */
/** @file drawing.c
 *  A drawing in SVG of which a scene takes an outline, `a`: read and checked. */
#include <stdlib.h>

#include <sph2d/io.h>

#include "fuzz.h"
#include "input_file.h"

static const char scene_text[] = "domain: {min: [0, 0], max: [2, 1]}\n"
                                 "spacing: 0.1\n"
                                 "blocks: [{box: {min: [0, 0], max: [1, 0.5]}}]\n"
                                 "obstacles: [{svg: drawing.svg#a}]\n";

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    input_file_write("drawing.svg", data, size, "", 0);
    input_file_write("scene.yaml", scene_text, sizeof scene_text - 1, "", 0);
    sph2d_report report = {0};
    sph2d_scene_file *file = NULL;
    sph2d_status status = sph2d_scene_file_read("scene.yaml", NULL, 0, &file, &report);
    if (status != SPH2D_OK && report.errors == 0)
        abort(); /* refused without a word */
    sph2d_scene_file_destroy(file);
    return 0;
}
