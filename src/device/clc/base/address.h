/* SPDX-License-Identifier: MIT */
/** @file address.h
 *  The words of src/base/address.h in OpenCL C. A thread has no stack worth the name: all is inlined. */
#ifndef SPH2D_BASE_ADDRESS_H
#define SPH2D_BASE_ADDRESS_H

#define SPH2D__ARRAY __global
#define SPH2D__FIXED __constant
#define SPH2D__LINKED __attribute__((always_inline))
#define SPH2D__OUTLINE static inline __attribute__((always_inline))

#endif
