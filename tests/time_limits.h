/* SPDX-License-Identifier: MIT */
/** @file time_limits.h
 *  Limits of time of the tests: of CPU time where something computes, since other jobs make it slow, by the clock only for
 *  what waits for ever. CK_TIMEOUT_MULTIPLIER, Check's own name, makes all of them so many times as long. */
#ifndef SPH2D_TESTS_TIME_LIMITS_H
#define SPH2D_TESTS_TIME_LIMITS_H

#include <stdlib.h>

#define LIMITS_HINT "CK_TIMEOUT_MULTIPLIER=5 gives five times as much"

/** How many times as long limits are, 1 at least. */
static inline unsigned limits_factor(void)
{
    const char *text = getenv("CK_TIMEOUT_MULTIPLIER");
    const long factor = text ? strtol(text, NULL, 10) : 1;
    return factor > 1 && factor < 1000 ? (unsigned)factor : 1;
}

#endif
