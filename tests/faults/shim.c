/* SPDX-License-Identifier: MIT */
/** @file shim.c
 *  A library for LD_PRELOAD that makes chosen calls of a program fail: the K-th of a kind, or all from the K-th on.
 *
 *      FAULTS=KIND:K[+][:ERRNO]   which kind, which call (from 1), "+": and all that follow, with which errno
 *      FAULTS_COUNT=FILE          appends a line "KIND CALLS" for each kind at the end of a process
 *
 *  Kinds: alloc (malloc, calloc, realloc, aligned_alloc, posix_memalign), write (write, pwrite, and fwrite and fclose of
 *  streams that are written), truncate, sync (fsync, fdatasync), rename, open (for writing), mkdir, thread
 *  (pthread_create). Standard output and standard error never fail. With "+" the first write that fails writes half of
 *  its bytes, as on a disk that becomes full.
 *
 *  Calls of OpenMP's runtime neither fail nor count: it ends the process where it has no memory or thread.
 *
 *  Counting starts with main(), so that the loader and constructors are not disturbed. Forked processes inherit the
 *  count; a program that executes itself starts anew. glibc only: it calls allocators by their internal names, which
 *  need no look-up that might itself allocate. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <link.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdio_ext.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { ALLOC, WRITE, TRUNCATE, SYNC, RENAME, OPEN, MKDIR, THREAD, KINDS };

static const char *const names[KINDS] = {"alloc", "write", "truncate", "sync", "rename", "open", "mkdir", "thread"};
static const int usual_errno[KINDS] = {ENOMEM, ENOSPC, EIO, EIO, EACCES, EACCES, ENOSPC, EAGAIN};

static atomic_bool armed;
static atomic_long calls[KINDS];
static int kind = KINDS, error_number;
static long which;
static bool onwards;

static uintptr_t openmp_begin, openmp_end; /* where its code is */

static int find_openmp(struct dl_phdr_info *library, size_t size, void *with)
{
    (void)size;
    (void)with;
    if (!strstr(library->dlpi_name, "libgomp.so") && !strstr(library->dlpi_name, "libomp.so"))
        return 0;
    for (int k = 0; k < library->dlpi_phnum; ++k)
        if (library->dlpi_phdr[k].p_type == PT_LOAD && library->dlpi_phdr[k].p_flags & PF_X) {
            openmp_begin = (uintptr_t)library->dlpi_addr + library->dlpi_phdr[k].p_vaddr;
            openmp_end = openmp_begin + library->dlpi_phdr[k].p_memsz;
        }
    return 1;
}

static bool is_openmp(uintptr_t caller)
{
    return caller >= openmp_begin && caller < openmp_end;
}

/** Whether it makes a thread here: the C library allocates for it. */
static _Thread_local bool openmp_makes_thread;

/** Counts the call of a function that is replaced here; whether it fails, with errno. */
#define fails(k) fails_for(k, (uintptr_t)__builtin_return_address(0))

static bool fails_for(int k, uintptr_t caller)
{
    if (!atomic_load_explicit(&armed, memory_order_relaxed) || is_openmp(caller) || openmp_makes_thread)
        return false;
    long n = atomic_fetch_add(&calls[k], 1) + 1;
    if (k != kind || (n != which && (!onwards || n < which)))
        return false;
    errno = error_number;
    return true;
}

/** The next definition of a function, after this library's. */
#define NEXT(type, name, ...) ((type(*)(__VA_ARGS__))dlsym(RTLD_NEXT, name))

/* ---- start and end ----------------------------------------------------------------------------------------------- */

static void read_settings(void)
{
    const char *text = getenv("FAULTS");
    for (int k = 0; text && k < KINDS; ++k) {
        size_t length = strlen(names[k]);
        if (strncmp(text, names[k], length) != 0 || text[length] != ':')
            continue;
        char *end;
        kind = k;
        which = strtol(text + length + 1, &end, 10);
        onwards = *end == '+';
        end += onwards;
        error_number = *end == ':' ? (int)strtol(end + 1, NULL, 10) : usual_errno[k];
    }
}

/** Written by the system calls themselves, as the program may be short of everything. */
__attribute__((destructor)) static void report(void)
{
    const char *path = getenv("FAULTS_COUNT");
    if (!path || !atomic_exchange(&armed, false))
        return;
    int fd = open(path, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    char text[KINDS * 32];
    int length = 0;
    for (int k = 0; k < KINDS; ++k)
        length += snprintf(text + length, sizeof text - (size_t)length, "%s %ld\n", names[k], atomic_load(&calls[k]));
    if (fd >= 0 && write(fd, text, (size_t)length) == length)
        close(fd);
}

// NOLINTBEGIN(readability-inconsistent-declaration-parameter-name): glibc names parameters by reserved words.

/** Processes that end by this call no destructors. */
void _exit(int code)
{
    report();
    NEXT(void, "_exit", int)(code);
    abort(); /* it does not return */
}

static int (*real_main)(int, char **, char **);

static int start(int argc, char **argv, char **environment)
{
    read_settings();
    dl_iterate_phdr(find_openmp, NULL);
    atomic_store(&armed, true);
    return real_main(argc, argv, environment);
}

int __libc_start_main(int (*program)(int, char **, char **), int argc, char **argv, void (*init)(void),
                      void (*fini)(void), void (*rtld_fini)(void), void *stack_end)
{
    real_main = program;
    return NEXT(int, "__libc_start_main", int (*)(int, char **, char **), int, char **, void (*)(void), void (*)(void),
                void (*)(void), void *)(start, argc, argv, init, fini, rtld_fini, stack_end);
}

/* ---- memory ------------------------------------------------------------------------------------------------------ */

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *block, size_t size);
void *__libc_memalign(size_t alignment, size_t size);

