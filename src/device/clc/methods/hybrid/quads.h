/* SPDX-License-Identifier: MIT */
/** @file quads.h
 *  Four and eight floats are types of OpenCL C. */
#ifndef SPH2D_METHODS_HYBRID_QUADS_H
#define SPH2D_METHODS_HYBRID_QUADS_H

typedef float4 sph2d__quad;
typedef float8 sph2d__oct;

#endif
