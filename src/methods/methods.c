/* SPDX-License-Identifier: MIT */
/** @file methods.c
 *  The table of methods. */
#include "methods/common/method.h"

#define ROW(name, word) [SPH2D_METHOD_##name] = &sph2d__##word,
static const sph2d__method *const methods[] = {SPH2D_METHOD_MAP(ROW)};

const sph2d__method *sph2d__method_find(const sph2d_method_options *options)
{
    if (options->name == SPH2D_METHOD_WCSPH && options->operators == SPH2D_OPERATORS_FITTED)
        return &sph2d__wcsph_fitted;
    return methods[options->name];
}
