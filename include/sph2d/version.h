/* SPDX-License-Identifier: MIT */
/** @file version.h
 *  The version of the library, when a program is compiled and when it runs. While the major number is 0, a new minor
 *  number may change the ABI. */
#ifndef SPH2D_VERSION_H
#define SPH2D_VERSION_H

#include "sph2d/export.h"

/** The version that a program is compiled with, as numbers and as text. */
#define SPH2D_VERSION_MAJOR 0
#define SPH2D_VERSION_MINOR 1
#define SPH2D_VERSION_PATCH 0
#define SPH2D_VERSION "0.1.0"

#ifdef __cplusplus
extern "C" {
#endif

/** The version of the library that runs, "major.minor.patch", to compare with SPH2D_VERSION. Static storage. */
SPH2D_API const char *sph2d_version(void);

#ifdef __cplusplus
}
#endif
#endif
