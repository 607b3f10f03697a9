/* SPDX-License-Identifier: MIT */
/** @file schema.h
 *  The keys of a file as a JSON schema, by which editors complete, explain and check what is typed. */
#ifndef SPH2D_CLI_SCHEMA_H
#define SPH2D_CLI_SCHEMA_H

#include <sph2d/key.h>

/** Prints the schema of files with these keys, one line of JSON, to stdout. */
void schema_print(const sph2d_keys *keys, const char *title);

#endif
