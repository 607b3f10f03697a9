/* SPDX-License-Identifier: MIT */
/** @file study_settings.h
 *  What rows differ in: the keys that they set, and how their names tell them. */
#ifndef SPH2D_CLI_STUDY_SETTINGS_H
#define SPH2D_CLI_STUDY_SETTINGS_H

#include <stdbool.h>
#include <stddef.h>

#include <sph2d/study.h>

/** The name of a key in names of rows, the last step of its path: "sound_speed" of "method.sound_speed". */
const char *study_key(const char *path);

/** The value that a row sets a key to in the end; NULL where it leaves the scene's. */
const char *study_setting(const sph2d_study_run *run, const char *path);

/** Whether two rows have the same settings but for one key. */
bool study_same_but(const char *key, const sph2d_study_run *a, const sph2d_study_run *b);

/** Where a row's name lists that a key has a value, "kernel=quintic, spacing=0.02"; NULL where it does not. *length is
 *  how long that part of the name is. */
const char *study_setting_in(const char *name, const char *path, const char *value, size_t *length);

/** The name of a row without what it says of a key: "kernel=quintic". Returns `out`, cut at `size`; NULL when the name
 *  does not list the key with the row's value, or nothing else. */
char *study_name_without(const sph2d_study_run *run, const char *path, char *out, size_t size);

#endif
