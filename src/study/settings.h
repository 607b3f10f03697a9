/* SPDX-License-Identifier: MIT */
/** @file settings.h
 *  What rows differ in: the keys that they set, and how their names tell them. */
#ifndef SPH2D_STUDY_SETTINGS_H
#define SPH2D_STUDY_SETTINGS_H

#include "sph2d/study_results.h"

/** The name of a key in names of rows, the last step of its path: "sound_speed" of "method.sound_speed". */
const char *sph2d__key_name(const char *path);

/** The value that a row sets a key to in the end; NULL where it leaves the scene's. */
const char *sph2d__setting(const sph2d_study_run *run, const char *path);

/** Whether two rows set the same keys, but for one, to the same values; with `any` to whatever values. */
bool sph2d__same_settings(const sph2d_study_run *a, const sph2d_study_run *b, const char *but, bool any);

/** Where a row's name lists that a key has a value, "kernel=quintic, spacing=0.02"; NULL where it does not. *length is
 *  how long that part of the name is. */
const char *sph2d__setting_in(const char *name, const char *path, const char *value, size_t *length);

#endif
