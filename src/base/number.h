/* SPDX-License-Identifier: MIT */
/** @file number.h
 *  Numbers in files: decimal, with a point in any locale, without a unit. The C locale is set for the calling thread only,
 *  while it is inside this library, and never for the process. */
#ifndef SPH2D_BASE_NUMBER_H
#define SPH2D_BASE_NUMBER_H

#include <locale.h>
#include <stdbool.h>
#include <stdint.h>

/* ---- the C locale ------------------------------------------------------------------------------------------------ */

typedef struct sph2d__c_locale {
    locale_t c_locale, before;
} sph2d__c_locale;

/** False when memory is short; then there is nothing to end. */
static inline bool sph2d__c_locale_begin(sph2d__c_locale *scope)
{
    scope->c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (scope->c_locale == (locale_t)0)
        return false;
    scope->before = uselocale(scope->c_locale);
    return true;
}

static inline void sph2d__c_locale_end(sph2d__c_locale *scope)
{
    uselocale(scope->before);
    freelocale(scope->c_locale);
}

/* ---- numbers ----------------------------------------------------------------------------------------------------- */

typedef enum sph2d__number {
    SPH2D__NUMBER_OK,
    SPH2D__NUMBER_NONE,       /**< no number, or followed by other text */
    SPH2D__NUMBER_NOT_FINITE, /**< NaN or infinity, in any of its spellings */
    SPH2D__NUMBER_RANGE       /**< a number that the type cannot hold */
} sph2d__number;

/** Reads all of `text` as a double. The thread must be in the C locale. */
sph2d__number sph2d__number_real(const char *text, double *value);

/** Reads all of `text` as a non-negative integer. */
sph2d__number sph2d__number_count(const char *text, uint64_t *value);

#endif
