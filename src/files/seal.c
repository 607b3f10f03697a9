/* SPDX-License-Identifier: MIT */
/** @file seal.c
 *  The last 16 bytes of a file: eight letters, and a checksum of all before them. */
#include "files/seal.h"

#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define XXH_INLINE_ALL /* nothing to link with */
#include <xxhash.h>

enum { BLOCK_BYTES = 1 << 20, SEAL_BYTES = 16 };

static const unsigned char letters[8] = {'S', 'P', 'H', '2', 'D', 'x', 'x', 'h'};

/** Reads up to `size` bytes; fewer at the end of the file. -1 with errno on failure. */
static ssize_t read_block(int fd, unsigned char *block, size_t size, off_t offset)
{
    size_t done = 0;
    while (done < size) {
        ssize_t got = pread(fd, block + done, size - done, offset + (off_t)done);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return -1;
        if (got == 0)
            break;
        done += (size_t)got;
    }
    return (ssize_t)done;
}

/** The checksum of the first `size` bytes of a file. */
static bool sum_file(int fd, off_t size, uint64_t *sum)
{
    unsigned char *block = malloc(BLOCK_BYTES);
    if (!block) {
        errno = ENOMEM;
        return false;
    }
    XXH64_state_t state;
    XXH64_reset(&state, 0);
    ssize_t got = 0;
    for (off_t done = 0; done < size; done += got) {
        off_t rest = size - done;
        got = read_block(fd, block, rest < BLOCK_BYTES ? (size_t)rest : BLOCK_BYTES, done);
        if (got <= 0) /* 0: it became shorter meanwhile */
            break;
        XXH64_update(&state, block, (size_t)got);
    }
    free(block);
    *sum = XXH64_digest(&state);
    return got >= 0;
}

/** Letters and sum, lowest byte first on any machine. */
static void make_seal(unsigned char seal[SEAL_BYTES], uint64_t sum)
{
    memcpy(seal, letters, sizeof letters);
    for (int i = 0; i < 8; ++i)
        seal[8 + i] = (unsigned char)(sum >> 8 * i);
}

bool sph2d__seal_put(int fd)
{
    struct stat info;
    uint64_t sum;
    if (fstat(fd, &info) != 0 || !sum_file(fd, info.st_size, &sum))
        return false;
    unsigned char seal[SEAL_BYTES];
    make_seal(seal, sum);
    for (size_t done = 0; done < sizeof seal;) {
        ssize_t put = pwrite(fd, seal + done, sizeof seal - done, info.st_size + (off_t)done);
        if (put < 0 && errno == EINTR)
            continue;
        if (put <= 0) {
            errno = put == 0 ? EIO : errno;
            return false;
        }
        done += (size_t)put;
    }
    return true;
}

sph2d__seal sph2d__seal_check(int fd)
{
    struct stat info;
    unsigned char found[SEAL_BYTES], made[SEAL_BYTES];
    if (fstat(fd, &info) != 0)
        return SPH2D__SEAL_UNREADABLE;
    if (info.st_size < SEAL_BYTES)
        return SPH2D__SEAL_NONE;
    off_t size = info.st_size - SEAL_BYTES;
    ssize_t got = read_block(fd, found, sizeof found, size);
    if (got < 0)
        return SPH2D__SEAL_UNREADABLE;
    if (got < SEAL_BYTES || memcmp(found, letters, sizeof letters) != 0)
        return SPH2D__SEAL_NONE;
    uint64_t sum;
    if (!sum_file(fd, size, &sum))
        return SPH2D__SEAL_UNREADABLE;
    make_seal(made, sum);
    return memcmp(found, made, sizeof made) == 0 ? SPH2D__SEAL_WHOLE : SPH2D__SEAL_BROKEN;
}
