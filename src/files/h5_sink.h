/* SPDX-License-Identifier: MIT */
/** @file h5_sink.h
 *  Where HDF5 writes to: a file that never tells HDF5 that the disk is full.
 *
 *  HDF5 1.10 crashes when it cannot flush its metadata, and keeps the broken file open. So a driver of our own keeps
 *  the first error for us and lets HDF5 go on; what it writes after that goes nowhere. */
#ifndef SPH2D_FILES_H5_SINK_H
#define SPH2D_FILES_H5_SINK_H

#include <hdf5.h>

typedef struct sph2d__h5_sink {
    int fd;    /**< open for reading and writing, and empty */
    int error; /**< errno of the first operation that failed; 0 while all is well */
} sph2d__h5_sink;

/** Makes `fapl` write to `sink`, which must outlive the HDF5 file. Returns the driver, to be given to H5FDunregister in
 *  the end; negative on failure. */
hid_t sph2d__h5_sink_driver(hid_t fapl, sph2d__h5_sink *sink);

#endif
