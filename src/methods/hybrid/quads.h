/* SPDX-License-Identifier: MIT */
/** @file quads.h
 *  Four and eight floats that are read together; on a device: src/device/clc/methods/hybrid/quads.h. */
#ifndef SPH2D_METHODS_HYBRID_QUADS_H
#define SPH2D_METHODS_HYBRID_QUADS_H

typedef float sph2d__quad __attribute__((vector_size(16)));
typedef float sph2d__oct __attribute__((vector_size(32)));

#define SPH2D__QUAD(a, b, c, d) ((sph2d__quad){a, b, c, d})
#define SPH2D__OCT(a, b, c, d, e, f, g, h) ((sph2d__oct){a, b, c, d, e, f, g, h})

/** Float n of four, a number from 0 to 3. */
#define SPH2D__PART(quad, n) ((quad)[n])

#endif
