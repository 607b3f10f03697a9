/* SPDX-License-Identifier: MIT */
/** @file export.h
 *  Marks what the shared libraries export; everything else is hidden. Programs need nothing of it: the other headers
 *  include it. */
#ifndef SPH2D_EXPORT_H
#define SPH2D_EXPORT_H

#if defined(__GNUC__)
#define SPH2D_API __attribute__((visibility("default")))
#else
#define SPH2D_API
#endif

#endif
