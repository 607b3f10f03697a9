/* SPDX-License-Identifier: MIT */
/** @file export.h
 *  Marks what the shared libraries export; everything else is hidden, where libraries are files that can tell. And what
 *  takes a format as printf has it. Programs need not include it: the other headers do. */
#ifndef SPH2D_EXPORT_H
#define SPH2D_EXPORT_H

#if defined(__GNUC__) && !defined(_WIN32)
#define SPH2D_API __attribute__((visibility("default")))
#else
#define SPH2D_API
#endif

/** The argument `at`, numbered from 1, is a format of printf for those from `first`: that of C, also where the system's own
 *  is older. */
#if defined(__MINGW32__) && !defined(__clang__)
#define SPH2D_PRINTF(at, first) __attribute__((format(gnu_printf, at, first)))
#elif defined(__GNUC__)
#define SPH2D_PRINTF(at, first) __attribute__((format(printf, at, first)))
#else
#define SPH2D_PRINTF(at, first)
#endif

#endif
