/* SPDX-License-Identifier: MIT */
/** @file quads.h
 *  Four and eight floats are types of OpenCL C. */
#ifndef SPH2D_METHODS_HYBRID_QUADS_H
#define SPH2D_METHODS_HYBRID_QUADS_H

typedef float4 sph2d__quad;
typedef float8 sph2d__oct;

#define SPH2D__QUAD(a, b, c, d) ((float4)(a, b, c, d))
#define SPH2D__OCT(a, b, c, d, e, f, g, h) ((float8)(a, b, c, d, e, f, g, h))
#define SPH2D__PART(quad, n) ((quad).s##n)

#endif
