/* SPDX-License-Identifier: MIT */
/** @file input_file.h
 *  An input as a file, for readers that take no memory. */
#ifndef SPH2D_TESTS_FUZZ_INPUT_FILE_H
#define SPH2D_TESTS_FUZZ_INPUT_FILE_H

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/** Writes a file in the working directory, in two parts. A new one: some file systems write at once what replaces the
 *  content of another. */
static inline void input_file_write(const char *path, const void *data, size_t size, const void *more, size_t more_size)
{
    remove(path);
    FILE *out = fopen(path, "wb");
    if (!out || fwrite(data, 1, size, out) != size || fwrite(more, 1, more_size, out) != more_size || fclose(out) != 0)
        exit(2);
}

#endif
