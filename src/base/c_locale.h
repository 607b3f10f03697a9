/* SPDX-License-Identifier: MIT */
/** @file c_locale.h
 *  The C locale, so that numbers in files have a decimal point in any locale. It is set for the calling thread only,
 *  while it is inside this library, and never for the process. */
#ifndef SPH2D_BASE_C_LOCALE_H
#define SPH2D_BASE_C_LOCALE_H

#include <locale.h>
#include <stdbool.h>

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

#endif
