/* SPDX-License-Identifier: MIT */
/** @file compose.c
 *  Prints into a buffer that is made larger until all fits. Not by open_memstream: when it cannot grow, glibc 2.36 drops
 *  a part of the text, and neither ferror nor fclose tells. */
#include "compose.h"

#include <stdbool.h>
#include <stdlib.h>

static const size_t FIRST = (size_t)1 << 16, LARGEST = (size_t)1 << 30;

char *compose(void (*put)(const void *what, FILE *out), const void *what, size_t *length)
{
    for (size_t room = FIRST; room <= LARGEST; room *= 4) {
        char *text = malloc(room);
        FILE *out = text ? fmemopen(text, room, "w") : NULL;
        if (!out) {
            free(text);
            return NULL;
        }
        put(what, out);
        const bool fits = fflush(out) == 0 && !ferror(out);
        const long end = ftell(out);
        if (fclose(out) == 0 && fits && end >= 0 && (size_t)end < room) {
            *length = (size_t)end;
            return text;
        }
        free(text);
    }
    return NULL;
}
