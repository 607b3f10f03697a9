/* SPDX-License-Identifier: MIT */
/** @file version.c
 *  The version at run time. */
#include "sph2d/version.h"

const char *sph2d_version(void)
{
    return SPH2D_VERSION;
}
