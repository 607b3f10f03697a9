/* SPDX-License-Identifier: MIT */
/** @file completions.h
 *  What the completions of shells (completions/) ask the command, so that no list of theirs can go stale. */
#ifndef SPH2D_CLI_COMPLETIONS_H
#define SPH2D_CLI_COMPLETIONS_H

/** Prints lines of fields between tabs, to stdout, "-" where there is none:
 *
 *      command NAME OPERANDS TEXT
 *      option  COMMAND LETTER NAME ARGUMENT WORDS TEXT      -o --output DIR
 *
 *  for each command and each option of it. WORDS are the values that it can have, between spaces. `sph2d help completions`
 *  prints the topics of help after them. */
void completions_print_commands(void);

#endif
