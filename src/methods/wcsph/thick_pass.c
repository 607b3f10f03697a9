/* SPDX-License-Identifier: MIT */
/** @file thick_pass.c
 *  The sweeps of thick.c, compiled once for each instruction set, named by SPH2D__ISA. */
#include "methods/wcsph/thick_sweeps.h"
#include "methods/wcsph/wcsph.h"

const sph2d__thick_pass SPH2D__OF_ISA(sph2d__thick_pass) = {
    .load = thick_load, .multiply = thick_multiply, .finish = thick_finish, .push_sides = thick_sides};
