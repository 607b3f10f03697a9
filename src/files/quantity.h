/* SPDX-License-Identifier: MIT */
/** @file quantity.h
 *  Numbers as people write them and files do not have them, `5 cm` or `0,05`: what to write instead. */
#ifndef SPH2D_FILES_QUANTITY_H
#define SPH2D_FILES_QUANTITY_H

#include <stdbool.h>
#include <stddef.h>

/** Says into `advice` (of `size` bytes) what to write for a text that begins with a number, where a number in `unit`
 *  is wanted ("m", "kg/m^3", "Pa s"; "" for none): "5 cm: write 0.05 [m]". Converts units of the same dimension only.
 *  False for other texts. */
bool sph2d__quantity_advice(const char *text, const char *unit, char *advice, size_t size);

#endif
