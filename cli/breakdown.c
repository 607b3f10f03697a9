/* SPDX-License-Identifier: MIT */
/** @file breakdown.c
 *  Handlers of signals and of exit() that say a last sentence. Nothing here allocates or locks. */
#define _XOPEN_SOURCE 700 /* sigaltstack */
#include "breakdown.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "exit.h"

static const struct {
    int number;
    const char *what;
} breakdowns[] = {
#define BREAKDOWN(signal)                                                                                              \
    {                                                                                                                  \
        signal, "the command broke down (" #signal ")"                                                                 \
    }
    BREAKDOWN(SIGSEGV), BREAKDOWN(SIGBUS), BREAKDOWN(SIGABRT), BREAKDOWN(SIGFPE), BREAKDOWN(SIGILL)};
#undef BREAKDOWN
enum { BREAKDOWNS = sizeof breakdowns / sizeof *breakdowns };

/* A recursion without end has no stack left for its handler. */
enum { STACK_BYTES = 1 << 16 };
static _Alignas(16) char stack[STACK_BYTES];

static volatile sig_atomic_t in_json, leaving, exit_code;

static void put(const char *text)
{
    size_t length = strlen(text);
    while (length > 0) {
        ssize_t done = write(STDERR_FILENO, text, length);
        if (done <= 0)
            return;
        text += done;
        length -= (size_t)done;
    }
}

static void say(const char *what)
{
    static const char cause[] = ", most likely because memory was short",
                      hint[] = "every file under its final name is complete; 'sph2d resume' continues a run";
    put(in_json ? "{\"severity\": \"error\", \"code\": \"G000\", \"message\": \"" : "sph2d: error: ");
    put(what);
    put(cause);
    put(in_json ? "\", \"hint\": \"" : "\n    hint: ");
    put(hint);
    put(in_json ? "\"}\n" : "\n");
}

static void on_signal(int number)
{
    if (leaving)
        _exit(exit_code);
    const char *what = "the command broke down";
    for (int k = 0; k < BREAKDOWNS; ++k)
        if (breakdowns[k].number == number)
            what = breakdowns[k].what;
    say(what);
    _exit(CLI_EXIT_SOFTWARE);
}

static void on_exit_of_others(void)
{
    if (leaving)
        return;
    say("a library ended the command");
    _exit(CLI_EXIT_SOFTWARE);
}

void breakdown_watch(void)
{
    atexit(on_exit_of_others);
    stack_t own = {.ss_sp = stack, .ss_size = sizeof stack};
    struct sigaction action = {.sa_handler = on_signal, .sa_flags = sigaltstack(&own, NULL) == 0 ? SA_ONSTACK : 0};
    sigfillset(&action.sa_mask);
    for (int k = 0; k < BREAKDOWNS; ++k) {
        struct sigaction before; /* a sanitizer's handlers know better */
        if (sigaction(breakdowns[k].number, NULL, &before) == 0 && before.sa_handler == SIG_DFL &&
            !(before.sa_flags & SA_SIGINFO))
            sigaction(breakdowns[k].number, &action, NULL);
    }
}

void breakdown_use_json(bool json)
{
    in_json = json;
}

int breakdown_leave(int code)
{
    exit_code = code;
    leaving = 1;
    /* Where memory was short, the libraries' own handlers of exit() may fail as well, and not in silence. */
    if (code == CLI_EXIT_SOFTWARE)
        _exit(code);
    return code;
}
