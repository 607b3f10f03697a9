/* SPDX-License-Identifier: MIT */
/** @file address.h
 *  Words for sources that are C and OpenCL C, too: there pointers say in which memory something is. */
#ifndef SPH2D_BASE_ADDRESS_H
#define SPH2D_BASE_ADDRESS_H

/** Before the type of an array of the simulation. */
#define SPH2D__ARRAY

/** A constant outside functions. */
#define SPH2D__FIXED static const

/** Before a function of another file, which a device has inlined. */
#define SPH2D__LINKED

/** A function that is not inlined, and may be unused. */
#define SPH2D__OUTLINE static __attribute__((noinline, unused))

#endif
