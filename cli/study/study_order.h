/* SPDX-License-Identifier: MIT */
/** @file study_order.h
 *  Orders of convergence: how fast errors fall along the key that is refined. */
#ifndef SPH2D_CLI_STUDY_ORDER_H
#define SPH2D_CLI_STUDY_ORDER_H

#include "study.h"

/** Fills in the orders of all rows, each from the nearest coarser row before it with the same settings; among rows that
 *  are written one by one, else from the nearest that sets the same keys. */
void study_order_all(cli_study *s);

/** What the study's `along` key is in a row: its spacing, or the number that it sets; NaN where it sets none. */
double study_order_along(const cli_study *s, const study_row *row);

/** Whether two rows differ in nothing but the `along` key. */
bool study_order_belong(const cli_study *s, const study_row *a, const study_row *b);

/** The order that the errors of rows show which belong to `row`: the slope of log(error) over log(along), by least
 *  squares. *count is how many rows that are; NaN below two values. */
double study_order_fit(const cli_study *s, const study_row *row, size_t *count);

#endif
