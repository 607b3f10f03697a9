/* SPDX-License-Identifier: MIT */
/** @file kernels.c
 *  Finds a program. */
#include "device/kernels.h"

#include <string.h>

const char *sph2d__kernels_of(const char *program)
{
    for (const sph2d__program *p = sph2d__programs; p->name; ++p)
        if (strcmp(p->name, program) == 0)
            return p->text;
    return "";
}
