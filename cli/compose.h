/* SPDX-License-Identifier: MIT */
/** @file compose.h
 *  Texts in memory that are printed to. */
#ifndef SPH2D_CLI_COMPOSE_H
#define SPH2D_CLI_COMPOSE_H

#include <stddef.h>
#include <stdio.h>

/** The text that `put` prints, which may be called again with more room; its length goes to `length`. The caller frees
 *  it. NULL when memory is short. */
char *compose(void (*put)(const void *what, FILE *out), const void *what, size_t *length);

#endif
