/* SPDX-License-Identifier: MIT */
/** @file h5_limits.h
 *  What a file may consist of, which is checked before its data are read: everything is in the file itself, takes no
 *  more memory than the file can hold, and is stored in a way that needs no code beyond HDF5's own. */
#ifndef SPH2D_FILES_H5_LIMITS_H
#define SPH2D_FILES_H5_LIMITS_H

#include "files/h5_read.h"

/** Checks that a link is a hard one, or is not there; to be called before it is followed. False with a report. The links
 *  of a file are not listed: HDF5 1.10 frees what it never allocated if a group says that it has more than it has. */
bool sph2d__h5_check_link(sph2d__h5_reader *r, hid_t at, const char *name);

/** Checks where and how a dataset is stored; to be called before its type and space are asked for, since a virtual
 *  dataset opens other files then. False with a report. */
bool sph2d__h5_check_storage(sph2d__h5_reader *r, hid_t dataset, const char *name);

/** Checks that the values of an item fit in the file, with all other items that were read. Type, rank, sizes and bytes
 *  are set. False with a report. */
bool sph2d__h5_check_size(sph2d__h5_reader *r, const sph2d__h5_item *item, const char *name);

/** Whether a type is one of the usual numbers, or a text of fixed length. HDF5 converts others by rules in the file. */
bool sph2d__h5_usual_type(hid_t type);

#endif