void *malloc(size_t size)
{
    return fails(ALLOC) ? NULL : __libc_malloc(size);
}

void *calloc(size_t count, size_t size)
{
    return fails(ALLOC) ? NULL : __libc_calloc(count, size);
}

void *realloc(void *block, size_t size)
{
    return size > 0 && fails(ALLOC) ? NULL : __libc_realloc(block, size);
}

void *aligned_alloc(size_t alignment, size_t size)
{
    return fails(ALLOC) ? NULL : __libc_memalign(alignment, size);
}

int posix_memalign(void **out, size_t alignment, size_t size)
{
    if (fails(ALLOC))
        return ENOMEM;
    void *block = __libc_memalign(alignment, size);
    if (block)
        *out = block;
    return block ? 0 : ENOMEM;
}

/* ---- writing ----------------------------------------------------------------------------------------------------- */

/** How many of `size` bytes a write may write: all; half, at the first failure of many; or -1, with errno. */
static ssize_t room(int fd, size_t size)
{
    if (fd == STDOUT_FILENO || fd == STDERR_FILENO)
        return (ssize_t)size;
    long before = atomic_load(&calls[WRITE]);
    if (!fails(WRITE))
        return (ssize_t)size;
    return onwards && before + 1 == which && size > 1 ? (ssize_t)(size / 2) : -1;
}

ssize_t write(int fd, const void *bytes, size_t size)
{
    ssize_t some = room(fd, size);
    return some < 0 ? -1 : NEXT(ssize_t, "write", int, const void *, size_t)(fd, bytes, (size_t)some);
}

ssize_t pwrite(int fd, const void *bytes, size_t size, off_t at)
{
    ssize_t some = room(fd, size);
    return some < 0 ? -1 : NEXT(ssize_t, "pwrite", int, const void *, size_t, off_t)(fd, bytes, (size_t)some, at);
}

ssize_t pwrite64(int fd, const void *bytes, size_t size, off64_t at)
{
    ssize_t some = room(fd, size);
    return some < 0 ? -1 : NEXT(ssize_t, "pwrite64", int, const void *, size_t, off64_t)(fd, bytes, (size_t)some, at);
}

int ftruncate(int fd, off_t size)
{
    return fails(TRUNCATE) ? -1 : NEXT(int, "ftruncate", int, off_t)(fd, size);
}

int ftruncate64(int fd, off64_t size)
{
    return fails(TRUNCATE) ? -1 : NEXT(int, "ftruncate64", int, off64_t)(fd, size);
}

/** Whether a stream is one whose writes fail: of a file, not a text in memory nor a standard stream. */
static bool is_file(FILE *stream)
{
    return stream != stdout && stream != stderr && __fwritable(stream) && fileno(stream) >= 0;
}

size_t fwrite(const void *items, size_t size, size_t count, FILE *stream)
{
    return is_file(stream) && fails(WRITE)
               ? 0
               : NEXT(size_t, "fwrite", const void *, size_t, size_t, FILE *)(items, size, count, stream);
}

/** A failing one closes the file, as it does in earnest, but what was in the buffer is lost. */
int fclose(FILE *stream)
{
    if (!is_file(stream) || !fails(WRITE))
        return NEXT(int, "fclose", FILE *)(stream);
    __fpurge(stream);
    NEXT(int, "fclose", FILE *)(stream);
    errno = error_number;
    return EOF;
}

int fsync(int fd)
{
    return fails(SYNC) ? -1 : NEXT(int, "fsync", int)(fd);
}

int fdatasync(int fd)
{
    return fails(SYNC) ? -1 : NEXT(int, "fdatasync", int)(fd);
}

/* ---- names ------------------------------------------------------------------------------------------------------- */

int rename(const char *from, const char *to)
{
    return fails(RENAME) ? -1 : NEXT(int, "rename", const char *, const char *)(from, to);
}

int mkdir(const char *path, mode_t mode)
{
    return fails(MKDIR) ? -1 : NEXT(int, "mkdir", const char *, mode_t)(path, mode);
}

static bool open_fails(int flags)
{
    return (flags & O_ACCMODE) != O_RDONLY && fails(OPEN);
}

#define OPEN_AS(name)                                                                                                  \
    int name(const char *path, int flags, ...)                                                                         \
    {                                                                                                                  \
        va_list rest;                                                                                                  \
        va_start(rest, flags);                                                                                         \
        unsigned mode = flags & (O_CREAT | __O_TMPFILE) ? va_arg(rest, unsigned) : 0;                                  \
        va_end(rest);                                                                                                  \
        return open_fails(flags) ? -1 : NEXT(int, #name, const char *, int, ...)(path, flags, mode);                   \
    }
OPEN_AS(open)
OPEN_AS(open64)

#define FOPEN_AS(name)                                                                                                 \
    FILE *name(const char *path, const char *mode)                                                                     \
    {                                                                                                                  \
        bool writes = strpbrk(mode, "wa+");                                                                            \
        return writes && fails(OPEN) ? NULL : NEXT(FILE *, #name, const char *, const char *)(path, mode);             \
    }
FOPEN_AS(fopen)
FOPEN_AS(fopen64)

/* ---- threads ----------------------------------------------------------------------------------------------------- */

int pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*work)(void *), void *argument)
{
    if (fails(THREAD))
        return error_number;
    openmp_makes_thread = is_openmp((uintptr_t)__builtin_return_address(0));
    const int status = NEXT(int, "pthread_create", pthread_t *, const pthread_attr_t *, void *(*)(void *),
                            void *)(thread, attributes, work, argument);
    openmp_makes_thread = false;
    return status;
}

// NOLINTEND(readability-inconsistent-declaration-parameter-name)
