/* SPDX-License-Identifier: MIT */
/** @file isa.h
 *  The instruction sets that pair loops are compiled for. */
#ifndef SPH2D_SIMD_ISA_H
#define SPH2D_SIMD_ISA_H

#include "sph2d/sim.h"

/** The set to use for a wish: `auto` becomes the widest that is there; one that is not there becomes auto (0). */
sph2d_isa sph2d__isa_choose(sph2d_isa wish);

#ifdef SPH2D__ISA_X86
#define SPH2D__ISA_COUNT 3
#else
#define SPH2D__ISA_COUNT 1
#endif

#endif
