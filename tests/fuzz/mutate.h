/* SPDX-License-Identifier: MIT */
/** @file mutate.h
 *  Inputs made from files by changes at random. The same files and number give the same input. */
#ifndef SPH2D_TESTS_FUZZ_MUTATE_H
#define SPH2D_TESTS_FUZZ_MUTATE_H

#include <stddef.h>
#include <stdint.h>

enum { MUTATE_MAX = 1 << 20 };

/** Some bytes. */
typedef struct mutate_bytes {
    unsigned char *bytes;
    size_t size;
} mutate_bytes;

/** Makes input `number` in `out`, which has room for MUTATE_MAX bytes: one of `files`, changed at one to eight places,
 *  as text where it is text. */
void mutate(const mutate_bytes *files, size_t file_count, uint64_t number, mutate_bytes *out);

#endif
