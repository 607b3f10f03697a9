/* SPDX-License-Identifier: MIT */
/** @file yaml.h
 *  Parses YAML text to a tree. */
#ifndef SPH2D_FILES_YAML_H
#define SPH2D_FILES_YAML_H

#include "files/tree.h"

/** Parses one document. Anchors, aliases, tags and keys that are not words are errors. Returns SPH2D_OK (also with
 *  errors that leave the rest of the tree valid; `faults` counts them), SPH2D_SCENE if the text is not well-formed, or
 *  SPH2D_NOMEM. *root is NULL for an empty text. */
sph2d_status sph2d__yaml_parse(const sph2d__source *source, sph2d__faults *faults, sph2d__node **root);

#endif
