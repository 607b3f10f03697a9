/* SPDX-License-Identifier: MIT */
/** @file exit.c
 *  _exit() of a build that counts what runs, linked with --wrap=_exit: the usual one ends a process without writing the
 *  counts, and workers of a study and handlers of signals would seem never to run. */
#include <signal.h>

void __gcov_dump(void);
_Noreturn void __real__exit(int code);
_Noreturn void __wrap__exit(int code);

_Noreturn void __wrap__exit(int code)
{
    static volatile sig_atomic_t writing; /* a handler comes here again, when writing crashes */
    if (!writing) {
        writing = 1;
        __gcov_dump();
    }
    __real__exit(code);
}
