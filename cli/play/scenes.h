/* SPDX-License-Identifier: MIT */
/** @file scenes.h
 *  The scenes of the keys 1 to 9, generated from cli/play/scenes. */
#ifndef SPH2D_CLI_PLAY_SCENES_H
#define SPH2D_CLI_PLAY_SCENES_H

#include <stddef.h>

typedef struct play_scene {
    const char *name, *text; /* "dam_break", and its YAML */
} play_scene;

extern const play_scene play_scenes[];
extern const size_t play_scene_count;

#endif
