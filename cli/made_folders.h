/* SPDX-License-Identifier: MIT */
/** @file made_folders.h
 *  The folders that this process made, so that one which fails or is stopped before it wrote anything leaves none of
 *  them. */
#ifndef SPH2D_CLI_MADE_FOLDERS_H
#define SPH2D_CLI_MADE_FOLDERS_H

/** Makes a folder and its parents as far as they do not exist. Returns 0 or an errno. */
int made_folders_make(const char *path);

/** Removes those that are empty, inner ones first: only while the folder is locked, as another process that found it may
 *  use it otherwise. May be called by a signal handler. */
void made_folders_remove(void);

/** Forgets them: they stay. */
void made_folders_keep(void);

#endif
