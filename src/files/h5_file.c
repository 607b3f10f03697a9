/* SPDX-License-Identifier: MIT */
/** @file h5_file.c
 *  Drivers of HDF5 on one open file, the checksum behind its data, and its error stack. */
#include "files/h5_file.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "sph2d/io.h"

#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif
#define XXH_INLINE_ALL /* nothing to link with */
#include <xxhash.h>

/* ---- HDF5's own messages ----------------------------------------------------------------------------------------- */

#define NUMBER(x) #x
#define DOTTED(a, b, c) NUMBER(a) "." NUMBER(b) "." NUMBER(c)

bool sph2d__h5_scope_begin(sph2d__h5_scope *scope)
{
    if (H5open() < 0)
        return false;
    scope->print = NULL;
    scope->data = NULL;
    H5Eget_auto2(H5E_DEFAULT, &scope->print, &scope->data);
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    return true;
}

void sph2d__h5_scope_end(const sph2d__h5_scope *scope)
{
    H5Eclear2(H5E_DEFAULT);
    H5Eset_auto2(H5E_DEFAULT, scope->print, scope->data);
}

typedef struct cause {
    char *out;
    size_t size;
} cause;

/** Copies the first error of the walk, without line ends. */
static herr_t take_first(unsigned n, const H5E_error2_t *error, void *data)
{
    const cause *b = data;
    if (n == 0 && error->desc) {
        snprintf(b->out, b->size, "%s", error->desc);
        for (char *p = b->out; *p; ++p)
            if (*p == '\n' || *p == '\r')
                *p = ' ';
    }
    return 0;
}

void sph2d__h5_cause(char *out, size_t size)
{
    cause b = {out, size};
    snprintf(out, size, "HDF5 gives no reason");
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_first, &b); /* upward starts at the innermost function, the cause */
}

const char *sph2d_io_hdf5_version(void)
{
    return DOTTED(H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE);
}

/* ---- a driver that reads: as many bytes as are asked for, or an error -------------------------------------------- */

/* The driver's data in the access properties; HDF5 copies it byte by byte. */
typedef struct source_info {
    int fd;
    haddr_t size;
} source_info;

/** The driver's source_handle of the open file; HDF5's part comes first. */
typedef struct source_handle {
    H5FD_t base;
    source_info info;
    haddr_t allocated; /**< end of the space that the file says it has */
} source_handle;

static H5FD_t *source_open(const char *name, unsigned flags, hid_t fapl, haddr_t limit)
{
    (void)name;
    (void)limit;
    const source_info *info = H5Pget_driver_info(fapl);
    source_handle *h = info && (flags & H5F_ACC_RDWR) == 0 ? calloc(1, sizeof *h) : NULL;
    if (!h)
        return NULL;
    h->info = *info;
    return &h->base;
}

static herr_t source_close(H5FD_t *file)
{
    free(file);
    return 0;
}

static herr_t source_query(const H5FD_t *file, unsigned long *flags)
{
    (void)file;
    *flags = H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
    return 0;
}

static haddr_t source_get_allocated(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return ((const source_handle *)file)->allocated;
}

static herr_t source_set_allocated(H5FD_t *file, H5FD_mem_t type, haddr_t address)
{
    (void)type;
    ((source_handle *)file)->allocated = address;
    return 0;
}

static haddr_t source_get_end(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return ((const source_handle *)file)->info.size;
}

static herr_t source_read_bytes(H5FD_t *file, H5FD_mem_t type, hid_t dxpl, haddr_t address, size_t size, void *buffer)
{
    (void)type;
    (void)dxpl;
    const source_handle *h = (const source_handle *)file;
    if (address > h->info.size || size > h->info.size - address)
        return -1;
    for (size_t done = 0; done < size;) {
        ssize_t got = pread(h->info.fd, (char *)buffer + done, size - done, (off_t)(address + done));
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return -1;
        done += (size_t)got;
    }
    return 0;
}

/** There is none: the file is open for reading only. */
static herr_t source_write_bytes(H5FD_t *file, H5FD_mem_t type, hid_t dxpl, haddr_t address, size_t size,
                                 const void *buffer)
{
    (void)file;
    (void)type;
    (void)dxpl;
    (void)address;
    (void)size;
    (void)buffer;
    return -1;
}

static const H5FD_class_t source_class = {
#if H5_VERSION_GE(1, 13, 0)
    .version = H5FD_CLASS_VERSION,
    .value = 601, /* from the range for unregistered drivers */
#endif
    .name = "sph2d-source",
    .maxaddr = ((haddr_t)1 << (8 * sizeof(off_t) - 1)) - 1,
    .fc_degree = H5F_CLOSE_STRONG,
    .fapl_size = sizeof(source_info),
    .open = source_open,
    .close = source_close,
    .query = source_query,
    .get_eoa = source_get_allocated,
    .set_eoa = source_set_allocated,
    .get_eof = source_get_end,
    .read = source_read_bytes,
    .write = source_write_bytes,
    .fl_map = H5FD_FLMAP_DICHOTOMY,
};

