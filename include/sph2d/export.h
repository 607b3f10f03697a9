/* SPDX-License-Identifier: MIT */
/** @file export.h
 *  Marks what the shared libraries export; everything else is hidden. Programs need not include it: the other headers
 *  do. */
#ifndef SPH2D_EXPORT_H
#define SPH2D_EXPORT_H

#if defined(__GNUC__)
#define SPH2D_API __attribute__((visibility("default")))
#else
#define SPH2D_API
#endif

#endif
