/* SPDX-License-Identifier: MIT */
/** @file h5_source.c
 *  The driver: as many bytes as are asked for, or an error. */
#include "files/h5_source.h"

#include <errno.h>
#include <stdlib.h>
#include <unistd.h>

#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

/** The driver's data in the access properties; HDF5 copies it byte by byte. */
typedef struct driver_info {
    int fd;
    haddr_t size;
} driver_info;

/** The driver's handle of the open file; HDF5's part comes first. */
typedef struct handle {
    H5FD_t base;
    driver_info info;
    haddr_t allocated; /**< end of the space that the file says it has */
} handle;

static H5FD_t *open_handle(const char *name, unsigned flags, hid_t fapl, haddr_t limit)
{
    (void)name;
    (void)limit;
    const driver_info *info = H5Pget_driver_info(fapl);
    handle *h = info && (flags & H5F_ACC_RDWR) == 0 ? calloc(1, sizeof *h) : NULL;
    if (!h)
        return NULL;
    h->info = *info;
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
    *flags = H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
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
    return ((const handle *)file)->info.size;
}

static herr_t read_bytes(H5FD_t *file, H5FD_mem_t type, hid_t dxpl, haddr_t address, size_t size, void *buffer)
{
    (void)type;
    (void)dxpl;
    const handle *h = (const handle *)file;
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
static herr_t write_bytes(H5FD_t *file, H5FD_mem_t type, hid_t dxpl, haddr_t address, size_t size, const void *buffer)
{
    (void)file;
    (void)type;
    (void)dxpl;
    (void)address;
    (void)size;
    (void)buffer;
    return -1;
}

static const H5FD_class_t driver_class = {
#if H5_VERSION_GE(1, 13, 0)
    .version = H5FD_CLASS_VERSION,
    .value = 601, /* from the range for unregistered drivers */
#endif
    .name = "sph2d-source",
    .maxaddr = ((haddr_t)1 << (8 * sizeof(off_t) - 1)) - 1,
    .fc_degree = H5F_CLOSE_STRONG,
    .fapl_size = sizeof(driver_info),
    .open = open_handle,
    .close = close_handle,
    .query = query,
    .get_eoa = get_allocated,
    .set_eoa = set_allocated,
    .get_eof = get_end,
    .read = read_bytes,
    .write = write_bytes,
    .fl_map = H5FD_FLMAP_DICHOTOMY,
};

hid_t sph2d__h5_source_driver(hid_t fapl, int fd, haddr_t size)
{
    hid_t driver = H5FDregister(&driver_class);
    driver_info info = {fd, size};
    if (driver >= 0 && H5Pset_driver(fapl, driver, &info) < 0) {
        H5FDunregister(driver);
        driver = H5I_INVALID_HID;
    }
    return driver;
}
