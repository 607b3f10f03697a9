/* SPDX-License-Identifier: MIT */
/** @file h5_file.h
 *  What is between HDF5 and the bytes of a file: drivers that read and write one open file, and the trailer behind HDF5's
 *  data; and HDF5's own messages, which are not printed while in this library.
 *
 *  A file is read by the very descriptor whose type and checksum were verified, whatever its name means by then. And
 *  metadata are read as they are asked for: the buffer in which HDF5 1.10 collects them for its default driver
 *  (H5F__accum_read) crashes over addresses and sizes that a damaged file may have.
 *
 *  A file is written by a driver that hides errors from HDF5. HDF5 1.10 crashes when it cannot flush its metadata, and keeps
 *  the broken file open. This driver records the first error and discards all later writes, so that HDF5 can close the file.
 *
 *  The trailer is eight letters, then XXH64 (Collet) with seed 0, little-endian, of all bytes before the letters, so that
 *  other programs can verify it, too. HDF5 ignores bytes after its data, truncates them when it changes a file, and is not
 *  robust against damaged files. The trailer detects damage before HDF5 reads the file; a file without one was cut short or
 *  changed. */
#ifndef SPH2D_FILES_H5_FILE_H
#define SPH2D_FILES_H5_FILE_H

#include <hdf5.h>
#include <stdbool.h>

/* ---- HDF5's own messages ----------------------------------------------------------------------------------------- */

/** The calling program's settings. */
typedef struct sph2d__h5_scope {
    H5E_auto2_t print;
    void *data;
} sph2d__h5_scope;

/** False, with nothing to end, when HDF5 cannot be started: memory is short. */
bool sph2d__h5_scope_begin(sph2d__h5_scope *scope);
void sph2d__h5_scope_end(const sph2d__h5_scope *scope);

/** HDF5's message about the failure of the last HDF5 call. */
void sph2d__h5_cause(char *out, size_t size);

/* ---- a driver that reads ----------------------------------------------------------------------------------------- */

/** Makes `fapl` read from `fd`, of `size` bytes, which must stay open as long as the HDF5 file. Returns the driver, to
 *  be given to H5FDunregister after closing the file; negative on failure. */
hid_t sph2d__h5_source_driver(hid_t fapl, int fd, haddr_t size);

/* ---- a driver that writes ---------------------------------------------------------------------------------------- */

typedef struct sph2d__h5_sink {
    int fd;    /**< open for reading and writing, and empty */
    int error; /**< errno of the first operation that failed; 0 without errors */
} sph2d__h5_sink;

/** Makes `fapl` write to `sink`, which must outlive the HDF5 file. Returns the driver, to be given to H5FDunregister in
 *  after closing the file; negative on failure. */
hid_t sph2d__h5_sink_driver(hid_t fapl, sph2d__h5_sink *sink);

/* ---- the trailer ------------------------------------------------------------------------------------------------- */

/** Appends a trailer to a file. False with errno if it cannot be read or written. */
bool sph2d__trailer_append(int fd);

typedef enum sph2d__trailer {
    SPH2D__TRAILER_NONE,
    SPH2D__TRAILER_VALID,
    SPH2D__TRAILER_INVALID,
    SPH2D__TRAILER_UNREADABLE
} sph2d__trailer;

/** Verifies the trailer of a file; sets errno if the file cannot be read. */
sph2d__trailer sph2d__trailer_check(int fd);

#endif
