/* SPDX-License-Identifier: MIT */
/** @file math.h
 *  OpenCL C has these functions built in, for floats by the same names. */
#define sqrtf(a) sqrt((float)(a))
