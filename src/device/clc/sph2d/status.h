/* SPDX-License-Identifier: MIT */
/** @file status.h
 *  Reports are the host's: names for what functions are declared with. */
#ifndef SPH2D_STATUS_H
#define SPH2D_STATUS_H

#include <stddef.h>

#include "sph2d/export.h"

typedef int sph2d_status;
typedef struct sph2d_report sph2d_report;

#endif
