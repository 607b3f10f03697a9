/* SPDX-License-Identifier: MIT */
/** @file implicit_pass.c
 *  The sweeps of implicit.c, compiled once for each instruction set, named by SPH2D__ISA. */
#include "methods/wcsph/implicit_sweeps.h"
#include "methods/wcsph/wcsph.h"

const sph2d__implicit_pass SPH2D__OF_ISA(sph2d__implicit_pass) = {
    .rest = rest_some,
    .loosen = loosen_some,
    .transpose = transpose_some,
    .diverge = diverge_some,
    .multiply = multiply_some,
    .finish = finish_some,
};
