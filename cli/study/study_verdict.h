/* SPDX-License-Identifier: MIT */
/** @file study_verdict.h
 *  What a wanted error costs, as a sentence. */
#ifndef SPH2D_CLI_STUDY_VERDICT_H
#define SPH2D_CLI_STUDY_VERDICT_H

#include "study.h"

/** "For an error of 1 % (speed L1) the cheapest is 'coarse': 0.14 % in 0.31 CPU s.", or what is to be said instead when
 *  no row is good enough; "" when none has an error. Returns `out`, cut at `size`. */
char *study_verdict(const cli_study *s, char *out, size_t size);

#endif
