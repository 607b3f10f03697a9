/* SPDX-License-Identifier: MIT */
/** @file c_locale.h
 *  Numbers in files have a point, whatever the program's locale says. The C locale is switched on for the calling
 *  thread alone while it is inside this library, and never for the process. */
#ifndef SPH2D_BASE_C_LOCALE_H
#define SPH2D_BASE_C_LOCALE_H

#include <locale.h>
#include <stdbool.h>

typedef struct sph2d__c_locale {
    locale_t mine, before;
} sph2d__c_locale;

/** False when memory is short; then there is nothing to end. */
static inline bool sph2d__c_locale_begin(sph2d__c_locale *scope)
{
    scope->mine = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (scope->mine == (locale_t)0)
        return false;
    scope->before = uselocale(scope->mine);
    return true;
}

static inline void sph2d__c_locale_end(sph2d__c_locale *scope)
{
    uselocale(scope->before);
    freelocale(scope->mine);
}

#endif
