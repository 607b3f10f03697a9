/* SPDX-License-Identifier: MIT */
/** @file h5_repair.c
 *  The parts of HDF5 files that have checksums (HDF5 File Format Specification, version 3.0): superblocks of version 2
 *  on, object headers of version 2, and their continuations. */
#include "h5_repair.h"

#include <string.h>

/* ---- the checksum: lookup3 (Jenkins 2006, public domain), of bytes ------------------------------------------------ */

static uint32_t turn(uint32_t x, int bits)
{
    return x << bits | x >> (32 - bits);
}

static uint32_t number(const uint8_t *bytes, size_t count)
{
    uint32_t x = 0;
    for (size_t i = 0; i < count && i < 4; ++i)
        x |= (uint32_t)bytes[i] << 8 * i;
    return x;
}

/** Mixes s[2], s[0] and s[1] in turn, as both parts of lookup3 do: x = (x op y) with y turned. */
static void mix(uint32_t s[3])
{
    static const int bits[6] = {4, 6, 8, 16, 19, 4};
    for (int i = 0; i < 6; ++i) {
        uint32_t *a = &s[i % 3], *b = &s[(i + 1) % 3], *c = &s[(i + 2) % 3];
        *a -= *c;
        *a ^= turn(*c, bits[i]);
        *c += *b;
    }
}

static void finish(uint32_t s[3])
{
    static const int bits[7] = {14, 11, 25, 16, 4, 14, 24};
    for (int i = 0; i < 7; ++i) {
        uint32_t *to = &s[(i + 2) % 3], *from = &s[(i + 1) % 3];
        *to ^= *from;
        *to -= turn(*from, bits[i]);
    }
}

static uint32_t lookup3(const uint8_t *bytes, size_t size)
{
    uint32_t start = 0xdeadbeefu + (uint32_t)size, s[3] = {start, start, start};
    if (size == 0)
        return start;
    for (;; bytes += 12, size -= 12) {
        for (size_t k = 0; k < 3; ++k)
            s[k] += size > 4 * k ? number(bytes + 4 * k, size - 4 * k) : 0;
        if (size <= 12)
            break;
        mix(s);
    }
    finish(s);
    return s[2];
}

/* ---- the file ---------------------------------------------------------------------------------------------------- */

static uint64_t wide(const uint8_t *bytes, size_t count)
{
    uint64_t x = 0;
    for (size_t i = 0; i < count; ++i)
        x |= (uint64_t)bytes[i] << 8 * i;
    return x;
}

/** Puts the checksum of `size` bytes after them. */
static void seal(uint8_t *bytes, size_t size)
{
    uint32_t sum = lookup3(bytes, size);
    for (size_t i = 0; i < 4; ++i)
        bytes[size + i] = (uint8_t)(sum >> 8 * i);
}

/** Seals the continuations that the messages from `at` to `end` name: address and length, the checksum included. */
static void seal_continuations(uint8_t *bytes, size_t size, size_t at, size_t end, size_t head)
{
    enum { CONTINUATION = 0x10 };
    while (at + head <= end) {
        unsigned type = bytes[at];
        size_t length = (size_t)wide(bytes + at + 1, 2);
        at += head;
        if (length > end - at)
            return;
        if (type == CONTINUATION && length >= 16) {
            uint64_t where = wide(bytes + at, 8), count = wide(bytes + at + 8, 8);
            if (where < size && count >= 8 && count <= size - where && memcmp(bytes + where, "OCHK", 4) == 0)
                seal(bytes + where, (size_t)count - 4);
        }
        at += length;
    }
}

/** Seals the object header at `at`: OHDR, version, flags, times and limits by flags, size, messages, checksum. */
static void seal_header(uint8_t *bytes, size_t size, size_t at)
{
    unsigned flags = bytes[at + 5];
    size_t begin = at + 6 + (flags & 0x20 ? 16 : 0) + (flags & 0x10 ? 4 : 0), width = (size_t)1 << (flags & 3);
    if (begin + width > size)
        return;
    uint64_t length = wide(bytes + begin, width);
    begin += width;
    if (length > size || begin + length + 4 > size)
        return;
    seal(bytes + at, begin + (size_t)length - at);
    seal_continuations(bytes, size, begin, begin + (size_t)length, flags & 4 ? 6 : 4);
}

void h5_repair(uint8_t *bytes, size_t size)
{
    enum { SUPERBLOCK = 44 };
    if (size >= SUPERBLOCK + 4 && bytes[8] >= 2)
        seal(bytes, SUPERBLOCK);
    for (size_t i = 0; i + 16 < size; ++i)
        if (bytes[i] == 'O' && memcmp(bytes + i, "OHDR", 4) == 0)
            seal_header(bytes, size, i);
}
