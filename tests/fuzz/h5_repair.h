/* SPDX-License-Identifier: MIT */
/** @file h5_repair.h
 *  Renews the checksums inside an HDF5 file, so that changes of its headers get past them. */
#ifndef SPH2D_TESTS_FUZZ_H5_REPAIR_H
#define SPH2D_TESTS_FUZZ_H5_REPAIR_H

#include <stddef.h>
#include <stdint.h>

/** Renews those of the superblock and of all object headers, as far as they can be found. */
void h5_repair(uint8_t *bytes, size_t size);

#endif
