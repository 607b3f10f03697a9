/* SPDX-License-Identifier: MIT */
/** @file hybrid_pass.c
 *  The pair loops of method `hybrid`, compiled once for each instruction set, named by SPH2D__ISA. */
#define SPH2D__MIXED
#include "methods/hybrid/hybrid.h"
#include "methods/hybrid/hybrid_pairs.h"

const sph2d__hybrid_passes SPH2D__OF_ISA(sph2d__hybrid_passes) = {density, pack, order};
