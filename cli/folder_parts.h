/* SPDX-License-Identifier: MIT */
/** @file folder_parts.h
 *  What folder.c and folder_clean.c share. */
#ifndef SPH2D_CLI_FOLDER_PARTS_H
#define SPH2D_CLI_FOLDER_PARTS_H

#include <stdbool.h>

/** Whether a name is ".NAME.tmp.NUMBER": a temporary file of a killed process, or of one that writes. */
bool folder_is_leftover(const char *name);

/** Reports that one cannot `what` (a verb) the file or folder `path`, for the errno `error`; returns the exit code. */
int folder_refuse(const char *path, const char *what, int error);

/** Reports that memory is short; returns the exit code. */
int folder_refuse_memory(void);

#endif
