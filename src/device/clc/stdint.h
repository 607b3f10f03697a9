/* SPDX-License-Identifier: MIT */
/** @file stdint.h
 *  Whole numbers of C by those of OpenCL C. */
#ifndef SPH2D_CLC_STDINT_H
#define SPH2D_CLC_STDINT_H

typedef int int32_t;
typedef long int64_t;
typedef unsigned char uint8_t;
typedef unsigned int uint32_t;
typedef unsigned long uint64_t;
typedef unsigned long uintptr_t;

#define UINT32_MAX 0xffffffffu
#define UINT64_MAX 0xfffffffffffffffful
#define UINT64_C(a) a##ul
#define SIZE_MAX 0xfffffffffffffffful

#endif
