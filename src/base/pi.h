/* SPDX-License-Identifier: MIT */
/** @file pi.h
 *  Pi, which standard C does not define. */
#ifndef SPH2D_BASE_PI_H
#define SPH2D_BASE_PI_H

#include "base/address.h"

SPH2D__FIXED double SPH2D__PI = 3.14159265358979323846;

#endif
