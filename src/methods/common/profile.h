/* SPDX-License-Identifier: MIT */
/** @file profile.h
 *  Clocks of the phases of a step. A phase lasts until another one is entered; with the clocks off, entering costs one
 *  comparison. */
#ifndef SPH2D_METHODS_COMMON_PROFILE_H
#define SPH2D_METHODS_COMMON_PROFILE_H

#include "sph2d/sim.h"

typedef struct sph2d__profile {
    bool on;
    sph2d_phase phase; /**< SPH2D_PHASE_COUNT between steps */
    double wall, cpu;  /**< clock readings when it was entered [s] */
    sph2d_profile sums;
} sph2d__profile;

void sph2d__profile_switch(sph2d__profile *profile, sph2d_phase phase);

/** Enters a phase; returns the previous one, so that it can be entered again. SPH2D_PHASE_COUNT stops the clocks. */
static inline sph2d_phase sph2d__profile_enter(sph2d__profile *profile, sph2d_phase phase)
{
    sph2d_phase left = profile->phase;
    if (profile->on && phase != left)
        sph2d__profile_switch(profile, phase);
    return left;
}

#endif
