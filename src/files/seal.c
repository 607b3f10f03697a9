/* SPDX-License-Identifier: MIT */
/** @file seal.c
 *  The last 16 bytes of a file: eight letters, and a checksum of all before them. Words are taken by four sums in turn,
 *  which a processor makes side by side. */
#include "files/seal.h"

#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { BLOCK_BYTES = 1 << 20, SEAL_BYTES = 16, SUMS = 4, WORD = 8, ROUND = SUMS * WORD };
_Static_assert(BLOCK_BYTES % ROUND == 0, "only the last block of a file ends within a round");

static const unsigned char letters[8] = {'S', 'P', 'H', '2', 'D', 's', 'm', '4'};

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

static uint64_t add_word(uint64_t sum, uint64_t word)
{
    sum = (sum ^ word) * 0x9e3779b97f4a7c15u;
    return sum ^ sum >> 32;
}

static uint64_t load_word(const unsigned char *bytes)
{
    uint64_t word;
    memcpy(&word, bytes, sizeof word);
    return word;
}

/** Takes a block into the sums; its last bytes are filled up with zeros. */
static void add_block(uint64_t sums[SUMS], const unsigned char *block, size_t size)
{
    size_t whole = size - size % ROUND;
    uint64_t a = sums[0], b = sums[1], c = sums[2], d = sums[3];
    for (size_t i = 0; i < whole; i += ROUND) {
        a = add_word(a, load_word(block + i));
        b = add_word(b, load_word(block + i + WORD));
        c = add_word(c, load_word(block + i + 2 * WORD));
        d = add_word(d, load_word(block + i + 3 * WORD));
    }
    uint64_t taken[SUMS] = {a, b, c, d};
    unsigned char rest[ROUND] = {0};
    memcpy(rest, block + whole, size - whole);
    for (size_t i = 0; i < SUMS; ++i)
        sums[i] = whole + i * WORD < size ? add_word(taken[i], load_word(rest + i * WORD)) : taken[i];
}

/** The checksum of the first `size` bytes of a file. */
static bool sum_file(int fd, off_t size, uint64_t *sum)
{
    unsigned char *block = malloc(BLOCK_BYTES);
    if (!block) {
        errno = ENOMEM;
        return false;
    }
    uint64_t sums[SUMS] = {(uint64_t)size, 1, 2, 3};
    ssize_t got = 0;
    for (off_t done = 0; done < size && got >= 0; done += got) {
        off_t rest = size - done;
        got = read_block(fd, block, rest < BLOCK_BYTES ? (size_t)rest : BLOCK_BYTES, done);
        if (got > 0)
            add_block(sums, block, (size_t)got);
        else if (got == 0) /* it became shorter meanwhile */
            break;
    }
    free(block);
    *sum = 0;
    for (int i = 0; i < SUMS; ++i)
        *sum = add_word(*sum, sums[i]);
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
