/* SPDX-License-Identifier: MIT */
/** @file muller_pass.c
 *  The loops of method `muller`, compiled once for each instruction set, named by SPH2D__ISA. */
#include "methods/muller/muller.h"
#include "methods/muller/muller_loops.h"

const sph2d__muller_passes SPH2D__OF_ISA(sph2d__muller_passes) = {density, pressures, wall_density, wall_pressures,
                                                                  force};
