/* SPDX-License-Identifier: MIT */
/** @file h5_source.h
 *  An HDF5 file driver that reads one open file.
 *
 *  HDF5 reads the very file whose type and checksum were verified, whatever its name means by then. And metadata are
 *  read as they are asked for: the buffer in which HDF5 1.10 collects them for its default driver (H5F__accum_read)
 *  crashes over addresses and sizes that a damaged file may have. */
#ifndef SPH2D_FILES_H5_SOURCE_H
#define SPH2D_FILES_H5_SOURCE_H

#include <hdf5.h>

/** Makes `fapl` read from `fd`, of `size` bytes, which must stay open as long as the HDF5 file. Returns the driver, to
 *  be given to H5FDunregister after closing the file; negative on failure. */
hid_t sph2d__h5_source_driver(hid_t fapl, int fd, haddr_t size);

#endif
