/* SPDX-License-Identifier: MIT */
/** @file system.c
 *  POSIX, with what Linux and macOS add to it, or Windows by mingw-w64, which has POSIX clocks. */
#if defined(__linux__)
#define _GNU_SOURCE /* gettid */
#elif defined(__APPLE__)
#define _DARWIN_C_SOURCE /* _SC_PHYS_PAGES */
#endif
#include "base/system.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <time.h>

static double seconds(clockid_t id)
{
    struct timespec now;
    return clock_gettime(id, &now) == 0 ? (double)now.tv_sec + 1e-9 * (double)now.tv_nsec : 0;
}

double sph2d__wall_clock(void)
{
    return seconds(CLOCK_MONOTONIC);
}

double sph2d__cpu_clock(void)
{
    return seconds(CLOCK_PROCESS_CPUTIME_ID);
}

#ifdef _WIN32

#include <malloc.h>
#include <string.h>
#include <windows.h>

double sph2d__machine_memory(void)
{
    MEMORYSTATUSEX memory = {.dwLength = sizeof memory};
    return GlobalMemoryStatusEx(&memory) ? (double)memory.ullTotalPhys : INFINITY;
}

void *sph2d__aligned_alloc(size_t alignment, size_t size)
{
    return _aligned_malloc(size, alignment); /* which free() does not take */
}

void sph2d__aligned_free(void *block)
{
    _aligned_free(block);
}

bool sph2d__on_main_thread(void)
{
    return true;
}

void sph2d__before_fork(void (*action)(void))
{
    (void)action;
}

void *sph2d__library_open(const char *name)
{
    return LoadLibraryA(name);
}

void *sph2d__library_symbol(void *library, const char *name)
{
    const FARPROC found = GetProcAddress(library, name);
    void *symbol;
    memcpy(&symbol, &found, sizeof symbol);
    return symbol;
}

#else

#include <dlfcn.h>
#include <pthread.h>
#include <unistd.h>

double sph2d__machine_memory(void)
{
    long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE); /* -1 where unknown */
    return pages > 0 && page > 0 ? (double)pages * (double)page : INFINITY;
}

void *sph2d__aligned_alloc(size_t alignment, size_t size)
{
    return size > SIZE_MAX - alignment ? NULL
                                       : aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

void sph2d__aligned_free(void *block)
{
    free(block);
}

bool sph2d__on_main_thread(void)
{
#ifdef __linux__
    return gettid() == getpid();
#else
    return true;
#endif
}

void sph2d__before_fork(void (*action)(void))
{
    pthread_atfork(action, NULL, NULL);
}

void *sph2d__library_open(const char *name)
{
    return dlopen(name, RTLD_NOW | RTLD_LOCAL);
}

void *sph2d__library_symbol(void *library, const char *name)
{
    return dlsym(library, name);
}

#endif
