/* SPDX-License-Identifier: MIT */
/** @file convert.h
 *  A tree into structs, by the table of keys. There is no code for any single key. */
#ifndef SPH2D_FILES_CONVERT_H
#define SPH2D_FILES_CONVERT_H

#include "files/tree.h"
#include "sph2d/key.h"

/** One conversion. */
typedef struct sph2d__converter {
    sph2d__pool *pool; /**< of the lists and texts that the structs will point at */
    sph2d__faults *faults;
} sph2d__converter;

/** Key paths are cut at this; a diagnostic keeps less. */
enum { SPH2D__PATH_SIZE = 256 };

/** Fills the struct `out`, which holds its defaults, from a mapping: unknown, doubled, missing and excluding keys and
 *  values of the wrong type are faults. `path` is the key path of the mapping, "" for the scene. */
void sph2d__convert_mapping(sph2d__converter *converter, const sph2d_keys *keys, const sph2d__node *mapping,
                            const char *path, void *out);

/** Fills the value of one key of kind NUMBER to NUMBERS in the struct `out`. */
void sph2d__convert_value(sph2d__converter *converter, const sph2d_key *key, const sph2d__node *node, const char *path,
                          void *out);

/** Reports that a node is not what a key holds. */
void sph2d__convert_wrong_type(sph2d__converter *converter, const sph2d_key *key, const sph2d__node *node,
                               const char *path, const char *expected);

/** Writes words that stand for a whole group, as `fluid: water`, out as mappings, `fluid: {material: water}`. */
void sph2d__convert_words(sph2d__node *mapping, const sph2d_keys *keys, sph2d__faults *faults);

#endif
