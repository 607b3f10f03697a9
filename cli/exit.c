/* SPDX-License-Identifier: MIT */
/** @file exit.c
 *  How the command ends. Handlers of signals remove empty folders; those of breakdowns, and of exit(), say a last sentence. */
#define _XOPEN_SOURCE 700 /* sigaltstack */
#include "exit.h"

#include <errno.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- exit codes -------------------------------------------------------------------------------------------------- */

int exit_of_status(sph2d_status status)
{
    /* Without a default, so that the compiler warns about a missing status. */
    switch (status) {
    case SPH2D_OK:
        return CLI_EXIT_SUCCESS;
    case SPH2D_GUARD:
        return CLI_EXIT_GUARD;
    case SPH2D_SCENE:
    case SPH2D_FORMAT:
        return CLI_EXIT_DATA;
    case SPH2D_NOINPUT:
        return CLI_EXIT_NOINPUT;
    case SPH2D_RENDER:
    case SPH2D_DEVICE:
        return CLI_EXIT_UNAVAILABLE;
    case SPH2D_CANTCREAT:
        return CLI_EXIT_CANTCREAT;
    case SPH2D_IO:
        return CLI_EXIT_IO;
    /* The command line is already checked, so an invalid argument is a bug of the command. */
    case SPH2D_INVALID:
    case SPH2D_NOMEM:
        break;
    }
    return CLI_EXIT_SOFTWARE;
}

/* ---- folders that were made, the last one first ------------------------------------------------------------------ */

typedef struct made_folder {
    struct made_folder *earlier;
    char path[];
} made_folder;

static made_folder *newest_made;

static int make_one(const char *path)
{
    size_t size = strlen(path) + 1;
    made_folder *made = malloc(sizeof *made + size);
    if (!made)
        return ENOMEM;
    made->earlier = newest_made;
    memcpy(made->path, path, size);
    int error = mkdir(path, 0777) == 0 ? 0 : errno;
    if (error == 0)
        newest_made = made;
    else
        free(made);
    return error;
}

int made_folders_make(const char *path)
{
    char *part = path[0] != '\0' ? strdup(path) : NULL;
    if (!part)
        return path[0] != '\0' ? ENOMEM : ENOENT;
    int error = 0;
    for (char *end = part; end;) {
        end = strchr(end + 1, '/');
        if (end)
            *end = '\0';
        /* A parent that cannot be made may exist all the same, so only the last error counts. */
        error = make_one(part);
        if (end)
            *end = '/';
    }
    free(part);
    return error == EEXIST ? 0 : error;
}

void made_folders_remove(void)
{
    for (const made_folder *made = newest_made; made; made = made->earlier)
        rmdir(made->path);
}

void made_folders_keep(void)
{
    while (newest_made) {
        made_folder *made = newest_made;
        newest_made = made->earlier;
        free(made);
    }
}

/* ---- signals that stop a command --------------------------------------------------------------------------------- */

static volatile sig_atomic_t caught;

/* A signal may come to any thread while the main one ends its preparation: whoever changes PREPARING first decides. */
enum { PREPARING, NOTING, ENDING };
static atomic_int phase;

static const int stop_signals[] = {SIGINT, SIGTERM, SIGHUP};
enum { STOP_SIGNAL_COUNT = sizeof stop_signals / sizeof *stop_signals };

static bool change_phase(int to)
{
    int preparing = PREPARING;
    return atomic_compare_exchange_strong(&phase, &preparing, to);
}

static void end_now(int number)
{
    made_folders_remove();
    _exit(128 + number);
}

static void handle_signal(int number)
{
    if (change_phase(ENDING))
        end_now(number);
    caught = number;
    /* A second signal ends the process at once: restore the default actions. */
    struct sigaction default_action = {.sa_handler = SIG_DFL};
    for (size_t i = 0; i < STOP_SIGNAL_COUNT; ++i)
        sigaction(stop_signals[i], &default_action, NULL);
}

void signals_install(void)
{
    struct sigaction action = {.sa_handler = handle_signal, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < STOP_SIGNAL_COUNT; ++i) {
        struct sigaction before;
        if (sigaction(stop_signals[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN)
            sigaction(stop_signals[i], &action, NULL);
    }
    /* A closed pipe or a file size limit must not kill a long run: writing fails with an error instead. */
    struct sigaction ignore = {.sa_handler = SIG_IGN};
    sigaction(SIGPIPE, &ignore, NULL);
    sigaction(SIGXFSZ, &ignore, NULL);
}

void signals_note(void)
{
    if (change_phase(NOTING))
        return;
    while (atomic_load(&phase) == ENDING) /* another thread is about to end the process */
        pause();
}

void signals_prepare(void)
{
    atomic_store(&phase, PREPARING);
    if (caught != 0)
        end_now(caught);
}

int signals_caught(void)
{
    return caught;
}

const char *signals_name(int number)
{
    return number == SIGINT ? "SIGINT" : number == SIGHUP ? "SIGHUP" : "SIGTERM";
}

/* ---- breakdowns: nothing here allocates or locks ----------------------------------------------------------------- */

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

static void break_down(int number)
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
    struct sigaction action = {.sa_handler = break_down, .sa_flags = sigaltstack(&own, NULL) == 0 ? SA_ONSTACK : 0};
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
