/* SPDX-License-Identifier: MIT */
/** @file methods.c
 *  The table of methods. */
#include "methods/common/method.h"
#include "methods/fitted/fitted.h"
#include "methods/muller/muller.h"
#include "methods/projection/constraint.h"
#include "methods/projection/pcisph.h"
#include "methods/wcsph/wcsph.h"

const sph2d__method *sph2d__method_find(const sph2d_method_options *options)
{
    if (options->name == SPH2D_METHOD_MULLER)
        return &sph2d__muller;
    if (options->name == SPH2D_METHOD_PCISPH)
        return &sph2d__pcisph;
    if (options->name == SPH2D_METHOD_CONSTRAINT)
        return &sph2d__constraint;
    return options->operators == SPH2D_OPERATORS_FITTED ? &sph2d__wcsph_fitted : &sph2d__wcsph;
}
