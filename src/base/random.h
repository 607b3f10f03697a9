/* SPDX-License-Identifier: MIT */
/** @file random.h
 *  Bits that look random: counter-based random numbers, functions of what they are used for, so that no generator has a
 *  state to store; and a hash of bytes, which finds damage and knows again what was there before. */
#ifndef SPH2D_BASE_RANDOM_H
#define SPH2D_BASE_RANDOM_H

#include <stddef.h>
#include <stdint.h>

/** splitmix64 (Steele, Lea & Flood 2014): a random number from a counter. */
static inline uint64_t sph2d__mix(uint64_t z)
{
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/** Uniform in [-1, 1) from seed, source, row, column and component. */
static inline double sph2d__noise(uint64_t seed, uint64_t source, uint64_t row, uint64_t column, uint64_t component)
{
    uint64_t bits = sph2d__mix(sph2d__mix(sph2d__mix(seed ^ sph2d__mix(source)) ^ row) ^ (2 * column + component));
    return (double)(bits >> 11) * 0x1p-52 - 1.0;
}

/** What a hash begins with. */
#define SPH2D__HASH_START UINT64_C(0xcbf29ce484222325)

/** The hash of more bytes behind those of `hash`: FNV-1a (Fowler, Noll & Vo) with 64 bits. */
static inline uint64_t sph2d__hash(uint64_t hash, const void *bytes, size_t count)
{
    const unsigned char *c = bytes;
    for (size_t i = 0; i < count; ++i)
        hash = (hash ^ c[i]) * UINT64_C(0x100000001b3); /* NOLINT: doubles have bytes */
    return hash;
}

#endif
