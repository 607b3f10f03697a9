/* SPDX-License-Identifier: MIT */
/** @file order.h
 *  Orders of convergence. */
#ifndef SPH2D_STUDY_ORDER_H
#define SPH2D_STUDY_ORDER_H

#include "sph2d/study_results.h"

/** Fills in the orders of all rows, each from the nearest coarser row before it with the same settings; among rows that
 *  are written one by one, else from the nearest that sets the same keys. */
void sph2d__order_all(sph2d_study_results *results);

#endif
