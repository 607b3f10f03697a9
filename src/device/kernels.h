/* SPDX-License-Identifier: MIT */
/** @file kernels.h
 *  The programs of devices: the files *.cl of this folder with all that they include, as the build has put them together
 *  in gen/kernels.c. */
#ifndef SPH2D_DEVICE_KERNELS_H
#define SPH2D_DEVICE_KERNELS_H

#include <stddef.h>

typedef struct sph2d__program {
    const char *name, *text;
} sph2d__program;

/** Ends with one whose name is NULL. */
extern const sph2d__program sph2d__programs[];

/** The text of a program; "" if there is none of that name. */
const char *sph2d__kernels_of(const char *program);

#endif
