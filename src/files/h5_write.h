/* SPDX-License-Identifier: MIT */
/** @file h5_write.h
 *  Writes HDF5 with sticky errors: after the first failure, which is reported, all calls do nothing. */
#ifndef SPH2D_FILES_H5_WRITE_H
#define SPH2D_FILES_H5_WRITE_H

#include <stdbool.h>
#include <stdint.h>

#include "files/h5_file.h"
#include "sph2d/status.h"

typedef struct sph2d__h5_writer {
    const char *path; /**< for messages */
    sph2d_report *report;
    sph2d__h5_sink sink;
    hid_t driver;
    hid_t file;
    hid_t group_properties; /**< without times, so that the same data gives the same bytes */
    unsigned compress;      /**< deflate level of large datasets; 0 for none */
    bool ok;
    bool short_of_memory; /**< why it is not ok */
} sph2d__h5_writer;

/** Starts an HDF5 file on an empty file open as `fd`. End it with sph2d__h5_writer_close in any case. */
void sph2d__h5_writer_open(sph2d__h5_writer *w, int fd, unsigned compress, const char *path, sph2d_report *report);
/** Flushes and closes the file, and reports failures of that. Errors: SPH2D_IO, SPH2D_NOMEM. */
sph2d_status sph2d__h5_writer_close(sph2d__h5_writer *w);

/** Checks the result of an HDF5 call. */
void sph2d__h5_check(sph2d__h5_writer *w, bool ok, const char *what);
/** Checks the result of an allocation. */
void sph2d__h5_check_memory(sph2d__h5_writer *w, bool ok);

/** Creates a group by its full path. Close it with sph2d__h5_close. */
hid_t sph2d__h5_group(sph2d__h5_writer *w, const char *path);
/** Closes a group or dataset, which may be invalid. */
void sph2d__h5_close(hid_t object);

/** Writes an attribute of `rows` x `columns` values of a memory type; 0 columns for one dimension, 0 rows for a scalar.
 *  One that is too large for an attribute becomes a dataset. */
void sph2d__h5_put(sph2d__h5_writer *w, hid_t at, const char *name, hid_t type, size_t rows, size_t columns,
                   const void *values);
/** Write a list of doubles, unsigned or signed integers; a count of 0 means a scalar. */
void sph2d__h5_put_reals(sph2d__h5_writer *w, hid_t at, const char *name, const double *values, size_t count);
void sph2d__h5_put_counts(sph2d__h5_writer *w, hid_t at, const char *name, const uint64_t *values, size_t count);
void sph2d__h5_put_ints(sph2d__h5_writer *w, hid_t at, const char *name, const int64_t *values, size_t count);
/** Writes one double as a list of one, as tools for SWIFT snapshots expect of what SWIFT has, too. */
void sph2d__h5_put_real(sph2d__h5_writer *w, hid_t at, const char *name, double value);
/** Writes a text as an attribute, or as a dataset if it is long. */
void sph2d__h5_put_text(sph2d__h5_writer *w, hid_t at, const char *name, const char *text);
/** Writes a text as a dataset. */
void sph2d__h5_put_document(sph2d__h5_writer *w, hid_t at, const char *name, const char *text);
/** Writes a list of texts as a dataset. */
void sph2d__h5_put_texts(sph2d__h5_writer *w, hid_t at, const char *name, const char *const *texts, size_t count);

/** Creates a dataset of `rows` x `columns` (0: one dimension), compressed as set. Close it with sph2d__h5_close. */
hid_t sph2d__h5_dataset(sph2d__h5_writer *w, hid_t at, const char *name, hid_t type, size_t rows, size_t columns);
/** Writes rows `first` to `first + count` of a dataset. */
void sph2d__h5_write_rows(sph2d__h5_writer *w, hid_t dataset, hid_t type, size_t first, size_t count, size_t columns,
                          const void *values);
/** A part of a joined dataset. */
typedef struct sph2d__h5_part {
    const char *from; /**< full path of a dataset of this file; NULL: the fill value */
    size_t rows;
} sph2d__h5_part;

/** Creates a dataset of `columns` columns (0: one dimension) that consists of others of this file, one after the other,
 *  without copies: a virtual dataset. `fill`: the value of parts that are none. Readers need HDF5 1.10. */
void sph2d__h5_join(sph2d__h5_writer *w, hid_t at, const char *name, hid_t type, size_t columns,
                    const sph2d__h5_part *parts, size_t count, const void *fill);

#endif
