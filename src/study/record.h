/* SPDX-License-Identifier: MIT */
/** @file record.h
 *  Filling the record of a row. */
#ifndef SPH2D_STUDY_RECORD_H
#define SPH2D_STUDY_RECORD_H

#include "sph2d/study_results.h"

/** Adds an empty series of `columns` values a row with room for `room` rows; NULL when memory is short. Pointers to
 *  other series become invalid. */
sph2d_study_series *sph2d__record_add(sph2d_study_record *record, size_t columns, size_t room);

/** Adds a row to a series; false when memory is short. */
bool sph2d__series_add(sph2d_study_series *series, double x, const double *values);

#endif
