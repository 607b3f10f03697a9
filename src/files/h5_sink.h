/* SPDX-License-Identifier: MIT */
/** @file h5_sink.h
 *  An HDF5 file driver that hides write errors from HDF5.
 *
 *  HDF5 1.10 crashes when it cannot flush its metadata, and keeps the broken file open. This driver records the first
 *  error and discards all later writes, so that HDF5 can close the file. */
#ifndef SPH2D_FILES_H5_SINK_H
#define SPH2D_FILES_H5_SINK_H

#include <hdf5.h>

typedef struct sph2d__h5_sink {
    int fd;    /**< open for reading and writing, and empty */
    int error; /**< errno of the first operation that failed; 0 without errors */
} sph2d__h5_sink;

/** Makes `fapl` write to `sink`, which must outlive the HDF5 file. Returns the driver, to be given to H5FDunregister in
 *  after closing the file; negative on failure. */
hid_t sph2d__h5_sink_driver(hid_t fapl, sph2d__h5_sink *sink);

#endif
