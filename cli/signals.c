/* SPDX-License-Identifier: MIT */
/** @file signals.c
 *  Signals that ask a run to stop. */
#include "signals.h"

#include <signal.h>
#include <stddef.h>

static volatile sig_atomic_t caught;

static const int stopping[] = {SIGINT, SIGTERM};
enum { STOPPING_COUNT = sizeof stopping / sizeof *stopping };

static void take_note(int number)
{
    caught = number;
    /* Whoever asks twice is in a hurry: both signals get their default action back. */
    struct sigaction standard = {.sa_handler = SIG_DFL};
    for (size_t i = 0; i < STOPPING_COUNT; ++i)
        sigaction(stopping[i], &standard, NULL);
}

void signals_install(void)
{
    struct sigaction action = {.sa_handler = take_note, .sa_flags = SA_RESTART};
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < STOPPING_COUNT; ++i) {
        struct sigaction before;
        if (sigaction(stopping[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN)
            sigaction(stopping[i], &action, NULL);
    }
    /* A reader of our messages that goes away, or a limit on the size of files, must not end a run of hours. Writing
     * fails then, and is noticed. */
    struct sigaction ignore = {.sa_handler = SIG_IGN};
    sigaction(SIGPIPE, &ignore, NULL);
    sigaction(SIGXFSZ, &ignore, NULL);
}

int signals_caught(void)
{
    return caught;
}
