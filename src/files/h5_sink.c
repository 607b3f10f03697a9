/* SPDX-License-Identifier: MIT */
/** @file h5_sink.c
 *  An HDF5 file driver on one open file. Like HDF5's default driver, except for errors. */
#include "files/h5_sink.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

/** The driver's handle of the open file; HDF5's part comes first. */
typedef struct handle {
    H5FD_t base;
    sph2d__h5_sink *sink;
    haddr_t allocated; /**< end of the space that HDF5 has allocated */
    haddr_t end;       /**< end of the file, as if all writes had succeeded */
} handle;

/** The driver's data in the access properties; HDF5 copies it byte by byte. */
typedef struct driver_info {
    sph2d__h5_sink *sink;
} driver_info;

static H5FD_t *open_handle(const char *name, unsigned flags, hid_t fapl, haddr_t limit)
{
    (void)name;
    (void)flags;
    (void)limit;
    const driver_info *info = H5Pget_driver_info(fapl);
    handle *h = info ? calloc(1, sizeof *h) : NULL;
    if (!h)
        return NULL;
    h->sink = info->sink;
    return &h->base;
}

static herr_t close_handle(H5FD_t *file)
{
    free(file);
    return 0;
}

static herr_t query(const H5FD_t *file, unsigned long *flags)
{
    (void)file;
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
    return 0;
}

static haddr_t get_allocated(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return ((const handle *)file)->allocated;
}

static herr_t set_allocated(H5FD_t *file, H5FD_mem_t type, haddr_t address)
{
    (void)type;
    ((handle *)file)->allocated = address;
    return 0;
}

static haddr_t get_end(const H5FD_t *file, H5FD_mem_t type)
{
    (void)type;
    return ((const handle *)file)->end;
}

/** Reads back; bytes beyond the end, or lost after an error, are zero. */
static herr_t read_bytes(H5FD_t *file, H5FD_mem_t type, hid_t dxpl, haddr_t address, size_t size, void *buffer)
{
    (void)type;
    (void)dxpl;
    const handle *h = (const handle *)file;
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

static herr_t write_bytes(H5FD_t *file, H5FD_mem_t type, hid_t dxpl, haddr_t address, size_t size, const void *buffer)
{
    (void)type;
    (void)dxpl;
    handle *h = (handle *)file;
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

static herr_t truncate_file(H5FD_t *file, hid_t dxpl, hbool_t closing)
{
    (void)dxpl;
    (void)closing;
    handle *h = (handle *)file;
    if (h->end == h->allocated)
        return 0;
    if (h->sink->error == 0 && ftruncate(h->sink->fd, (off_t)h->allocated) != 0)
        h->sink->error = errno;
    h->end = h->allocated;
    return 0;
}

static const H5FD_class_t driver_class = {
#if H5_VERSION_GE(1, 13, 0)
    .version = H5FD_CLASS_VERSION,
    .value = 600, /* from the range for unregistered drivers */
#endif
    .name = "sph2d",
    .maxaddr = ((haddr_t)1 << (8 * sizeof(off_t) - 1)) - 1,
    .fc_degree = H5F_CLOSE_WEAK,
    .fapl_size = sizeof(driver_info),
    .open = open_handle,
    .close = close_handle,
    .query = query,
    .get_eoa = get_allocated,
    .set_eoa = set_allocated,
    .get_eof = get_end,
    .read = read_bytes,
    .write = write_bytes,
    .truncate = truncate_file,
    .fl_map = H5FD_FLMAP_DICHOTOMY, /* as in HDF5's default driver, for the same file layout */
};

hid_t sph2d__h5_sink_driver(hid_t fapl, sph2d__h5_sink *sink)
{
    hid_t driver = H5FDregister(&driver_class);
    driver_info info = {sink};
    if (driver >= 0 && H5Pset_driver(fapl, driver, &info) < 0) {
        H5FDunregister(driver);
        driver = H5I_INVALID_HID;
    }
    return driver;
}
