/* SPDX-License-Identifier: MIT */
/** @file build.h
 *  The build's source, compiler and flags, which determine the speed. */
#ifndef SPH2D_CLI_BUILD_H
#define SPH2D_CLI_BUILD_H

#include "text.h"

/** "gcc (Debian 12.2.0-14) 12.2.0". */
extern const char *const build_compiler;
/** Compiler flags, without warnings and those of the instruction sets. */
extern const char *const build_flags;
/** A checksum of the source. */
extern const char *const build_source;
/** The commit of the source, with "-dirty" if files were changed; "none" outside a repository. */
extern const char *const build_commit;

/** The name of the processor, or of the machine type. Returns `out`, truncated to `size`. */
char *build_processor(char *out, size_t size);

/** Processor, version, commit, compiler and flags in one line. Returns `out`, truncated to `size`. */
char *build_describe(char *out, size_t size);

#endif
