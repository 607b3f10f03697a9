/* SPDX-License-Identifier: MIT */
/** @file quads.h
 *  Four and eight floats that are read together; on a device: src/device/clc/methods/hybrid/quads.h. */
#ifndef SPH2D_METHODS_HYBRID_QUADS_H
#define SPH2D_METHODS_HYBRID_QUADS_H

typedef float sph2d__quad __attribute__((vector_size(16)));
typedef float sph2d__oct __attribute__((vector_size(32)));

#endif
