/* SPDX-License-Identifier: MIT */
/** @file completion.h
 *  What the completions of shells ask about the keys and names of a scene. */
#ifndef SPH2D_CLI_COMPLETION_H
#define SPH2D_CLI_COMPLETION_H

/** Prints lines of fields between tabs to stdout, about the scene that `path` names or holds: a scene file, a study, a
 *  snapshot or the folder of a run; without a scene there, about any:
 *
 *      key   PATH WORDS      each key that --set takes, and its words, "-" where it has none
 *      name  NAME            each obstacle and body with a name
 *
 *  Says nothing of what cannot be read. */
void completion_print(const char *path);

#endif
