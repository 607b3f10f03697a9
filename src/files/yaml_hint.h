/* SPDX-License-Identifier: MIT */
/** @file yaml_hint.h
 *  What to do about a text that is no YAML: the parser tells where it stopped, the lines there tell why. */
#ifndef SPH2D_FILES_YAML_HINT_H
#define SPH2D_FILES_YAML_HINT_H

#include "files/text.h"

/** Adds a hint to a diagnostic (NULL is allowed) about the parser's `message` of the byte at `offset`, if there is one. */
void sph2d__yaml_hint(sph2d_diagnostic *diagnostic, const sph2d__source *source, size_t offset, const char *message);

/** Adds a hint about the key or text `word` if it is one by its signs only, `until:1`, `until = 1`, `-box`; whether it did. */
bool sph2d__yaml_hint_word(sph2d_diagnostic *diagnostic, const char *word);

/** The same about a bracket that is not closed up to the end. */
void sph2d__yaml_hint_open(sph2d_diagnostic *diagnostic, const sph2d__source *source, size_t bracket);

#endif
