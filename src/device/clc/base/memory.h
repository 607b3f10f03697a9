/* SPDX-License-Identifier: MIT */
/** @file memory.h
 *  The host's memory, of which a device knows nothing. */
#ifndef SPH2D_BASE_MEMORY_H
#define SPH2D_BASE_MEMORY_H

#include <stdbool.h>
#include <stddef.h>

typedef struct sph2d__memory sph2d__memory;

#endif
