/* SPDX-License-Identifier: MIT */
/** @file hash.h
 *  FNV-1a (Fowler, Noll & Vo) with 64 bits: finds damage, and makes a file's name of a long key. */
#ifndef SPH2D_STUDY_HASH_H
#define SPH2D_STUDY_HASH_H

#include <stddef.h>
#include <stdint.h>

#define SPH2D__HASH_START UINT64_C(0xcbf29ce484222325)

/** The hash of more bytes behind those of `hash`. */
static inline uint64_t sph2d__hash(uint64_t hash, const void *bytes, size_t count)
{
    const unsigned char *c = bytes;
    for (size_t i = 0; i < count; ++i)
        hash = (hash ^ c[i]) * UINT64_C(0x100000001b3);
    return hash;
}

#endif
