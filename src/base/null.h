/* SPDX-License-Identifier: MIT */
/** @file null.h
 *  The answer of public functions to NULL where the documentation does not allow it (sph2d/status.h). */
#ifndef SPH2D_BASE_NULL_H
#define SPH2D_BASE_NULL_H

#include "sph2d/status.h"

/** Reports that an argument of a public function is NULL. Returns SPH2D_INVALID. */
static inline sph2d_status sph2d__null(sph2d_report *report, const char *function, const char *argument)
{
    sph2d_diagnostic *d = sph2d_report_add(report, SPH2D_ERROR, SPH2D_CODE_GENERAL, NULL,
                                           "%s() was called with NULL for '%s'", function, argument);
    sph2d_diagnostic_hint(d, "only arguments whose description allows it may be NULL");
    return SPH2D_INVALID;
}

#endif
