/* SPDX-License-Identifier: MIT */
/** @file yaml.h
 *  YAML text into a tree. */
#ifndef SPH2D_FILES_YAML_H
#define SPH2D_FILES_YAML_H

#include "files/tree.h"

/** Parses one document. Anchors, aliases, tags and keys that are not words are faults. Returns SPH2D_OK (also with
 *  faults that leave the rest of the tree sound; count them in `faults`), SPH2D_SCENE when the text is not well-formed,
 *  or SPH2D_NOMEM. *root is NULL when there is nothing in the text. */
sph2d_status sph2d__yaml_parse(const sph2d__source *source, sph2d__faults *faults, sph2d__node **root);

#endif
