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
    const sph2d__store *f = &sim->system.fluid;
    size_t inside = f->count;
    for (size_t i = 0; i < f->count && sim->openings.count > 0; ++i)
        inside -= sph2d__opening_at(sim, f->x[i], f->y[i]) != NULL;
    values[0] = NAN;
    values[1] = sim->system.mass / sim->system.rest_density * (double)inside;
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
