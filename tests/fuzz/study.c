/* SPDX-License-Identifier: MIT */
/** @file study.c
 *  The text of a study: read, with the names and the places of all its rows. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <sph2d/study.h>

#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    sph2d_report report = {0};
    sph2d_study_file *file = NULL;
    if (sph2d_study_file_parse((const char *)data, size, "study.yaml", &file, &report) == SPH2D_OK) {
        const sph2d_study *study = sph2d_study_file_study(file);
        char name[200];
        for (size_t i = 0; i < study->run_count; ++i) {
            const sph2d_study_run *run = &study->runs[i];
            sph2d_study_run_name(run, "spacing", name, sizeof name);
            for (size_t k = 0; k < run->override_count; ++k) {
                sph2d_diagnostic place = {0};
                snprintf(place.path, sizeof place.path, "%s", run->places[k]);
                sph2d_study_file_locate(file, &place);
            }
        }
    } else if (report.errors == 0) {
        abort(); /* refused without a word */
    }
    sph2d_study_file_destroy(file);
    return 0;
}
