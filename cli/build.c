/* SPDX-License-Identifier: MIT */
/** @file build.c
 *  The build's source, compiler and flags, and the processor. */
#include "build.h"

#include <stdio.h>
#include <string.h>
#include <sys/utsname.h>

#include <sph2d/version.h>

#include "build_info.h"

const char *const build_compiler = BUILD_COMPILER;
const char *const build_flags = BUILD_FLAGS;
const char *const build_source = BUILD_SOURCE;
const char *const build_commit = BUILD_COMMIT;

char *build_processor(char *out, size_t size)
{
    char line[256];
    struct utsname system;
    snprintf(out, size, "%s", uname(&system) == 0 ? system.machine : "unknown");
    FILE *in = fopen("/proc/cpuinfo", "r");
    while (in && fgets(line, sizeof line, in)) {
        const char *colon = strchr(line, ':');
        if (strncmp(line, "model name", strlen("model name")) != 0 || !colon)
            continue;
        line[strcspn(line, "\n")] = '\0';
        snprintf(out, size, "%s", colon + 1 + strspn(colon + 1, " "));
        break;
    }
    if (in)
        fclose(in);
    return out;
}

char *build_describe(char *out, size_t size)
{
    char processor[256];
    snprintf(out, size, "%s; sph2d %s, commit %s; %s; %s", build_processor(processor, sizeof processor),
             sph2d_version(), build_commit, build_compiler, build_flags);
    return out;
}
