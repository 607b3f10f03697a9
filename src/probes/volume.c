/* SPDX-License-Identifier: MIT */
/** @file volume.c
 *  Probes of the liquid's area, and of its level at rest (coverage.h). */
#include <math.h>

#include "probes/coverage.h"
#include "probes/probes.h"

size_t sph2d__probe_volume(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    (void)probe;
    sph2d__coverage coverage;
    values[0] = NAN;
    values[1] = sph2d__placed_area(sim);
    if (sph2d__coverage_make(&coverage, sim)) {
        values[0] = sph2d__coverage_area(&coverage);
        sph2d__coverage_free(&coverage);
    }
    return 2;
}

size_t sph2d__probe_level(const sph2d_sim *sim, const sph2d_probe *probe, double *values)
{
    (void)probe;
    sph2d__coverage coverage;
    values[0] = NAN;
    if (sph2d__coverage_make(&coverage, sim)) {
        values[0] = sph2d__coverage_level(&coverage, sph2d__coverage_area(&coverage));
        sph2d__coverage_free(&coverage);
    }
    return 1;
}
