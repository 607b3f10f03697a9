/* SPDX-License-Identifier: MIT */
/** @file profile.c
 *  Clocks of the phases of a step. */
#include "base/system.h"
#include "methods/common/system.h"

const char *sph2d_phase_name(sph2d_phase phase)
{
    static const char *const names[SPH2D_PHASE_COUNT] = {"move",    "sort",   "walls", "search",
                                                         "density", "forces", "solve", "bookkeeping"};
    return (unsigned)phase < SPH2D_PHASE_COUNT ? names[phase] : "unknown";
}

void sph2d__profile_switch(sph2d__profile *p, sph2d_phase phase)
{
    double wall = sph2d__wall_clock(), cpu = sph2d__cpu_clock();
    if (p->phase < SPH2D_PHASE_COUNT) {
        p->sums.wall[p->phase] += wall - p->wall;
        p->sums.cpu[p->phase] += cpu - p->cpu;
    }
    if (phase < SPH2D_PHASE_COUNT)
        ++p->sums.calls[phase];
    p->phase = phase;
    p->wall = wall;
    p->cpu = cpu;
}
