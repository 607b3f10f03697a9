/* SPDX-License-Identifier: MIT */
/** @file system.h
 *  What the solver asks of the operating system beyond C17. Where systems differ, system.c alone knows it. */
#ifndef SPH2D_BASE_SYSTEM_H
#define SPH2D_BASE_SYSTEM_H

#include <stdbool.h>
#include <stddef.h>

/** Time since a moment that does not change, and processor time of all threads of the process [s]; 0 where unknown. */
double sph2d__wall_clock(void);
double sph2d__cpu_clock(void);

/** The memory of the machine [bytes]; INFINITY where unknown. */
double sph2d__machine_memory(void);

/** A block of at least `size` bytes, aligned to `alignment`, a power of 2; NULL when memory is short. To be freed by
 *  sph2d__aligned_free(), which takes NULL, too. */
void *sph2d__aligned_alloc(size_t alignment, size_t size);
void sph2d__aligned_free(void *block);

/** Whether the calling thread is that of main(); true where it is not known. */
bool sph2d__on_main_thread(void);

/** Has `action` called before each fork() from now on, where there is one. */
void sph2d__before_fork(void (*action)(void));

/** Loads a shared library, which stays loaded; NULL where there is none of that name. And one of its functions. */
void *sph2d__library_open(const char *name);
void *sph2d__library_symbol(void *library, const char *name);

#endif
