/* SPDX-License-Identifier: MIT */
/** @file wcsph_pass.c
 *  The sweeps of an acoustic step, compiled once for each instruction set, named by SPH2D__ISA. */
#include "methods/wcsph/wcsph.h"
#include "methods/wcsph/wcsph_sweeps.h"

const sph2d__wcsph_pass SPH2D__OF_ISA(sph2d__wcsph) = {.force = force, .rate = rate};
