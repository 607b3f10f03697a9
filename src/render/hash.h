/* SPDX-License-Identifier: MIT */
/** @file hash.h
 *  A hash by which something that was drawn before is known again. */
#ifndef SPH2D_RENDER_HASH_H
#define SPH2D_RENDER_HASH_H

#include <stddef.h>
#include <stdint.h>

/** What to begin with. */
#define SPH2D__HASH_BEGIN UINT64_C(14695981039346656037)

/** Continues a hash by some bytes (FNV-1a). */
static inline uint64_t sph2d__hash(uint64_t so_far, const void *bytes, size_t size)
{
    for (size_t i = 0; i < size; ++i)
        so_far =
            (so_far ^ ((const unsigned char *)bytes)[i]) * UINT64_C(1099511628211); /* NOLINT: doubles have bytes */
    return so_far;
}

#endif