hid_t sph2d__h5_source_driver(hid_t fapl, int fd, haddr_t size)
{
    hid_t driver = H5FDregister(&source_class);
    source_info info = {fd, size};
    if (driver >= 0 && H5Pset_driver(fapl, driver, &info) < 0) {
        H5FDunregister(driver);
        driver = H5I_INVALID_HID;
    }
    return driver;
}

/* ---- a driver that writes: like HDF5's default driver, except for errors ----------------------------------------- */

/** The driver's sink_handle of the open file; HDF5's part comes first. */
typedef struct sink_handle {
    H5FD_t base;
    sph2d__h5_sink *sink;
    haddr_t allocated; /**< end of the space that HDF5 has allocated */
    haddr_t end;       /**< end of the file, as if all writes had succeeded */
} sink_handle;

/* The driver's data in the access properties; HDF5 copies it byte by byte. */
typedef struct sink_info {
    sph2d__h5_sink *sink;
} sink_info;

static H5FD_t *sink_open(const char *name, unsigned flags, hid_t fapl, haddr_t limit)
{
    (void)name;
    (void)flags;
    (void)limit;
    const sink_info *info = H5Pget_driver_info(fapl);
    sink_handle *h = info ? calloc(1, sizeof *h) : NULL;
    if (!h)
        return NULL;
    h->sink = info->sink;
    return &h->base;
}

static herr_t sink_close(H5FD_t *file)
{
    free(file);
    return 0;
}

static herr_t sink_query(const H5FD_t *file, unsigned long *flags)
{
    (void)file;
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
    return 0;
}

static haddr_t sink_get_allocated(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return ((const sink_handle *)file)->allocated;
}

static herr_t sink_set_allocated(H5FD_t *file, H5FD_mem_t type, haddr_t address)
{
    (void)type;
    ((sink_handle *)file)->allocated = address;
    return 0;
}

static haddr_t sink_get_end(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return ((const sink_handle *)file)->end;
}

/** Reads back; bytes beyond the end, or lost after an error, are zero. */
static herr_t sink_read_bytes(H5FD_t *file, H5FD_mem_t type, hid_t dxpl, haddr_t address, size_t size, void *buffer)
{
    (void)type;
    (void)dxpl;
    const sink_handle *h = (const sink_handle *)file;
    size_t done = 0;
    while (done < size) {
        ssize_t got = pread(h->sink->fd, (char *)buffer + done, size - done, (off_t)(address + done));
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            break;
        done += (size_t)got;
    }
    memset((char *)buffer + done, 0, size - done);
    return 0;
}

static herr_t sink_write_bytes(H5FD_t *file, H5FD_mem_t type, hid_t dxpl, haddr_t address, size_t size,
                               const void *buffer)
{
    (void)type;
    (void)dxpl;
    sink_handle *h = (sink_handle *)file;
    size_t done = 0;
    while (done < size && h->sink->error == 0) {
        ssize_t put = pwrite(h->sink->fd, (const char *)buffer + done, size - done, (off_t)(address + done));
        if (put > 0)
            done += (size_t)put;
        else if (put == 0 || errno != EINTR)
            h->sink->error = put == 0 ? EIO : errno;
    }
    if (address + size > h->end)
        h->end = address + size;
    return 0;
}

static herr_t sink_truncate_file(H5FD_t *file, hid_t dxpl, hbool_t closing)
{
    (void)dxpl;
    (void)closing;
    sink_handle *h = (sink_handle *)file;
    if (h->end == h->allocated)
        return 0;
    if (h->sink->error == 0 && ftruncate(h->sink->fd, (off_t)h->allocated) != 0)
        h->sink->error = errno;
    h->end = h->allocated;
    return 0;
}

static const H5FD_class_t sink_class = {
#if H5_VERSION_GE(1, 13, 0)
    .version = H5FD_CLASS_VERSION,
    .value = 600, /* from the range for unregistered drivers */
#endif
    .name = "sph2d",
    .maxaddr = ((haddr_t)1 << (8 * sizeof(off_t) - 1)) - 1,
    .fc_degree = H5F_CLOSE_WEAK,
    .fapl_size = sizeof(sink_info),
    .open = sink_open,
    .close = sink_close,
    .query = sink_query,
    .get_eoa = sink_get_allocated,
    .set_eoa = sink_set_allocated,
    .get_eof = sink_get_end,
    .read = sink_read_bytes,
    .write = sink_write_bytes,
    .truncate = sink_truncate_file,
    .fl_map = H5FD_FLMAP_DICHOTOMY, /* as in HDF5's default driver, for the same file layout */
};

hid_t sph2d__h5_sink_driver(hid_t fapl, sph2d__h5_sink *sink)
{
    hid_t driver = H5FDregister(&sink_class);
    sink_info info = {sink};
    if (driver >= 0 && H5Pset_driver(fapl, driver, &info) < 0) {
        H5FDunregister(driver);
        driver = H5I_INVALID_HID;
    }
    return driver;
}

/* ---- the trailer, the last 16 bytes of a file -------------------------------------------------------------------- */

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
