/* SPDX-License-Identifier: MIT */
/** @file build.h
 *  What this program was built from, and with what: speed depends on it. */
#ifndef SPH2D_CLI_BUILD_H
#define SPH2D_CLI_BUILD_H

#include "text.h"

/** "gcc (Debian 12.2.0-14) 12.2.0". */
extern const char *const build_compiler;
/** Flags of the compiler but for warnings; those of one instruction set come on top. */
extern const char *const build_flags;
/** A checksum of all that the program was compiled from. */
extern const char *const build_source;
/** Of the source, with "-dirty" where files were changed; "none" outside a repository. */
extern const char *const build_commit;

/** The name of the processor that it runs on, or what the system calls the machine. Returns `out`, cut at `size`. */
char *build_processor(char *out, size_t size);

/** Processor, version, commit, compiler and flags in one line. Returns `out`, cut at `size`. */
char *build_describe(char *out, size_t size);

#endif
