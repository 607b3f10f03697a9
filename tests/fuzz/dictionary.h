/* SPDX-License-Identifier: MIT */
/** @file dictionary.h
 *  Words that a mutation may write: every key and word of scenes and studies, numbers at the ends of what numbers can
 *  be, and the signs of YAML. */
#ifndef SPH2D_TESTS_FUZZ_DICTIONARY_H
#define SPH2D_TESTS_FUZZ_DICTIONARY_H

#include <stddef.h>

/** Lists the keys; once, before the others. */
void dictionary_make(void);

/** A number, and any word, by an arbitrary index. */
const char *dictionary_number(size_t index);
const char *dictionary_word(size_t index);

#endif
