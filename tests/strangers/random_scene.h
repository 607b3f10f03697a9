/* SPDX-License-Identifier: MIT */
/** @file random_scene.h
 *  Small random scenes over the whole language. */
#ifndef SPH2D_STRANGERS_RANDOM_SCENE_H
#define SPH2D_STRANGERS_RANDOM_SCENE_H

#include <stdint.h>
#include <stdio.h>

/** Writes the scene of a seed as YAML: the same text for the same seed. */
void random_scene_write(uint64_t seed, FILE *out);

#endif
