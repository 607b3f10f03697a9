/* SPDX-License-Identifier: MIT */
/** @file convert.h
 *  Conversion of a tree to structs by the table of keys; no key has code of its own. */
#ifndef SPH2D_FILES_CONVERT_H
#define SPH2D_FILES_CONVERT_H

#include "files/tree.h"
#include "sph2d/key.h"

/** One conversion. */
typedef struct sph2d__converter {
    sph2d__pool *pool; /**< owns the lists and texts that the structs point to */
    sph2d__faults *faults;
    const sph2d_keys *keys; /**< at the top of the file */
} sph2d__converter;

/** Key paths are truncated to this size; those of diagnostics are shorter. */
enum { SPH2D__PATH_SIZE = 256 };

/** Fills the struct `out`, which contains its defaults, from a mapping. Unknown, duplicate, missing and mutually
 *  exclusive keys and values of the wrong type are errors. `path` is the key path of the mapping, "" for the scene. */
void sph2d__convert_mapping(sph2d__converter *converter, const sph2d_keys *keys, const sph2d__node *mapping,
                            const char *path, void *out);

/** Sets the value of one key, of kinds NUMBER to NUMBERS, in the struct `out`. */
void sph2d__convert_value(sph2d__converter *converter, const sph2d_key *key, const sph2d__node *node, const char *path,
                          void *out);

/** Reports that a node has the wrong type for a key. Returns the diagnostic, NULL where the node was reported already. */
sph2d_diagnostic *sph2d__convert_wrong_type(sph2d__converter *converter, const sph2d_key *key, const sph2d__node *node,
                                            const char *path, const char *expected);

/** Expands short forms of groups, `fluid: water`, to mappings, `fluid: {material: water}`, and notes the other words of keys. */
void sph2d__convert_words(sph2d__node *mapping, const sph2d_keys *keys, sph2d__faults *faults);

#endif
