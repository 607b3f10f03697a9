/* SPDX-License-Identifier: MIT */
/** @file suggest.h
 *  Hints: "did you mean ...?" */
#ifndef SPH2D_BASE_SUGGEST_H
#define SPH2D_BASE_SUGGEST_H

#include "sph2d/key.h"

/** Adds a hint to a diagnostic about the unknown key `name`: the most similar of `keys`, else the hint `elsewhere` unless that
 *  is "", else a key of the same name in one of their groups or at the `top` of the file, or else all of them.
 *  `diagnostic` may be NULL. */
void sph2d__suggest_key(sph2d_diagnostic *diagnostic, const char *name, const sph2d_keys *keys, const sph2d_keys *top,
                        const char *elsewhere);

/** The same for one of `words`, which NULL ends; all of them follow `all`, "one of". */
void sph2d__suggest_word(sph2d_diagnostic *diagnostic, const char *text, const char *const *words, const char *all);

#endif
