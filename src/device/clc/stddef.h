/* SPDX-License-Identifier: MIT */
/** @file stddef.h
 *  size_t is a type of OpenCL C. */
#ifndef SPH2D_CLC_STDDEF_H
#define SPH2D_CLC_STDDEF_H

#ifndef NULL
#define NULL ((void *)0)
#endif

#endif
