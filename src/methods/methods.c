/* SPDX-License-Identifier: MIT */
/** @file methods.c
 *  The table of methods. */
#include "methods/common/method.h"
#include "methods/fitted/fitted.h"
#include "methods/muller/muller.h"
#include "methods/projection/constraint.h"
#include "methods/projection/pcisph.h"
#include "methods/wcsph/wcsph.h"

static const sph2d__method *const methods[][2] = {
    [SPH2D_METHOD_MULLER] = {&sph2d__muller},
    [SPH2D_METHOD_WCSPH] =
        {[SPH2D_OPERATORS_SYMMETRIC] = &sph2d__wcsph, [SPH2D_OPERATORS_FITTED] = &sph2d__wcsph_fitted},
    [SPH2D_METHOD_PCISPH] = {&sph2d__pcisph},
    [SPH2D_METHOD_CONSTRAINT] = {&sph2d__constraint},
};

const sph2d__method *sph2d__method_find(const sph2d_method_options *options)
{
    const sph2d__method *method = methods[options->name][options->operators];
    return method ? method : methods[options->name][0];
}
