/* SPDX-License-Identifier: MIT */
/** @file h5_read.h
 *  Reads untrusted HDF5: sizes are checked against the file's size before use, and every error has a message. */
#ifndef SPH2D_FILES_H5_READ_H
#define SPH2D_FILES_H5_READ_H

#include <stdbool.h>
#include <stdint.h>

#include "files/h5_file.h"
#include "files/pool.h"
#include "sph2d/status.h"

typedef struct sph2d__h5_reader {
    const char *path;
    sph2d_report *report;
    sph2d__pool *pool; /**< owns all that is read */
    int fd;
    hid_t driver;
    hid_t file;
    uint64_t file_bytes;
    uint64_t taken_bytes; /**< of the file, by datasets */
    sph2d_status status;  /**< SPH2D_OK until the first error; reading goes on, to report all errors */
} sph2d__h5_reader;

/** Opens a file; `checked`: only if its checksum matches. The result is in r->status. End it with
 *  sph2d__h5_reader_close in any case. */
void sph2d__h5_reader_open(sph2d__h5_reader *r, const char *path, bool checked, sph2d__pool *pool,
                           sph2d_report *report);
void sph2d__h5_reader_close(sph2d__h5_reader *r);

/** Checks that a group, if the file has it, can be opened without leaving the file. For each group, before others of
 *  these functions get its name. False, with a report, otherwise. */
bool sph2d__h5_check_group(sph2d__h5_reader *r, const char *group);

/** Reports an error in the file's content, or, if that is why it seems wrong, that memory was short. Returns the
 *  diagnostic, for a hint, or NULL. */
sph2d_diagnostic *sph2d__h5_refuse(sph2d__h5_reader *r, sph2d_code code, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** An attribute or a dataset. */
typedef struct sph2d__h5_item {
    hid_t id;
    bool is_attribute;
    hid_t type, space;
    int rank;
    size_t sizes[2]; /**< of the dimensions; 1 beyond the rank */
    size_t bytes;    /**< of one value in the file */
} sph2d__h5_item;

/** Whether a group has an attribute or dataset of a name. That this is not known, for want of memory, is reported. */
bool sph2d__h5_has(sph2d__h5_reader *r, const char *group, const char *name);
/** Opens an item and gets its shape; false, with a report, if it is missing or damaged. Close it with item_close. */
bool sph2d__h5_item_open(sph2d__h5_reader *r, const char *group, const char *name, sph2d__h5_item *item);
void sph2d__h5_item_close(sph2d__h5_item *item);
/** Reads an item, or rows `first` to `first + count` of a dataset. */
bool sph2d__h5_item_read(sph2d__h5_reader *r, const sph2d__h5_item *item, hid_t type, void *out, const char *name);
bool sph2d__h5_item_read_rows(sph2d__h5_reader *r, const sph2d__h5_item *item, hid_t type, size_t first, size_t count,
                              void *out, const char *name);

/** Read exactly `count` doubles, or unsigned integers. False, with a report, for another type or count. */
bool sph2d__h5_get_reals(sph2d__h5_reader *r, const char *group, const char *name, double *out, size_t count);
bool sph2d__h5_get_counts(sph2d__h5_reader *r, const char *group, const char *name, uint64_t *out, size_t count);
/** Reads a text into the pool; NULL, with a report, if there is none. */
const char *sph2d__h5_get_text(sph2d__h5_reader *r, const char *group, const char *name);
/** Reads a list of texts into the pool; NULL, with a report, if there is none. */
const char **sph2d__h5_get_texts(sph2d__h5_reader *r, const char *group, const char *name, size_t *count);

#endif
