/* SPDX-License-Identifier: MIT */
/** @file trailer.c
 *  The checksum trailer, the last 16 bytes of a file: eight letters, and a checksum of all bytes before them. */
#include "files/trailer.h"

#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define XXH_INLINE_ALL /* nothing to link with */
#include <xxhash.h>

enum { BLOCK_BYTES = 1 << 20, TRAILER_BYTES = 16 };

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
        if (got <= 0) /* 0: the file was truncated meanwhile */
            break;
        XXH64_update(&state, block, (size_t)got);
    }
    free(block);
    *sum = XXH64_digest(&state);
    return got >= 0;
}

/** Letters and checksum, little-endian on any machine. */
static void make_trailer(unsigned char trailer[TRAILER_BYTES], uint64_t sum)
{
    memcpy(trailer, letters, sizeof letters);
    for (int i = 0; i < 8; ++i)
        trailer[8 + i] = (unsigned char)(sum >> 8 * i);
}

bool sph2d__trailer_append(int fd)
{
    struct stat info;
    uint64_t sum;
    if (fstat(fd, &info) != 0 || !sum_file(fd, info.st_size, &sum))
        return false;
    unsigned char trailer[TRAILER_BYTES];
    make_trailer(trailer, sum);
    for (size_t done = 0; done < sizeof trailer;) {
        ssize_t put = pwrite(fd, trailer + done, sizeof trailer - done, info.st_size + (off_t)done);
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

sph2d__trailer sph2d__trailer_check(int fd)
{
    struct stat info;
    unsigned char found[TRAILER_BYTES], made[TRAILER_BYTES];
    if (fstat(fd, &info) != 0)
        return SPH2D__TRAILER_UNREADABLE;
    if (info.st_size < TRAILER_BYTES)
        return SPH2D__TRAILER_NONE;
    off_t size = info.st_size - TRAILER_BYTES;
    ssize_t got = read_block(fd, found, sizeof found, size);
    if (got < 0)
        return SPH2D__TRAILER_UNREADABLE;
    if (got < TRAILER_BYTES || memcmp(found, letters, sizeof letters) != 0)
        return SPH2D__TRAILER_NONE;
    uint64_t sum;
    if (!sum_file(fd, size, &sum))
        return SPH2D__TRAILER_UNREADABLE;
    make_trailer(made, sum);
    return memcmp(found, made, sizeof made) == 0 ? SPH2D__TRAILER_VALID : SPH2D__TRAILER_INVALID;
}
