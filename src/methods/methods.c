/* SPDX-License-Identifier: MIT */
/** @file methods.c
 *  The table of methods. */
#include "methods/method.h"
#include "methods/muller.h"

const char *sph2d__limit_name(sph2d__limit limit)
{
    static const char *const names[SPH2D__LIMIT_COUNT] = {"acoustic", "force", "viscous", "fixed"};
    return (unsigned)limit < SPH2D__LIMIT_COUNT ? names[limit] : "unknown";
}

const sph2d__method *sph2d__method_find(sph2d_method name)
{
    static const sph2d__method *const table[] = {[SPH2D_METHOD_MULLER] = &sph2d__muller};
    return table[name];
}
